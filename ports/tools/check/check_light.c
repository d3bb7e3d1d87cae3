/* SPDX-License-Identifier: MIT */
/* tidepool check: Fresnel reflectance, light of rough water, rays at the surface, exposure;
 * [F1]-[F4], [F8], [V1], [V2] and [V5]. */
#include <math.h>
#include "check.h"
#include "features/exposure/exposure.h"
#include "shade/optics.h"
#include "shade/rough_lobe.h"

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

/* -- rough water --------------------------------------------------------------------- */

static const check_field rough_columns[] = {
    SHARE("cos_v"), { .name = "slope_variance", .high = 1 }, SHARE("F_mean"),
};

static uint32_t check_q24(double x)
{
    return (uint32_t)lround(x * (1 << 24));
}

static void each_fresnel_rough(check_run *run, unsigned row, const double *v)
{
    const tp_rough_view view = tp_rough_view_make(0, check_q24(v[1]));
    const int32_t nv = tp_rough_view_cosine((int32_t)lround(fmin(v[0], 1) * 16384), &view);
    check_add(run, 0, row, tp_fresnel((tp_q30)nv << 16) / Q30 - v[2]);
}

/* The table is the fit [V2]; the engine draws the mean of the exact law over the slopes that
 * are seen, within 0.001.  The fit differs from that mean by up to 0.09, most for grazing
 * views of steep slopes. */
const check_model check_fresnel_rough = {
    CHECK_ALL(rough_columns),
    .notes = { { .text = "[V2] mean Fresnel of a rough sea: cos of the view to the mean "
                         "normal, slope variance of what is not drawn along the view" } },
    .quantities = { { "mean share", "", 0.09 } },
    .each = each_fresnel_rough,
};

static const check_field lobe_columns[] = {
    { .name = "n", .low = 1, .high = 1000 }, { .name = "slope_variance", .high = 1 },
    SHARE("rv"), { .name = "n_eff", .high = 1000 }, SHARE("value"),
};

/* Looks the lobe up as the light's stage does: in the table of the smooth lobe, which has
 * 1024 entries of 8 bits.  An exponent of 500 falls by 40 % from entry to entry. */
static void each_lobe(check_run *run, unsigned row, const double *v)
{
    static tp_entry16 shine[TP_SHINE + 1];
    const int32_t part = tp_rough_narrowing((uint32_t)v[0], check_q24(v[1]));
    const tp_rough_lobe lobe = { .across = part, .along = part, .peak = part };
    const int32_t rv = (int32_t)lround(fmin(v[2], 1) * 16384);
    const int32_t at = tp_rough_lobe_cosine(&lobe, rv, 0);

    tp_shade_shine(shine, check_fx(v[0]), TP_FX_ONE);
    const double here = shine[at >> 4], next = shine[(at + 15) >> 4];
    check_add(run, 0, row, check_percent(v[0] * part / 16384, v[3]));
    check_add(run, 1, row,
              (here + (next - here) * (at & 15) / 16) * part / (256 * 16384.0) - v[4]);
}

const check_model check_lobe = {
    CHECK_ALL(lobe_columns),
    .notes = { { .text = "[V1] Phong lobe of exponent n over slopes of variance s2 "
                         "an axis: n_eff = n/(1+4 n s2), value = (n_eff/n) rv^n_eff" } },
    .quantities = { { "exponent", "%", 1 }, { "value", "", 0.05 } },
    .each = each_lobe,
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
