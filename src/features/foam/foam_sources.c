/* SPDX-License-Identifier: MIT */
/* Sources of foam: compressed and breaking crests, moving shallow water, water moving
 * along walls; hulls are in foam_hull.c.  All are functions of the time and a rest
 * position.
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

#define GAIN_MOST TP_FOAM_GAIN_MOST

/* -- crests -------------------------------------------------------------------------- */

#define CREST_UNITS    600      /* units of cover per unit of the Jacobian, ... */
#define CREST_MOST     TP_FX(0.2)   /* ... over at most this range of the Jacobian */
#define BREAKING_UNITS 112

static uint32_t crest_gain(const tp_foam_maker *m, tp_fx jacobian)
{
    tp_fx below = m->scene->foam.crest - jacobian;
    return tp_foam_scale_gain(tp_clamp(below, 0, CREST_MOST), CREST_UNITS);
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
    return tp_foam_scale_gain(tp_fx_mul(shallow, moves), 80);
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
           + tp_foam_scale_gain(tp_fx_mul(at.breaking * 257, m->scene->foam.breaking),
                        BREAKING_UNITS);
}

/* The mean of the gains, and the cover that balances what fades. */
uint32_t tp_foam_maker_mean_cover(const tp_foam_maker *m, tp_fx depth, uint32_t visits)
{
    if (depth <= 0)
        return 0;
    const tp_coastal_surf surf = tp_coastal_mean_surf(m->coastal, depth);
    const uint32_t gain = tp_foam_scale_gain(tp_fx_mul(surf.breaking, m->scene->foam.breaking),
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
         ? tp_foam_scale_gain(tp_fx_mul(speed, m->scene->foam.wall), WALL_UNITS) : 0;
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
        m->per_lsb >>= m->pool->interval;   /* a change in so many ticks */
    }
    if (m->coastal) {
        m->deep = tp_coastal_breaking_foam_depth(m->coastal);
        m->per_deep = tp_fx_recip(m->deep);
    }
    tp_foam_maker_find_hull(m);
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
        gain += tp_foam_maker_hull_gain(m, x);
    return gain < GAIN_MOST ? gain : GAIN_MOST;
}

/* -- gains apart, for foam in slices ------------------------------------------------- */

uint32_t tp_foam_maker_wall_gain(const tp_foam_maker *m, tp_fx x)
{
    return wall_gain(m, x);
}

/* The Jacobian of swells of a sum q of steepness is at least (1 - q)^2, [A9]. */
bool tp_foam_maker_has_waves(const tp_foam_maker *m)
{
    const tp_q30 rest = TP_Q30_ONE - m->world->deep.steepness_sum;
    const tp_fx least = tp_q30_mul(rest, rest) >> 14;

    if (m->coastal)
        return true;
    return m->scene->foam.crest > 0 && m->scene->foam.crest > least - TP_FX_ONE / 64;
}

static uint32_t deep_gain(const tp_foam_maker *m, tp_fx x)
{
    if (m->scene->foam.crest <= 0)
        return 0;
    return crest_gain(m, tp_deep_water_jacobian(&m->world->deep, m->world->phases, x, m->z));
}

uint32_t tp_foam_maker_wave_gain(const tp_foam_maker *m, tp_fx x)
{
    if (!m->coastal)
        return deep_gain(m, x);
    const tp_fx depth = tp_coastal_floor(m->coastal, x, m->z).depth;
    if (depth <= 0)
        return 0;
    const uint32_t share = tp_foam_maker_open_share(m, depth);
    uint32_t gain = share > 0 ? deep_gain(m, x) * share >> 8 : 0;
    if (share < 256) {
        const tp_coastal_point at = sample_coastal(m, x, m->z);
        gain += shore_gain(m, depth, tp_abs(at.position.y), at.breaking * 128)
              + tp_foam_scale_gain(tp_fx_mul(at.breaking * 257, m->scene->foam.breaking),
                           BREAKING_UNITS);
    }
    return gain < GAIN_MOST ? gain : GAIN_MOST;
}
