/* SPDX-License-Identifier: MIT */
/* Films: YUV4MPEG2, which needs no library and which every player and encoder reads. */
#ifndef HOST_FILM_H
#define HOST_FILM_H
#include "output.h"
#include "picture.h"

typedef struct {
    output    out;
    uint32_t  width, height;
    uint32_t *pixels;           /* two rows, 0x00RRGGBB */
    uint8_t  *planes;           /* Y, then U and V of half the size each way */
    size_t    bytes;            /* of the planes */
} film;

/* Each picture is shown for `ticks` of 1/60 s. */
int  film_open(film *f, const char *name, uint32_t width, uint32_t height, uint32_t ticks);
/* The same, of one tick, into a pipe, which it closes in any case, film_close at the
 * latest. */
int  film_open_pipe(film *f, int to, const char *name, uint32_t width, uint32_t height);
int  film_add(film *f, const picture *p);       /* after a failure nothing is left */
int  film_close(film *f);
void film_discard(film *f);
#endif
