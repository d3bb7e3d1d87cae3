/* SPDX-License-Identifier: MIT */
/* Where drawn pictures go: nowhere, one PNG each, an animated one, or a film.
 *
 * No file is written when hashes, figures or a comparison alone were asked for.  Without
 * any of them the pictures go into the current folder, to SCENE.png or, if there are
 * several, to SCENE.apng, and a message says so; a file of that name that tidepool has not
 * written is not replaced. */
#ifndef HOST_SINK_H
#define HOST_SINK_H
#include "animation.h"
#include "args.h"
#include "film.h"

typedef struct {
    const options *options;
    const char *out;            /* the pattern of names, or the film's */
    char       *own;            /* the name of our choice, which is no pattern; or NULL */
    enum { SINK_NONE, SINK_PNG, SINK_ANIMATION, SINK_FILM } kind;
    animation   animation;
    film        film;
} sink;

/* Each returns an exit code and has said why.  The options must outlive the sink; it is
 * closed or discarded in any case. */
int  sink_open(sink *s, const options *o);
int  sink_add(sink *s, const picture *p, uint32_t frame);
int  sink_close(sink *s);
void sink_discard(sink *s);     /* what is unfinished; whole PNGs stay */
#endif
