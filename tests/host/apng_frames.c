/* SPDX-License-Identifier: MIT */
/* apng_frames FILE.apng: decodes an animated PNG and prints each frame's CRC-32 (as
 * `tidepool render --hash` does), its duration in seconds and its rows.  Prints each
 * violated rule of the format; the exit code is then 1.
 *
 * Converts each frame to a PNG of its own, read by libpng; no code of the writer is
 * used. */
#include <inttypes.h>
#include <png.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>
#include "app/files/picture.h"

#define HEAD_BYTES 4096         /* chunks before the pixels: palette and others */

typedef struct { char type[5]; uint32_t bytes; const uint8_t *data; } apng_chunk;

typedef struct {
    const uint8_t *at, *end;
    uint32_t width, height, frames, shown, sequence;
    uint8_t  head[HEAD_BYTES];  /* signature, IHDR, PLTE and the like */
    size_t   head_bytes;
    uint8_t *png;               /* the frame as a PNG: head, then pixels */
    size_t   png_bytes;
    uint32_t w, h, x, y;        /* rectangle of the frame; w 0: no open frame */
    double   seconds;
    uint32_t *canvas;
} apng_film;

static void broken(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vprintf(format, list);
    va_end(list);
    putchar('\n');
    exit(1);
}

static void *claim(void *old, size_t bytes)
{
    void *memory = realloc(old, bytes);
    if (!memory)
        broken("no memory");
    return memory;
}

/* -- chunks -------------------------------------------------------------------------- */

static bool next_chunk(apng_film *f, apng_chunk *c)
{
    if (f->at == f->end)
        return false;
    if (f->end - f->at < 12)
        broken("ends within a chunk");
    c->bytes = png_get_uint_32(f->at);
    memcpy(c->type, f->at + 4, 4);
    c->type[4] = '\0';
    c->data = f->at + 8;
    if ((size_t)(f->end - f->at) < 12 + (size_t)c->bytes)
        broken("ends within a chunk %s of %" PRIu32 " bytes", c->type, c->bytes);
    const uLong crc = crc32(crc32(0, NULL, 0), f->at + 4, 4 + c->bytes);
    if (crc != png_get_uint_32(c->data + c->bytes))
        broken("%s has a wrong CRC", c->type);
    f->at += 12 + (size_t)c->bytes;
    return true;
}

static void add_chunk(uint8_t **to, size_t *bytes, const char *type, const uint8_t *data,
                      uint32_t length)
{
    *to = claim(*to, *bytes + 12 + length);
    uint8_t *at = *to + *bytes;
    png_save_uint_32(at, length);
    memcpy(at + 4, type, 4);
    if (length)
        memcpy(at + 8, data, length);
    png_save_uint_32(at + 8 + length,
                     (png_uint_32)crc32(crc32(0, NULL, 0), at + 4, 4 + length));
    *bytes += 12 + (size_t)length;
}

static void expect_number(apng_film *f, const uint8_t *data)
{
    const uint32_t number = png_get_uint_32(data);
    if (number != f->sequence)
        broken("chunk %" PRIu32 " where %" PRIu32 " is due", number, f->sequence);
    f->sequence++;
}

/* -- frames -------------------------------------------------------------------------- */

static void show(apng_film *f)
{
    png_image image = { .version = PNG_IMAGE_VERSION };
    add_chunk(&f->png, &f->png_bytes, "IEND", NULL, 0);
    if (!png_image_begin_read_from_memory(&image, f->png, f->png_bytes)
        || image.width != f->w || image.height != f->h)
        broken("frame %" PRIu32 " cannot be read: %s", f->shown, image.message);
    image.format = PNG_FORMAT_BGRA;     /* 0xAARRGGBB on a little-endian machine */
    uint32_t *pixels = claim(NULL, PNG_IMAGE_SIZE(image));
    if (!png_image_finish_read(&image, NULL, pixels, 0, NULL))
        broken("frame %" PRIu32 " cannot be read: %s", f->shown, image.message);
    for (uint32_t y = 0; y < f->h; y++)
        memcpy(f->canvas + (size_t)(f->y + y) * f->width + f->x, pixels + y * f->w,
               f->w * sizeof *pixels);
    free(pixels);
    const picture p = { TP_FORMAT_XRGB8888, f->width, f->height, 4 * (size_t)f->width,
                        (uint8_t *)f->canvas };
    printf("frame %04" PRIu32 " crc32 %08" PRIx32 " for %.4f s, %" PRIu32 " rows\n",
           f->shown++, picture_crc(&p), f->seconds, f->h);
    f->w = 0;
}

