/* SPDX-License-Identifier: MIT */
/* Input of a held key per tick, common to all ports with keys. */
#ifndef TP_INTERACT_INPUT_MERGE_H
#define TP_INTERACT_INPUT_MERGE_H
#include "tidepool/world.h"

/* Camera, per tick of 1/60 s: 4 m/s, 16 m/s with Shift, 60 degrees/s. */
#define INPUT_WALK TP_FX(4.0 / TP_TICKS_PER_SECOND)
#define INPUT_RUN  TP_FX(16.0 / TP_TICKS_PER_SECOND)
#define INPUT_TURN ((int32_t)TP_DEG(60.0 / TP_TICKS_PER_SECOND))

/* Light: 45 degrees/s. */
#define INPUT_LIGHT ((int32_t)TP_DEG(45.0 / TP_TICKS_PER_SECOND))

/* Sphere 1.5 m/s; boat's throttle 4 m/s; rudder 20 degrees/s. */
#define INPUT_STEER  TP_FX(1.5 / TP_TICKS_PER_SECOND)
#define INPUT_SAIL   TP_FX(4)
#define INPUT_RUDDER TP_FX(20)

/* Adds the input `more` to `to`, for several inputs between two ticks.  Pokes are not
 * added. */
void input_merge(tp_input *to, const tp_input *more);

/* True if the input moves the camera, possible while the water stands still too. */
bool input_moves_camera(const tp_input *input);
#endif
