/* SPDX-License-Identifier: MIT */
/* Showing a scene on a raw screen: what the program and a baked scene have in common. */
#ifndef SCREEN_SHOW_H
#define SCREEN_SHOW_H
#include <signal.h>
#include "console.h"
#include "keep.h"
#include "screen.h"

typedef struct {
    const screen_port *port;
    const char *device;             /* NULL: the port's own */
    uint32_t    width, height;      /* 0: the screen's */
    bool        counted;            /* frames first..last alone, each of them shown */
    uint32_t    first, last;
    bool        hold;               /* the last one until a signal or Esc */
    bool        hash;               /* each one's CRC-32 on standard output */
    const char *keep;               /* file; NULL: none */

    const tp_scene  *scene;
    const tp_assets *assets;
    tp_world        *world;         /* at tick 0 */
    size_t           world_bytes;

    /* The drawing's own; called in the process that draws.  `format` is the screen's
     * wish.  prepare returns EXIT_* and has said why, also after the size has changed. */
    void  *user;
    int  (*prepare)(void *user, uint32_t width, uint32_t height, tp_format format);
    const picture *(*draw)(void *user, const tp_world *world, uint32_t frame);

    /* NULL: there is no tape.  Of it, before a picture and before each of its steps, what
     * else was done than what its input tells; then each step's input. */
    int  (*acts)(void *user);
    const tp_input *(*taped)(void *user);

    /* Of the tape, for worlds that are kept: entries played so far, and keep.remake. */
    uint32_t (*played)(void *user);
    bool (*remake)(void *user, uint32_t played);
} show;

/* The port that is called so, NULL: none; and all names, as "fb or kms". */
const screen_port *show_port(const char *name);
#define SHOW_PORTS "fb or kms"

/* Returns when it is over and the screen is as it was found.  EXIT_* and said why; if a
 * signal ended it, it is raised again and nothing returns. */
int show_run(const show *what);

/* -- between watch.c and loop.c -------------------------------------------------- */

/* In the child.  *signal: what ended it, 0 if nothing did. */
int loop_run(const show *what, screen *on, console *tty, const keep *kept, uint32_t frame,
             int *signal);

/* Signals that end the loop or tell it of the console; blocked unless it waits. */
void loop_signals(sigset_t *set);
#endif
