/* SPDX-License-Identifier: MIT */
/* Tables of a floor map: nodes with depth and slope of the floor, and for each wave the
 * phase and the direction of travel at each node, from the eikonal equation. */
#include "waves/coastal_tables.h"

/* -- the eikonal equation ------------------------------------------------------------ */

/* Solves |grad S| = k on a square grid by fast sweeping: Gauss-Seidel in four orders.  Each
 * order settles the nodes reached by waves in its direction (Zhao 2005).
 *
 * a and b are the lower of the two neighbours along x and along z.  A node solves
 *     (S - a)^2 + (S - b)^2 = f^2,   f = k times the grid step,
 * or takes a + f if b is too high to contribute (Godunov).  A plane wave is an exact
 * solution, to the last bit.  k is taken half a step back, towards the neighbour with the
 * larger difference; a straight shore then has second order accuracy.  Behind an obstacle
 * the solution holds only the waves that arrive first.
 *
 * On input `turns[i]` holds the phase, Q32.32, on the edges where waves come in, and
 * INT64_MAX elsewhere.  On output `turns` holds the earliest phase everywhere.
 * `ray[i].turns` holds k times the step, as unsigned turns Q8.24. */

#define UNSOLVED INT64_MAX
#define ROUNDS  16

typedef struct {
    int64_t *turns;
    const tp_coastal_wave_node *ray;
    uint32_t cols, rows;
} lattice;

/* A neighbour: its phase, and its k times the step. */
typedef struct {
    int64_t turns;
    int64_t number;
} before;

static before lower_neighbour(const lattice *l, size_t at, size_t step, bool has_low,
                              bool has_high)
{
    const int64_t low = has_low ? l->turns[at - step] : UNSOLVED;
    const int64_t high = has_high ? l->turns[at + step] : UNSOLVED;
    const size_t from = low <= high ? at - step : at + step;

    if (low == UNSOLVED && high == UNSOLVED)
        return (before){ UNSOLVED, 0 };
    return (before){ low <= high ? low : high, (uint32_t)l->ray[from].turns };
}

/* Returns f half a step back from `here`, in Q32.32. */
static int64_t half_step_wave_number(int64_t here, int64_t there)
{
    return (here + there) * ((int64_t)1 << 7);
}

/* Returns sqrt(2 f^2 - d^2) for |d| < f; f is first shifted down to 31 bits. */
static int64_t wavefront_root(int64_t f, int64_t d)
{
    int down = 0;

    for (; f >> 31 != 0; f >>= 1, d /= 2)
        down++;
    return (int64_t)tp_isqrt64((uint64_t)(2 * f * f - d * d)) << down;
}

static int64_t godunov_solution(int64_t number, before a, before b)
{
    if (a.turns > b.turns) {
        const before swap = a;
        a = b;
        b = swap;
    }
    if (a.turns == UNSOLVED)
        return UNSOLVED;
    const int64_t alone = half_step_wave_number(number, a.number);
    if (b.turns == UNSOLVED || b.turns - a.turns >= alone)
        return a.turns + alone;
    const int64_t da = number - a.number, db = number - b.number;
    const bool more = (db < 0 ? -db : db) > (da < 0 ? -da : da);
    const int64_t f = half_step_wave_number(number, more ? b.number : a.number);
    const int64_t d = b.turns - a.turns;
    if (d >= f)
        return a.turns + alone;
    return (a.turns + b.turns + wavefront_root(f, d)) / 2;
}

static bool update_node(const lattice *l, uint32_t col, uint32_t row)
{
    const size_t at = (size_t)row * l->cols + col;
    const before x = lower_neighbour(l, at, 1, col > 0, col + 1 < l->cols);
    const before z = lower_neighbour(l, at, l->cols, row > 0, row + 1 < l->rows);
    const int64_t turns = godunov_solution((uint32_t)l->ray[at].turns, x, z);

    if (turns >= l->turns[at])
        return false;
    l->turns[at] = turns;
    return true;
}

static bool sweep(const lattice *l, bool west, bool north)
{
    bool changed = false;

    for (uint32_t r = 0; r < l->rows; r++) {
        const uint32_t row = north ? l->rows - 1 - r : r;
        for (uint32_t c = 0; c < l->cols; c++)
            changed |= update_node(l, west ? l->cols - 1 - c : c, row);
    }
    return changed;
}

