/* SPDX-License-Identifier: MIT */
/* The boat's attitude on the water, [E2] and [E3].
 *
 * Four points of the hull sample the water: bow, stern, port and starboard.  The
 * attitude, tp_boat_attitude, is three lengths: heave is the mean of the four heights,
 * rise is bow minus stern, tilt is port minus starboard.  Pitch is the angle of rise over
 * length, roll of tilt over beam.  A kinematic boat takes the water's own attitude, or
 * approaches it as in [D6]: x += (x* - x)(1 - exp(-dt / tau)).
 *
 * A dynamic boat is four equal columns, one under each point, 2 draft high and half
 * immersed at rest: m_i = rho A_i draft, F_i = rho g A_i clamp(y_surf - y_i, 0, 2 draft)
 * - m_i g - c v_i.  With e_i, the water height over the point's waterline,
 *     a_i = omega^2 clamp(e_i, -draft, draft) - 2 zeta omega v_i,  omega^2 = g / draft.
 * The columns' inertia about the middle is m (length / 2)^2 / 2 for pitch and m
 * (beam / 2)^2 / 2 for roll, so heave" = mean a_i, rise" = a_bow - a_stern,
 * tilt" = a_port - a_starboard.  Mass and area cancel; all three oscillate at the same
 * omega.
 *
 * Steps are semi-implicit with centred damping, as [C4], in metres per step:
 *     v' = q v + (1 + q)/2 K e,  x' = x + v',  K = (omega dt)^2,
 *     q = (1 - zeta omega dt) / (1 + zeta omega dt), not below 0.
 * e uses the water at the end of the step; [E3] uses the water one tick earlier.  While
 * no point is wholly in or out of still water, the energy v^2/2 + K x (x -
 * v)/2, x measured from rest, never grows [C3]; the energy is positive for omega dt < 2.
 * For zeta >= 1 nothing overshoots: (1 - omega dt)/(1 + omega dt) is at most critical.  A
 * boat that leaps out of the water and back has no such bound.  Without drag its energy
 * varies: in 300 throws of 5000 steps up to 87-fold at omega dt = 0.745, 1.09-fold at
 * 0.1.  [E3] asks for omega dt < 1.  Here a tick is split into steps of omega dt <= 1/8.
 * The worst case of the parameter table, g = 100 m/s^2 over a draft of 0.05 m, is 0.745
 * per tick: 6 steps. */
#include "base/base.h"
#include "features/boat/boat.h"
#include "waves/softfloat.h"

#define GRAVITY_MOST (100 * TP_FX_ONE)
#define DRAFT_LEAST  TP_FX(0.05)
#define DRAFT_MOST   (20 * TP_FX_ONE)
#define DRAG_MOST    (2 * TP_FX_ONE)
#define ATTITUDE_MAX     ((int64_t)4096 << 40)  /* above the highest water, fits 16.16 */
#define SPEED_MOST   ((int64_t)64 << 40)    /* per tick */
#define SUNK_MOST    (256 * TP_FX_ONE)

/* Thresholds of rest: within 1/4 LSB of 16.16, and slower than 1/4096 of the distance per
 * tick.  The slowest boat's omega dt is 1/848. */
#define STILL      (1 << 22)
#define STILL_TICK (1 << 10)

/* Returns x q / 2^32 rounded towards zero: the magnitude of a speed always falls.
 * |x| < 2^62. */
static int64_t scale_towards_zero(int64_t x, uint32_t q)
{
    TP_ASSERT(x > -((int64_t)1 << 62) && x < (int64_t)1 << 62);
    uint64_t size = (uint64_t)(x < 0 ? -x : x);
    uint64_t part = (size >> 32) * q + ((size & 0xffffffff) * q >> 32);
    return x < 0 ? -(int64_t)part : (int64_t)part;
}

/* Computes the water's own attitude, Q40 m.  The result is exact, also the mean's
 * quarter. */
