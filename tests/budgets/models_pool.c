/* SPDX-License-Identifier: MIT */
/* Models of the pool: steps per cell, surface per point; see models.c. */
#include "tests/budgets/models.h"

enum { TICKS = 2, MASK_SIDE = 64 };

static tp_pool *const pool = (tp_pool *)(void *)&model.block;
static uint32_t pool_bytes;

/* Mask with pillars of 4 x 4 cells, one in each 16 x 16 of 64 x 64 cells. */
static const tp_grey *pillars(void)
{
    static uint16_t sample[MASK_SIDE * MASK_SIDE];
    static const tp_grey mask = { MASK_SIDE, MASK_SIDE, sample };

    for (int z = 0; z < MASK_SIDE; z++)
        for (int x = 0; x < MASK_SIDE; x++)
            sample[z * MASK_SIDE + x] = (x & 15) < 4 && (z & 15) < 4 ? 0 : 65535;
    return &mask;
}

/* Adds standing waves along and across, of 16 cells and more, at most `high` each. */
static void ruffle(int32_t high)
{
    for (uint32_t z = 0; z < pool->rows; z++)
        for (uint32_t x = 0; x < pool->cols; x++) {
            const tp_q30 wave = tp_cos(x << 27) / 4 + tp_cos(z << 26) / 4
                              + tp_cos((x + z) << 25) / 4;
            tp_pool_add_cell_height(pool, x, z, tp_q30_mul(high, wave));
        }
}

/* Gear A, except the settling pool; two steps, so that all cells move. */
tp_pool *model_pool(int kind)
{
    const int      with = kind / 8;
    const uint32_t side = kind & 4 ? 128 : 64;
    const tp_pool_config config = {
        .cols = side, .rows = side, .cells = (tp_cells)(kind & 3),
        .edges = with == SPONGE ? TP_EDGES_SPONGE : with == TILED ? TP_EDGES_TILE
                                                                  : TP_EDGES_WALL,
        .courant = TP_FX(0.4841), .damping = 6, .sponge = 8, .range = TP_FX(1),
        .cell = TP_FX(0.25), .mask = with == MASK ? pillars() : NULL,
        .drive_min = with == FED ? TP_FX(0.01) : 0,
        .drive_max = with == FED ? TP_FX(0.5) : 0, .drive_amplitude = TP_FX(0.1),
    };
    const int32_t high = config.cells == TP_CELLS_8 ? 100
                       : config.cells == TP_CELLS_16 ? 25000 : 1 << 23;

    pool_bytes = (uint32_t)tp_pool_bytes(&config);
    model_expect(pool_bytes <= sizeof model.block, "the pool is too large");
    model_expect(!tp_pool_init(pool, &config, NULL), "no pool");
    ruffle(high);
    if (with != SETTLE)
        tp_pool_start_carry_rounding(pool, high);
    tp_pool_step(pool);
    tp_pool_step(pool);
    model_expect(!pool->at_rest, "still water");
    return pool;
}

/* Bytes of a cell: the block without its head, per cell, rounded. */
static void prepare_step(int kind)
{
    const uint32_t head = sizeof(tp_pool);

    model_pool(kind);
    const uint32_t cells = pool->cols * pool->rows;
    model.count = TICKS * cells;
    model.bytes = (pool_bytes - head + cells / 2) / cells;
}

COUNTED(step)
{
    for (int i = 0; i < TICKS; i++)
        tp_pool_step(pool);
    model_expect(!pool->at_rest, "water that came to rest");
}

static void prepare_relief(int kind)
{
    model_pool(kind);
}

COUNTED(relief)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const tp_height_slope at = tp_pool_height_slope(pool, PLACE_X(i, TP_FX(7.9)),
                                            PLACE_Z(i, TP_FX(7.9)), TP_FX(0.25));
        KEEP(at);
    }
}

/* Splash of sigma 2 cells: a window of 23 x 23. */
COUNTED(hat)
{
    for (uint32_t i = 0; i < model.count; i++)
        tp_pool_add_splash(pool, PLACE_X(i, TP_FX(4)), PLACE_Z(i, TP_FX(4)), TP_FX(0.5),
                           TP_FX(0.1));
}

#define STEP(name, cells, side, with) \
    { name, "cell", "a cell", prepare_step, counted_step, \
      MODEL_POOL(cells, side, with), 0 }
#define STEPS(name, cells) \
    STEP(name "-64", cells, 64, OPEN), STEP(name "-128", cells, 128, OPEN), \
    STEP(name "-mask-64", cells, 64, MASK), STEP(name "-mask-128", cells, 128, MASK), \
    STEP(name "-sponge-64", cells, 64, SPONGE), \
    STEP(name "-sponge-128", cells, 128, SPONGE), \
    STEP(name "-tiled-64", cells, 64, TILED), STEP(name "-tiled-128", cells, 128, TILED)
#define RELIEF(name, cells, with) \
    { name, "point", "", prepare_relief, counted_relief, MODEL_POOL(cells, 64, with), \
      256 }

const model_row model_pools[] = {
    STEPS("pool-8", TP_CELLS_8),
    STEPS("pool-16", TP_CELLS_16),
    STEPS("pool-32", TP_CELLS_32),
    STEP("pool-8-settling-64", TP_CELLS_8, 64, SETTLE),
    STEP("pool-16-settling-64", TP_CELLS_16, 64, SETTLE),
    STEP("pool-16-fed-64", TP_CELLS_16, 64, FED),
    RELIEF("relief-8", TP_CELLS_8, OPEN),
    RELIEF("relief-16", TP_CELLS_16, OPEN),
    RELIEF("relief-32", TP_CELLS_32, OPEN),
    RELIEF("relief-16-mask", TP_CELLS_16, MASK),
    RELIEF("relief-16-tiled", TP_CELLS_16, TILED),
    { "hat-16", "hat", "", prepare_relief, counted_hat,
      MODEL_POOL(TP_CELLS_16, 64, OPEN), 4 },
    { 0 },
};
