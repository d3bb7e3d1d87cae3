/* SPDX-License-Identifier: MIT */
/* The wake.  A hull that moves through a pool's cells, or sinks into them, displaces
 * water, [E4]: H += b (sub before - sub now), sub the submerged column over a cell.
 *
 * The hull's form is a parabola along both axes: with alpha and beta from -1 to 1 over
 * length and beam, sub = (1 - alpha^2)(1 - beta^2)(draft + water height over the local
 * waterline).  The column vanishes at the rim, so no cell gets a sudden impulse.  The
 * form holds 4/9 of its box, as real hulls do.  A hull smaller than three cells is
 * stretched to three cells and made shallower by the same factor, because the pool cannot
 * carry shorter waves.
 *
 * Each sub is a function of the hull alone, rounded to the cells' LSB.  The pool gets the
 * difference of two such numbers.  A hull that returns to its earlier pose has therefore
 * added exactly nothing under itself, whatever the roundings.  The hull before is the
 * hull at the last stirring, not at the last tick.  Changes below two LSB accumulate
 * until they exceed two LSB, so pool and boat come to rest.
 *
 * The hull heaves as if the pool were absent, in swells, rings and a field under the
 * hull.  A hull that reacted to its own ripples could drive them for ever: a hull sinking
 * here pulls water down, while the boat's lag behind a wave should push the water up.
 *
 * The cells around the hull take the negative sum of the differences.  A remainder goes
 * to any cell within reach, at worst to the cells where the water came from. */
#include "base/base.h"
#include "features/boat/boat.h"
#include "world/pools.h"

#define PEAK_LEAST 2                    /* LSB */
#define AROUND     TP_FX(1.5)           /* times half the hull's sides */

/* A hull over the cells.  The axes are per metre: alpha = (dx, dz) . along. */
typedef struct {
    tp_fx   x, z;
    tp_turn heading;
    int64_t along_q24[2], across_q24[2];
    tp_fx   length, beam;               /* half lengths, m */
    tp_fx   heave, rise, tilt;          /* immersed depth amidships, and its
                                         * differences bow - stern, port - starboard, m */
    tp_fx   max_depth;                  /* limit of the immersed depth: 2 draft, m */
    tp_q30  share;                      /* b times the factor of shallowness */
} hull_form;

/* -- the hull's form ----------------------------------------------------------------- */

/* Returns half a side, at least 1.5 cells. */
static tp_fx half_side_at_least_1_5_cells(tp_fx side, const tp_pool *pool)
{
    TP_ASSERT(side > 0 && pool->cell > 0);
    tp_fx least = pool->cell + pool->cell / 2;
    return side / 2 > least ? side / 2 : least;
}

/* Returns the hull's form over the pool.  A sine over half a side, 0.05 m or more, is
 * below 2^29 in Q24. */
static hull_form make_form(const tp_hull *hull, const tp_scene *scene, const tp_pool *pool)
{
    tp_fx   length = half_side_at_least_1_5_cells(scene->boat.length, pool);
    tp_fx   beam = half_side_at_least_1_5_cells(scene->boat.beam, pool);
    int64_t s = (int64_t)tp_sin(hull->heading) * 1024;      /* Q40; the quotient is Q24 */
    int64_t c = (int64_t)tp_cos(hull->heading) * 1024;
    int64_t slim = ((int64_t)scene->boat.length << 29) / length;
    int64_t fine = ((int64_t)scene->boat.beam << 29) / beam;
    int64_t wide = slim * fine >> 30;

    return (hull_form){
        .x = hull->x, .z = hull->z, .heading = hull->heading,
        .along_q24 = { s / length, -c / length },
        .across_q24 = { c / beam, s / beam },
        .length = length, .beam = beam,
        .heave = scene->boat.draft + hull->immersion[0],
        .rise = hull->immersion[1], .tilt = hull->immersion[2],
        .max_depth = 2 * scene->boat.draft,
        .share = tp_q30_mul((int32_t)wide, scene->boat.wake << 14),
    };
}

/* Computes alpha and beta of a place, 16.16.  A distance is below 2^32 and an axis below
 * 2^29, so the sum of two products stays below 2^62.  After the shift up to 38 bits
 * remain. */