static void begin_frame(apng_film *f, const apng_chunk *c)
{
    if (f->w)
        show(f);
    if (c->bytes != 26)
        broken("fcTL of %" PRIu32 " bytes", c->bytes);
    expect_number(f, c->data);
    f->w = png_get_uint_32(c->data + 4);
    f->h = png_get_uint_32(c->data + 8);
    f->x = png_get_uint_32(c->data + 12);
    f->y = png_get_uint_32(c->data + 16);
    const unsigned over = png_get_uint_16(c->data + 22);
    f->seconds = (double)png_get_uint_16(c->data + 20) / (over ? over : 100);
    const bool whole = f->w == f->width && f->h == f->height;
    if (!f->w || !f->h || f->w > f->width - f->x || f->h > f->height - f->y
        || (f->sequence == 1 && !whole))
        broken("frame %" PRIu32 " is not within the picture", f->shown);
    if (c->data[24] || c->data[25])
        broken("frame %" PRIu32 " is to be blended", f->shown);
    f->png = claim(f->png, f->head_bytes);
    memcpy(f->png, f->head, f->head_bytes);
    f->png_bytes = 8;
    uint8_t sides[13];
    memcpy(sides, f->head + 16, sizeof sides);
    png_save_uint_32(sides, f->w);
    png_save_uint_32(sides + 4, f->h);
    add_chunk(&f->png, &f->png_bytes, "IHDR", sides, sizeof sides);
    f->png = claim(f->png, f->head_bytes);
    memcpy(f->png + f->png_bytes, f->head + f->png_bytes, f->head_bytes - f->png_bytes);
    f->png_bytes = f->head_bytes;
}

static void add_pixels(apng_film *f, const apng_chunk *c)
{
    const bool first = strcmp(c->type, "IDAT") == 0;
    if (!f->w || first != (f->shown == 0) || c->bytes < 4)
        broken("%s where none is due", c->type);
    if (!first)
        expect_number(f, c->data);
    add_chunk(&f->png, &f->png_bytes, "IDAT", c->data + (first ? 0 : 4),
              c->bytes - (first ? 0 : 4));
}

/* -- the file ------------------------------------------------------------------------ */

static void begin(apng_film *f)
{
    apng_chunk c;
    if (f->end - f->at < 8 || png_sig_cmp(f->at, 0, 8))
        broken("no PNG");
    const uint8_t *start = f->at;
    f->at += 8;
    if (!next_chunk(f, &c) || strcmp(c.type, "IHDR") != 0 || c.bytes != 13)
        broken("no IHDR");
    f->width = png_get_uint_32(c.data);
    f->height = png_get_uint_32(c.data + 4);
    f->canvas = claim(NULL, 4 * (size_t)f->width * f->height);
    while (next_chunk(f, &c) && strcmp(c.type, "acTL") != 0)
        if (strcmp(c.type, "IDAT") == 0)
            broken("pixels before acTL");
    f->head_bytes = (size_t)(c.data - 8 - start);
    if (strcmp(c.type, "acTL") != 0 || c.bytes != 8 || f->head_bytes > sizeof f->head)
        broken("no acTL behind a head of %zu bytes", f->head_bytes);
    memcpy(f->head, start, f->head_bytes);
    f->frames = png_get_uint_32(c.data);
    printf("%" PRIu32 "x%" PRIu32 ", %" PRIu32 " frames, %s\n", f->width, f->height,
           f->frames, png_get_uint_32(c.data + 4) ? "and an end" : "for ever");
}

static void read_all(apng_film *f)
{
    apng_chunk c;
    begin(f);
    do {
        if (!next_chunk(f, &c))
            broken("no IEND");
        if (strcmp(c.type, "fcTL") == 0)
            begin_frame(f, &c);
        else if (strcmp(c.type, "IDAT") == 0 || strcmp(c.type, "fdAT") == 0)
            add_pixels(f, &c);
        else if (strcmp(c.type, "IEND") != 0)
            broken("%s among the frames", c.type);
    } while (strcmp(c.type, "IEND") != 0);
    if (f->w)
        show(f);
    if (f->at != f->end || f->shown != f->frames)
        broken("%" PRIu32 " frames of %" PRIu32 ", %td bytes behind them", f->shown,
               f->frames, f->end - f->at);
}

int main(int argc, char **argv)
{
    static apng_film f;
    uint8_t *bytes = NULL;
    size_t length = 0, got;
    FILE *file = argc == 2 ? fopen(argv[1], "rb") : NULL;
    if (!file)
        return 2;
    do {
        bytes = claim(bytes, length + (1 << 20));
        got = fread(bytes + length, 1, 1 << 20, file);
        length += got;
    } while (got);
    fclose(file);
    f.at = bytes;
    f.end = bytes + length;
    read_all(&f);
    free(f.png);
    free(f.canvas);
    free(bytes);
    return 0;
}
