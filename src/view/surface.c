/* SPDX-License-Identifier: MIT */
/* The water surface of all wave models together; see the header.
 *
 * The surface above a given position is found by inverting the horizontal displacement
 * [E1].  Deep water uses its own Newton steps.  The tables of coastal water have no
 * derivatives; the search is p0 <- p0 + (p - P(p0)) with a memory of one step (Anderson
 * mixing): the part of the last step that minimises the error along the line of the last
 * two errors is taken back.  On 32,000 positions with steepness sums up to 0.9, deep and
 * over a beach, twelve steps left at most 0.3 mm; plain steps, with an error of q^n for a
 * sum q, left 0.29 m. */
#include "view/wave_models.h"

#define STEPS 12
#define CLOSE 4         /* LSB of 16.16, 0.06 mm */
#define REACH TP_FX(511)/* m; the most without overhangs is 0.95 x 2000 / 2 pi = 303 */
#define MIX   (4 * 256) /* largest part of a step taken back or repeated, Q8 */

static void add_height_slope(tp_height_slope *sum, tp_height_slope more)
{
    sum->height += more.height;
    sum->slope_x += more.slope_x;
    sum->slope_z += more.slope_z;
}

tp_height_slope tp_rings_pools_sample(const tp_surface *surface, tp_fx x, tp_fx z)
{
    tp_height_slope sum = { 0, 0, 0 };

    if (surface->rings)
        sum = surface->by->rings->height_slope(surface->ring, surface->rings, x, z);
    if (surface->pool)
        add_height_slope(&sum, surface->by->pools->height_slope(
                                   surface->pool, surface->pool_kind, x, z, surface->lag));
    if (surface->field)
        add_height_slope(&sum, surface->by->pools->height_slope(
                                   surface->field, surface->field_kind, x, z, surface->lag));
    return sum;
}

tp_height_slope tp_rings_pools_sample_faded(const tp_surface *surface, tp_fx x, tp_fx z,
                                            tp_fx weight)
{
    TP_ASSERT(weight >= 0 && weight <= TP_FX_ONE);
    if (weight == 0)
        return (tp_height_slope){ 0, 0, 0 };
    tp_height_slope relief = tp_rings_pools_sample(surface, x, z);
    if (weight == TP_FX_ONE)
        return relief;
    return (tp_height_slope){ tp_fx_mul(relief.height, weight),
                              tp_fx_mul(relief.slope_x, weight),
                              tp_fx_mul(relief.slope_z, weight) };
}

/* Returns a bound of the height: each ring adds at most 4 m, a pool at most its range. */
static tp_fx rings_pools_height_bound(const tp_surface *surface)
{
    int64_t sum = 0;

    for (uint32_t i = 0; i < surface->rings; i++)
        sum += (surface->ring[i].gain_q24 >> 8) + 1;
    if (surface->pool)
        sum += surface->by->pools->highest(surface->pool);
    if (surface->field)
        sum += surface->by->pools->highest(surface->field);
    return (tp_fx)(sum < 1024 * TP_FX_ONE ? sum : 1024 * TP_FX_ONE);
}

tp_fx tp_surface_displacement_bound(const tp_surface *surface)
{
    return surface->coastal ? surface->by->coastal->max_displacement(surface->coastal)
                            : surface->deep->max_displacement;
}

tp_fx tp_surface_height_bound(const tp_surface *surface)
{
    tp_fx waves = surface->coastal ? surface->by->coastal->height(surface->coastal)
                                   : surface->deep->height;
    return waves + rings_pools_height_bound(surface);
}

/* A search along an axis: position, last error, step after that error. */
typedef struct {
    tp_fx   at;
    int64_t error, step;
} axis_search;

/* Moves the search.  The root lies within `max_displacement` of the target, and the search
 * stays within `max_displacement` too; at the ends of 16.16 the search stays there. */
static void step_search(axis_search *s, int64_t error, int64_t mixing_q8, tp_fx target,
                        tp_fx max_displacement)
{
    int64_t step = error - mixing_q8 * (s->step + error - s->error) / 256;
    int64_t off = tp_clamp_abs(s->at + step - target, max_displacement);
    tp_fx   to = tp_fx_saturate(target + off);

    s->step = (int64_t)to - s->at;
    s->error = error;
    s->at = to;
}

/* Returns the part of the step to take back, Q8.  Errors are below REACH + 303 m, 2^25.7,
 * so products have 54.4 bits, and 256 times the sum of two products fits. */
