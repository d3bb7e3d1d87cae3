/* SPDX-License-Identifier: MIT */
/*
 * The scanline grid, see scanline_grid.h: the conditions for its use, and its placement.
 */
#include "frame/scanline_grid.h"
#include "view/fan.h"
#include "waves/coastal_tables.h"
#include "world/pools.h"

/* -- scanline validity --------------------------------------------------------------- */

/*
 * Conditions under which scanline water draws the same picture as triangles; they depend
 * on camera and sea alone.
 *
 * Scanline water requires that a column of pixels, walked upwards, meets the grid's lines
 * one after the other, each line once.  Hence the eye must stand above all water, every
 * ray of the picture must lead away across the lines, and the camera must neither roll nor
 * be upside down.  Displaced lines must also keep their order along a ray.  A ray goes t
 * metres along the lines for each metre across them; lines are met in order while J_mm - t
 * J_km > 0, k across, m along:
 *     sum |bend_mm - t bend_km| < 1,
 * for any phases.  The sum is convex in t: checking the picture's corners suffices.
 * Relief on the swells is a height and moves nothing sideways.  Breaking waves overhang
 * and are excluded.
 *
 * The widest ray also bounds the distance of two lines along a ray, and with it the
 * deviation from the triangles.
 */

#define WIDEST_T 3                      /* limit of t, the tangent of 71.6 degrees */
#define ROLL    (TP_FX_ONE / 64)        /* sine of the largest roll */
#define ABOVE   (TP_FX_ONE / 8)         /* least height over the highest crest, m */
#define FOLDS   (TP_FX_ONE * 9 / 10)    /* limit of the sum for deep water */
#define STEEPENS (TP_FX_ONE * 3 / 4)    /* for coastal water, whose waves steepen more */

/* A horizontal ray by its components across and along the lines, of any length. */
typedef struct {
    int64_t across, along;
} level_ray;

static tp_dir3 rows_direction(const tp_frame *frame)
{
    return tp_fan_rows_direction(&frame->projection.turn, frame->grid_view.detail.walls);
}

/* Ray through a corner of the picture, 16.16; pixels lie below 2^12 from the centre, the
 * focal length is below 2^16. */
static level_ray corner_ray(const tp_frame *frame, int corner)
{
    const tp_rotation *turn = &frame->projection.turn;
    int64_t u = (int64_t)frame->config.width << 15, v = (int64_t)frame->config.height << 15;
    int64_t far = frame->projection.focal;

    u = corner & 1 ? u : -u;
    v = corner & 2 ? v : -v;
    int64_t x = (turn->x.x * u + turn->y.x * v - turn->z.x * far) >> 30;
    int64_t z = (turn->x.z * u + turn->y.z * v - turn->z.z * far) >> 30;
    const tp_dir3 r = rows_direction(frame);
    return (level_ray){ (z * r.x - x * r.z) >> 30, (x * r.x + z * r.z) >> 30 };
}

/* Bends of a swell: along the lines, and along times across. */
typedef struct {
    int64_t along, cross;
} line_bend;

/* Turns the bends of a swell to the direction of the rows. */
static line_bend turned_bend(const tp_swell *w, tp_dir3 right)
{
    const int64_t x = right.x >> 15, z = right.z >> 15;
    const int64_t xx = x * x >> 15, xz = x * z >> 15, zz = z * z >> 15;     /* Q15 */

    return (line_bend){
        (w->bend_xx * xx + 2 * w->bend_xz * xz + w->bend_zz * zz) >> 15,
        ((int64_t)(w->bend_zz - w->bend_xx) * xz + w->bend_xz * (xx - zz)) >> 15,
    };
}

static bool is_line_order_kept(const tp_frame *frame, tp_fx t)
{
    const tp_deep_water *deep = frame->surface.deep;
    const tp_dir3 right = rows_direction(frame);
    int64_t sum = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        const line_bend bend = turned_bend(&deep->swell[i], right);
        int64_t b = (bend.along - (bend.cross * t >> 16)) >> 14;
        sum += b < 0 ? -b : b;
    }
    return sum < (frame->surface.coastal ? STEEPENS : FOLDS);
}

/* True if all corner rays lead away across the lines, within the widest angle, and the
 * lines on each keep their order. */
static bool are_lines_ordered_in_view(const tp_frame *frame)
{
    for (int corner = 0; corner < 4; corner++) {
        const level_ray ray = corner_ray(frame, corner);
        const int64_t across = -ray.across, along = -ray.along;
        if (across < TP_FX_ONE || (along < 0 ? -along : along) >= WIDEST_T * across)
            return false;
        if (!is_line_order_kept(frame, (tp_fx)tp_quotient(along * TP_FX_ONE, across)))
            return false;
    }
    return true;
}

