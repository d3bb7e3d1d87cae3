/* SPDX-License-Identifier: MIT */
/* Sources of foam: compressed and breaking crests, moving shallow water, water moving
 * along walls, and a hull.  All are functions of the time and a rest position.
 *
 * Rates are chosen by eye, in units of cover per visit (TP_FOAM_TICKS ticks); 255 units
 * are white. */
#include "base/base.h"
#include "features/foam/foam.h"
#include "waves/coastal_tables.h"
#include "waves/deep_water.h"
#include "waves/softfloat.h"
#include "world/module.h"
#include "world/pools.h"

#define GAIN_MOST 0xff00u

/* Returns share x units of cover in 1/256 units, clamped to 0..GAIN_MOST.  `share` is
 * 16.16. */
static uint32_t scale_gain(tp_fx share, int32_t units)
{
    int64_t gain = (int64_t)share * units >> 8;
    return gain < 0 ? 0 : gain > GAIN_MOST ? GAIN_MOST : (uint32_t)gain;
}

/* -- crests -------------------------------------------------------------------------- */

#define CREST_UNITS    600      /* units of cover per unit of the Jacobian, ... */
#define CREST_MOST     TP_FX(0.2)   /* ... over at most this range of the Jacobian */
#define BREAKING_UNITS 112

static uint32_t crest_gain(const tp_foam_maker *m, tp_fx jacobian)
{
    tp_fx below = m->scene->foam.crest - jacobian;
    return scale_gain(tp_clamp(below, 0, CREST_MOST), CREST_UNITS);
}

static tp_coastal_point sample_coastal(const tp_foam_maker *m, tp_fx x, tp_fx z)
{
    return tp_coastal_displace_point(m->coastal, m->world->phases, x, z);
}

/* Returns the stretch over one cell, clamped to +-8.  Larger values occur only on land. */
static tp_fx cell_stretch(const tp_foam_maker *m, int64_t difference)
{
    return (tp_fx)tp_clamp_abs(tp_clamp_abs(difference, 1 << 24) * m->per_cell >> 16,
                               8 * TP_FX_ONE);
}

/* Returns the array of displaced positions of the row at z - cell. */
static tp_vec3 *previous_row(const tp_foam_maker *m)
{
    return (tp_vec3 *)(void *)((char *)m->foam + m->foam->scratch);
}

/* Returns the Jacobian of the displacement, from differences over one cell. */
static tp_fx coastal_jacobian(tp_foam_maker *m, uint32_t col, tp_vec3 here)
{
    tp_vec3 *above = previous_row(m) + col;
    int64_t jxx = cell_stretch(m, (int64_t)here.x - m->left.x);
    int64_t jzx = cell_stretch(m, (int64_t)here.z - m->left.z);
    int64_t jxz = cell_stretch(m, (int64_t)here.x - above->x);
    int64_t jzz = cell_stretch(m, (int64_t)here.z - above->z);

    m->left = here;
    *above = here;
    return (tp_fx)((jxx * jzz - jxz * jzx) >> 16);
}

/* Crests gain less over a near floor.  Orbits widen there and every crest is
 * compressed, so only breaking counts.  The full gain holds from a depth of 16 wave
 * heights on, none up to a depth of 8 wave heights. */
uint32_t tp_foam_maker_open_share(const tp_foam_maker *m, tp_fx depth)
{
    int64_t over = ((int64_t)depth - m->deep) * m->per_deep >> 16;
    return over < 0 ? 0 : over < 256 * 256 ? (uint32_t)over >> 8 : 256;
}

static uint32_t reduce_shallow_gain(const tp_foam_maker *m, tp_fx depth, uint32_t gain)
{
    return gain * tp_foam_maker_open_share(m, depth) >> 8;
}

/* Returns the gain of shallow water, in proportion to its height or breaking; still water
 * makes no foam. */
static uint32_t shore_gain(const tp_foam_maker *m, tp_fx depth, tp_fx lift, tp_fx breaking)
{
    tp_fx shore = m->scene->foam.shore;

    if (depth >= shore)
        return 0;
    tp_fx shallow = TP_FX_ONE - tp_fx_mul(depth, m->per_shore);
    int64_t lifted = ((int64_t)lift * m->per_shore + 0x8000) >> 16;
    tp_fx moves = (tp_fx)tp_clamp_abs(lifted + breaking, TP_FX_ONE);
    return scale_gain(tp_fx_mul(shallow, moves), 80);
}

