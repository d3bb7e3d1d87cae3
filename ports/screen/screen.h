/* SPDX-License-Identifier: MIT */
/* A screen without a window system.  A port supplies one screen_port: its functions alone
 * touch the device.  The loop (loop.c) draws, waits and reads keys; the console
 * (console.h) owns the virtual terminal.
 *
 * Two processes share an open screen.  The parent opens it, forks, and does nothing but
 * wait; its child draws.  However the child has ended, the parent then closes the screen,
 * with the state as open() left it: close() may rely on nothing that the child did. */
#ifndef SCREEN_SCREEN_H
#define SCREEN_SCREEN_H
#include <stdbool.h>
#include <stdint.h>
#include "../host/picture.h"

typedef struct screen screen;   /* a port's own, opaque */

/* fds, events, ready, format, away and back may be NULL where there is nothing to do. */
typedef struct {
    const char *name;           /* what --on says */
    const char *device;         /* that is taken unless another one is named */

    /* Size wanted, 0: the device's own; a port may give another one.  EXIT_* and has said
     * why in one clear line; nothing is left open then. */
    int  (*open)(screen **s, const char *device, uint32_t width, uint32_t height);

    /* Of its picture now; may change (a monitor taken away, another one plugged in). */
    void (*size)(const screen *s, uint32_t *width, uint32_t *height);

    /* A descriptor to poll for the port's events (flips, plugs), -1: none; and what
     * handles them. */
    int  (*fds)(const screen *s);
    int  (*events)(screen *s);

    /* Presents a whole picture, xrgb8888 or another format, in exactly its colours.  One
     * that is smaller than the screen is centred. */
    int  (*show)(screen *s, const picture *p);
    bool (*ready)(const screen *s);     /* a picture may be shown now: no flip is pending */

    bool (*lacks)(const screen *s);     /* it shows none, and could; NULL: never */

    /* What its pixels take best; NULL: xrgb8888. */
    tp_format (*format)(const screen *s);

    int  (*away)(screen *s);    /* another virtual terminal takes over */
    int  (*back)(screen *s);    /* and gives back: the picture will be shown anew */
    void (*close)(screen *s);   /* the screen as it was found; when away, as it is now */
} screen_port;

extern const screen_port screen_fb, screen_kms;
#endif
