/* SPDX-License-Identifier: MIT */
/* Creates a dumb buffer, registers it as a framebuffer for CRTCs, and maps it. */
#define _POSIX_C_SOURCE 200809L
#define _FILE_OFFSET_BITS 64            /* map offsets exceed 4 GB */
#include "buffer.h"
#include <errno.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>

#define SIDE 4096                       /* largest side of a picture, px */

bool kms_ask(int card, unsigned long request, void *what)
{
    int r;
    do
        r = ioctl(card, request, what);
    while (r == -1 && (errno == EINTR || errno == EAGAIN));
    return r != -1;
}

void kms_buffer_free(int card, kms_buffer *b)
{
    struct drm_mode_destroy_dumb dumb = { .handle = b->handle };
    if (b->map)
        munmap(b->map, b->bytes);
    if (b->fb)
        kms_ask(card, DRM_IOCTL_MODE_RMFB, &b->fb);
    if (b->handle)
        kms_ask(card, DRM_IOCTL_MODE_DESTROY_DUMB, &dumb);
    *b = (kms_buffer){ 0 };
}

static bool name_and_map(int card, kms_buffer *b)
{
    struct drm_mode_fb_cmd fb = { .width = b->width, .height = b->height,
                                  .pitch = b->pitch, .bpp = b->bits,
                                  .depth = b->bits == 32 ? 24 : 16, .handle = b->handle };
    struct drm_mode_map_dumb map = { .handle = b->handle };
    if (!kms_ask(card, DRM_IOCTL_MODE_ADDFB, &fb))
        return false;
    b->fb = fb.fb_id;
    if (!kms_ask(card, DRM_IOCTL_MODE_MAP_DUMB, &map))
        return false;
    void *at = mmap(NULL, b->bytes, PROT_READ | PROT_WRITE, MAP_SHARED, card,
                    (off_t)map.offset);
    if (at == MAP_FAILED)
        return false;
    b->map = at;
    return true;
}

bool kms_buffer_make(int card, kms_buffer *b, uint32_t width, uint32_t height,
                     uint32_t bits)
{
    struct drm_mode_create_dumb dumb = { .width = width, .height = height, .bpp = bits };
    if (!kms_ask(card, DRM_IOCTL_MODE_CREATE_DUMB, &dumb))
        return false;
    *b = (kms_buffer){ .handle = dumb.handle, .pitch = dumb.pitch, .width = width,
                       .height = height, .bits = bits, .bytes = dumb.size };
    if (!name_and_map(card, b)) {
        int error = errno;
        kms_buffer_free(card, b);
        errno = error;
        return false;
    }
    memset(b->map, 0, b->bytes);
    return true;
}

static void put_565(uint16_t *to, const uint32_t *from, uint32_t count)
{
    for (uint32_t x = 0; x < count; x++)
        to[x] = (uint16_t)((from[x] >> 8 & 0xf800) | (from[x] >> 5 & 0x07e0)
                           | (from[x] >> 3 & 0x001f));
}

/* Converts row by row in ordinary memory: a card's memory is slow to write in pieces and
 * slower to read. */
void kms_buffer_draw(kms_buffer *b, const picture *p)
{
    uint32_t line[SIDE];
    uint32_t across = p->width < b->width ? p->width : b->width;
    uint32_t down = p->height < b->height ? p->height : b->height;
    const uint32_t *from = line + (p->width - across) / 2;
    if (b->drawn_width != p->width || b->drawn_height != p->height)
        memset(b->map, 0, b->bytes);
    b->drawn_width = p->width;
    b->drawn_height = p->height;
    for (uint32_t y = 0; y < down; y++) {
        uint8_t *row = b->map + (size_t)(y + (b->height - down) / 2) * b->pitch
                     + (size_t)((b->width - across) / 2) * (b->bits / 8);
        picture_expand_row(p, y + (p->height - down) / 2, line);
        if (b->bits == 32)
            memcpy(row, from, across * sizeof *line);
        else
            put_565((uint16_t *)(void *)row, from, across);
    }
}
