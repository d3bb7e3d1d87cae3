/* SPDX-License-Identifier: MIT */
/* Placing the scanline grid; see scanline_grid.h. */
#include "frame/scanline_grid.h"

/* Mean cell width, px, above which a row of cells also draws middle lines.  WIDE_TILTED
 * holds for a camera turned by more than 14 degrees from the lines' normal: its rays go
 * farther from line to line. */
#define WIDE_CELL   16
#define WIDE_TILTED 4

void tp_lines_layout(tp_frame_buffers *buffers, tp_arena *arena, const tp_program *program,
                    const tp_scene *scene, const tp_config *config)
{
    size_t cols = (size_t)scene->grid.cols, rows = (size_t)scene->grid.rows;
    size_t lines = cols > rows ? cols : rows;
    size_t upright = cols * ((rows - 2) / TP_GRID_BLOCK + 1);
    size_t level = rows * ((cols - 2) / TP_GRID_BLOCK + 1);
    const bool streams = tp_frame_is_grid_streamed(program, scene);

    (void)config;
    tp_frame_lines *to = tp_arena_alloc(arena, 1, sizeof *to);
    const tp_frame_lines l = {
        .line = tp_arena_alloc(arena, lines, sizeof *l.line),
        .line_box = streams ? NULL : tp_arena_alloc(arena, upright, sizeof *l.line_box),
        .reach = tp_arena_alloc(arena, upright > level && !streams ? upright : level,
                                sizeof *l.reach),
    };
    if (to)
        *to = l;
    buffers->lines = to;
}

tp_row_point tp_line_point(const tp_frame *frame, const tp_grid_window *window, uint32_t k,
                           uint32_t m)
{
    const tp_grid *grid = frame->buffers.grid;
    const tp_grid_vertex *v = tp_line_vertex(frame, window, k, m);
    const bool upright = frame->buffers.lines->upright;
    uint32_t i = upright ? k : m, j = upright ? m : k;

    return (tp_row_point){
        v->u, v->v, v->zi, grid->column[i].place, grid->row[j].place,
        (uint32_t)(uint16_t)v->slope_x << 16 | (uint16_t)v->slope_z,
    };
}

tp_grid_span tp_line_points(const tp_frame *frame, uint32_t k)
{
    TP_ASSERT(k < frame->buffers.lines->lines);
    const tp_grid_span none = { 0, 0 };
    const tp_frame_lines *lines = frame->buffers.lines;
    tp_grid_span a = k > 0 ? lines->line[k - 1].cells : none;
    tp_grid_span b = k + 1 < lines->lines ? lines->line[k].cells : none;

    if (a.first >= a.end)
        a = b;
    if (b.first >= b.end)
        b = a;
    return (tp_grid_span){ a.first < b.first ? a.first : b.first,
                           (uint16_t)((a.end > b.end ? a.end : b.end) + 1) };
}

void tp_line_ends(const tp_frame *frame, const tp_grid_window *window, uint32_t k,
                  tp_row_point end[2])
{
    tp_grid_span points = tp_line_points(frame, k);
    bool back = frame->buffers.lines->points_back;

    end[back] = tp_line_point(frame, window, k, points.first);
    end[!back] = tp_line_point(frame, window, k, points.end - 1u);
}

static tp_grid_box box_of_cells(tp_frame *frame, uint32_t k, uint32_t first, uint32_t end)
{
    tp_grid_box box = TP_BOX_NONE;

    if (!frame->buffers.lines->upright)
        return tp_frame_cells_box(frame, k, first, end);
    for (uint32_t m = first; m < end; m++) {
        tp_grid_box cell = tp_frame_cells_box(frame, m, k, k + 1);
        tp_box_join(&box, &cell);
    }
    return box;
}

/* Sets the direction of the lines.  If the camera looks along x, lines are the grid's
 * columns. */
static void turn(tp_frame *frame)
{
    const tp_grid *grid = frame->buffers.grid;
    const tp_dir3 *back = &frame->projection.turn.z;
    tp_frame_lines *lines = frame->buffers.lines;

    lines->upright = tp_abs(back->x) > tp_abs(back->z);
    if (lines->upright) {
        lines->lines_back = back->x > 0;
        lines->points_back = back->x > 0;
    } else {
        lines->lines_back = back->z > 0;
        lines->points_back = back->z < 0;
    }
    lines->lines = lines->upright ? grid->cols : grid->rows;
    lines->points = lines->upright ? grid->rows : grid->cols;
    lines->blocks = (lines->points - 2) / TP_GRID_BLOCK + 1;
    lines->box = lines->upright ? frame->buffers.lines->line_box : grid->box;
}

static bool is_tilted(const tp_frame *frame)
{
    int32_t x = tp_abs(frame->projection.turn.z.x), z = tp_abs(frame->projection.turn.z.z);
    return 4 * (int64_t)(x < z ? x : z) > (x < z ? z : x);
}

