/* SPDX-License-Identifier: MIT */
/* tidepool check: sines and the sums of swells, [A1]-[A3], [A7]-[A10] and [E1].
 *
 * A wave of the table becomes a tp_wave, and the sea is made of those by the core.  Times
 * of the tables lie between ticks, so that the phase -omega t + phase is formed here. */
#include <math.h>
#include "check.h"
#include "tidepool/wave.h"

#define GRAVITY TP_FX(9.81)

#define METRES(n)  { .name = n, .low = -8000, .high = 8000 }
#define SECONDS(n) { .name = n, .high = 1e6 }
#define UNIT(n)    { .name = n, .low = -1, .high = 1 }
#define ANY(n)     { .name = n, .low = -1e9, .high = 1e9 }

/* -- sine -------------------------------------------------------------------------- */

static const check_field sine_columns[] = {
    { .name = "phase_u32", .high = 4294967295.0, .kind = CHECK_WHOLE },
    UNIT("sin"), UNIT("cos"),
    { .name = "sin_q16", .low = -65536, .high = 65536, .kind = CHECK_WHOLE },
    { .name = "cos_q16", .low = -65536, .high = 65536, .kind = CHECK_WHOLE },
};

static void each_sine(check_run *run, unsigned row, const double *v)
{
    const tp_turn angle = (tp_turn)v[0];
    check_add(run, 0, row, (double)tp_sin(angle) / TP_Q30_ONE - v[1]);
    check_add(run, 1, row, (double)tp_cos(angle) / TP_Q30_ONE - v[2]);
    check_add(run, 2, row, tp_fx_sin(angle) - v[3]);
    check_add(run, 3, row, tp_fx_cos(angle) - v[4]);
}

const check_model check_sine = {
    CHECK_ALL(sine_columns),
    .notes = { { .text = "[G1] phase_u32: unsigned 32-bit turns (2^32 = 2 pi)."
                         " sin_q16/cos_q16: nearest 16.16" } },
    .quantities = { { "sine", "", 1.6e-5 }, { "cosine", "", 1.6e-5 },
                    { "sine 16.16", "LSB", 1 }, { "cosine 16.16", "LSB", 1 } },
    .each = each_sine,
};

/* -- a sea from a table's parameter lines ------------------------------------------ */

#define WAVE_TEXT "wave %: L=% k=% omega=% Dx=% Dz=% phase=% A=% Q=%" \
                  " (m, rad/m, rad/s, 1, 1, rad, m, 1)"

enum { WAVE, LENGTH, NUMBER, OMEGA, DX, DZ, PHASE, AMPLITUDE, SHARPNESS };

static const check_field wave_numbers[] = {
    { .name = "wave", .high = CHECK_LINES - 1, .kind = CHECK_WHOLE },
    { .name = "L", .low = 0.25, .high = 2000 }, { .name = "k", .high = 26 },
    { .name = "omega", .high = 1000 }, UNIT("Dx"), UNIT("Dz"), ANY("phase"),
    { .name = "A", .low = 0.0001, .high = 16 }, { .name = "Q", .high = 1 },
};

static tp_wave wave_of(const double *p, bool sharp)
{
    return (tp_wave){
        .amplitude = check_fx(p[AMPLITUDE]),
        .length = check_fx(p[LENGTH]),
        .steepness = check_fx(fmin(1, sharp * p[SHARPNESS] * p[NUMBER] * p[AMPLITUDE])),
        .heading = check_fx(atan2(p[DX], -p[DZ]) * (180 / CHECK_PI)),
        .speed = TP_FX_ONE,
        .power = 1,
    };
}

static void sea_of(const check_run *run, unsigned note, bool sharp, tp_sea *sea)
{
    tp_wave waves[CHECK_LINES];
    for (unsigned i = 0; i < run->n_lines[note]; i++)
        waves[i] = wave_of(run->lines[note][i], sharp);
    tp_sea_init(sea, waves, run->n_lines[note], GRAVITY);
}

static void phases_at(const check_run *run, unsigned note, double t,
                      tp_turn phases[TP_WAVES])
{
    for (unsigned i = 0; i < TP_WAVES; i++) {
        const double *p = run->lines[note][i];
        phases[i] = i < run->n_lines[note] ? check_turn(p[PHASE] - p[OMEGA] * t) : 0;
    }
}

/* The point of rest place v[0], v[1]. */
static tp_sea_point at_rest(const tp_sea *sea, const tp_turn phases[TP_WAVES],
                            const double *v)
{
    return tp_sea_at_rest(sea, phases, check_fx(v[0]), check_fx(v[1]));
}

