/* SPDX-License-Identifier: MIT */
/* Films in YUV4MPEG2, a format that needs no library and is read by players and
 * encoders. */
#ifndef TP_APP_FILES_FILM_H
#define TP_APP_FILES_FILM_H
#include "output_file.h"
#include "picture.h"

typedef struct {
    output_file out;
    uint32_t  width, height;
    uint32_t *pixels;           /* two rows, 0x00RRGGBB */
    uint8_t  *planes;           /* Y, then U and V of half the width and height */
    size_t    bytes;            /* size of the planes */
} film;

/* Opens a film; each picture is shown for `ticks` of 1/60 s. */
int  film_open(film *f, const char *name, uint32_t width, uint32_t height, uint32_t ticks);
/* The same with one tick per picture, into a pipe.  The pipe is closed in every case: at
 * once after a failure, else by film_close. */
int  film_open_pipe(film *f, int to, const char *name, uint32_t width, uint32_t height);
int  film_add(film *f, const picture *p);       /* after a failure the film is discarded */
int  film_close(film *f);
void film_discard(film *f);
#endif
