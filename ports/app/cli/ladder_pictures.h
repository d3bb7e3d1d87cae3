/* SPDX-License-Identifier: MIT */
/* The errors of a ladder's steps, measured on the pictures of ticks 60 and 300. */
#ifndef TP_APP_CLI_LADDER_PICTURES_H
#define TP_APP_CLI_LADDER_PICTURES_H
#include "app/scene/set_ladder.h"

/* Draws the pictures of `count` steps, and sets their errors against the exact picture, and
 * RAM; `reference`: the total error too, which takes seconds.  Shows its progress.  Returns
 * an exit code. */
int ladder_pictures_measure(ladder_step *step, uint32_t count, const options *o,
                            bool reference);
#endif