static void compute_water_attitude(const tp_fx water[4], int64_t aim[3])
{
    int64_t sum = (int64_t)water[TP_BOW] + water[TP_STERN] + water[TP_PORT]
                + water[TP_STARBOARD];

    aim[0] = sum * (1 << 22);
    aim[1] = ((int64_t)water[TP_BOW] - water[TP_STERN]) * (1 << 24);
    aim[2] = ((int64_t)water[TP_PORT] - water[TP_STARBOARD]) * (1 << 24);
}

void tp_boat_snap_attitude(tp_boat_attitude *attitude, const tp_fx water[4])
{
    compute_water_attitude(water, attitude->at);
    for (int k = 0; k < 3; k++)
        attitude->speed[k] = 0;
}

/* -- kinematic ----------------------------------------------------------------------- */

/* Returns 1 - exp(-dt / tau), Q0.32.  dt / tau = 2^48 / (60 tau) in Q32.  The exponential
 * uses 24 of the fraction bits; the factor 1 - x uses the remaining 8. */
static uint32_t smoothing_factor(tp_fx tau)
{
    TP_ASSERT(tau > 0);
    uint64_t x = ((uint64_t)1 << 48) / (TP_TICKS_PER_SECOND * (uint64_t)tau);
    uint64_t left = x >> 32 >= 23 ? 0 : tp_exp_neg((uint32_t)(x >> 8));

    return (uint32_t)(0xffffffff - left + (left * (x & 0xff) >> 32));
}

/* Moves the attitude by the share k towards the water's.  Rounding stops the motion less
 * than 2^32 / k LSB from its aim: 601 LSB for the longest tau, or 2^-30 m.  The rounding
 * to 16.16 removes the difference. */
static void smooth_attitude(tp_boat_attitude *attitude, tp_fx tau, const tp_fx water[4])
{
    int64_t  aim[3];
    uint32_t k = smoothing_factor(tau);

    compute_water_attitude(water, aim);
    for (int i = 0; i < 3; i++) {
        attitude->at[i] += scale_towards_zero(aim[i] - attitude->at[i], k);
        attitude->speed[i] = 0;
    }
}

/* -- dynamic ------------------------------------------------------------------------- */

/* Oscillation constants.  `steps`: steps per tick; `keep`: q of a step, Q0.32; `kick`:
 * share of the push added to the speed per tick, n (1 + q) K / 2, Q0.32. */
typedef struct {
    int32_t  steps;
    uint32_t keep, kick;
} swing;

/* Returns (omega dt)^2 of a tick = g / (3600 draft) < 0.5556, Q0.32.  g 2^32 is below
 * 2^55. */
static uint64_t spring_constant(tp_fx gravity, tp_fx draft)
{
    TP_ASSERT(gravity >= 0 && draft > 0);
    const uint64_t ticks = TP_TICKS_PER_SECOND * TP_TICKS_PER_SECOND;
    return ((uint64_t)gravity << 32) / (ticks * (uint64_t)draft);
}

/* Returns q.  Without drag a step loses only 2^-32 of the speed. */
static uint32_t damping_factor(uint64_t spring, tp_fx drag)
{
    const uint64_t one = 0xffffffff;
    uint64_t root = tp_isqrt64(spring << 32);
    uint64_t loss = root * (uint64_t)drag >> 16;

    return loss >= one ? 0 : (uint32_t)(((one - loss) << 32) / (one + 1 + loss));
}

static swing compute_oscillation(const tp_scene *scene)
{
    tp_fx    draft = tp_clamp(scene->boat.draft, DRAFT_LEAST, DRAFT_MOST);
    uint64_t tick = spring_constant(tp_clamp(scene->water.gravity, 0, GRAVITY_MOST), draft);
    uint64_t n = 1;

    while (64 * tick > n * n << 32)         /* omega dt > n / 8? */
        n++;
    uint32_t keep =
        damping_factor(tick / (n * n), tp_clamp(scene->boat.drag, 0, DRAG_MOST));
    uint64_t kick = tick / n * (((uint64_t)keep + 0x100000000) >> 1);
    return (swing){ (int32_t)n, keep, (uint32_t)(kick >> 32) };
}

