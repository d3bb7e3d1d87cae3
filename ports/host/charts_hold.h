/* SPDX-License-Identifier: MIT */
/* Holding signals while something has to be tidied up after; needs POSIX. */
#ifndef HOST_CHARTS_HOLD_H
#define HOST_CHARTS_HOLD_H
#include <signal.h>

typedef struct { sigset_t held, before; } chart_hold;

/* Signals that end a program wait from hold to release, where they do what they do. */
void charts_hold(chart_hold *h);
void charts_release(const chart_hold *h);
#endif
