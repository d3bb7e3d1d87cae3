/* SPDX-License-Identifier: MIT */
/* Interface between the parts of coastal water.  coastal_init.c, coastal_tables.c and
 * coastal_map.c make the tables; coastal_water.c and coastal_surf.c read them. */
#ifndef TP_WAVES_COASTAL_TABLES_H
#define TP_WAVES_COASTAL_TABLES_H
#include "base/base.h"
#include "waves/coastal_water.h"

/* -- points and directions ----------------------------------------------------------- */

/* A horizontal unit vector. */
typedef struct {
    tp_q30 x, z;
} tp_way;

tp_way tp_way_from_degrees(tp_fx heading_degrees);
tp_fx  tp_way_project(tp_way way, tp_fx x, tp_fx z);    /* m along `way`; saturates */

static inline tp_q30 tp_way_dot(tp_way a, tp_way b)
{
    return (tp_q30)(((int64_t)a.x * b.x + (int64_t)a.z * b.z + (1 << 29)) >> 30);
}

/* Interpolates from a to b; `part` is Q16.  b - a must fit an int32_t. */
static inline int32_t tp_coastal_mix(int32_t a, int32_t b, int32_t part)
{
    return a + (int32_t)(((int64_t)(b - a) * part + 0x8000) >> 16);
}

/* -- depths of the tables ------------------------------------------------------------ */

/* Eight depths an octave (32 for phases).  The leading bits of h give the node, the next
 * bits the fraction: a look-up needs neither a root nor a division. */

#define TP_COASTAL_FIRST 12     /* 1/16 m is 2^12 in 16.16 ... */
#define TP_COASTAL_LAST  27     /* ... and 2048 m is 2^27 */

/* True if waves with this stretch may overhang: only where the floor rises. */
static inline bool tp_can_overhang(tp_fx stretch, tp_fx slope, bool mapped)
{
    return stretch > 0 && (slope > 0 || mapped);
}

typedef struct {
    uint32_t depth, phase;                      /* next shallower nodes */
    int32_t  depth_fraction, phase_fraction;    /* fractions to the next node, Q16 */
} tp_coastal_table_place;

/* Returns the table position of a depth > 0. */
static inline tp_coastal_table_place tp_coastal_table_find(tp_fx h)
{
    TP_ASSERT(h > 0);
    if (h < 1 << TP_COASTAL_FIRST)
        return (tp_coastal_table_place){ 0, 0, h * 16, h * 16 };
    if (h >= 1 << TP_COASTAL_LAST)
        return (tp_coastal_table_place){ TP_COASTAL_DEPTHS - 2, TP_COASTAL_PHASES - 2,
                                         TP_FX_ONE, TP_FX_ONE };
    const int zeros = tp_clz((uint32_t)h);
    const uint32_t octave = (uint32_t)(31 - zeros - TP_COASTAL_FIRST);
    const uint32_t rest = (uint32_t)h << zeros << 1;    /* without the leading one */
    return (tp_coastal_table_place){ 1 + 8 * octave + (rest >> 29),
                             1 + 32 * octave + (rest >> 27), (int32_t)(rest << 3 >> 16),
                             (int32_t)(rest << 5 >> 16) };
}

/* Returns the depth of node i with 2^bits nodes an octave. */
static inline tp_fx tp_coastal_node_depth(uint32_t i, int octave_bits)
{
    TP_ASSERT(i <= TP_COASTAL_PHASES && (octave_bits == 3 || octave_bits == 5));
    if (i == 0)
        return 0;
    const uint32_t in = (i - 1) & ((1u << octave_bits) - 1),
                   octave = (i - 1) >> octave_bits;
    return (tp_fx)(((1u << octave_bits) + in)
                   << (TP_COASTAL_FIRST - octave_bits + (int)octave));
}

/* -- orbits and breaking ------------------------------------------------------------- */

/* Sx and Sy of [B12], 8.24.  Sx is about 2^7 at 1/16 m with the default rates.  Unusual
 * rates are bounded: Sx is clamped to 2^13 and Sy to 2. */
typedef struct {
    int64_t x_q24, y_q24;
} tp_orbit_scale;
tp_orbit_scale tp_orbit_scale_make(tp_fx depth, tp_fx widening_decay,
                                   tp_fx flattening_decay);

/* Returns e^-K h as Q0.32. */
uint32_t tp_orbit_depth_decay(tp_fx rate, tp_fx depth);

/* Returns sqrt(1 - s^2). */
tp_q30 tp_cos_of_sin(tp_q30 sin);

/* Returns the offset of an orbit at a phase.  Along the direction of travel the semi-axis
 * `up` counts at most as `along`: with Q < 1 `up` may be longer, and k along bounds the
 * horizontal Jacobian [B13]. */
static inline tp_offset tp_orbit_offset(const tp_ellipse *o, tp_turn phi)
{
    const int32_t a = tp_q30_mul(o->along, tp_sin(phi));
    const tp_q30 cos = tp_cos(phi);
    const int32_t b = -tp_q30_mul(o->up, cos);

    if (o->sin == 0)
        return (tp_offset){ a, b };
    const int32_t level = o->up <= o->along ? b : -tp_q30_mul(o->along, cos);
    return (tp_offset){ tp_q30_mul(a, o->cos) - tp_q30_mul(level, o->sin),
                        tp_q30_mul(a, o->sin) + tp_q30_mul(b, o->cos) };
}

