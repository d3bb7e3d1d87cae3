/* SPDX-License-Identifier: MIT */
/*
 * Positions of the grid's lines: equal steps in the middle, growing steps in the skirts.
 * Waves fade to 0 at the last line of the middle, so the skirts are flat.  Level of detail
 * then removes lines where they are dense on the screen; grid.h has the idea.
 */
#include "view/grid.h"

/* Returns cell (g + g^2 + ... + g^n), saturated. */
static int64_t geometric_sum(tp_fx cell, int64_t ratio, uint32_t n)
{
    int64_t step = cell, sum = 0;

    for (uint32_t i = 0; i < n && sum < (int64_t)1 << 40; i++) {
        step = step * ratio >> 16;
        sum += step;
    }
    return sum;
}

/* Returns the ratio, 16.16, for n growing steps over the distance `way`; at least 1. */
static int64_t solve_ratio(tp_fx cell, int64_t way, uint32_t n)
{
    int64_t low = TP_FX_ONE, high = 256 * TP_FX_ONE;

    while (high - low > 1) {
        int64_t middle = (low + high) / 2;
        if (geometric_sum(cell, middle, n) <= way)
            low = middle;
        else
            high = middle;
    }
    return low;
}

uint32_t tp_grid_lines_skirt_count(uint32_t count, const tp_grid_view *view)
{
    uint32_t flank = view->reach > 0 ? count / 8 : 0;
    return flank < TP_GRID_FLANK ? flank : TP_GRID_FLANK;
}

/* Returns the ratio of the skirts' steps.  A skirt ends at the scene's reach, or at 16000
 * m from the centre. */
static int64_t skirt_growth_ratio(uint32_t count, const tp_grid_view *view)
{
    TP_ASSERT(count >= 2 && view->cell > 0);
    uint32_t flank = tp_grid_lines_skirt_count(count, view);
    tp_fx half = (tp_fx)((int64_t)view->cell * (count - 2 * flank - 1) / 2);
    int64_t most = 16000 * TP_FX_ONE - half;
    int64_t way = view->reach < most ? view->reach : most;

    return flank ? solve_ratio(view->cell, way, flank) : 0;
}

/* Returns the centre of the grid, in whole cells.  The grid lies ahead of the eye; the
 * eye is a tenth of the middle away from the rear edge. */
static tp_fx grid_centre(tp_fx eye, tp_q30 ahead, uint32_t count, const tp_grid_view *view)
{
    if (!view->follow)
        return 0;
    int64_t core = (int64_t)view->cell * (count - 2 * (count / 8)) * 2 / 5;
    int64_t centre = eye + (core * ahead >> 30);
    int64_t cells = centre / view->cell;
    return (tp_fx)(cells * view->cell);
}

static tp_fx axis_centre(uint32_t count, const tp_grid_view *view, bool along_z)
{
    const tp_projection *projection = view->projection;
    return along_z ? grid_centre(projection->eye.z, projection->ahead.z, count, view)
                   : grid_centre(projection->eye.x, projection->ahead.x, count, view);
}

void tp_grid_lines_place(tp_grid_line *line, uint32_t count, const tp_grid_view *view,
                         bool along_z)
{
    uint32_t flank = tp_grid_lines_skirt_count(count, view);
    uint32_t core = count - 2 * flank, last = flank + core - 1;
    tp_fx centre = axis_centre(count, view, along_z);
    tp_fx half = (tp_fx)((int64_t)view->cell * (core - 1) / 2);
    int64_t ratio = skirt_growth_ratio(count, view), step = view->cell;
    uint32_t fading = flank ? core / 8 + 1 : 0;

    for (uint32_t k = flank; k <= last; k++) {
        uint32_t from_edge = k - flank < last - k ? k - flank : last - k;
        line[k].place = centre - half + (tp_fx)(k - flank) * view->cell;
        line[k].fade = fading == 0 ? TP_FX_ONE
                     : tp_smoothstep((tp_fx)((from_edge << 16) / fading));
    }
    for (uint32_t k = 1; k <= flank; k++) {
        step = step * ratio >> 16;
        line[last + k].place = line[last + k - 1].place + (tp_fx)step;
        line[flank - k].place = line[flank - k + 1].place - (tp_fx)step;
        line[last + k].fade = line[flank - k].fade = 0;
    }
}

