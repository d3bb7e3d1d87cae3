/* SPDX-License-Identifier: MIT */
/* Slope grid of flat water at every 8th column and row of the picture, evaluated once a
 * frame for any number of tiles.  Also the conditions and the level plane of the renderers
 * based on level water: the water is swells alone, all below the eye. */
#include "frame/frame.h"
#include "view/wave_models.h"
#include "world/pools.h"

enum { CELL = TP_LATTICE_CELL };

static uint32_t count_points(uint32_t pixels)
{
    return (pixels + CELL - 1) / CELL + 1;
}

static bool has_waves(const tp_scene *scene)
{
    for (int i = 0; i < TP_WAVES; i++) {
        if (scene->wave[i].amplitude > 0)
            return true;
    }
    return false;
}

void tp_frame_layout_slopes(tp_frame_buffers *buffers, tp_arena *arena,
                            const tp_scene *scene, const tp_config *config)
{
    if (!has_waves(scene))
        return;
    buffers->slope_cols = count_points(config->width);
    buffers->slopes = tp_arena_alloc(arena, (size_t)buffers->slope_cols
                                             * count_points(config->height),
                                  sizeof *buffers->slopes);
}

bool tp_frame_can_use_level_plane(const tp_frame *frame)
{
    const tp_surface *surface = &frame->surface;

    return frame->buffers.level && !surface->coastal
           && !tp_surface_has_rings_or_pools(surface) && !tp_has_tank(frame->scene)
           && (surface->by->points || !tp_surface_has_swells(surface))
           && frame->projection.eye.y
                  >= tp_surface_height_bound(surface) + TP_LEVEL_HEIGHT;
}

void tp_frame_place_level(tp_frame *frame)
{
    TP_ASSERT(frame->buffers.level != NULL);
    tp_level_begin(frame->buffers.level, &frame->projection);
}

/* -- slope grid ---------------------------------------------------------------------- */

/* A row of points: values shared by its points if the picture does not roll. */
typedef struct {
    int64_t down, step;         /* depth term of the first point; step to the next */
    tp_level_scale reach, beyond;
} row_of_points;

static tp_level_scale make_clamped_reach(const tp_level *level, int64_t down)
{
    return tp_level_metres_per_pixel(level, down > 0 ? down : 1);
}

static row_of_points make_row(const tp_level *level, int32_t y)
{
    int64_t down = tp_level_evaluate(&level->down, 0, y);
    return (row_of_points){ down, level->down.x * CELL, make_clamped_reach(level, down),
                            make_clamped_reach(level, down - level->down.y * CELL) };
}

/* Returns the rest position of a point, and the vectors to its right neighbour and to its
 * farther neighbour. */
static void sample_rest(const tp_level *level, const row_of_points *row, int32_t x,
                        int32_t y, tp_fx at[2], tp_fx step[2][2])
{
    const tp_level_linear *sums[2] = { &level->east, &level->south };
    const tp_fx eye[2] = { level->x, level->z };
    tp_level_scale reach = row->reach, beyond = row->beyond;

    if (level->rolled) {
        int64_t down = tp_level_evaluate(&level->down, x, y);
        reach = make_clamped_reach(level, down);
        beyond = make_clamped_reach(level, down - level->down.y * CELL);
    }
    for (int axis = 0; axis < 2; axis++) {
        int64_t way = tp_level_evaluate(sums[axis], x, y);
        int64_t here = tp_level_pixels_to_metres(reach, way);
        int64_t far = tp_level_pixels_to_metres(beyond, way - sums[axis]->y * CELL);
        at[axis] = tp_fx_saturate(eye[axis] + here);
        step[0][axis] =
            tp_fx_saturate(tp_level_pixels_to_metres(reach, sums[axis]->x * CELL));
        step[1][axis] = tp_fx_saturate(far - here);
    }
}

static uint32_t sample_slopes(const tp_frame *frame, const row_of_points *row, int32_t x,
                              int32_t y)
{
    const tp_level *level = frame->buffers.level;
    tp_fx at[2], step[2][2];

    sample_rest(level, row, x, y, at, step);
    tp_surface_point point =
        frame->surface.by->points->point(&frame->surface, at, step);
    return tp_level_pack_slopes(&point);
}

/* Computes a row of slopes.  Slopes above the horizon are 0 and not evaluated. */
static void place_row(tp_frame *frame, int32_t y, uint32_t cols, uint32_t *slopes)
{
    const row_of_points row = make_row(frame->buffers.level, y);
    int64_t down = row.down;

    for (uint32_t i = 0; i < cols; i++, down += row.step) {
        slopes[i] = 0;
        if (down <= 0)
            continue;
        slopes[i] = sample_slopes(frame, &row, (int32_t)i * CELL, y);
        frame->stats.vertices++;
    }
}

void tp_frame_place_slopes(tp_frame *frame)
{
    TP_ASSERT(frame->buffers.slopes != NULL && frame->buffers.slope_cols > 0);
    const uint32_t cols = frame->buffers.slope_cols;
    const uint32_t rows = count_points(frame->config.height);

    for (uint32_t j = 0; j < rows; j++)
        place_row(frame, (int32_t)j * CELL, cols, frame->buffers.slopes + j * cols);
}
