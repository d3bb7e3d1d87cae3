/* SPDX-License-Identifier: MIT */
/* A tick's cost: instructions a cell, counted on a Cortex-M4, times the cells of a world that
 * has run for a second.  Still cells cost less than moving ones, so the world is needed. */
#include "tick_cost.h"
#include "features/foam/foam_visit.h"
#include "waves/coastal_tables.h"
#include "world/pools.h"
#include "world/world.h"

#define WARM 60                 /* ticks before the estimate, as in the budgets */
#define TICKS 8                 /* of the estimate: whole steps of pools, a round of foam */

/* Kinds of work, with the instructions of a Cortex-M0+ for one of a Cortex-M4, counted by
 * tests/budgets/processor-ticks.sh.  Cells of up to 16 bits: pond; with a sponge: tank 1.58,
 * harbour 1.77; of 32 bits: tank 1.31, pond 1.45.  Waves have products of 64 bits: storm,
 * deep-sea, and shallows, where a wave over a map takes 5.29 with the coastal wave's share.
 * COASTAL: the rest of the ticks of deep-sea 2.98 and shallows 3.12.  In hundredths. */
#define WORKS(X) \
    X(CELLS, 190) X(SPONGE, 165) X(WIDE, 140) X(DRIVE, 290) X(VISITS, 310) X(DEEP, 490) \
    X(COASTAL, 300) X(COASTAL_WAVES, 380) X(MAP_WAVES, 730)

enum {
#define X(name, m0plus) name,
    WORKS(X)
#undef X
    WORK_COUNT
};

/* Instructions of a Cortex-M4. */
typedef struct { uint64_t of[WORK_COUNT]; } tick_work;

static const uint32_t factors[][WORK_COUNT] = {
#define X(name, m0plus) [name] = 100,
    [TP_PROCESSOR_M4] = { WORKS(X) },
#undef X
#define X(name, m0plus) [name] = m0plus,
    [TP_PROCESSOR_M0PLUS] = { WORKS(X) },
#undef X
};

static uint64_t work_cost(const tick_work *work, tp_processor processor)
{
    uint64_t sum = 0;

    for (int i = 0; i < WORK_COUNT; i++)
        sum += work->of[i] * factors[processor][i];
    return sum / 100;
}

/* -- pools --------------------------------------------------------------------------- */

typedef struct { uint32_t still, moving; } cell_cost;

/* Costs of a cell by its bits, without inner walls, with walls and with a sponge.  Moving
 * cells: assets/charts/pool.csv at 64 x 64 cells.  Still cells, and inner walls: counted
 * ticks of harbour and tank.  Cells of 32 bits cost the same in either. */
static const cell_cost cell_costs[3][3] = {
    [TP_CELLS_8] = { { 25, 37 }, { 32, 49 }, { 50, 81 } },
    [TP_CELLS_16] = { { 23, 39 }, { 32, 51 }, { 50, 82 } },
    [TP_CELLS_32] = { { 109, 109 }, { 122, 122 }, { 138, 138 } },
};

#define PADDLE_COLUMN 336       /* a push of two cells */
#define DRIVE_CELL 15           /* the rms of heights, a cell */
#define INJECTION 190000        /* a splash of the drive */

static uint32_t count_moving_cells(const tp_pool *pool)
{
    uint32_t count = 0;

    for (uint32_t row = 0; row < pool->rows; row++)
        for (uint32_t col = 0; col < pool->cols; col++)
            count += tp_pool_velocity(pool, col, row) != 0;
    return count;
}

/* Adds the work of a step; `injected`: splashes of the drive in it. */
static void add_step(tick_work *work, const tp_pool *pool, const tp_scene_pool *scene,
                     uint32_t injected)
{
    const cell_cost *cost =
        &cell_costs[pool->cells][pool->sponge != 0 ? 2 : pool->walls != 0];
    const uint64_t cells = tp_pool_count(pool), moving = count_moving_cells(pool);

    const int kind = pool->cells == TP_CELLS_32 ? WIDE : pool->sponge != 0 ? SPONGE : CELLS;

    if (!pool->at_rest)
        work->of[kind] += cost->still * (cells - moving) + cost->moving * moving;
    work->of[DRIVE] += (scene->paddle > 0 ? (uint64_t)PADDLE_COLUMN * pool->cols : 0)
                     + (scene->drive_min > 0 ? DRIVE_CELL * cells : 0)
                     + (uint64_t)INJECTION * injected;
}

/* Steps the world by a tick and returns the work of its pools. */
static tick_work step_pools(tp_world *world, const tp_scene *scene)
{
    const tp_scene_pool *of[2] = { &scene->pool, &scene->field };
    const tp_pool *pool[2] = { tp_world_pool(world), tp_world_field(world) };
    uint32_t before[2] = { 0, 0 };
    bool due[2] = { false, false };
    tick_work work = { { 0 } };

    for (int i = 0; i < 2; i++)
        if (pool[i]) {
            due[i] = tp_pool_is_due(pool[i]);
            before[i] = pool[i]->injections;
        }
    tp_world_step(&tp_program_all, world, scene, NULL);
    for (int i = 0; i < 2; i++)
        if (due[i])
            add_step(&work, pool[i], of[i], pool[i]->injections - before[i]);
    return work;
}

/* -- foam ---------------------------------------------------------------------------- */

