/* SPDX-License-Identifier: MIT */
/* Foam in slices, n = 2 or more by foam.slices at init: cover fades and hulls foam at every
 * visit, as with one slice; waves and walls foam at every n-th visit of a row, for n visits
 * at once.  Rows take turns in pairs of lattice rows, so each tick has its n-th part.
 *
 * The gain of waves is sampled at every second cell of the line between the two rows and
 * linear between.  Open coastal water counts as deep water: its crests foam by the Jacobian
 * of the swells, without the floor and the wind. */
#include "base/base.h"
#include "features/foam/foam_visit.h"
#include "waves/coastal_tables.h"

/* Returns the gain of n visits: each takes its share of the free cover. */
static uint32_t repeat_gain(uint32_t gain, uint32_t n)
{
    uint32_t all = gain;

    for (; n > 1 && gain > 0; n--)
        all += ((65536 - all) * gain) >> 16;
    return all;
}

/* -- gains of a pair of rows --------------------------------------------------------- */

/* Sets the gains of waves at every second cell from x on. */
static void sample_pair(tp_foam_sparse *sparse, tp_foam_maker *make, tp_fx x, tp_fx z,
                        uint32_t cells)
{
    const tp_fx row_z = make->z;

    make->z = z;
    for (uint32_t i = 0; i < cells; i += 2)
        sparse->gain[i / 2] = (uint16_t)tp_foam_maker_wave_gain(
            make, (tp_fx)(x + (int64_t)i * make->foam->cell));
    if (cells % 2 == 0)
        sparse->gain[cells / 2] = sparse->gain[cells / 2 - 1];
    make->z = row_z;
}

static uint32_t wave_gain_of_cell(const tp_foam_sparse *sparse, uint32_t i)
{
    const uint16_t *gain = sparse->gain + i / 2;
    return i % 2 ? ((uint32_t)gain[0] + gain[1]) / 2 : gain[0];
}

/* -- cells --------------------------------------------------------------------------- */

/* Returns the sum of the row's cover after it has faded. */
static uint32_t fade_row(const tp_foam_visit *v, uint8_t *cover, uint32_t cells)
{
    uint32_t sum = 0;

    for (uint32_t i = 0; i < cells; i++) {
        if (cover[i] == 0)
            continue;
        cover[i] = tp_foam_next_cover(cover[i], v, i, 0);
        sum += cover[i];
    }
    return sum;
}

/* Returns the gain of a cell, number k of the window's row, or TP_FOAM_DRY. */
static uint32_t cell_gain(tp_foam_visit *v, uint32_t k, tp_fx x, bool due, bool hull)
{
    uint32_t gain = due && v->sparse.waves ? wave_gain_of_cell(&v->sparse, k) : 0;

    if (due && v->make.pool) {
        const uint32_t walls = v->make.by->foam_walls->gain(&v->make, x);
        if (walls == TP_FOAM_DRY)
            return walls;
        gain += walls;
    }
    gain = repeat_gain(gain < TP_FOAM_GAIN_MOST ? gain : TP_FOAM_GAIN_MOST, v->slices);
    if (hull)
        gain += v->make.by->foam_hull->gain(&v->make, x);
    return gain < TP_FOAM_GAIN_MOST ? gain : TP_FOAM_GAIN_MOST;
}

/* Visits the cells of a row: all if waves and walls are due, else those within the hull's
 * range. */
static void visit_cells(tp_foam_visit *v, const tp_foam *foam, uint8_t *cover,
                        const uint32_t hull[2], bool due)
{
    const uint32_t from = due ? 0 : hull[0], to = due ? foam->cells : hull[1];
    uint32_t col = v->x.seam + from;

    col -= col >= foam->cells ? foam->cells : 0;
    for (uint32_t k = from; k < to; k++, col = col + 1 < foam->cells ? col + 1 : 0) {
        const tp_fx x = (tp_fx)(v->low_x + (int64_t)k * foam->cell);
        const uint32_t gain = cell_gain(v, k, x, due, k >= hull[0] && k < hull[1]);
        cover[col] = gain == TP_FOAM_DRY ? 0
                   : (gain | cover[col]) == 0 ? 0
                                              : tp_foam_next_cover(cover[col], v, col, gain);
    }
}

/* Fades the cells of the window's numbers from `from` to `to`. */
static void fade_cells(const tp_foam_visit *v, const tp_foam *foam, uint8_t *cover,
                       uint32_t from, uint32_t to)
{
    uint32_t col = v->x.seam + from;

    col -= col >= foam->cells ? foam->cells : 0;
    for (uint32_t k = from; k < to; k++, col = col + 1 < foam->cells ? col + 1 : 0)
        if (cover[col])
            cover[col] = tp_foam_next_cover(cover[col], v, col, 0);
}

static uint32_t sum_of_row(const uint8_t *cover, uint32_t cells)
{
    uint32_t sum = 0;

    for (uint32_t i = 0; i < cells; i++)
        sum += cover[i];
    return sum;
}

/* -- rows ---------------------------------------------------------------------------- */

/* Clears the cells that have entered the window since the last visit. */
static void clear_entering_cells(const tp_foam_visit *v, uint8_t *cover, uint32_t cells)
{
    if (v->seen_x.first == v->x.first)
        return;
    for (uint32_t i = 0; i < cells; i++)
        if (tp_lattice_cell_number(&v->x, i) != tp_lattice_cell_number(&v->seen_x, i))
            cover[i] = 0;
}

/* Returns true if the waves and walls of the lattice row foam at this visit, and prepares the
 * gains of its pair. */
static bool begin_row(tp_foam_visit *v, const tp_foam *foam, int32_t number)
{
    const int32_t pair = (number - (number & 1)) / 2;
    const uint32_t turn = (foam->visits / TP_FOAM_TICKS) % v->slices;

    if (tp_foam_mod(pair + (int32_t)turn, v->slices) != 0 || !v->sparse.sources)
        return false;
    if (v->sparse.waves && (!v->sparse.ready || v->sparse.pair != pair))
        sample_pair(&v->sparse, &v->make, v->low_x,
                    tp_foam_cell_centre(foam, 2 * pair, foam->drift_z) + foam->cell / 2,
                    foam->cells);
    v->sparse.ready = true;
    v->sparse.pair = pair;
    return true;
}

static uint32_t visit_row_sparsely(tp_foam_visit *v, const tp_foam *foam, uint8_t *cover,
                                   int32_t number)
{
    const bool due = begin_row(v, foam, number);
    uint32_t hull[2] = { 0, 0 };

    clear_entering_cells(v, cover, foam->cells);
    if (!tp_foam_maker_hull_range(&v->make, v->low_x, &hull[0], &hull[1]))
        hull[0] = hull[1] = 0;
    if (!due && hull[0] == hull[1])
        return fade_row(v, cover, foam->cells);
    if (!due)
        fade_cells(v, foam, cover, 0, hull[0]);
    visit_cells(v, foam, cover, hull, due);
    if (!due)
        fade_cells(v, foam, cover, hull[1], foam->cells);
    return sum_of_row(cover, foam->cells);
}

const struct tp_water_foam_slices tp_water_foam_slices = { visit_row_sparsely };
