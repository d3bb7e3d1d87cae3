/* SPDX-License-Identifier: MIT */
/* A whole picture by the reference, rows shared out among threads. */
#ifndef TP_REFERENCE_IMAGE_H
#define TP_REFERENCE_IMAGE_H
#include <stdatomic.h>
#include "trace.h"

enum { REF_SAMPLES = 16 };      /* a pixel, of pictures that others are judged by */

typedef struct {
    uint32_t    width, height;
    ref_colour *colour;         /* of each pixel, the mean of its samples */
    uint8_t    *kind;           /* of its last sample: ref_kind, */
    uint8_t    *in_mirror;      /* that of an object in the water's mirror, */
    double     *near;           /* and 1 / m of depth, 0 where there is none */
} ref_image;

/* `samples` a pixel: a square number, in a fixed pattern that is stratified in both
 * ways; 1 is the pixel's centre.  Tells of its progress on a terminal. */
void ref_image_draw(ref_image *image, const ref_scene *s, uint32_t width, uint32_t height,
                    uint32_t samples, uint32_t threads);

/* How far a picture is that is drawn beside something else, and whether it is still
 * wanted: both may be looked at and set by another thread. */
typedef struct {
    atomic_uint rows;           /* done */
    atomic_bool stop;           /* after the pixels that are being drawn */
} ref_pace;

/* The same without a word on the terminal.  False: it was stopped, or there is no memory;
 * then nothing is to be freed. */
bool ref_image_draw_at(ref_image *image, const ref_scene *s, uint32_t width,
                       uint32_t height, uint32_t samples, uint32_t threads,
                       ref_pace *pace);
void ref_image_free(ref_image *image);

/* A pixel rounded, 0x00RRGGBB. */
uint32_t ref_image_pixel(const ref_image *image, uint32_t x, uint32_t y);
#endif
