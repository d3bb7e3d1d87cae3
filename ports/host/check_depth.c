/* SPDX-License-Identifier: MIT */
/* tidepool check: one wave over a depth, [B1]-[B10], [B14], [B15] and [B20]. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "check.h"
#include "tidepool/depth.h"

#define GRAVITY TP_FX(9.81)
#define Q32     4294967296.0

#define DEPTH(n)  { .name = n, .low = 0.001, .high = 8000 }
#define NUMBER(n) { .name = n, .low = 0.001, .high = 100 }
#define ANY(n)    { .name = n, .low = -1e9, .high = 1e9 }
#define FLAG(n)   { .name = n, .high = 1, .kind = CHECK_WHOLE }
#define PERIOD    { .name = "T", .low = 0.5, .high = 35 }

static int64_t number_q32(double k)
{
    return llround(k * Q32);
}

/* The core names a wave by its length on deep water, g T^2 / 2 pi. */
static tp_fx deep_length(double period)
{
    return check_fx(9.81 * period * period / (2 * CHECK_PI));
}

/* Whether the roundings of the inputs may put a number on the other side of a limit. */
static bool on_the_edge(double x, double limit)
{
    return fabs(x / limit - 1) < 1e-4;
}

/* -- dispersion -------------------------------------------------------------------- */

enum { D_T, D_H, D_OMEGA, D_KINF, D_K, D_ECKART, D_FENTON, D_NEWTON, D_L, D_C, D_CG, D_KS,
       D_CLASS };

static const check_field dispersion_columns[] = {
    PERIOD, DEPTH("h"), NUMBER("omega"), NUMBER("k_inf"), NUMBER("k"), NUMBER("k_eckart"),
    NUMBER("k_fenton"), NUMBER("k_newton"), DEPTH("L"), NUMBER("c"), NUMBER("cg"),
    NUMBER("Ks"),
    { .name = "class", .kind = CHECK_WORD, .words = "shallow|transition|deep" },
};

