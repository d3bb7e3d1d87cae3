/* SPDX-License-Identifier: MIT */
/* The surface of deep water at a point, [A6]-[A10] and [E1] of the models: the displaced
 * point of a rest point, the compression there, the rest point of a given point, and
 * slopes of a surface known by heights alone. */
#include "base/base.h"
#include "waves/deep_water.h"

/* -- the displaced point ------------------------------------------------------------- */

/* Gerstner waves, [A7]-[A10] of the models; steepness 0 gives plain sines [A1].
 *
 * Normals are the exact normals of [A10], as slopes:  N = (hz Jxz - hx Jzz, det, hx Jxz -
 * hz Jxx), and dy/dx = -Nx/Ny = (hx Jzz - hz Jxz) / det.  The clamp of [A11] keeps the
 * smallest eigenvalue of J at 0.05 or above: det > 0, and the quotient exists.  Gentle
 * seas, with tp_deep_water.crossed false, use N = (-hx, 1 - sum QkA sin th, -hz).  All
 * terms are evaluated at the rest point.  The form printed with the displaced point inside
 * the sine is a different, wrong surface ([A10]).
 *
 * Derivation of the error bounds of normals in deep_water.h.  Errors dh and dJ turn the
 * normal of the slopes g = J^-1 h by |J^-1 (dh - dJ g)| / sqrt(1 + g^2) <= hypot(|dh|,
 * |dJ|) / (1 - q).  Sine and cosine are too small by up to 4.71e-6 of their value and
 * are cut to Q24, and slopes are rounded to 16.16: 1.08e-5 both together.  For one
 * trochoid, J = 1 - S sin and h = S cos.  The error of the cosine has the factor h J /
 * (J^2 + h^2) <= 1/2, the error of the sine h S / (J^2 + h^2) <= S / 2 (1 - S);
 * together 2.36e-6 / (1 - S).  The error of the phase has the factor S / (1 - S), the
 * rate of turn of the normal on the crest. */

tp_surface_point tp_swell_sum_point(const tp_swell_sum *sum, tp_fx x0, tp_fx z0, tp_fx fade)
{
    return tp_swell_sum_point_inline(sum, x0, z0, fade, 1);
}

tp_surface_point tp_deep_water_displace_point(const tp_deep_water *deep,
                                              const tp_turn phases[TP_WAVES], tp_fx x0,
                                              tp_fx z0)
{
    TP_ASSERT(deep->count <= TP_WAVES);
    const bool sharpened = deep->sharpened, crossed = deep->crossed;
    tp_swell_sum sum = { 0 };

    for (const tp_swell *w = deep->swell, *end = w + deep->count; w < end; w++) {
        const tp_turn th = *phases++ + tp_swell_turns(w->turns_x, x0)
                                     + tp_swell_turns(w->turns_z, z0);
        tp_swell_sum_add_swell(&sum, w, th, sharpened, crossed);
    }
    return tp_swell_sum_point_inline(&sum, x0, z0, TP_FX_ONE, crossed);
}

/* -- compression --------------------------------------------------------------------- */

/* The Jacobian of the horizontal displacement: the horizontal compression of the
 * surface. */

/* Bends sum to at most 0.95: the sums fit Q30, and their products fit 64 bits. */
tp_fx tp_deep_water_jacobian(const tp_deep_water *deep, const tp_turn phases[TP_WAVES],
                             tp_fx x0, tp_fx z0)
{
    TP_ASSERT(deep->count <= TP_WAVES);
    int32_t bxx = 0, bxz = 0, bzz = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        if (w->bend == 0)
            continue;
        tp_q30 s = tp_sin(phases[i] + tp_swell_turns(w->turns_x, x0)
                          + tp_swell_turns(w->turns_z, z0));
        bxx += tp_q30_mul(w->bend_xx, s);
        bxz += tp_q30_mul(w->bend_xz, s);
        bzz += tp_q30_mul(w->bend_zz, s);
    }
    int64_t jxx = (int64_t)TP_Q30_ONE - bxx, jzz = (int64_t)TP_Q30_ONE - bzz;
    return (tp_fx)((jxx * jzz - (int64_t)bxz * bxz) >> 44);
}