static void hull_coordinates(const hull_form *f, tp_fx x, tp_fx z, int64_t at[2])
{
    const int64_t dx = (int64_t)x - f->x, dz = (int64_t)z - f->z, half = 1 << 23;

    at[0] = (dx * f->along_q24[0] + dz * f->along_q24[1] + half) >> 24;
    at[1] = (dx * f->across_q24[0] + dz * f->across_q24[1] + half) >> 24;
}

static bool are_magnitudes_smaller(const int64_t at[2], tp_fx limit)
{
    return at[0] > -limit && at[0] < limit && at[1] > -limit && at[1] < limit;
}

/* Returns the immersed depth of the hull at (x, z) times `share`, in the pool's LSB; 0
 * outside of the hull.  A depth of at most 40 m and parabolas of at most 1 keep each
 * product below 2^38. */
static int32_t weighted_immersed_depth(const hull_form *f, const tp_pool *pool, tp_fx x,
                                       tp_fx z)
{
    int64_t at[2];

    hull_coordinates(f, x, z, at);
    if (!are_magnitudes_smaller(at, TP_FX_ONE))
        return 0;
    tp_fx alpha = (tp_fx)at[0], beta = (tp_fx)at[1];
    tp_fx deep = f->heave + tp_fx_mul(alpha, f->rise / 2) - tp_fx_mul(beta, f->tilt / 2);
    tp_fx lean = tp_fx_mul(TP_FX_ONE - tp_fx_mul(alpha, alpha),
                           TP_FX_ONE - tp_fx_mul(beta, beta));
    tp_fx metres = tp_fx_mul(tp_clamp(deep, 0, f->max_depth), lean);
    return tp_pool_from_metres(pool, tp_q30_mul(metres, f->share));
}

/* -- cells --------------------------------------------------------------------------- */

/* A rectangle of cells within the hulls' reach, scanned row by row.  In a tiled field the
 * rectangle may extend beyond the field's edge; its cells then wrap. */
typedef struct {
    int32_t col0, col1, row0, row1;
} cell_box;

typedef struct {
    tp_pool *pool;
    hull_form before, now;
    int32_t  peak;              /* largest change of a cell, LSB */
} wake;

typedef struct {
    int32_t  col, row;
    uint32_t in_col, in_row;    /* wrapped: cell of the pool */
    tp_fx    x, z;              /* centre of the cell, m */
} wake_cell;

static uint32_t wrap_index(int32_t i, uint32_t count)
{
    int32_t n = i % (int32_t)count;
    return (uint32_t)(n < 0 ? n + (int32_t)count : n);
}

/* Returns the coordinate of the outer edge of the first column or row of cells. */
static int64_t first_cell_edge(tp_fx middle, tp_fx cell, uint32_t count)
{
    return middle - (int64_t)count * cell / 2;
}

/* Returns the centre of column or row i.  Centres are exactly one side apart, to the
 * LSB. */
static tp_fx cell_centre(tp_fx middle, tp_fx cell, uint32_t count, int32_t i)
{
    return (tp_fx)(first_cell_edge(middle, cell, count) + cell / 2 + (int64_t)i * cell);
}

/* Returns the cell with its indices wrapped into the pool and its centre in the world,
 * m. */
static wake_cell locate_wake_cell(const tp_pool *pool, int32_t col, int32_t row)
{
    TP_ASSERT(pool->cols > 0 && pool->rows > 0);
    return (wake_cell){
        col, row, wrap_index(col, pool->cols), wrap_index(row, pool->rows),
        cell_centre(pool->x, pool->cell, pool->cols, col),
        cell_centre(pool->z, pool->cell, pool->rows, row),
    };
}

/* Returns the position before the first cell, as next_cell expects.  An empty box has no
 * cells. */
static wake_cell position_before_first_cell(const cell_box *b)
{
    bool empty = b->col0 > b->col1;
    return (wake_cell){ .col = b->col1, .row = empty ? b->row1 : b->row0 - 1 };
}

/* Steps to the next cell.  Returns false after the last cell. */
static bool next_cell(const tp_pool *pool, const cell_box *b, wake_cell *at)
{
    if (at->col < b->col1) {
        at->col++;
        at->in_col = at->in_col + 1 < pool->cols ? at->in_col + 1 : 0;
        at->x += pool->cell;
        return true;
    }
    if (at->row >= b->row1)
        return false;
    *at = locate_wake_cell(pool, b->col0, at->row + 1);
    return true;
}

