/* SPDX-License-Identifier: MIT */
/*
 * The modules of a scene's two pools: [pool], stirred by drops and by user input, and
 * [field].  In a tick the splashes, by user input and at random, come first.  Then a paddle
 * pushes the water (paddle.c).  Then each pool steps.
 */
#include "base/base.h"
#include "features/pool/pool_module.h"
#include "pool/pool.h"
#include "view/wave_models.h"
#include "world/world.h"

/* -- detail of the grid -------------------------------------------------------------- */

#define CELLS 16                /* of a pool in the length of its shortest waves */

static void add_pool_detail(const tp_scene_pool *pool, tp_water_detail *detail)
{
    const bool tiled = pool->boundary == TP_EDGES_TILE;
    const int64_t wide = tiled ? TP_FX_MAX : (int64_t)pool->cell * pool->cols / 2;
    const int64_t deep = tiled ? TP_FX_MAX : (int64_t)pool->cell * pool->rows / 2;

    if (pool->cols > 0)
        tp_grid_detail_widen(detail, (int64_t)pool->cell * CELLS,
                              tp_rectangle_make(pool->x, pool->z, wide, deep));
}

static void pool_detail(const tp_scene *scene, bool flat, tp_water_detail *detail)
{
    if (tp_is_walled(scene))
        *detail = (tp_water_detail){ .sides = tp_pool_sides(scene), .walls = &tp_fan_tank };
    else if (!flat)
        add_pool_detail(&scene->pool, detail);
}

static void field_detail(const tp_scene *scene, bool flat, tp_water_detail *detail)
{
    if (!flat && !detail->walls)
        add_pool_detail(&scene->field, detail);
}

/* -- enabled pools ------------------------------------------------------------------- */

static bool is_pool_enabled(const tp_module_conditions *conditions,
                            const tp_scene_pool *pool)
{
    return pool->cols > 0 && (!conditions->water || conditions->water->pools);
}

bool tp_main_pool_enabled(const tp_module_conditions *conditions)
{
    return is_pool_enabled(conditions, &conditions->scene->pool);
}

bool tp_field_enabled(const tp_module_conditions *conditions)
{
    return is_pool_enabled(conditions, &conditions->scene->field);
}

/* -- splashes ------------------------------------------------------------------------ */

/* Returns a random place along one side, within the middle four fifths of a pool. */
static tp_fx random_coordinate(tp_world *world, tp_fx centre, int32_t cells, tp_fx cell)
{
    int64_t side = (int64_t)cells * cell * 4 / 5;
    return (tp_fx)(centre - side / 2 + (side * (tp_random(&world->random) >> 8) >> 24));
}

static void step_random_splash(tp_basin *basin, tp_world *world, const tp_scene_pool *scene)
{
    if (!basin || scene->splash_interval <= 0)
        return;
    uint32_t every =
        (uint32_t)((int64_t)scene->splash_interval * TP_TICKS_PER_SECOND >> 16);
    if (basin->poke_wait > every)       /* the interval was longer at its start */
        basin->poke_wait = every;
    if (basin->poke_wait > 0 && --basin->poke_wait > 0)
        return;
    basin->poke_wait = every;
    tp_fx x = random_coordinate(world, scene->x, scene->cols, scene->cell);
    tp_fx z = random_coordinate(world, scene->z, scene->rows, scene->cell);
    tp_pool_add_splash(&basin->pool, x, z, scene->splash_width, scene->splash_height);
}

