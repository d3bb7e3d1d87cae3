/* SPDX-License-Identifier: MIT */
/* The fast rungs of scanline water: raster/fast_scanlines.h over the lines of the scanline
 * grid.  Rows clipped by the frustum are drawn as triangles, as the exact rung does; there
 * are no middle lines.  The stages of water read the depth of level water, one number a row
 * of pixels if the picture does not roll. */
#include "frame/scanline_grid.h"

typedef struct {
    const tp_frame *frame;
    tp_grid_window  window;
    tp_fast_rows    rows;
    tp_column_range columns;    /* of the current row of cells; empty: x0 >= x1 */
} walk;

/* -- lines --------------------------------------------------------------------------- */

static void set_walked(walk *w, tp_column_range pixels)
{
    const int bits = w->rows.column_bits - 4;

    w->rows.x0 = pixels.x0 >> bits;
    w->rows.x1 = (pixels.x1 + (1 << bits) - 1) >> bits;
}

/* Returns point m of a line, as tp_line_point does. */
static inline tp_row_point make_point(const tp_fan *fan, const tp_fan_row *row,
                                      const tp_grid_vertex *vertex, uint32_t m)
{
    const tp_grid_vertex *v = &vertex[m];

    return (tp_row_point){
        v->u, v->v, v->zi, tp_fan_x(fan, row, m), tp_fan_z(fan, row, m),
        (uint32_t)(uint16_t)v->slope_x << 16 | (uint16_t)v->slope_z,
    };
}

static void lay_segments(walk *w, uint32_t k, tp_grid_span part, tp_column_range pixels)
{
    const tp_frame *frame = w->frame;
    const tp_fan *fan = frame->buffers.grid->fan;
    const tp_grid_vertex *vertex = w->window.line[k & 1];
    const struct tp_draw_row_land *land = tp_line_land(frame);
    int32_t right = vertex[part.first].u;
    tp_row_point end[2];        /* of point m: end[m & 1], if `made` */
    bool made = false;

    for (uint32_t m = part.first; m < part.end; m++) {
        const int32_t left = right;
        right = vertex[m + 1].u;
        bool out = left == TP_GRID_NEEDS_CLIP || right == TP_GRID_NEEDS_CLIP
                   || right <= 16 * pixels.x0 || left >= 16 * pixels.x1;
        if (!out && land && land->is_land(frame, k, m)) {
            tp_fast_rows_remove(&w->rows, left, right);
            out = true;
        }
        if (!out && !made)
            end[m & 1] = make_point(fan, &fan->row[k], vertex, m);
        made = !out;
        if (out)
            continue;
        end[~m & 1] = make_point(fan, &fan->row[k], vertex, m + 1);
        tp_fast_rows_lay(&w->rows, &end[m & 1], &end[~m & 1]);
    }
}

static void draw_line(walk *w, uint32_t k, tp_grid_span segments, tp_column_range pixels,
                      tp_line_kind kind)
{
    const tp_line_scale *scale = &w->frame->buffers.fast_lines->scale[k];

    tp_fast_rows_begin_line(&w->rows, kind == TP_LINE_ON ? scale : NULL);
    if (segments.first < segments.end)
        lay_segments(w, k, segments, pixels);
    tp_fast_rows_end_line(&w->rows, kind);
}

static void draw_edge(walk *w, const tp_row_point *left, const tp_row_point *right,
                      tp_line_kind kind)
{
    tp_fast_rows_begin_line(&w->rows, NULL);
    tp_fast_rows_lay(&w->rows, left, right);
    tp_fast_rows_end_line(&w->rows, kind);
}

/* Draws line k after line k + 1, with the left and right ends of the row of cells between
 * both. */
static void draw_sided(walk *w, uint32_t k, tp_grid_span segments, tp_column_range pixels)
{
    tp_row_point was[2], now[2];

    tp_line_ends(w->frame, &w->window, k + 1, was);
    tp_line_ends(w->frame, &w->window, k, now);
    const bool left = was[0].u != TP_GRID_NEEDS_CLIP && now[0].u != TP_GRID_NEEDS_CLIP;
    const bool right = was[1].u != TP_GRID_NEEDS_CLIP && now[1].u != TP_GRID_NEEDS_CLIP;
    if (left)
        draw_edge(w, &now[0], &was[0], TP_LINE_BEHIND_GAP);
    if (right)
        draw_edge(w, &was[1], &now[1], TP_LINE_BEHIND_GAP);
    if (left)
        draw_edge(w, &was[0], &now[0], TP_LINE_ON);
    draw_line(w, k, segments, pixels, TP_LINE_ON);
    if (right)
        draw_edge(w, &now[1], &was[1], TP_LINE_ON);
}

/* Draws line k, the far end of the current row of cells and the near end of the next. */
static void advance_to_line(walk *w, uint32_t k, tp_line_kind kind)
{
    const bool before = w->columns.x0 < w->columns.x1;
    const tp_column_range walked =
        tp_line_next_columns(w->frame, w->rows.tile, k, &w->columns);

    if (walked.x0 >= walked.x1)
        return;
    set_walked(w, walked);
    const bool sided = kind == TP_LINE_ON && before
                       && (w->frame->buffers.lines->line[k].is & TP_LINE_SIDED);
    const tp_grid_span segments = tp_line_reached(w->frame, k, walked);
    if (sided)
        tp_line_load(w->frame, &w->window, k + 1, segments, true);
    tp_line_load(w->frame, &w->window, k, segments, sided);
    if (sided)
        draw_sided(w, k, segments, walked);
    else
        draw_line(w, k, segments, walked, kind);
}