static uint32_t coastal_gain(tp_foam_maker *m, uint32_t col, tp_fx x, bool after_neighbour)
{
    if (!after_neighbour)
        m->left = sample_coastal(m, x - m->foam->cell, m->z).position;
    tp_coastal_point at = sample_coastal(m, x, m->z);
    tp_fx squeeze = coastal_jacobian(m, col, at.position);

    if (at.depth <= 0)
        return TP_FOAM_DRY;
    return reduce_shallow_gain(m, at.depth, crest_gain(m, squeeze))
           + shore_gain(m, at.depth, tp_abs(at.position.y), at.breaking * 128)
           + scale_gain(tp_fx_mul(at.breaking * 257, m->scene->foam.breaking),
                        BREAKING_UNITS);
}

/* The mean of the gains, and the cover that balances what fades. */
uint32_t tp_foam_maker_mean_cover(const tp_foam_maker *m, tp_fx depth, uint32_t visits)
{
    if (depth <= 0)
        return 0;
    const tp_coastal_surf surf = tp_coastal_mean_surf(m->coastal, depth);
    const uint32_t gain = scale_gain(tp_fx_mul(surf.breaking, m->scene->foam.breaking),
                                     BREAKING_UNITS)
                        + shore_gain(m, depth, surf.lift, surf.breaking / 2);
    const uint32_t more = gain < GAIN_MOST ? gain : GAIN_MOST;      /* Q16 */
    const uint32_t lost = ((1u << 24) - tp_foam_kept_share(m->scene->foam.fade)) >> 8;
    const uint64_t age = (uint64_t)(more + lost) * visits << 8;
    const uint32_t young = tp_exp_neg(age < UINT32_MAX ? (uint32_t)age : UINT32_MAX);
    const uint64_t cover = (uint64_t)(more * 255) * (UINT32_MAX - young);

    return (uint32_t)((cover / (more + lost + 1) + (1u << 31)) >> 32);
}

/* -- walls --------------------------------------------------------------------------- */

#define WALL_UNITS 800          /* units per m/s above WALL_STILL */
#define WALL_STILL TP_FX(0.06)

static bool is_beside_pool_wall(const tp_foam_maker *m, tp_fx x)
{
    const tp_pool *pool = m->pool;
    tp_fx d = pool->cell > m->foam->cell ? pool->cell : m->foam->cell;
    uint32_t col, row;

    return !tp_pool_open_cell_at_point(pool, x - d, m->z, &col, &row)
           || !tp_pool_open_cell_at_point(pool, x + d, m->z, &col, &row)
           || !tp_pool_open_cell_at_point(pool, x, m->z - d, &col, &row)
           || !tp_pool_open_cell_at_point(pool, x, m->z + d, &col, &row);
}

/* Returns the gain along walls.  Outside of the pool the gain is 0; inside a wall the
 * cell is dry. */
static uint32_t wall_gain(const tp_foam_maker *m, tp_fx x)
{
    const tp_pool *pool = m->pool;
    int64_t dx = (int64_t)x - pool->x, dz = (int64_t)m->z - pool->z;
    uint32_t col, row;

    if (!tp_pool_open_cell_at_point(pool, x, m->z, &col, &row))
        return 2 * (dx < 0 ? -dx : dx) < (int64_t)pool->cols * pool->cell
                   && 2 * (dz < 0 ? -dz : dz) < (int64_t)pool->rows * pool->cell
               ? TP_FOAM_DRY : 0;
    int64_t lsb = tp_abs(tp_pool_velocity(pool, col, row));
    tp_fx speed = (tp_fx)tp_clamp_abs(lsb * m->per_lsb >> 32, 64 * TP_FX_ONE) - WALL_STILL;
    return speed > 0 && m->scene->foam.wall > 0 && is_beside_pool_wall(m, x)
         ? scale_gain(tp_fx_mul(speed, m->scene->foam.wall), WALL_UNITS) : 0;
}

/* -- the hull ------------------------------------------------------------------------ */

