/* SPDX-License-Identifier: MIT */
/* Screen grid: water by lines of points laid over the picture.  Points start on the level
 * plane, are displaced by the waves and projected again, for raster/raster.h.  No vertex
 * is stored, and the number of points depends on the picture, not on the water's size.
 *
 * Lines are parallel to the horizon, hence depth and its reciprocal are constant on a
 * line.  They get denser towards the horizon; points lie at every 8th column.  Lines begin
 * far enough below the picture for crests there to rise into it, and extend as far to both
 * sides; the last line is the water's far end.  A tile walks the lines that may touch it:
 * wide, low tiles walk fewest.
 *
 * The margin below: consider a ray that falls T per metre of depth, and a line at depth D
 * on level water.  Displaced, the line comes no higher than the ray if D T >= h + G, and
 * stays below the ray if D T <= h - G:
 *     |A sin th + T QA cos th| <= sqrt(A^2 + (T QA)^2), G their sum over the waves.
 * Points on a line keep their order from left to right while
 *     B (1 + sec phi) / 2 + K (tan phi sin pitch + sin roll) < 1,
 * B the sum of Q k A, K that of k A, phi the widest angle between a ray and the camera's
 * heading.  Rays must lead forwards, for nearer lines to hide farther ones. */
#include "frame/frame.h"
#include "frame/renderers.h"
#include "view/wave_models.h"
#include "waves/deep_water.h"

enum { CELL = 8, RUN = 16 };

/* -- range of the lines -------------------------------------------------------------- */

/* Returns G of the file's head for a ray with a fall of `fall` per metre. */
static tp_fx max_rise_over_ray(const tp_deep_water *deep, tp_fx fall)
{
    int64_t sum = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        int64_t a = tp_sharp_max_height(w->amplitude, w->power);
        int64_t q = tp_isqrt64((uint64_t)((int64_t)w->orbit_x * w->orbit_x
                                          + (int64_t)w->orbit_z * w->orbit_z));
        q = (q * fall >> 16) + 2;
        q = q < INT32_MAX ? q : INT32_MAX;
        sum += tp_isqrt64((uint64_t)(a * a + q * q)) + 1;
    }
    return tp_fx_saturate(sum);
}

/* Returns the fall of a ray per metre of depth, from its pixels below the horizon in
 * Q.30. */
static tp_fx ray_descent_per_metre(const tp_frame *frame, int64_t below_horizon_q30)
{
    TP_ASSERT(frame->projection.focal > 0);
    return tp_fx_div((tp_fx)(below_horizon_q30 >> 14), frame->projection.focal);
}

/* Returns the first line, px below the horizon and a multiple of 4, that stays below a ray
 * for any phase of the waves; 0: no line does. */
static int32_t first_line_below_ray(const tp_frame *frame, int64_t below_horizon_q30)
{
    const tp_level *level = frame->buffers.level;
    tp_fx h = level->height,
          low = h
                - max_rise_over_ray(frame->surface.deep,
                                    ray_descent_per_metre(frame, below_horizon_q30));

    if (low < h / 4)
        return 0;
    int64_t rows = (below_horizon_q30 >> 14) * tp_fx_div(h, low) / (level->down.y >> 14);
    return ((int32_t)(rows >> 16) + 8) & ~3;
}

/* Returns how many pixels a line extends beyond each side: f / D is -d.y / h. */
static int32_t side_margin(const tp_frame *frame, int64_t descent)
{
    const tp_projected *p = frame->buffers.projected;
    return (int32_t)((descent >> 14) * p->share >> 32) + 2 * CELL;
}

/* -- conditions ---------------------------------------------------------------------- */

/* Returns the row in column x, Q.30, of the line that lies `below` px below the horizon. */
static int64_t row_below_horizon(const tp_projected *p, int32_t x, int32_t below)
{
    return p->horizon.at + p->horizon.x * x + (int64_t)below * TP_Q30_ONE;
}

/* True if points near pixel (x, y) keep their order, by the second condition of the file's
 * head. */
