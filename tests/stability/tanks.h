/* SPDX-License-Identifier: MIT */
/* Tanks with an r set by the test, and invariants of all tanks. */
#ifndef TP_TESTS_TANKS_H
#define TP_TESTS_TANKS_H
#include "tests/unit/pools.h"
#include "pool/pool.h"

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
    pool->r2q = r2q_of(r);
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
