/* SPDX-License-Identifier: MIT */
/* State copied from an old world to a new world: everything in the world's head; the
 * parts behind the head are the reason for the new world.  Sea, sun and boat continue
 * without a jump, pools are still. */
#include "features/exposure/exposure.h"
#include "setting.h"
#include "world/world.h"

static void carry_camera(tp_world *to, const tp_world *from)
{
    to->eye = from->eye;
    to->last_eye = from->last_eye;
    to->heading = from->heading;
    to->pitch = from->pitch;
    to->roll = from->roll;
    to->last_heading = from->last_heading;
    to->last_pitch = from->last_pitch;
    to->last_roll = from->last_roll;
    to->aboard = from->aboard;
}

static void carry_light(tp_world *to, const tp_world *from)
{
    to->light_heading = from->light_heading;
    to->light_elevation = from->light_elevation;
    to->last_light_heading = from->last_light_heading;
    to->last_light_elevation = from->last_light_elevation;
}

/* Copies tick and clock, and sets the phases of the waves for the tick. */
static void carry_time(tp_world *to, const tp_world *from)
{
    const tp_fx scale = to->clock_scale;

    to->tick = from->tick;
    to->lag = from->lag;
    to->clock = from->clock;
    if (scale != from->clock_scale)
        tp_clock_set_target(&to->clock, scale);
    tp_deep_water_phases(&to->deep, to->tick, 0, to->phases);
}

static void carry_boat(tp_world *to, const tp_world *from)
{
    to->boat = from->boat;
    to->last_boat = from->last_boat;
    to->boat_state = from->boat_state;
}

void setting_carry(tp_world *to, const tp_world *from)
{
    if ((to->aboard == TP_ABOARD_NOT) == (from->aboard == TP_ABOARD_NOT))
        carry_camera(to, from);
    if (to->scene_light[0] == from->scene_light[0]
        && to->scene_light[1] == from->scene_light[1])
        carry_light(to, from);
    if (tp_world_is_metered(to) && tp_world_is_metered(from)) {
        to->exposure = from->exposure;
        to->last_exposure = from->last_exposure;
    }
    carry_time(to, from);
    if (to->boat_state.placed && from->boat_state.placed)
        carry_boat(to, from);
}
