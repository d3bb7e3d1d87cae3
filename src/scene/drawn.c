/* SPDX-License-Identifier: MIT */
/* The state of the world between its last two ticks, and the camera on the boat's deck.
 * A deck camera keeps its place on the deck and heaves, turns, pitches and rolls with the
 * boat. */
#include "base/assert.h"
#include "scene/drawn.h"

/* Interpolates from b to a along the shorter arc. */
static tp_turn interpolate_turn(tp_turn a, tp_turn b, tp_fx back)
{
    return b + (tp_turn)((int64_t)(int32_t)(a - b) * back >> 16);
}

static tp_pose interpolate_pose(const tp_pose *a, const tp_pose *b, tp_fx back)
{
    return (tp_pose){
        tp_place_interpolate(a->place, b->place, back),
        interpolate_turn(a->heading, b->heading, back),
        interpolate_turn(a->pitch, b->pitch, back),
        interpolate_turn(a->roll, b->roll, back),
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

tp_camera tp_camera_interpolate(const tp_world *world, tp_fx back)
{
    TP_ASSERT(back >= 0 && back <= TP_FX_ONE);
    const tp_turn heading = interpolate_turn(world->last_heading, world->heading, back);
    const tp_turn pitch = interpolate_turn(world->last_pitch, world->pitch, back);
    const tp_turn roll = interpolate_turn(world->last_roll, world->roll, back);
    const tp_camera camera = { tp_place_interpolate(world->last_eye, world->eye, back),
                               tp_rotation_from_angles(heading, pitch, roll) };

    if (world->aboard != TP_ABOARD_DECK)
        return camera;
    const tp_pose boat = interpolate_pose(&world->last_boat, &world->boat, back);
    return deck_to_world_camera(&camera, &boat);
}

tp_camera tp_world_camera(const tp_world *world)
{
    return tp_camera_interpolate(world, world->back);
}

tp_drawn tp_world_interpolate(const tp_world *world)
{
    tp_fx    back = world->back;
    tp_drawn at = {
        .camera = tp_world_camera(world),
        .boat = interpolate_pose(&world->last_boat, &world->boat, back),
        .light_heading = interpolate_turn(world->last_light_heading, world->light_heading,
                                      back),
        .light_elevation = interpolate_turn(world->last_light_elevation,
                                        world->light_elevation, back),
        .exposure = tp_interpolate(world->last_exposure, world->exposure, back),
        .time = (int64_t)(world->tick * TP_FX_ONE) - back,
    };

    tp_sea_phases(&world->sea, world->tick, back, at.phases);
    return at;
}
