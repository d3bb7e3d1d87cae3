/* SPDX-License-Identifier: MIT */
/* Draws a whole picture with the reference; threads share the rows. */
#ifndef TP_TOOLS_REFERENCE_IMAGE_H
#define TP_TOOLS_REFERENCE_IMAGE_H
#include <stdatomic.h>
#include "trace.h"

enum { REF_SAMPLES = 16 };      /* samples a pixel of reference pictures */

typedef struct {
    uint32_t    width, height;
    ref_colour *colour;         /* mean of the samples of each pixel */
    uint8_t    *kind;           /* ref_kind of each pixel's last sample */
    uint8_t    *in_mirror;      /* object mirrored at the last sample, ref_kind */
    double     *near;           /* 1 / depth of the last sample, 1/m; 0: no depth */
} ref_image;

/* Draws a picture. `samples` a pixel: a square number, in a fixed pattern that is
 * stratified in both axes; 1 is the pixel's centre. Reports the progress on a terminal. */
void ref_image_draw(ref_image *image, const ref_scene *s, uint32_t width, uint32_t height,
                    uint32_t samples, uint32_t threads);

/* Progress and stop request of a picture that is drawn in the background; another thread
 * may read and set both. */
typedef struct {
    atomic_uint rows;           /* rows done */
    atomic_bool stop;           /* stop request; takes effect after the current pixels */
} ref_pace;

/* Draws like ref_image_draw but prints nothing. Returns false if the drawing was stopped or
 * memory is lacking; then there is nothing to free. */
bool ref_image_draw_size(ref_image *image, const ref_scene *s, uint32_t width,
                         uint32_t height, uint32_t samples, uint32_t threads,
                         ref_pace *pace);
void ref_image_free(ref_image *image);

/* Colour of a pixel, rounded, 0x00RRGGBB. */
uint32_t ref_image_pixel(const ref_image *image, uint32_t x, uint32_t y);
#endif
