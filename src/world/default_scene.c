/* SPDX-License-Identifier: MIT */
/* The default scene: gentle deep water with three waves under a sunny sky, with a
 * built-in ripple texture of 1364 bytes. */
#include "tidepool/assets.h"

#include "world/sea_ripple.inc"

static const tp_texture ripple = {
    .level = { ripple_0, ripple_1, ripple_2, ripple_3, ripple_4 },
    .log2_w = 4, .log2_h = 4, .levels = 5,
};

static const tp_assets pictures = { .ripple = &ripple };

static tp_wave make_wave(tp_fx amplitude, tp_fx length, tp_fx heading, tp_fx phase)
{
    return (tp_wave){
        .amplitude = amplitude, .length = length, .steepness = TP_FX(0.25),
        .heading = heading, .phase = phase, .speed = TP_FX_ONE, .exponent = 1,
    };
}

static void set_light_and_sky(tp_scene *scene)
{
    scene->light.heading = TP_FX(20);
    scene->light.elevation = TP_FX(22);
    scene->light.colour = 0xfff0d0;
    scene->light.ambient = TP_FX(0.4);
    scene->sky.kind = TP_SKY_DAY;
    scene->sky.horizon = 0xc4dcea;
    scene->sky.zenith = 0x2f6cb0;
    scene->sky.haze = TP_FX(900);
}

static void set_water(tp_scene *scene)
{
    scene->water.colour = 0x1c5468;
    scene->water.specular = TP_FX(0.9);
    scene->water.shininess = TP_FX(60);
    scene->water.reflection = TP_FX(0.9);
    scene->ripple.map.size = TP_FX(2.4);
    scene->ripple.map.drift_x = TP_FX(0.12);
    scene->ripple.map.drift_z = TP_FX(0.05);
    scene->ripple.bump = TP_FX(0.6);
    scene->wave[0] = make_wave(TP_FX(0.3), TP_FX(19), TP_FX(30), 0);
    scene->wave[1] = make_wave(TP_FX(0.16), TP_FX(11), TP_FX(75), TP_FX(140));
    scene->wave[2] = make_wave(TP_FX(0.09), TP_FX(6), TP_FX(350), TP_FX(250));
}

void tp_scene_init(tp_scene *scene)
{
    tp_scene_level(scene);
    scene->camera.y = TP_FX(2.4);
    scene->camera.pitch = TP_FX(-6);
    scene->camera.fov = TP_FX(60);
    set_light_and_sky(scene);
    set_water(scene);
    scene->pictures = &pictures;
}
