/* SPDX-License-Identifier: MIT */
/* tidepool check: orbits over a floor and breaking crests, [B11]-[B13], [B16]-[B19]. */
#include <math.h>
#include "check.h"
#include "waves/coastal_water.h"

#define Q32     4294967296.0
#define QUARTER 0x40000000u

/* Arguments of tp_orbit_ellipse: radius, m; slope of the floor, rad, at most vertical. */
#define RADIUS    { .name = "r", .low = 0.001, .high = 64 }
#define GAMMA     { .name = "gamma", .low = -1.5708, .high = 1.5708 }

/* Offset, m: half axes up to 0.95 / k = 303 along and 128 up, and a stretch and a lip of
 * 128. */
#define OFFSET(n) { .name = n, .low = -1000, .high = 1000 }

/* -- orbits -------------------------------------------------------------------------- */

enum { R, H, GAMMA_AT, K };         /* the first columns of both files */

static const check_field orbit_columns[] = {
    RADIUS, CHECK_DEPTH("h"), GAMMA, CHECK_WAVES("k"), CHECK_ANY("Phi"),
    CHECK_UNIT("sin_a"), CHECK_UNIT("cos_a"), CHECK_ANY("Sx_raw"),
    { .name = "Sx", .high = 8192 }, { .name = "Sy", .high = 2 },    /* the core's bounds */
    OFFSET("dx"), OFFSET("dy"),
};

static const check_field orbit_numbers[] = {
    { .name = "K0", .high = 4 }, { .name = "Kx", .low = 0.001, .high = 4 },
    { .name = "Ky", .low = 0.001, .high = 4 },
};

static tp_ellipse make_orbit(const double *v, double k0, double kx, double ky)
{
    return tp_orbit_ellipse(check_fx(v[R]), check_fx(v[H]), check_turn(v[GAMMA_AT]),
                       llround(v[K] * Q32), check_fx(k0), check_fx(kx), check_fx(ky));
}

static double apart_mm(tp_offset at, double along, double up)
{
    return 1000 * fmax(fabs(check_metres(at.along) - along),
                       fabs(check_metres(at.up) - up));
}

/* Refuses a row with k r > 0.95: the core clamps r there, so no comparison is possible. */
static int refuse_wide(const check_run *run, unsigned row)
{
    const double *v = check_row(run, row), wide = v[R] * v[K];
    return wide <= 0.95 ? EXIT_DONE
         : check_refuse(run, row, "k r = %.9g is above 0.95, where r is held", wide);
}

/* Returns the bound of the relative error of 1 - e^-x, x = K h, by rounding: of K, of h
 * (clamped to at least 1/16 m), and of x itself, Q24. */
static double fall_share(double k, double h)
{
    const double deep = fmax(h, 1 / 16.0);
    if (k <= 0)
        return 0;
    return check_share(k) + (deep == h) * check_share(h) + 1 / (33554432 * k * deep);
}

/* Returns the bound of the tilt's error, rad.  The sine of the tilt, sin gamma e^-K0 h,
 * changes by at most 1 / e of the relative error, and has an error of its own. */
static double tilt_lost(double k0, double h, double cos_a)
{
    return (fall_share(k0, h) / 2.7 + 5e-6) / fmax(cos_a, 1e-4);
}

/* Returns the bound of the relative error of the half axes, and hence of the orbit's
 * size. */
static double axes_lost(const double *v, const double *k)
{
    return check_share(v[R]) + fall_share(k[1], v[H]) + fall_share(k[2], v[H]) + 5e-6;
}

static void orbit_row(check_run *run, unsigned row, const double *k)
{
    const double *v = check_row(run, row);
    const tp_ellipse orbit = make_orbit(v, k[0], k[1], k[2]);
    const tp_offset at = tp_orbit_evaluate(&orbit, check_turn(v[4]));
    const double along = v[R] * v[8], up = v[R] * v[9], lost = 1000 * axes_lost(v, k);
    const double turned = 1000 * tilt_lost(k[0], v[H], v[6]);
    check_add(run, 0, row, check_excess(apart_mm(at, v[10], v[11]),
                                        (along + up) * (lost + turned)));
    check_add(run, 1, row, check_excess(1000 * (check_metres(orbit.along) - along),
                                        along * lost));
    check_add(run, 2, row, check_excess(1000 * (check_metres(orbit.up) - up), up * lost));
}

