/* SPDX-License-Identifier: MIT */
/* Walked water: a height field in screen order, for level views of swells.
 *
 * Lines lie at fixed distances below the horizon, 16 px apart near the eye and a pixel apart
 * at the horizon, with a point at every 16th column.  A point is displaced by the waves and
 * projected; its row is kept, its column is not: the water sways towards the eye but not to
 * its side.  Between two points row and slopes are linear, s and t are those of level water
 * along the line.  A tile draws its lines from near to far by raster/fast_scanlines.h, in
 * pairs of columns.  The points are evaluated once a frame, 8 bytes each.
 *
 * Valid without roll for swells alone, all below the eye by a quarter of its height; else
 * triangles are drawn. */
#include "frame/walk_water.h"
#include "frame/renderers.h"

/* Lines beyond the picture's lower edge take an eighth of its height at the most. */
uint32_t tp_walk_most_lines(uint32_t height)
{
    return height / 8 + height / 64 + 48;
}

struct tp_walk *tp_walk_allocate(tp_arena *arena, const tp_config *config, size_t bytes,
                                 void **points)
{
    const uint32_t lines = tp_walk_most_lines(config->height);
    const uint32_t cols = tp_walk_count_points(config->width);
    struct tp_walk *to = tp_arena_alloc(arena, 1, sizeof *to);

    if (to)
        *to = (struct tp_walk){ .most_lines = lines, .cols = cols };
    *points = tp_arena_alloc(arena, (size_t)lines * cols, bytes);
    return to;
}

static void layout_walk(tp_frame_buffers *buffers, tp_arena *arena,
                        const tp_program *program, const tp_scene *scene,
                        const tp_config *config)
{
    void *points;
    struct tp_walk *to = tp_walk_allocate(arena, config, sizeof(tp_even_point), &points);
    tp_walk_line *line = tp_arena_alloc(arena, tp_walk_most_lines(config->height), sizeof *line);

    (void)program;
    (void)scene;
    if (to) {
        to->line = line;
        to->point = points;
    }
    buffers->walk = to;
}

/* -- placement ----------------------------------------------------------------------- */

int32_t tp_walk_next_line(int32_t below)
{
    const int32_t apart = below > 192 ? 16 : below > 96 ? 8 : below > 40 ? 4 : below > 16 ? 2 : 1;
    return below - apart;
}

/* Returns the first line that no wave lifts into the picture, px below the horizon; 0: the
 * waves are too high for the eye. */
static int32_t first_line(const tp_frame *frame)
{
    const tp_level *level = &frame->buffers.walk->level;
    const int64_t down = tp_level_evaluate(&level->down, 0, (int32_t)frame->config.height);
    const int64_t below =                                               /* 16.16 */
        down > 0 ? tp_quotient(down << 2, level->down.y >> 14) : 0;
    const tp_fx fall = tp_fx_div(tp_fx_saturate(below), frame->projection.focal);
    const int64_t rise = tp_surface_height_bound(&frame->surface)
                       + tp_fx_mul(tp_surface_displacement_bound(&frame->surface), fall);
    const int64_t low = level->height - rise;

    if (low < level->height / 4)
        return 0;
    return ((int32_t)tp_quotient((below >> 16) * level->height, low) + 16) & ~7;
}

static uint32_t count_lines(int32_t below)
{
    uint32_t lines = 2;

    for (; below > 1; below = tp_walk_next_line(below))
        lines++;
    return lines;
}

bool tp_walk_can_draw(tp_frame *frame)
{
    struct tp_walk *walk = frame->buffers.walk;
    const tp_surface *surface = &frame->surface;

    if (!walk || surface->coastal || tp_surface_has_rings_or_pools(surface)
        || tp_has_tank(frame->scene)
        || (tp_surface_has_swells(surface) && !surface->by->points)
        || frame->projection.eye.y < tp_surface_height_bound(surface) + TP_LEVEL_HEIGHT)
        return false;
    tp_level_begin(&walk->level, &frame->projection);
    const tp_level_linear *down = &walk->level.down;
    if (down->x != 0 || down->y < TP_Q30_ONE / 2)
        return false;
    const int32_t below = first_line(frame);
    return below > 0 && count_lines(below) <= walk->most_lines;
}

#define WALK_FAR ((int64_t)12000 << 16)        /* m: farther points are on the horizon */