/* Solves |grad S| = k over cols x rows square cells.  On input `turns[i]` holds the
 * phase, Q32.32, on the edges where waves come in, and INT64_MAX elsewhere.  On output
 * `turns` holds the earliest phase everywhere.  `ray[i].turns` holds k times the step, as
 * unsigned turns Q8.24. */
static void eikonal_solve(int64_t *turns, const tp_coastal_wave_node *ray, uint32_t cols,
                          uint32_t rows)
{
    TP_ASSERT(cols >= 2 && rows >= 2);
    const lattice l = { turns, ray, cols, rows };
    bool changed = true;

    for (int n = 0; n < ROUNDS && changed; n++) {
        changed = false;
        for (int way = 0; way < 4; way++)
            changed |= sweep(&l, way & 1, way & 2);
    }
}

/* -- the nodes of a map -------------------------------------------------------------- */

/* Phases are stored as the difference from the phase in deep water, in turns with 16
 * fraction bits.  The difference changes slowly from node to node, even for short waves
 * whose phase runs through several turns.  Bilinear interpolation of the difference
 * therefore never errs by a whole turn.  In deep water the difference is 0.
 *
 * On the edges where waves come in, the phase is the integral of the wave number along
 * the edge, by Snell's law [B9] with the slope of the floor at the edge.  A map of a
 * straight slope then has the phases of this slope.  Heights do not change where rays
 * spread or crowd. */

#define UNKNOWN   INT64_MAX
#define RISE_LEAST 1024         /* half of 1 / the least slope that bends waves */

/* -- the floor ----------------------------------------------------------------------- */

/* Returns the depth at a node.  A map with more pixels than nodes is sampled at four points
 * around the node. */
static tp_fx average_depth(const tp_coastal_water *coastal, const tp_floor *floor,
                           int64_t x, int64_t z)
{
    const uint32_t cols = floor->map->cols, rows = floor->map->rows;
    const bool fine = cols > coastal->map_cols || rows > coastal->map_rows;
    const int64_t way = fine ? coastal->map_step / 4 : 0;
    int64_t sum = 2;

    for (int n = 0; n < 4; n++) {
        const int64_t at_x = x + (n & 1 ? way : -way), at_z = z + (n & 2 ? way : -way);
        sum += tp_floor_sample(floor, (tp_fx)at_x, (tp_fx)at_z).depth;
    }
    return (tp_fx)(sum >> 2);
}

/* Rise of the floor along x and z at a node, over two steps: depth of the western neighbour
 * less the eastern, of the northern less the southern.  On the edges the difference over
 * one step is doubled. */
typedef struct {
    int64_t x, z;
} floor_gradient;

static floor_gradient floor_rise_over_two_steps(const tp_coastal_water *coastal, size_t at)
{
    const size_t cols = coastal->map_cols, col = at % cols, row = at / cols;
    const tp_coastal_floor_node *node = tp_coastal_floor_nodes(coastal) + at;
    const tp_coastal_floor_node *west = col > 0 ? node - 1 : node;
    const tp_coastal_floor_node *east = col + 1 < cols ? node + 1 : node;
    const tp_coastal_floor_node *north = row > 0 ? node - cols : node;
    const tp_coastal_floor_node *south = row + 1 < coastal->map_rows ? node + cols : node;
    const bool inside_x = east - west == 2, inside_z = south - north > (ptrdiff_t)cols;

    return (floor_gradient){ ((int64_t)west->depth - east->depth) * (inside_x ? 1 : 2),
                   ((int64_t)north->depth - south->depth) * (inside_z ? 1 : 2) };
}

/* Converts a rise over two steps to a slope, Q4.11, clamped. */
static int16_t pack_floor_rise(int64_t rise, int64_t step)
{
    return (int16_t)tp_clamp_abs(rise * 1024 / step, 16384);
}

static void set_node_rises(const tp_coastal_water *coastal, tp_coastal_floor_node *nodes)
{
    for (size_t i = 0; i < (size_t)coastal->map_cols * coastal->map_rows; i++) {
        const floor_gradient f = floor_rise_over_two_steps(coastal, i);
        nodes[i].rise_x = pack_floor_rise(f.x, coastal->map_step);
        nodes[i].rise_z = pack_floor_rise(f.z, coastal->map_step);
    }
}