#define LINE_LEAST TP_FX(0.28)  /* m: half the width of the foam line */
#define LINE_UNITS 28           /* line of a hull at rest */
#define PACE_UNITS 300          /* line of a hull at PACE or faster */
#define PACE       4            /* m/s */
#define FULLER     TP_FX(1.176) /* a hull is longer than its points are apart; with the
                                 * factor the longship's waterline is 1 - alpha^2 within
                                 * 0.1 m */
#define ARM        TP_FX(0.3536)/* tangent of Kelvin's angle, 19.47 degrees */
#define ARM_LONG   5            /* length of the arms, in half hull lengths */

/* Returns a triangular profile: 1 at e = 0, 0 at |e| >= wide. */
static tp_fx triangle_profile(tp_fx e, tp_fx wide)
{
    tp_fx off = tp_abs(e);
    return off < wide ? TP_FX_ONE - tp_fx_div(off, wide) : 0;
}

/* Returns the intensity of the wake, 0..1: two arms from the bow, kept outside of the
 * hull, and turbulent water behind the stern.  `behind`: distance from the bow,
 * `side`: distance from the hull's axis, `hull_half_width`: half width of the hull
 * there; all in m. */
static tp_fx wake_foam_intensity(const tp_foam_hull *h, tp_fx behind, tp_fx side,
                                 tp_fx hull_half_width, tp_fx line_half_width)
{
    tp_fx reach = ARM_LONG * h->length, stern = behind - 2 * h->length;

    if (behind <= 0 || behind >= reach)
        return 0;
    tp_fx left = TP_FX_ONE - tp_fx_div(behind, reach);
    tp_fx off = tp_fx_mul(behind, ARM);
    tp_fx arm = triangle_profile(side - (off > hull_half_width ? off : hull_half_width)
                                     - line_half_width / 2,
                                 line_half_width + behind / 24);
    tp_fx trail = stern > -h->length / 2 && stern < h->length / 2
                ? triangle_profile(side, h->beam / 2 + line_half_width) / 2 : 0;
    return tp_fx_mul(arm > trail ? arm : trail, tp_fx_mul(left, left));
}

static uint32_t hull_gain(const tp_foam_maker *m, tp_fx x)
{
    const tp_foam_hull *h = &m->hull;
    int64_t dx = (int64_t)x - h->x, dz = (int64_t)m->z - h->z;

    if (dx > h->foam_radius || dx < -h->foam_radius || dz > h->foam_radius
        || dz < -h->foam_radius)
        return 0;
    tp_fx alpha = tp_fx_saturate((dx * h->along[0] + dz * h->along[1]) >> 16);
    tp_fx beta = tp_fx_saturate((dx * h->across[0] + dz * h->across[1]) >> 16);
    tp_fx line = LINE_LEAST > m->foam->cell / 2 ? LINE_LEAST : m->foam->cell / 2;
    tp_fx side = tp_fx_mul(tp_abs(tp_clamp(beta, -TP_FX_MAX, TP_FX_MAX)), h->beam);
    tp_fx pace = tp_abs(h->pace);
    tp_fx wide = 0;
    uint32_t gain = 0;

    if (tp_abs(tp_clamp(alpha, -TP_FX_MAX, TP_FX_MAX)) <= TP_FX_ONE) {
        wide = tp_fx_mul(h->beam, TP_FX_ONE - tp_fx_mul(alpha, alpha));
        tp_fx hugs = triangle_profile(side - wide - line / 2, line);
        gain = scale_gain(hugs, LINE_UNITS) + scale_gain(tp_fx_mul(hugs, pace), PACE_UNITS);
    }
    if (pace > 0) {
        int64_t ahead = h->pace > 0 ? alpha : -(int64_t)alpha;
        tp_fx behind = tp_fx_saturate((TP_FX_ONE - ahead) * h->length >> 16);
        tp_fx wake = wake_foam_intensity(h, behind, side, wide, line);
        gain += scale_gain(tp_fx_mul(wake, pace), PACE_UNITS);
    }
    return (uint32_t)((uint64_t)gain * (uint32_t)m->scene->foam.hull >> 16);
}

/* Finds the hull in rest positions.  The rest positions of the hull's four points give
 * its axes, whatever the waves' displacement.  The displacement is at most 600 m, so det
 * is below 2^53. */
