/* SPDX-License-Identifier: MIT */
/* Animated PNGs: films of exactly the shown colours, which browsers play for ever and
 * which programs that know nothing of animations show the first picture of. */
#ifndef HOST_ANIMATION_H
#define HOST_ANIMATION_H
#include "output.h"
#include "picture.h"

typedef struct {
    output    out;
    uint32_t  frames;           /* that will be added in all */
    uint32_t  ticks;            /* of 1/60 s that each is shown */
    uint32_t  added, sequence;  /* frames; numbered chunks */
    uint8_t  *rows;             /* of the last picture */
    size_t    bytes;
} animation;

/* Each returns an exit code and has said why.  The pictures are of one format and size,
 * `frames` of them from 1, `ticks` from 1 to 65535. */
int  animation_open(animation *a, const char *name, uint32_t frames, uint32_t ticks);
int  animation_add(animation *a, const picture *p);
int  animation_close(animation *a);
void animation_discard(animation *a);
#endif