void tp_coastal_make_floor_nodes(tp_coastal_water *coastal, const tp_floor *floor)
{
    tp_coastal_floor_node *beds = tp_coastal_floor_nodes(coastal), *node = beds;

    for (uint32_t r = 0; r < coastal->map_rows; r++) {
        for (uint32_t c = 0; c < coastal->map_cols; c++, node++)
            node->depth = average_depth(coastal, floor,
                                        coastal->map_x + (int64_t)c * coastal->map_step,
                                        coastal->map_z + (int64_t)r * coastal->map_step);
    }
    set_node_rises(coastal, beds);
}

/* Returns the mean slope of the beach, Q30: of all nodes where a wave of this
 * amplitude may break, at depths up to four times the amplitude; of the whole floor if
 * no node is as shallow. */
tp_q30 tp_coastal_beach_slope(const tp_coastal_water *coastal, tp_fx amplitude)
{
    const tp_coastal_floor_node *beds = tp_coastal_floor_nodes(coastal);
    const size_t count = (size_t)coastal->map_cols * coastal->map_rows;
    int64_t sum[2] = { 0, 0 }, found[2] = { 0, 0 };

    for (size_t i = 0; i < count; i++) {
        const int32_t x = beds[i].rise_x, z = beds[i].rise_z;
        const uint32_t rise = tp_isqrt64((uint64_t)((int64_t)x * x + (int64_t)z * z));
        const int near = beds[i].depth > 0 && beds[i].depth <= 4 * (int64_t)amplitude;
        sum[near] += rise;
        found[near]++;
    }
    const int of = found[1] > 0;
    const int64_t mean = sum[of] * 1024 / found[of] * 512;      /* Q11 to Q30 */
    return (tp_q30)(mean < TP_Q30_ONE ? mean : TP_Q30_ONE);
}

/* -- waves --------------------------------------------------------------------------- */

static tp_dir3 normalise_horizontal(int64_t x, int64_t z)
{
    for (; x > TP_Q30_ONE || x < -TP_Q30_ONE || z > TP_Q30_ONE || z < -TP_Q30_ONE; z /= 2)
        x /= 2;
    return tp_normalise((int32_t)x, 0, (int32_t)z);
}

/* Returns the wave number at a node, rad/m. */
static int64_t node_wave_number(const tp_coastal_water *coastal,
                                const tp_coastal_swell *w, size_t at)
{
    return tp_coastal_local_wave_number(w->k_inf_q32,
                                        tp_coastal_floor_nodes(coastal)[at].depth);
}

static tp_coastal_wave_number node_wave_vector(const tp_coastal_water *coastal,
                                               const tp_coastal_swell *w, size_t at)
{
    const floor_gradient f = floor_rise_over_two_steps(coastal, at);
    const int64_t least = coastal->map_step / RISE_LEAST;
    tp_way up = { 0, 0 };

    if (f.x > least || f.x < -least || f.z > least || f.z < -least) {
        const tp_dir3 dir = normalise_horizontal(f.x, f.z);
        up = (tp_way){ dir.x, dir.z };
    }
    return tp_coastal_wave_vector(w, up, node_wave_number(coastal, w, at));
}

/* Turns in a step between nodes: 2^34 times 2^23 at the most. */
static int64_t turns_per_step(const tp_coastal_water *coastal, int64_t k_q32)
{
    return tp_coastal_turns_per_metre(k_q32) * (int64_t)coastal->map_step >> 16;
}

/* Computes phases along an edge, from the node `at` with a known phase, `count` times
 * `step` nodes on.  Each step adds the mean of the wave vector's component along the
 * edge at both ends. */
static void integrate_edge_phases(const tp_coastal_water *coastal,
                                  const tp_coastal_swell *w, int64_t *turns, ptrdiff_t at,
                                  ptrdiff_t step, uint32_t count)
{
    const bool east_west = step == 1 || step == -1;
    const int sign = step < 0 ? -1 : 1;
    tp_coastal_wave_number here = node_wave_vector(coastal, w, (size_t)at);

    for (uint32_t n = 1; n < count; n++, at += step) {
        const tp_coastal_wave_number next =
            node_wave_vector(coastal, w, (size_t)(at + step));
        const int64_t mean = east_west ? (here.x_q32 + next.x_q32) / 2
                                       : (here.z_q32 + next.z_q32) / 2;
        turns[at + step] = turns[at] + sign * turns_per_step(coastal, mean);
        here = next;
    }
}

/* Returns the phase of deep water at a node in turns, Q32.32; the fraction is the sum of
 * tp_swell_turns along x and z.  Only 16 bits of the whole turns are kept: more turns wrap.
 * phase_excess takes the difference of 48 bits, so the wrap cancels there. */
