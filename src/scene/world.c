/* SPDX-License-Identifier: MIT */
/* The world: what of a scene moves, tick by tick.  Nothing here knows that it is
 * drawn. */
#include "base/base.h"
#include "scene/boat.h"
#include "scene/foam.h"
#include "scene/light.h"
#include "scene/parts.h"
#include "scene/spray.h"

#define PITCH_MOST TP_DEG(89)
#define EYE_MOST   (8000 * TP_FX_ONE)

/* -- the beginning ----------------------------------------------------------------- */

static tp_status layout(tp_world_parts *parts, const tp_scene *scene,
                        const tp_assets *assets, tp_error *err)
{
    tp_sea sea;

    tp_sea_init(&sea, scene->wave, TP_WAVES, scene->water.gravity);
    return tp_parts_of(parts, scene, assets, &sea, err);
}

size_t tp_world_bytes(const tp_scene *scene, const tp_assets *assets)
{
    tp_world_parts parts;
    return layout(&parts, scene, assets, NULL) == TP_OK ? parts.bytes : 0;
}

static void place_camera(tp_world *world, const tp_scene *scene)
{
    world->eye = (tp_vec3){ scene->camera.x, scene->camera.y, scene->camera.z };
    world->heading = tp_turn_of_degrees(scene->camera.heading);
    world->pitch = tp_turn_of_degrees(scene->camera.pitch);
    world->last_eye = world->eye;
    world->last_heading = world->heading;
    world->last_pitch = world->pitch;
}

/* A scene without a boat does not feel for the water under one, and its camera stands in
 * the world. */
static void place_boat(tp_world *world, const tp_scene *scene)
{
    if (scene->boat.mesh[0])
        tp_boat_init(world, scene);
    world->last_boat = world->boat;
    world->aboard = scene->boat.mesh[0] && scene->camera.follow == TP_FOLLOW_BOAT;
}

static void place_sea(tp_world *world, const tp_scene *scene)
{
    tp_sea_init(&world->sea, scene->wave, TP_WAVES, scene->water.gravity);
    tp_sea_phases(&world->sea, world->tick, 0, world->phases);
}

tp_status tp_world_init(tp_world *world, size_t bytes, const tp_scene *scene,
                        const tp_assets *assets, tp_error *err)
{
    tp_world_parts parts;
    tp_status status = layout(&parts, scene, assets, err);

    if (status != TP_OK)
        return status;
    if (bytes < parts.bytes)
        return TP_FAIL(err, TP_E_NOSPACE, 0, parts.bytes, bytes);
    memset(world, 0, parts.bytes);
    world->parts = parts;
    world->random = 1;
    place_camera(world, scene);
    tp_light_init(world, scene);
    tp_clock_init(&world->clock, scene->clock.scale);
    world->clock_scale = scene->clock.scale;
    place_sea(world, scene);
    status = tp_parts_init(world, scene, assets, err);
    if (status == TP_OK)
        place_boat(world, scene);
    return status;
}

bool tp_world_refresh(tp_world *world, const tp_scene *scene, const tp_assets *assets)
{
    tp_world_parts parts;

    if (layout(&parts, scene, assets, NULL) != TP_OK
        || memcmp(&parts, &world->parts, sizeof parts) != 0
        || !tp_parts_can_tune(world, scene))
        return false;
    place_sea(world, scene);
    if (tp_parts_init_ocean(world, scene, assets, NULL) != TP_OK)
        return false;
    tp_parts_tune(world, scene);
    if (world->parts.drops) {
        tp_parts_drops(world)->sphere.y = scene->drops.y;
        tp_parts_drops(world)->sphere_radius = 2 * scene->drops.radius;
    }
    tp_light_refresh(world, scene);
    tp_meter_init(world, scene, assets);
    if (world->clock_scale != scene->clock.scale)
        tp_clock_aim(&world->clock, scene->clock.scale);
    world->clock_scale = scene->clock.scale;
    place_boat(world, scene);
    return true;
}

/* -- the camera -------------------------------------------------------------------- */

/* Pitch is signed: held short of straight up and down. */
static tp_turn tilted(tp_turn pitch, int32_t tilt)
{
    return (tp_turn)(int32_t)tp_limit((int64_t)(int32_t)pitch + tilt, PITCH_MOST);
}

static tp_fx held(int64_t x)
{
    return (tp_fx)tp_limit(x, EYE_MOST);
}

/* Rounded, so that a walk forth and back ends where it began. */
static void move_eye(tp_world *world, const tp_input *in)
{
    world->last_eye = world->eye;
    world->last_heading = world->heading;
    world->last_pitch = world->pitch;
    world->heading += (tp_turn)in->turn;
    world->pitch = tilted(world->pitch, in->tilt);

    const int64_t half = 1 << 29;
    int64_t s = tp_sin(world->heading), c = tp_cos(world->heading);
    world->eye.x = held(world->eye.x + ((in->ahead * s + in->aside * c + half) >> 30));
    world->eye.z = held(world->eye.z + ((in->aside * s - in->ahead * c + half) >> 30));
    world->eye.y = held((int64_t)world->eye.y + in->up);
}

