/* SPDX-License-Identifier: MIT */
/* The world: what of a scene moves, tick by tick.  Nothing here knows that it is
 * drawn. */
#include "scene/boat.h"

#define PITCH_MOST TP_DEG(89)
#define EYE_MOST   (8000 * TP_FX_ONE)

/* A scene without a boat does not feel for the water under one. */
static void place_boat(tp_world *world, const tp_scene *scene)
{
    if (scene->boat.mesh[0])
        tp_boat_place(world, scene);
}

void tp_world_refresh(tp_world *world, const tp_scene *scene)
{
    tp_sea_init(&world->sea, scene->wave, TP_WAVES, scene->water.gravity);
    tp_sea_phases(&world->sea, world->tick, world->phases);
    place_boat(world, scene);
}

void tp_world_init(tp_world *world, const tp_scene *scene)
{
    *world = (tp_world){
        .eye = { scene->camera.x, scene->camera.y, scene->camera.z },
        .heading = tp_turn_of_degrees(scene->camera.heading),
        .pitch = tp_turn_of_degrees(scene->camera.pitch),
        .boat_turn = tp_rotation_of(0, 0, 0),
    };
    tp_world_refresh(world, scene);
}

/* Pitch is signed: held short of straight up and down. */
static tp_turn tilted(tp_turn pitch, int32_t tilt)
{
    int64_t sum = (int64_t)(int32_t)pitch + tilt;
    int64_t most = PITCH_MOST;
    return (tp_turn)(int32_t)(sum > most ? most : sum < -most ? -most : sum);
}

static tp_fx held(int64_t x)
{
    return (tp_fx)(x > EYE_MOST ? EYE_MOST : x < -EYE_MOST ? -EYE_MOST : x);
}

/* Rounded, so that a walk forth and back ends where it began. */
static void move_eye(tp_world *world, const tp_input *in)
{
    world->heading += (tp_turn)in->turn;
    world->pitch = tilted(world->pitch, in->tilt);

    const int64_t half = 1 << 29;
    int64_t s = tp_sin(world->heading), c = tp_cos(world->heading);
    world->eye.x = held(world->eye.x + ((in->ahead * s + in->aside * c + half) >> 30));
    world->eye.z = held(world->eye.z + ((in->aside * s - in->ahead * c + half) >> 30));
    world->eye.y = held((int64_t)world->eye.y + in->up);
}

void tp_world_step(tp_world *world, const tp_scene *scene, const tp_input *input)
{
    world->tick++;
    if (input)
        move_eye(world, input);
    tp_sea_phases(&world->sea, world->tick, world->phases);
    place_boat(world, scene);
}
