/* SPDX-License-Identifier: MIT */
/* Control on a board: lines from a serial port or a debugger change the scene's numbers
 * while it runs, by the names that `tidepool params` lists.
 *
 *     set wave0.amplitude 0.8     ok wave0.amplitude = 0.8 m
 *     set wave0.amplitude 99      error wave0.amplitude = 99 is outside 0..16 m
 *     get sky.kind                ok sky.kind = day of gradient|day|dusk|night|cube
 *     list wave0                  a line for each of them, then: ok 7 parameters
 *     drop                        ok drop
 *     poke 1.5 -8                 ok poke; a height may follow, or is pool.poke; a tick
 *                                 takes 8 of them, more are refused until it was made
 *     input light_turn=9 drops=1  ok input; what scene/tape.h lists, for one tick
 *     pause, go, step 30          ok pause; a step is so many ticks, then it pauses
 *     restart                     ok restart; from tick 0, with the numbers as they are
 *     state                       ok tick 37, and what the port adds
 *
 * Bytes are fed one by one as they come, between frames: a frame that is being drawn
 * reads the scene.  Every line that is not blank is answered by one that begins with "ok"
 * or "error"; a line ends with CR, LF or both.  There is no heap, and nothing waits. */
#ifndef BOARD_CONTROL_H
#define BOARD_CONTROL_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/frame.h"

#define CONTROL_LINE 160        /* bytes of the longest line, without its end */

/* What the port fills in; the scene is the one that frame and world were made with. */
typedef struct {
    const tp_scene  *shown;
    tp_scene        *scene;     /* the same in RAM; NULL: constant, `set` is refused */
    const tp_config *config;    /* of the frame */
    tp_world        *world;
    size_t           world_bytes;               /* of its block */
    void           (*write)(void *to, const char *text);    /* a piece of an answer */
    void           (*state)(void *to);      /* the rest of that answer; NULL: none */
    void            *to;
} control_setup;

typedef struct {
    const control_setup *setup;
    bool     paused;            /* the water stands */
    uint32_t steps;             /* ticks still to make though it does */
    bool     changed;           /* by a line, since the port took it back */
    tp_input input;             /* for the next tick; see control_take */

    /* private part */
    uint32_t frame_bytes;       /* that the frame had at init */
    uint32_t length;            /* of the line so far; more than fit: it is too long */
    uint32_t odd;               /* 1 + its first byte that is no text, or 0 */
    char     line[CONTROL_LINE];
} control;

/* After tp_frame_init and tp_world_init; the setup must outlive the control. */
void control_begin(control *c, const control_setup *setup);

/* False: the port makes the ticks of a step first, and then reads on. */
bool control_reads(const control *c);

/* True: the byte ended a line, which has been done and answered. */
bool control_byte(control *c, uint8_t byte);

/* Whether a tick that is due is to be made. */
bool control_ticks(control *c);

/* The input of the next tick, which then is empty. */
tp_input control_take(control *c);
#endif