void tp_world_look(tp_world *world, const tp_input *input)
{
    move_eye(world, input);
    world->last_eye = world->eye;       /* there is no tick to draw between */
    world->last_heading = world->heading;
    world->last_pitch = world->pitch;
}

/* -- drops ------------------------------------------------------------------------- */

/* An impact raises a ring, or stirs the pool as much [D5]. */
static void strike(tp_world *world, const tp_scene *scene, const tp_impact *impact,
                   tp_fx level)
{
    tp_pool *pool = tp_parts_pool(world);

    if (world->parts.foam)
        tp_foam_blob(tp_parts_foam(world), impact->x, impact->z, impact->length / 5, 160);
    if (world->parts.spray)
        tp_spray_splash(tp_parts_spray(world), scene, impact, level);

    if (scene->drops.into == TP_DROPS_RINGS)
        tp_drops_ring(tp_parts_drops(world), &scene->drops, impact);
    else if (pool)
        tp_pool_hat(pool, impact->x, impact->z, impact->length / 4, -impact->amplitude);
}

static void move_drops(tp_world *world, const tp_scene *scene, const tp_surface *surface)
{
    tp_drops *drops = tp_parts_drops(world);
    const tp_drop *drop = tp_drops_list(drops);
    tp_impact impact;

    for (uint32_t i = 0; i < drops->count; i++) {
        tp_fx level = tp_surface_above(surface, drop[i].place.x, drop[i].place.z,
                                       NULL).position.y;
        if (tp_drops_step(drops, &scene->drops, i, scene->water.gravity, level,
                          world->tick, &impact))
            strike(world, scene, &impact, level);
    }
}

static void set_rings(tp_world *world)
{
    const tp_drops *drops = tp_world_drops(world);
    const tp_ring *ring = tp_drops_rings(drops);
    tp_ring_now *now = tp_parts_rings(world);

    world->rings = 0;
    for (uint32_t i = 0; now && i < drops->rings; i++)
        world->rings += tp_ring_at(&ring[i], (int64_t)(world->tick * TP_FX_ONE),
                                   &now[world->rings]);
}

static void step_drops(tp_world *world, const tp_scene *scene, const tp_input *in)
{
    tp_drops *drops = tp_parts_drops(world);
    tp_surface surface = tp_world_surface(world);

    tp_drops_steer(drops, in->sphere_x, in->sphere_z);
    tp_drops_release_due(drops, &scene->drops);
    if (in->drops > 0)
        tp_drops_release(drops, &scene->drops, (uint32_t)in->drops);
    move_drops(world, scene, &surface);
    tp_drops_tidy(drops, (int64_t)(world->tick * TP_FX_ONE), 200 * TP_FX_ONE);
    set_rings(world);
}

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

static void step_pool(tp_world *world, tp_pool *pool, const tp_scene_pool *scene,
                      uint32_t *wait)
{
    poke_at_times(world, pool, scene, wait);
    if (scene->paddle > 0)
        tp_paddle_push(pool, scene, world->tick);
    tp_pool_step(pool);
}

static void step_pools(tp_world *world, const tp_scene *scene, const tp_input *in)
{
    tp_pool *pool = tp_parts_pool(world), *field = tp_parts_field(world);

    if (pool && in->poke != 0)
        tp_pool_hat(pool, in->poke_x, in->poke_z, scene->pool.poke_size, in->poke);
    if (pool)
        step_pool(world, pool, &scene->pool, &world->poke_wait[0]);
    if (field)
        step_pool(world, field, &scene->field, &world->poke_wait[1]);
}

/* -- a tick ------------------------------------------------------------------------ */

/* Each part moves over the water as the last tick left it; pools move last. */
void tp_world_step(tp_world *world, const tp_scene *scene, const tp_input *input)
{
    static const tp_input none;
    const tp_input *in = input ? input : &none;

    world->tick++;
    move_eye(world, in);
    tp_sea_phases(&world->sea, world->tick, 0, world->phases);
    if (world->parts.drops)
        step_drops(world, scene, in);
    world->last_boat = world->boat;
    if (scene->boat.mesh[0]) {
        tp_boat_step(world, scene, in);
        tp_boat_wake(world, scene);
    }
    step_pools(world, scene, in);
    if (world->parts.foam)
        tp_foam_step(world, scene);
    if (world->parts.spray)
        tp_spray_step(world, scene);
    tp_light_step(world, scene, in);
    tp_clock_shift(&world->clock, in->slower);
}

/* Ticks that must have been stepped to draw at the clock's time. */
static uint64_t ticks_for(const tp_clock *clock)
{
    return tp_clock_ticks(clock) + (tp_clock_fraction(clock) > 0);
}

uint32_t tp_world_frame(tp_world *world)
{
    uint64_t before = ticks_for(&world->clock);
    tp_clock_next(&world->clock);
    tp_fx part = tp_clock_fraction(&world->clock);

    world->back = part > 0 ? TP_FX_ONE - part : 0;
    return (uint32_t)(ticks_for(&world->clock) - before);
}

tp_sea_point tp_world_above(const tp_world *world, tp_fx x, tp_fx z)
{
    tp_surface surface = tp_world_surface(world);
    return tp_surface_above(&surface, x, z, NULL);
}