static int64_t deep_water_node_phase(const tp_coastal_water *coastal,
                                     const tp_coastal_wave *wave, uint32_t col,
                                     uint32_t row)
{
    const int64_t x = coastal->map_x + (int64_t)col * coastal->map_step;
    const int64_t z = coastal->map_z + (int64_t)row * coastal->map_step;
    const uint64_t turns_x = (uint64_t)wave->turns_x * (uint64_t)x >> 16;
    const uint64_t turns_z = (uint64_t)wave->turns_z * (uint64_t)z >> 16;
    return (int64_t)((turns_x + turns_z) << 16) >> 16;
}

static void init_phases(const tp_coastal_water *coastal, const tp_coastal_wave *wave,
                        tp_coastal_wave_node *rays, const tp_coastal_swell *w,
                        int64_t *turns)
{
    const uint32_t cols = coastal->map_cols, rows = coastal->map_rows;
    const uint32_t col = w->way.x < 0 ? cols - 1 : 0, row = w->way.z < 0 ? rows - 1 : 0;
    const size_t corner = (size_t)row * cols + col, count = (size_t)cols * rows;

    for (size_t i = 0; i < count; i++) {
        const int64_t f =
            (turns_per_step(coastal, node_wave_number(coastal, w, i)) + 0x80) >> 8;
        rays[i].turns = (int32_t)(uint32_t)(f < UINT32_MAX ? f : UINT32_MAX);
        turns[i] = UNKNOWN;
    }
    turns[corner] = deep_water_node_phase(coastal, wave, col, row);
    if (w->way.z != 0)
        integrate_edge_phases(coastal, w, turns, (ptrdiff_t)corner, w->way.x < 0 ? -1 : 1,
                              cols);
    if (w->way.x != 0)
        integrate_edge_phases(coastal, w, turns, (ptrdiff_t)corner,
                              w->way.z < 0 ? -(ptrdiff_t)cols : (ptrdiff_t)cols, rows);
}

/* Returns the phase in excess of deep water in Q16; 48 bits of the phases count. */
static int32_t phase_excess(int64_t turns, int64_t plane)
{
    const uint64_t more = (uint64_t)turns - (uint64_t)plane + 0x8000;
    return (int32_t)((int64_t)(more << 16) >> 32);
}

/* Converts a difference in Q30 to Q2.13. */
static int16_t q30_to_q13(int64_t q30)
{
    return (int16_t)((q30 + (1 << 16)) >> 17);
}

/* The direction of travel is the gradient of the phase. */
static void store_phases_and_directions(const tp_coastal_water *coastal,
                                        const tp_coastal_wave *wave,
                                        tp_coastal_wave_node *rays, const int64_t *turns)
{
    const size_t cols = coastal->map_cols, rows = coastal->map_rows;

    for (size_t r = 0; r < rows; r++) {
        const size_t north = r > 0 ? r - 1 : r, south = r + 1 < rows ? r + 1 : r;
        for (size_t c = 0; c < cols; c++) {
            const size_t west = c > 0 ? c - 1 : c, east = c + 1 < cols ? c + 1 : c;
            const int64_t x = turns[r * cols + east] - turns[r * cols + west];
            const int64_t z = turns[south * cols + c] - turns[north * cols + c];
            const tp_dir3 way = normalise_horizontal(x * (east - west == 2 ? 1 : 2),
                                                     z * (south - north == 2 ? 1 : 2));
            tp_coastal_wave_node *ray = &rays[r * cols + c];
            ray->turns = phase_excess(
                turns[r * cols + c],
                deep_water_node_phase(coastal, wave, (uint32_t)c, (uint32_t)r));
            ray->way_x = q30_to_q13((int64_t)way.x - wave->way_x);
            ray->way_z = q30_to_q13((int64_t)way.z - wave->way_z);
        }
    }
}

void tp_coastal_make_wave_nodes(tp_coastal_water *coastal, uint32_t i,
                                const tp_coastal_swell *swell, int64_t *scratch_turns)
{
    const tp_coastal_wave *wave = &coastal->wave[i];
    tp_coastal_wave_node *rays = tp_coastal_wave_nodes(coastal, wave);

    init_phases(coastal, wave, rays, swell, scratch_turns);
    eikonal_solve(scratch_turns, rays, coastal->map_cols, coastal->map_rows);
    store_phases_and_directions(coastal, wave, rays, scratch_turns);
}
