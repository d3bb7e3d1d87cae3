/* SPDX-License-Identifier: MIT */
/* Pools, each in a block of exactly the required bytes, filled with 0xa5 before: the
 * sanitizers see any access beyond. Tanks with an r set by the test, and their
 * invariants. */
#ifndef TP_TESTS_LIB_POOLS_H
#define TP_TESTS_LIB_POOLS_H
#include "pool/pool.h"
#include "tests/lib/random.h"

static inline tp_pool_config pool_config(tp_cells cells, tp_edges edges, uint32_t cols,
                                         uint32_t rows)
{
    return (tp_pool_config){
        .cols = cols, .rows = rows, .cells = cells, .edges = edges, .sponge = 8,
        .courant = TP_FX(0.4841), .damping = 6, .range = TP_FX(1), .cell = TP_FX(0.25),
    };
}

static inline tp_pool *pool_make(const tp_pool_config *config)
{
    tp_error err;
    const size_t bytes = tp_pool_bytes(config);
    tp_pool *const pool = malloc(bytes);

    assert_true(bytes > 0);
    memset(pool, 0xa5, bytes);
    assert_int_equal(tp_pool_init(pool, config, &err), TP_OK);
    return pool;
}

static inline void pool_steps(tp_pool *pool, int ticks)
{
    while (ticks-- > 0)
        tp_pool_step(pool);
}

/* Fills the pool with random heights within +-`most` LSB. */
static inline void pool_fill(tp_pool *pool, uint64_t *chance, int32_t most)
{
    for (uint32_t y = 0; y < pool->rows; y++)
        for (uint32_t x = 0; x < pool->cols; x++)
            tp_pool_add_cell_height(pool, x, y, chance_int(chance, -most, most));
    tp_pool_start_carry_rounding(pool, most);
}

/* A mask with walls in about `walls` of 256 cells, for pools of at most 64 x 64. */
static inline const tp_grey *pool_mask(uint64_t *chance, uint32_t cols, uint32_t rows,
                                       uint32_t walls)
{
    static uint16_t sample[64 * 64];
    static tp_grey mask;

    for (uint32_t i = 0; i < cols * rows; i++)
        sample[i] = random_below(chance, 256) < walls ? 0 : 65535;
    mask = (tp_grey){ cols, rows, sample };
    return &mask;
}

/* -- tanks with an r of their own ---------------------------------------------------- */

enum { RATES = 16 };            /* r = 0.05 .. 0.8 */

/* True if the environment asks for runs of minutes instead of seconds. */
static inline bool soak(void)
{
    return getenv("TP_SOAK") != NULL;
}

static inline double rate_at(int i)
{
    return 0.05 * (i + 1);
}

static inline uint32_t r2q_of(double r)
{
    return (uint32_t)lround(1024 * r * r);
}

static inline tp_pool *tank(tp_cells cells, tp_edges edges, uint32_t size, uint32_t m,
                            double r)
{
    tp_pool_config c = pool_config(cells, edges, size, size);
    c.damping = m;
    tp_pool *const pool = pool_make(&c);
    pool->courant_sq_q10 = r2q_of(r);
    return pool;
}

/* True if tp_pool_check accepts r and the damping [C9]. */
static inline bool is_bounded(double r, uint32_t m)
{
    tp_pool_config c = pool_config(TP_CELLS_16, TP_EDGES_WALL, 16, 16);
    c.damping = m;
    c.courant = (tp_fx)lround(r * 65536);
    return tp_pool_check(&c, NULL) == TP_OK;
}

/* Asserts that no cell leaves its range. */
static inline tp_pool_state look_bounded(const tp_pool *pool)
{
    const tp_pool_state look = tp_pool_stats(pool);
    assert_true(look.highest <= tp_pool_max_lsb(pool));
    assert_true(pool->cells == TP_CELLS_32 || look.fastest <= tp_pool_max_lsb(pool));
    return look;
}
#endif
