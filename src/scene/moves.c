/* SPDX-License-Identifier: MIT */
/* How drops move, and the list of all movers, as a kit names them. */
#include "scene/moves.h"
#include "base/base.h"
#include "scene/module.h"

/* -- drops ------------------------------------------------------------------------- */

/* An impact raises a ring, or it stirs a pool. */
static void strike(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                   const tp_impact *impact, tp_fx level)
{
    tp_modules_hit(kit, world, scene, impact, level);
    if (scene->drops.into == TP_DROPS_RINGS)
        tp_drops_ring(tp_parts_drops(world), &scene->drops, impact);
}

static void move_drops(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                       const tp_surface *surface)
{
    tp_drops *drops = tp_parts_drops(world);
    const tp_drop *drop = tp_drops_list(drops);
    tp_impact impact;

    for (uint32_t i = 0; i < drops->count; i++) {
        tp_fx level = tp_surface_above(surface, drop[i].place.x, drop[i].place.z,
                                       NULL).position.y;
        if (tp_drops_step(drops, &scene->drops, i, scene->water.gravity, level,
                          world->tick, &impact))
            strike(kit, world, scene, &impact, level);
    }
}

static void set_rings(const tp_kit *kit, tp_world *world)
{
    const tp_drops *drops = tp_world_drops(world);
    const tp_ring *ring = tp_drops_rings(drops);
    tp_ring_now *now = tp_parts_rings(world);

    world->rings = 0;
    for (uint32_t i = 0; now && i < drops->rings; i++)
        world->rings += kit->water.rings->at(&ring[i], (int64_t)(world->tick * TP_FX_ONE),
                                   &now[world->rings]);
}

static void step_drops(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                       const tp_input *in)
{
    tp_drops *drops = tp_parts_drops(world);
    tp_surface surface = tp_world_surface(kit, world);

    tp_drops_steer(drops, in ? in->sphere_x : 0, in ? in->sphere_z : 0);
    tp_drops_release_due(drops, &scene->drops);
    if (in && in->drops > 0)
        tp_drops_release(drops, &scene->drops, (uint32_t)in->drops);
    move_drops(kit, world, scene, &surface);
    tp_drops_tidy(drops, (int64_t)(world->tick * TP_FX_ONE), 200 * TP_FX_ONE);
    if (kit->water.rings)
        set_rings(kit, world);
}

const struct tp_move_drops tp_move_drops = { tp_drops_bytes, tp_drops_init, step_drops };

/* -- what other files move ----------------------------------------------------------- */

const struct tp_move_boat   tp_move_boat = { tp_boat_init, tp_boat_step };
const struct tp_move_wake   tp_move_wake = { tp_boat_wake };
const struct tp_move_ocean  tp_move_ocean = { tp_parts_ocean_bytes, tp_parts_init_ocean,
                                              tp_parts_refresh_ocean };