static double normal_error(const tp_sea_point *p, const double want[3])
{
    return check_angle(tp_normalise(-p->slope_x, TP_FX_ONE, -p->slope_z), want);
}

static double place_error(const tp_sea_point *p, double x, double y, double z)
{
    return 1000 * fmax(fabs(check_metres(p->position.x) - x),
                       fmax(fabs(check_metres(p->position.y) - y),
                            fabs(check_metres(p->position.z) - z)));
}

/* -- sum of sines ------------------------------------------------------------------ */

static const check_field sum_columns[] = {
    METRES("x"), METRES("z"), SECONDS("t"), METRES("y"), ANY("dydx"), ANY("dydz"),
    UNIT("nx"), UNIT("ny"), UNIT("nz"),
};

static int run_sum_of_sines(check_run *run)
{
    tp_sea sea;
    sea_of(run, 0, false, &sea);
    for (unsigned row = 0; row < run->table.n_rows; row++) {
        const double *v = check_row(run, row);
        tp_turn phases[TP_WAVES];
        phases_at(run, 0, v[2], phases);
        const tp_sea_point p = at_rest(&sea, phases, v);
        check_add(run, 0, row, 1000 * (check_metres(p.position.y) - v[3]));
        check_add(run, 1, row, normal_error(&p, v + 6));
    }
    return EXIT_DONE;
}

const check_model check_sum_of_sines = {
    CHECK_ALL(sum_columns),
    .notes = { { WAVE_TEXT, CHECK_ALL(wave_numbers), true },
               { .text = "[A1][A2] y=sum A sin(k D.p - omega t + phase); Q unused" },
               { .text = "units m,s" } },
    .quantities = { { "height", "mm", 0.25 }, { "normal", "deg", 0.02 } },
    .run = run_sum_of_sines,
};

/* -- sharpened sine ---------------------------------------------------------------- */

static const check_field sharp_columns[] = {
    { .name = "k", .low = 1, .high = 8, .kind = CHECK_WHOLE },
    { .name = "A", .low = 0.0001, .high = 1.8 }, ANY("theta"), ANY("f"), ANY("mean"),
    METRES("y"), ANY("dy_dtheta"),
};

/* One wave of 2 pi metres, so that dy/dx is dy/dtheta, at the origin. */
static void each_sharp(check_run *run, unsigned row, const double *v)
{
    const tp_wave wave = { .amplitude = check_fx(v[1]), .length = check_fx(2 * CHECK_PI),
                           .heading = TP_FX(90), .speed = TP_FX_ONE,
                           .power = (int32_t)v[0] };
    const tp_turn phases[TP_WAVES] = { check_turn(v[2]) };
    const double length = sqrt(1 + v[6] * v[6]);
    const double normal[3] = { -v[6] / length, 1 / length, 0 };
    tp_sea sea;
    tp_sea_init(&sea, &wave, 1, GRAVITY);
    const tp_sea_point p = tp_sea_at_rest(&sea, phases, 0, 0);
    check_add(run, 0, row, 1000 * (check_metres(p.position.y) - v[5]));
    check_add(run, 1, row, normal_error(&p, normal));
}

const check_model check_sharp_sine = {
    CHECK_ALL(sharp_columns),
    .notes = { { .text = "[A3] f=2((sin th+1)/2)^k; mean=2 C(2k,k)/4^k; y=A(f-mean);"
                         " dy_dtheta=A k b^(k-1) cos th" } },
    .quantities = { { "height", "mm", 0.5 }, { "normal", "deg", 0.02 } },
    .each = each_sharp,
};

/* -- Gerstner ---------------------------------------------------------------------- */

static const check_field single_columns[] = {
    { .name = "L", .low = 0.25, .high = 105 },      /* S/k stays below 16 m */
    { .name = "S", .high = 0.95 },
    UNIT("Dx"), UNIT("Dz"), METRES("x0"), METRES("z0"), SECONDS("t"),
    METRES("px"), METRES("py"), METRES("pz"), UNIT("nx"), UNIT("ny"), UNIT("nz"),
    ANY("det"),
};

/* Q = 1 and A = S/k: the steepness Q k A is S. */
static void each_single(check_run *run, unsigned row, const double *v)
{
    const double k = 2 * CHECK_PI / v[0];
    const tp_wave wave = { .amplitude = check_fx(v[1] / k), .length = check_fx(v[0]),
                           .steepness = check_fx(v[1]),
                           .heading = check_fx(atan2(v[2], -v[3]) * (180 / CHECK_PI)),
                           .speed = TP_FX_ONE, .power = 1 };
    const tp_turn phases[TP_WAVES] = { check_turn(-sqrt(9.81 * k) * v[6]) };
    tp_sea sea;
    tp_sea_init(&sea, &wave, 1, GRAVITY);
    const tp_sea_point p = at_rest(&sea, phases, v + 4);
    check_add(run, 0, row, place_error(&p, v[7], v[8], v[9]));
    check_add(run, 1, row, normal_error(&p, v + 10));
}

