/* SPDX-License-Identifier: MIT */
/* Sources of foam: compressed crests, water moving along walls; coastal water is in
 * foam_coast.c, hulls are in foam_hull.c.  All are functions of the time and a rest
 * position.
 *
 * Rates are chosen by eye, in units of cover per visit (TP_FOAM_TICKS ticks); 255 units
 * are white. */
#include "base/base.h"
#include "features/foam/foam_visit.h"
#include "waves/coastal_tables.h"
#include "waves/deep_water.h"
#include "world/module.h"
#include "world/pools.h"

#define GAIN_MOST TP_FOAM_GAIN_MOST

/* -- crests -------------------------------------------------------------------------- */

#define CREST_UNITS    600      /* units of cover per unit of the Jacobian, ... */
#define CREST_MOST     TP_FX(0.2)   /* ... over at most this range of the Jacobian */

uint32_t tp_foam_crest_gain(const tp_foam_maker *m, tp_fx jacobian)
{
    tp_fx below = m->scene->foam.crest - jacobian;
    return tp_foam_scale_gain(tp_clamp(below, 0, CREST_MOST), CREST_UNITS);
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

static void begin_walls(tp_foam_maker *m)
{
    int64_t most = tp_pool_height_bound(m->pool),
            full = tp_pool_from_metres(m->pool, (tp_fx)most);

    m->per_lsb = full > 0 ? (most * TP_TICKS_PER_SECOND << 32) / full : 0;
    m->per_lsb >>= m->pool->interval;       /* a change in so many ticks */
}

const struct tp_water_foam_walls tp_water_foam_walls = { begin_walls, wall_gain };

/* ----------------------------------------------------------------------------------- */

void tp_foam_maker_begin(tp_foam_maker *m, tp_foam *foam, const tp_wave_models *by,
                         const tp_world *world, const tp_scene *scene)
{
    *m = (tp_foam_maker){
        .by = by, .world = world, .scene = scene, .foam = foam,
        .coastal = by->foam_coast ? tp_world_coastal(world) : NULL,
        .pool = by->foam_walls ? tp_world_pool(world) : NULL,
        .per_cell = tp_fx_recip(foam->cell), .per_shore = tp_fx_recip(scene->foam.shore),
    };
    if (m->pool)
        by->foam_walls->begin(m);
    if (m->coastal) {
        m->deep = tp_coastal_breaking_foam_depth(m->coastal);
        m->per_deep = tp_fx_recip(m->deep);
    }
    if (by->foam_hull)
        by->foam_hull->find(m);
}

uint32_t tp_foam_deep_gain(const tp_foam_maker *m, tp_fx x)
{
    if (m->scene->foam.crest <= 0)
        return 0;
    return tp_foam_crest_gain(
        m, tp_deep_water_jacobian(&m->world->deep, m->world->phases, x, m->z));
}

uint32_t tp_foam_maker_gain(tp_foam_maker *m, uint32_t col, tp_fx x, bool after_neighbour)
{
    TP_ASSERT(col < m->foam->cells);
    uint32_t gain = m->coastal ? m->by->foam_coast->gain(m, col, x, after_neighbour)
                               : tp_foam_deep_gain(m, x);

    if (gain == TP_FOAM_DRY)
        return gain;
    if (m->pool) {
        uint32_t walls = m->by->foam_walls->gain(m, x);
        if (walls == TP_FOAM_DRY)
            return walls;
        gain += walls;
    }
    if (m->has_hull)
        gain += m->by->foam_hull->gain(m, x);
    return gain < GAIN_MOST ? gain : GAIN_MOST;
}

/* -- gains apart, for foam in slices ------------------------------------------------- */

/* The Jacobian of swells of a sum q of steepness is at least (1 - q)^2, [A9]. */
bool tp_foam_maker_has_waves(const tp_foam_maker *m)
{
    const tp_q30 rest = TP_Q30_ONE - m->world->deep.steepness_sum;
    const tp_fx least = tp_q30_mul(rest, rest) >> 14;

    if (m->coastal)
        return true;
    return m->scene->foam.crest > 0 && m->scene->foam.crest > least - TP_FX_ONE / 64;
}

uint32_t tp_foam_maker_wave_gain(const tp_foam_maker *m, tp_fx x)
{
    if (!m->coastal)
        return tp_foam_deep_gain(m, x);
    const uint32_t gain = m->by->foam_coast->wave_gain(m, x);
    return gain < GAIN_MOST ? gain : GAIN_MOST;
}
