/* SPDX-License-Identifier: MIT */
/* Pools for tests, each in a block of exactly the required bytes, filled with 0xa5 before:
 * the sanitizers see any access beyond. */
#ifndef TP_TESTS_POOLS_H
#define TP_TESTS_POOLS_H
#include "chance.h"
#include "pool/pool.h"

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
            tp_pool_add(pool, x, y, chance_int(chance, -most, most));
    tp_pool_wake(pool, most);
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
#endif
