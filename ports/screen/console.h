/* SPDX-License-Identifier: MIT */
/* The virtual terminal under a screen, and the terminals that keys come from.
 *
 * console_open only looks and keeps what it finds; console_take changes it;
 * console_restore brings all of it back from what was kept, whoever changed it: in the
 * parent of the process that took it, too. */
#ifndef SCREEN_CONSOLE_H
#define SCREEN_CONSOLE_H
#include <poll.h>
#include <stdbool.h>
#include <termios.h>
#include <linux/vt.h>
#include "keys.h"

#define CONSOLE_KEYS 2

typedef struct {
    int            vt;          /* the virtual terminal, -1: there is none */
    int            number;      /* of it, 0: the one in front, whichever it is */
    int            mode;        /* KD_TEXT */
    struct vt_mode switching;
    struct {
        int            fd;      /* -1: nothing, or no more */
        struct termios was;
    } keys[CONSOLE_KEYS];
} console;

/* EXIT_DISPLAY, said why and nothing open: another program draws on the terminal. */
int  console_open(console *c);
int  console_take(console *c);
void console_restore(console *c);
void console_close(console *c);

/* Descriptors to poll into `fds`, how many; and what came on them into `k`. */
int  console_fds(const console *c, struct pollfd fds[CONSOLE_KEYS]);
void console_read(console *c, const struct pollfd *fds, int count, keys *k);

/* Whether our terminal is in front; and what the kernel asks by signals to do about it,
 * after the screen has gone away or before it comes back. */
bool console_front(const console *c);
void console_give(console *c);
void console_taken_back(console *c);

#define CONSOLE_AWAY SIGUSR1
#define CONSOLE_BACK SIGUSR2
#endif
