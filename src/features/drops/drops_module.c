/* SPDX-License-Identifier: MIT */
/* The drops of a scene and their rings, in one block of fixed size.  Drops and rings
 * beyond the capacity are counted as dropped. */
#include "base/base.h"
#include "features/drops/drops.h"
#include "view/wave_models.h"
#include "world/module.h"
#include "world/pools.h"

#define MOST       1024

enum { DROPS_AT = (sizeof(tp_drops) + 7) & ~7u };

_Static_assert(sizeof(tp_drop) % 8 == 0 && sizeof(tp_ring) % 8 == 0,
               "both hold int64_t and follow each other");

static uint32_t clamp_capacity(int32_t asked)
{
    return (uint32_t)tp_clamp(asked, 0, MOST);
}

size_t tp_drops_bytes(const tp_scene_drops *config)
{
    if (config->count <= 0)
        return 0;
    return DROPS_AT + clamp_capacity(config->count) * sizeof(tp_drop)
           + clamp_capacity(config->rings) * sizeof(tp_ring);
}

void tp_drops_init(tp_drops *drops, const tp_scene_drops *config)
{
    TP_ASSERT((uintptr_t)drops % 8 == 0 && config->count > 0);
    memset(drops, 0, tp_drops_bytes(config));
    drops->capacity = clamp_capacity(config->count);
    drops->ring_capacity = clamp_capacity(config->rings);
    drops->random = 1;
    drops->sphere = (tp_vec3){ config->x, config->y, config->z };
    drops->last_sphere = drops->sphere;
    drops->sphere_radius = 2 * config->radius;
}

static tp_drop *list(tp_drops *drops)
{
    return (tp_drop *)(void *)((char *)drops + DROPS_AT);
}

static tp_ring *rings(tp_drops *drops)
{
    return (tp_ring *)(void *)(list(drops) + drops->capacity);
}

const tp_drop *tp_drops_list(const tp_drops *drops)
{
    return (const tp_drop *)(const void *)((const char *)drops + DROPS_AT);
}

const tp_ring *tp_drops_rings(const tp_drops *drops)
{
    return (const tp_ring *)(const void *)(tp_drops_list(drops) + drops->capacity);
}

/* -- the sphere ---------------------------------------------------------------------- */

static tp_fx clamp_sphere_coordinate(int64_t x)
{
    return (tp_fx)tp_clamp_abs(x, TP_DROPS_SPHERE_FAR);
}

void tp_drops_move_releasing_sphere(tp_drops *drops, tp_fx dx, tp_fx dz)
{
    drops->last_sphere = drops->sphere;
    drops->sphere.x = clamp_sphere_coordinate((int64_t)drops->sphere.x + dx);
    drops->sphere.z = clamp_sphere_coordinate((int64_t)drops->sphere.z + dz);
}

/* Returns a random place, uniform over a disc of radius `reach` around the sphere's
 * centre.  The square root gives each annulus of equal width a share in proportion to its
 * area. */
static tp_vec3 random_release_place(tp_drops *drops, tp_fx reach)
{
    tp_turn round = tp_random(&drops->random);
    tp_fx   way = tp_fx_mul(tp_fx_sqrt((tp_fx)(tp_random(&drops->random) >> 16)), reach);
    tp_vec3 at = drops->sphere;

    at.x += tp_q30_mul(way, tp_sin(round));
    at.z += tp_q30_mul(way, tp_cos(round));
    return at;
}

void tp_drops_release(tp_drops *drops, const tp_scene_drops *config, uint32_t count)
{
    TP_ASSERT(drops->count <= drops->capacity);
    uint32_t room = drops->capacity - drops->count, most = UINT32_MAX - drops->dropped;
    uint32_t fits = count < room ? count : room, lost = count - fits;
    tp_fx    reach = config->scatter_radius;

    if (count > 1 && reach < drops->sphere_radius)
        reach = drops->sphere_radius;
    for (uint32_t i = 0; i < fits; i++) {
        tp_vec3 at = random_release_place(drops, reach);
        list(drops)[drops->count++] = (tp_drop){
            .place = at, .last = at, .high_q32 = (int64_t)at.y * 65536,
            .radius = config->radius, .level = TP_DROP_NEW,
        };
    }
    drops->released += fits;
    drops->dropped += lost < most ? lost : most;
}

/* Releases the drops due in this tick.  The interval is at most 60 s, 22 bits, so its
 * product with 60 fits 32 bits.  At 1/65536 s the loop releases 1092 drops per tick. */
