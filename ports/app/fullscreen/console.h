/* SPDX-License-Identifier: MIT */
/* The virtual terminal under a screen, and the terminals that keys come from.
 *
 * console_open saves the current state and changes nothing. console_take changes the
 * state. console_restore restores the saved state, regardless of the process that
 * changed it; the parent of the drawing process may call it. */
#ifndef TP_APP_FULLSCREEN_CONSOLE_H
#define TP_APP_FULLSCREEN_CONSOLE_H
#include <linux/vt.h>
#include <poll.h>
#include <stdbool.h>
#include <termios.h>
#include "terminal_keys.h"

#define CONSOLE_KEYS 2

typedef struct {
    int            vt;          /* descriptor of the virtual terminal; -1: none */
    int            number;      /* its number; 0: unknown, treated as active */
    int            mode;        /* saved: KD_TEXT */
    struct vt_mode switching;
    struct {                    /* terminals that keys come from */
        int            fd;      /* its descriptor; -1: unused or hung up */
        struct termios was;     /* settings before console_take */
    } keys[CONSOLE_KEYS];
} console;

/* Returns EXIT_DISPLAY if another program draws on the terminal; the reason has been
 * said and nothing is left open. */
int  console_open(console *c);
int  console_take(console *c);
void console_restore(console *c);
void console_close(console *c);

/* console_fds writes the descriptors to poll and returns their number. console_read
 * reads them and passes the bytes to `k`. */
int  console_fds(const console *c, struct pollfd fds[CONSOLE_KEYS]);
void console_read(console *c, const struct pollfd *fds, int count, terminal_keys *k);

/* console_front: true if our terminal is active. console_give answers CONSOLE_AWAY after
 * the screen is released; console_taken_back answers CONSOLE_BACK before the screen is
 * drawn again. */
bool console_front(const console *c);
void console_give(console *c);
void console_taken_back(console *c);

#define CONSOLE_AWAY SIGUSR1
#define CONSOLE_BACK SIGUSR2
#endif
