/* SPDX-License-Identifier: MIT */
/* Where a scene's camera stands at the start, and what it would see of level water. */
#ifndef TP_SCENE_STAND_H
#define TP_SCENE_STAND_H
#include "base/base.h"
#include "scene/sides.h"

typedef struct {
    tp_vec3     eye;
    tp_rotation turn;
    int64_t     wide, high;     /* tangents of half the picture, Q16 */
    int64_t     x, z;           /* the grid's centre */
    tp_rectangle water;         /* that there is */
} tp_stand;

tp_stand tp_stand_of(const tp_scene *scene, uint32_t width, uint32_t height);

/* From the grid's centre to the end of its even cells; `flank`: lines beyond. */
int64_t tp_stand_half(const tp_scene *scene, int32_t lines, int32_t *flank);

/* Where the place `line` lines (Q16) from the middle of an axis lies; those of the flanks
 * grow. */
int64_t tp_stand_line(const tp_scene *scene, int32_t lines, int64_t centre, int64_t line);

/* The ray through x, y of the picture: tangents, Q16 of one ahead, below 2^26. */
tp_vec3 tp_stand_ray(const tp_stand *at, int64_t x, int64_t y);

/* How far ahead, m in Q16, it meets the level water; 0: it does not. */
int64_t tp_stand_water(const tp_stand *at, int64_t x, int64_t y);

/* From one place to another, held within 8 km along each axis. */
static inline tp_vec3 tp_stand_way(tp_vec3 from, tp_vec3 to)
{
    const int64_t most = 1 << 29;

    return (tp_vec3){ (tp_fx)tp_limit((int64_t)to.x - from.x, most),
                      (tp_fx)tp_limit((int64_t)to.y - from.y, most),
                      (tp_fx)tp_limit((int64_t)to.z - from.z, most) };
}
#endif