tp_grid_extent tp_grid_lines_extent(uint32_t count, const tp_grid_view *view, bool along_z)
{
    uint32_t flank = tp_grid_lines_skirt_count(count, view), core = count - 2 * flank;
    tp_fx centre = axis_centre(count, view, along_z);
    tp_fx half = (tp_fx)((int64_t)view->cell * (core - 1) / 2);
    tp_fx low = centre - half, high = low + (tp_fx)(core - 1) * view->cell;
    int64_t ratio = skirt_growth_ratio(count, view), step = view->cell;
    tp_grid_extent extent = {
        low, high, { low, high }, flank ? view->cell * (tp_fx)(core / 8 + 1) : 0,
    };

    for (uint32_t k = 0; k < flank; k++) {
        step = step * ratio >> 16;
        extent.first -= (tp_fx)step;
        extent.last += (tp_fx)step;
    }
    return extent;
}

tp_fx tp_grid_extent_wave_weight(const tp_grid_extent *extent, tp_fx place)
{
    TP_ASSERT(extent->fading >= 0);
    int64_t low = (int64_t)place - extent->calm[0];
    int64_t high = (int64_t)extent->calm[1] - place;
    int64_t from_edge = low < high ? low : high;

    if (extent->fading == 0 || from_edge >= extent->fading)
        return TP_FX_ONE;
    return from_edge <= 0 ? 0 : tp_smoothstep(tp_fx_div((tp_fx)from_edge, extent->fading));
}

/* -- level of detail: distance of lines ---------------------------------------------- */

/* A ray in px, Q.16: along the camera's heading, across the heading (the absolute value),
 * down. */
typedef struct {
    int64_t ahead, aside, down;
} ray;

static int64_t along(const tp_projection *projection, int32_t u, int32_t v, tp_q30 right,
                     tp_q30 up, tp_q30 ahead)
{
    return ((int64_t)projection->focal * ahead + (int64_t)u * 4096 * right
            + (int64_t)v * 4096 * up) >> 30;
}

/* Returns the ray from the eye through a corner (u, v) of the picture, 28.4 px from the
 * picture's centre.  Its components are relative to the camera's horizontal heading
 * (hx, hz), a unit vector. */
static ray corner_ray(const tp_projection *projection, int32_t u, int32_t v, tp_q30 hx,
                      tp_q30 hz)
{
    int64_t x = along(projection, u, v, projection->turn.x.x, projection->turn.y.x,
                      projection->ahead.x);
    int64_t y = along(projection, u, v, projection->turn.x.y, projection->turn.y.y,
                      projection->ahead.y);
    int64_t z = along(projection, u, v, projection->turn.x.z, projection->turn.y.z,
                      projection->ahead.z);
    int64_t aside = (x * hz - z * hx) >> 30;

    return (ray){ (x * hx + z * hz) >> 30, aside < 0 ? -aside : aside, -y };
}

/* Returns the widest tangent between the heading and a corner of the picture, 0 if a ray
 * leads backwards. *down: the steepest fall of a ray, px. */
static tp_fx find_widest(const tp_projection *projection, tp_dir3 heading, int64_t *down)
{
    tp_fx wide = 1;

    *down = 1;
    for (int k = 0; k < 4; k++) {
        ray r =
            corner_ray(projection, k & 1 ? projection->u0 : -projection->u0,
                       k & 2 ? projection->v0 : -projection->v0, heading.x, heading.z);
        *down = r.down > *down ? r.down : *down;
        if (r.ahead <= 0 || r.aside >= r.ahead * 64)
            return 0;
        tp_fx tangent = (tp_fx)(r.aside * TP_FX_ONE / r.ahead);
        wide = tangent > wide ? tangent : wide;
    }
    return wide;
}

/* Returns the step per distance, Q.24: TP_LOD_PIXELS / (focal (cos + sin tan)). cos and
 * sin belong to the angle between the heading and the direction of a side's lines, tan is
 * the view's widest tangent.  If cos + sin tan <= 0 the lines are not visible and the
 * rate is the maximum. */
static int32_t side_rate(const tp_projection *projection, tp_fx wide, tp_q30 cosine,
                         tp_q30 sine)
{
    int64_t share = cosine + ((int64_t)tp_abs(sine) * wide >> 16);     /* Q.30 */
    int64_t most = (int64_t)1 << 24;

    if (wide == 0 || share <= 0)
        return wide == 0 ? 0 : (int32_t)most;
    int64_t rate =
        ((int64_t)TP_LOD_PIXELS << 46) / ((projection->focal * (share >> 4)) >> 20);
    return (int32_t)(rate < most ? rate : most);
}

