/* SPDX-License-Identifier: MIT */
/* The start camera of a scene, and its view of level water. */
#ifndef TP_SCENE_START_VIEW_H
#define TP_SCENE_START_VIEW_H
#include "base/base.h"
#include "scene/sides.h"

typedef struct {
    tp_vec3     eye;
    tp_rotation turn;
    int64_t     wide, high;     /* tangents of half the picture's angles of view, Q16 */
    int64_t     x, z;           /* centre of the grid, m */
    tp_rectangle water;         /* extent of the water */
} tp_start_view;

tp_start_view tp_start_view_make(const tp_scene *scene, uint32_t width, uint32_t height);

/* Returns the distance from the centre of the grid to the end of the even cells, m.
 * *flank: number of lines beyond that end. */
int64_t tp_start_view_core_half_width(const tp_scene *scene, int32_t lines, int32_t *flank);

/* Returns the coordinate of a position `line` lines (Q16) from the middle of an axis.
 * Steps between lines of the skirt grow outwards. */
int64_t tp_start_view_line_coordinate(const tp_scene *scene, int32_t lines, int64_t centre,
                           int64_t line);

/* Returns the ray through (x, y) of the picture: tangents, Q16 per unit ahead, below
 * 2^26. */
tp_vec3 tp_start_view_ray(const tp_start_view *at, int64_t x, int64_t y);

/* Returns the distance ahead, Q16 m, at that the ray through (x, y) meets level water, or
 * 0. */
int64_t tp_start_view_water_distance(const tp_start_view *at, int64_t x, int64_t y);

/* Returns to - from, clamped to 8 km along each axis. */
static inline tp_vec3 tp_start_view_clamped_vector(tp_vec3 from, tp_vec3 to)
{
    const int64_t most = 1 << 29;

    return (tp_vec3){ (tp_fx)tp_clamp_abs((int64_t)to.x - from.x, most),
                      (tp_fx)tp_clamp_abs((int64_t)to.y - from.y, most),
                      (tp_fx)tp_clamp_abs((int64_t)to.z - from.z, most) };
}
#endif
