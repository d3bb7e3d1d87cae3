/* SPDX-License-Identifier: MIT */
/* tidepool check: rings, drops that fall and bounce, and the clock; [A4]-[A6], [D1]-[D4]
 * and [D6]. */
#include <math.h>
#include "check.h"
#include "tidepool/clock.h"
#include "tidepool/drop.h"
#include "tidepool/ring.h"
#include "tidepool/wave.h"

#define TICKS   (TP_TICKS_PER_SECOND * 65536.0)     /* the API's times, a second */
#define Q24     16777216.0

#define METRES(n)  { .name = n, .low = -1000, .high = 1000 }
#define SECONDS(n) { .name = n, .high = 1e5 }
#define UNIT(n)    { .name = n, .low = -1, .high = 1 }
#define ANY(n)     { .name = n, .low = -1e9, .high = 1e9 }

/* -- rings ------------------------------------------------------------------------- */

static const check_field ring_columns[] = {
    METRES("x"), METRES("z"), SECONDS("t"), METRES("y"), ANY("dydx"), ANY("dydz"),
    UNIT("nx"), UNIT("ny"), UNIT("nz"), UNIT("n4x"), UNIT("n4y"), UNIT("n4z"),
};

static const check_field ring_numbers[] = {
    { .name = "ring", .high = CHECK_LINES - 1, .kind = CHECK_WHOLE },
    METRES("cx"), METRES("cz"), SECONDS("t0"), { .name = "A", .high = 4 },
    { .name = "L", .low = 0.02, .high = 64 }, { .name = "c", .low = 0.01, .high = 64 },
    { .name = "tau", .low = 0.05, .high = 1000 },
    { .name = "p0", .low = 0.01, .high = 1000 }, { .name = "tr", .high = 8 },
};

static tp_ring ring_of(const double *p)
{
    return (tp_ring){ .x = check_fx(p[1]), .z = check_fx(p[2]),
                      .start = llround(p[3] * TICKS), .amplitude = check_fx(p[4]),
                      .length = check_fx(p[5]), .speed = check_fx(p[6]),
                      .decay = check_fx(p[7]), .spread = check_fx(p[8]),
                      .attack = check_fx(p[9]) };
}

static uint32_t rings_at(const check_run *run, double t, tp_ring_now *now)
{
    uint32_t count = 0;
    for (unsigned i = 0; i < run->n_lines[0]; i++) {
        const tp_ring ring = ring_of(run->lines[0][i]);
        if (tp_ring_at(&ring, llround(t * TICKS), &now[count]))
            count++;
    }
    return count;
}

static tp_dir3 five_normal(const tp_ring_now *now, uint32_t count, tp_fx x, tp_fx z)
{
    const tp_fx d = TP_FX(0.05);
    const tp_fx around[4] = { tp_ring_relief(now, count, x - d, z).height,
                              tp_ring_relief(now, count, x + d, z).height,
                              tp_ring_relief(now, count, x, z - d).height,
                              tp_ring_relief(now, count, x, z + d).height };
    return tp_five_normal(around, d);
}

static void each_ring_row(check_run *run, unsigned row, const double *v)
{
    tp_ring_now now[CHECK_LINES];
    const uint32_t count = rings_at(run, v[2], now);
    const tp_fx x = check_fx(v[0]), z = check_fx(v[1]);
    const tp_relief at = tp_ring_relief(now, count, x, z);
    check_add(run, 0, row, 1000 * (check_metres(at.height) - v[3]));
    check_add(run, 1, row, check_angle(tp_normalise(-at.slope_x, TP_FX_ONE, -at.slope_z),
                                       v + 6));
    check_add(run, 2, row, check_angle(five_normal(now, count, x, z), v + 9));
}

const check_model check_droplet_waves = {
    CHECK_ALL(ring_columns),
    .notes = { { "ring %: cx=% cz=% t0=% A=% L=% c=% tau=% p0=% tr=%",
                 CHECK_ALL(ring_numbers), true },
               { .text = "[A4][A5][A6] sum of single-crest rings; n4*: 5-point"
                         " 4-triangle normal with spacing 0.05 m" } },
    .quantities = { { "height", "mm", 0.25 }, { "normal", "deg", 0.05 },
                    { "five heights", "deg", 0.05 } },
    .each = each_ring_row,
};

/* -- drops ------------------------------------------------------------------------- */

enum { CASE, Y0, E, EFF, B, T, M, RAD, V, LOST, LENGTH, A0 };

