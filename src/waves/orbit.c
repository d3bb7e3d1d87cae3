/* SPDX-License-Identifier: MIT */
/* The orbit of a particle in coastal water, [B11]-[B13] and [B16]-[B19] of the models:
 * an ellipse that flattens and tilts over the floor, and its crest where the wave
 * breaks. */
#include "waves/coastal_tables.h"
#include "waves/softfloat.h"

/* -- orbits over a floor ------------------------------------------------------------- */

/* Elliptic orbits over a floor, [B11]-[B13] of the models: circles that flatten towards the
 * floor and tilt with the floor.
 *
 * Only a floor that rises along the direction of travel tilts the orbits: no wave breaks
 * backwards.  Sx grows without bound towards the shore.  The major axis is clamped to 0.95
 * / k, where the surface would fold into loops; Sy uses the ratio before the clamp. */

#define AXIS_MAX TP_FX(0.95)
#define R_MAX    TP_FX(64)      /* m; times Sx, 2^37 in 8.24: 59 bits */

static tp_fx clamp_depth(tp_fx depth)
{
    return depth < TP_DEPTH_LEAST ? TP_DEPTH_LEAST : depth;
}

uint32_t tp_orbit_depth_decay(tp_fx rate, tp_fx depth)
{
    const int64_t x = ((int64_t)(rate > 0 ? rate : 0) * clamp_depth(depth) + 0x80) >> 8;
    return x >= (int64_t)23 << 24 ? 0 : tp_exp_neg((uint32_t)x);
}

/* The exponentials are within 2^-30.  1 - e^-Kx h is at least 0.0068 with the usual rates
 * and has a relative error below 2^-22. */
tp_orbit_scale tp_orbit_scale_make(tp_fx depth, tp_fx widening_decay,
                                   tp_fx flattening_decay)
{
    const int64_t one = (int64_t)1 << 32, most = (int64_t)1 << 37, two = 1 << 25;
    const int64_t lack_x = one - tp_orbit_depth_decay(widening_decay, depth);
    const int64_t lack_y = one - tp_orbit_depth_decay(flattening_decay, depth);
    const int64_t x = ((one << 24) + lack_x / 2) / lack_x;
    const int64_t y = ((lack_y << 24) + lack_x / 2) / lack_x;

    return (tp_orbit_scale){ x < most ? x : most, y < two ? y : two };
}

tp_q30 tp_cos_of_sin(tp_q30 sin)
{
    TP_ASSERT(tp_abs(sin) <= TP_Q30_ONE);
    return (tp_q30)tp_isqrt64(((uint64_t)1 << 60) - (uint64_t)((int64_t)sin * sin));
}

/* Returns 0.95 / k, saturated. */
static tp_fx max_semi_axis(int64_t k_q32)
{
    if (k_q32 <= 0)
        return TP_FX_MAX;
    const int64_t most = ((int64_t)AXIS_MAX << 32) / k_q32;
    return tp_fx_saturate(most);
}

tp_ellipse tp_orbit_ellipse(tp_fx r, tp_fx depth, tp_turn floor_angle, int64_t k_q32,
                            tp_fx tilt_decay, tp_fx widening_decay,
                            tp_fx flattening_decay)
{
    const tp_fx most = max_semi_axis(k_q32);
    const tp_fx held = tp_clamp(r, 0, most < R_MAX ? most : R_MAX);
    const tp_orbit_scale s = tp_orbit_scale_make(depth, widening_decay, flattening_decay);
    const int64_t half = 1 << 23;
    const int64_t along = (held * s.x_q24 + half) >> 24;
    const tp_q30 rise = tp_sin(floor_angle);
    const tp_q30 fall =
        (tp_q30)((tp_orbit_depth_decay(tilt_decay, depth) + (uint64_t)2) >> 2);
    const tp_q30 sin = rise > 0 ? tp_q30_mul(rise, fall) : 0;

    return (tp_ellipse){
        .along = along < most ? (tp_fx)along : most,
        .up = (tp_fx)((held * s.y_q24 + half) >> 24),
        .sin = sin, .cos = tp_cos_of_sin(sin),
    };
}

