/* SPDX-License-Identifier: MIT */
/* Pictures laid over things: which level, and the texel there.
 *
 * Of one sample a pixel the level is the engine's: the logarithm of texels a pixel, its
 * fraction by a straight line between whole ones.  Of several samples it is the
 * finest. */
#ifndef TP_REFERENCE_MAP_H
#define TP_REFERENCE_MAP_H
#include "scene.h"
#include "texture.h"

static inline double ref_rough_log2(double x)
{
    int e;
    const double m = frexp(x, &e);          /* 0.5 to 1 */
    return e - 1 + (2 * m - 1);
}

/* `texels` a metre, `at` the place; `level` ground is seen at a slant. */
static inline int ref_level(const ref_scene *s, const tp_texture *t, double texels,
                            double coarser, ref_vec at, bool level)
{
    const ref_camera *c = &s->camera;
    const double z = fmax(c->near, ref_dot(ref_sub(at, c->eye), c->ahead));
    const double near = c->near * 255 / 256;
    const double far = ref_rough_log2(near) - ref_rough_log2(near / z);
    double lod = ref_rough_log2(fmax(texels, 1.0 / 65536)) - ref_rough_log2(c->focal)
               + coarser + far;

    if (!s->meshed)
        return 0;
    if (level)
        lod += fmax(0, far) / 2 - ref_rough_log2(fmax(1, fabs(c->eye.y))) / 2;
    return (int)ref_clamp(floor(lod), 0, t->levels - 1);
}

/* A drifting picture at a place (x, z) at rest; level as above. */
static inline ref_colour ref_map_at(const ref_scene *s, const tp_texture *t,
                                    const tp_scene_map *map, double x, double z,
                                    double coarser, ref_vec at, bool linear)
{
    const double size = map->size / 65536.0;
    const double u = (x - map->drift_x / 65536.0 * s->seconds) / size;
    const double v = (z - map->drift_z / 65536.0 * s->seconds) / size;
    const int level = ref_level(s, t, (1 << t->log2_w) / size, coarser, at, true);

    return linear ? ref_linear(t, level, u, v)
                  : ref_colour_of(ref_nearest(t, level, u, v));
}
#endif