const check_model check_gerstner_single = {
    CHECK_ALL(single_columns),
    .notes = { { .text = "[A7][A8] one wave, Q=1, A=S/k, omega=sqrt(g k), g=9.81, phase"
                         " 0; det=horizontal Jacobian" } },
    .quantities = { { "position", "mm", 0.25 }, { "normal", "deg", 0.02 } },
    .each = each_single,
};

static const check_field gerstner_columns[] = {
    METRES("x0"), METRES("z0"), SECONDS("t"), METRES("px"), METRES("py"), METRES("pz"),
    UNIT("nx"), UNIT("ny"), UNIT("nz"), ANY("tx"), ANY("ty"), ANY("tz"),
    ANY("bx"), ANY("by"), ANY("bz"), ANY("det"),
};

static const check_field steepness_sum[] = { { .name = "sum Q k A", .high = 0.95 } };

static int run_gerstner_sum(check_run *run)
{
    tp_sea sea;
    sea_of(run, 0, true, &sea);
    for (unsigned row = 0; row < run->table.n_rows; row++) {
        const double *v = check_row(run, row);
        tp_turn phases[TP_WAVES];
        phases_at(run, 0, v[2], phases);
        const tp_sea_point p = at_rest(&sea, phases, v);
        check_add(run, 0, row, place_error(&p, v[3], v[4], v[5]));
        check_add(run, 1, row, normal_error(&p, v + 6));
    }
    return EXIT_DONE;
}

const check_model check_gerstner_sum = {
    CHECK_ALL(gerstner_columns),
    .notes = { { WAVE_TEXT, CHECK_ALL(wave_numbers), true },
               { "[A9][A10] exact (non-linearised) normal; sum Q k A = %",
                 CHECK_ALL(steepness_sum), false } },
    .quantities = { { "position", "mm", 0.25 }, { "normal", "deg", 0.02 } },
    .run = run_gerstner_sum,
};

/* -- above a place ----------------------------------------------------------------- */

enum { STEPS = 5, FIRST_STEP = 6 };

static const check_field buoyancy_columns[] = {
    METRES("x"), METRES("z"), SECONDS("t"), METRES("x0"), METRES("z0"), METRES("y"),
    METRES("y_it0"), METRES("y_it1"), METRES("y_it2"), METRES("y_it3"), METRES("y_it4"),
    UNIT("nx"), UNIT("ny"), UNIT("nz"),
};

/* A step is compared with the same step of the table, not with what it converges to; the
 * root's place, height and normal are those of a point at rest. */
static int run_buoyancy(check_run *run)
{
    tp_sea sea;
    sea_of(run, 0, true, &sea);
    for (unsigned row = 0; row < run->table.n_rows; row++) {
        const double *v = check_row(run, row);
        const tp_fx x = check_fx(v[0]), z = check_fx(v[1]);
        tp_turn phases[TP_WAVES];
        phases_at(run, 0, v[2], phases);
        for (unsigned n = 0; n < STEPS; n++) {
            const tp_sea_point p = tp_sea_iterate(&sea, phases, x, z, n);
            const double off = check_metres(p.position.y) - v[FIRST_STEP + n];
            check_add(run, n, row, 1000 * off);
        }
        const tp_sea_point p = at_rest(&sea, phases, v + 3);
        check_add(run, STEPS, row, place_error(&p, v[0], v[5], v[1]));
        check_add(run, STEPS + 1, row, normal_error(&p, v + 11));
    }
    return EXIT_DONE;
}

const check_model check_buoyancy = {
    CHECK_ALL(buoyancy_columns),
    .notes = { { WAVE_TEXT, CHECK_ALL(wave_numbers), true },
               { "[E1] surface height above fixed (x,z); x0,z0 the rest point; y_it0.."
                 " heights from the n-th fixed-point iterate; sum QkA=%",
                 CHECK_ALL(steepness_sum), false } },
    .quantities = { { "step 0", "mm", 1 }, { "step 1", "mm", 1 }, { "step 2", "mm", 1 },
                    { "step 3", "mm", 1 }, { "step 4", "mm", 1 },
                    { "root", "mm", 0.25 }, { "root normal", "deg", 0.02 } },
    .run = run_buoyancy,
};
