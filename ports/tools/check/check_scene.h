/* SPDX-License-Identifier: MIT */
/* tidepool check SCENE: finds the faults of a scene's file. */
#ifndef TP_TOOLS_CHECK_CHECK_SCENE_H
#define TP_TOOLS_CHECK_CHECK_SCENE_H
#include "app/cli/args.h"

/* Checks every line, the files that the scene names, and the world.  o->write replaces the
 * old names of rows in the file, as a whole or not at all, if every line can be read.
 * Returns EXIT_CHECK if only old names remain, EXIT_INPUT for other faults, after messages;
 * EXIT_DONE after printing the number of values. */
int check_scene(const options *o);
#endif