void tp_drops_release_by_interval(tp_drops *drops, const tp_scene_drops *config)
{
    uint32_t interval = (uint32_t)config->interval * TP_TICKS_PER_SECOND, due = 0;

    if (config->interval <= 0) {
        drops->wait = 0;
        return;
    }
    if (drops->wait > interval)             /* the interval was longer at its start */
        drops->wait = interval;
    for (; drops->wait < TP_FX_ONE; due++)
        drops->wait += interval;
    drops->wait -= TP_FX_ONE;
    tp_drops_release(drops, config, due);
}

/* -- impacts ------------------------------------------------------------------------- */

bool tp_drops_step_drop(tp_drops *drops, const tp_scene_drops *config, uint32_t i,
                        tp_fx gravity, tp_fx level, uint64_t tick, tp_impact *impact)
{
    TP_ASSERT(i < drops->count);
    bool struck = tp_drop_step(&list(drops)[i], config, gravity, level, tick, impact);

    drops->impacts += struck;
    return struck;
}

/* Adds a ring.  The smallest drops ask for shorter waves than a ring can have; the length
 * is clamped. */
bool tp_drops_add_ring(tp_drops *drops, const tp_scene_drops *config,
                       const tp_impact *impact)
{
    TP_ASSERT(drops->rings <= drops->ring_capacity);
    if (impact->amplitude <= 0)
        return false;
    if (drops->rings == drops->ring_capacity) {
        drops->rings_dropped++;
        return false;
    }
    rings(drops)[drops->rings++] = (tp_ring){
        .x = impact->x, .z = impact->z,
        .start = impact->time,
        .amplitude = impact->amplitude,
        .length = tp_clamp(impact->length, TP_FX(0.02), 64 * TP_FX_ONE),
        .speed = config->ring_speed,
        .decay = config->ring_decay,
        .spread = config->ring_spread,
        .attack = config->ring_rise_time,
    };
    return true;
}

void tp_drops_rings_remove_spent(tp_drops *drops, int64_t now, tp_fx max_distance)
{
    tp_drop *drop = list(drops);
    tp_ring *ring = rings(drops);
    uint32_t n = 0;

    for (uint32_t i = 0; i < drops->count; i++)
        if (drop[i].radius > 0)
            drop[n++] = drop[i];
    drops->count = n;
    n = 0;
    for (uint32_t i = 0; i < drops->rings; i++)
        if (!tp_ring_is_spent(&ring[i], now, max_distance))
            ring[n++] = ring[i];
    drops->rings = n;
}

/* -- the module's state -------------------------------------------------------------- */

/* The rings at this tick, for the water's surface.  The array stands after the block of
 * tp_drops; its room is 0 if drops do not raise rings. */
typedef struct {
    uint32_t count, room;
    tp_ring_now ring[];
} rings_now;

static rings_now *current_rings(const tp_drops *drops)
{
    const tp_ring *end = tp_drops_rings(drops) + drops->ring_capacity;
    return (rings_now *)(uintptr_t)end;
}

const tp_drops *tp_world_drops(const tp_world *world)
{
    return tp_world_module_state(world, TP_DROPS_ID);
}

bool tp_drops_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->drops.count > 0;
}

static uint32_t configured_ring_capacity(const tp_scene_drops *config)
{
    return config->target == TP_DROPS_RINGS ? clamp_capacity(config->rings) : 0;
}

static size_t bytes(const tp_module_conditions *conditions)
{
    const tp_scene_drops *config = &conditions->scene->drops;

    return tp_drops_bytes(config) + sizeof(rings_now)
           + configured_ring_capacity(config) * sizeof(tp_ring_now);
}

static tp_status init(void *mine, tp_world *world, const tp_module_conditions *conditions,
                      tp_error *err)
{
    (void)world, (void)err;
    tp_drops_init(mine, &conditions->scene->drops);
    *current_rings(mine) =
        (rings_now){ .room = configured_ring_capacity(&conditions->scene->drops) };
    return TP_OK;
}

static bool fits(const void *mine, const tp_scene *scene)
{
    const tp_drops *drops = mine;

    return drops->capacity == clamp_capacity(scene->drops.count)
           && drops->ring_capacity == clamp_capacity(scene->drops.rings)
           && current_rings(drops)->room == configured_ring_capacity(&scene->drops);
}

static bool apply_sphere_config(void *mine, tp_world *world,
                                const tp_module_conditions *conditions)
{
    tp_drops *drops = mine;

    (void)world;
    drops->sphere.y = conditions->scene->drops.y;
    drops->sphere_radius = 2 * conditions->scene->drops.radius;
    return true;
}

/* -- a tick -------------------------------------------------------------------------- */

/* Handles an impact.  With drops.target = rings the impact raises a ring; otherwise a pool
 * takes the same impact [D5]. */