/* Computes the pushes on heave, rise and tilt, Q40 m of water.  The waterline of the bow
 * lies half a rise above the heave, of the stern half a rise below; likewise port and
 * starboard. */
static void compute_push(const tp_boat_attitude *attitude, tp_fx draft,
                         const tp_fx water[4], int64_t push[3])
{
    int64_t half_rise = attitude->at[1] / 2, half_tilt = attitude->at[2] / 2;
    const int64_t over[4] = { half_rise, half_rise - attitude->at[1], half_tilt,
                              half_tilt - attitude->at[2] };
    int64_t e[4];

    for (int i = 0; i < 4; i++) {
        int64_t immersion = water[i] * ((int64_t)1 << 24) - attitude->at[0] - over[i];
        e[i] = tp_clamp_abs(immersion, (int64_t)draft << 24);
    }
    push[0] = (e[TP_BOW] + e[TP_STERN] + e[TP_PORT] + e[TP_STARBOARD]) / 4;
    push[1] = e[TP_BOW] - e[TP_STERN];
    push[2] = e[TP_PORT] - e[TP_STARBOARD];
}

static bool are_magnitudes_within(const int64_t x[3], int64_t limit)
{
    return x[0] <= limit && x[1] <= limit && x[2] <= limit
        && x[0] >= -limit && x[1] >= -limit && x[2] >= -limit;
}

/* Advances the attitude by one step.  Near rest the step ends exactly at rest: the push
 * is then the remaining distance. */
static void step_oscillation(tp_boat_attitude *attitude, const swing *s, tp_fx draft,
                             const tp_fx water[4])
{
    TP_ASSERT(s->steps > 0 && draft > 0);
    int64_t push[3];

    compute_push(attitude, draft, water, push);
    bool at_rest = are_magnitudes_within(push, STILL)
                   && are_magnitudes_within(attitude->speed, STILL_TICK);
    for (int i = 0; i < 3; i++) {
        int64_t speed = scale_towards_zero(attitude->speed[i], s->keep)
                        + scale_towards_zero(push[i], s->kick);
        attitude->speed[i] = at_rest ? 0 : tp_clamp_abs(speed, SPEED_MOST);
        attitude->at[i] += at_rest ? push[i] : attitude->speed[i] / s->steps;
        attitude->at[i] = tp_clamp_abs(attitude->at[i], ATTITUDE_MAX);
    }
}

/* ----------------------------------------------------------------------------------- */

void tp_boat_step_attitude(tp_boat_attitude *attitude, const tp_scene *scene,
                           const tp_fx water[4])
{
    if (scene->boat.mode == TP_BOAT_DYNAMIC) {
        const swing s = compute_oscillation(scene);
        for (int n = 0; n < s.steps; n++)
            step_oscillation(attitude, &s, scene->boat.draft, water);
    } else if (scene->boat.smooth > 0) {
        smooth_attitude(attitude, scene->boat.smooth, water);
    } else {
        tp_boat_snap_attitude(attitude, water);
    }
}

void tp_boat_set_immersion(tp_hull *hull, const tp_boat_attitude *attitude,
                           const tp_fx water[4])
{
    int64_t aim[3];

    compute_water_attitude(water, aim);
    for (int k = 0; k < 3; k++)
        hull->immersion[k] = tp_clamp(tp_fx_of_q40(aim[k] - attitude->at[k]), -SUNK_MOST,
                                 SUNK_MOST);
}

/* True if the attitude is in range.  The water's own attitude may be twice the highest
 * water, equal to ATTITUDE_MAX. */
bool tp_boat_attitude_is_valid(const tp_boat_attitude *attitude)
{
    return are_magnitudes_within(attitude->at, ATTITUDE_MAX)
           && are_magnitudes_within(attitude->speed, SPEED_MOST);
}

bool tp_boat_immersion_is_valid(const tp_hull *hull)
{
    bool valid = true;

    for (int k = 0; k < 3; k++)
        valid =
            valid && hull->immersion[k] >= -SUNK_MOST && hull->immersion[k] <= SUNK_MOST;
    return valid;
}