static void each_dispersion(check_run *run, unsigned row, const double *v)
{
    const tp_fx   h = check_fx(v[D_H]);
    const int64_t k_inf = tp_depth_number_deep(deep_length(v[D_T]));
    const int64_t k = tp_depth_number(k_inf, h), exact = tp_depth_number_exact(k_inf, h);
    const double  ratio = v[D_H] / v[D_L];
    check_add(run, 0, row, check_percent((double)k / Q32, v[D_K]));
    check_add(run, 1, row, check_percent((double)k / Q32, v[D_NEWTON]));
    check_add(run, 2, row, check_percent((double)exact / Q32, v[D_K]));
    check_add(run, 3, row, check_percent((double)tp_depth_number_eckart(k_inf, h) / Q32,
                                   v[D_ECKART]));
    check_add(run, 4, row, check_percent((double)tp_depth_number_fenton(k_inf, h) / Q32,
                                   v[D_FENTON]));
    check_add(run, 5, row,
              check_percent(check_metres(tp_depth_speed(k_inf, exact, GRAVITY)), v[D_C]));
    check_add(run, 6, row,
              check_percent(check_metres(tp_depth_group_speed(k_inf, exact, h, GRAVITY)),
                      v[D_CG]));
    check_add(run, 7, row,
              check_percent(check_metres(tp_depth_shoaling(k_inf, exact, h)), v[D_KS]));
    if (!on_the_edge(ratio, 0.5) && !on_the_edge(ratio, 0.05))
        check_add(run, 8, row, (int)tp_depth_regime_of(exact, h) != (int)v[D_CLASS]);
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

/* -- the phase over a coast -------------------------------------------------------- */

enum { S_T, S_H0, S_SLOPE, S_THETA, S_X, S_H, S_K, S_KZ, S_ANGLE, S_PHASE, S_ECKART };

static const check_field shoaling_columns[] = {
    PERIOD, DEPTH("h0"), { .name = "slope", .high = 1 },
    { .name = "theta_inf_deg", .low = -89, .high = 89 },
    { .name = "x", .high = 8000 }, DEPTH("h"), NUMBER("k"),
    { .name = "kz", .low = -100, .high = 100 }, ANY("theta_deg"), ANY("S_exact"),
    ANY("S_eckart"),
};

/* The last row of the coast that begins at `row`. */
static unsigned last_of_coast(const check_run *run, unsigned row)
{
    const double *first = check_row(run, row);
    while (row + 1 < run->table.n_rows
           && memcmp(check_row(run, row + 1), first, S_X * sizeof *first) == 0)
        row++;
    return row;
}

static void along_coast(check_run *run, unsigned row, unsigned last,
                        const tp_coast *coast, int64_t k_inf)
{
    for (; row <= last; row++) {
        const double *v = check_row(run, row);
        const double turns = (double)tp_coast_phase(coast, check_fx(v[S_X])) / Q32;
        const int64_t k = tp_depth_number_exact(k_inf, check_fx(v[S_H]));
        check_add(run, 0, row, turns * 2 * CHECK_PI - v[S_PHASE]);
        check_add(run, 1, row, check_percent((double)k / Q32, v[S_K]));
    }
}

static int run_coast(check_run *run, unsigned row, unsigned last)
{
    const double *v = check_row(run, row);
    const tp_coast_shape shape = {
        .k_inf_q32 = tp_depth_number_deep(deep_length(v[S_T])),
        .kz_q32 = number_q32(v[S_KZ]), .depth = check_fx(v[S_H0]),
        .slope = check_q30(v[S_SLOPE]), .least = TP_FX(0.5),
        .x_to = check_fx(check_row(run, last)[S_X]),
    };
    const size_t bytes = tp_coast_bytes(&shape);
    tp_coast *coast = malloc(bytes);
    if (!coast)
        return fail_memory(bytes);
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

/* -- wind -------------------------------------------------------------------------- */

static const check_field wind_columns[] = {
    { .name = "r", .low = 0.001, .high = 64 },
    { .name = "lambda", .low = -100, .high = 100 },
    ANY("theta"), ANY("phi"), ANY("phi_it1"), ANY("phi_it2"), ANY("phi_it3"),
};

static void each_wind(check_run *run, unsigned row, const double *v)
{
    const tp_q30 push = tp_wind_push(check_fx(v[1]), check_fx(v[0]));
    for (int n = 1; n <= 3; n++) {
        const tp_turn phi = tp_wind_phase(check_turn(v[2]), push, n);
        const double off = check_wrapped(check_radians(phi) - v[3 + n]);
        check_add(run, (unsigned)n - 1, row, off);
    }
}

const check_model check_wind_phase = {
    CHECK_ALL(wind_columns),
    .notes = { { .text = "[B10] Phi = theta - lambda*dy, dy=-r cos Phi; phi exact root;"
                         " it1..it3 fixed-point iterates from theta" } },
    .quantities = { { "step 1", "rad", 0.001 }, { "step 2", "rad", 0.001 },
                    { "step 3", "rad", 0.001 } },
    .each = each_wind,
};

/* -- when waves break -------------------------------------------------------------- */

enum { C_T, C_H0, C_H, C_SLOPE, C_K, C_KS, C_HEIGHT, C_OVER_L, C_OVER_H, C_STEEP, C_DEPTH,
       C_MICHE, C_H_MICHE, C_XI0, C_TYPE };

static const check_field criteria_columns[] = {
    PERIOD, { .name = "H0", .low = 0.001, .high = 32 }, DEPTH("h"),
    { .name = "slope", .low = 0.0001, .high = 1 }, NUMBER("k"), NUMBER("Ks"),
    { .name = "H", .low = 0.001, .high = 1000 }, ANY("H_over_L"), ANY("H_over_h"),
    FLAG("steep"), FLAG("depth"), FLAG("miche"), NUMBER("H_miche"), NUMBER("xi0"),
    { .name = "type", .kind = CHECK_WORD, .words = "spilling|plunging|surging" },
};

static void compare_flag(check_run *run, unsigned row, uint32_t flags, uint32_t flag,
                         double known, bool edge)
{
    if (!edge)
        check_add(run, 3, row, ((flags & flag) != 0) != (known != 0));
}

static void each_criterion(check_run *run, unsigned row, const double *v)
{
    const tp_fx   h = check_fx(v[C_H]), high = check_fx(v[C_H0]);
    const tp_fx   length = deep_length(v[C_T]);
    const int64_t k_inf = tp_depth_number_deep(length);
    const int64_t k = tp_depth_number_exact(k_inf, h);
    const tp_fx   ks = tp_depth_shoaling(k_inf, k, h), height = tp_fx_mul(high, ks);
    const tp_fx   miche = tp_miche_height(k, h);
    const tp_fx   xi = tp_iribarren(check_q30(v[C_SLOPE]), high, length);
    const uint32_t flags = tp_breaking_flags(height, k, h);
    check_add(run, 0, row, check_percent(check_metres(miche), v[C_H_MICHE]));
    check_add(run, 1, row, check_percent(check_metres(xi), v[C_XI0]));
    check_add(run, 2, row, check_percent(check_metres(ks), v[C_KS]));
    compare_flag(run, row, flags, TP_BREAKING_STEEP, v[C_STEEP],
                 on_the_edge(v[C_OVER_L], 1 / 7.0));
    compare_flag(run, row, flags, TP_BREAKING_DEPTH, v[C_DEPTH],
                 on_the_edge(v[C_OVER_H], 0.78));
    compare_flag(run, row, flags, TP_BREAKING_MICHE, v[C_MICHE],
                 on_the_edge(v[C_HEIGHT], v[C_H_MICHE]));
    if (!on_the_edge(v[C_XI0], 0.5) && !on_the_edge(v[C_XI0], 3.3))
        check_add(run, 4, row, tp_breaker_type_of(xi) != (tp_breaker_type)v[C_TYPE]);
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