static bool are_points_ordered(const tp_frame *frame, int32_t x, int32_t y)
{
    const tp_level *level = frame->buffers.level;
    const tp_projection  *projection = &frame->projection;
    const tp_deep_water   *deep = frame->surface.deep;
    int64_t east = tp_level_evaluate(&level->east, x, y) >> 14;
    int64_t south = tp_level_evaluate(&level->south, x, y) >> 14;
    int64_t down = tp_level_evaluate(&level->down, x, y) >> 14;
    int64_t ahead = (east * projection->ahead.x + south * projection->ahead.z) >> 30;
    int64_t aside = (east * projection->ahead.z - south * projection->ahead.x) >> 30;
    tp_fx   tilt = 0;

    if (ahead * 4 < down || ahead <= 0)
        return false;
    for (uint32_t i = 0; i < deep->count; i++)
        tilt += deep->swell[i].tilt;
    aside = aside < 0 ? -aside : aside;
    int64_t slant = ahead + tp_isqrt64((uint64_t)(ahead * ahead + aside * aside));
    int64_t turned =
        aside * tp_abs(projection->ahead.y) + ahead * tp_abs(projection->turn.x.y);
    return (slant * deep->steepness_sum >> 31) + ((turned >> 30) * tilt >> 16)
           <= ahead * 15 / 16;
}

/* Adds one side of the water as a far end in columns x0 to x1.  Returns true if the side
 * is such an end or lies outside; false if it crosses the lines otherwise. */
static bool add_side_if_far_end(tp_projected *p, const tp_level_linear *side, int32_t x0,
                                int32_t x1)
{
    int64_t nearest[2] = { row_below_horizon(p, x0, p->start),
                           row_below_horizon(p, x1, p->start) };
    int64_t horizon[2] = { row_below_horizon(p, x0, 0), row_below_horizon(p, x1, 0) };

    if (tp_level_evaluate_fractional_row(side, x0, nearest[0]) < 0
        || tp_level_evaluate_fractional_row(side, x1, nearest[1]) < 0)
        return false;
    if (tp_level_evaluate_fractional_row(side, x0, horizon[0]) >= 0
        && tp_level_evaluate_fractional_row(side, x1, horizon[1]) >= 0)
        return true;
    if (side->y <= 0 || side->y < side->x || side->y < -side->x)
        return false;
    TP_ASSERT(p->tops < TP_LEVEL_SIDES);
    p->top[p->tops++] = tp_level_zero_line(side);
    return true;
}

/* Returns -d.y, px, Q.30, of the rays through the line that lies `px_below_horizon` px
 * below the horizon. */
static int64_t ray_descent(const tp_frame *frame, int32_t px_below_horizon)
{
    return frame->buffers.level->down.y * px_below_horizon;
}

/* Sets the first line below the picture's lower edge; true if all conditions hold up to
 * the water's far end. */
static bool set_line_range_if_drawable(tp_frame *frame)
{
    const tp_level *level = frame->buffers.level;
    tp_projected *p = frame->buffers.projected;
    const int32_t wide = (int32_t)frame->config.width, high = (int32_t)frame->config.height;
    int64_t left = tp_level_evaluate(&level->down, 0, high);
    int64_t down = left + (level->down.x > 0 ? level->down.x * wide : 0);

    p->start = down > 0 ? first_line_below_ray(frame, down) : 4;
    if (p->start == 0 || p->start > 4096)
        return false;
    down = ray_descent(frame, p->start);
    int64_t depth = (int64_t)frame->projection.focal * level->height / (down >> 14);
    if (depth < 2 * (int64_t)frame->projection.near + p->towards)
        return false;
    int32_t x0 = -side_margin(frame, down), x1 = wide - x0;
    if (x1 > 6000 || !are_points_ordered(frame, -CELL, high + CELL)
        || !are_points_ordered(frame, wide + CELL, high + CELL))
        return false;
    for (int k = 0; k < TP_LEVEL_SIDES; k++) {
        if (!add_side_if_far_end(p, &level->side[k], x0, x1))
            return false;
    }
    return true;
}

/* Sets the largest wave motion towards the camera, and to the side of a ray at the
 * picture's edge, tan phi = w: QA sqrt(1 + w^2), plus the share of wave height by pitch
 * and roll. */
static void set_motion_bounds(tp_frame *frame)
{
    const tp_projection *projection = &frame->projection;
    tp_projected *p = frame->buffers.projected;
    tp_fx wide = tp_fx_div((tp_fx)(frame->config.width << 15), projection->focal);
    tp_fx slant = tp_fx_sqrt(tp_fx_mul(wide, wide) + TP_FX_ONE);
    tp_fx sideways = tp_surface_displacement_bound(&frame->surface);
    tp_fx high = tp_surface_height_bound(&frame->surface);
    tp_fx aside = tp_fx_mul(sideways, slant)
                  + tp_fx_mul(tp_q30_mul(high, tp_abs(projection->ahead.y)), wide)
                  + tp_q30_mul(high, tp_abs(projection->turn.x.y));

    p->towards = sideways + tp_q30_mul(high, tp_abs(projection->ahead.y));
    p->share = tp_fx_div(aside, projection->eye.y);
}

