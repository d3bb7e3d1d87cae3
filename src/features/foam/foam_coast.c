/* SPDX-License-Identifier: MIT */
/* Foam of coastal water: compressed and breaking crests, moving shallow water; the mean of
 * both at a depth, and cells that enter the window over a map of the floor.  Rates are
 * chosen by eye, see foam_sources.c. */
#include "base/base.h"
#include "features/foam/foam_cover.h"
#include "features/foam/foam_visit.h"
#include "view/wave_models.h"
#include "waves/coastal_tables.h"
#include "waves/softfloat.h"

#define BREAKING_UNITS 112

static tp_coastal_point sample_coastal(const tp_foam_maker *m, tp_fx x, tp_fx z)
{
    return m->by->coastal->breaking(m->coastal, m->world->phases, x, z);
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
    TP_ASSERT(m->coastal != NULL && m->foam->scratch != 0);
    if (!after_neighbour)
        m->left = sample_coastal(m, x - m->foam->cell, m->z).position;
    tp_coastal_point at = sample_coastal(m, x, m->z);
    tp_fx squeeze = coastal_jacobian(m, col, at.position);

    if (at.depth <= 0)
        return TP_FOAM_DRY;
    return reduce_shallow_gain(m, at.depth, tp_foam_crest_gain(m, squeeze))
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
    const uint32_t more = gain < TP_FOAM_GAIN_MOST ? gain : TP_FOAM_GAIN_MOST;      /* Q16 */
    const uint32_t lost = ((1u << 24) - tp_foam_kept_share(m->scene->foam.fade)) >> 8;
    const uint64_t age = (uint64_t)(more + lost) * visits << 8;
    const uint32_t young = tp_exp_neg(age < UINT32_MAX ? (uint32_t)age : UINT32_MAX);
    const uint64_t cover = (uint64_t)(more * 255) * (UINT32_MAX - young);

    return (uint32_t)((cover / (more + lost + 1) + (1u << 31)) >> 32);
}

static tp_fx floor_depth(const tp_foam_maker *m, tp_fx x)
{
    return m->by->coastal->floor(m->coastal, x, m->z).depth;
}

/* Open water counts as deep water. */
static uint32_t wave_gain(const tp_foam_maker *m, tp_fx x)
{
    const tp_fx depth = floor_depth(m, x);
    if (depth <= 0)
        return 0;
    const uint32_t share = tp_foam_maker_open_share(m, depth);
    uint32_t gain = share > 0 ? tp_foam_deep_gain(m, x) * share >> 8 : 0;
    if (share < 256) {
        const tp_coastal_point at = sample_coastal(m, x, m->z);
        gain += shore_gain(m, depth, tp_abs(at.position.y), at.breaking * 128)
              + tp_foam_scale_gain(tp_fx_mul(at.breaking * 257, m->scene->foam.breaking),
                           BREAKING_UNITS);
    }
    return gain;
}

/* -- rows ---------------------------------------------------------------------------- */

static void sample_previous_row(tp_foam_maker *m, uint32_t col, tp_fx x)
{
    previous_row(m)[col] = sample_coastal(m, x, m->z - m->foam->cell).position;
}

/* Returns the mean of the cover at a rest position over a map, by the depth. */
static uint8_t map_mean(const tp_foam_maker *m, tp_fx x)
{
    const tp_fx depth = floor_depth(m, x);
    if (depth <= 0)
        return 0;
    const uint32_t open = tp_foam_open_mean(m->foam, m->world);
    const uint32_t cover =
        tp_foam_maker_mean_cover(m, depth, m->foam->visits / TP_FOAM_TICKS)
        + ((open * tp_foam_maker_open_share(m, depth)) >> 16);
    return (uint8_t)(cover < 255 ? cover : 255);
}

/* Gives the cells of a row over a map that enter the window the mean, so the window shows
 * no edge when it moves.  `seen`: the window of the last visit; `all`: the row enters. */
static void fill_entering_cells(const tp_foam_visit *v, const tp_foam *foam, uint8_t *cover,
                                const tp_lattice_axis *seen, bool all)
{
    if (!all && seen->first == v->x.first)
        return;
    for (uint32_t i = 0; i < foam->cells; i++) {
        const int32_t number = tp_lattice_cell_number(&v->x, i);
        if (all || number != tp_lattice_cell_number(seen, i))
            cover[i] = map_mean(&v->make, tp_foam_cell_centre(foam, number, foam->drift_x));
    }
}

/* Adds every sixteenth cell of a row that lies in open water. */
static void count_open_water(const tp_foam_visit *v, tp_foam *foam, const uint8_t *cover)
{
    tp_foam_open *open = tp_foam_open_water(foam);

    for (uint32_t i = 0; i < foam->cells; i += 16) {
        const int32_t number = tp_lattice_cell_number(&v->x, i);
        const tp_fx x = tp_foam_cell_centre(foam, number, foam->drift_x);
        const tp_fx depth = floor_depth(&v->make, x);
        const uint32_t share = depth > 0 ? tp_foam_maker_open_share(&v->make, depth) : 0;
        if (share < TP_FOAM_OPEN_SHARE)
            continue;
        open->sum += cover[i];
        open->count += share;
    }
    for (; open->count >= TP_FOAM_OPEN_COUNT; open->count /= 2)
        open->sum /= 2;
}

const struct tp_water_foam_coast tp_water_foam_coast = {
    .gain = coastal_gain, .wave_gain = wave_gain,
    .sample_previous_row = sample_previous_row,
    .fill_entering_cells = fill_entering_cells, .count_open_water = count_open_water,
    .begin_surf = tp_foam_surf_begin, .set_shore = tp_foam_set_shore,
};
