/* SPDX-License-Identifier: MIT */
/* The phase of a wave that comes in over a straight coast, [B8] and [B9] of the models: the
 * integral of sqrt(k(x)^2 - kz^2) towards the shore.  The product k x with the local k is
 * not the integral: its crests would run backwards.
 *
 * The table covers the floor between deep water and the shore.  On both sides of the table
 * the wave number is constant and the phase a straight line.  A node holds the phase and
 * its slope; cubics interpolate between nodes.  The distance of nodes is a power of two: a
 * lookup needs a shift, not a division.  Nodes are at most L/16 apart [B8], L the shortest
 * local wave length, and from one node to the next the depth changes by at most half of
 * the least depth.
 *
 * Near the shore k grows as h^-1/2.  With node distance d and q = d slope / h <= 1/2,
 * Simpson's error is k d q^4 6.6 / 2880 < 6e-5 rad, and the cubic's error is k d q^3 1.9 /
 * 384 < 3e-4 rad.  Both fall as fast as the depth grows.  Of 16000 random phases the worst
 * was off by 1.9e-4 rad.  A grazing wave, kz = k_inf, also feels floors deeper than the
 * table; this effect is left out: 2 e^-12 / slope rad at the most. */
#include <stdbool.h>
#include "base/base.h"
#include "waves/coastal_water.h"
#include "waves/softfloat.h"

#define K_MOST_Q32      ((int64_t)1024 << 32)
#define SIXTEENTH_Q32   1686629713      /* 2^32 2 pi / 16 */
#define DEPTH_MOST_Q32  ((int64_t)1 << 48)
#define BITS_MOST       24

/* The coast with its numbers clamped, and the ends of its table. */
typedef struct {
    tp_scaled k_inf;
    tp_scaled across_squared;   /* k_inf^2 - kz^2 */
    int64_t   depth_q32;        /* depth at x = 0, m; magnitude below 2^47 */
    int64_t   least_q32;
    int64_t   shore_q32;        /* the least depth of the table */
    int64_t   slope_q30;
    tp_fx     x_first, x_last;
} coast_profile;

