/* SPDX-License-Identifier: MIT */
/* YUV4MPEG2, 4:2:0 with centred chroma ("C420jpeg"), BT.601 in limited range, the default
 * of players.
 *
 * Converts RGB to YUV in integers with 16 fraction bits.  The coefficients sum to 219/255,
 * 0 and 0: greys have no tint, and white is 235.  Chroma uses the sum of four pixels, hence
 * two more bits. */
#include "film.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "log.h"

enum {
    Y_R = 16829,  Y_G = 33039,  Y_B = 6416,
    U_R = -9714,  U_G = -19070, U_B = 28784,
    V_R = 28784,  V_G = -24103, V_B = -4681
};

_Static_assert(U_R + U_G + U_B == 0 && V_R + V_G + V_B == 0, "grey must stay grey");

static int red(uint32_t c)   { return (int)(c >> 16 & 255); }
static int green(uint32_t c) { return (int)(c >> 8 & 255); }
static int blue(uint32_t c)  { return (int)(c & 255); }

static uint8_t luma(uint32_t c)
{
    const int sum = Y_R * red(c) + Y_G * green(c) + Y_B * blue(c);
    return (uint8_t)(16 + ((sum + 0x8000) >> 16));
}

/* Arguments: sums of four pixels; |sum| <= 28784 * 1020 < 2^25. */
static uint8_t chroma(int r, int g, int b, int kr, int kg, int kb)
{
    return (uint8_t)(128 + ((kr * r + kg * g + kb * b + 0x20000) >> 18));
}

/* Converts two rows of pixels to two rows of Y and one row each of U and V.  At an odd
 * bottom the last row counts twice. */
static void add_rows(film *f, uint32_t y)
{
    const uint32_t w = f->width, h = f->height, half = (w + 1) / 2;
    const uint32_t *upper = f->pixels, *lower = f->pixels + w;
    uint8_t *luma_row = f->planes + (size_t)y * w;
    uint8_t *u_row = f->planes + (size_t)w * h + (size_t)(y / 2) * half;
    uint8_t *v_row = u_row + (size_t)half * ((h + 1) / 2);
    for (uint32_t x = 0; x < w; x++) {
        luma_row[x] = luma(upper[x]);
        if (y + 1 < h)
            luma_row[w + x] = luma(lower[x]);
    }
    for (uint32_t i = 0; i < half; i++) {
        const uint32_t x0 = 2 * i, x1 = x0 + 1 < w ? x0 + 1 : x0;
        const uint32_t four[4] = { upper[x0], upper[x1], lower[x0], lower[x1] };
        int r = 0, g = 0, b = 0;
        for (int k = 0; k < 4; k++) {
            r += red(four[k]);
            g += green(four[k]);
            b += blue(four[k]);
        }
        u_row[i] = chroma(r, g, b, U_R, U_G, U_B);
        v_row[i] = chroma(r, g, b, V_R, V_G, V_B);
    }
}

static bool put(film *f, const void *data, size_t bytes)
{
    return fwrite(data, 1, bytes, f->out.file) == bytes;
}

static int refuse(film *f)
{
    const int code = output_file_fail(&f->out, EIO);
    film_discard(f);
    return code;
}

static int make_room(film *f, uint32_t width, uint32_t height)
{
    const size_t half = (size_t)((width + 1) / 2) * ((height + 1) / 2);
    *f = (film){ .width = width, .height = height };
    f->bytes = (size_t)width * height + 2 * half;
    f->pixels = malloc(2 * width * sizeof *f->pixels);
    f->planes = malloc(f->bytes);
    if (f->pixels && f->planes)
        return EXIT_DONE;
    film_discard(f);
    return log_fail_memory(f->bytes);
}

static int put_head(film *f, uint32_t ticks)
{
    char head[96];
    const int length = snprintf(head, sizeof head,
        "YUV4MPEG2 W%u H%u F%d:%u Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n",
        (unsigned)f->width, (unsigned)f->height, TP_TICKS_PER_SECOND, (unsigned)ticks);
    return put(f, head, (size_t)length) ? EXIT_DONE : refuse(f);
}

int film_open(film *f, const char *name, uint32_t width, uint32_t height, uint32_t ticks)
{
    int code = make_room(f, width, height);
    if (code)
        return code;
    code = output_file_open(&f->out, name);
    if (code)
        film_discard(f);
    return code ? code : put_head(f, ticks);
}

int film_open_pipe(film *f, int to, const char *name, uint32_t width, uint32_t height)
{
    int code = make_room(f, width, height);
    if (code) {
        close(to);
        return code;
    }
    code = output_file_adopt(&f->out, to, name);
    if (code)
        film_discard(f);
    return code ? code : put_head(f, 1);
}

int film_add(film *f, const picture *p)
{
    for (uint32_t y = 0; y < p->height; y += 2) {
        picture_expand_row(p, y, f->pixels);
        picture_expand_row(p, y + 1 < p->height ? y + 1 : y, f->pixels + p->width);
        add_rows(f, y);
    }
    if (!put(f, "FRAME\n", 6) || !put(f, f->planes, f->bytes))
        return refuse(f);
    return EXIT_DONE;
}

void film_discard(film *f)
{
    output_file_discard(&f->out);
    free(f->pixels);
    free(f->planes);
    *f = (film){ .out = f->out };
}

int film_close(film *f)
{
    const int code = output_file_close(&f->out);
    film_discard(f);
    return code;
}