/* For each pair of neighbouring lines, sets the range of visible cells between the two. */
static void set_cells(tp_frame *frame)
{
    const tp_grid *grid = frame->buffers.grid;
    tp_frame_line *line = frame->buffers.lines->line;

    const bool upright = frame->buffers.lines->upright;

    for (uint32_t k = 0; k + 1 < frame->buffers.lines->lines; k++)
        line[k].cells = upright ? (tp_grid_span){ 0, 0 } : grid->span[k];
    for (uint32_t j = 0; upright && j + 1 < grid->rows; j++) {
        for (uint32_t i = grid->span[j].first; i < grid->span[j].end; i++) {
            if (line[i].cells.end == 0)
                line[i].cells.first = (uint16_t)j;
            line[i].cells.end = (uint16_t)(j + 1);
        }
    }
}

/* True if the frustum clips cells of row k within the picture's columns. */
static bool is_cut(tp_frame *frame, uint32_t k)
{
    const tp_grid_window *seen = &frame->buffers.grid->window;
    const tp_frame_line *line = &frame->buffers.lines->line[k];
    int32_t width = (int32_t)frame->config.width;

    for (uint32_t m = line->cells.first; m < line->cells.end; m++) {
        if (tp_line_vertex(frame, seen, k, m)->u != TP_GRID_NEEDS_CLIP
            && tp_line_vertex(frame, seen, k, m + 1)->u != TP_GRID_NEEDS_CLIP
            && tp_line_vertex(frame, seen, k + 1, m)->u != TP_GRID_NEEDS_CLIP
            && tp_line_vertex(frame, seen, k + 1, m + 1)->u != TP_GRID_NEEDS_CLIP)
            continue;
        tp_grid_box box = box_of_cells(frame, k, m, m + 1);
        if (box.x0 < width && box.x1 >= 0)
            return true;
    }
    return false;
}

static void set_box(tp_frame *frame, uint32_t k)
{
    tp_frame_line *line = &frame->buffers.lines->line[k];

    line->box = TP_BOX_NONE;
    for (uint32_t b = line->cells.first / TP_GRID_BLOCK;
         b * TP_GRID_BLOCK < line->cells.end; b++) {
        tp_grid_span cells = tp_line_block_cells(line, b);
        const tp_frame_lines *lines = frame->buffers.lines;
        size_t at = (size_t)k * lines->blocks + b;
        if (cells.first >= cells.end)
            continue;
        if (lines->upright)
            lines->line_box[at] = box_of_cells(frame, k, cells.first, cells.end);
        tp_box_join(&line->box, &lines->box[at]);
    }
}

static bool is_on_screen(const tp_frame *frame, int32_t u)
{
    return u != TP_GRID_NEEDS_CLIP && u > 0 && u < 16 * (int32_t)frame->config.width;
}

static bool is_sided(const tp_frame *frame, uint32_t k)
{
    for (uint32_t far = 0; far < 2; far++) {
        tp_row_point end[2];
        tp_line_ends(frame, &frame->buffers.grid->window, k + far, end);
        if (is_on_screen(frame, end[0].u) || is_on_screen(frame, end[1].u))
            return true;
    }
    return false;
}

static void set_reach(tp_frame *frame, uint32_t k)
{
    tp_grid_span points = tp_line_points(frame, k);

    const tp_frame_lines *lines = frame->buffers.lines;

    for (uint32_t b = 0; b < lines->blocks; b++) {
        tp_line_reach *reach = &lines->reach[(size_t)k * lines->blocks + b];
        tp_grid_span part = tp_line_block_segments(points, b);
        *reach = (tp_line_reach){ INT16_MAX, INT16_MIN };
        for (uint32_t m = part.first; part.first < part.end && m <= part.end; m++) {
            int32_t u = tp_line_vertex(frame, &frame->buffers.grid->window, k, m)->u;
            if (u == TP_GRID_NEEDS_CLIP)
                continue;
            reach->x0 = u >> 4 < reach->x0 ? (int16_t)(u >> 4) : reach->x0;
            reach->x1 = u >> 4 > reach->x1 ? (int16_t)(u >> 4) : reach->x1;
        }
    }
}

static void set_row(tp_frame *frame, uint32_t k)
{
    const tp_gbuffer picture = { .x1 = (int32_t)frame->config.width,
                                 .y1 = (int32_t)frame->config.height };
    const int32_t wide = is_tilted(frame) ? WIDE_TILTED : WIDE_CELL;
    tp_frame_line *line = &frame->buffers.lines->line[k];

    line->is = 0;
    set_box(frame, k);
    if (line->cells.first >= line->cells.end || !tp_view_touches(&line->box, &picture))
        return;
    if (is_cut(frame, k))
        line->is |= TP_LINE_CUT;
    if (is_sided(frame, k))
        line->is |= TP_LINE_SIDED;
    if (line->box.x1 - line->box.x0 > wide * (line->cells.end - line->cells.first))
        line->is |= TP_LINE_WIDE;
}

/* Places all lines.  Rows of the grid are examined right after their placement, because a
 * streamed grid does not keep them. */
void tp_lines_place(tp_frame *frame)
{
    const tp_frame_lines *lines = frame->buffers.lines;

    tp_frame_begin_water(frame);
    turn(frame);
    set_cells(frame);
    for (uint32_t j = 0; lines->upright && j < frame->buffers.grid->rows; j++)
        tp_frame_place_line(frame, j);
    for (uint32_t k = 0; k < lines->lines; k++) {
        if (!lines->upright)
            tp_frame_place_line(frame, k);
        set_reach(frame, k);
        if (k > 0)
            set_row(frame, k - 1);
    }
}
