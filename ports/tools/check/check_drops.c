/* SPDX-License-Identifier: MIT */
/* tidepool check: rings, falling and bouncing drops, and the clock; [A4]-[A6], [D1]-[D4]
 * and [D6]. */
#include <math.h>
#include "check.h"
#include "features/drops/drops.h"
#include "world/world.h"

#define TICKS   (TP_TICKS_PER_SECOND * 65536.0)     /* API time units a second */
#define Q24     16777216.0

/* PLACE: horizontal coordinate, m, any 16.16.  HEIGHT: m, up to 16 rings of 4 m. */
#define PLACE(n)  { .name = n, .low = -32767, .high = 32767 }
#define HEIGHT(n) { .name = n, .low = -64, .high = 64 }

/* -- rings --------------------------------------------------------------------------- */

static const check_field ring_columns[] = {
    PLACE("x"), PLACE("z"), CHECK_TIME("t"), HEIGHT("y"), CHECK_ANY("dydx"),
    CHECK_ANY("dydz"), CHECK_UNIT("nx"), CHECK_UNIT("ny"), CHECK_UNIT("nz"),
    CHECK_UNIT("n4x"), CHECK_UNIT("n4y"), CHECK_UNIT("n4z"),
};

/* Ranges from A on are the ranges of tp_ring. */
static const check_field ring_numbers[] = {
    { .name = "ring", .high = CHECK_LINES - 1, .kind = CHECK_WHOLE },
    PLACE("cx"), PLACE("cz"), CHECK_TIME("t0"), { .name = "A", .high = 4 },
    { .name = "L", .low = 0.02, .high = 64 }, { .name = "c", .low = 0.01, .high = 64 },
    { .name = "tau", .low = 0.05, .high = 1000 },
    { .name = "p0", .low = 0.01, .high = 1000 }, { .name = "tr", .high = 8 },
};

static tp_ring make_ring(const double *p)
{
    return (tp_ring){ .x = check_fx(p[1]), .z = check_fx(p[2]),
                      .start = llround(p[3] * TICKS), .amplitude = check_fx(p[4]),
                      .length = check_fx(p[5]), .speed = check_fx(p[6]),
                      .decay = check_fx(p[7]), .spread = check_fx(p[8]),
                      .attack = check_fx(p[9]) };
}

static uint32_t evaluate_rings(const check_run *run, double t, tp_ring_now *now)
{
    uint32_t count = 0;
    for (unsigned i = 0; i < run->n_lines[0]; i++) {
        const tp_ring ring = make_ring(run->lines[0][i]);
        if (tp_ring_evaluate(&ring, llround(t * TICKS), &now[count]))
            count++;
    }
    return count;
}

static tp_dir3 five_normal(const tp_ring_now *now, uint32_t count, tp_fx x, tp_fx z)
{
    const tp_fx d = TP_FX(0.05);
    const tp_fx neighbours[4] = { tp_ring_height_slope(now, count, x - d, z).height,
                                  tp_ring_height_slope(now, count, x + d, z).height,
                                  tp_ring_height_slope(now, count, x, z - d).height,
                                  tp_ring_height_slope(now, count, x, z + d).height };
    return tp_neighbour_normal(neighbours, d);
}

/* Bounds of the errors explained by rounding at the point v[0], v[1] and the time v[2]:
 * height, m; slope, m/m.  aside: additional error of the point, m. */
typedef struct {
    double height, slope;
} ring_lost;

/* Returns the bound of one ring, 0 outside its band.  The phase changes with point, time, c
 * and L.  The height changes with A, tau, p0 and tr, by at most their relative errors. */
static ring_lost ring_error_bound(const double *p, const double *v, double aside)
{
    const double age = fmax(0, v[2] - p[3]), a = p[4], l = p[5], c = p[6];
    const double off = aside + hypot(check_rounding(v[0]), check_rounding(v[1]))
                     + hypot(check_rounding(p[1]), check_rounding(p[2]))
                     + age * check_rounding(c) + c / TICKS + check_rounding(l);
    const double phase = 2 * CHECK_PI / l * off;
    const double ahead = hypot(v[0] - p[1], v[1] - p[2]) - l / 2 - c * age;
    const double share = check_share(a) + check_share(p[7]) + check_share(p[8])
                       + check_share(p[9]) + (age < p[9] ? 1.5 / TICKS / p[9] : 0);
    if (v[2] + 1 / TICKS < p[3] || fabs(ahead) > l / 2 + off)
        return (ring_lost){ 0, 0 };
    const double steepest = a * (CHECK_PI / l + 1 / p[8]);
    return (ring_lost){ a * (phase / 2 + share),
                        steepest * (phase + share + check_share(l)) };
}