static void find_hull_in_rest_positions(tp_foam_maker *m)
{
    const tp_boat_state *a = &m->world->boat_state;
    const tp_vec3 *now = &m->world->boat.place, *last = &m->world->last_boat.place;
    const tp_fx (*p)[2] = a->rest;
    int64_t ux = ((int64_t)p[0][0] - p[1][0]) / 2, uz = ((int64_t)p[0][1] - p[1][1]) / 2;
    int64_t wx = ((int64_t)p[3][0] - p[2][0]) / 2, wz = ((int64_t)p[3][1] - p[2][1]) / 2;
    int64_t det = ux * wz - uz * wx;
    tp_foam_hull *h = &m->hull;

    m->has_hull = m->scene->boat.mesh[0] && a->placed && m->scene->foam.hull > 0
               && det > 1 << 24;
    if (!m->has_hull)
        return;
    h->x = (tp_fx)(((int64_t)p[0][0] + p[1][0] + p[2][0] + p[3][0]) / 4);
    h->z = (tp_fx)(((int64_t)p[0][1] + p[1][1] + p[2][1] + p[3][1]) / 4);
    ux = ux * FULLER >> 16;
    uz = uz * FULLER >> 16;
    det = (det >> 16) * FULLER + ((det & 0xffff) * FULLER >> 16);
    h->along[0] = tp_fx_saturate(wz * ((int64_t)1 << 32) / det);
    h->along[1] = tp_fx_saturate(-wx * ((int64_t)1 << 32) / det);
    h->across[0] = tp_fx_saturate(-uz * ((int64_t)1 << 32) / det);
    h->across[1] = tp_fx_saturate(ux * ((int64_t)1 << 32) / det);
    h->length = tp_fx_mul(m->scene->boat.length / 2, FULLER);
    h->beam = m->scene->boat.beam / 2;
    int64_t way = (((int64_t)now->x - last->x) * tp_sin(a->hull.heading)
                   - ((int64_t)now->z - last->z) * tp_cos(a->hull.heading)) >> 30;
    h->pace = (tp_fx)tp_clamp_abs(way * TP_TICKS_PER_SECOND / PACE, TP_FX_ONE);
    h->foam_radius = h->pace != 0 ? (ARM_LONG + 1) * h->length : h->length + h->beam;
}

/* ----------------------------------------------------------------------------------- */

void tp_foam_maker_begin(tp_foam_maker *m, tp_foam *foam, const tp_world *world,
                         const tp_scene *scene)
{
    *m = (tp_foam_maker){
        .world = world, .scene = scene, .foam = foam, .coastal = tp_world_coastal(world),
        .pool = tp_world_pool(world), .per_cell = tp_fx_recip(foam->cell),
        .per_shore = tp_fx_recip(scene->foam.shore),
    };
    if (m->pool) {
        int64_t most = tp_pool_height_bound(m->pool),
                full = tp_pool_from_metres(m->pool, (tp_fx)most);
        m->per_lsb = full > 0 ? (most * TP_TICKS_PER_SECOND << 32) / full : 0;
    }
    if (m->coastal) {
        m->deep = tp_coastal_breaking_foam_depth(m->coastal);
        m->per_deep = tp_fx_recip(m->deep);
    }
    find_hull_in_rest_positions(m);
}

void tp_foam_maker_sample_previous_row(tp_foam_maker *m, uint32_t col, tp_fx x)
{
    previous_row(m)[col] = sample_coastal(m, x, m->z - m->foam->cell).position;
}

uint32_t tp_foam_maker_gain(tp_foam_maker *m, uint32_t col, tp_fx x, bool after_neighbour)
{
    TP_ASSERT(col < m->foam->cells);
    uint32_t gain = m->coastal ? coastal_gain(m, col, x, after_neighbour)
                    : m->scene->foam.crest > 0
                        ? crest_gain(m, tp_deep_water_jacobian(&m->world->deep,
                                                               m->world->phases, x, m->z))
                        : 0;

    if (gain == TP_FOAM_DRY)
        return gain;
    if (m->pool) {
        uint32_t walls = wall_gain(m, x);
        if (walls == TP_FOAM_DRY)
            return walls;
        gain += walls;
    }
    if (m->has_hull)
        gain += hull_gain(m, x);
    return gain < GAIN_MOST ? gain : GAIN_MOST;
}
