/* SPDX-License-Identifier: MIT */
/* One drop: fall, impact, bounce, shape; [D1]-[D4] of the models.
 *
 * A step is velocity Verlet with the drag split evenly around the move: half a kick of
 * gravity, half of the drag, the move, half of the drag, half a kick.  Without drag the
 * step is exact.  The drag of half a step, v' = -k v |v|, is solved exactly, v / (1 + k
 * |v| t), and is stable for any k.
 *
 * Impacts are searched in the frame of the water, whose level moves evenly during the
 * tick.  The height over the water is the parabola through both ends with the initial
 * speed. */
#include <stdbool.h>
#include "base/base.h"
#include "features/drops/drops.h"

#define RATE        TP_TICKS_PER_SECOND
#define FALL_MOST   ((int64_t)127 << 24)
#define WATER_MOST  ((int64_t)16 << 24)             /* m/s; a faster level has jumped */
#define DRAG_Q40    ((uint64_t)494780232499)        /* 3 rho_a / 8 = 0.45 */
#define CUBE_ROOT   TP_Q30(0.7937005259840998)      /* 2^(-1/3) */
#define HIGH_MOST   ((int64_t)16384 << 32)          /* m, Q32; the outline fits 16.16 */
#define SQUASH_MOST 8192                            /* 1/2, Q2.14 */

static int32_t clamp_fall_speed(int64_t fall_q24)
{
    return (int32_t)tp_clamp_abs(fall_q24, FALL_MOST);
}

/* Returns n / d rounded half up; d > 0, |n| < 2^62. */
static int64_t divide_rounded(int64_t n, int64_t d)
{
    TP_ASSERT(d > 0);
    int64_t twice = n + (d >> 1), q = twice / d;
    return twice % d < 0 ? q - 1 : q;
}

/* -- fall ---------------------------------------------------------------------------- */

/* Returns k of [D1], 1/m: (rho_a Cd pi r^2 / 2) / (rho 4/3 pi r^3) = 3 rho_a Cd / (8 rho
 * r), Q24.  k is below 2^29 for r = 0.5 mm, the size to which 0.002 m shrinks.  k is
 * clamped to 2^30. */
static uint64_t drag_q24(const tp_scene_drops *config, tp_fx radius)
{
    TP_ASSERT(config->density > 0 && radius > 0);
    if (config->drag <= 0)
        return 0;
    uint64_t k = (uint64_t)config->drag * DRAG_Q40
               / ((uint64_t)config->density * (uint64_t)radius);
    return k < 1 << 30 ? k : 1 << 30;
}

/* Returns v after half a tick of drag.  k |v| < 2^61; divided by 2^24 and 120 it is below
 * 2^31. */
static int64_t apply_half_tick_drag(int64_t v, uint64_t k_q24)
{
    if (k_q24 == 0)
        return v;
    uint64_t size = (uint64_t)(v < 0 ? -v : v);
    uint32_t slower = (1u << 24) + (uint32_t)((k_q24 * size >> 24) / (2 * RATE));
    int      up = tp_clz(slower);
    uint64_t left = size * tp_recip_norm(slower << up) >> (39 - up);
    return v < 0 ? -(int64_t)left : (int64_t)left;
}

/* State of the drop after one tick of free fall, without water. */
typedef struct {
    int64_t high_q32;
    int32_t fall_q24;
} fall;

static fall compute_free_fall(const tp_drop *drop, const tp_scene_drops *config,
                              tp_fx gravity)
{
    int64_t kick = divide_rounded((int64_t)gravity * 256, 2 * RATE);
    uint64_t k = drag_q24(config, drop->radius);
    int64_t  middle = apply_half_tick_drag(drop->fall_q24 - kick, k);

    return (fall){ drop->high_q32 + divide_rounded(middle * 256, RATE),
                   clamp_fall_speed(apply_half_tick_drag(middle, k) - kick) };
}

/* -- impact -------------------------------------------------------------------------- */

/* Motion relative to the water during the tick; index 0 is the start, 1 the end. */
typedef struct {
    int64_t high[2];        /* height over the water, m, Q.32 */
    int64_t speed[2];       /* upward speed over the water, m/s, Q.24 */
    int64_t water;          /* upward speed of the water, m/s, Q.24 */
} crossing;

static int64_t q32(tp_fx x)
{
    return (int64_t)x * 65536;
}

/* Returns the relative motion.  A level that jumps has no speed: a jump must not throw
 * drops. */
static crossing make_relative_motion(const tp_drop *drop, const fall *to, tp_fx level)
{
    tp_fx   before = drop->level == TP_DROP_NEW ? level : drop->level;
    int64_t water = ((int64_t)level - before) * (256 * RATE);

    if (water > WATER_MOST || water < -WATER_MOST) {
        before = level;
        water = 0;
    }
    return (crossing){
        .high = { drop->high_q32 - q32(before), to->high_q32 - q32(level) },
        .speed = { drop->fall_q24 - water, to->fall_q24 - water },
        .water = water,
    };
}

