/* SPDX-License-Identifier: MIT */
/* The kernel's calls, and its dumb buffers: memory that a CRTC shows as it is. */
#ifndef KMS_BUFFER_H
#define KMS_BUFFER_H
#include <stdbool.h>
#include <stdint.h>
#include "../host/picture.h"
#include "choose.h"

typedef struct {
    uint32_t handle, fb, pitch;         /* 0: there is none */
    uint32_t width, height, bits;       /* a pixel: 32 (xrgb8888) or 16 (rgb565) */
    uint64_t bytes;
    uint8_t *map;
    uint32_t drawn_width, drawn_height; /* of the picture in it */
} kms_buffer;

/* An ioctl, begun anew where a signal broke it off.  False: see errno. */
bool kms_ask(int card, unsigned long request, void *what);

/* Black.  False, with errno, and nothing is left of it. */
bool kms_buffer_make(int card, kms_buffer *b, uint32_t width, uint32_t height,
                     uint32_t bits);
void kms_buffer_free(int card, kms_buffer *b);

/* A picture in its middle: of a larger one the middle. */
void kms_buffer_draw(kms_buffer *b, const picture *p);
#endif