static bool can_any_wave_overhang(const tp_coastal_water *coastal)
{
    for (uint32_t i = 0; i < coastal->count; i++)
        if (tp_can_overhang(coastal->wave[i].stretch, coastal->slope,
                            coastal->map_cols > 0))
            return true;
    return false;
}

bool tp_frame_can_draw_rows(tp_frame *frame)
{
    return frame->buffers.lines && frame->buffers.grid
           && tp_abs(frame->projection.turn.x.y >> 14) < ROLL
           && frame->projection.turn.y.y > 0
           && frame->projection.eye.y > tp_surface_height_bound(&frame->surface) + ABOVE
           && are_lines_ordered_in_view(frame)
           && !(frame->surface.coastal && can_any_wave_overhang(frame->surface.coastal));
}

/* -- placement ----------------------------------------------------------------------- */

/* Mean cell width, px, above which a row of cells of the water also gets a middle line,
 * drawn between its two grid lines.  WIDE_TILTED holds for a camera turned by more than
 * 14 degrees from the lines' normal: its rays go farther from line to line. */
#define WIDE_CELL     32
#define WIDE_TANK     16        /* a tank's pool is not filtered to fit the cells */
#define WIDE_TILTED   4

/* Returns the segments of a piece, log2: about a third of those across a strip, so that a
 * strip evaluates few points beside it.  Of count-64 in streamed tiles of 64x6 pixels 4
 * segments cost 412 instructions a pixel, 8 cost 440, 16 cost 495. */
static uint8_t choose_piece_bits(const tp_config *config, uint32_t vertices)
{
    const uint32_t cols = tp_fan_most_cols(vertices) * config->tile_width / config->width;

    return config->tile_width == config->width || cols >= 48 ? 4 : cols >= 24 ? 3 : 2;
}

void tp_lines_layout(tp_frame_buffers *buffers, tp_arena *arena, const tp_program *program,
                     const tp_scene *scene, const tp_config *config)
{
    const uint32_t vertices = tp_fan_budget(scene), lines = tp_fan_most_rows(vertices);
    const uint8_t bits = choose_piece_bits(config, vertices);

    tp_frame_lines *to = tp_arena_alloc(arena, 1, sizeof *to);
    const tp_frame_lines l = {
        .line = tp_arena_alloc(arena, lines, sizeof *l.line),
        .reach = tp_arena_alloc(arena, (vertices >> bits) + lines, sizeof *l.reach),
        .piece_bits = bits,
    };
    if (to)
        *to = l;
    buffers->lines = to;
    if (tp_frame_asks_fast_rows(program, scene))
        program->method.lines->layout(buffers, arena, program, scene, config);
}

tp_row_point tp_line_point(const tp_frame *frame, const tp_grid_window *window, uint32_t k,
                           uint32_t m)
{
    const tp_grid *grid = frame->buffers.grid;
    const tp_grid_vertex *v = tp_line_vertex(window, k, m);

    return (tp_row_point){
        v->u, v->v, v->zi, tp_grid_s(grid, m, k), tp_grid_t(grid, m, k),
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

    end[0] = tp_line_point(frame, window, k, points.first);
    end[1] = tp_line_point(frame, window, k, points.end - 1u);
}

/* Sets the counts of lines and points.  Lines lie from far to near, points from left to
 * right. */
static void set_counts(tp_frame *frame)
{
    const tp_grid *grid = frame->buffers.grid;
    tp_frame_lines *lines = frame->buffers.lines;

    lines->lines = grid->rows;
    lines->points = grid->cols;
    lines->blocks = (lines->points - 2) / TP_GRID_BLOCK + 1;
    lines->pieces = ((lines->points - 2) >> lines->piece_bits) + 1;
    lines->box = grid->box;
}

static bool is_tilted(const tp_frame *frame)
{
    const tp_dir3 *back = &frame->projection.turn.z;
    const bool along_x = rows_direction(frame).x != 0;
    const int64_t along = along_x ? back->x : back->z, across = along_x ? back->z : back->x;

    return 4 * (along < 0 ? -along : along) > (across < 0 ? -across : across);
}

/* For each pair of neighbouring lines, sets the range of visible cells between the two. */
static void set_cells(tp_frame *frame)
{
    const tp_grid *grid = frame->buffers.grid;
    tp_frame_line *line = frame->buffers.lines->line;

    for (uint32_t k = 0; k + 1 < frame->buffers.lines->lines; k++)
        line[k].cells = grid->span[k];
}

/* True if a cell of row k needs clipping, because a corner cannot be projected, and the
 * cell overlaps the picture's columns; without the part that clips cells, any may. */
static bool has_cell_to_clip(tp_frame *frame, uint32_t k)
{
    const struct tp_draw_cells *by = frame->program->draw.cells;
    const tp_grid_window *seen = &frame->buffers.grid->window;
    const tp_frame_line *line = &frame->buffers.lines->line[k];
    int32_t width = (int32_t)frame->config.width;

    for (uint32_t m = line->cells.first; m < line->cells.end; m++) {
        if (tp_line_vertex(seen, k, m)->u != TP_GRID_NEEDS_CLIP
            && tp_line_vertex(seen, k, m + 1)->u != TP_GRID_NEEDS_CLIP
            && tp_line_vertex(seen, k + 1, m)->u != TP_GRID_NEEDS_CLIP
            && tp_line_vertex(seen, k + 1, m + 1)->u != TP_GRID_NEEDS_CLIP)
            continue;
        if (!by)
            return true;
        tp_grid_box box = by->box(frame, k, m, m + 1);
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
        tp_box_join(&line->box, &lines->box[at]);
    }
}

static bool is_on_screen(const tp_frame *frame, int32_t u)
{
    return u != TP_GRID_NEEDS_CLIP && u > 0 && u < 16 * (int32_t)frame->config.width;
}

/* True if an end of one of the two lines of row k lies between the sides of the picture. */
static bool has_line_end_on_screen(const tp_frame *frame, uint32_t k)
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
    const tp_grid_span points = tp_line_points(frame, k);
    const tp_frame_lines *lines = frame->buffers.lines;
    const int bits = lines->piece_bits;

    for (uint32_t p = 0; p < lines->pieces; p++) {
        tp_line_reach *reach = &lines->reach[(size_t)k * lines->pieces + p];
        const tp_grid_span part = tp_line_segments(points, p << bits, (p + 1) << bits);
        *reach = (tp_line_reach){ INT16_MAX, INT16_MIN };
        for (uint32_t m = part.first; part.first < part.end && m <= part.end; m++) {
            int32_t u = tp_line_vertex(&frame->buffers.grid->window, k, m)->u;
            if (u == TP_GRID_NEEDS_CLIP)
                continue;
            reach->x0 = u >> 4 < reach->x0 ? (int16_t)(u >> 4) : reach->x0;
            reach->x1 = u >> 4 > reach->x1 ? (int16_t)(u >> 4) : reach->x1;
        }
    }
}

