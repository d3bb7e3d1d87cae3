/* SPDX-License-Identifier: MIT */
/* The sun or moon as moved by input and time, the sky's configuration, and the camera's
 * exposure. */
#include "base/base.h"
#include "world/light.h"

#define LEAST TP_DEG(1)
#define MOST  TP_DEG(90)

static tp_turn clamp_elevation(int64_t height)
{
    return (tp_turn)(height < LEAST ? LEAST : height > MOST ? MOST : height);
}

tp_dir3 tp_light_direction(tp_turn heading, tp_turn elevation)
{
    tp_q30 level = tp_cos(elevation);

    return (tp_dir3){ tp_q30_mul(level, tp_sin(heading)), tp_sin(elevation),
                      -tp_q30_mul(level, tp_cos(heading)) };
}

bool tp_has_dome(const tp_scene *scene)
{
    return scene->sky.kind == TP_SKY_DAY || scene->sky.kind == TP_SKY_DUSK
        || scene->sky.kind == TP_SKY_NIGHT;
}

tp_dome_config tp_dome_config_make(const tp_scene *scene)
{
    return (tp_dome_config){
        .kind = scene->sky.kind == TP_SKY_DUSK    ? TP_DOME_DUSK
              : scene->sky.kind == TP_SKY_NIGHT ? TP_DOME_NIGHT : TP_DOME_DAY,
        .horizon = (uint32_t)scene->sky.horizon, .zenith = (uint32_t)scene->sky.zenith,
        .light = (uint32_t)scene->light.colour, .sun = scene->sky.sun,
    };
}

static void save_last_light(tp_world *world)
{
    world->last_light_heading = world->light_heading;
    world->last_light_elevation = world->light_elevation;
    world->last_exposure = world->exposure;
}

static void set_light_from_scene(tp_world *world, const tp_scene *scene)
{
    world->light_heading = tp_turn_of_degrees(scene->light.heading);
    world->light_elevation =
        clamp_elevation((int32_t)tp_turn_of_degrees(scene->light.elevation));
    world->scene_light[0] = scene->light.heading;
    world->scene_light[1] = scene->light.elevation;
}

void tp_light_init(tp_world *world, const tp_scene *scene)
{
    TP_ASSERT(world != NULL && scene->hdr.exposure_factor > 0);
    set_light_from_scene(world, scene);
    world->exposure = scene->hdr.exposure_factor;
    save_last_light(world);
}

/* A light moved by time or input keeps its position until the scene's heading or
 * elevation changes. */
void tp_light_apply_scene(tp_world *world, const tp_scene *scene)
{
    if (world->scene_light[0] != scene->light.heading
        || world->scene_light[1] != scene->light.elevation)
        set_light_from_scene(world, scene);
    if (scene->hdr.exposure == TP_EXPOSURE_FIXED)
        world->exposure = world->last_exposure = scene->hdr.exposure_factor;
}

/* The rotation per tick is rounded to within 2^-33 turn; the sum drifts by less than 1
 * degree in four days. */
void tp_light_step(tp_world *world, const tp_scene *scene, const tp_input *in)
{
    save_last_light(world);
    int64_t second = (int64_t)scene->light.turn * ((int64_t)1 << 32);
    const int64_t ticks = (int64_t)360 * TP_FX_ONE * TP_TICKS_PER_SECOND;
    int64_t tick = tp_quotient(second < 0 ? second - ticks / 2 : second + ticks / 2, ticks);

    world->light_heading += (tp_turn)tick;
    if (!in)
        return;
    world->light_heading += (tp_turn)in->light_turn;
    world->light_elevation =
        clamp_elevation((int64_t)world->light_elevation + in->light_tilt);
}

static bool is_in_range(int64_t x, int64_t low, int64_t high)
{
    return x >= low && x <= high;
}

bool tp_light_is_valid(const tp_world *world)
{
    const tp_fx least = TP_FX_ONE / 8, most = 8 * TP_FX_ONE;    /* [F8]: exposure range */

    return is_in_range(world->light_elevation, LEAST, MOST)
           && is_in_range(world->last_light_elevation, LEAST, MOST)
           && is_in_range(world->exposure, least, most)
           && is_in_range(world->last_exposure, least, most);
}