/* Computes the first and last cell between low and high, m.  In a tiled field the count
 * is at most the number of cells of the field. */
static void find_cell_range(const tp_pool *pool, uint32_t count, tp_fx middle, int64_t low,
                            int64_t high, int32_t ends[2])
{
    int64_t start = first_cell_edge(middle, pool->cell, count), most = (int64_t)count - 1;
    int64_t a = (low - start) / pool->cell - 1, b = (high - start) / pool->cell + 1;

    if (pool->edges == TP_EDGES_TILE) {
        int64_t spare = b - a - most;
        a += spare > 0 ? spare / 2 : 0;
        b = spare > 0 ? a + most : b;
    } else {
        a = a < 0 ? 0 : a;
        b = b > most ? most : b;
    }
    ends[0] = (int32_t)a;
    ends[1] = (int32_t)b;
}

static int64_t min_int64(int64_t a, int64_t b) { return a < b ? a : b; }
static int64_t max_int64(int64_t a, int64_t b) { return a > b ? a : b; }

/* Returns the hull's largest extent from its middle along an axis of the world. */
static tp_fx hull_half_extent(const hull_form *f, tp_turn heading)
{
    return tp_q30_mul(f->length, tp_abs(tp_sin(heading)))
         + tp_q30_mul(f->beam, tp_abs(tp_cos(heading)));
}

/* Returns the cells reached by the hulls before and after.  `enlargement` scales the half
 * extents; 1 is the hull itself. */
static cell_box hull_cell_box(const wake *w, tp_fx enlargement)
{
    const hull_form *a = &w->before, *b = &w->now;
    const tp_pool *pool = w->pool;
    const tp_turn quarter = 0x40000000;
    int64_t ax = tp_fx_mul(hull_half_extent(a, a->heading), enlargement);
    int64_t az = tp_fx_mul(hull_half_extent(a, a->heading + quarter), enlargement);
    int64_t bx = tp_fx_mul(hull_half_extent(b, b->heading), enlargement);
    int64_t bz = tp_fx_mul(hull_half_extent(b, b->heading + quarter), enlargement);
    int32_t col[2], row[2];

    find_cell_range(pool, pool->cols, pool->x, min_int64(a->x - ax, b->x - bx),
                    max_int64(a->x + ax, b->x + bx), col);
    find_cell_range(pool, pool->rows, pool->z, min_int64(a->z - az, b->z - bz),
                    max_int64(a->z + az, b->z + bz), row);
    return (cell_box){ col[0], col[1], row[0], row[1] };
}

/* -- stirring ------------------------------------------------------------------------ */

/* Returns the change of height of a cell, LSB. */
static int32_t height_change(const wake *w, const wake_cell *at)
{
    return weighted_immersed_depth(&w->before, w->pool, at->x, at->z)
           - weighted_immersed_depth(&w->now, w->pool, at->x, at->z);
}

/* True for a water cell around the current hull: outside of the hull, within AROUND of
 * it. */
static bool is_surrounding_cell(const wake *w, const wake_cell *at)
{
    int64_t way[2];

    hull_coordinates(&w->now, at->x, at->z, way);
    return are_magnitudes_smaller(way, AROUND) && !are_magnitudes_smaller(way, TP_FX_ONE)
           && !tp_pool_is_wall_or_outside(w->pool, at->in_col, at->in_row);
}

/* Adds height to a cell and returns the amount that fitted: 0 in walls. */
static int32_t add_cell_height(wake *w, const wake_cell *at, int64_t lsb)
{
    int32_t part = (int32_t)tp_clamp_abs(lsb, INT32_MAX);
    int32_t added = tp_pool_add_cell_height(w->pool, at->in_col, at->in_row, part);

    w->peak = tp_abs(added) > w->peak ? tp_abs(added) : w->peak;
    return added;
}

/* Returns the largest change of a cell; stops at PEAK_LEAST, because more makes no
 * difference. */