/* Returns the width of a wide cell, px.  Level water has few vertices, and its textures
 * need the middle lines. */
static int32_t wide_cell(const tp_frame *frame)
{
    const tp_fan *fan = frame->buffers.grid->fan;

    if (!fan->law.walls)
        return frame->surface.deep->count == 0 && fan->detail == 0 ? WIDE_TILTED : WIDE_CELL;
    return is_tilted(frame) ? WIDE_TILTED : WIDE_TANK;
}

/* Draws a row without its edges if the program lacks them; fast rows have their own. */
static void drop_missing_edges(tp_frame *frame, const tp_gbuffer *picture, uint32_t k)
{
    const tp_draws *draw = &frame->program->draw;
    const unsigned edges = (draw->row_sides ? 0 : TP_LINE_SIDED)
                         | (draw->row_middles ? 0 : TP_LINE_WIDE);
    tp_frame_line *line = &frame->buffers.lines->line[k];

    if (frame->column_bits || !(line->is & edges))
        return;
    const tp_column_range seen = tp_line_columns(frame, picture, k);
    line->is &= (uint16_t)~edges;
    frame->stats.dropped += seen.x0 < seen.x1;
}

static void set_row(tp_frame *frame, uint32_t k)
{
    const tp_gbuffer picture = { .x1 = (int32_t)frame->config.width,
                                 .y1 = (int32_t)frame->config.height };
    const int32_t wide = wide_cell(frame);
    tp_frame_line *line = &frame->buffers.lines->line[k];

    line->is = 0;
    set_box(frame, k);
    if (line->cells.first >= line->cells.end || !tp_box_overlaps_tile(&line->box, &picture))
        return;
    if (has_cell_to_clip(frame, k)) {
        line->is |= TP_LINE_CUT;
        if (!frame->program->draw.cells)
            tp_frame_count_lack(frame, TP_LACKING_CELLS);
    }
    if (has_line_end_on_screen(frame, k))
        line->is |= TP_LINE_SIDED;
    if (line->box.x1 - line->box.x0 > wide * (line->cells.end - line->cells.first))
        line->is |= TP_LINE_WIDE;
    drop_missing_edges(frame, &picture, k);
}

/* Places all lines.  Rows of the grid are examined right after their placement, because a
 * streamed grid does not keep them. */
void tp_lines_place(tp_frame *frame)
{
    const tp_frame_lines *lines = frame->buffers.lines;

    tp_frame_begin_grid(frame);
    frame->stats.dropped +=
        frame->buffers.grid->dry != NULL && !frame->program->draw.row_land;
    set_counts(frame);
    set_cells(frame);
    for (uint32_t k = 0; k < lines->lines; k++) {
        tp_frame_place_grid_line(frame, k);
        set_reach(frame, k);
        if (k > 0)
            set_row(frame, k - 1);
    }
}