static int64_t max_int64(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

static int64_t min_int64(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

/* Returns the depth at x, Q32.  x is in halves of 2^-16 m, to have midpoints.  |x| <=
 * 2^32 + 2^24 and slope <= 2^30: 63 bits.  One node past the shore the depth is half of
 * the least depth. */
static int64_t beach_depth(const coast_profile *b, int64_t x_q17)
{
    const int64_t rise = (x_q17 * b->slope_q30 + (1 << 14)) >> 15;
    return max_int64(b->depth_q32 - rise, b->least_q32 / 2);
}

/* Returns the first x where the floor has risen to a depth below 2^48; slope > 0.  The
 * difference of depths is below 1.5 2^32 in 16.16, and its product with 2^30 is below
 * 2^63. */
static tp_fx x_from_depth(const coast_profile *b, int64_t depth_q32)
{
    TP_ASSERT(b->slope_q30 > 0);
    const int64_t rise = (b->depth_q32 - depth_q32) >> 16;
    const int64_t up = rise > 0 ? b->slope_q30 - 1 : 0;
    const int64_t x = (rise * ((int64_t)1 << 30) + up) / b->slope_q30;
    return tp_fx_saturate(x);
}

/* Finds the ends of the table: from the point where the wave begins to feel the floor, to
 * the point where the floor becomes level. */
static void find_table_ends(coast_profile *b, const tp_coast_shape *s)
{
    b->x_first = s->x_from;
    b->x_last = s->x_to > s->x_from ? s->x_to : s->x_from;
    if (b->slope_q30 > 0 && b->k_inf.m != 0) {
        const tp_scaled reach = tp_scaled_mul(tp_scaled_from_fixed(TP_DEPTH_DEEP_Q24, 24),
                                              tp_scaled_recip(b->k_inf));
        const int64_t deep = min_int64(tp_scaled_fixed(reach, 32), DEPTH_MOST_Q32 - 1);
        b->x_first = (tp_fx)max_int64(b->x_first, x_from_depth(b, deep));
        b->x_last = (tp_fx)min_int64(b->x_last, x_from_depth(b, b->least_q32));
    }
    if (b->slope_q30 == 0 || b->k_inf.m == 0 || b->x_first >= b->x_last)
        b->x_first = b->x_last = s->x_from;
    b->shore_q32 = max_int64(beach_depth(b, 2 * (int64_t)b->x_last), b->least_q32);
}

static coast_profile make_coast_profile(const tp_coast_shape *s)
{
    const int64_t k = min_int64(max_int64(s->k_inf_q32, 0), K_MOST_Q32);
    const int64_t kz = max_int64(min_int64(s->kz_q32, k), -k);
    const tp_fx least = s->least > TP_DEPTH_LEAST ? s->least : TP_DEPTH_LEAST;
    coast_profile b = {
        .k_inf = tp_scaled_from_wave_number(k),
        .across_squared = tp_scaled_mul(tp_scaled_from_wave_number(k - kz),
                                        tp_scaled_from_wave_number(k + kz)),
        .depth_q32 = (int64_t)s->depth * 65536,
        .least_q32 = (int64_t)least * 65536,
        .slope_q30 = tp_clamp(s->slope, 0, TP_Q30_ONE),
    };
    find_table_ends(&b, s);
    return b;
}

/* k^2 - kz^2 = (k_inf / sinh kh)^2 + k_inf^2 - kz^2, because k = k_inf / tanh kh.
 * Both terms keep all their bits for a grazing wave, where the difference of k and kz
 * would lose bits. */
static tp_scaled cross_shore_wave_number_squared(const coast_profile *b, int64_t depth_q32)
{
    const tp_scaled h = tp_scaled_from_fixed((uint64_t)depth_q32, 32);
    const tp_scaled x = tp_scaled_mul(tp_depth_wave_number_scaled(b->k_inf, h, 3), h);
    const tp_scaled bent = tp_scaled_mul(b->k_inf, b->k_inf);

    if (tp_scaled_q24(x) >= TP_DEPTH_DEEP_Q24)
        return b->across_squared;
    return tp_scaled_add(tp_scaled_mul(bent, tp_csch_squared(x)), b->across_squared);
}

/* Returns sqrt(k^2 - kz^2) / 2 pi in turns per metre, Q31.32. */
static int64_t cross_shore_turns_per_metre(const coast_profile *b, int64_t depth_q32)
{
    if (b->k_inf.m == 0)
        return 0;
    const tp_scaled across = tp_scaled_sqrt(cross_shore_wave_number_squared(b, depth_q32));
    const tp_scaled over_two_pi = tp_scaled_from_fixed(TP_OVER_TWO_PI_Q32, 32);
    return tp_scaled_fixed(tp_scaled_mul(across, over_two_pi), 32);
}

/* Returns the distance of nodes as a power of two of 2^-16 m; the bounds are in the
 * head of this file. */
static uint32_t node_spacing_bits(const coast_profile *b)
{
    const tp_scaled h = tp_scaled_from_fixed((uint64_t)b->shore_q32, 32);
    const tp_scaled k = tp_depth_wave_number_scaled(b->k_inf, h, 3);
    const tp_scaled part = tp_scaled_mul(tp_scaled_from_fixed(SIXTEENTH_Q32, 32),
                                         tp_scaled_recip(k));
    const int64_t steep = b->shore_q32 * (1 << 13) / b->slope_q30;
    const int64_t most = min_int64(min_int64(tp_scaled_fixed(part, 16), steep),
                                 1 << BITS_MOST);
    return most > 1 ? 31 - (uint32_t)tp_clz((uint32_t)most) : 0;
}

static uint32_t count_nodes(const coast_profile *b, uint32_t bits)
{
    return (((uint32_t)b->x_last - (uint32_t)b->x_first) >> bits) + 2;
}

size_t tp_coast_bytes(const tp_coast_shape *shape)
{
    const coast_profile b = make_coast_profile(shape);
    size_t bytes = sizeof(tp_coast);

    if (b.x_first < b.x_last)
        bytes += count_nodes(&b, node_spacing_bits(&b)) * sizeof(tp_coast_node);
    return (bytes + 7) / 8 * 8;
}

/* The nodes begin where the head ends. */
_Static_assert(sizeof(tp_coast) % _Alignof(tp_coast_node) == 0, "nodes are aligned");

static inline tp_coast_node *coast_nodes(const tp_coast *coast)
{
    return (tp_coast_node *)(coast + 1);
}

static tp_coast_node make_node(int64_t turns, uint32_t rise)
{
    return (tp_coast_node){ (tp_turn)turns, (int32_t)(turns >> 32), rise };
}

static int64_t node_turns(const tp_coast_node *n)
{
    return (int64_t)((uint64_t)(uint32_t)n->turns << 32 | n->part);
}

/* Simpson's rule over each step.  A slope is below 2^40, and slope times step is at most an
 * 11th of a turn: six of them are below 2^47 in Q48. */
static void integrate_phases(tp_coast *coast, const coast_profile *b)
{
    tp_coast_node *const node = coast_nodes(coast);
    const int64_t step = (int64_t)1 << coast->bits, half = TP_FX_ONE / 2;
    int64_t halves = 2 * (int64_t)b->x_first, sum = 0;
    int64_t from = cross_shore_turns_per_metre(b, beach_depth(b, halves));

    for (uint32_t i = 0; i < coast->count; i++) {
        const int64_t rise = (from * step + half) >> 16;
        node[i] = make_node(sum, (uint32_t)rise);
        const int64_t middle =
            cross_shore_turns_per_metre(b, beach_depth(b, halves + step));
        const int64_t to =
            cross_shore_turns_per_metre(b, beach_depth(b, halves + 2 * step));
        sum += ((from + 4 * middle + to) * step + 6 * half) / (6 * TP_FX_ONE);
        halves += 2 * step;
        from = to;
    }
}

/* Interpolates between two nodes, `way` of 2^bits, by the cubic of both phases and both
 * slopes.  All of these numbers are below 2^29, and `way` is below 2^24. */
static int64_t interpolate_phase(const tp_coast *coast, tp_fx x)
{
    const uint32_t way = (uint32_t)x - (uint32_t)coast->x_first;
    TP_ASSERT((way >> coast->bits) + 1 < coast->count);
    const tp_coast_node *const n = coast_nodes(coast) + (way >> coast->bits);
    const int64_t half = ((int64_t)1 << coast->bits) / 2;
    const int64_t t = way & (((uint32_t)1 << coast->bits) - 1);
    const int64_t all = (int32_t)(n[1].part - n[0].part);
    const int64_t r0 = n[0].rise, r1 = n[1].rise;
    int64_t y = r0 + r1 - 2 * all;

    y = 3 * all - 2 * r0 - r1 + ((y * t + half) >> coast->bits);
    y = r0 + ((y * t + half) >> coast->bits);
    return node_turns(n) + ((y * t + half) >> coast->bits);
}

/* Returns gradient x distance.  Gradients are below 2^40 and distances below 2^32: the
 * product is computed in two parts. */
static int64_t phase_from_gradient(int64_t gradient, int64_t distance)
{
    return gradient * (distance >> 16) + ((gradient * (distance & 0xffff) + 0x8000) >> 16);
}

int64_t tp_coast_phase(const tp_coast *coast, tp_fx x)
{
    if (x <= coast->x_first)
        return coast->first
               + phase_from_gradient(coast->rise_first, (int64_t)x - coast->x_first);
    if (x >= coast->x_last)
        return coast->last
               + phase_from_gradient(coast->rise_last, (int64_t)x - coast->x_last);
    return interpolate_phase(coast, x);
}

void tp_coast_init(tp_coast *coast, const tp_coast_shape *shape)
{
    const coast_profile b = make_coast_profile(shape);
    const bool bent = b.x_first < b.x_last;
    const int64_t sea = b.x_first > shape->x_from ? DEPTH_MOST_Q32 - 1
                      : max_int64(beach_depth(&b, 2 * (int64_t)b.x_first), b.least_q32);

    *coast = (tp_coast){
        .x_first = b.x_first, .x_last = b.x_last,
        .rise_first = cross_shore_turns_per_metre(&b, sea),
        .rise_last = cross_shore_turns_per_metre(&b, b.shore_q32),
    };
    if (bent) {
        coast->bits = node_spacing_bits(&b);
        coast->count = count_nodes(&b, coast->bits);
        integrate_phases(coast, &b);
        coast->last = interpolate_phase(coast, b.x_last);
    }
    const int64_t zero = tp_coast_phase(coast, 0);
    coast->first -= zero;
    coast->last -= zero;
    tp_coast_node *const node = coast_nodes(coast);
    for (uint32_t i = 0; i < coast->count; i++)
        node[i] = make_node(node_turns(&node[i]) - zero, node[i].rise);
}
