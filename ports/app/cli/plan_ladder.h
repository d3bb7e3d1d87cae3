/* SPDX-License-Identifier: MIT */
/* tidepool plan --ladder and --board. */
#ifndef TP_APP_CLI_PLAN_LADDER_H
#define TP_APP_CLI_PLAN_LADDER_H
#include "app/scene/loaded_scene.h"

/* Print the steps of a loaded scene, or the step for o->board.  Return an exit code. */
int plan_ladder_print(const loaded_scene *s, const options *o);
int plan_board_print(const loaded_scene *s, const options *o);
#endif