static const check_field bounce_columns[] = {
    { .name = "case", .high = 1e6, .kind = CHECK_WHOLE },
    { .name = "y0", .low = 0.01, .high = 100 }, { .name = "e", .low = 0.1, .high = 0.9 },
    { .name = "eff", .low = 0.001, .high = 1 },
    { .name = "b", .high = 30, .kind = CHECK_WHOLE }, SECONDS("t"),
    { .name = "m", .low = 1e-6, .high = 5000 },
    { .name = "rad", .low = 0.002, .high = 1 },
    { .name = "v", .high = 100 }, { .name = "E_lost", .high = 1e6 },
    { .name = "L", .low = 0.01, .high = 8 }, { .name = "A0", .low = 1e-5, .high = 10 },
};

static tp_scene_drops drops_of(const double *v)
{
    const double volume = 4 * CHECK_PI / 3 * v[RAD] * v[RAD] * v[RAD];
    return (tp_scene_drops){ .count = 1, .radius = check_fx(v[RAD]),
                             .density = check_fx(fmax(100, fmin(10000, v[M] / volume))),
                             .bounce = check_fx(v[E]), .impacts = 32,
                             .efficiency = check_fx(v[EFF]) };
}

/* Ticks until the next impact; false: none within an hour. */
static bool next_impact(tp_drop *drop, const tp_scene_drops *config, uint64_t *tick,
                        tp_impact *impact)
{
    for (uint64_t end = *tick + 3600 * TP_TICKS_PER_SECOND; *tick < end;)
        if (tp_drop_step(drop, config, TP_FX(9.81), 0, ++*tick, impact))
            return true;
    return false;
}

/* The impacts of one drop, let go when the clock starts; returns the row after. */
static int run_drop(check_run *run, unsigned *row)
{
    const double *first = check_row(run, *row);
    const tp_scene_drops config = drops_of(first);
    tp_drop drop = { .place = { 0, check_fx(first[Y0]), 0 }, .radius = config.radius,
                     .high_q32 = (int64_t)check_fx(first[Y0]) * 65536,
                     .level = TP_DROP_NEW };
    uint64_t tick = 0;
    for (unsigned b = 0; *row < run->table.n_rows; b++, ++*row) {
        const double *v = check_row(run, *row);
        tp_impact impact;
        if (v[CASE] != first[CASE])
            return EXIT_DONE;
        if (v[B] != b)
            return check_refuse(run, *row, "impact %g; expected %u", v[B], b);
        if (!next_impact(&drop, &config, &tick, &impact))
            return check_refuse(run, *row, "the drop does not come down again");
        check_add(run, 0, *row, (double)impact.time / TICKS - v[T]);
        check_add(run, 1, *row, check_percent(impact.uncapped_q24 / Q24, v[A0]));
        check_add(run, 2, *row, check_percent(check_metres(impact.length), v[LENGTH]));
    }
    return EXIT_DONE;
}

static int run_drop_bounce(check_run *run)
{
    int code = EXIT_DONE;
    for (unsigned row = 0; !code && row < run->table.n_rows;)
        code = run_drop(run, &row);
    return code;
}

const check_model check_drop_bounce = {
    CHECK_ALL(bounce_columns),
    .notes = { { .text = "[D1]-[D4] no drag; release height y0 above water; impact b at"
                         " time t with mass m radius rad speed v; E_lost J; ring width"
                         " L=8 rad; ring amplitude A0 m" } },
    .quantities = { { "time", "s", 1.0 / 60 }, { "amplitude", "%", 1 },
                    { "ring length", "%", 1 } },
    .run = run_drop_bounce,
};

/* -- the clock --------------------------------------------------------------------- */

static const check_field clock_columns[] = {
    { .name = "frame", .high = 1e9, .kind = CHECK_WHOLE },
    { .name = "target", .low = 0.125, .high = 4 }, { .name = "scale", .high = 4 },
    { .name = "acc", .high = 1 }, { .name = "n", .high = 5, .kind = CHECK_WHOLE },
    { .name = "total", .high = 1e9, .kind = CHECK_WHOLE },
};

static int run_time_scale(check_run *run)
{
    tp_clock clock;
    tp_clock_init(&clock, TP_FX_ONE);
    for (unsigned row = 0; row < run->table.n_rows; row++) {
        const double *v = check_row(run, row);
        if (v[0] != row)
            return check_refuse(run, row, "frame %g; expected %u", v[0], row);
        tp_clock_aim(&clock, check_fx(v[1]));
        tp_clock_next(&clock);
        check_add(run, 0, row, check_metres(tp_clock_scale(&clock)) - v[2]);
        check_add(run, 1, row, (double)tp_clock_ticks(&clock) - v[5]);
    }
    return EXIT_DONE;
}

const check_model check_time_scale = {
    CHECK_ALL(clock_columns),
    .notes = { { .text = "[D6] frame 1/60 s, tau=0.4 s; scale s approaches target"
                         " exponentially; acc in ticks; n fixed steps run this frame;"
                         " total" } },
    .quantities = { { "scale", "", 0.001 }, { "ticks in all", "", 1 } },
    .run = run_time_scale,
};
