/* SPDX-License-Identifier: MIT */
/* Random cameras, lights and colours for the shading stages, and the values that the
 * reference needs from them. */
#ifndef TP_TESTS_SHADES_H
#define TP_TESTS_SHADES_H
#include "../reference/shading.h"
#include "runs.h"

#define Q14 16384.0
#define Q12 4096.0

typedef void stage(const tp_shade *shade, tp_run *run);

/* Focal lengths of 200 to 1000 pixels, as for 640 x 480 pixels at 60 degrees. */
/* Table shared by all shades: tests use one shade at a time. */
static tp_entry16 shade_shine[TP_SHINE + 1];

static inline tp_shade shade_any(uint64_t *state)
{
    const tp_rotation turn =
        tp_rotation_from_angles((tp_turn)random_next(state),
                                (tp_turn)chance_int(state, -400000000, 400000000), 0);
    const tp_dir3 light = tp_normalise(chance_int(state, -1000, 1000),
                                       chance_int(state, 20, 1000),
                                       chance_int(state, -1000, 1000));
    tp_shade s = {
        .u0 = 320 * 16, .v0 = 240 * 16,
        .focal = chance_int(state, 200, 1000) * 16,
        .world = { turn.x, turn.y, turn.z, light.x >> 16, light.y >> 16, light.z >> 16 },
        .zi_log = 15 * 256 + 14 * 256,
        .water_colour = (uint32_t)random_next(state) & 0xffffff,
        .light_colour = (uint32_t)random_next(state) & 0xffffff,
        .ambient = chance_int(state, 0, 256),
        .mirror = chance_int(state, 0, 256),
        .shine = shade_shine,
    };
    s.fresnel = tp_fresnel_table;
    tp_shade_sky(&s, (uint32_t)random_next(state) & 0xffffff,
                 (uint32_t)random_next(state) & 0xffffff);
    return s;
}

static inline tp_solid solid_any(const uint8_t gloss[TP_GLOSS], uint64_t *state)
{
    return (tp_solid){ .diffuse = (uint32_t)random_next(state) & 0xffffff,
                       .specular = (uint32_t)random_next(state) & 0xffffff,
                       .bump = 256, .gloss = gloss };
}

static inline ref_dir shade_dir(tp_dir3 d)
{
    return (ref_dir){ d.x / 1073741824.0, d.y / 1073741824.0, d.z / 1073741824.0 };
}

static inline ref_dir shade_light(const tp_view_axes *a)
{
    return (ref_dir){ a->lx / Q14, a->ly / Q14, a->lz / Q14 };
}

/* Direction from the pixel's centre to the eye. */
static inline ref_dir shade_view(const tp_shade *s, const tp_view_axes *axes, int32_t x,
                                 int32_t y)
{
    const ref_dir right = shade_dir(axes->right), up = shade_dir(axes->up),
                  back = shade_dir(axes->back);
    const double u = 16 * x + 8 - s->u0, v = s->v0 - 16 * y - 8, f = s->focal;

    return ref_unit((ref_dir){ f * back.x - u * right.x - v * up.x,
                               f * back.y - u * right.y - v * up.y,
                               f * back.z - u * right.z - v * up.z });
}

static inline double run_sx(const test_run *r, int i)
{
    return (int16_t)(r->n[i] >> 16) / Q12;
}

static inline double run_sz(const test_run *r, int i)
{
    return (int16_t)(r->n[i] & 0xffff) / Q12;
}
#endif