static int run_fr_orbit(check_run *run)
{
    int code = EXIT_DONE;
    for (unsigned row = 0; !code && row < run->table.n_rows; row++) {
        code = refuse_wide(run, row);
        if (!code)
            orbit_row(run, row, run->lines[0][0]);
    }
    return code;
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

/* -- breaking crests ----------------------------------------------------------------- */

enum { STRETCH_MOST = 4, KS, KD, PHI, PHI_MIN, P, STRETCH, DISPLACEMENT, ORIENTATION,
       GATE, X, Y };

/* St_max: range of tp_breaker's stretch, m. */
static const check_field breaking_columns[] = {
    RADIUS, CHECK_DEPTH("h"), GAMMA, CHECK_WAVES("k"), { .name = "St_max", .high = 128 },
    { .name = "Ks", .high = 4 }, { .name = "Kd", .high = 4 }, CHECK_ANY("Phi"),
    CHECK_ANY("Phi_min"), CHECK_ANY("p"), CHECK_ANY("Stretch"),
    CHECK_ANY("Displacement"), CHECK_ANY("Orientation"),
    { .name = "gate", .high = CHECK_ONE }, OFFSET("X"), OFFSET("Y"),
};

static const double usual[3] = { 0.1, 0.11, 0.09 };    /* K0, Kx, Ky, 1/m */

/* Returns e^-Kh from the core: the sine of an orbit's tilt is sin gamma e^-K0 h [B11], here
 * with gamma vertical. */
static tp_fx decay(double k, double h)
{
    const tp_ellipse e = tp_orbit_ellipse(TP_FX_ONE, check_fx(h), QUARTER, 0, check_fx(k),
                                          TP_FX(0.11), TP_FX(0.09));
    return (e.sin + (1 << 13)) >> 14;
}

/* Bounds of the errors explained by rounding. */
typedef struct {
    double offset, stretch, displacement;       /* m */
    double orientation, lowest;                 /* rad */
    double gate;
} breaking_lost;

/* Phi_min = -atan2(along sin a, up cos a).  Its error has three parts: the error of the
 * tilt a times along / up, the relative errors of the axes, and the last bits of both
 * products.  The stretch, (p / pi)^2, and the ramp of lip and orientation, at most 8 / pi
 * per radian, depend on p.  The gate rises 8.4 times as fast as 2 r / h, and 2 r / h is
 * 0.78 at its end. */
static breaking_lost breaking_error_bound(const double *v, const tp_ellipse *orbit)
{
    const double along = check_metres(orbit->along), up = check_metres(orbit->up);
    const double c = orbit->cos / (double)TP_Q30_ONE, s = orbit->sin / (double)TP_Q30_ONE;
    const double tilt = tilt_lost(usual[0], v[H], c), axes = axes_lost(v, usual);
    const double p = along / up * tilt + axes + 3 * CHECK_HALF / hypot(along * s, up * c);
    const double sizes = v[STRETCH_MOST] + 2 * v[R];
    breaking_lost lost = {
        .stretch = v[STRETCH_MOST] * 2 / CHECK_PI * p + check_rounding(v[STRETCH_MOST]),
        .displacement = 2 * v[R] * 8 / CHECK_PI * p + check_rounding(2 * v[R]),
        .orientation = 6 * p + tilt, .lowest = p,
        .gate = 6.6 * (check_share(2 * v[R]) + check_share(v[H])),
    };
    const double kept = (fall_share(v[KS], v[H]) + fall_share(v[KD], v[H])) / 2.7
                      + 4 * CHECK_HALF;
    lost.offset = (along + up) * (axes + tilt) + lost.stretch + lost.displacement
                + sizes * (lost.gate + kept + lost.orientation);
    return lost;
}

static tp_breaker make_breaker(const double *v, tp_fx gate)
{
    return (tp_breaker){
        .orbit = make_orbit(v, usual[0], usual[1], usual[2]),
        .stretch = check_fx(v[STRETCH_MOST]), .lip = check_fx(2 * v[R]),
        .kept_stretch = tp_fx_mul(gate, decay(v[KS], v[H])),
        .kept_lip = tp_fx_mul(gate, decay(v[KD], v[H])),
    };
}

/* Compares one row.  Rows on the joints count too: the three parts are continuous there.
 * At the crest p jumps from pi to -pi, with the same value on both sides. */
static void breaking_row(check_run *run, unsigned row, const double *v)
{
    const tp_fx gate = tp_breaking_gate(tp_fx_div(check_fx(2 * v[R]), check_fx(v[H])));
    const tp_breaker breaker = make_breaker(v, gate);
    const tp_breaking at = tp_breaking_shape(&breaker, check_turn(v[PHI]));
    const breaking_lost lost = breaking_error_bound(v, &breaker.orbit);
    const double lowest = check_radians(tp_orbit_lowest_phase(&breaker.orbit));
    const double error[6] = {
        apart_mm(at.offset, v[X], v[Y]), 1000 * (check_metres(at.stretch) - v[STRETCH]),
        1000 * (check_metres(at.displacement) - v[DISPLACEMENT]),
        at.orientation * (2 * CHECK_PI / Q32) - v[ORIENTATION],
        check_wrapped(lowest - v[PHI_MIN]), check_metres(gate) - v[GATE],
    };
    const double explained[6] = { 1000 * lost.offset, 1000 * lost.stretch,
                                  1000 * lost.displacement, lost.orientation, lost.lowest,
                                  lost.gate };
    for (unsigned i = 0; i < 6; i++)
        check_add(run, i, row, check_excess(error[i], explained[i]));
}

static int run_breaking(check_run *run)
{
    int code = EXIT_DONE;
    for (unsigned row = 0; !code && row < run->table.n_rows; row++) {
        code = refuse_wide(run, row);
        if (!code)
            breaking_row(run, row, check_row(run, row));
    }
    return code;
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
    .run = run_breaking,
};
