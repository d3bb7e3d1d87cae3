/* SPDX-License-Identifier: MIT */
/* Blocks signals while temporary files exist; needs POSIX. */
#ifndef TP_TOOLS_CHARTS_CHARTS_HOLD_H
#define TP_TOOLS_CHARTS_CHARTS_HOLD_H
#include <signal.h>

typedef struct { sigset_t held, before; } chart_hold;

/* Signals that end a program wait from charts_hold to charts_release, and then take
 * effect. */
void charts_hold(chart_hold *h);
void charts_release(const chart_hold *h);
#endif
