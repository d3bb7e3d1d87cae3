/* SPDX-License-Identifier: MIT */
/* Where drawn pictures go: nowhere, one PNG each, or a film. */
#ifndef HOST_SINK_H
#define HOST_SINK_H
#include "args.h"
#include "film.h"

typedef struct {
    const char *out;            /* the pattern of names, or the film's */
    enum { SINK_NONE, SINK_PNG, SINK_FILM } kind;
    film        film;
} sink;

/* Each returns an exit code and has said why. */
int  sink_open(sink *s, const options *o);
int  sink_add(sink *s, const picture *p, uint32_t frame);
int  sink_close(sink *s);
void sink_discard(sink *s);     /* an unfinished film; whole PNGs stay */
#endif