/* The least H / h where the gate may begin to open, with full noise: 0.6 / 1.5. */
#define TP_COASTAL_RATIO_LEAST TP_FX(0.3999)

/* -- noise: noise.c; breaking depth: coastal_water.c --------------------------------- */

/* Value noise in -1..1, 16.16: random heights at integer u and v, smooth interpolation.  u
 * and v are Q16; u repeats after 2^16 cells, v after 8 cells. */
tp_fx tp_noise(uint32_t u_q16, uint32_t v_q16, uint32_t seed);

/* Returns the depth, m, up to which crests foam by breaking alone.  In
 * deeper water crests foam where the surface is compressed. */
tp_fx tp_coastal_breaking_foam_depth(const tp_coastal_water *coastal);

/* -- means over time and noise: coastal_surf.c ---------------------------------------- */

/* The surf at a depth: mean of tp_coastal_point.breaking over its most, 16.16, below 1; and
 * the mean of |y|, m, an upper bound. */
typedef struct {
    tp_fx breaking, lift;
} tp_coastal_surf;
tp_coastal_surf tp_coastal_mean_surf(const tp_coastal_water *coastal, tp_fx depth);

/* -- construction: coastal_tables.c, coastal_map.c ----------------------------------- */

/* Inputs of a wave's tables. */
typedef struct {
    int64_t k_inf_q32;
    int64_t kz_q32;             /* wave number along a straight shore [B9] */
    tp_way  way;
    tp_fx   amplitude, reach;   /* A and QA in deep water, m */
    tp_fx   length;
    bool    surging;            /* [B20]: orbits do not widen over a straight floor */
} tp_coastal_swell;

/* Returns k at a depth; depths below 1/16 m count as 1/16 m.  k is below 29 rad/m for
 * waves of 0.25 m. */
static inline int64_t tp_coastal_local_wave_number(int64_t k_inf_q32, tp_fx depth)
{
    return tp_depth_wave_number_exact(k_inf_q32,
                                      depth < TP_DEPTH_LEAST ? TP_DEPTH_LEAST : depth);
}

/* Converts a wave number to turns per metre, Q31.32.  k < 2^5: the product fits. */
static inline int64_t tp_coastal_turns_per_metre(int64_t k_q32)
{
    return (k_q32 * 42722830 + (1 << 27)) >> 28;        /* 2^28 / 2 pi */
}

/* Returns x y / 2^30 for an x of any size; within two units. */
static inline int64_t tp_coastal_scale_q30(int64_t x, tp_q30 y)
{
    return ((x >> 16) * y >> 14) + ((x & 0xffff) * y >> 30);
}

/* Wave vector k over a floor that rises towards `up`: by Snell's law [B9] the component
 * along the depth contours stays.  up = (0, 0): no change of direction. */
typedef struct {
    int64_t x_q32, z_q32;
} tp_coastal_wave_number;
tp_coastal_wave_number tp_coastal_wave_vector(const tp_coastal_swell *swell, tp_way up,
                                              int64_t k_q32);

/* Tables begin where the head ends. */
_Static_assert(sizeof(tp_coastal_water) % _Alignof(tp_coastal_table) == 0,
               "tables are aligned");

static inline tp_coastal_table *tp_coastal_tables(const tp_coastal_water *coastal)
{
    return (tp_coastal_table *)(coastal + 1);
}

static inline void *tp_coastal_at_byte(const tp_coastal_water *coastal, size_t offset)
{
    return (char *)(uintptr_t)coastal + offset;
}

tp_coastal_floor_node *tp_coastal_floor_nodes(const tp_coastal_water *coastal);
tp_coastal_wave_node *tp_coastal_wave_nodes(const tp_coastal_water *coastal,
                                            const tp_coastal_wave *wave);

/* Make the table of swell i, and its phases over a straight floor. */
void tp_coastal_make_table(tp_coastal_water *coastal, uint32_t i,
                           const tp_coastal_swell *swell,
                           const tp_coastal_config *config);
void tp_coastal_make_phases_by_depth(tp_coastal_water *coastal, uint32_t i,
                                     const tp_coastal_swell *swell);

/* At each depth: if the steepness of all waves adds up to more than 0.951, scales the
 * horizontal axes of the orbits to a sum of 0.95.  Heights stay. */
void tp_coastal_limit_steepness_sum(tp_coastal_water *coastal);

/* tp_coastal_floor_tilt_sine_bound returns the sine of the steepest tilt over a map,
 * Q14. tp_coastal_add_bounds adds the bounds of a swell, whose table and phases must
 * exist, to the bounds of the coastal water. */
int32_t tp_coastal_floor_tilt_sine_bound(const tp_coastal_water *coastal);
void tp_coastal_add_bounds(tp_coastal_water *coastal, uint32_t i, int32_t tilt_sine_bound);

/* coastal_map.c: the nodes of a map.  `scratch_turns` is memory for one phase per node. */
void tp_coastal_make_floor_nodes(tp_coastal_water *coastal, const tp_floor *floor);
void tp_coastal_make_wave_nodes(tp_coastal_water *coastal, uint32_t i,
                                const tp_coastal_swell *swell, int64_t *scratch_turns);
tp_q30 tp_coastal_beach_slope(const tp_coastal_water *coastal, tp_fx amplitude);

#endif
