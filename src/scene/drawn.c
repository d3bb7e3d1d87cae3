/* SPDX-License-Identifier: MIT */
/* The state of the world between its last two ticks, and the camera on the boat's deck.
 * A deck camera keeps its place on the deck and heaves, turns, pitches and rolls with the
 * boat. */
#include "base/assert.h"
#include "scene/drawn.h"

/* Interpolates from b to a along the shorter arc. */
static tp_turn interpolate_turn(tp_turn a, tp_turn b, tp_fx lag)
{
    return b + (tp_turn)((int64_t)(int32_t)(a - b) * lag >> 16);
}

static tp_pose interpolate_pose(const tp_pose *a, const tp_pose *b, tp_fx lag)
{
    return (tp_pose){
        tp_place_interpolate(a->place, b->place, lag),
        interpolate_turn(a->heading, b->heading, lag),
        interpolate_turn(a->pitch, b->pitch, lag),
        interpolate_turn(a->roll, b->roll, lag),
    };
}

/* Transforms a camera from deck axes, the axes of the mesh, to world axes.  The camera is
 * at most 14 km from the boat; its position is clamped to 8000 m, the limit of any
 * camera. */
static tp_camera deck_to_world_camera(const tp_camera *deck, const tp_pose *boat)
{
    const tp_rotation turn =
        tp_rotation_from_angles(boat->heading, boat->pitch, boat->roll);
    const tp_vec3 offset = tp_rotate_back(&turn, deck->eye);
    const tp_fx most = 8000 * TP_FX_ONE;

    return (tp_camera){
        { (tp_fx)tp_clamp_abs((int64_t)boat->place.x + offset.x, most),
          (tp_fx)tp_clamp_abs((int64_t)boat->place.y + offset.y, most),
          (tp_fx)tp_clamp_abs((int64_t)boat->place.z + offset.z, most) },
        tp_rotation_mul(&deck->turn, &turn),
    };
}

tp_camera tp_camera_interpolate(const tp_world *world, tp_fx lag)
{
    TP_ASSERT(lag >= 0 && lag <= TP_FX_ONE);
    const tp_turn heading = interpolate_turn(world->last_heading, world->heading, lag);
    const tp_turn pitch = interpolate_turn(world->last_pitch, world->pitch, lag);
    const tp_turn roll = interpolate_turn(world->last_roll, world->roll, lag);
    const tp_camera camera = { tp_place_interpolate(world->last_eye, world->eye, lag),
                               tp_rotation_from_angles(heading, pitch, roll) };

    if (world->aboard != TP_ABOARD_DECK)
        return camera;
    const tp_pose boat = interpolate_pose(&world->last_boat, &world->boat, lag);
    return deck_to_world_camera(&camera, &boat);
}

tp_camera tp_world_camera(const tp_world *world)
{
    return tp_camera_interpolate(world, world->lag);
}

tp_drawn tp_world_interpolate(const tp_world *world)
{
    tp_fx    lag = world->lag;
    tp_drawn at = {
        .camera = tp_world_camera(world),
        .boat = interpolate_pose(&world->last_boat, &world->boat, lag),
        .light_heading = interpolate_turn(world->last_light_heading, world->light_heading,
                                      lag),
        .light_elevation = interpolate_turn(world->last_light_elevation,
                                        world->light_elevation, lag),
        .exposure = tp_interpolate(world->last_exposure, world->exposure, lag),
        .time = (int64_t)(world->tick * TP_FX_ONE) - lag,
    };

    tp_deep_water_phases(&world->deep, world->tick, lag, at.phases);
    return at;
}