/* Sets the step limits of both axes, for water no higher than `height`. */
static void set_lod_step_limits(tp_lod_axis lod[2], const tp_projection *projection,
                                tp_fx height, tp_fx cell)
{
    tp_dir3 heading = tp_normalise(projection->ahead.x, 0, projection->ahead.z);
    int64_t down;
    tp_fx   wide = find_widest(projection, heading, &down);
    tp_fx   over = projection->eye.y - height;
    int64_t least = over > 0 ? (int64_t)over * TP_LOD_PIXELS * TP_FX_ONE / down : 0;

    lod[0] = (tp_lod_axis){
        projection->eye.x, cell, tp_fx_saturate(least),
        { side_rate(projection, wide, -heading.x, heading.z),
          side_rate(projection, wide, heading.x, heading.z) },
    };
    lod[1] = (tp_lod_axis){
        projection->eye.z, cell, tp_fx_saturate(least),
        { side_rate(projection, wide, -heading.z, heading.x),
          side_rate(projection, wide, heading.z, heading.x) },
    };
}

tp_fx tp_lod_step(const tp_lod_axis *lod, tp_fx place)
{
    int64_t way = (int64_t)place - lod->eye;
    int64_t step = (way < 0 ? -way : way) * lod->rate[way >= 0] >> 24;

    return tp_fx_saturate(step > lod->least ? step : lod->least);
}

/* -- level of detail: lines ---------------------------------------------------------- */

/* Returns the index of the cell at a position, counted from the world's origin; lines may
 * lie in the middle of cells. */
static int32_t cell_index(const tp_lod_axis *lod, tp_fx place)
{
    TP_ASSERT(lod->cell > 0);
    int64_t cells = (int64_t)place / lod->cell;
    return (int32_t)(cells - ((int64_t)place < cells * lod->cell));
}

/* Removes lines between the skirts and moves the other lines up.  Lines between the
 * skirts are a cell apart; skirt lines stay.  Returns the new number of lines. */
static uint32_t thin(const tp_lod_axis *lod, tp_grid_line *line, uint32_t count,
                     uint32_t flank)
{
    uint32_t first = flank, last = count - 1 - flank;
    TP_ASSERT(first <= last && last < count);
    uint32_t at = (uint32_t)cell_index(lod, line[first].place), left = first + 1;

    for (uint32_t k = first + 1; k < count; k++) {
        uint32_t level = 0;
        tp_fx    step = k < last ? tp_lod_step(lod, line[k].place) : 0;
        while (level < TP_LOD_LEVELS && step >> (level + 1) >= lod->cell)
            level++;
        if (((at + (k - first)) & ((1u << level) - 1)) == 0 || k >= last)
            line[left++] = line[k];
    }
    return left;
}

void tp_lod_thin(tp_grid *grid, const tp_grid_view *view)
{
    set_lod_step_limits(grid->lod, view->projection,
                        tp_surface_height_bound(view->surface), view->cell);
    grid->cols = thin(&grid->lod[0], grid->column, grid->cols,
                      tp_grid_lines_skirt_count(grid->cols, view));
    grid->rows = thin(&grid->lod[1], grid->row, grid->rows,
                      tp_grid_lines_skirt_count(grid->rows, view));
}

void tp_lod_layout(tp_grid *grid, tp_arena *arena)
{
    struct tp_lod_axis *lod = tp_arena_alloc(arena, 2, sizeof *lod);
    if (lod)                    /* NULL if the arena only counts bytes */
        grid->lod = lod;
}

/* -- level of detail: waves ---------------------------------------------------------- */

/* Returns the weight left of a wave on a grid of coarse lines.  `scaled_turns`: turns of
 * the wave from line to line, 16.16, times 6 for heights or 4 for slopes.  The weight is 1
 * up to 1 scaled turn and 0 from 2 on, but at least `min_weight`. */
static tp_fx compute_lod_weight(uint64_t scaled_turns, tp_fx min_weight)
{
    tp_fx weight = scaled_turns >= 2 * TP_FX_ONE
                       ? 0
                       : tp_smoothstep(2 * TP_FX_ONE - (tp_fx)scaled_turns);
    return weight > min_weight ? weight : min_weight;
}

tp_lod_share tp_lod_swell_share(const tp_lod_axis *lod, tp_fx step, int64_t turns)
{
    uint64_t of_step = (uint64_t)(turns < 0 ? -turns : turns) * (uint32_t)step >> 32;
    tp_fx    min_weight = 0;

    if (step <= lod->cell || of_step * 6 <= TP_FX_ONE)
        return (tp_lod_share){ TP_FX_ONE, TP_FX_ONE };
    if (step < 2 * lod->cell)
        min_weight = tp_fx_div(2 * lod->cell - step, lod->cell);
    return (tp_lod_share){ compute_lod_weight(of_step * 6, min_weight),
                           compute_lod_weight(of_step * 4, min_weight) };
}
