/* SPDX-License-Identifier: MIT */
/* A tape played to a stage: inputs are handed out, looks and changes of parameters done
 * where they were done when it was recorded.
 *
 *     replay_acts                     before a picture: what was done between two
 *     for tp_world_advance_clock() ticks:
 *         replay_acts                 changes inside a picture, of tapes by hand
 *         tp_world_step(.., replay_step()) */
#ifndef HOST_REPLAY_H
#define HOST_REPLAY_H
#include "deck.h"
#include "stage.h"

typedef struct {
    deck      tape;
    uint64_t  tick;             /* steps so far */
    const deck_entry *step;     /* of this tick, taken from the tape already */
} replay;

/* What a changed world may need: all, or what goes without another world's block. */
typedef enum { REPLAY_ALL, REPLAY_SAME_WORLD } replay_room;

/* Reads options.tape, if there is one, and tries all its changes on another stage of the
 * scene: EXIT_INPUT, and said why with file and line, before anything has moved. */
int  replay_open(replay *r, const stage *s, const options *o, replay_room room);
int  replay_close(replay *r);

/* The looks and changes of this tick that have not been done yet.  *opened: see
 * stage_set. */
int  replay_acts(replay *r, stage *s, const options *o, bool *opened);

/* The input of this tick's step, or NULL; the next tick is the one after it. */
const tp_input *replay_step(replay *r);

/* For worlds that are kept: entries of the tape that the world has taken.  The stage's
 * world made anew in its block, at tick 0, of the scene as so many have changed it; false:
 * the tape has less.  Tape and scene brought there, when the stage's world is the one that
 * was kept: before the canvas is opened. */
uint32_t replay_played(const replay *r);
bool replay_remake(const replay *r, stage *s, uint32_t played);
void replay_skip(replay *r, stage *s, uint32_t played);
#endif
