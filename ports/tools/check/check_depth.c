/* SPDX-License-Identifier: MIT */
/* tidepool check: one wave over a depth, [B1]-[B10], [B14], [B15] and [B20]. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "check.h"
#include "waves/coastal_water.h"

#define GRAVITY TP_FX(9.81)
#define Q32     4294967296.0

/* Period, s: T = sqrt(2 pi L / g) for L = 0.25..2000 m. */
#define PERIOD  { .name = "T", .low = 0.4, .high = 35.8 }
#define FLAG(n) { .name = n, .high = 1, .kind = CHECK_WHOLE }

static int64_t number_q32(double k)
{
    return llround(k * Q32);
}

/* Returns k_inf = omega^2 / g, Q32, at full precision; a length in 16.16 would give fewer
 * bits. */
static int64_t deep_number(double period)
{
    return number_q32(4 * CHECK_PI * CHECK_PI / (9.81 * period * period));
}

/* Returns the length in deep water, g T^2 / 2 pi, m. */
static double deep_length(double period)
{
    return 9.81 * period * period / (2 * CHECK_PI);
}

/* True if rounding of the inputs may move x across the limit.  lost: relative error of
 * x. */
static bool on_the_edge(double x, double limit, double lost)
{
    return fabs(x / limit - 1) < 1e-4 + lost;
}

/* -- dispersion ---------------------------------------------------------------------- */

enum { D_T, D_H, D_OMEGA, D_KINF, D_K, D_ECKART, D_FENTON, D_NEWTON, D_L, D_C, D_CG, D_KS,
       D_CLASS };

static const check_field dispersion_columns[] = {
    PERIOD, CHECK_DEPTH("h"), CHECK_WAVES("omega"), CHECK_WAVES("k_inf"),
    CHECK_WAVES("k"), CHECK_WAVES("k_eckart"), CHECK_WAVES("k_fenton"),
    CHECK_WAVES("k_newton"), { .name = "L", .low = 0.0048, .high = 2002 },
    CHECK_WAVES("c"), CHECK_WAVES("cg"), CHECK_WAVES("Ks"),
    { .name = "class", .kind = CHECK_WORD, .words = "shallow|transition|deep" },
};

static void compare_percent(check_run *run, unsigned quantity, unsigned row, double got,
                            double want, double lost)
{
    check_add(run, quantity, row, check_excess(check_percent(got, want), 100 * lost));
}

/* A relative error of h changes k, c, cg and Ks by at most half of that error: by half in
 * shallow water, where k = sqrt(k_inf / h), and by less in deeper water. */
static void each_dispersion(check_run *run, unsigned row, const double *v)
{
    const tp_fx   h = check_fx(v[D_H]);
    const int64_t k_inf = deep_number(v[D_T]);
    const int64_t k = tp_depth_wave_number(k_inf, h),
                  exact = tp_depth_wave_number_exact(k_inf, h);
    const double  ratio = v[D_H] / v[D_L], lost = check_share(v[D_H]) / 2;
    const double  number[5] = { (double)k, (double)k, (double)exact,
                                (double)tp_depth_wave_number_eckart(k_inf, h),
                                (double)tp_depth_wave_number_fenton(k_inf, h) };
    const unsigned want[5] = { D_K, D_NEWTON, D_K, D_ECKART, D_FENTON };
    for (unsigned i = 0; i < 5; i++)
        compare_percent(run, i, row, number[i] / Q32, v[want[i]], lost);
    const double c = check_metres(tp_depth_speed(k_inf, exact, GRAVITY));
    const double cg = check_metres(tp_depth_group_speed(k_inf, exact, h, GRAVITY));
    compare_percent(run, 5, row, c, v[D_C], lost + CHECK_HALF / v[D_C]);
    compare_percent(run, 6, row, cg, v[D_CG], lost + CHECK_HALF / v[D_CG]);
    const double shoaled = check_metres(tp_depth_shoaling_factor(k_inf, exact, h));
    compare_percent(run, 7, row, shoaled, v[D_KS], lost);
    if (!on_the_edge(ratio, 0.5, 2 * lost) && !on_the_edge(ratio, 0.05, 2 * lost))
        check_add(run, 8, row, (int)tp_depth_classify(exact, h) != (int)v[D_CLASS]);
}

const check_model check_dispersion = {
    CHECK_ALL(dispersion_columns),
    .notes = { { .text = "[B1]-[B7] T s, h m, g=9.81; k exact, k_eckart [B4], k_fenton"
                         " [B5], k_newton = one Newton step from Eckart [B6]; Ks"
                         " shoaling coefficient [B7]" } },
    .quantities = { { "k, usual", "%", 0.06 }, { "k, one step", "%", 0.06 },
                    { "k, for tables", "%", 0.06 }, { "k, Eckart", "%", 0.06 },
                    { "k, Fenton", "%", 0.06 }, { "c", "%", 0.06 }, { "cg", "%", 0.06 },
                    { "Ks", "%", 0.1 }, { "class", "", 0 } },
    .each = each_dispersion,
};

/* -- phase over a coast -------------------------------------------------------------- */

