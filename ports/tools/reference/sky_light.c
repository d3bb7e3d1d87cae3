/* SPDX-License-Identifier: MIT */
/* Sky colour by direction, built from the parts of env.h.  First the gradients of generated
 * skies, with the engine's palettes copied as data; then the plain gradient, cube maps,
 * haze and exposure. */
#include "sky_light.h"
#include "map.h"

typedef struct {
    int      sine;              /* sine of the elevation, in 1/256 */
    uint32_t colour;
} ref_stop;

#define STOPS 7

static const ref_stop dusk_towards[STOPS] = {
    { 0, 0xffae58 }, { 12, 0xf79860 }, { 34, 0xd77a74 }, { 66, 0x9d6488 },
    { 110, 0x645688 }, { 170, 0x343c74 }, { 256, 0x161f50 },
};
static const ref_stop dusk_away[STOPS] = {
    { 0, 0x74668c }, { 16, 0x8e7298 }, { 36, 0x86709c }, { 66, 0x625f96 },
    { 110, 0x414a86 }, { 170, 0x26316a }, { 256, 0x161f50 },
};
static const ref_stop night_towards[STOPS] = {
    { 0, 0x2c3c58 }, { 12, 0x243450 }, { 34, 0x1a2844 }, { 66, 0x121d36 },
    { 110, 0x0c152a }, { 170, 0x070e1e }, { 256, 0x040915 },
};
static const ref_stop night_away[STOPS] = {
    { 0, 0x172236 }, { 12, 0x141e32 }, { 34, 0x10192c }, { 66, 0x0b1324 },
    { 110, 0x080e1e }, { 170, 0x060b19 }, { 256, 0x040915 },
};

static ref_colour between_stops(const ref_stop *s, double sine)
{
    int i = 0;

    while (i < STOPS - 2 && s[i + 1].sine < 256 * sine)
        i++;
    const double share = (256 * sine - s[i].sine) / (s[i + 1].sine - s[i].sine);
    return ref_mix(ref_colour_unpack(s[i].colour), ref_colour_unpack(s[i + 1].colour),
                   ref_clamp(share, 0, 1));
}

/* Colour of the day sky's two gradients; towards the sun the air near the horizon is as
 * bright as the sun's light. */
static ref_colour day(const tp_scene *scene, bool towards, double sine)
{
    const double left = 1 - sine, low = left * left;
    const ref_colour c = ref_sky((uint32_t)scene->sky.horizon,
                                 (uint32_t)scene->sky.zenith, sine);
    return towards ? ref_mix(c, ref_colour_unpack((uint32_t)scene->light.colour),
                             low * low * 5 / 8) : c;
}

static ref_colour gradient(const tp_scene *scene, bool towards, double sine)
{
    if (scene->sky.kind == TP_SKY_DUSK)
        return between_stops(towards ? dusk_towards : dusk_away, sine);
    if (scene->sky.kind == TP_SKY_NIGHT)
        return between_stops(towards ? night_towards : night_away, sine);
    return day(scene, towards, sine);
}

#define WHOLE    0x1p28         /* scale of the squared chords in env.h: 28 binary places */
#define DISC_END 131072         /* squared chord at which the disc's edge has faded out */

/* Below the horizon the sky darkens, to a quarter within 11 degrees. */
ref_light ref_dome(const ref_scene *s, ref_vec way, bool disc)
{
    const tp_scene *scene = s->scene;
    const ref_vec off = ref_sub(way, s->light);
    const double square = ref_dot(off, off) * WHOLE, sine = ref_clamp(way.y, 0, 1);
    const ref_colour base = ref_mix(gradient(scene, false, sine),
                                    gradient(scene, true, sine), ref_towards(square));
    ref_light light = ref_glow(scene->sky.kind - TP_SKY_DAY,
                               (uint32_t)scene->light.colour, scene->sky.sun / 65536.0,
                               disc ? square : fmax(square, DISC_END));

    light.colour = ref_add(base, light.colour);
    if (way.y < 0) {
        light.colour = ref_scale(light.colour, ref_clamp(1 + 4 * way.y, 0.25, 1));
        light.alpha = 0;
    }
    return light;
}

/* Cube map sample. A face with full alpha everywhere has no brightness above white. */
static ref_light sample_cube(const ref_scene *s, ref_vec way, double coarser)
{
    const ref_place p = ref_cube_place((ref_dir){ way.x, way.y, way.z });
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

static ref_light sample_environment(const ref_scene *s, ref_vec way, double coarser,
                                    bool disc)
{
    const tp_scene *scene = s->scene;

    if (has_cube(s))
        return sample_cube(s, way, coarser);
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
    return sample_environment(s, way, 0.5 + far / 2, s->scene->water.specular <= 0);
}

ref_colour ref_heaven_whole(const ref_scene *s, ref_light light)
{
    return ref_unclamped_colour(light, s->scene->hdr.share / 65536.0);
}

ref_colour ref_heaven(const ref_scene *s, ref_vec way)
{
    return ref_add(ref_heaven_whole(s, sample_environment(s, way, 0, true)),
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