static int64_t anderson_factor(const axis_search *u, const axis_search *w, int64_t dx,
                               int64_t dz)
{
    int64_t ux = dx - u->error, uz = dz - w->error, over = ux * ux + uz * uz;
    int64_t by = over > 0 ? (dx * ux + dz * uz) * 256 / over : 0;

    return by > MIX ? MIX : by < -MIX ? -MIX : by;
}

/* Finds the surface point of coastal water, without slopes: they are differences
 * (set_coastal_slopes), because waves over a floor have no closed form. */
static tp_surface_point sample_coastal_without_slopes(const tp_surface *surface, tp_fx x,
                                                      tp_fx z, tp_fx rest[2])
{
    tp_fx most = tp_coastal_max_displacement(surface->coastal),
          max_displacement = most < REACH ? most : REACH;
    axis_search u = { x, 0, 0 }, w = { z, 0, 0 };
    tp_coastal_point at;

    step_search(&u, (int64_t)rest[0] - x, 0, x,
                max_displacement); /* limited to the box */
    step_search(&w, (int64_t)rest[1] - z, 0, z, max_displacement);
    at = tp_coastal_displace_no_overhang(surface->coastal, surface->phases, u.at, w.at);
    for (int n = 0; n < STEPS; n++) {
        int64_t dx = (int64_t)x - at.position.x, dz = (int64_t)z - at.position.z;
        if (dx < CLOSE && dx > -CLOSE && dz < CLOSE && dz > -CLOSE)
            break;
        int64_t by = n > 0 ? anderson_factor(&u, &w, dx, dz) : 0;
        step_search(&u, dx, by, x, max_displacement);
        step_search(&w, dz, by, z, max_displacement);
        at = tp_coastal_displace_no_overhang(surface->coastal, surface->phases, u.at, w.at);
    }
    rest[0] = u.at;
    rest[1] = w.at;
    return (tp_surface_point){ .position = at.position };
}

/* Computes slopes from points 1/32 m away, an eighth of the shortest wave. */
static void set_coastal_slopes(const tp_surface *surface, tp_surface_point *at,
                               const tp_fx rest[2])
{
    const tp_fx d = TP_FX_ONE / 32;
    const tp_fx way[4][2] = { { -d, 0 }, { d, 0 }, { 0, -d }, { 0, d } };
    tp_vec3 p[4];

    for (int k = 0; k < 4; k++)
        p[k] = tp_coastal_displace_no_overhang(surface->coastal, surface->phases,
                               tp_fx_add_sat(rest[0], way[k][0]),
                               tp_fx_add_sat(rest[1], way[k][1])).position;
    tp_slopes_from_tangents(tp_vec3_sub(p[1], p[0]), tp_vec3_sub(p[3], p[2]), &at->slope_x,
                     &at->slope_z);
}

tp_surface_point tp_surface_coastal_sample(const tp_surface *surface, tp_fx x, tp_fx z,
                                           tp_fx rest[2])
{
    TP_ASSERT(surface->coastal != NULL && rest != NULL);
    tp_surface_point at = sample_coastal_without_slopes(surface, x, z, rest);
    set_coastal_slopes(surface, &at, rest);
    return at;
}

tp_surface_point tp_surface_sample(const tp_surface *surface, tp_fx x, tp_fx z,
                                   tp_fx rest[2])
{
    tp_fx from[2] = { x, z };
    tp_surface_point at = { .position = { x, 0, z } };

    if (!rest)
        rest = from;
    if (surface->coastal)
        at = surface->by->coastal->above(surface, x, z, rest);
    else if (surface->by->swells && surface->by->samples)
        at = surface->by->samples->above(surface->deep, surface->phases, x, z, rest);
    if (tp_surface_has_rings_or_pools(surface)) {
        tp_height_slope relief = tp_rings_pools_sample(surface, x, z);
        at.position.y += relief.height;
        at.slope_x += relief.slope_x;
        at.slope_z += relief.slope_z;
    }
    return at;
}

/* A divisor of slopes and 2^63 over its upper 32 bits. */
typedef struct {
    uint64_t n;
    uint32_t reciprocal;
    int      zeros;             /* before its highest bit */
} slope_divisor;