/* -- the rest point ------------------------------------------------------------------ */

/* The surface above a point of the plane [E1]: finds the rest point p0 with P(p0) = p0 +
 * d(p0) = p, by Newton's method.
 *
 * P is the gradient of |p0|^2/2 + sum (QA/k) sin th.  Its Hessian is the Jacobian J of [A9]
 * with eigenvalues within 1 -+ q, q the sum of QkA.  For q < 1 there is one root.  The root
 * lies within max_displacement of p, in a box around p; the search never leaves the box.
 *
 * A pure Newton step fails if one wave is long and steep, and another wave is far shorter
 * than the distance left.  The local slope of the short wave says nothing about the slope
 * along this distance, where the short wave averages out.  Each wave therefore counts in J
 * with the weight 1 / (1 + 2 (k e)^2), e the present error in metres.  Long waves are
 * solved first, and the step becomes Newton's as e goes to 0.  On 20,000 legal sets of
 * waves at the steepness clamp, seven pure Newton steps, with plain steps where Newton
 * failed, left errors of up to 25 m; seven weighted steps leave rounding errors only. */

#define STEPS 7             /* a last evaluation follows: eight in all */
#define NEAR  2             /* LSB of x and z: the rounding error of a rest point */

typedef struct { tp_fx x, z; } rest_place;

/* Returns the displacement d(p0), and the sine of each swell in Q8.24.  Factors have 25 and
 * 24 bits: sixteen products fit 64 bits. */
static rest_place displacement(const tp_deep_water *deep, const tp_turn phases[TP_WAVES],
                               rest_place rest, int32_t sine[TP_WAVES])
{
    const int64_t half = (int64_t)1 << 23;
    int64_t x = 0, z = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        tp_turn th = phases[i] + tp_swell_turns(w->turns_x, rest.x)
                               + tp_swell_turns(w->turns_z, rest.z);
        int32_t c = tp_cos(th) >> 6;
        sine[i] = tp_sin(th) >> 6;
        x += (int64_t)w->orbit_x * c;
        z += (int64_t)w->orbit_z * c;
    }
    return (rest_place){ (tp_fx)((x + half) >> 24), (tp_fx)((z + half) >> 24) };
}

/* Returns the weight 1 / (1 + 2 (k e)^2) in 16.16 for an error e in 16.16 below 2^11 m.
 * With t = k e / 2 pi the weight is 1 / (1 + 79 t^2).  34 and 27 bits make t.  From 16
 * turns on the wave counts for almost nothing, and 79 t^2 has 47 bits. */
static uint32_t newton_wave_weight(const tp_swell *w, uint32_t error)
{
    uint64_t t = w->turns * error >> 32;
    uint64_t most = t < 16 << 16 ? t : 16 << 16;
    return UINT32_MAX / (uint32_t)((1 << 16) + (79 * most * most >> 16));
}

/* Returns the step against the error e = P(p0) - p: -e over the weighted J, Q4.28.  The
 * eigenvalues of J are 0.05 or more, and det > 0.047; 27 and 30 bits make the numerator. */
static rest_place newton_step_against_error(const tp_deep_water *deep,
                                            const int32_t sine[TP_WAVES],
                                            rest_place position_error)
{
    uint32_t error =
        tp_isqrt64((uint64_t)((int64_t)position_error.x * position_error.x
                              + (int64_t)position_error.z * position_error.z));
    int64_t  bxx = 0, bxz = 0, bzz = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        int64_t s = (int64_t)sine[i] * newton_wave_weight(w, error) >> 16;
        bxx += w->bend_xx * s;
        bxz += w->bend_xz * s;
        bzz += w->bend_zz * s;
    }
    int64_t jxx = (1 << 28) - (bxx >> 26), jzz = (1 << 28) - (bzz >> 26);
    int64_t jxz = -(bxz >> 26), det = (jxx * jzz - jxz * jxz) >> 28;
    TP_ASSERT(det > 0);
    return (rest_place){
        (tp_fx)tp_div_rounded(position_error.z * jxz - position_error.x * jzz, det),
        (tp_fx)tp_div_rounded(position_error.x * jxz - position_error.z * jxx, det)
    };
}