static bool handle_impact(void *mine, const tp_program *program,
                          const tp_scene *scene, const tp_impact *impact, tp_fx level)
{
    (void)program, (void)level;
    return scene->drops.target == TP_DROPS_RINGS
           && tp_drops_add_ring(mine, &scene->drops, impact);
}

static void move_drops(tp_drops *drops, const tp_program *program, tp_world *world,
                       const tp_scene *scene)
{
    const tp_surface surface = tp_world_surface(program, world);
    const tp_drop *drop = tp_drops_list(drops);
    tp_impact impact;

    for (uint32_t i = 0; i < drops->count; i++) {
        tp_fx level = tp_surface_sample(&surface, drop[i].place.x, drop[i].place.z,
                                       NULL).position.y;
        if (tp_drops_step_drop(drops, &scene->drops, i, scene->water.gravity, level,
                               world->tick, &impact))
            tp_modules_handle_impact(program, world, scene, &impact, level);
    }
}

uint32_t tp_drops_rings_evaluate(const tp_drops *drops, const tp_program *program,
                                 int64_t time, tp_ring_now *to, uint32_t room)
{
    const tp_ring *ring = tp_drops_rings(drops);
    uint32_t n = 0;

    for (uint32_t i = 0; program->water.rings && i < drops->rings && n < room; i++)
        n += program->water.rings->at(&ring[i], time, &to[n]);
    return n;
}

static void step(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *in)
{
    const int64_t time = (int64_t)(world->tick * TP_FX_ONE);
    tp_drops *drops = mine;
    rings_now *now = current_rings(drops);

    tp_drops_move_releasing_sphere(drops, in ? in->sphere_x : 0, in ? in->sphere_z : 0);
    tp_drops_release_by_interval(drops, &scene->drops);
    if (in && in->drops > 0)
        tp_drops_release(drops, &scene->drops, (uint32_t)in->drops);
    move_drops(drops, program, world, scene);
    tp_drops_rings_remove_spent(drops, time, 200 * TP_FX_ONE);
    now->count = tp_drops_rings_evaluate(drops, program, time, now->ring, now->room);
}

static void add_surface(const void *mine, tp_surface *surface)
{
    const rings_now *now = current_rings(mine);

    surface->ring = now->ring;
    surface->rings = now->count;
    surface->raised = tp_drops_rings(mine);
    surface->n_raised = ((const tp_drops *)mine)->rings;
}

/* True if `now` is empty or holds exactly the drops' rings at this time. */
static bool are_rings_valid(const tp_drops *drops, const rings_now *now, int64_t time)
{
    uint32_t n = 0;

    if (now->count == 0)
        return true;
    for (uint32_t i = 0; i < drops->rings && n < now->count && n < now->room; i++) {
        tp_ring_now at;
        if (!tp_ring_evaluate(&tp_drops_rings(drops)[i], time, &at))
            continue;
        if (memcmp(&at, &now->ring[n++], sizeof at) != 0)
            return false;
    }
    return n == now->count;
}

static bool is_valid(const void *mine, const void *fresh, const tp_world *world)
{
    return tp_drops_are_valid(mine, fresh, world->tick)
        && current_rings(mine)->room == current_rings(fresh)->room
        && are_rings_valid(mine, current_rings(mine), (int64_t)(world->tick * TP_FX_ONE));
}

#define RADII  6                /* of a drop in the length of a ring; the first has 8 [D4] */
#define DECAYS 2                /* a ring runs for: 6 % of the height is left, with the spreading */

static void add_detail(const tp_scene *scene, bool flat, tp_water_detail *detail)
{
    const tp_scene_drops *drops = &scene->drops;
    const int64_t length = (int64_t)drops->radius * RADII;
    const int64_t half = drops->scatter_radius + length
                         + ((int64_t)drops->ring_speed * drops->ring_decay * DECAYS >> 16);

    (void)flat;
    if (drops->count > 0 && drops->target == TP_DROPS_RINGS && !detail->walls)
        tp_grid_detail_widen(detail, length, tp_rectangle_make(drops->x, drops->z, half, half));
}

const tp_module tp_drops_module = {
    .name = "drops",
    .id = TP_DROPS_ID,
    .is = TP_MODULE_SOLID | TP_MODULE_SAMPLES | TP_MODULE_DRAWS(DROP),
    .enabled = tp_drops_enabled,
    .bytes = bytes,
    .init = init,
    .fits = fits,
    .refresh = apply_sphere_config,
    .step = step,
    .hit = handle_impact,
    .surface = add_surface,
    .detail = add_detail,
    .is_valid = is_valid,
};
