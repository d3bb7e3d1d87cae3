/* SPDX-License-Identifier: MIT */
/* Animated PNGs: films with exactly the displayed colours.  Browsers play them in an
 * endless loop; programs without support for animation show the first picture. */
#ifndef TP_APP_FILES_ANIMATION_H
#define TP_APP_FILES_ANIMATION_H
#include "output_file.h"
#include "picture.h"

typedef struct {
    output_file out;
    uint32_t  frames;           /* total number of frames to be added */
    uint32_t  ticks;            /* duration of each frame, in 1/60 s */
    uint32_t  added, sequence;  /* frames until now; number of the next chunk */
    uint8_t  *rows;             /* pixels of the previous picture */
    size_t    bytes;
} animation;

/* Each function returns an exit code; on failure it has printed the reason.  All pictures
 * have the same format and size.  frames: from 1; ticks: 1..65535. */
int  animation_open(animation *a, const char *name, uint32_t frames, uint32_t ticks);
int  animation_add(animation *a, const picture *p);
int  animation_close(animation *a);
void animation_discard(animation *a);
#endif
