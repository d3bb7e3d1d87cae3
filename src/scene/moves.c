/* SPDX-License-Identifier: MIT */
/* How drops and pools move, and the list of all movers, as a kit names them. */
#include "scene/moves.h"
#include "base/base.h"
#include "scene/module.h"

/* -- drops ------------------------------------------------------------------------- */

/* An impact raises a ring, or stirs the pool as much [D5]. */
static void strike(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                   const tp_impact *impact, tp_fx level)
{
    const tp_moves *move = &kit->move;
    tp_pool *pool = tp_parts_pool(world);

    tp_modules_hit(kit, world, scene, impact, level);

    if (scene->drops.into == TP_DROPS_RINGS)
        tp_drops_ring(tp_parts_drops(world), &scene->drops, impact);
    else if (pool)
        move->pools->hat(pool, impact->x, impact->z, impact->length / 4, -impact->amplitude);
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

/* -- pools ------------------------------------------------------------------------- */

/* Somewhere in the middle four fifths of a pool along one side. */
static tp_fx somewhere(tp_world *world, tp_fx centre, int32_t cells, tp_fx cell)
{
    int64_t side = (int64_t)cells * cell * 4 / 5;
    return (tp_fx)(centre - side / 2 + (side * (tp_random(&world->random) >> 8) >> 24));
}

static void poke_at_times(tp_world *world, tp_pool *pool, const tp_scene_pool *scene,
                          uint32_t *wait)
{
    if (scene->poke_every <= 0)
        return;
    uint32_t every = (uint32_t)((int64_t)scene->poke_every * TP_TICKS_PER_SECOND >> 16);
    if (*wait > every)          /* it was longer when this wait began */
        *wait = every;
    if (*wait > 0 && --*wait > 0)
        return;
    *wait = every;
    tp_fx x = somewhere(world, scene->x, scene->cols, scene->cell);
    tp_fx z = somewhere(world, scene->z, scene->rows, scene->cell);
    tp_pool_hat(pool, x, z, scene->poke_size, scene->poke);
}

static void step_pool(const tp_kit *kit, tp_world *world, tp_pool *pool,
                      const tp_scene_pool *scene, uint32_t *wait)
{
    poke_at_times(world, pool, scene, wait);
    if (scene->paddle > 0 && kit->move.paddle)
        kit->move.paddle->push(pool, scene, world->tick);
    tp_pool_step(pool);
}

static void step_pools(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                       const tp_input *in)
{
    tp_pool *pool = tp_parts_pool(world), *field = tp_parts_field(world);

    for (int i = 0; in && pool && i < TP_PUSHES; i++) {
        const tp_push *p = &in->push[i];
        if (p->height != 0)
            tp_pool_hat(pool, p->x, p->z, scene->pool.poke_size, p->height);
    }
    if (pool)
        step_pool(kit, world, pool, &scene->pool, &world->poke_wait[0]);
    if (field)
        step_pool(kit, world, field, &scene->field, &world->poke_wait[1]);
}

const struct tp_move_pools tp_move_pools = {
    .take = tp_parts_take_pools, .init = tp_parts_init_pools,
    .can_tune = tp_parts_can_tune_pools, .tune = tp_parts_tune_pools,
    .hat = tp_pool_hat, .step = step_pools,
};

/* -- what other files move ----------------------------------------------------------- */

const struct tp_move_boat   tp_move_boat = { tp_boat_init, tp_boat_step };
const struct tp_move_wake   tp_move_wake = { tp_boat_wake };
const struct tp_move_paddle tp_move_paddle = { tp_paddle_push };
const struct tp_move_ocean  tp_move_ocean = { tp_parts_ocean_bytes, tp_parts_init_ocean,
                                              tp_parts_refresh_ocean };