static int32_t largest_height_change(const wake *w, const cell_box *b)
{
    int32_t highest = 0;

    for (wake_cell at = position_before_first_cell(b);
         highest < PEAK_LEAST && next_cell(w->pool, b, &at);) {
        int32_t size = tp_abs(height_change(w, &at));
        highest = size > highest ? size : highest;
    }
    return highest;
}

/* Applies all changes and returns the sum of the amounts that fitted. */
static int64_t apply_height_changes(wake *w, const cell_box *b)
{
    int64_t sum = 0;

    for (wake_cell at = position_before_first_cell(b); next_cell(w->pool, b, &at);) {
        int32_t lsb = height_change(w, &at);
        sum += lsb ? add_cell_height(w, &at, lsb) : 0;
    }
    return sum;
}

static int64_t count_surrounding_cells(const wake *w, const cell_box *b)
{
    int64_t count = 0;

    for (wake_cell at = position_before_first_cell(b); next_cell(w->pool, b, &at);)
        count += is_surrounding_cell(w, &at);
    return count;
}

/* Spreads `sum` evenly over the cells around the hull: of n cells the i-th gets the part
 * between (i - 1) sum / n and i sum / n.  |sum| is below 2^18 cells of 2^31.  Returns the
 * remainder that did not fit. */
static int64_t fill_surrounding_cells(wake *w, const cell_box *b, int64_t sum)
{
    int64_t n = count_surrounding_cells(w, b), i = 0, given = 0, left = sum;

    for (wake_cell at = position_before_first_cell(b); next_cell(w->pool, b, &at);) {
        if (!is_surrounding_cell(w, &at))
            continue;
        i++;
        int64_t due = sum / n * i + sum % n * i / n;
        left -= due != given ? add_cell_height(w, &at, due - given) : 0;
        given = due;
    }
    return left;
}

/* Adds `left`, the sum that did not fit around the hull, to the first cells of the box with
 * room for more. */
static void fill_cells_with_room(wake *w, const cell_box *b, int64_t left)
{
    for (wake_cell at = position_before_first_cell(b);
         left != 0 && next_cell(w->pool, b, &at);)
        left -= add_cell_height(w, &at, left);
}

static void stir_pool(wake *w, const cell_box *hulls)
{
    int64_t left = -apply_height_changes(w, hulls);

    if (left != 0) {
        const cell_box around = hull_cell_box(w, AROUND);
        left = fill_surrounding_cells(w, &around, left);
        fill_cells_with_room(w, &around, left);
    }
    tp_pool_start_carry_rounding(w->pool, w->peak);
}

/* ----------------------------------------------------------------------------------- */

static bool is_same(const tp_hull *a, const tp_hull *b)
{
    return a->x == b->x && a->z == b->z && a->heading == b->heading
           && a->immersion[0] == b->immersion[0] && a->immersion[1] == b->immersion[1]
           && a->immersion[2] == b->immersion[2];
}

tp_pool *tp_boat_pool(tp_world *world)
{
    tp_pool *pool = tp_world_mutable_pool(world);
    return pool ? pool : tp_world_mutable_field(world);
}

void tp_boat_stir_pool(tp_world *world, const tp_scene *scene)
{
    tp_boat_state *a = &world->boat_state;
    wake w = { .pool = tp_boat_pool(world) };

    if (!w.pool || is_same(&a->hull, &a->wake_hull))
        return;
    w.before = make_form(&a->wake_hull, scene, w.pool);
    w.now = make_form(&a->hull, scene, w.pool);
    const cell_box hulls = hull_cell_box(&w, TP_FX_ONE);
    int32_t peak = largest_height_change(&w, &hulls);
    if (peak >= PEAK_LEAST) {
        stir_pool(&w, &hulls);
        a->wake_ticks++;
    }
    if (peak == 0 || peak >= PEAK_LEAST)
        a->wake_hull = a->hull;
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_wake_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->boat.mesh[0] != '\0';
}

static void step(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *input)
{
    (void)mine, (void)program, (void)input;
    if (scene->boat.mesh[0])
        tp_boat_stir_pool(world, scene);
}

const tp_module tp_wake_module = {
    .name = "wake", .id = TP_MODULE_ID('w', 'a', 'k', 'e'), .enabled = tp_wake_enabled,
    .step = step,
};