static bool can_draw_projected(tp_frame *frame)
{
    tp_projected *p = frame->buffers.projected;

    if (!tp_frame_can_use_level_plane(frame) || !p)
        return false;
    tp_frame_place_level(frame);
    const tp_level_linear *down = &frame->buffers.level->down;
    if (down->y < TP_Q30_ONE / 2 || tp_abs((int32_t)down->x) > down->y / 4)
        return false;
    p->horizon = tp_level_zero_line(down);
    p->tops = 0;
    set_motion_bounds(frame);
    return set_line_range_if_drawable(frame);
}

/* -- points -------------------------------------------------------------------------- */

typedef struct {
    const tp_frame *frame;
    int32_t below;              /* px below the horizon; 0: at the water's far end */
    int64_t gap;                /* distance to the next line, in -d.y */
    tp_level_scale reach, beyond;
} screen_line;

static tp_level_scale make_clamped_scale(const tp_level *level, int64_t descent)
{
    return tp_level_metres_per_pixel(level, descent > 0 ? descent : 1);
}

/* Returns the row of the water's far end in column x. */
static int64_t water_end_row(const tp_projected *p, int32_t x)
{
    int64_t row = p->horizon.at + p->horizon.x * x;

    for (int k = 0; k < p->tops; k++) {
        int64_t top = p->top[k].at + p->top[k].x * x;
        row = top > row ? top : row;
    }
    return row;
}

/* Rest position of the point in column x at `row`, and the vectors to its right neighbour
 * and to the next line's point. */
static void sample_rest(const screen_line *l, int32_t x, int64_t row, bool at_water_end,
                        tp_fx at[2], tp_fx step[2][2])
{
    const tp_level *level = l->frame->buffers.level;
    const tp_level_linear *sums[2] = { &level->east, &level->south };
    const tp_fx eye[2] = { level->x, level->z };
    tp_level_scale reach = l->reach, beyond = l->beyond;

    if (at_water_end) {
        int64_t down = tp_level_evaluate_fractional_row(&level->down, x, row);
        reach = make_clamped_scale(level, down);
        beyond = make_clamped_scale(level, down - l->gap);
    }
    for (int axis = 0; axis < 2; axis++) {
        const tp_level_linear *sum = sums[axis];
        int64_t way = tp_level_evaluate_fractional_row(sum, x, row);
        int64_t across = sum->x + (sum->y * l->frame->buffers.projected->horizon.x >> 30);
        int64_t farther = way - (sum->y * (l->gap >> 14) / (level->down.y >> 14));
        int64_t here = tp_level_pixels_to_metres(reach, way);
        at[axis] = tp_fx_saturate(eye[axis] + here);
        step[0][axis] = tp_fx_saturate(tp_level_pixels_to_metres(reach, across * CELL));
        step[1][axis] = tp_fx_saturate(tp_level_pixels_to_metres(beyond, farther) - here);
    }
}

/* Projects a displaced point to the screen.  A point outside of the guard band keeps *to,
 * the projected rest position; waves of a valid sea do not move points there. */
static void project(const tp_frame *frame, const tp_surface_point *from, tp_row_point *to)
{
    tp_view_vertex c = { .s = 0 };

    tp_projection_view_vertex(&frame->projection, from->position, &c);
    if (tp_projection_can_project(&frame->projection, &c))
        tp_projection_project(&frame->projection, &c, &to->u, &to->v, &to->zi);
}

static tp_row_point project_displaced_line_point(const screen_line *l, int32_t x)
{
    const tp_frame *frame = l->frame;
    const tp_level *level = frame->buffers.level;
    int64_t row = row_below_horizon(frame->buffers.projected, x, l->below);
    int64_t end = water_end_row(frame->buffers.projected, x);
    tp_fx   at[2], step[2][2];

    bool ends = row <= end;
    row = ends ? end : row;
    sample_rest(l, x, row, ends, at, step);
    tp_row_point p = {
        .u = 16 * x + 8,
        .v = (int32_t)((row + (1 << 25)) >> 26) + 8,
        .zi = (uint32_t)(tp_level_evaluate_fractional_row(&level->zi, x, row)
                         >> TP_LEVEL_ZI),
        .s = at[0],
        .t = at[1],
    };
    if (tp_surface_has_swells(&frame->surface)) {
        tp_surface_point from = frame->surface.by->points->point(&frame->surface, at, step);
        p.n = tp_level_pack_slopes(&from);
        if (from.position.x != at[0] || from.position.y != 0 || from.position.z != at[1])
            project(frame, &from, &p);
    }
    return p;
}

