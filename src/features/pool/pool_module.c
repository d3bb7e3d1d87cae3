/* SPDX-License-Identifier: MIT */
/*
 * The modules of a scene's two pools: [pool], stirred by drops and by user input, and
 * [field]; and the paddle at a pool's edge.  In a tick the splashes, by user input and at
 * random, come first.  Then a paddle pushes the water.  Then each pool steps.
 */
#include "base/base.h"
#include "features/pool/pool_module.h"
#include "pool/pool.h"
#include "view/wave_models.h"
#include "world/world.h"

/* -- the paddle ---------------------------------------------------------------------- */

/* A paddle at a pool's north edge: two rows of cells about half a wavelength apart.  One
 * row is pushed up while the other is pushed down, with the period of the wave.  The gain
 * of one row equals the loss of the other, so the sum of all heights stays.
 *
 * A wave obeys sin(k/2) = sin(om/2) / r, with k and om its phase per cell and per tick
 * [C1].  A row pushed by d per tick sends d / (2 r cos(k/2)) in both directions.  The
 * second row, n cells away with opposite sign, multiplies the amplitude by 2 sin(k
 * n / 2).  At a wall the mirrored rows contribute too; the factor is 2 (cos(k/2) - cos(k
 * (n + 1/2))). */

typedef struct {
    uint32_t row, apart;        /* the rows are `row` and `row + apart` */
    int32_t  push;              /* maximum per step, LSB */
} stroke;

/* Returns om / 2 of a tick, a turn.  The period is at least 0.1 s, so the result is below
 * 1/12 turn. */
static tp_turn half_phase_per_tick(const tp_scene_pool *scene)
{
    TP_ASSERT(scene->paddle_period > 0);
    return (tp_turn)(((uint64_t)1 << 47) / ((uint64_t)(uint32_t)scene->paddle_period
                                            * TP_TICKS_PER_SECOND));
}

/* Returns the rows and the push for the scene's wave; tick, r and om are those of a step.
 * Four ticks have a phase om / 2 below 1/3 turn, of a positive sine.  The amplitude, half
 * of the height, has 29 bits; the push is below 2^60 before its division.  The push is at
 * most the amplitude, so a pool too short for its wave gets a lower wave.  The shortest
 * waves of a grid do not travel, so k is clamped just below 1/2 turn. */
static stroke compute_stroke(const tp_pool *pool, const tp_scene_pool *scene)
{
    TP_ASSERT(scene->courant > 0 && scene->paddle >= 0);
    bool    walls = pool->edges == TP_EDGES_WALL;
    stroke  s = { .row = pool->edges == TP_EDGES_SPONGE ? (uint32_t)scene->sponge : 0 };
    const tp_turn step_half = half_phase_per_tick(scene) << pool->interval;
    const tp_fx courant = scene->courant * (1 << pool->interval);
    int64_t sine = (int64_t)tp_sin(step_half) * TP_FX_ONE / courant;

    sine = sine < TP_Q30(0.99) ? sine : TP_Q30(0.99);
    int64_t cosine = tp_isqrt64(((uint64_t)1 << 60) - (uint64_t)(sine * sine));
    tp_turn half = tp_atan2((int32_t)sine, (int32_t)cosine);            /* k / 2 */
    uint32_t most = (pool->rows - 1 - s.row) / 2;
    s.apart = (((uint32_t)1 << 30) + half / 2) / half;
    s.apart = s.apart < 1 ? 1 : s.apart > most ? most : s.apart;

    int64_t share = walls ? cosine - tp_cos(half * (2 * s.apart + 1))
                          : tp_sin(half * s.apart);
    int64_t most_push = tp_pool_from_metres(pool, scene->paddle) / 2;
    int64_t push = (most_push * courant >> 16) * cosine;
    s.push = (int32_t)(push < most_push * share ? push / share : most_push);
    return s;
}

/* Pushes one column: up at the first row, down by the same amount at the second, limited
 * by the smaller of both. */
static void push_column(tp_pool *pool, const stroke *s, uint32_t col, int32_t push)
{
    uint32_t other = s->row + s->apart;

    if (tp_pool_is_wall_or_outside(pool, col, s->row)
        || tp_pool_is_wall_or_outside(pool, col, other))
        return;
    int32_t done = tp_pool_add_cell_height(pool, col, s->row, push);
    int32_t back = tp_pool_add_cell_height(pool, col, other, -done);
    if (back != -done)
        tp_pool_add_cell_height(pool, col, s->row, -done - back);
}

void tp_paddle_push(tp_pool *pool, const tp_scene_pool *scene, uint64_t tick)
{
    stroke  s = compute_stroke(pool, scene);
    tp_turn phase = (tp_turn)(2 * (uint64_t)half_phase_per_tick(scene) * tick);
    int32_t push = tp_q30_mul(s.push, tp_sin(phase));

    for (uint32_t col = 0; push != 0 && col < pool->cols; col++)
        push_column(pool, &s, col, push);
    tp_pool_start_carry_rounding(pool, tp_pool_from_metres(pool, scene->paddle));
}

/* -- the module ---------------------------------------------------------------------- */

static bool has_paddle(const tp_scene_pool *scene)
{
    return scene->cols > 0 && scene->paddle > 0;
}

bool tp_paddle_enabled(const tp_module_conditions *conditions)
{
    return has_paddle(&conditions->scene->pool) || has_paddle(&conditions->scene->field);
}

static void step_paddle(void *mine, const tp_program *program, tp_world *world,
                        const tp_scene *scene, const tp_input *input)
{
    tp_pool *pool = tp_world_mutable_pool(world), *field = tp_world_mutable_field(world);

    (void)mine, (void)program, (void)input;
    if (pool && has_paddle(&scene->pool) && tp_pool_is_due(pool))
        tp_paddle_push(pool, &scene->pool, world->tick);
    if (field && has_paddle(&scene->field) && tp_pool_is_due(field))
        tp_paddle_push(field, &scene->field, world->tick);
}

const tp_module tp_paddle_module = {
    .name = "paddle", .id = TP_MODULE_ID('p', 'a', 'd', 'l'),
    .enabled = tp_paddle_enabled,
    .step = step_paddle,
};

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