/* The box around p, clipped to the range of 16.16.  Its half side is max_displacement +
 * 2^-16 m, for the rounding of a point. */
typedef struct { rest_place low, high; } box;

static box search_box(const tp_deep_water *deep, tp_fx x, tp_fx z)
{
    const tp_fx reach = deep->max_displacement + 1;
    return (box){ { tp_fx_sub_sat(x, reach), tp_fx_sub_sat(z, reach) },
                  { tp_fx_add_sat(x, reach), tp_fx_add_sat(z, reach) } };
}

static tp_fx clamp_coordinate(int64_t x, tp_fx low, tp_fx high)
{
    return x < low ? low : x > high ? high : (tp_fx)x;
}

static rest_place add_step_in_box(const box *b, rest_place from, rest_place step)
{
    return (rest_place){ clamp_coordinate((int64_t)from.x + step.x, b->low.x, b->high.x),
                    clamp_coordinate((int64_t)from.z + step.z, b->low.z, b->high.z) };
}

static bool is_rounding_error(tp_fx e)
{
    return (uint32_t)(e + NEAR) <= 2 * NEAR;
}

/* Within the box the differences of coordinates fit 32 bits. */
tp_surface_point tp_deep_water_sample(const tp_deep_water *deep,
                                      const tp_turn phases[TP_WAVES], tp_fx x, tp_fx z,
                                      tp_fx rest[2])
{
    const rest_place still = { 0, 0 };
    const box   around = search_box(deep, x, z);
    rest_place at = { x, z };
    int32_t sine[TP_WAVES];

    if (rest)
        at = add_step_in_box(&around, (rest_place){ rest[0], rest[1] }, still);
    for (int n = 0; n < STEPS; n++) {
        rest_place d = displacement(deep, phases, at, sine);
        rest_place e = { at.x - x + d.x, at.z - z + d.z };
        if (is_rounding_error(e.x) && is_rounding_error(e.z))
            break;
        at = add_step_in_box(&around, at, newton_step_against_error(deep, sine, e));
    }
    if (rest) {
        rest[0] = at.x;
        rest[1] = at.z;
    }
    return tp_deep_water_displace_point(deep, phases, at.x, at.z);
}

tp_surface_point tp_deep_water_sample_iterated(const tp_deep_water *deep,
                                               const tp_turn phases[TP_WAVES], tp_fx x,
                                               tp_fx z, uint32_t steps)
{
    rest_place at = { x, z };
    int32_t sine[TP_WAVES];

    for (; steps > 0; steps--) {
        rest_place d = displacement(deep, phases, at, sine);
        at = (rest_place){ tp_fx_sub_sat(x, d.x), tp_fx_sub_sat(z, d.z) };
    }
    return tp_deep_water_displace_point(deep, phases, at.x, at.z);
}

/* -- slopes by central differences --------------------------------------------------- */

/* The five-height normal by central differences, [A6] of the models.  Four triangles meet
 * at a point.  The sum of their normals, before normalisation, contains exactly the central
 * differences: N = (h(x-d) - h(x+d), 2d, h(z-d) - h(z+d)). */

tp_height_slope tp_neighbour_height_slope(tp_fx middle, const tp_fx neighbours[4],
                                          tp_fx spacing)
{
    TP_ASSERT(spacing > 0 && spacing < 8192 * TP_FX_ONE);
    return (tp_height_slope){
        middle,
        tp_fx_div(neighbours[1] - neighbours[0], 2 * spacing),
        tp_fx_div(neighbours[3] - neighbours[2], 2 * spacing),
    };
}

tp_dir3 tp_neighbour_normal(const tp_fx neighbours[4], tp_fx spacing)
{
    TP_ASSERT(spacing > 0 && spacing < 8192 * TP_FX_ONE);
    return tp_normalise(neighbours[0] - neighbours[1], 2 * spacing,
                        neighbours[2] - neighbours[3]);
}
