/* SPDX-License-Identifier: MIT */
/* Command interface of a board: lines from a serial port or a debugger change the scene's
 * numbers at run time, by the names that `tidepool params` lists.
 *
 *     set wave0.amplitude 0.8     ok wave0.amplitude = 0.8 m
 *     set wave0.amplitude 99      error wave0.amplitude = 99 is outside 0..16 m
 *     get sky.kind                ok sky.kind = day of gradient|day|dusk|night|cube
 *     list wave0                  a line for each parameter, then: ok 7 parameters
 *     drop                        ok drop
 *     poke 1.5 -8                 ok poke; a height may follow, default
 *                                 pool.splash_height; a tick takes 8 pokes, more are
 *                                 refused until the next tick
 *     input light_turn=9 drops=1  ok input; fields as in world/text.h, for one tick
 *     pause, go, step 30          ok pause; step makes so many ticks, then pauses
 *     restart                     ok restart; from tick 0, with the present numbers
 *     state                       ok tick 37, then data of the port
 *
 * Bytes are passed in one by one, between frames only: drawing a frame reads the scene.
 * Every line that is not blank gets a reply line that begins with "ok" or "error"; before
 * it, an earlier name of a parameter is answered with a line "pool.feed is now called
 * pool.drive_amplitude", if control_setup.find knows it.  A line ends with CR, LF or both.
 * No function allocates memory or waits. */
#ifndef TP_SERIAL_CONTROL_H
#define TP_SERIAL_CONTROL_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/frame.h"

#define CONTROL_LINE 160        /* bytes of the longest line, without its end */

/* Filled in by the port.  The scene is the one of frame and world. */
typedef struct {
    const tp_scene  *shown;
    tp_scene        *scene;     /* the same in RAM; NULL: constant, `set` is refused */
    const tp_config *config;    /* config of the frame */
    tp_world        *world;
    size_t           world_bytes;               /* bytes of the world's block */
    void           (*write)(void *to, const char *text);    /* sends a piece of a reply */
    void           (*state)(void *to);      /* the port's part of `state`; NULL: none */
    void            *to;
    /* Returns the row of a present or an earlier name (old_name_param of
     * ports/interact); NULL: earlier names are refused, which saves their table. */
    const tp_param *(*find)(const char *name, size_t bytes);
} control_setup;

typedef struct {
    const control_setup *setup;
    bool     paused;            /* true: the water is paused */
    uint32_t steps;             /* ticks of `step` still to make */
    bool     changed;           /* true: a line changed the picture; the port resets it */
    tp_input input;             /* input of the next tick; see control_take */

    /* private part */
    uint32_t frame_bytes;       /* block size of the frame at init */
    uint32_t length;            /* bytes of the line; above CONTROL_LINE: too long */
    uint32_t odd;               /* 1 + the line's first byte that is not text, or 0 */
    char     line[CONTROL_LINE];
} control;

/* Initialises a control, after tp_frame_init and tp_world_init.  The setup must outlive
 * the control. */
void control_begin(control *c, const control_setup *setup);

/* True if the control accepts bytes.  False during a step: the port makes its ticks
 * first. */
bool control_reads(const control *c);

/* Passes a byte in.  Returns true if the byte ended a line; the line's command has been
 * executed and answered. */
bool control_byte(control *c, uint8_t byte);

/* True if the port should make the tick now due. */
bool control_ticks(control *c);

/* Returns the input of the next tick and clears it. */
tp_input control_take(control *c);
#endif
