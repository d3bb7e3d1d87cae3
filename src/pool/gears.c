/* SPDX-License-Identifier: MIT */
/* The step of 8- and 16-bit cells: two gears, [C8]-[C13] of the models.
 *
 * With F the neighbours' sum less four times the height, the centred damping [C4] is
 *     S = (2 - 2^-m) (V + r^2 F / 2),   V' = S - V,   H' = H + V',
 * and all depends on how S is rounded.  Gear A passes each cell's rounding error on to
 * the next: ripples travel far, and the sum of heights is kept.  Gear B rounds towards 0:
 * it never adds energy [C5], so the water settles; when nothing moves any more each
 * height goes one nearer to 0 [C10], until all are.
 *
 * A sponge takes from gear A what the damping of its cells makes of a wave, and so takes
 * the sum with it: waves that are stirred up there left a mean of -13000 LSB of 32767 in
 * 20000 ticks.  So a cell of it is also held by a spring of (delta / 2)^2, which as part
 * of F keeps the theorem of [C5]; a line damped alike in both its quantities does not
 * reflect. With it the mean stays within 200 LSB, and reflections are what they were.
 *
 * Only the sponge needs 64 bits.  With T = 2^11 V + r2q F, S is (2^(m+1) - 1) T /
 * 2^(11+m) to be rounded.  |V| <= 32767 and |F| <= 8 x 32767, so |T| < 2^26 + 767 x 2^18
 * < 2^28. Divided in two steps, first by 2^(m+1), where (2^(m+1) T + w) / 2^(m+1) = T + w
 * / 2^(m+1), the large product is never formed; the floor of a floor is exact.  A literal
 * 2^10 of the second step costs a Cortex-M4 less than the reduced fraction of [C13]; the
 * bits are the same. */
#include "pool/pool.h"
#include "base/base.h"

typedef struct {
    int32_t  rate;          /* r2q */
    uint32_t down;          /* m + 1 */
    int32_t  whole;         /* 2^(11+m) <= 2^21: S's denominator */
} gear;

static gear gear_of(const tp_pool *pool)
{
    return (gear){ (int32_t)tp_pool_r2q(pool), pool->damping + 1,
                   (int32_t)1 << (11 + pool->damping) };
}

/* Gear A: S rounded to nearest, halves away from 0, of T's share and the carry; the error
 * becomes the carry.  It is kept with half of `whole` added, 0 < carry <= whole, so that
 * rounding is a floor; that rounds a tie up, where below 0 it has to go down. */
TP_ALWAYS_INLINE int32_t spread(int32_t t, const gear *g, int32_t *carry)
{
    const int32_t w = *carry - t;
    int32_t s = (t + (w >> g->down)) >> 10;
    int32_t rest = tp_pool_up(t - s * 1024, g->down) + w;

    if (rest == 0 && s <= 0) {
        rest = tp_pool_up(1024, g->down);
        s--;
    }
    *carry = rest;
    return s;
}

/* The same in a sponge, where a cell's own damping `own` is stronger.  The carry stays in
 * units of the field's damping: (2^(m+1) - 2^(m-own)) T fits 39 bits. */
TP_ALWAYS_INLINE int32_t soak(int32_t t, const gear *g, uint32_t own, int32_t *carry)
{
    const int32_t factor = (1 << g->down) - (1 << (g->down - 1 - own));
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

/* Gear B: S cut towards 0. */
TP_ALWAYS_INLINE int32_t cut(int32_t t, const gear *g)
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
