/* SPDX-License-Identifier: MIT */
/* tidepool check: Fresnel reflectance, rays at the surface, exposure; [F1]-[F4] and
 * [F8]. */
#include <math.h>
#include "check.h"
#include "features/exposure/exposure.h"
#include "shade/optics.h"

#define Q30 1073741824.0

#define SHARE(n) { .name = n, .high = CHECK_ONE }

/* -- Fresnel ------------------------------------------------------------------------- */

static const check_field fresnel_columns[] = {
    SHARE("cos_i"), SHARE("Rs"), SHARE("Rp"), SHARE("R_exact"), SHARE("R_schlick"),
};

static void each_fresnel(check_run *run, unsigned row, const double *v)
{
    const tp_q30 c = check_q30(v[0]);
    check_add(run, 0, row, tp_fresnel(c) / Q30 - v[3]);
    check_add(run, 1, row, tp_fresnel_schlick(c) / Q30 - v[4]);
}

const check_model check_fresnel = {
    CHECK_ALL(fresnel_columns),
    .notes = { { .text = "[F1][F2] air 1.000293 -> water 1.3333; Schlick R0=0.02037" } },
    .quantities = { { "exact", "", 0.002 }, { "Schlick", "", 0.002 } },
    .each = each_fresnel,
};

/* -- rays ---------------------------------------------------------------------------- */

static const check_field ray_columns[] = {
    CHECK_UNIT("ix"), CHECK_UNIT("iy"), CHECK_UNIT("iz"), CHECK_UNIT("nx"),
    CHECK_UNIT("ny"), CHECK_UNIT("nz"), CHECK_UNIT("rx"), CHECK_UNIT("ry"),
    CHECK_UNIT("rz"), CHECK_UNIT("tx"), CHECK_UNIT("ty"), CHECK_UNIT("tz"),
    { .name = "d", .high = 8000 },                          /* m, depth of a floor */
    { .name = "offx", .low = -32768, .high = 32768 },       /* m, where 16.16 saturates */
    { .name = "offz", .low = -32768, .high = 32768 },
};

static tp_dir3 direction(const double *v)
{
    return (tp_dir3){ check_q30(v[0]), check_q30(v[1]), check_q30(v[2]) };
}

/* Returns the largest difference of the three components. */
static double apart(tp_dir3 got, const double *want)
{
    return fmax(fabs(got.x / Q30 - want[0]),
                fmax(fabs(got.y / Q30 - want[1]), fabs(got.z / Q30 - want[2])));
}

/* Returns the bound of the offset's error, m; the offset along x is d x / -y.  The unit
 * vector is rounded to 2^-26, and d to 16.16; flatter rays have larger errors. */
static double offset_lost(double d, double x, double z)
{
    const double off = hypot(x, z);
    return d > 0 ? (d + off * off / d) / 67108864 + check_share(d) * off : 0;
}

static void each_ray(check_run *run, unsigned row, const double *v)
{
    const tp_dir3 in = direction(v), normal = direction(v + 3);
    const tp_dir3 refracted = tp_refract(in, normal);
    const tp_floor_offset at = tp_refract_offset(refracted, check_fx(v[12]));
    check_add(run, 0, row, apart(tp_reflect(in, normal), v + 6));
    check_add(run, 1, row, apart(refracted, v + 9));
    const double off = fmax(fabs(check_metres(at.x) - v[13]),
                            fabs(check_metres(at.z) - v[14]));
    check_add(run, 2, row, check_excess(off, offset_lost(v[12], v[13], v[14])));
}

const check_model check_reflect_refract = {
    CHECK_ALL(ray_columns),
    .notes = { { .text = "[F3][F4] I incident (towards surface), eta=1/1.333; offx,offz"
                         " = bottom hit offset at depth d along T (m)" } },
    .quantities = { { "reflected", "", 0.001 }, { "refracted", "", 0.001 },
                    { "floor offset", "m", 0.001 } },
    .each = each_ray,
};

/* -- exposure ------------------------------------------------------------------------ */

static const check_field exposure_columns[] = {
    { .name = "tick", .high = 1e9, .kind = CHECK_WHOLE },
    { .name = "mean_brightness", .high = 1000 },
    { .name = "target", .high = 8 * CHECK_ONE },
    { .name = "exposure", .high = 8 * CHECK_ONE },
};

static const check_field exposure_numbers[] = {
    { .name = "e0", .low = 0.125, .high = 8 }, { .name = "rate", .high = 1 },
};

/* Compares one run from tick 0: each exposure depends on the exposures before. */
static int run_exposure(check_run *run)
{
    tp_fx exposure = check_fx(run->lines[0][0][0]);
    const tp_fx rate = check_fx(run->lines[0][0][1]);
    for (unsigned row = 0; row < run->table.n_rows; row++) {
        const double *v = check_row(run, row);
        if (v[0] != row)
            return check_refuse(run, row, "tick %g; expected %u", v[0], row);
        exposure = tp_exposure_step(exposure, check_fx(v[1]), rate);
        check_add(run, 0, row, check_metres(exposure) - v[3]);
    }
    return EXIT_DONE;
}

const check_model check_exposure = {
    CHECK_ALL(exposure_columns),
    .notes = { { "[F8] e0=%, rate % per tick, target=clamp(0.5/mean,1/8,8)",
                 CHECK_ALL(exposure_numbers), false } },
    .quantities = { { "exposure", "", 0.001 } },
    .run = run_exposure,
};