static walk begin_walk(const tp_frame *frame, const tp_gbuffer *tile, void *memory,
                       bool keyed)
{
    walk w = { .frame = frame, .window = tp_frame_grid_window(frame, tile, memory) };

    tp_fast_rows_begin(&w.rows, tile, memory, frame->column_bits, keyed);
    w.rows.oblique = frame->buffers.grid->fan->law.walls;
    return w;
}

/* -- a tile -------------------------------------------------------------------------- */

static void draw_fast_rows(const tp_frame *frame, tp_gbuffer *tile, void *memory)
{
    const tp_frame_lines *lines = frame->buffers.lines;
    walk w = begin_walk(frame, tile, memory, true);
    tp_line_kind kind = TP_LINE_BEHIND_GAP;

    tile->front_only = frame->cull_water;
    w.rows.solid = tp_frame_has_solids(frame);
    for (uint32_t k = lines->lines; k-- > 0 && w.rows.open > 0;) {
        advance_to_line(&w, k, kind);
        if (k == 0)
            break;
        const tp_frame_line *next = &lines->line[k - 1];
        if (next->cells.first >= next->cells.end) {
            kind = TP_LINE_BEHIND_GAP;
        } else if (next->is & TP_LINE_CUT) {
            if (frame->program->draw.cells)
                frame->program->draw.cells->draw_row(frame, tile, &w.window, k - 1);
            w.rows.solid = true;
            kind = TP_LINE_BEHIND_TRIANGLES;
        } else {
            kind = w.columns.x0 < w.columns.x1 ? TP_LINE_ON : TP_LINE_BEHIND_GAP;
        }
    }
}

/* True if all rows of cells in the tile are whole and reach from side to side. */
static bool is_simple(const tp_frame *frame, const tp_gbuffer *tile)
{
    const tp_frame_lines *lines = frame->buffers.lines;

    if (frame->buffers.grid->dry)
        return false;
    for (uint32_t k = 0; k + 1 < lines->lines; k++)
        if ((lines->line[k].is & (TP_LINE_CUT | TP_LINE_SIDED))
            && tp_box_overlaps_tile(&lines->line[k].box, tile))
            return false;
    return true;
}

static bool draw_alone(const tp_frame *frame, const tp_gbuffer *tile, void *memory,
                       tp_water_rows *found)
{
    const tp_frame_lines *lines = frame->buffers.lines;
    tp_line_kind kind = TP_LINE_BEHIND_GAP;

    if (!is_simple(frame, tile))
        return false;
    walk w = begin_walk(frame, tile, memory, false);
    w.rows.means = tp_frame_has_packed_rows(frame) && tp_frame_has_half_lines(frame)
                   && tile->y0 % 16 == 0 && tile->y1 == tile->y0 + 16;
    for (uint32_t k = lines->lines; k-- > 0 && w.rows.open > 0 && !w.rows.holes;) {
        advance_to_line(&w, k, kind);
        kind = w.columns.x0 < w.columns.x1 ? TP_LINE_ON : TP_LINE_BEHIND_GAP;
    }
    if (w.rows.holes)
        return false;
    *found = tp_fast_rows_found(&w.rows);
    tp_frame_write_alone_keys(frame, &w.rows, found);
    return true;
}

/* -- placement ----------------------------------------------------------------------- */

static void layout_fast_lines(tp_frame_buffers *buffers, tp_arena *arena,
                              const tp_program *program, const tp_scene *scene,
                              const tp_config *config)
{
    tp_fast_lines *to = tp_arena_alloc(arena, 1, sizeof *to);
    tp_line_scale *scale = tp_arena_alloc(
        arena, tp_fan_most_rows(tp_fan_budget(scene)), sizeof *scale);

    (void)program;
    (void)config;
    if (to)
        to->scale = scale;
    buffers->fast_lines = to;
}

/* Returns the scale of a line at its middle, on level water.  Beyond the near plane the
 * depth is limited. */
static tp_line_scale make_line_scale(const tp_frame *frame, uint32_t k)
{
    const tp_projection *p = &frame->projection;
    const tp_grid *grid = frame->buffers.grid;
    const tp_dir3 along = tp_fan_rows_direction(&p->turn, grid->fan->law.walls);
    const uint32_t m = grid->cols / 2;
    const int64_t x = (int64_t)tp_grid_s(grid, m, k) - p->eye.x, y = -(int64_t)p->eye.y;
    const int64_t z = (int64_t)tp_grid_t(grid, m, k) - p->eye.z;
    const int64_t ahead = -((x * p->turn.z.x >> 30) + (y * p->turn.z.y >> 30)
                            + (z * p->turn.z.z >> 30));
    const int64_t depth = ahead > p->near ? ahead : p->near;
    const int64_t half_pixel = (depth << 15) / p->focal;    /* m, 16.16 */

    return (tp_line_scale){ (uint32_t)((int64_t)p->near * INT32_MAX / depth),
                            (int32_t)(half_pixel * along.x >> 30),
                            (int32_t)(half_pixel * along.z >> 30) };
}

static void place_fast_lines(tp_frame *frame)
{
    tp_fast_lines *to = frame->buffers.fast_lines;
    tp_level level;

    tp_lines_place(frame);
    for (uint32_t k = 0; k < frame->buffers.lines->lines; k++)
        to->scale[k] = make_line_scale(frame, k);
    tp_level_begin(&level, &frame->projection);
    to->zi = level.zi;
    frame->level_zi = &to->zi;
}

const struct tp_water_renderer tp_method_lines = {
    .layout = layout_fast_lines, .place = place_fast_lines, .draw = draw_fast_rows,
    .draw_alone = draw_alone,
    .level_keys = tp_frame_shade_level_run,
};