enum { S_T, S_H0, S_SLOPE, S_THETA, S_X, S_H, S_K, S_KZ, S_ANGLE, S_PHASE, S_ECKART };

static const check_field shoaling_columns[] = {
    PERIOD, CHECK_DEPTH("h0"), { .name = "slope", .high = 1 },
    { .name = "theta_inf_deg", .low = -89, .high = 89 },
    { .name = "x", .high = 32767 }, CHECK_DEPTH("h"), CHECK_WAVES("k"),
    { .name = "kz", .low = -26, .high = 26 }, CHECK_ANY("theta_deg"),
    CHECK_ANY("S_exact"), CHECK_ANY("S_eckart"),
};

/* Returns the last row of the coast that begins at `row`. */
static unsigned last_of_coast(const check_run *run, unsigned row)
{
    const double *first = check_row(run, row);
    while (row + 1 < run->table.n_rows
           && memcmp(check_row(run, row + 1), first, S_X * sizeof *first) == 0)
        row++;
    return row;
}

/* Returns the bound of the phase error by rounding, rad.  Rounding of x: the phase grows by
 * at most k per m.  Rounding of h0 and of the slope changes the depth h, and with h the
 * integrand sqrt(k^2 - kz^2), |kz| <= k_inf, by at most 0.56 k / h per m of depth.  h is at
 * least 0.5 m, and k grows towards the row's k. */
static double phase_lost(const double *v)
{
    const double slope = fabs(check_q30(v[S_SLOPE]) / (double)TP_Q30_ONE - v[S_SLOPE]);
    const double h = check_rounding(v[S_H0]) + slope * v[S_X];
    return v[S_K] * (check_rounding(v[S_X]) + v[S_X] * 1.12 * h);
}

static void along_coast(check_run *run, unsigned row, unsigned last,
                        const tp_coast *coast, int64_t k_inf)
{
    for (; row <= last; row++) {
        const double *v = check_row(run, row);
        const double turns = (double)tp_coast_phase(coast, check_fx(v[S_X])) / Q32;
        const int64_t k = tp_depth_wave_number_exact(k_inf, check_fx(v[S_H]));
        const double off = turns * 2 * CHECK_PI - v[S_PHASE];
        check_add(run, 0, row, check_excess(off, phase_lost(v)));
        compare_percent(run, 1, row, (double)k / Q32, v[S_K], check_share(v[S_H]) / 2);
    }
}

static int run_coast(check_run *run, unsigned row, unsigned last)
{
    const double *v = check_row(run, row);
    const tp_coast_shape shape = {
        .k_inf_q32 = deep_number(v[S_T]),
        .kz_q32 = number_q32(v[S_KZ]), .depth = check_fx(v[S_H0]),
        .slope = check_q30(v[S_SLOPE]), .least = TP_FX(0.5),
        .x_to = check_fx(check_row(run, last)[S_X]),
    };
    const size_t bytes = tp_coast_bytes(&shape);
    tp_coast *coast = malloc(bytes);
    if (!coast)
        return log_fail_memory(bytes);
    tp_coast_init(coast, &shape);
    along_coast(run, row, last, coast, shape.k_inf_q32);
    free(coast);
    return EXIT_DONE;
}

static int run_shoaling_phase(check_run *run)
{
    int code = EXIT_DONE;
    for (unsigned row = 0; !code && row < run->table.n_rows;) {
        const unsigned last = last_of_coast(run, row);
        code = run_coast(run, row, last);
        row = last + 1;
    }
    return code;
}

const check_model check_shoaling_phase = {
    CHECK_ALL(shoaling_columns),
    .notes = { { .text = "[B8][B9] straight coast, h(x)=max(0.5,h0-slope*x); S=int_0^x"
                         " sqrt(k^2-kz^2)dx rad; S with exact k and with Eckart k;"
                         " theta = ray angle to shore normal (deg)" } },
    .quantities = { { "phase", "rad", 0.002 }, { "k", "%", 0.06 } },
    .run = run_shoaling_phase,
};

/* -- wind ---------------------------------------------------------------------------- */

static const check_field wind_columns[] = {
    { .name = "r", .low = 0.001, .high = 64 },
    { .name = "lambda", .low = -100, .high = 100 },
    CHECK_ANY("theta"), CHECK_ANY("phi"), CHECK_ANY("phi_it1"), CHECK_ANY("phi_it2"),
    CHECK_ANY("phi_it3"),
};

static void wind_row(check_run *run, unsigned row, const double *v)
{
    const tp_q30 push = tp_wind_phase_shift(check_fx(v[1]), check_fx(v[0]));
    for (int n = 1; n <= 3; n++) {
        const tp_turn phi = tp_wind_phase(check_turn(v[2]), push, n);
        const double off = check_wrapped(check_radians(phi) - v[3 + n]);
        check_add(run, (unsigned)n - 1, row, off);
    }
}

static int run_wind_phase(check_run *run)
{
    for (unsigned row = 0; row < run->table.n_rows; row++) {
        const double *v = check_row(run, row);
        if (fabs(v[0] * v[1]) > 0.5 * CHECK_ONE)
            return check_refuse(run, row, "lambda r = %.9g is outside -0.5..0.5, where it"
                                " is held", v[0] * v[1]);
        wind_row(run, row, v);
    }
    return EXIT_DONE;
}

