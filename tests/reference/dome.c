/* SPDX-License-Identifier: MIT */
/* Generated skies. The palettes are the engine's, copied as data. */
#include "dome.h"

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
    return ref_mix(ref_colour_of(s[i].colour), ref_colour_of(s[i + 1].colour),
                   ref_clamp(share, 0, 1));
}

/* Colour of the day sky's two gradients; towards the sun the air near the horizon is as
 * bright as the sun's light. */
static ref_colour day(const tp_scene *scene, bool towards, double sine)
{
    const double left = 1 - sine, low = left * left;
    const ref_colour c = ref_sky((uint32_t)scene->sky.horizon,
                                 (uint32_t)scene->sky.zenith, sine);
    return towards ? ref_mix(c, ref_colour_of((uint32_t)scene->light.colour),
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
