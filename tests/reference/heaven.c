/* SPDX-License-Identifier: MIT */
/* Sky colour by direction, built from the parts of env.h; the gradients of generated skies
 * are in dome.c. */
#include "heaven.h"
#include "dome.h"
#include "map.h"

/* Cube map sample. A face with full alpha everywhere has no brightness above white. */
static ref_light cube_at(const ref_scene *s, ref_vec way, double coarser)
{
    const ref_place p = ref_cube_at((ref_dir){ way.x, way.y, way.z });
    const tp_texture *t = s->assets->sky[p.face];
    const double lod = t->log2_w - 1 - ref_rough_log2(s->camera.focal) + coarser;
    const int level = s->meshed ? (int)ref_clamp(floor(lod), 0, t->levels - 1) : 0;
    ref_light light = ref_face_texel(t->level[level], ref_side(t->log2_w, level),
                                     ref_side(t->log2_h, level), p.s, p.t);

    if (t->level[t->levels - 1][0] >> 24 == 255)
        light.alpha = 0;
    return light;
}

static bool has_cube(const ref_scene *s)
{
    bool all = s->scene->sky.kind == TP_SKY_CUBE;

    for (int i = 0; i < TP_FACES; i++)
        all &= s->assets->sky[i] != NULL;
    return all;
}

static ref_light light_from(const ref_scene *s, ref_vec way, double coarser, bool disc)
{
    const tp_scene *scene = s->scene;

    if (has_cube(s))
        return cube_at(s, way, coarser);
    if (scene->sky.kind != TP_SKY_GRADIENT && scene->sky.kind != TP_SKY_CUBE)
        return ref_dome(s, way, disc);
    return (ref_light){ ref_sky((uint32_t)scene->sky.horizon, (uint32_t)scene->sky.zenith,
                                way.y), 0 };
}

/* Sky in the water's mirror. A direction below the horizon gets the horizon's colour. */
ref_light ref_heaven_mirrored(const ref_scene *s, ref_vec way, ref_vec at)
{
    const ref_camera *c = &s->camera;
    const double z = ref_dot(ref_sub(at, c->eye), c->ahead);
    const double far = fmax(0, ref_rough_log2(fmax(z, c->near)));

    way.y = fmax(way.y, 0);
    return light_from(s, way, 0.5 + far / 2, s->scene->water.specular <= 0);
}

ref_colour ref_heaven_whole(const ref_scene *s, ref_light light)
{
    return ref_beyond(light, s->scene->hdr.share / 65536.0);
}

ref_colour ref_heaven(const ref_scene *s, ref_vec way)
{
    return ref_add(ref_heaven_whole(s, light_from(s, way, 0, true)),
                   (ref_colour){ { 0, 0, 0 } });
}

/* -- between object and eye ---------------------------------------------------------- */

ref_colour ref_heaven_haze(const ref_scene *s, ref_colour colour, ref_vec at)
{
    const ref_vec off = ref_sub(at, s->camera.eye);
    const double z = fmax(0, ref_dot(off, s->camera.ahead)), h = s->haze;
    const ref_vec level = { off.x, 0, off.z };

    if (h <= 0)
        return colour;
    return ref_mix(colour, ref_heaven(s, ref_unit_vec(level)),
                   z * z / (z * z + h * h));
}

ref_colour ref_heaven_exposed(const ref_scene *s, ref_colour colour)
{
    const double e = s->exposure;

    for (int i = 0; i < 3 && e != 1; i++) {
        const double t = ref_clamp(colour.c[i] / 255, 0, 1);
        colour.c[i] = 255 * e * t / (1 + (e - 1) * (e > 1 ? t : t * t * t * t));
    }
    return colour;
}