const check_model check_wind_phase = {
    CHECK_ALL(wind_columns),
    .notes = { { .text = "[B10] Phi = theta - lambda*dy, dy=-r cos Phi; phi exact root;"
                         " it1..it3 fixed-point iterates from theta" } },
    .quantities = { { "step 1", "rad", 0.001 }, { "step 2", "rad", 0.001 },
                    { "step 3", "rad", 0.001 } },
    .run = run_wind_phase,
};

/* -- criteria of breaking ------------------------------------------------------------ */

enum { C_T, C_H0, C_H, C_SLOPE, C_K, C_KS, C_HEIGHT, C_OVER_L, C_OVER_H, C_STEEP, C_DEPTH,
       C_MICHE, C_H_MICHE, C_XI0, C_TYPE };

/* H0 is twice the amplitude of a tp_wave; Ks 0.913 to 48; H = H0 Ks; Miche's height 0.142 L
 * tanh(kh); xi0 = slope / sqrt(H0 / L0).  Columns compared in percent have a low bound
 * above 0, below every value that the other columns allow. */
static const check_field criteria_columns[] = {
    PERIOD, { .name = "H0", .low = 0.001, .high = 32 }, CHECK_DEPTH("h"),
    { .name = "slope", .low = 0.0001, .high = 1 }, CHECK_WAVES("k"), CHECK_WAVES("Ks"),
    { .name = "H", .low = 0.0009, .high = 1540 }, CHECK_ANY("H_over_L"),
    CHECK_ANY("H_over_h"), FLAG("steep"), FLAG("depth"), FLAG("miche"),
    { .name = "H_miche", .low = 1e-5, .high = 285 },
    { .name = "xi0", .low = 8e-6, .high = 1416 },
    { .name = "type", .kind = CHECK_WORD, .words = "spilling|plunging|surging" },
};

static void compare_flag(check_run *run, unsigned row, uint32_t flags, uint32_t flag,
                         double known, bool edge)
{
    if (!edge)
        check_add(run, 3, row, ((flags & flag) != 0) != (known != 0));
}

static void compare_flags(check_run *run, unsigned row, uint32_t flags, double lost)
{
    const double *v = check_row(run, row);
    compare_flag(run, row, flags, TP_BREAKING_STEEP, v[C_STEEP],
                 on_the_edge(v[C_OVER_L], 1 / 7.0, lost));
    compare_flag(run, row, flags, TP_BREAKING_DEPTH, v[C_DEPTH],
                 on_the_edge(v[C_OVER_H], 0.78, lost));
    compare_flag(run, row, flags, TP_BREAKING_MICHE, v[C_MICHE],
                 on_the_edge(v[C_HEIGHT], v[C_H_MICHE], lost));
}

/* Compares one row.  The results are rounded too.  Miche's height has the full relative
 * error of the depth. */
static void each_criterion(check_run *run, unsigned row, const double *v)
{
    const tp_fx   h = check_fx(v[C_H]), high = check_fx(v[C_H0]);
    const double  length = deep_length(v[C_T]);
    const int64_t k_inf = deep_number(v[C_T]), k = tp_depth_wave_number_exact(k_inf, h);
    const tp_fx   ks = tp_depth_shoaling_factor(k_inf, k, h), height = tp_fx_mul(high, ks);
    const tp_fx   xi = tp_iribarren(check_q30(v[C_SLOPE]), high, check_fx(length));
    const double  deep = check_share(v[C_H]), first = check_share(v[C_H0]);
    const double  miche = deep + CHECK_HALF / v[C_H_MICHE];
    const double  breaks = (first + check_share(length)) / 2 + CHECK_HALF / v[C_XI0];
    compare_percent(run, 0, row, check_metres(tp_miche_height(k, h)), v[C_H_MICHE],
                    miche);
    compare_percent(run, 1, row, check_metres(xi), v[C_XI0], breaks);
    compare_percent(run, 2, row, check_metres(ks), v[C_KS], deep / 2);
    compare_flags(run, row, tp_breaking_flags(height, k, h),
                  first + deep + miche + CHECK_HALF / v[C_HEIGHT]);
    if (!on_the_edge(v[C_XI0], 0.5, breaks) && !on_the_edge(v[C_XI0], 3.3, breaks))
        check_add(run, 4, row, tp_breaker_classify(xi) != (tp_breaker_type)v[C_TYPE]);
}

const check_model check_breaking_criteria = {
    CHECK_ALL(criteria_columns),
    .notes = { { .text = "[B14][B15][B20] H0 deep height m, m=tan(beach slope);"
                         " Iribarren xi0 = m/sqrt(H0/L0); steep: H/L>1/7, depth:"
                         " H/h>0.78, miche: H>0.142 L tanh(kh)" } },
    .quantities = { { "H_miche", "%", 0.1 }, { "xi0", "%", 0.1 }, { "Ks", "%", 0.1 },
                    { "flags", "", 0 }, { "type", "", 0 } },
    .each = each_criterion,
};
