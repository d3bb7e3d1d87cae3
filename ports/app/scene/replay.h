/* SPDX-License-Identifier: MIT */
/* Plays a tape to a loaded scene: returns the inputs, and applies looks and changes of
 * parameters at the same ticks as in the recording.
 *
 *     replay_acts                     before a picture: changes between two pictures
 *     for tp_world_advance_clock() ticks:
 *         replay_acts                 changes within a picture, in tapes written by hand
 *         tp_world_step(.., replay_step()) */
#ifndef TP_APP_SCENE_REPLAY_H
#define TP_APP_SCENE_REPLAY_H
#include "loaded_scene.h"
#include "tape_file.h"

typedef struct {
    tape_file      tape;
    uint64_t  tick;             /* number of steps until now */
    const tape_file_entry *step; /* entry of this tick's step, already taken from the
                                  * tape */
} replay;

/* Allowed changes of the world: all, or only changes that need no new block of memory. */
typedef enum { REPLAY_ALL, REPLAY_SAME_WORLD } replay_room;

/* Reads options.tape, if given, and tries all its changes on a second loaded scene.
 * Returns EXIT_INPUT, after a message with file and line, before anything has moved. */
int  replay_open(replay *r, const loaded_scene *s, const options *o, replay_room room);
int  replay_close(replay *r);

/* Applies the remaining looks and changes of this tick.  *opened: see loaded_scene_set. */
int  replay_acts(replay *r, loaded_scene *s, const options *o, bool *opened);

/* Returns the input of this tick's step, or NULL, and advances to the next tick. */
const tp_input *replay_step(replay *r);

/* For kept worlds.  replay_played returns the number of entries that the world has taken.
 * replay_remake makes the loaded scene's world anew in its block, at tick 0, from the scene
 * after `played` entries; false: the tape is shorter.  replay_skip brings tape and scene to
 * the state of a kept world; to call before the frame renderer is opened. */
uint32_t replay_played(const replay *r);
bool replay_remake(const replay *r, loaded_scene *s, uint32_t played);
void replay_skip(replay *r, loaded_scene *s, uint32_t played);
#endif
