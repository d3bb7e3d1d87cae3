/* SPDX-License-Identifier: MIT */
/* The modules of a scene's two pools: [pool], stirred by drops and by user input, and
 * [field].  In a tick the splashes, by user input and at random, come first.  Then a
 * paddle pushes the water (paddle.c).  Then each pool steps. */
#include "base/base.h"
#include "features/pool/pool_module.h"
#include "pool/pool.h"
#include "scene/world.h"

/* -- enabled pools ------------------------------------------------------------------- */

static bool is_pool_enabled(const tp_want *want, const tp_scene_pool *pool)
{
    return pool->cols > 0 && (!want->water || want->water->pools);
}

bool tp_main_pool_enabled(const tp_want *want)
{
    return is_pool_enabled(want, &want->scene->pool);
}

bool tp_field_enabled(const tp_want *want)
{
    return is_pool_enabled(want, &want->scene->field);
}

/* -- splashes ------------------------------------------------------------------------ */

/* Returns a random place along one side, within the middle four fifths of a pool. */
static tp_fx random_place(tp_world *world, tp_fx centre, int32_t cells, tp_fx cell)
{
    int64_t side = (int64_t)cells * cell * 4 / 5;
    return (tp_fx)(centre - side / 2 + (side * (tp_random(&world->random) >> 8) >> 24));
}

static void step_random_splash(tp_basin *basin, tp_world *world, const tp_scene_pool *scene)
{
    if (!basin || scene->poke_every <= 0)
        return;
    uint32_t every = (uint32_t)((int64_t)scene->poke_every * TP_TICKS_PER_SECOND >> 16);
    if (basin->poke_wait > every)       /* the interval was longer at its start */
        basin->poke_wait = every;
    if (basin->poke_wait > 0 && --basin->poke_wait > 0)
        return;
    basin->poke_wait = every;
    tp_fx x = random_place(world, scene->x, scene->cols, scene->cell);
    tp_fx z = random_place(world, scene->z, scene->rows, scene->cell);
    tp_pool_add_splash(&basin->pool, x, z, scene->poke_size, scene->poke);
}

static void add_user_splashes(tp_pool *pool, const tp_scene *scene, const tp_input *in)
{
    for (int i = 0; in && pool && i < TP_PUSHES; i++) {
        const tp_push *p = &in->push[i];
        if (p->height != 0)
            tp_pool_add_splash(pool, p->x, p->z, scene->pool.poke_size, p->height);
    }
}

static void step_pokes(void *mine, const tp_program *program, tp_world *world,
                       const tp_scene *scene, const tp_input *in)
{
    (void)mine, (void)program;
    add_user_splashes(tp_world_mutable_pool(world), scene, in);
    step_random_splash(tp_world_module_state(world, TP_POOL_ID), world, &scene->pool);
    step_random_splash(tp_world_module_state(world, TP_FIELD_ID), world, &scene->field);
}

bool tp_pokes_enabled(const tp_want *want)
{
    return tp_main_pool_enabled(want) || tp_field_enabled(want);
}

const tp_module tp_pokes_module = {
    .name = "pokes", .id = TP_MODULE_ID('p', 'o', 'k', 'e'), .enabled = tp_pokes_enabled,
    .step = step_pokes,
};

/* -- common to both pools ------------------------------------------------------------ */

static size_t basin_bytes(const tp_want *want, bool field)
{
    const tp_pool_config config = tp_pools_config(want->scene, want->assets, field);
    return offsetof(tp_basin, pool) + tp_pool_bytes(&config);
}

static tp_status init_one(tp_basin *basin, const tp_want *want, bool field, tp_error *err)
{
    const tp_pool_config config = tp_pools_config(want->scene, want->assets, field);
    return tp_pool_init(&basin->pool, &config, err);
}

/* True if the new parameters fit.  The test runs on a copy of the pool's head; the copy
 * has no memory for a sponge layer. */
static bool fits_one(const tp_basin *basin, const tp_scene *scene, bool field)
{
    const tp_pool_config config = tp_pools_config(scene, NULL, field);
    tp_pool head = basin->pool;

    head.sponge = 0;
    return tp_pool_set_config(&head, &config);
}

static bool refresh_one(tp_basin *basin, const tp_scene *scene, bool field)
{
    const tp_pool_config config = tp_pools_config(scene, NULL, field);
    return tp_pool_set_config(&basin->pool, &config);
}

static void step(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *in)
{
    tp_basin *basin = mine;

    (void)program, (void)world, (void)scene, (void)in;
    tp_pool_step(&basin->pool);
}

static bool is_valid(const void *mine, const void *made, const tp_world *world)
{
    (void)world;
    const tp_basin *basin = mine, *fresh = made;
    return tp_pool_is_valid(&basin->pool, &fresh->pool);
}

/* -- [pool] -------------------------------------------------------------------------- */

static tp_status pool_check(const tp_want *want, tp_error *err)
{
    return tp_pools_check(want->scene, want->assets, false, err);
}

static size_t pool_bytes(const tp_want *want)
{
    return basin_bytes(want, false);
}

static tp_status pool_init(void *mine, tp_world *world, const tp_want *want, tp_error *err)
{
    (void)world;
    return init_one(mine, want, false, err);
}

static bool pool_fits(const void *mine, const tp_scene *scene)
{
    return fits_one(mine, scene, false);
}

static bool pool_refresh(void *mine, tp_world *world, const tp_want *want)
{
    (void)world;
    return refresh_one(mine, want->scene, false);
}

/* Handles an impact: a splash of the strength of a ring [D5]. */
static bool pool_hit(void *mine, const tp_scene *scene, const tp_impact *impact,
                     tp_fx level)
{
    tp_basin *basin = mine;

    (void)level;
    return scene->drops.into != TP_DROPS_RINGS
           && tp_pool_add_splash(&basin->pool, impact->x, impact->z, impact->length / 4,
                                 -impact->amplitude);
}

static void pool_surface(const void *mine, tp_surface *surface)
{
    surface->pool = surface->by->pools ? &((const tp_basin *)mine)->pool : NULL;
}

const tp_module tp_main_pool_module = {
    .name = "pool", .id = TP_POOL_ID,
    .enabled = tp_main_pool_enabled, .check = pool_check,
    .bytes = pool_bytes, .init = pool_init, .fits = pool_fits, .refresh = pool_refresh,
    .step = step, .surface = pool_surface, .hit = pool_hit, .is_valid = is_valid,
};

/* -- [field] ------------------------------------------------------------------------- */

static tp_status field_check(const tp_want *want, tp_error *err)
{
    return tp_pools_check(want->scene, want->assets, true, err);
}

static size_t field_bytes(const tp_want *want)
{
    return basin_bytes(want, true);
}

static tp_status field_init(void *mine, tp_world *world, const tp_want *want, tp_error *err)
{
    (void)world;
    return init_one(mine, want, true, err);
}

static bool field_fits(const void *mine, const tp_scene *scene)
{
    return fits_one(mine, scene, true);
}

static bool field_refresh(void *mine, tp_world *world, const tp_want *want)
{
    (void)world;
    return refresh_one(mine, want->scene, true);
}

static void field_surface(const void *mine, tp_surface *surface)
{
    surface->field = surface->by->pools ? &((const tp_basin *)mine)->pool : NULL;
}

const tp_module tp_field_module = {
    .name = "field", .id = TP_FIELD_ID, .enabled = tp_field_enabled, .check = field_check,
    .bytes = field_bytes, .init = field_init, .fits = field_fits,
    .refresh = field_refresh, .surface = field_surface, .step = step, .is_valid = is_valid,
};