/* Returns the time in the tick, 16.16, at which the parabola with high[0] >= 0 > high[1]
 * falls through 0.  The terms are below 2^35, so products with 17 bits of time fit. */
static int32_t find_crossing_time(const crossing *c)
{
    TP_ASSERT(c->high[0] >= 0 && c->high[1] < 0);
    int64_t slope = divide_rounded(c->speed[0] * 256, RATE);
    int64_t bend = c->high[1] - c->high[0] - slope;
    int32_t above = 0, below = TP_FX_ONE;

    while (below - above > 1) {
        int32_t t = (above + below) / 2;
        if (c->high[0] + ((slope + (bend * t >> 16)) * t >> 16) >= 0)
            above = t;
        else
            below = t;
    }
    return above;
}

/* Returns the share of the impact's energy lost by the drop: 1 - e^2 / 2, as m' = m / 2
 * [D3]. */
static uint64_t lost_energy_share(const tp_scene_drops *config)
{
    return TP_FX_ONE - (((uint64_t)config->bounce * (uint64_t)config->bounce) >> 17);
}

static int bit_length(uint64_t x)
{
    return x >> 32 ? 64 - tp_clz((uint32_t)(x >> 32)) : x ? 32 - tp_clz((uint32_t)x) : 0;
}

/* Returns the 32 highest bits of x and subtracts the number of dropped bits from *shift. */
static uint64_t keep_top_bits(uint64_t x, int *shift)
{
    int out = bit_length(x) > 32 ? bit_length(x) - 32 : 0;
    *shift -= out;
    return x >> out;
}

/* Returns the energy [D3]: (2 pi / 3) (rho r) (r u)^2 (1 - e^2 / 2), `speed` u in Q24.  r
 * u is below 2^31.2 in Q24 and rho r below 2^45.4 in Q32.  At most 45 bits are dropped,
 * so `down` stays above 0.  The result saturates: 2^16 J and more give TP_FX_MAX. */
static tp_fx energy_lost(const tp_scene_drops *config, uint64_t radius, uint64_t speed)
{
    const uint64_t two_thirds_pi = 34315;                       /* Q14 */
    uint64_t way = radius * speed >> 16;
    int      down = 48 + 32 - 24;
    uint64_t square = keep_top_bits(way * way, &down);
    uint64_t heavy = keep_top_bits((uint64_t)config->density * radius, &down);
    uint64_t lost_q24 = square * heavy >> down;

    if (lost_q24 >> 40)
        return TP_FX_MAX;
    lost_q24 = lost_q24 * lost_energy_share(config) >> 16;
    uint64_t lost = (lost_q24 * two_thirds_pi + (1 << 21)) >> 22;
    return lost < TP_FX_MAX ? (tp_fx)lost : TP_FX_MAX;
}

/* Returns [D4] with [D3] and L = 8 r substituted, Q24:
 *     A0 = u sqrt(eff (1 - e^2 / 2)) sqrt(rho r / (36 rho_w g));
 * the roots are below 1 and 1.7, in Q31 and Q29. */
static int32_t ring_height(const tp_scene_drops *config, tp_fx gravity, uint64_t radius,
                           uint64_t speed)
{
    uint64_t taken = (uint64_t)config->efficiency * lost_energy_share(config);     /* Q32 */
    uint64_t heavy = ((uint64_t)config->density * radius << 18)             /* Q50 */
                   / (36000 * (uint64_t)gravity);
    uint64_t roots = (uint64_t)tp_isqrt64(taken << 30) * tp_isqrt64(heavy << 24) >> 30;
    uint64_t height = (roots * speed + (1 << 29)) >> 30;
    return height < INT32_MAX ? (int32_t)height : INT32_MAX;
}

static tp_impact make_impact(const tp_drop *drop, const tp_scene_drops *config,
                             tp_fx gravity, int64_t speed, int64_t time)
{
    uint64_t radius = (uint64_t)drop->radius, size = (uint64_t)speed;
    int32_t  height_q24 = ring_height(config, gravity, radius, size);
    tp_fx    height = (tp_fx)(((int64_t)height_q24 + 128) >> 8);
    tp_fx    most = drop->radius * 4 / 7;                       /* L / 14 */

    return (tp_impact){
        .x = drop->place.x, .z = drop->place.z, .time = time,
        .amplitude = height < most ? height : most,
        .uncapped_q24 = height_q24,
        .length = 8 * drop->radius,
        .lost = energy_lost(config, radius, size),
    };
}

/* Returns the state at the end of the tick after a bounce with `speed`, relative to the
 * water.  `left`: the rest of the tick, 16.16.  A drop that would come down again within
 * the tick waits on the water; its next impact is at most as fast as its rise. */
static fall bounced(int64_t speed, tp_fx gravity, int64_t left, const crossing *c)
{
    int64_t rise = divide_rounded(speed * left, RATE << 8)
                 - (divide_rounded((int64_t)gravity * left * left, 2 * RATE * RATE) >> 16);
    int64_t after = speed - divide_rounded((int64_t)gravity * left, RATE << 8);

    return (fall){ rise > 0 ? rise : 0,
                   clamp_fall_speed(c->water + (after > -speed ? after : -speed)) };
}

