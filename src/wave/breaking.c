/* SPDX-License-Identifier: MIT */
/* The shape of a breaking crest, [B16]-[B19] of the models.
 *
 * p is the phase counted from the lowest point of the orbit: p < 0 is the front face, p >
 * 0 the back, +-half a turn the crest.  The crest is stretched along the tilt of its
 * orbit.  The top of the crest is the last third of a turn in front and the last
 * sixteenth of a turn behind.  The top also moves out along an angle that falls from the
 * tilt to 45 degrees below horizontal.  All quantities are continuous, with kinks at the
 * joints, as in the source. */
#include "wave/ocean_tables.h"

#define FRONT 715827883         /* pi / 3 as turns Q0.32 */
#define BACK  0x70000000        /* 7 pi / 8 */
#define DOWN  (-0x20000000)     /* -pi / 4 */

tp_fx tp_breaking_gate(tp_fx height_over_depth)
{
    const tp_fx x = tp_clamp(height_over_depth, TP_FX(0.6), TP_FX(0.78)) - TP_FX(0.6);
    return tp_smoothstep(tp_fx_mul(x, TP_FX(5.5555556)));
}

tp_turn tp_orbit_lowest(const tp_ellipse *orbit)
{
    return 0u - tp_atan2(tp_q30_mul(orbit->along, orbit->sin),
                         tp_q30_mul(orbit->up, orbit->cos));
}

/* Returns the ramp of a phase, Q30: 0 between the joints, 1 at the crest.  The ramp in
 * front is a third of a turn long, the ramp behind a sixteenth: factors 3/4 and 4
 * convert Q32 to Q30. */
static tp_q30 crest_ramp(int32_t p)
{
    if (p < -FRONT)
        return (tp_q30)(((uint64_t)(-(int64_t)p - FRONT) * 3) >> 2);
    return p > BACK ? (p - BACK) * 4 : 0;
}

/* Returns (p / pi)^2 as Q30; |p| <= 2^31. */
static tp_q30 phase_square(int32_t p)
{
    const uint64_t size = p < 0 ? 0u - (uint32_t)p : (uint32_t)p;
    return (tp_q30)((size * size + 0x80000000u) >> 32);
}

tp_breaking tp_breaking_shape(const tp_breaker *breaker, tp_turn phi)
{
    TP_ASSERT(breaker->kept_stretch >= 0 && breaker->kept_stretch <= TP_FX_ONE);
    TP_ASSERT(breaker->kept_lip >= 0 && breaker->kept_lip <= TP_FX_ONE);
    const tp_ellipse *orbit = &breaker->orbit;
    const int32_t p = (int32_t)(phi - tp_orbit_lowest(orbit));
    const tp_q30 ramp = crest_ramp(p);
    const int32_t tilt = (int32_t)tp_atan2(orbit->sin, orbit->cos);
    tp_breaking at = {
        .p = p,
        .stretch = tp_q30_mul(breaker->stretch, phase_square(p)),
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
