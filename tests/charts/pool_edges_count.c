/* SPDX-License-Identifier: MIT */
/* Steps pools with each kind of edge and each kind of cell between the marks of
 * pool-edges.sh, and prints a line for each:
 *
 *     pool BITS edge|mask|sponge|tile|drive|splash CELLS
 *
 * drive: a tiled field whose drive looks at the level and adds nothing; splash: adds one in
 * each tick. Freestanding if the compiler is in freestanding mode. */
#include "cortex-m/trace_marks.h"
#include "pool/pool.h"
#include "tests/lib/board_output.h"
#include "tidepool/tidepool.h"

enum { TICKS = 2, SIDE = 64, ROOM = 64 << 10 };

static union { uint64_t aligned; uint8_t byte[ROOM]; } block;
static tp_pool *const pool = (tp_pool *)(void *)&block;
static uint16_t dark[SIDE * SIDE];

TRACE_MARK(count_as_pool)
TRACE_MARK(count_end)
TRACE_MARK(count_section)

typedef struct {
    const char *name;           /* with the blanks around it */
    tp_edges edges;
    bool     masked;
    tp_fx    drive;
} edge_kind;

static void ruffle(int32_t high)
{
    for (uint32_t i = 0; i < SIDE * SIDE; i++) {
        const uint32_t x = i % SIDE, z = i / SIDE;
        const tp_q30 wave = tp_cos(x << 27) / 4 + tp_cos(z << 26) / 4
                          + tp_cos((x + z) << 25) / 4;
        tp_pool_add_cell_height(pool, x, z, tp_q30_mul(high, wave));
    }
    tp_pool_start_carry_rounding(pool, high);
}

static bool prepare(const edge_kind *kind, tp_cells cells)
{
    static const tp_grey mask = { .cols = SIDE, .rows = SIDE, .sample = dark };
    const tp_pool_config config = {
        .cols = SIDE, .rows = SIDE, .cells = cells, .edges = kind->edges,
        .courant = TP_FX(0.484), .damping = 6, .sponge = 8, .range = TP_FX(1),
        .cell = TP_FX(0.25), .drive_min = kind->drive, .drive_max = kind->drive,
        .drive_amplitude = TP_FX(0.01), .mask = kind->masked ? &mask : NULL,
    };
    const size_t bytes = tp_pool_bytes(&config);

    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        dark[i] = i % SIDE == 0 || i % SIDE == SIDE - 1 || i / SIDE == 0
               || i / SIDE == SIDE - 1 ? 0 : 0xffff;
    if (bytes == 0 || bytes > sizeof block || tp_pool_init(pool, &config, NULL))
        return false;
    ruffle(cells == TP_CELLS_8 ? 100 : cells == TP_CELLS_16 ? 25000 : 1 << 23);
    for (int n = 0; n < TICKS; n++)
        tp_pool_step(pool);
    return true;
}

static __attribute__((noinline)) void run_steps(void)
{
    for (int n = 0; n < TICKS; n++)
        tp_pool_step(pool);
}

static bool count(const edge_kind *kind, tp_cells cells)
{
    if (!prepare(kind, cells))
        return false;
    const uint32_t before = pool->injections;
    count_as_pool();
    run_steps();
    count_end();
    count_section();
    say_number("pool ", 8u << cells);
    say_number(kind->name, TICKS * SIDE * SIDE);
    say("\n");
    return !pool->at_rest
        && pool->injections - before == (kind->drive == TP_FX(1) ? TICKS : 0u);
}

int main(void)
{
    static const edge_kind kinds[] = {
        { " edge ", TP_EDGES_WALL, false, 0 }, { " mask ", TP_EDGES_WALL, true, 0 },
        { " sponge ", TP_EDGES_SPONGE, false, 0 }, { " tile ", TP_EDGES_TILE, false, 0 },
        { " drive ", TP_EDGES_TILE, false, TP_FX(0.001) },
        { " splash ", TP_EDGES_TILE, false, TP_FX(1) },
    };

    for (int cells = TP_CELLS_8; cells <= TP_CELLS_32; cells++)
        for (int n = 0; n < 6; n++)
            if (!count(&kinds[n], (tp_cells)cells)) {
                say("FAILED a pool that cannot be made, rests, or is fed wrongly\n");
                return 1;
            }
    return 0;
}