static ring_lost rings_lost(const check_run *run, const double *v, double aside)
{
    ring_lost sum = { 0, 0 };
    for (unsigned i = 0; i < run->n_lines[0]; i++) {
        const ring_lost one = ring_error_bound(run->lines[0][i], v, aside);
        sum.height += one.height;
        sum.slope += one.slope;
    }
    return sum;
}

/* Compares normals.  A normal turns by at most the change of its slope. */
static void compare_normal(check_run *run, unsigned quantity, unsigned row, tp_dir3 got,
                           const double *want, double slope_lost)
{
    check_add(run, quantity, row, check_excess(check_angle(got, want),
                                               slope_lost * (180 / CHECK_PI)));
}

/* Compares one row.  Slopes are clamped at 7.99: such a row has no normal to compare. */
static void each_ring_row(check_run *run, unsigned row, const double *v)
{
    tp_ring_now now[CHECK_LINES];
    const uint32_t count = evaluate_rings(run, v[2], now);
    const tp_fx x = check_fx(v[0]), z = check_fx(v[1]);
    const tp_height_slope at = tp_ring_height_slope(now, count, x, z);
    const ring_lost lost = rings_lost(run, v, 0);
    check_add(run, 0, row, check_excess(1000 * (check_metres(at.height) - v[3]),
                                        1000 * lost.height));
    if (hypot(v[4], v[5]) < 7.99)
        compare_normal(run, 1, row, tp_normalise(-at.slope_x, TP_FX_ONE, -at.slope_z),
                       v + 6, lost.slope);
    compare_normal(run, 2, row, five_normal(now, count, x, z), v + 9,
                   rings_lost(run, v, check_rounding(0.05)).slope);
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

/* -- drops --------------------------------------------------------------------------- */

enum { CASE, Y0, E, EFF, B, T, M, RAD, V, LOST, LENGTH, A0 };

/* Ranges: release height 0.01..100 m, the range of a scene's sphere; drops as in a scene,
 * but with a wider range of e; 7 impacts, each halves the mass.  Radii and masses are taken
 * at the impact: at the last impact 1/4 and 1/64 of the first.  Densities are 100..10000
 * kg/m^3.  Hence v = sqrt(2 g y0), E_lost below m g y0, L = 8 rad, and A0 of [D4], at most
 * 7.44 m. */
static const check_field bounce_columns[] = {
    { .name = "case", .high = 1e6, .kind = CHECK_WHOLE },
    { .name = "y0", .low = 0.01, .high = 100 }, { .name = "e", .low = 0.1, .high = 0.9 },
    { .name = "eff", .low = 1 / 65536.0, .high = CHECK_ONE },
    { .name = "b", .high = 6, .kind = CHECK_WHOLE }, CHECK_TIME("t"),
    { .name = "m", .low = 5e-8, .high = 41900 },
    { .name = "rad", .low = 0.0005 / CHECK_ONE, .high = CHECK_ONE },
    { .name = "v", .high = 44.3 }, { .name = "E_lost", .high = 4.2e7 },
    { .name = "L", .low = 0.004 / CHECK_ONE, .high = 8 * CHECK_ONE },
    { .name = "A0", .low = 6e-13, .high = 7.5 },
};

static double drop_density(const double *v)
{
    return v[M] / (4 * CHECK_PI / 3 * v[RAD] * v[RAD] * v[RAD]);
}

static tp_scene_drops make_drops_config(const double *v)
{
    return (tp_scene_drops){ .count = 1, .radius = check_fx(v[RAD]),
                             .density = check_fx(drop_density(v)),
                             .bounce = check_fx(v[E]), .impacts = 7,
                             .efficiency = check_fx(v[EFF]) };
}

/* Refuses a drop with an impossible radius or density at its release. */
static int refuse_drop(const check_run *run, unsigned row)
{
    const double *v = check_row(run, row), density = drop_density(v);
    if (v[RAD] * CHECK_ONE < 0.002)
        return check_refuse(run, row, "rad = %.9g at the first impact is below 0.002",
                            v[RAD]);
    if (density * CHECK_ONE < 100 || density > 10000 * CHECK_ONE)
        return check_refuse(run, row, "m / (4/3 pi rad^3) = %.9g is outside 100..10000",
                            density);
    return EXIT_DONE;
}

/* Steps to the next impact; *tick counts ticks.  False: no impact within an hour. */
static bool next_impact(tp_drop *drop, const tp_scene_drops *config, uint64_t *tick,
                        tp_impact *impact)
{
    for (uint64_t end = *tick + 3600 * TP_TICKS_PER_SECOND; *tick < end;)
        if (tp_drop_step(drop, config, TP_FX(9.81), 0, ++*tick, impact))
            return true;
    return false;
}

/* Compares an impact, beyond relative errors by rounding.  The radius is rounded again at
 * each bounce.  A0 grows with the square root of the radius, of y0 and of eff, and with
 * e^b, and is stored in Q24.  At most one impact happens per tick: `late` = number of
 * delayed impacts. */
static void compare_impact(check_run *run, unsigned row, const tp_impact *impact,
                           unsigned late)
{
    const double *v = check_row(run, row), b = v[B];
    const double radius = (b + 1) * CHECK_HALF / v[RAD];
    const double height = (radius + check_share(v[Y0]) + check_share(v[EFF])) / 2
                        + (b + 1) * check_share(v[E]) + 0.5 / Q24 / v[A0];
    check_add(run, 0, row, check_excess((double)impact->time / TICKS - v[T],
                                        (double)late / TP_TICKS_PER_SECOND));
    check_add(run, 1, row, check_excess(check_percent(impact->uncapped_q24 / Q24, v[A0]),
                                        100 * height));
    check_add(run, 2, row, check_excess(check_percent(check_metres(impact->length),
                                                      v[LENGTH]), 100 * radius));
}

/* Compares the impacts of one drop, released at time 0.  *row: the row after the last. */
static int run_drop(check_run *run, unsigned *row)
{
    const double *first = check_row(run, *row);
    const tp_scene_drops config = make_drops_config(first);
    tp_drop drop = { .place = { 0, check_fx(first[Y0]), 0 }, .radius = config.radius,
                     .high_q32 = (int64_t)check_fx(first[Y0]) * 65536,
                     .level = TP_DROP_NEW };
    uint64_t tick = 0;
    unsigned late = 0;
    for (unsigned b = 0; *row < run->table.n_rows; b++, ++*row) {
        const double *v = check_row(run, *row);
        tp_impact impact;
        if (v[CASE] != first[CASE])
            return EXIT_DONE;
        if (v[B] != b)
            return check_refuse(run, *row, "impact %g; expected %u", v[B], b);
        if (!next_impact(&drop, &config, &tick, &impact))
            return check_refuse(run, *row, "the drop does not come down again");
        late += b > 0 && 2 * v[V] / 9.81 * TP_TICKS_PER_SECOND < 1;
        compare_impact(run, *row, &impact, late);
    }
    return EXIT_DONE;
}

static int run_drop_bounce(check_run *run)
{
    int code = EXIT_DONE;
    for (unsigned row = 0; !code && row < run->table.n_rows;) {
        code = refuse_drop(run, row);
        if (!code)
            code = run_drop(run, &row);
    }
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

/* -- the clock ----------------------------------------------------------------------- */

static const check_field clock_columns[] = {
    { .name = "frame", .high = 1e9, .kind = CHECK_WHOLE },
    { .name = "target", .low = 0.125, .high = 4 },
    { .name = "scale", .high = 4 * CHECK_ONE },
    { .name = "acc", .high = CHECK_ONE }, { .name = "n", .high = 5, .kind = CHECK_WHOLE },
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
        tp_clock_set_target(&clock, check_fx(v[1]));
        tp_clock_advance(&clock);
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
