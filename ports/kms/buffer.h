/* SPDX-License-Identifier: MIT */
/* The kernel's DRM calls, and dumb buffers: memory shown by a CRTC without conversion. */
#ifndef TP_KMS_BUFFER_H
#define TP_KMS_BUFFER_H
#include <stdbool.h>
#include <stdint.h>
#include "app/files/picture.h"
#include "mode_select.h"

typedef struct {
    uint32_t handle, fb, pitch;         /* 0: none */
    uint32_t width, height, bits;       /* bits per pixel: 32 (xrgb8888) or 16 (rgb565) */
    uint64_t bytes;
    uint8_t *map;
    uint32_t drawn_width, drawn_height; /* size of its picture, px */
} kms_buffer;

/* ioctl, repeated if interrupted by a signal.  Returns false on failure, with errno. */
bool kms_ask(int card, unsigned long request, void *what);

/* Makes a black buffer.  Returns false with errno; nothing is then left allocated. */
bool kms_buffer_make(int card, kms_buffer *b, uint32_t width, uint32_t height,
                     uint32_t bits);
void kms_buffer_free(int card, kms_buffer *b);

/* Draws a picture into the middle of the buffer; a larger picture is cropped around its
 * middle. */
void kms_buffer_draw(kms_buffer *b, const picture *p);
#endif
