/* SPDX-License-Identifier: MIT */
/* A screen without a window system.  A port provides one screen_port; only its functions
 * access the device.  The loop (drawing_loop.c) draws, waits and reads keys; the
 * console (console.h) owns the virtual terminal.
 *
 * Two processes share an open screen.  The parent opens the screen, forks and waits; the
 * child draws.  After the child's end, of any kind, the parent closes the screen with
 * the state as open() left it: close() must not rely on anything done in the child. */
#ifndef TP_APP_FULLSCREEN_SCREEN_H
#define TP_APP_FULLSCREEN_SCREEN_H
#include <stdbool.h>
#include <stdint.h>
#include "app/files/picture.h"

typedef struct screen screen;   /* opaque; defined by each port */

/* fds, events, ready, format, away and back may be NULL if there is nothing to do. */
typedef struct {
    const char *name;           /* value of --on */
    const char *device;         /* default device */

    /* Opens a device. width, height: the wanted size, 0: the device's own; a port may
     * choose another size.  Returns EXIT_*; on failure it has printed the reason in one
     * line and left nothing open. */
    int  (*open)(screen **s, const char *device, uint32_t width, uint32_t height);

    /* The current size; may change (one monitor unplugged, another one plugged in). */
    void (*size)(const screen *s, uint32_t *width, uint32_t *height);

    /* fds: a descriptor to poll for the device's events (page flips, hotplug), -1: none.
     * events: handles them. */
    int  (*fds)(const screen *s);
    int  (*events)(screen *s);

    /* Shows a whole picture, xrgb8888 or another format, in exactly its colours.  A
     * picture smaller than the screen is centred. */
    int  (*show)(screen *s, const picture *p);
    bool (*ready)(const screen *s);     /* a picture may be shown now: no flip is pending */

    bool (*lacks)(const screen *s);     /* shows no picture yet, but could; NULL: never */

    /* The best picture format for the screen; NULL: xrgb8888. */
    tp_format (*format)(const screen *s);

    int  (*away)(screen *s);    /* another virtual terminal becomes active */
    int  (*back)(screen *s);    /* ours is active again; a new picture will be shown */
    void (*close)(screen *s);   /* restores the screen of open(), unless away */
} screen_port;

extern const screen_port screen_fb, screen_kms;
#endif
