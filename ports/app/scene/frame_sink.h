/* SPDX-License-Identifier: MIT */
/* The destination of drawn pictures: none, one PNG each, an animated PNG, or a film.
 *
 * No file is written if only hashes, figures or a comparison are asked for.  Without any
 * option for output, pictures go to SCENE.png in the current folder or, several, to
 * SCENE.apng, with a message.  An existing file of that name is replaced only if tidepool
 * has written the file. */
#ifndef TP_APP_SCENE_FRAME_SINK_H
#define TP_APP_SCENE_FRAME_SINK_H
#include "app/cli/args.h"
#include "app/files/animation.h"
#include "app/files/film.h"

typedef struct {
    const options *options;
    const char *out;            /* pattern of names, or name of the film */
    char       *own;            /* name chosen by the program, no pattern; or NULL */
    enum { FRAME_SINK_NONE, FRAME_SINK_PNG, FRAME_SINK_ANIMATION, FRAME_SINK_FILM } kind;
    animation   animation;
    film        film;
} frame_sink;

/* Each function returns an exit code, and prints the reason of a failure.  The options must
 * outlive the sink.  The caller closes or discards the sink in every case. */
int  frame_sink_open(frame_sink *s, const options *o);
int  frame_sink_add(frame_sink *s, const picture *p, uint32_t frame);
int  frame_sink_close(frame_sink *s);
/* Removes an unfinished animation or film; PNGs already written stay. */
void frame_sink_discard(frame_sink *s);
#endif