/* -- shape --------------------------------------------------------------------------- */

/* Returns `full_value` x |speed| / full_speed; the quotient is at most 1.  `speed` is in
 * Q24 m/s, `full_speed` in whole m/s. */
static int32_t scale_by_speed(int64_t speed, int32_t full_speed, int32_t full_value)
{
    int64_t q16 = (speed < 0 ? -speed : speed) >> 8;
    return q16 >= full_speed * TP_FX_ONE ? full_value
                                         : (int32_t)(q16 * full_value / full_speed >> 16);
}

/* Advances the shape: a damped spring, about three oscillations per second, around the
 * squash for the current speed. */
static void step_squash(tp_drop *drop)
{
    int32_t rest = scale_by_speed(drop->fall_q24, 12, 6000);

    drop->squash_speed += ((rest - drop->squash + 4) >> 3)
                        - ((drop->squash_speed + 2) >> 2);
    drop->squash = tp_clamp(drop->squash + drop->squash_speed, -SQUASH_MOST, SQUASH_MOST);
}

static void flatten(tp_drop *drop, int64_t speed)
{
    drop->squash = -scale_by_speed(speed, 6, SQUASH_MOST);
    drop->squash_speed = 0;
}

/* -- the step ------------------------------------------------------------------------ */

/* Moves the drop.  Heights above HIGH_MOST are clamped; they need a change of gravity in
 * flight. */
static void apply_fall(tp_drop *drop, const fall *to)
{
    drop->high_q32 = to->high_q32 < HIGH_MOST ? to->high_q32 : HIGH_MOST;
    drop->fall_q24 = to->fall_q24;
    drop->place.y = (tp_fx)((drop->high_q32 + (1 << 15)) >> 16);
}

/* Handles an impact: the drop comes down through the surface, [D2]. */
static void handle_impact(tp_drop *drop, const tp_scene_drops *config, tp_fx gravity,
                          const crossing *c, uint64_t tick, tp_impact *impact)
{
    int64_t t = find_crossing_time(c);
    int64_t speed = -(c->speed[0] + ((c->speed[1] - c->speed[0]) * t >> 16));

    if (speed < 0)
        speed = 0;
    *impact = make_impact(drop, config, gravity, speed, (int64_t)((tick - 1) * 65536) + t);
    fall to = bounced(speed * config->bounce >> 16, gravity, TP_FX_ONE - t, c);
    to.high_q32 += q32(drop->level);
    apply_fall(drop, &to);
    flatten(drop, speed);
    drop->radius = tp_q30_mul(drop->radius, CUBE_ROOT);
    if (++drop->impacts >= (uint32_t)config->impacts)
        drop->radius = 0;
}

bool tp_drop_step(tp_drop *drop, const tp_scene_drops *config, tp_fx gravity,
                  tp_fx level, uint64_t tick, tp_impact *impact)
{
    TP_ASSERT(tick > 0 && impact != NULL);
    if (drop->radius <= 0)
        return false;
    if (gravity < TP_FX(0.1))
        gravity = TP_FX(0.1);               /* lower bound in the parameter table */
    fall     to = compute_free_fall(drop, config, gravity);
    crossing c = make_relative_motion(drop, &to, level);

    drop->last = drop->place;
    drop->level = level;
    if (c.high[1] < 0 && c.high[0] >= 0) {
        handle_impact(drop, config, gravity, &c, tick, impact);
        return true;
    }
    if (c.high[1] < 0) {                    /* under water all the time: lifted out */
        to.high_q32 = q32(level);
        to.fall_q24 = (int32_t)(to.fall_q24 > c.water ? to.fall_q24 : c.water);
    }
    apply_fall(drop, &to);
    step_squash(drop);
    return false;
}

/* -- validation of a state from outside ---------------------------------------------- */

static bool is_magnitude_within(int64_t x, int64_t limit)
{
    return x >= -limit && x <= limit;
}

/* True if the drop is in range.  The spring's speed loses a quarter per tick and gains at
 * most 1777. */
bool tp_drop_is_valid(const tp_drop *drop)
{
    return is_magnitude_within(drop->place.x, TP_DROP_FAR)
           && is_magnitude_within(drop->place.z, TP_DROP_FAR)
           && drop->last.x == drop->place.x && drop->last.z == drop->place.z
           && is_magnitude_within(drop->high_q32, HIGH_MOST)
           && is_magnitude_within(drop->last.y, HIGH_MOST >> 16)
           && drop->place.y == (tp_fx)((drop->high_q32 + (1 << 15)) >> 16)
           && is_magnitude_within(drop->fall_q24, FALL_MOST) && drop->radius > 0
           && drop->radius <= TP_FX_ONE && is_magnitude_within(drop->squash, SQUASH_MOST)
           && is_magnitude_within(drop->squash_speed, SQUASH_MOST);
}
