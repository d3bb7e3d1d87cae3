/* SPDX-License-Identifier: MIT */
/* Showing a scene on a raw screen: the part common to `tidepool show` and a baked scene. */
#ifndef TP_APP_FULLSCREEN_FULLSCREEN_H
#define TP_APP_FULLSCREEN_FULLSCREEN_H
#include <signal.h>
#include "app/files/snapshot.h"
#include "console.h"
#include "screen.h"

typedef struct {
    const screen_port *port;
    const char *device;             /* NULL: the port's default */
    uint32_t    width, height;      /* 0: the screen's */
    bool        counted;            /* draw and show frames first..last only */
    uint32_t    first, last;
    bool        hold;               /* hold the last frame until a signal or Esc */
    bool        hash;               /* print each frame's CRC-32 to standard output */
    const char *keep;               /* file; NULL: none */

    const tp_scene  *scene;
    const tp_assets *assets;
    tp_world        *world;         /* at tick 0 */
    size_t           world_bytes;

    /* Drawing callbacks, called in the drawing process.  `format`: the screen's
     * preferred format. prepare is called again after a change of size; it returns
     * EXIT_* and has printed the reason of a failure. */
    void  *user;
    int  (*prepare)(void *user, uint32_t width, uint32_t height, tp_format format);
    const picture *(*draw)(void *user, const tp_world *world, uint32_t frame);

    /* Tape callbacks; NULL: no tape. acts: called before each frame and before each
     * tick, applies the tape's entries other than inputs. taped: returns the input of
     * each tick. */
    int  (*acts)(void *user);
    const tp_input *(*taped)(void *user);

    /* Tape callbacks for kept worlds: the number of entries played so far;
     * snapshot_store.remake. */
    uint32_t (*played)(void *user);
    bool (*remake)(void *user, uint32_t played);
} show;

/* Returns the port of that name, NULL if there is none.  SHOW_PORTS lists all names. */
const screen_port *show_port(const char *name);
#define SHOW_PORTS "fb or kms"

/* Shows until the end, then restores the screen as found.  Returns EXIT_*, with the
 * reason of a failure printed.  If a signal ended the child, the same signal is raised
 * here and ends the program. */
int show_run(const show *what);

/* -- interface between supervisor.c and drawing_loop.c ------------------------------- */

/* Runs in the child. *signal: the signal that ended the loop, or 0. */
int loop_run(const show *what, screen *on, console *tty, const snapshot_store *kept,
             uint32_t frame, int *signal);

/* The signals used by the loop: they end it or announce a console switch.  Blocked
 * except while it waits. */
void loop_signals(sigset_t *set);
#endif
