/* SPDX-License-Identifier: MIT */
/* Adds up several inputs for one tick: motions are summed, lever positions take the last
 * value. */
#include "input_merge.h"

void input_merge(tp_input *to, const tp_input *more)
{
    to->forward += more->forward;
    to->strafe += more->strafe;
    to->up += more->up;
    to->turn += more->turn;
    to->tilt += more->tilt;
    to->sphere_x += more->sphere_x;
    to->sphere_z += more->sphere_z;
    to->throttle = more->throttle;
    to->rudder = more->rudder;
    to->drops += more->drops;
    to->slowdown += more->slowdown;
    to->light_turn += more->light_turn;
    to->light_tilt += more->light_tilt;
}

bool input_moves_camera(const tp_input *input)
{
    return input->forward || input->strafe || input->up || input->turn || input->tilt;
}
