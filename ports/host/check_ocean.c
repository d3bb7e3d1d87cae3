/* SPDX-License-Identifier: MIT */
/* tidepool check: orbits over a floor and breaking crests, [B11]-[B13], [B16]-[B19]. */
#include <math.h>
#include "check.h"
#include "tidepool/ocean.h"

#define Q32     4294967296.0
#define QUARTER 0x40000000u

#define OFFSET(n) { .name = n, .low = -1000, .high = 1000 }
#define ANY(n)    { .name = n, .low = -1e9, .high = 1e9 }
#define RADIUS    { .name = "r", .low = 0.001, .high = 64 }
#define DEPTH     { .name = "h", .low = 0.001, .high = 8000 }
#define GAMMA     { .name = "gamma", .low = -1.57, .high = 1.57 }
#define NUMBER    { .name = "k", .low = 0.001, .high = 100 }

/* -- orbits ------------------------------------------------------------------------ */

enum { R, H, GAMMA_AT, K };         /* the first columns of both files */

static const check_field orbit_columns[] = {
    RADIUS, DEPTH, GAMMA, NUMBER, ANY("Phi"), { .name = "sin_a", .low = -1, .high = 1 },
    { .name = "cos_a", .low = -1, .high = 1 }, ANY("Sx_raw"), ANY("Sx"), ANY("Sy"),
    OFFSET("dx"), OFFSET("dy"),
};

static const check_field orbit_numbers[] = {
    { .name = "K0", .high = 4 }, { .name = "Kx", .low = 0.001, .high = 4 },
    { .name = "Ky", .low = 0.001, .high = 4 },
};

static tp_ellipse orbit_of(const double *v, double k0, double kx, double ky)
{
    return tp_orbit_of(check_fx(v[R]), check_fx(v[H]), check_turn(v[GAMMA_AT]),
                       llround(v[K] * Q32), check_fx(k0), check_fx(kx), check_fx(ky));
}

static double apart_mm(tp_offset at, double along, double up)
{
    return 1000 * fmax(fabs(check_metres(at.along) - along),
                       fabs(check_metres(at.up) - up));
}

static int run_fr_orbit(check_run *run)
{
    const double *k = run->lines[0][0];
    for (unsigned row = 0; row < run->table.n_rows; row++) {
        const double *v = check_row(run, row);
        const tp_ellipse orbit = orbit_of(v, k[0], k[1], k[2]);
        const tp_offset at = tp_orbit(&orbit, check_turn(v[4]));
        check_add(run, 0, row, apart_mm(at, v[10], v[11]));
        check_add(run, 1, row, 1000 * (check_metres(orbit.along) - v[R] * v[8]));
        check_add(run, 2, row, 1000 * (check_metres(orbit.up) - v[R] * v[9]));
    }
    return EXIT_DONE;
}

const check_model check_fr_orbit = {
    CHECK_ALL(orbit_columns),
    .notes = { { "[B11]-[B13] K0=% Kx=% Ky=% 1/m; h floored at 1/16 m; sin_a=max(0,sin"
                 " gamma)exp(-K0 h); Sx capped at 0.95/(k r); Sy from the UNCAPPED"
                 " ratio; dx,dy = offset from rest (m)",
                 CHECK_ALL(orbit_numbers), false } },
    .quantities = { { "offset", "mm", 1 }, { "r Sx", "mm", 1 }, { "r Sy", "mm", 1 } },
    .run = run_fr_orbit,
};

/* -- breaking crests --------------------------------------------------------------- */

enum { STRETCH_MOST = 4, KS, KD, PHI, PHI_MIN, P, STRETCH, DISPLACEMENT, ORIENTATION,
       GATE, X, Y };

static const check_field breaking_columns[] = {
    RADIUS, DEPTH, GAMMA, NUMBER, { .name = "St_max", .high = 100 },
    { .name = "Ks", .high = 4 }, { .name = "Kd", .high = 4 }, ANY("Phi"), ANY("Phi_min"),
    ANY("p"), ANY("Stretch"), ANY("Displacement"), ANY("Orientation"),
    { .name = "gate", .high = 1 }, OFFSET("X"), OFFSET("Y"),
};

/* e^-Kh by the core: the sine of an orbit's tilt is sin gamma e^-K0 h [B11], and here
 * gamma is upright. */
static tp_fx decay(double k, double h)
{
    const tp_ellipse e = tp_orbit_of(TP_FX_ONE, check_fx(h), QUARTER, 0, check_fx(k),
                                     TP_FX(0.11), TP_FX(0.09));
    return (e.sin + (1 << 13)) >> 14;
}

/* Rows on the joints count too: the three parts are continuous there, and at the crest,
 * where p jumps from pi to -pi, both sides have the same value. */
static void each_breaking(check_run *run, unsigned row, const double *v)
{
    const tp_fx gate = tp_breaking_gate(tp_fx_div(check_fx(2 * v[R]), check_fx(v[H])));
    const tp_breaker breaker = {
        .orbit = orbit_of(v, 0.1, 0.11, 0.09),
        .stretch = check_fx(v[STRETCH_MOST]), .lip = check_fx(2 * v[R]),
        .kept_stretch = tp_fx_mul(gate, decay(v[KS], v[H])),
        .kept_lip = tp_fx_mul(gate, decay(v[KD], v[H])),
    };
    const tp_breaking at = tp_breaking_shape(&breaker, check_turn(v[PHI]));
    const double lowest = check_radians(tp_orbit_lowest(&breaker.orbit));
    check_add(run, 0, row, apart_mm(at.offset, v[X], v[Y]));
    check_add(run, 1, row, 1000 * (check_metres(at.stretch) - v[STRETCH]));
    check_add(run, 2, row, 1000 * (check_metres(at.displacement) - v[DISPLACEMENT]));
    check_add(run, 3, row, at.orientation * (2 * CHECK_PI / Q32) - v[ORIENTATION]);
    check_add(run, 4, row, check_wrapped(lowest - v[PHI_MIN]));
    check_add(run, 5, row, check_metres(gate) - v[GATE]);
}

const check_model check_breaking = {
    CHECK_ALL(breaking_columns),
    .notes = { { .text = "[B16]-[B19] reconstructed Gonzato/Le Saec; p=wrap(Phi-Phimin)"
                         " in [-pi,pi); X,Y offset from rest (m); FR part as"
                         " fr_orbit.csv; gate=smoothstep(0.6,0.78,2r/h) multiplies the"
                         " Stretch and Displacement terms in X,Y" } },
    .quantities = { { "offset", "mm", 2 }, { "stretch", "mm", 2 },
                    { "displacement", "mm", 2 }, { "orientation", "rad", 0.002 },
                    { "Phi_min", "rad", 0.002 }, { "gate", "", 0.001 } },
    .each = each_breaking,
};