/* Returns a coordinate at most WALK_FAR from the eye's, so that differences fit 16.16. */
static tp_fx near_eye(const tp_frame *frame, int axis, int64_t at)
{
    const tp_fx eye = axis ? frame->projection.eye.z : frame->projection.eye.x;
    return tp_fx_saturate(eye + tp_clamp_abs(at - eye, WALK_FAR));
}

/* Waves are kept as if the points were 3/4 as far apart: against triangles at tick 60 that is
 * 28.2 dB in count-64, and 27.9 without. */
static tp_even_point make_point(const tp_frame *frame, const tp_walk_placed_line *line,
                                int32_t x)
{
    const int32_t flat = (int32_t)((line->row + (1 << 13)) >> 14) + TP_FX_ONE / 2;
    tp_fx place[2], step[2][2];
    tp_screen_vertex seen;
    tp_view_vertex view = { .s = 0 };

    if (!tp_surface_has_swells(&frame->surface))
        return (tp_even_point){ flat, 0 };
    for (int axis = 0; axis < 2; axis++) {
        const int64_t here = line->at[axis] + line->step[axis] * x;
        const int64_t there = line->beyond[axis] + line->beyond_step[axis] * x;
        place[axis] = near_eye(frame, axis, here);
        step[0][axis] = tp_fx_saturate(line->step[axis] * (TP_WALK_CELL * 3 / 4));
        step[1][axis] = tp_fx_saturate((there - here) * 3 >> 2);
    }
    const tp_surface_point p = frame->surface.by->points->point(&frame->surface, place, step);
    tp_projection_view_vertex(&frame->projection, p.position, &view);
    if (!tp_projection_can_project(&frame->projection, &view))
        return (tp_even_point){ flat, tp_level_pack_slopes(&p) };
    tp_projection_project(&frame->projection, &view, &seen.u, &seen.v, &seen.zi);
    return (tp_even_point){ seen.v * (TP_FX_ONE / 16), tp_level_pack_slopes(&p) };
}

static tp_level_scale level_scale(const tp_level *level, int64_t below_q30)
{
    const int64_t down = level->down.y * (below_q30 >> 20) >> 10;
    return tp_level_metres_per_pixel(level, down > 0 ? down : 1);
}

/* Sets the rest positions of a row, Q.30 px, `below` px below the horizon. */
static void set_rest(const tp_level *level, int64_t row, int64_t below, int64_t at[2],
                     int64_t step[2])
{
    const tp_level_linear *sums[2] = { &level->east, &level->south };
    const tp_level_scale scale = level_scale(level, below);

    at[0] = level->x;
    at[1] = level->z;
    for (int axis = 0; axis < 2; axis++) {
        at[axis] += tp_level_pixels_to_metres(
            scale, tp_level_evaluate_fractional_row(sums[axis], 0, row));
        step[axis] = tp_level_pixels_to_metres(scale, sums[axis]->x);
    }
}

void tp_walk_begin_line(const tp_level *level, int32_t below, tp_walk_placed_line *at,
                        tp_walk_line *line)
{
    const int64_t last = TP_Q30_ONE / 8, horizon = tp_level_zero_line(&level->down).at;
    const int32_t next = tp_walk_next_line(below);
    const int64_t here = below > 0 ? (int64_t)below * TP_Q30_ONE : last;
    const int64_t beyond = below <= 0 ? last / 2 : next > 0 ? (int64_t)next * TP_Q30_ONE : last;

    at->row = horizon + here;
    set_rest(level, at->row, here, at->at, at->step);
    set_rest(level, horizon + beyond, beyond, at->beyond, at->beyond_step);
    const int64_t zi =
        tp_level_evaluate_fractional_row(&level->zi, 0, at->row) >> TP_LEVEL_ZI;
    *line = (tp_walk_line){
        { zi < 1 ? 1 : zi > INT32_MAX ? INT32_MAX : (uint32_t)zi,
          (int32_t)(at->step[0] / 2), (int32_t)(at->step[1] / 2) },
        (uint32_t)at->at[0], (uint32_t)at->at[1], (int32_t)at->step[0],
        (int32_t)at->step[1], INT32_MAX,
    };
}

tp_even_point tp_walk_make_point(const tp_frame *frame, const tp_walk_placed_line *line,
                                 int32_t x)
{
    return make_point(frame, line, x);
}

