/* SPDX-License-Identifier: MIT */
/* The step of 8- and 16-bit cells, with two ways of rounding, called gears,
 * [C8]-[C13] of the models.
 *
 * F is the sum of the four neighbours less four times the height.  The
 * centred damping [C4] is
 *     S = (2 - 2^-m) (V + r^2 F / 2),   V' = S - V,   H' = H + V',
 * and the behaviour depends on the rounding of S.  Gear A passes the rounding error of each
 * cell on to the next cell: ripples travel far, and the sum of heights is kept.  Gear B
 * rounds towards 0: it never adds energy [C5], and the water settles.  When nothing moves
 * any more, each tick takes all heights one step nearer to 0 [C10], until all are 0.
 *
 * In a sponge, gear A does not keep the sum: the stronger damping absorbs part of a wave
 * and its sum with it.  Waves started in a sponge left a mean of -13000 LSB of 32767 in
 * 20000 ticks.  Each sponge cell is therefore also pulled to 0 by a spring of (delta /
 * 2)^2.  The spring is part of F, and the theorem of [C5] still holds.  A line with equal
 * damping of both its quantities does not reflect.  With the spring the mean stays within
 * 200 LSB, and the reflections do not change.
 *
 * Only the sponge needs 64 bits.  With T = 2^11 V + r2q F, S is (2^(m+1) - 1) T / 2^(11+m),
 * rounded.  |V| <= 32767 and |F| <= 8 x 32767: |T| < 2^26 + 767 x 2^18 < 2^28.  The
 * division takes two steps.  The first divides by 2^(m+1), where (2^(m+1) T + w) / 2^(m+1)
 * = T + w / 2^(m+1): the large product is never formed, and a floor of a floor is exact.
 * The second divides by 2^10.  This literal costs a Cortex-M4 less than the reduced
 * fraction of [C13], and the bits are the same. */
#include "base/base.h"
#include "pool/pool.h"

typedef struct {
    int32_t  rate;          /* r2q */
    uint32_t down;          /* m + 1 */
    int32_t  whole;         /* denominator of S: 2^(11+m) <= 2^21 */
} gear;

static gear make_step_constants(const tp_pool *pool)
{
    return (gear){ (int32_t)tp_pool_clamped_courant_sq_q10(pool), pool->damping + 1,
                   (int32_t)1 << (11 + pool->damping) };
}

/* Gear A: rounds S + carry to nearest, halves away from 0; the error becomes the new carry.
 * The carry is stored with half of `whole` added, 0 < carry <= whole, to make the rounding
 * a floor.  A floor rounds a tie up; below 0 a tie has to go down, and the last lines
 * correct the result. */
TP_ALWAYS_INLINE int32_t damp_and_round(int32_t t, const gear *g, int32_t *carry)
{
    const int32_t w = *carry - t;
    int32_t s = (t + (w >> g->down)) >> 10;
    int32_t rest = tp_pool_shift_left(t - s * 1024, g->down) + w;

    if (rest == 0 && s <= 0) {
        rest = tp_pool_shift_left(1024, g->down);
        s--;
    }
    *carry = rest;
    return s;
}

/* Gear A in a sponge, where the damping `cell_damping` of the cell is stronger.  The
 * carry stays in units of the damping of the field: (2^(m+1) - 2^(m-own)) T fits 39
 * bits. */
TP_ALWAYS_INLINE int32_t damp_and_round_in_sponge(int32_t t, const gear *g,
                                                  uint32_t cell_damping, int32_t *carry)
{
    const int32_t factor = (1 << g->down) - (1 << (g->down - 1 - cell_damping));
    const int64_t y = (int64_t)factor * t + *carry;
    int32_t s = (int32_t)(y >> (10 + g->down));
    int32_t rest = (int32_t)(y - (int64_t)s * g->whole);

    if (rest == 0 && s <= 0) {
        rest = g->whole;
        s--;
    }
    *carry = rest;
    return s;
}

/* Gear B: truncates S towards 0. */
TP_ALWAYS_INLINE int32_t damp_and_truncate(int32_t t, const gear *g)
{
    const int32_t w = (t >> 31 & (g->whole - 1)) - t;
    return (t + (w >> g->down)) >> 10;
}

#define CELL    int8_t
#define PAIR    tp_pool_pair_8
#define NAME(x) x##_8
#define FULL    TP_FULL_8
#include "pool/gears.inc"

#define CELL    int16_t
#define PAIR    tp_pool_pair_16
#define NAME(x) x##_16
#define FULL    TP_FULL_16
#include "pool/gears.inc"
