/* SPDX-License-Identifier: MIT */
/* Texture lookup: mipmap level and texel.
 *
 * With one sample a pixel the level is the engine's: the logarithm of texels a pixel, with
 * the fraction interpolated linearly between powers of two. With several samples a pixel
 * the level is the finest. */
#ifndef TP_TOOLS_REFERENCE_MAP_H
#define TP_TOOLS_REFERENCE_MAP_H
#include "scene.h"
#include "texture.h"
#include "tidepool/assets.h"

static inline double ref_rough_log2(double x)
{
    int e;
    const double m = frexp(x, &e);          /* 0.5 to 1 */
    return e - 1 + (2 * m - 1);
}

/* Level of detail, not rounded, for `texels` a metre at a distance of 2^far m. The ground
 * lies `over` metres below the eye and is seen at a slant; over = 0: upright. */
static inline double ref_lod(const ref_scene *s, double texels, double far, double over)
{
    const double lod = ref_rough_log2(fmax(texels, 1.0 / 65536))
                     - ref_rough_log2(s->camera.focal) + far;
    return over > 0 ? lod + (fmax(0, far) - ref_rough_log2(over)) / 2 : lod;
}

/* log2 of the depth from the G-buffer's 1 / z. */
static inline double ref_far(const ref_scene *s, ref_vec at)
{
    const ref_camera *c = &s->camera;
    const double z = fmax(c->near, ref_dot(ref_sub(at, c->eye), c->ahead));
    const double near = c->near * 255 / 256;
    return ref_rough_log2(near) - ref_rough_log2(near / z);
}

/* Level of detail on the water's plane. */
static inline double ref_water_lod(const ref_scene *s, double texels, ref_vec at)
{
    return ref_lod(s, texels, ref_far(s, at), fmax(1, fabs(s->camera.eye.y)));
}

static inline int ref_level(const ref_scene *s, const tp_texture *t, double lod)
{
    return s->meshed ? (int)ref_clamp(floor(lod), 0, t->levels - 1) : 0;
}

/* Colour of a drifting texture at a rest point (x, z). */
static inline ref_colour ref_sample_map(const ref_scene *s, const tp_texture *t,
                                        const tp_scene_map *map, double x, double z,
                                        ref_vec at, bool linear)
{
    const double size = map->size / 65536.0;
    const double u = (x - map->drift_x / 65536.0 * s->seconds) / size;
    const double v = (z - map->drift_z / 65536.0 * s->seconds) / size;
    const double lod = ref_water_lod(s, (1 << t->log2_w) / size, at);
    const int level = ref_level(s, t, lod);

    return linear ? ref_linear(t, level, u, v)
                  : ref_colour_unpack(ref_nearest(t, level, u, v));
}
#endif