/* Stores the points of a line; returns its least v. */
static int32_t store_points(const tp_frame *frame, const tp_walk_placed_line *at,
                            tp_even_point *to)
{
    int32_t top = INT32_MAX;

    for (uint32_t i = 0; i < frame->buffers.walk->cols; i++) {
        to[i] = make_point(frame, at, (int32_t)i * TP_WALK_CELL);
        top = to[i].v < top ? to[i].v : top;
    }
    return top;
}

/* Stores the rows of a line's points. */
static void store_rows(const tp_frame *frame, const tp_walk_placed_line *at, uint8_t *to)
{
    struct tp_walk *walk = frame->buffers.walk;

    for (uint32_t i = 0; i < walk->cols; i++) {
        const int32_t v = make_point(frame, at, (int32_t)i * TP_WALK_CELL).v;
        const int32_t row = tp_clamp(v >> 16 >> walk->row_bits, 0, 255);
        to[i] = (uint8_t)row;
        walk->top = row < walk->top ? row : walk->top;
    }
}

static void place_line(tp_frame *frame, int32_t below)
{
    struct tp_walk *walk = frame->buffers.walk;
    const uint32_t k = walk->lines++;
    const size_t first = (size_t)k * walk->cols;
    tp_walk_placed_line at;
    tp_walk_line   line;

    tp_walk_begin_line(&walk->level, below, &at, &line);
    frame->stats.vertices += walk->cols;
    if (walk->row) {
        store_rows(frame, &at, walk->row + first);
        return;
    }
    line.top = store_points(frame, &at, walk->point + first);
    walk->line[k] = line;
}

void tp_walk_place(tp_frame *frame)
{
    struct tp_walk *walk = frame->buffers.walk;

    frame->level_zi = &walk->level.zi;
    walk->lines = 0;
    walk->top = 255;
    walk->first = first_line(frame);
    for (int32_t below = walk->first; below > 0; below = tp_walk_next_line(below))
        place_line(frame, below);
    place_line(frame, 0);
}

/* -- a tile -------------------------------------------------------------------------- */

static void lay_line(tp_fast_rows *rows, const struct tp_walk *walk, uint32_t k)
{
    const tp_walk_line *line = &walk->line[k], *before = &walk->line[k > 0 ? k - 1 : 0];
    const tp_line_scale scale[2] = { line->scale, before->scale };
    const tp_even_line even = { walk->point + k * walk->cols, line->s, line->t, line->step_s,
                                line->step_t, line->scale.zi };

    tp_fast_rows_begin_line(rows, scale);
    tp_fast_rows_lay_even(rows, &even);
    tp_fast_rows_end_line(rows, k > 0 ? TP_LINE_ON : TP_LINE_BEHIND_GAP);
}

bool tp_walk_end_alone(const tp_frame *frame, const tp_fast_rows *rows, tp_water_rows *found)
{
    if (rows->holes)
        return false;
    *found = tp_fast_rows_found(rows);
    tp_frame_write_alone_keys(frame, rows, found);
    return true;
}

/* Draws the lines that matter for the tile: those that rise into it, and before each the
 * line in front. */
static void draw_lines(const tp_frame *frame, tp_fast_rows *rows)
{
    const struct tp_walk *walk = frame->buffers.walk;
    const int32_t bottom = rows->tile->y1 * TP_FX_ONE;

    for (uint32_t k = 0; k < walk->lines && rows->open > 0; k++)
        if (walk->line[k].top < bottom
            || (k + 1 < walk->lines && walk->line[k + 1].top < bottom))
            lay_line(rows, walk, k);
}

static void draw_walk(const tp_frame *frame, tp_gbuffer *tile, void *memory)
{
    tp_fast_rows rows;

    tp_fast_rows_begin(&rows, tile, memory, frame->column_bits, true);
    rows.solid = tp_frame_has_solids(frame);
    draw_lines(frame, &rows);
}

static bool draw_walk_alone(const tp_frame *frame, const tp_gbuffer *tile, void *memory,
                            tp_water_rows *found)
{
    tp_fast_rows rows;

    tp_fast_rows_begin(&rows, tile, memory, frame->column_bits, false);
    draw_lines(frame, &rows);
    return tp_walk_end_alone(frame, &rows, found);
}

const struct tp_water_renderer tp_method_walk = {
    .layout = layout_walk, .holds = tp_walk_can_draw, .place = tp_walk_place,
    .draw = draw_walk, .draw_alone = draw_walk_alone,
    .level_keys = tp_frame_shade_level_run,
};