/* Costs of a visit of a cell.  Sources are asked at each visit, or with n slices at every
 * n-th; waves are then sampled at every second cell of every second row. */
#define VISIT 91                /* gain and cover */
#define VISIT_SLICED 19         /* without sources: an empty cell */
#define FADE 33                 /* a cell with cover, in addition */
#define WALL 445                /* the speed along a pool's walls */
#define HULL_FAR 22             /* a cell beyond the foam of a hull */
#define HULL_NEAR 150
#define DEEP_VISIT 35           /* the Jacobian of deep water, and of each wave */
#define DEEP_WAVE 69
#define COASTAL_VISIT 320       /* coastal water, and each wave */
#define COASTAL_WAVE 354
#define MAP_WAVE 266            /* each wave over a map of the floor, in addition */

/* Shares are fixed-point numbers from 0 to TP_FX_ONE. */
static uint64_t scale(uint64_t work, uint64_t share)
{
    return work * share >> 16;
}

static uint64_t covered_share(const tp_foam *foam)
{
    const uint8_t *cover = (const uint8_t *)(foam + 1);
    const uint64_t cells = (uint64_t)foam->cells * foam->cells;
    uint64_t count = 0;

    for (size_t i = 0; i < cells; i++)
        count += cover[i] != 0;
    return count * TP_FX_ONE / cells;
}

/* Returns the cost of a hull's foam for `visits` cells: near the hull a cell costs more. */
static uint64_t hull_cost(const tp_foam_maker *m, const tp_foam *foam, uint64_t visits)
{
    const uint64_t side = (uint64_t)foam->cells * (uint64_t)foam->cell;
    const uint64_t reach = 2 * (uint64_t)m->hull.foam_radius;
    const uint64_t along = reach < side ? reach * TP_FX_ONE / side : TP_FX_ONE;
    const uint64_t near = scale(visits, scale(along, along));

    return m->has_hull ? visits * HULL_FAR + near * HULL_NEAR : 0;
}

/* Returns the share of the foam's window over water. */
static uint64_t wet_share(const tp_coastal_water *coastal, const tp_foam *foam)
{
    uint64_t wet = 0, all = 0;

    for (int32_t j = 0; j < (int32_t)foam->cells; j += 4)
        for (int32_t i = 0; i < (int32_t)foam->cells; i += 4, all++) {
            const tp_fx x = tp_foam_cell_centre(foam, foam->first_x + i, foam->drift_x);
            const tp_fx z = tp_foam_cell_centre(foam, foam->first_z + j, foam->drift_z);
            wet += tp_coastal_floor(coastal, x, z).depth > 0;
        }
    return wet * TP_FX_ONE / all;
}

/* Adds the waves' work of a number of visits. */
static void add_waves(tick_work *work, const tp_world *world, const tp_scene *scene,
                      const tp_foam *foam, uint64_t visits)
{
    const tp_coastal_water *coastal = tp_world_coastal(world);
    const uint64_t waves = world->deep.count;

    if (!coastal) {
        work->of[DEEP] += visits * (DEEP_VISIT + DEEP_WAVE * waves);
        return;
    }
    visits = scale(visits, wet_share(coastal, foam));
    work->of[COASTAL] += visits * COASTAL_VISIT;
    work->of[COASTAL_WAVES] += visits * COASTAL_WAVE * waves;
    work->of[MAP_WAVES] += scene->floor.map[0] ? visits * MAP_WAVE * waves : 0;
}

/* Adds the mean work of a tick's visits. */
static void add_foam(tick_work *work, const tp_world *world, const tp_scene *scene)
{
    tp_foam *foam = tp_foam_of_world(world);
    tp_foam_maker m;

    if (!foam)
        return;
    tp_foam_maker_begin(&m, foam, &tp_program_all.water, world, scene);
    const uint64_t n = foam->slices;
    const uint64_t visits = (uint64_t)foam->cells * foam->cells / TP_FOAM_TICKS;
    const uint64_t walls = m.pool ? WALL : 0, hull = hull_cost(&m, foam, visits);
    const bool foams = foam->slices > 1 ? tp_foam_maker_has_waves(&m)
                                        : m.coastal || scene->foam.crest > 0;

    work->of[VISITS] += n > 1 ? visits * VISIT_SLICED
                                    + FADE * scale(visits, covered_share(foam))
                                    + visits * (VISIT + walls) / n + hull * 2 / 5
                              : visits * (VISIT + walls) + hull;
    if (foams)
        add_waves(work, world, scene, foam, n > 1 ? visits / (4 * n) : visits);
}

/* ----------------------------------------------------------------------------------- */

tick_cost tick_cost_estimate(tp_world *world, const tp_scene *scene,
                             tp_processor processor)
{
    tick_work visits = { { 0 } };
    uint64_t sum = 0, most = 0;

    for (int i = 0; i < WARM; i++)
        tp_world_step(&tp_program_all, world, scene, NULL);
    for (int i = 0; i < TICKS; i++) {
        const tick_work work = step_pools(world, scene);
        const uint64_t pools = work_cost(&work, processor);
        sum += pools;
        most = pools > most ? pools : most;
    }
    add_foam(&visits, world, scene);
    const uint64_t foam = work_cost(&visits, processor);
    return (tick_cost){ sum / TICKS + foam, most + foam };
}