static slope_divisor make_slope_divisor(uint64_t n)
{
    TP_ASSERT(n > 0);
    const uint32_t high = (uint32_t)(n >> 32);
    const int zeros = high ? tp_clz(high) : 32 + tp_clz((uint32_t)n);

    return (slope_divisor){ n, tp_recip_norm((uint32_t)(n << zeros >> 32)), zeros };
}

/* Returns 2^16 n / divisor, rounded to 0, exactly; |n| < 8 divisor and |n| <= 2^40.  The
 * dividend has 83 - zeros bits at most; its upper 32 bits times the reciprocal are the
 * quotient, below 2^19, with 12 bits of fraction that are within 2^3, so one step corrects
 * it.  A 64-bit division is long on processors with 32 bits. */
static tp_fx divide_slope(int64_t n, const slope_divisor *by)
{
    const uint64_t whole = (uint64_t)(n < 0 ? -n : n) << 16;
    const int down = 51 - by->zeros;
    const uint32_t upper = (uint32_t)(down >= 0 ? whole >> down : whole << -down);
    int32_t quotient = (int32_t)((uint64_t)upper * by->reciprocal >> 44);
    const int64_t rest = (int64_t)(whole - (uint64_t)quotient * by->n);

    if (rest < 0)
        quotient--;
    else if ((uint64_t)rest >= by->n)
        quotient++;
    return n < 0 ? -quotient : quotient;
}

/* Computes N = along_z x along_x, with the directions of the grid's rows and columns; a
 * slope is -N / N.y.  N.y has a lower limit, so an overhang gets the steepest slope. */
void tp_slopes_from_tangents(tp_vec3 along_x, tp_vec3 along_z, tp_fx *slope_x,
                             tp_fx *slope_z)
{
    int64_t nx = (int64_t)along_z.y * along_x.z - (int64_t)along_z.z * along_x.y;
    int64_t ny = (int64_t)along_z.z * along_x.x - (int64_t)along_z.x * along_x.z;
    int64_t nz = (int64_t)along_z.x * along_x.y - (int64_t)along_z.y * along_x.x;
    int64_t most = (nx < 0 ? -nx : nx) + (nz < 0 ? -nz : nz);

    for (; most > (int64_t)1 << 40; most >>= 1) {
        nx /= 2;
        ny /= 2;
        nz /= 2;
    }
    if (ny * 8 <= most)             /* also if all three components are 0 */
        ny = most / 8 + 1;
    const slope_divisor by = make_slope_divisor((uint64_t)ny);
    *slope_x = divide_slope(-nx, &by);
    *slope_z = divide_slope(-nz, &by);
}

tp_surface_point tp_surface_displaced(const tp_surface *surface, tp_fx x, tp_fx z)
{
    const struct tp_water_samples *samples = surface->by->samples;

    return samples ? samples->displaced(surface->deep, surface->phases, x, z)
                   : (tp_surface_point){ .position = { x, 0, z } };
}

tp_vec3 tp_surface_displace(const tp_surface *surface, tp_fx x, tp_fx z)
{
    return surface->coastal
               ? surface->by->coastal->smooth(surface->coastal, surface->phases, x, z)
                     .position
               : tp_surface_displaced(surface, x, z).position;
}

tp_surface_point tp_surface_coastal_near(const tp_surface *s, tp_fx x, tp_fx z, tp_fx off[2])
{
    const tp_fx d = TP_FX_ONE / 32, x0 = tp_fx_add_sat(x, off[0]),
                z0 = tp_fx_add_sat(z, off[1]);
    const tp_vec3 at = tp_surface_displace(s, x0, z0);
    const tp_vec3 east = tp_surface_displace(s, tp_fx_add_sat(x0, d), z0);
    const tp_vec3 south = tp_surface_displace(s, x0, tp_fx_add_sat(z0, d));
    tp_surface_point p = { .position = at };

    tp_slopes_from_tangents(tp_vec3_sub(east, at), tp_vec3_sub(south, at), &p.slope_x,
                            &p.slope_z);
    off[0] = tp_fx_sub_sat(x0, at.x);
    off[1] = tp_fx_sub_sat(z0, at.z);
    return p;
}

tp_fx tp_surface_rough_height(const tp_surface *surface, tp_fx x, tp_fx z)
{
    tp_vec3 first = tp_surface_displace(surface, x, z);
    tp_fx level = tp_surface_displace(surface, 2 * x - first.x, 2 * z - first.z).y;

    return tp_surface_has_rings_or_pools(surface)
         ? level + tp_rings_pools_sample(surface, x, z).height : level;
}