/* -- lines --------------------------------------------------------------------------- */

/* Returns the next line, px below the horizon: 1/16 nearer to the horizon, at most 4 px. */
static int32_t next_line_towards_horizon(int32_t px_below_horizon)
{
    return px_below_horizon > 64   ? px_below_horizon - 4
           : px_below_horizon > 32 ? px_below_horizon - 2
                                   : px_below_horizon - 1;
}

static void draw_line_points(const screen_line *l, tp_rows *rows, int32_t x0, int32_t x1)
{
    tp_row_point run[RUN + 1];
    uint32_t count = 0;

    for (int32_t x = x0; x <= x1; x += CELL) {
        run[count++] = project_displaced_line_point(l, x);
        if (count == RUN + 1 || x + CELL > x1) {
            tp_rows_draw_line(rows, run, count);
            run[0] = run[count - 1];
            count = 1;
        }
    }
}

static void draw_grid_line(const tp_frame *frame, tp_rows *rows, int32_t px_below_horizon)
{
    const tp_gbuffer *tile = rows->tile;
    const tp_level *level = frame->buffers.level;
    int32_t next = px_below_horizon > 0 ? next_line_towards_horizon(px_below_horizon) : 0;
    int64_t down = ray_descent(frame, px_below_horizon > 0 ? px_below_horizon : 1);
    screen_line l = { frame, px_below_horizon,
                      ray_descent(frame,
                                  px_below_horizon > 0 ? px_below_horizon - next : 1),
                      make_clamped_scale(level, down),
                      make_clamped_scale(level, ray_descent(frame, next)) };
    int32_t margin =
        tp_surface_has_swells(&frame->surface) ? side_margin(frame, down) : 2 * CELL;

    draw_line_points(&l, rows, (tile->x0 - margin) & ~(CELL - 1), tile->x1 + margin);
}

/* Returns the farthest line before the water's end in at least one column. */
static int32_t last_line(const tp_frame *frame, const tp_gbuffer *tile)
{
    const tp_projected *p = frame->buffers.projected;
    int64_t least = (int64_t)4096 * TP_Q30_ONE;

    for (int32_t x = tile->x0 & ~(CELL - 1); x < tile->x1 + CELL; x += CELL) {
        int64_t below = water_end_row(p, x) - p->horizon.at - p->horizon.x * x;
        least = below < least ? below : least;
    }
    return (int32_t)(least >> 30);
}

static void draw_projected(const tp_frame *frame, tp_gbuffer *tile, void *memory)
{
    const tp_level *level = frame->buffers.level;
    const tp_projected *p = frame->buffers.projected;
    int32_t side = level->down.x > 0 ? tile->x1 : tile->x0;
    int64_t down = tp_level_evaluate(&level->down, side, tile->y1);
    tp_rows rows;

    if (down <= 0)
        return;
    tp_rows_begin(&rows, tile, memory, true);
    int32_t below = first_line_below_ray(frame, down), last = last_line(frame, tile);
    below = below > 0 && below < p->start ? below : p->start;
    for (; below > last && rows.open > 0; below = next_line_towards_horizon(below))
        draw_grid_line(frame, &rows, below);
    if (rows.open > 0)
        draw_grid_line(frame, &rows, 0);
}

/* -- the renderer -------------------------------------------------------------------- */

/* Lays out the memory.  Flat water, if the plan may use it, has allocated the level plane
 * already. */
static void layout_projected(tp_frame_buffers *buffers, tp_arena *arena,
                             const tp_program *program, const tp_scene *scene,
                             const tp_config *config)
{
    (void)scene, (void)config;
    if (!(buffers->rung_mask.visibility >> TP_VISIBILITY_FLAT & 1) || !program->method.flat)
        buffers->level = tp_arena_alloc(arena, 1, sizeof *buffers->level);
    buffers->projected = tp_arena_alloc(arena, 1, sizeof *buffers->projected);
}

/* Does nothing: can_draw_projected has set all data. */
static void place_nothing(tp_frame *frame)
{
    (void)frame;
}

const struct tp_water_renderer tp_method_projected = {
    .layout = layout_projected, .holds = can_draw_projected,
    .place = place_nothing, .draw = draw_projected,
};
