/* SPDX-License-Identifier: MIT */
/* Writes drawn pictures as PNG.  libpng reports errors by longjmp: all memory to be freed
 * is in one struct outside of the function with setjmp. */
#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "picture.h"
#include "pixel/pixel.h"

/* The chunk that marks tidepool's own pictures: type, key, text.  At most the palette's 768
 * bytes precede the chunk. */
static char mark[] = "tEXtSoftware\0tidepool";
#define MARK_KEY   (mark + 4)
#define MARK_TEXT  (mark + 13)
#define MARK_BYTES (sizeof mark - 1)
#define MARK_HIGH  1024

typedef struct {
    FILE       *to;
    png_structp png;
    png_infop   info;
    uint32_t   *pixels;         /* pixels of a row, 0x00RRGGBB */
    uint8_t    *rgb;            /* bytes of a row, R, G, B */
    int         error;          /* errno of the failed write */
} png_writer;

static void put(png_structp png, png_bytep data, size_t bytes)
{
    png_writer *w = png_get_io_ptr(png);
    errno = 0;
    if (fwrite(data, 1, bytes, w->to) != bytes) {
        w->error = errno ? errno : EIO;
        png_error(png, "write failed");
    }
}

static void flush(png_structp png)      /* the code that closes the file flushes */
{
    (void)png;
}

static void jump(png_structp png, png_const_charp text)
{
    (void)text;
    png_longjmp(png, 1);
}

static void ignore(png_structp png, png_const_charp text)
{
    (void)png;
    (void)text;
}

static void put_palette(png_writer *w)
{
    png_color colours[256];
    for (int i = 0; i < 256; i++) {
        const uint32_t c = tp_palette[i];
        colours[i] = (png_color){ (png_byte)(c >> 16), (png_byte)(c >> 8), (png_byte)c };
    }
    png_set_PLTE(w->png, w->info, colours, 256);
}

static void put_header(png_writer *w, const picture *p)
{
    const bool grey = p->format == TP_FORMAT_L8 || p->format == TP_FORMAT_I1;
    const bool indexed = p->format == TP_FORMAT_P8;
    const int type = grey ? PNG_COLOR_TYPE_GRAY
                   : indexed ? PNG_COLOR_TYPE_PALETTE : PNG_COLOR_TYPE_RGB;
    png_set_IHDR(w->png, w->info, p->width, p->height, p->format == TP_FORMAT_I1 ? 1 : 8,
                 type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(w->png, w->info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(w->png, w->info, &(png_text){ .compression = PNG_TEXT_COMPRESSION_NONE,
                                               .key = MARK_KEY, .text = MARK_TEXT }, 1);
    if (indexed)
        put_palette(w);
    png_write_info(w->png, w->info);
}

/* Returns a row in the layout of PNG.  p8, l8 and i1 have the same layout in memory. */
static const uint8_t *row_for_png(png_writer *w, const picture *p, uint32_t y)
{
    if (tp_format_bits(p->format) <= 8)
        return picture_row(p, y);
    picture_expand_row(p, y, w->pixels);
    for (uint32_t x = 0; x < p->width; x++) {
        w->rgb[3 * x]     = (uint8_t)(w->pixels[x] >> 16);
        w->rgb[3 * x + 1] = (uint8_t)(w->pixels[x] >> 8);
        w->rgb[3 * x + 2] = (uint8_t)w->pixels[x];
    }
    return w->rgb;
}

static bool write_all(png_writer *w, const picture *p)
{
    if (setjmp(png_jmpbuf(w->png)))
        return false;
    png_set_write_fn(w->png, w, put, flush);
    put_header(w, p);
    for (uint32_t y = 0; y < p->height; y++)
        png_write_row(w->png, row_for_png(w, p, y));
    png_write_end(w->png, w->info);
    return true;
}

int picture_put_png(const picture *p, FILE *to)
{
    png_writer w = { .to = to };
    w.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, jump, ignore);
    w.info = w.png ? png_create_info_struct(w.png) : NULL;
    w.pixels = malloc(p->width * sizeof *w.pixels);
    w.rgb = malloc(3 * (size_t)p->width);
    if (!w.info || !w.pixels || !w.rgb || !write_all(&w, p))
        w.error = w.error ? w.error : ENOMEM;
    png_destroy_write_struct(&w.png, &w.info);
    free(w.pixels);
    free(w.rgb);
    return w.error;
}

bool picture_is_ours(const char *name)
{
    uint8_t head[MARK_HIGH];
    FILE *file = fopen(name, "rb");
    const size_t bytes = file ? fread(head, 1, sizeof head, file) : 0;
    if (file)
        fclose(file);
    for (size_t i = 8; i + MARK_BYTES <= bytes; i++)
        if (memcmp(head + i, mark, MARK_BYTES) == 0)
            return png_sig_cmp(head, 0, 8) == 0;
    return false;
}
