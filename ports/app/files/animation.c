/* SPDX-License-Identifier: MIT */
/* Animated PNGs after the third edition of the PNG specification.  libpng packs each
 * picture into memory as a complete PNG.  The chunks of the first PNG are copied unchanged,
 * with acTL, the number of pictures, inserted before the pixels.  Of every later PNG only
 * the pixels are copied: IDAT is renamed to fdAT and gets a sequence number.  An fcTL chunk
 * before each picture gives its position and its duration.
 *
 * Rows at the top and at the bottom that equal the previous picture's are not stored: a
 * still sky costs nothing. */
#define _POSIX_C_SOURCE 200809L
#include "animation.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "log.h"
#include "pixel/pixel.h"

#define SIGNATURE 8             /* bytes of the PNG signature */
#define CHUNK     12            /* bytes of a chunk beside its data: length, type, CRC */

static void put_32(uint8_t *to, uint32_t n)
{
    for (int i = 0; i < 4; i++)
        to[i] = (uint8_t)(n >> (24 - 8 * i));
}

static uint32_t get_32(const uint8_t *from)
{
    return (uint32_t)from[0] << 24 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 8
         | from[3];
}

/* Writes a chunk with its data in two parts: head is a sequence number or empty. */
static bool put_chunk(animation *a, const char *type, const uint8_t *head,
                      size_t head_bytes, const uint8_t *data, size_t bytes)
{
    uint8_t before[12], crc[4];
    const size_t length = head_bytes + bytes;
    put_32(before, (uint32_t)length);
    memcpy(before + 4, type, 4);
    if (head_bytes)
        memcpy(before + 8, head, head_bytes);
    put_32(crc, tp_crc32(tp_crc32(0, before + 4, 4 + head_bytes), data, bytes));
    return fwrite(before, 1, 8 + head_bytes, a->out.file) == 8 + head_bytes
        && fwrite(data, 1, bytes, a->out.file) == bytes
        && fwrite(crc, 1, sizeof crc, a->out.file) == sizeof crc;
}

/* Writes acTL: the number of frames, then the number of plays, 0 = endless. */
static bool put_count(animation *a)
{
    uint8_t data[8] = { 0 };
    put_32(data, a->frames);
    return put_chunk(a, "acTL", NULL, 0, data, sizeof data);
}

/* Writes fcTL: sequence number, size, position, duration in seconds as a fraction.  The
 * last two bytes, disposal and blending, are 0: the picture stays on the canvas, and the
 * next picture replaces the pixels under its rectangle. */
static bool put_control(animation *a, const picture *part, uint32_t y)
{
    uint8_t data[26] = { 0 };
    put_32(data, a->sequence++);
    put_32(data + 4, part->width);
    put_32(data + 8, part->height);
    put_32(data + 16, y);
    put_32(data + 20, a->ticks << 16 | TP_TICKS_PER_SECOND);
    return put_chunk(a, "fcTL", NULL, 0, data, sizeof data);
}

static bool put_pixels(animation *a, const uint8_t *data, size_t bytes)
{
    uint8_t number[4];
    if (a->added == 0)
        return put_chunk(a, "IDAT", NULL, 0, data, bytes);
    put_32(number, a->sequence++);
    return put_chunk(a, "fdAT", number, sizeof number, data, bytes);
}

/* Copies the chunks of a PNG made by libpng; the picture begins at row y of the canvas. */
static bool put_png(animation *a, const uint8_t *png, size_t bytes, const picture *part,
                    uint32_t y)
{
    bool begun = false, done = true;
    if (a->added == 0)
        done = fwrite(png, 1, SIGNATURE, a->out.file) == SIGNATURE;
    for (size_t at = SIGNATURE; done && at + CHUNK <= bytes;) {
        const uint8_t *chunk = png + at;
        const size_t length = get_32(chunk);
        const char *type = (const char *)chunk + 4;
        if (memcmp(type, "IDAT", 4) == 0) {
            if (!begun)
                done = (a->added > 0 || put_count(a)) && put_control(a, part, y);
            begun = true;
            done = done && put_pixels(a, chunk + 8, length);
        } else if (a->added == 0 && memcmp(type, "IEND", 4) != 0) {
            done = put_chunk(a, type, NULL, 0, chunk + 8, length);
        }
        at += CHUNK + length;
    }
    return done;
}

/* Returns the rows of the picture from the first to the last changed row, at least one row.
 * *y: the first of the rows. */
static picture changed_part(const animation *a, const picture *p, uint32_t *y)
{
    const size_t line = p->row_bytes;
    uint32_t top = 0, end = p->height;
    while (a->added && top + 1 < end
           && memcmp(a->rows + top * line, p->rows + top * line, line) == 0)
        top++;
    while (a->added && end > top + 1
           && memcmp(a->rows + (end - 1) * line, p->rows + (end - 1) * line, line) == 0)
        end--;
    picture part = *p;
    part.rows += top * line;
    part.height = end - top;
    *y = top;
    return part;
}

/* Returns 0 or an errno. */
static int put_picture(animation *a, const picture *p)
{
    char *png = NULL;
    size_t bytes = 0;
    uint32_t y;
    const picture part = changed_part(a, p, &y);
    FILE *memory = open_memstream(&png, &bytes);
    int error = memory ? picture_put_png(&part, memory) : errno;
    if (memory && fclose(memory) && !error)
        error = errno;
    errno = 0;
    if (!error && !put_png(a, (const uint8_t *)png, bytes, &part, y))
        error = errno ? errno : EIO;
    free(png);
    return error;
}

static int refuse(animation *a, int error)
{
    free(a->rows);
    a->rows = NULL;
    return output_file_fail(&a->out, error);
}

int animation_open(animation *a, const char *name, uint32_t frames, uint32_t ticks)
{
    *a = (animation){ .frames = frames, .ticks = ticks };
    return output_file_open(&a->out, name);
}

int animation_add(animation *a, const picture *p)
{
    const size_t bytes = p->row_bytes * p->height;
    if (!a->rows)
        a->rows = malloc(bytes);
    const int error = a->rows ? put_picture(a, p) : ENOMEM;
    if (error)
        return refuse(a, error);
    memcpy(a->rows, p->rows, bytes);
    a->added++;
    return EXIT_DONE;
}

int animation_close(animation *a)
{
    errno = 0;
    if (!put_chunk(a, "IEND", NULL, 0, (const uint8_t *)"", 0))
        return refuse(a, errno ? errno : EIO);
    free(a->rows);
    a->rows = NULL;
    return output_file_close(&a->out);
}

void animation_discard(animation *a)
{
    free(a->rows);
    a->rows = NULL;
    output_file_discard(&a->out);
}
