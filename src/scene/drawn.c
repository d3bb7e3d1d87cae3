/* SPDX-License-Identifier: MIT */
/* The world between its last two ticks. */
#include "scene/drawn.h"

static tp_vec3 place_between(tp_vec3 a, tp_vec3 b, tp_fx back)
{
    return (tp_vec3){ tp_between(a.x, b.x, back), tp_between(a.y, b.y, back),
                      tp_between(a.z, b.z, back) };
}

/* The shorter way round. */
static tp_turn turn_between(tp_turn a, tp_turn b, tp_fx back)
{
    return b + (tp_turn)((int64_t)(int32_t)(a - b) * back >> 16);
}

tp_drawn tp_world_drawn(const tp_world *world)
{
    tp_fx    back = world->back;
    tp_drawn at = {
        .eye = place_between(world->last_eye, world->eye, back),
        .heading = turn_between(world->last_heading, world->heading, back),
        .pitch = turn_between(world->last_pitch, world->pitch, back),
        .boat = {
            place_between(world->last_boat.place, world->boat.place, back),
            turn_between(world->last_boat.heading, world->boat.heading, back),
            turn_between(world->last_boat.pitch, world->boat.pitch, back),
            turn_between(world->last_boat.roll, world->boat.roll, back),
        },
        .time = (int64_t)(world->tick * TP_FX_ONE) - back,
    };

    tp_sea_phases(&world->sea, world->tick, back, at.phases);
    return at;
}
