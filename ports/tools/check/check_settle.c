/* SPDX-License-Identifier: MIT */
/* tidepool check: the number of steps until a pool with two gears is at rest, [C8]-[C13].
 *
 * The table's header gives the droplet's kind, width and height, but not its position in
 * the tank nor its rounding to integers.  T_A depends on the height alone and is exact.
 * The step of rest is not exact: moving the droplet by a fraction of a cell changes the
 * step by up to 6 %, and by up to 17 % where r < 1/4, because the weak kick lingers at the
 * dead zone [C14].  These errors are allowed; the droplet here is the core's splash in the
 * middle of the tank.  Columns that compare with a run in double precision are not
 * checked. */
#include <stdlib.h>
#include "check.h"
#include "check_pool.h"

enum { N, BITS, DELTA, COURANT, TA, SETTLE };

enum { REFUSED, GEAR_A, REST, REST_WEAK, LEFT };    /* indices of quantities */

enum { STEPS_MOST = 100000 };

#define WEAK 0.2499             /* below: r < 1/4; the table has four decimals */

#define ERROR(n) { .name = n, .low = -1, .high = 1e9 }

static const check_field settle_columns[] = {
    { .name = "N", .low = 16, .high = 512, .kind = CHECK_WHOLE },
    { .name = "bits", .kind = CHECK_WORD, .words = "8|16" },
    { .name = "delta_log2", .low = 4, .high = 10, .kind = CHECK_WHOLE },
    { .name = "courant", .low = 0.05, .high = 0.8 },
    { .name = "TA", .high = STEPS_MOST, .kind = CHECK_WHOLE },
    { .name = "settle", .low = -1, .high = STEPS_MOST, .kind = CHECK_WHOLE },
    ERROR("maxmean_lsb"), ERROR("faithful_steps"), ERROR("e50"), ERROR("e100"),
    ERROR("e200"), ERROR("e400"),
};

/* True if the pool may flicker, [C9]. */
static bool may_flicker(const double *v)
{
    const double delta = 1.0 / (1 << (int)v[DELTA]);
    return v[COURANT] * v[COURANT] > (1 - 1 / (2 - delta)) / 2;
}

static unsigned steps_to_rest(tp_pool *pool)
{
    unsigned steps = 0;
    for (; steps < STEPS_MOST && !pool->at_rest; steps++)
        tp_pool_step(pool);
    return steps;
}

static void settle(check_run *run, unsigned row, tp_pool *pool)
{
    const double *v = check_row(run, row);
    const bool small = pool->cells == TP_CELLS_8;
    tp_pool_add_splash(pool, 0, 0, 4 * pool->cell,
                       small ? TP_FX(100 / 127.0) : TP_FX(25600 / 32767.0));
    check_add(run, GEAR_A, row, pool->gear - v[TA]);
    const double off = steps_to_rest(pool) - v[SETTLE];
    const tp_pool_state left = tp_pool_stats(pool);
    check_add(run, v[COURANT] < WEAK ? REST_WEAK : REST, row, 100 * off / v[SETTLE]);
    check_add(run, LEFT, row, left.highest + left.fastest);
}

static int run_automaton_settle_table(check_run *run)
{
    for (unsigned row = 0; row < run->table.n_rows; row++) {
        const double *v = check_row(run, row);
        const check_pool_shape shape = {
            .cells = v[BITS] > 0 ? TP_CELLS_16 : TP_CELLS_8, .cols = (uint32_t)v[N],
            .rows = (uint32_t)v[N], .courant = check_fx(v[COURANT]),
            .damping = (uint32_t)v[DELTA],
        };
        tp_pool *pool = check_pool_make(&shape);
        check_progress(run, row);
        check_add(run, REFUSED, row, (pool == NULL) != may_flicker(v));
        if (pool && v[SETTLE] > 0)
            settle(run, row, pool);
        free(pool);
    }
    return EXIT_DONE;
}

const check_model check_automaton_settle_table = {
    CHECK_ALL(settle_columns),
    .notes = { { .text = "two-gear rule, droplet (zero-sum Mexican hat, sigma 4 cells,"
                         " amplitude 100 (8 bit) or 25600 LSB (16 bit)), reflecting"
                         " tank NxN" },
               { .text = "settle: step at which H==0 and V==0 exactly (-1: not within"
                         " the run), TA: gear A duration; maxmean: max |mean H| in LSB;"
                         " faithful: last step with normalised rms error < 0.5 (max"
                         " 1000); eNN: normalised rms error vs double at step NN (-1:"
                         " already at rest)" } },
    .quantities = { [REFUSED] = { "refused", "", 0 }, [GEAR_A] = { "T_A", "steps", 0 },
                    [REST] = { "steps to rest", "%", 6 },
                    [REST_WEAK] = { "rest, r < 1/4", "%", 17 },
                    [LEFT] = { "left at rest", "LSB", 0 } },
    .run = run_automaton_settle_table,
};
