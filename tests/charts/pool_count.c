/* SPDX-License-Identifier: MIT */
/* Steps each pool of the chart between the marks of pool-count.sh, and prints its name:
 *     pool KEYS wall|sponge CELLS
 * once between walls, and once with a sponge layer, the two cases of scenes. The water has
 * standing waves of 16 cells and more, so all cells move, in gear A. Freestanding if the
 * compiler is in freestanding mode: static memory, words by semihosting. */
#include "cortex-m/trace_marks.h"
#include "pool/pool.h"
#include "tests/lib/board_output.h"
#include "tests/charts/pool_points.h"
#include "tidepool/tidepool.h"

/* Bytes of the largest tank, 256 x 256 cells of 32 bits with a sponge layer. */
enum { TICKS = 2, ROOM = 900 << 10 };

static union { uint64_t aligned; uint8_t byte[ROOM]; } block;
static tp_pool *const pool = (tp_pool *)(void *)&block;

TRACE_MARK(count_as_pool)
TRACE_MARK(count_end)
TRACE_MARK(count_section)

static void ruffle(int32_t high)
{
    for (uint32_t z = 0; z < pool->rows; z++)
        for (uint32_t x = 0; x < pool->cols; x++) {
            const tp_q30 wave = tp_cos(x << 27) / 4 + tp_cos(z << 26) / 4
                              + tp_cos((x + z) << 25) / 4;
            tp_pool_add_cell_height(pool, x, z, tp_q30_mul(high, wave));
        }
    tp_pool_start_carry_rounding(pool, high);
}

static bool prepare(const pool_point *point, tp_edges edges)
{
    const tp_pool_config config = {
        .cols = point->cols, .rows = point->rows, .cells = point->cells, .edges = edges,
        .courant = point->courant, .damping = point->damping, .sponge = 8,
        .range = TP_FX(1), .cell = TP_FX(0.25),
    };
    const size_t bytes = tp_pool_bytes(&config);

    if (bytes == 0 || bytes > sizeof block || tp_pool_init(pool, &config, NULL))
        return false;
    ruffle(point->cells == TP_CELLS_8 ? 100 : point->cells == TP_CELLS_16 ? 25000
                                                                          : 1 << 23);
    for (int n = 0; n < TICKS; n++)
        tp_pool_step(pool);
    return true;
}

static __attribute__((noinline)) void run_steps(void)
{
    for (int n = 0; n < TICKS; n++)
        tp_pool_step(pool);
}

static bool count(const pool_point *point, tp_edges edges, const char *edge)
{
    if (!prepare(point, edges))
        return false;
    count_as_pool();
    run_steps();
    count_end();
    count_section();
    say("pool ");
    say(point->keys);
    say_number(edge, TICKS * point->cols * point->rows);
    say("\n");
    return !pool->at_rest;
}

int main(void)
{
    for (const pool_point *point = pool_points; point->keys; point++)
        if (!count(point, TP_EDGES_WALL, " wall ")
            || !count(point, TP_EDGES_SPONGE, " sponge ")) {
            say("FAILED a pool that cannot be made, or rests\n");
            return 1;
        }
    return 0;
}
