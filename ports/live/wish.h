/* SPDX-License-Identifier: MIT */
/* What a held key wishes for the next tick, in every port that has keys. */
#ifndef LIVE_WISH_H
#define LIVE_WISH_H
#include "tidepool/world.h"

/* Steps of a tick of 1/60 s: 4 m/s, or 16 m/s with Shift; 60 degrees a second. */
#define WISH_WALK TP_FX(4.0 / TP_TICKS_PER_SECOND)
#define WISH_RUN  TP_FX(16.0 / TP_TICKS_PER_SECOND)
#define WISH_TURN ((int32_t)TP_DEG(60.0 / TP_TICKS_PER_SECOND))

/* The light's: 45 degrees a second. */
#define WISH_LIGHT ((int32_t)TP_DEG(45.0 / TP_TICKS_PER_SECOND))

/* The sphere's and the boat's: 1.5 m/s, 4 m/s, 20 degrees a second. */
#define WISH_STEER  TP_FX(1.5 / TP_TICKS_PER_SECOND)
#define WISH_SAIL   TP_FX(4)
#define WISH_RUDDER TP_FX(20)

/* Of several between two ticks; pokes are not among them. */
void wish_add(tp_input *to, const tp_input *more);

/* Whether it moves the camera, which it does while the water stands too. */
bool wish_moves(const tp_input *input);
#endif
