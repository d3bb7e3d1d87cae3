/* SPDX-License-Identifier: MIT */
/* tidepool check: sines and sums of swells, [A1]-[A3], [A7]-[A10] and [E1].
 *
 * Times in the tables lie between ticks: the phase -omega t + phase is computed here.
 * Points are compared within the bounds of check_sea.h, which grow with amplitude,
 * steepness and the distance from the origin.  A table may contain every wave and point
 * that the core accepts. */
#include <math.h>
#include "check_sea.h"

/* Ranges, m.  PLACE: rest position, 30 km each way as in deep_water.h.  POINT: displaced
 * position, at most 303 m farther (q / k).  HEIGHT: 16 waves of 16 m with crests up to
 * twice as high. */
#define PLACE(n)  { .name = n, .low = -30000, .high = 30000 }
#define POINT(n)  { .name = n, .low = -30303, .high = 30303 }
#define HEIGHT(n) { .name = n, .low = -512, .high = 512 }

/* LENGTH: range of tp_wave, m.  LEAST: least positive 16.16, m. */
#define LENGTH    { .name = "L", .low = 0.25, .high = 2000 }
#define LEAST     (1 / 65536.0)

/* -- sine ---------------------------------------------------------------------------- */

static const check_field sine_columns[] = {
    { .name = "phase_u32", .high = 4294967295.0, .kind = CHECK_WHOLE },
    CHECK_UNIT("sin"), CHECK_UNIT("cos"),
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

/* -- a sea from a table's parameter lines -------------------------------------------- */

#define WAVE_TEXT "wave %: L=% k=% omega=% Dx=% Dz=% phase=% A=% Q=%" \
                  " (m, rad/m, rad/s, 1, 1, rad, m, 1)"

enum { WAVE, WAVE_LENGTH, NUMBER, OMEGA, DX, DZ, PHASE, AMPLITUDE, SHARPNESS };

/* k and omega follow from L, omega for a tp_wave's speed of 0..8 and a gravity up to 100
 * m/s^2.  Q has no bound of its own: read_waves bounds Q k A. */
static const check_field wave_numbers[] = {
    { .name = "wave", .high = CHECK_LINES - 1, .kind = CHECK_WHOLE },
    LENGTH, { .name = "k", .low = 0.00314, .high = 25.133 },
    { .name = "omega", .high = 402 }, CHECK_UNIT("Dx"), CHECK_UNIT("Dz"),
    CHECK_ANY("phase"), { .name = "A", .low = LEAST, .high = 16 },
    { .name = "Q", .high = 1e9 },
};

static check_wave make_wave(const double *p, bool sharp)
{
    return (check_wave){ .k = p[NUMBER], .dx = p[DX], .dz = p[DZ],
                         .amplitude = p[AMPLITUDE], .power = 1,
                         .q = sharp * p[SHARPNESS] * p[NUMBER] * p[AMPLITUDE] };
}

/* The waves of a table and their sea.  Waves that the core would clamp are refused: their
 * table has other values. */
typedef struct {
    check_wave wave[CHECK_LINES];
    unsigned   count;
    tp_deep_water deep;
} waves;

static int read_waves(const check_run *run, bool sharp, waves *w)
{
    double sum = 0;
    w->count = run->n_lines[0];
    for (unsigned i = 0; i < w->count; i++) {
        const double *p = run->lines[0][i];
        w->wave[i] = make_wave(p, sharp);
        sum += w->wave[i].q;
        if (p[AMPLITUDE] > 0.3 * p[WAVE_LENGTH] * CHECK_ONE)
            return check_refuse_line(run, 0, i, "A = %.9g is above 0.3 L, where it is"
                                     " cut", p[AMPLITUDE]);
        if (sum > 0.95 * CHECK_ONE)
            return check_refuse_line(run, 0, i, "sum Q k A = %.9g is above 0.95, where it"
                                     " is scaled down", sum);
    }
    w->deep = check_sea_make(w->wave, w->count);
    return EXIT_DONE;
}

static void compute_phases(const check_run *run, double t, tp_turn phases[TP_WAVES])
{
    for (unsigned i = 0; i < TP_WAVES; i++) {
        const double *p = run->lines[0][i];
        phases[i] = i < run->n_lines[0] ? check_turn(p[PHASE] - p[OMEGA] * t) : 0;
    }
}

/* Returns the point with the rest position v[0], v[1]. */
static tp_surface_point at_rest(const tp_deep_water *deep, const tp_turn phases[TP_WAVES],
                                const double *v)
{
    return tp_deep_water_displace_point(deep, phases, check_fx(v[0]), check_fx(v[1]));
}

/* Returns the angle between the normals, rad. */
static double normal_error(const tp_surface_point *p, const double want[3])
{
    return check_angle(tp_normalise(-p->slope_x, TP_FX_ONE, -p->slope_z), want)
         * (CHECK_PI / 180);
}

/* Returns the error of the position in units of the bounds; x, y, z: expected position,
 * m. */
static double place_error(const tp_surface_point *p, check_bound most, double x, double y,
                          double z)
{
    return fmax(fabs(check_metres(p->position.y) - y) / most.up,
                fmax(fabs(check_metres(p->position.x) - x),
                     fabs(check_metres(p->position.z) - z)) / most.along);
}

/* -- sum of sines -------------------------------------------------------------------- */

static const check_field sum_columns[] = {
    PLACE("x"), PLACE("z"), CHECK_TIME("t"), HEIGHT("y"), CHECK_ANY("dydx"),
    CHECK_ANY("dydz"), CHECK_UNIT("nx"), CHECK_UNIT("ny"), CHECK_UNIT("nz"),
};

static int run_sum_of_sines(check_run *run)
{
    waves w;
    const int code = read_waves(run, false, &w);
    for (unsigned row = 0; !code && row < run->table.n_rows; row++) {
        const double *v = check_row(run, row);
        const check_bound most = check_sea_bound(w.wave, w.count, v[0], v[1]);
        tp_turn phases[TP_WAVES];
        compute_phases(run, v[2], phases);
        const tp_surface_point p = at_rest(&w.deep, phases, v);
        check_add(run, 0, row, (check_metres(p.position.y) - v[3]) / most.up);
        check_add(run, 1, row, normal_error(&p, v + 6) / most.turn);
    }
    return code;
}

const check_model check_sum_of_sines = {
    CHECK_ALL(sum_columns),
    .notes = { { WAVE_TEXT, CHECK_ALL(wave_numbers), true },
               { .text = "[A1][A2] y=sum A sin(k D.p - omega t + phase); Q unused" },
               { .text = "units m,s" } },
    .quantities = { { "height", "bound", 1 }, { "normal", "bound", 1 } },
    .run = run_sum_of_sines,
};

/* -- sharpened sine ------------------------------------------------------------------ */

/* A: up to 0.3 of the length, 2 pi m. */
static const check_field sharp_columns[] = {
    { .name = "k", .low = 1, .high = 8, .kind = CHECK_WHOLE },
    { .name = "A", .low = LEAST, .high = 1.88495 }, CHECK_ANY("theta"), CHECK_ANY("f"),
    CHECK_ANY("mean"), HEIGHT("y"), CHECK_ANY("dy_dtheta"),
};

/* Compares a row: one wave with a length of 2 pi m, hence dy/dx = dy/dtheta, at the
 * origin. */
static void each_sharp(check_run *run, unsigned row, const double *v)
{
    const check_wave wave = { .k = 1, .dx = 1, .amplitude = v[1], .power = (int)v[0] };
    const check_bound most = check_sea_bound(&wave, 1, 0, 0);
    const tp_deep_water deep = check_sea_make(&wave, 1);
    const tp_turn phases[TP_WAVES] = { check_turn(v[2]) };
    const tp_surface_point p = tp_deep_water_displace_point(&deep, phases, 0, 0);
    const double length = sqrt(1 + v[6] * v[6]);
    const double normal[3] = { -v[6] / length, 1 / length, 0 };
    check_add(run, 0, row, (check_metres(p.position.y) - v[5]) / most.up);
    check_add(run, 1, row, normal_error(&p, normal) / most.turn);
}

const check_model check_sharp_sine = {
    CHECK_ALL(sharp_columns),
    .notes = { { .text = "[A3] f=2((sin th+1)/2)^k; mean=2 C(2k,k)/4^k; y=A(f-mean);"
                         " dy_dtheta=A k b^(k-1) cos th" } },
    .quantities = { { "height", "bound", 1 }, { "normal", "bound", 1 } },
    .each = each_sharp,
};

/* -- Gerstner ------------------------------------------------------------------------ */

static const check_field single_columns[] = {
    LENGTH, { .name = "S", .high = 0.95 * CHECK_ONE },
    CHECK_UNIT("Dx"), CHECK_UNIT("Dz"), PLACE("x0"), PLACE("z0"), CHECK_TIME("t"),
    POINT("px"), HEIGHT("py"), POINT("pz"), CHECK_UNIT("nx"), CHECK_UNIT("ny"),
    CHECK_UNIT("nz"), CHECK_ANY("det"),
};

/* Q = 1 and A = S / k: the steepness Q k A is S. */
static int run_single(check_run *run)
{
    for (unsigned row = 0; row < run->table.n_rows; row++) {
        const double *v = check_row(run, row), k = 2 * CHECK_PI / v[0];
        const check_wave wave = { .k = k, .dx = v[2], .dz = v[3], .amplitude = v[1] / k,
                                  .q = v[1], .power = 1 };
        if (wave.amplitude > 16)
            return check_refuse(run, row, "A = S L / 2 pi = %.9g m is above 16",
                                wave.amplitude);
        const check_bound most = check_sea_bound(&wave, 1, v[4], v[5]);
        const tp_deep_water deep = check_sea_make(&wave, 1);
        const tp_turn phases[TP_WAVES] = { check_turn(-sqrt(9.81 * k) * v[6]) };
        const tp_surface_point p = at_rest(&deep, phases, v + 4);
        check_add(run, 0, row, place_error(&p, most, v[7], v[8], v[9]));
        check_add(run, 1, row,
                  normal_error(&p, v + 10) / check_trochoid_bound(&wave, v[4], v[5]));
    }
    return EXIT_DONE;
}

const check_model check_gerstner_single = {
    CHECK_ALL(single_columns),
    .notes = { { .text = "[A7][A8] one wave, Q=1, A=S/k, omega=sqrt(g k), g=9.81, phase"
                         " 0; det=horizontal Jacobian" } },
    .quantities = { { "position", "bound", 1 }, { "normal", "bound", 1 } },
    .run = run_single,
};

enum { NX = 6, TX = 9, TY = 10, BY = 13, BZ = 14 };

static const check_field gerstner_columns[] = {
    PLACE("x0"), PLACE("z0"), CHECK_TIME("t"), POINT("px"), HEIGHT("py"), POINT("pz"),
    CHECK_UNIT("nx"), CHECK_UNIT("ny"), CHECK_UNIT("nz"), CHECK_ANY("tx"),
    CHECK_ANY("ty"), CHECK_ANY("tz"), CHECK_ANY("bx"), CHECK_ANY("by"), CHECK_ANY("bz"),
    CHECK_ANY("det"),
};

static const check_field steepness_sum[] = {
    { .name = "sum Q k A", .high = 0.95 * CHECK_ONE },
};

/* Returns the error of the normal.  The expected normal is nx, ny, nz of the check's table.
 * A sea without cross terms [A10] is compared with a normal without cross terms, computed
 * from the table's tangents t = (Jxx, hx, Jxz) and b = (Jxz, hz, Jzz). */
static double gerstner_normal_error(const tp_deep_water *deep, const tp_surface_point *p,
                                    const double *v)
{
    const double cheap[3] = { -v[TY], v[TX] + v[BZ] - 1, -v[BY] };
    return normal_error(p, deep->crossed || deep->count < 2 ? v + NX : cheap);
}

static int run_gerstner_sum(check_run *run)
{
    waves w;
    const int code = read_waves(run, true, &w);
    for (unsigned row = 0; !code && row < run->table.n_rows; row++) {
        const double *v = check_row(run, row);
        const check_bound most = check_sea_bound(w.wave, w.count, v[0], v[1]);
        tp_turn phases[TP_WAVES];
        compute_phases(run, v[2], phases);
        const tp_surface_point p = at_rest(&w.deep, phases, v);
        check_add(run, 0, row, place_error(&p, most, v[3], v[4], v[5]));
        check_add(run, 1, row, gerstner_normal_error(&w.deep, &p, v) / most.turn);
    }
    return code;
}

const check_model check_gerstner_sum = {
    CHECK_ALL(gerstner_columns),
    .notes = { { WAVE_TEXT, CHECK_ALL(wave_numbers), true },
               { "[A9][A10] exact (non-linearised) normal; sum Q k A = %",
                 CHECK_ALL(steepness_sum), false } },
    .quantities = { { "position", "bound", 1 }, { "normal", "bound", 1 } },
    .run = run_gerstner_sum,
};

/* -- height above a fixed point ------------------------------------------------------ */

enum { STEPS = 5, FIRST_STEP = 6 };

static const check_field buoyancy_columns[] = {
    PLACE("x"), PLACE("z"), CHECK_TIME("t"), POINT("x0"), POINT("z0"), HEIGHT("y"),
    HEIGHT("y_it0"), HEIGHT("y_it1"), HEIGHT("y_it2"), HEIGHT("y_it3"), HEIGHT("y_it4"),
    CHECK_UNIT("nx"), CHECK_UNIT("ny"), CHECK_UNIT("nz"),
};

/* Compares a row.  A step of the iteration is compared with the same step of the table, not
 * with the limit.  Position, height and normal of the root are those of a point at rest.
 * Without cross terms the normal may be turned by another 1.5 degrees [A10]. */
static void buoyancy_row(check_run *run, unsigned row, const waves *w)
{
    const double *v = check_row(run, row);
    const tp_fx x = check_fx(v[0]), z = check_fx(v[1]);
    const check_bound most = check_sea_bound(w->wave, w->count, v[0], v[1]);
    const double cheap = w->deep.crossed || w->count < 2 ? 0 : 1.5 * CHECK_PI / 180;
    tp_turn phases[TP_WAVES];
    compute_phases(run, v[2], phases);
    for (unsigned n = 0; n < STEPS; n++) {
        const tp_surface_point p =
            tp_deep_water_sample_iterated(&w->deep, phases, x, z, n);
        const double off = check_metres(p.position.y) - v[FIRST_STEP + n];
        check_add(run, n, row, off / most.step);
    }
    const tp_surface_point p = at_rest(&w->deep, phases, v + 3);
    check_add(run, STEPS, row, place_error(&p, most, v[0], v[5], v[1]));
    check_add(run, STEPS + 1, row, normal_error(&p, v + 11) / (most.turn + cheap));
}

static int run_buoyancy(check_run *run)
{
    waves w;
    const int code = read_waves(run, true, &w);
    for (unsigned row = 0; !code && row < run->table.n_rows; row++)
        buoyancy_row(run, row, &w);
    return code;
}

const check_model check_buoyancy = {
    CHECK_ALL(buoyancy_columns),
    .notes = { { WAVE_TEXT, CHECK_ALL(wave_numbers), true },
               { "[E1] surface height above fixed (x,z); x0,z0 the rest point; y_it0.."
                 " heights from the n-th fixed-point iterate; sum QkA=%",
                 CHECK_ALL(steepness_sum), false } },
    .quantities = { { "step 0", "bound", 1 }, { "step 1", "bound", 1 },
                    { "step 2", "bound", 1 }, { "step 3", "bound", 1 },
                    { "step 4", "bound", 1 }, { "root", "bound", 1 },
                    { "root normal", "bound", 1 } },
    .run = run_buoyancy,
};