static void add_user_splashes(tp_pool *pool, const tp_scene *scene, const tp_input *in)
{
    for (int i = 0; in && pool && i < TP_PUSHES; i++) {
        const tp_push *p = &in->push[i];
        if (p->height != 0)
            tp_pool_add_splash(pool, p->x, p->z, scene->pool.splash_width, p->height);
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

bool tp_pokes_enabled(const tp_module_conditions *conditions)
{
    return tp_main_pool_enabled(conditions) || tp_field_enabled(conditions);
}

const tp_module tp_pokes_module = {
    .name = "pokes", .id = TP_MODULE_ID('p', 'o', 'k', 'e'), .enabled = tp_pokes_enabled,
    .step = step_pokes,
};

/* -- common to both pools ------------------------------------------------------------ */

static size_t basin_bytes(const tp_module_conditions *conditions, bool is_field)
{
    const tp_pool_config config =
        tp_pools_config(conditions->scene, conditions->assets, is_field);
    return offsetof(tp_basin, pool) + tp_pool_bytes(&config);
}

/* Returns the name of a part that the program lacks for this pool; NULL: none. */
static const char *find_lacking_part(const tp_wave_models *by, const tp_scene *scene,
                                     const tp_pool_config *config)
{
    static const char *const names[] = {
#define X(name) "pool_" #name,
        TP_POOL_KINDS(X)
#undef X
    };
    const bool sponge = config->edges == TP_EDGES_SPONGE;
    const uint32_t number = tp_pool_kind_number(config->cells, config->mask != NULL, sponge);
    const bool splashes = config->drive_min > 0
                          || (scene->drops.count > 0
                              && scene->drops.target != TP_DROPS_RINGS);

    return !tp_models_numbered_kind(by, number) ? names[number]
         : splashes && !by->pool_splashes       ? "pool_splashes" : NULL;
}

static tp_status check_basin(const tp_module_conditions *conditions, bool is_field,
                             tp_error *err)
{
    const tp_scene *scene = conditions->scene;
    const tp_status status = tp_pools_check(scene, conditions->assets, is_field, err);
    const tp_pool_config config = tp_pools_config(scene, conditions->assets, is_field);
    const char *lacking = status == TP_OK && config.cols > 0 && conditions->water
                              ? find_lacking_part(conditions->water, scene, &config)
                              : NULL;

    return lacking ? tp_program_fail_lacking(lacking, err) : status;
}

static tp_status init_basin(tp_basin *basin, const tp_module_conditions *conditions,
                            bool is_field, tp_error *err)
{
    const tp_pool_config config =
        tp_pools_config(conditions->scene, conditions->assets, is_field);
    return tp_pool_init(&basin->pool, &config, err);
}

/* True if the new parameters fit.  The test runs on a copy of the pool's head; the copy
 * has no memory for a sponge layer. */
static bool basin_fits_scene(const tp_basin *basin, const tp_scene *scene, bool is_field)
{
    const tp_pool_config config = tp_pools_config(scene, NULL, is_field);
    tp_pool head = basin->pool;

    head.sponge = 0;
    return tp_pool_set_config(&head, &config);
}

static bool apply_basin_config(tp_basin *basin, const tp_scene *scene, bool is_field)
{
    const tp_pool_config config = tp_pools_config(scene, NULL, is_field);
    return tp_pool_set_config(&basin->pool, &config);
}

static void step(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *in)
{
    tp_pool *pool = &((tp_basin *)mine)->pool;
    const tp_pool_kind *kind = tp_models_pool_kind(&program->water, pool);
    const struct tp_water_pool_splashes *splashes = program->water.pool_splashes;

    (void)world, (void)scene, (void)in;
    if (kind)
        tp_pool_step_kind(pool, kind, splashes ? splashes->drive : NULL);
}

static bool is_valid(const void *mine, const void *fresh_state, const tp_world *world)
{
    (void)world;
    const tp_basin *basin = mine, *fresh = fresh_state;
    return tp_pool_is_valid(&basin->pool, &fresh->pool);
}

/* -- [pool] -------------------------------------------------------------------------- */

static tp_status pool_check(const tp_module_conditions *conditions, tp_error *err)
{
    return check_basin(conditions, false, err);
}

static size_t pool_bytes(const tp_module_conditions *conditions)
{
    return basin_bytes(conditions, false);
}

static tp_status pool_init(void *mine, tp_world *world,
                           const tp_module_conditions *conditions, tp_error *err)
{
    (void)world;
    return init_basin(mine, conditions, false, err);
}

static bool pool_fits(const void *mine, const tp_scene *scene)
{
    return basin_fits_scene(mine, scene, false);
}

static bool pool_refresh(void *mine, tp_world *world,
                         const tp_module_conditions *conditions)
{
    (void)world;
    return apply_basin_config(mine, conditions->scene, false);
}

/* Handles an impact: a splash of the strength of a ring [D5]. */
static bool pool_handle_impact(void *mine, const tp_program *program,
                               const tp_scene *scene, const tp_impact *impact, tp_fx level)
{
    tp_basin *basin = mine;

    (void)level;
    return scene->drops.target != TP_DROPS_RINGS && program->water.pool_splashes
           && program->water.pool_splashes->add(&basin->pool, impact->x, impact->z,
                                                impact->length / 4, -impact->amplitude);
}

static void pool_surface(const void *mine, tp_surface *surface)
{
    const tp_pool *pool = &((const tp_basin *)mine)->pool;

    surface->pool_kind = surface->by->pools ? tp_models_pool_kind(surface->by, pool) : NULL;
    surface->pool = surface->pool_kind ? pool : NULL;
}

const tp_module tp_main_pool_module = {
    .name = "pool", .id = TP_POOL_ID,
    .enabled = tp_main_pool_enabled, .check = pool_check,
    .bytes = pool_bytes, .init = pool_init, .fits = pool_fits, .refresh = pool_refresh,
    .step = step, .surface = pool_surface, .detail = pool_detail, .hit = pool_handle_impact,
    .is_valid = is_valid,
};

/* -- [field] ------------------------------------------------------------------------- */

/* The field is the scene's second pool and uses the pool's functions, with `field` true. */

static tp_status field_check(const tp_module_conditions *conditions, tp_error *err)
{
    return check_basin(conditions, true, err);
}

static size_t field_bytes(const tp_module_conditions *conditions)
{
    return basin_bytes(conditions, true);
}

static tp_status field_init(void *mine, tp_world *world,
                            const tp_module_conditions *conditions, tp_error *err)
{
    (void)world;
    return init_basin(mine, conditions, true, err);
}

static bool field_fits(const void *mine, const tp_scene *scene)
{
    return basin_fits_scene(mine, scene, true);
}

static bool field_refresh(void *mine, tp_world *world,
                          const tp_module_conditions *conditions)
{
    (void)world;
    return apply_basin_config(mine, conditions->scene, true);
}

static void field_surface(const void *mine, tp_surface *surface)
{
    const tp_pool *pool = &((const tp_basin *)mine)->pool;

    surface->field_kind = surface->by->pools ? tp_models_pool_kind(surface->by, pool) : NULL;
    surface->field = surface->field_kind ? pool : NULL;
}

const tp_module tp_field_module = {
    .name = "field", .id = TP_FIELD_ID, .enabled = tp_field_enabled, .check = field_check,
    .bytes = field_bytes, .init = field_init, .fits = field_fits,
    .refresh = field_refresh, .surface = field_surface, .detail = field_detail,
    .step = step, .is_valid = is_valid,
};
