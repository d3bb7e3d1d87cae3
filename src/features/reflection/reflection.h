/* SPDX-License-Identifier: MIT */
/*
 * Reflections of objects on the water, by two modules, with the data of their stages in
 * tp_run.mine: the planar reflection, a planar map of the objects; and the object cube
 * map, five small pictures of the objects around a point on the water.  Further their
 * parameters.
 *
 *     reflection_drawing.c   the module mirror, its picture and its cost
 *     object_cube_drawing.c  the module object_cube and its pictures
 *     reflection_stage.c     their span stages
 *     fast_reflection_stage.c  the planar reflection by blocks of pixels
 *     reflection_wide.h      the planar reflection's loop for vector units
 */
#ifndef TP_FEATURES_REFLECTION_REFLECTION_H
#define TP_FEATURES_REFLECTION_REFLECTION_H
#include "pixel/pixel.h"
#include "shade/shade.h"
#include "tidepool/fixed.h"
#include "tidepool/modules.h"
#include "world/module.h"

#define TP_MIRROR_ID TP_MODULE_ID('m', 'i', 'r', 'r')

/* Inverse depths (zi) of the nearest and farthest object in a column, Q1.31. */
typedef struct {
    uint32_t near, far;
} tp_mirrored_zi;

typedef struct {
    tp_planar_map map;          /* planar map of objects above the level, upside down */
    int32_t  bend;              /* effect of slopes; 256 is physical */
    int64_t  height;            /* eye over the mirror's level, Q12 near planes */
    const tp_mirrored_zi *zi;   /* array, one for each column from x0 on */
} tp_mirror;

/* Displacements on the screen, 28.4 px: xu xv zu zv for a slope of 1 and share 1; hu hv
 * for h / zm = 1. */
typedef struct {
    int32_t xu, xv, zu, zv, hu, hv;
    int32_t dy;                 /* y of the ray, Q16 */
} tp_mirror_push;

/* reflection_stage.c.  Returns the factors at column x of row y. */
tp_mirror_push tp_mirror_push_make(const tp_shade *shade, int32_t x, int32_t y);

/* Returns z / zm, Q16, clamped below 2. */
TP_ALWAYS_INLINE int32_t tp_mirror_depth_ratio(uint32_t object_zi, uint32_t water_key)
{
    uint32_t zi = tp_key_zi(water_key);
    int      shift = tp_clz(zi);
    uint64_t ratio = (uint64_t)object_zi * (uint32_t)tp_recip_rough(zi << shift)
                  >> (46 - shift);
    return ratio < 131071 ? (int32_t)ratio : 131071;
}

/* In a column with several objects, water up to the nearest object and 1/8 beyond it, by
 * z / zm in Q16, reflects the nearest.  Water farther away reflects the farthest object.
 * Water behind the farthest object reflects none of them: the reflected rays start behind
 * all objects. */
#define TP_MIRROR_BESIDE (65536 + 8192)

/* Finds the object that water at column x of the picture reflects: its zi, and z / zm, Q16.
 * Returns false if the water reflects none. */
TP_ALWAYS_INLINE bool tp_mirror_find_object(const tp_mirror *look, int32_t x,
                                            uint32_t water_key, uint32_t *zi,
                                            int32_t *ratio)
{
    const tp_planar_map *map = &look->map;
    const tp_mirrored_zi *column = &look->zi[tp_clamp(
        (x >> map->halvings) - map->x0, 0, map->x1 - map->x0 - 1)];

    *zi = column->near;
    *ratio = tp_mirror_depth_ratio(*zi, water_key);
    if (*ratio <= TP_MIRROR_BESIDE)
        return true;
    *zi = column->far;
    *ratio = tp_mirror_depth_ratio(*zi, water_key);
    return *ratio <= 65536;
}

/* A pixel of a map of mirror.colours = rgb565: 0 where no object is, else its colour. */
TP_ALWAYS_INLINE uint32_t tp_mirror_unpack(uint32_t pixel)
{
    return pixel ? tp_rgb565_expand(pixel) | 0xff000000u : 0;
}

static inline uint32_t tp_mirror_packed_pixel(const tp_planar_map *map, int32_t i, int32_t j)
{
    const uint16_t *const pixels = (const uint16_t *)(const void *)map->colour;

    if (i < map->x0 || i >= map->x1 || j < map->y0 || j >= map->y1)
        return 0;
    return pixels[(size_t)(uint32_t)(j - map->y0) * (uint32_t)(map->x1 - map->x0)
                  + (uint32_t)(i - map->x0)];
}

/* As tp_planar_map_sample, of such a map. */
static inline uint32_t tp_mirror_sample_packed(const tp_planar_map *map, int32_t u, int32_t v)
{
    const int32_t i = (u - 16) >> 5, j = (v - 16) >> 5;
    const uint32_t a = tp_mirror_packed_pixel(map, i, j),
                   b = tp_mirror_packed_pixel(map, i + 1, j),
                   c = tp_mirror_packed_pixel(map, i, j + 1),
                   d = tp_mirror_packed_pixel(map, i + 1, j + 1);

    if (((a ^ b) | (a ^ c) | (a ^ d)) == 0)
        return tp_mirror_unpack(a);
    return tp_planar_map_mix(tp_mirror_unpack(a), tp_mirror_unpack(b), tp_mirror_unpack(c),
                             tp_mirror_unpack(d), (uint32_t)(u - 16) & 31,
                             (uint32_t)(v - 16) & 31);
}

/* Samples the map; `packed`: mirror.colours = rgb565. */
TP_ALWAYS_INLINE uint32_t tp_mirror_sample(const tp_planar_map *map, int32_t u, int32_t v,
                                           int packed)
{
    return packed ? tp_mirror_sample_packed(map, u, v) : tp_planar_map_sample(map, u, v);
}

#define TP_OBJECT_CUBE_ID TP_MODULE_ID('c', 'u', 'b', 'e')

#define TP_OBJECT_CUBE_SIDE  32
#define TP_OBJECT_CUBE_FACES 5         /* +x -x +z -z +y; -y is below the water's level */

typedef struct {
    const uint32_t *colour;     /* texels 0xAARRGGBB, face by face; NULL: empty */
    tp_vec3  from;              /* eye - the point, m */
    tp_vec3  to;                /* middle of the objects - the point, m */
    int32_t  nx, nz;            /* horizontal direction of `to`, Q1.14 */
    tp_fx    zi_near;
} tp_object_cube;

#define TP_REFLECTION_ROWS \
    TP_ROW_CHOICE("mirror.method", mirror.method, "none|stencil|cube", \
        TP_MIRROR_CUBE, TP_MIRROR_NONE, \
        "boat and drops in the water: sharp (stencil), or from a small cube"), \
    TP_ROW_CHOICE("mirror.size", mirror.size, "half|quarter|full", \
        TP_MIRROR_FULL, TP_MIRROR_HALF, \
        "side of the stencil's image; full takes 4 times the bytes of half"), \
    TP_ROW_CHOICE("mirror.colours", mirror.colours, "rgb888|rgb565", \
        TP_MIRROR_RGB565, TP_MIRROR_RGB888, \
        "colours of the stencil's image; rgb565 takes half the bytes"), \
    TP_ROW_NUMBER("mirror.distortion", mirror.distortion, "", 0, 4, 1, \
        "strength with which waves distort the mirrored image")

#endif