tp_offset tp_orbit_evaluate(const tp_ellipse *orbit, tp_turn phi)
{
    return tp_orbit_offset(orbit, phi);
}

/* -- breaking crests ----------------------------------------------------------------- */

/* The shape of a breaking crest, [B16]-[B19] of the models.
 *
 * p is the phase counted from the lowest point of the orbit: p < 0 is the front face, p >
 * 0 the back, +-half a turn the crest.  The crest is stretched along the tilt of its
 * orbit.  The top of the crest is the last third of a turn in front and the last
 * sixteenth of a turn behind.  The top also moves out along an angle that falls from the
 * tilt to 45 degrees below horizontal.  All quantities are continuous, with kinks at the
 * joints, as in the source. */

#define FRONT 715827883         /* pi / 3 as turns Q0.32 */
#define BACK  0x70000000        /* 7 pi / 8 */
#define DOWN  (-0x20000000)     /* -pi / 4 */

tp_fx tp_breaking_gate(tp_fx height_over_depth)
{
    const tp_fx x = tp_clamp(height_over_depth, TP_FX(0.6), TP_FX(0.78)) - TP_FX(0.6);
    return tp_smoothstep(tp_fx_mul(x, TP_FX(5.5555556)));
}

tp_turn tp_orbit_lowest_phase(const tp_ellipse *orbit)
{
    return 0u - tp_atan2(tp_q30_mul(orbit->along, orbit->sin),
                         tp_q30_mul(orbit->up, orbit->cos));
}

/* Returns the ramp of a phase, Q30: 0 between the joints, 1 at the crest.  The ramp in
 * front is a third of a turn long, the ramp behind a sixteenth: factors 3/4 and 4
 * convert Q32 to Q30. */
static tp_q30 crest_ramp(int32_t phase)
{
    if (phase < -FRONT)
        return (tp_q30)(((uint64_t)(-(int64_t)phase - FRONT) * 3) >> 2);
    return phase > BACK ? (phase - BACK) * 4 : 0;
}

/* Returns (p / pi)^2 as Q30; |p| <= 2^31. */
static tp_q30 half_turns_squared(int32_t phase)
{
    const uint64_t size = phase < 0 ? 0u - (uint32_t)phase : (uint32_t)phase;
    return (tp_q30)((size * size + 0x80000000u) >> 32);
}

tp_breaking tp_breaking_shape(const tp_breaker *breaker, tp_turn phi)
{
    TP_ASSERT(breaker->kept_stretch >= 0 && breaker->kept_stretch <= TP_FX_ONE);
    TP_ASSERT(breaker->kept_lip >= 0 && breaker->kept_lip <= TP_FX_ONE);
    const tp_ellipse *orbit = &breaker->orbit;
    const int32_t p = (int32_t)(phi - tp_orbit_lowest_phase(orbit));
    const tp_q30 ramp = crest_ramp(p);
    const int32_t tilt = (int32_t)tp_atan2(orbit->sin, orbit->cos);
    tp_breaking at = {
        .p = p,
        .stretch = tp_q30_mul(breaker->stretch, half_turns_squared(p)),
        .displacement = tp_q30_mul(breaker->lip, ramp),
        .orientation = tilt + tp_q30_mul(DOWN - tilt, ramp),
        .offset = tp_orbit_offset(orbit, phi),
    };
    const tp_fx stretch = tp_fx_mul(at.stretch, breaker->kept_stretch);
    const tp_fx lip = tp_fx_mul(at.displacement, breaker->kept_lip);

    at.offset.along += tp_q30_mul(stretch, orbit->cos)
                     + tp_q30_mul(lip, tp_cos((tp_turn)at.orientation));
    at.offset.up += tp_q30_mul(stretch, orbit->sin)
                  + tp_q30_mul(lip, tp_sin((tp_turn)at.orientation));
    return at;
}
