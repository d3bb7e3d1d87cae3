/* SPDX-License-Identifier: MIT */
/* PNG files of every kind, written by libpng from one formula, so the exact texels to be
 * read are known; and scenes that name a picture in one place: the result of loading, and
 * the messages. */
#ifndef TP_TESTS_LIB_PNG_FILES_H
#define TP_TESTS_LIB_PNG_FILES_H
#include <png.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "app/scene/assets.h"
#include "app/files/log.h"
#include <cmocka.h>

static const char *const textures[] = {
    "layer0.texture", "layer1.texture", "layer2.texture", "distortion.texture",
    "ripple.texture", "foam.texture", "sky.east", "sky.west", "sky.up", "sky.down",
    "sky.south", "sky.north", "tank.wall", "tank.floor", "floor.texture",
};
static const char *const greys[] = { "floor.map", "pool.mask", "field.mask" };

enum { TEXTURES = sizeof textures / sizeof *textures,
       GREYS = sizeof greys / sizeof *greys };

_Static_assert((int)TEXTURES == (int)ASSETS_PICTURES, "every place of a texture is tried");

/* -- messages ------------------------------------------------------------------------ */

static int kept_stderr;
static char said[8192];

static inline void listen(void)
{
    fflush(stderr);
    kept_stderr = dup(STDERR_FILENO);
    assert_non_null(freopen("said", "w", stderr));
}

static inline void stop_listening(void)
{
    fflush(stderr);
    dup2(kept_stderr, STDERR_FILENO);
    close(kept_stderr);
    FILE *file = fopen("said", "rb");
    assert_non_null(file);
    said[fread(said, 1, sizeof said - 1, file)] = '\0';
    fclose(file);
}

/* -- scenes with a picture ------------------------------------------------------------- */

static inline void put_setting(FILE *file, const char *row, const char *value)
{
    const char *dot = strchr(row, '.');
    fprintf(file, "[%.*s]\n%s = %s\n", (int)(dot - row), row, dot + 1, value);
}

/* Loads a scene naming a picture in its third line.  Returns the code; messages go to
 * `said`. */
static inline int open_one(const char *row, const char *name)
{
    scene_file scene;
    asset_set a;
    FILE *file = fopen("case.ini", "w");
    assert_non_null(file);
    fprintf(file, "; a case\n");
    put_setting(file, row, name);
    fclose(file);
    listen();
    int code = scene_file_open(&scene, "./case.ini");
    assert_int_equal(code, EXIT_DONE);
    code = assets_open(&a, &scene);
    if (!code)
        assets_close(&a);
    else
        assert_null(a.blocks);
    scene_file_close(&scene);
    stop_listening();
    return code;
}

/* -- a temporary folder ---------------------------------------------------------------- */

static char folder[4096];

static inline int enter(void **state)
{
    const char *place = getenv("TMPDIR");

    (void)state;
    snprintf(folder, sizeof folder, "%s/tidepool-images-XXXXXX",
             place && *place ? place : P_tmpdir);
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

static inline int leave(void **state)
{
    static const char *const made[] = { "kind.png", "bad.png", "case.ini", "said" };
    (void)state;
    for (size_t i = 0; i < sizeof made / sizeof *made; i++)
        remove(made[i]);
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

/* -- kinds of files ------------------------------------------------------------------ */

typedef struct {
    const char *name;
    uint32_t    w, h;
    int         bits, type;
    bool        interlaced, keyed;      /* keyed: has a tRNS chunk */
} kind;

#define GREY  PNG_COLOR_TYPE_GRAY
#define GREYA PNG_COLOR_TYPE_GRAY_ALPHA
#define RGB   PNG_COLOR_TYPE_RGB
#define RGBA  PNG_COLOR_TYPE_RGB_ALPHA
#define INDEX PNG_COLOR_TYPE_PALETTE

static const kind kinds[] = {
    { "one pixel",                1,   1,  8, RGB,   false, false },
    { "one pixel of 1 bit",       1,   1,  1, GREY,  false, false },
    { "one column",               1,  37,  8, RGB,   false, false },
    { "one row, interlaced",     41,   1,  8, RGB,   true,  false },
    { "odd sides",               13,  29,  8, RGB,   false, false },
    { "odd sides, interlaced",   13,  29,  8, RGBA,  true,  false },
    { "3 x 3, interlaced",        3,   3,  8, RGB,   true,  false },
    { "16 bits",                 17,   9, 16, RGB,   false, false },
    { "16 bits with alpha",      17,   9, 16, RGBA,  true,  false },
    { "16 bits with a key",      17,   9, 16, RGB,   false, true },
    { "grey of 1 bit",           19,   5,  1, GREY,  false, false },
    { "grey of 2 bits",          19,   5,  2, GREY,  true,  false },
    { "grey of 4 bits",          19,   5,  4, GREY,  false, true },
    { "grey of 8 bits",          64,  64,  8, GREY,  false, false },
    { "grey of 16 bits",         21,   6, 16, GREY,  true,  false },
    { "grey with a key",         21,   6,  8, GREY,  false, true },
    { "grey with alpha",         21,   6,  8, GREYA, false, false },
    { "grey of 16, with alpha",  21,   6, 16, GREYA, true,  false },
    { "palette of 1 bit",        11,   7,  1, INDEX, false, false },
    { "palette of 2 bits",       11,   7,  2, INDEX, true,  false },
    { "palette of 4, with tRNS", 11,   7,  4, INDEX, false, true },
    { "palette of 8",            40,  30,  8, INDEX, false, false },
    { "palette of 8, with tRNS", 40,  30,  8, INDEX, true,  true },
    { "a long strip",          4096,   2,  8, GREY,  false, false },
};

enum { KINDS = sizeof kinds / sizeof *kinds };

static inline int channels(const kind *k)
{
    return k->type == RGB ? 3 : k->type == RGBA ? 4 : k->type == GREYA ? 2 : 1;
}

/* Returns sample c of pixel (x, y), of k->bits bits. */
static inline uint32_t sample(const kind *k, uint32_t x, uint32_t y, int c)
{
    const uint32_t v = x * 40503u + y * 30011u + (uint32_t)c * 17321u;
    return (v ^ v >> 7) & ((1u << k->bits) - 1);
}

#define KEY 1                   /* the transparent sample, or palette index */

static inline png_color palette_entry(uint32_t i)
{
    return (png_color){ (png_byte)(7 * i + 3), (png_byte)(255 - 5 * i),
                        (png_byte)(90 ^ i) };
}

/* Returns the texel to be read. */
static inline uint32_t expected(const kind *k, uint32_t x, uint32_t y)
{
    uint32_t c[4], raw[4], alpha = 255;
    for (int i = 0; i < channels(k); i++) {
        raw[i] = sample(k, x, y, i);
        c[i] = k->bits == 16 ? (raw[i] * 255 + 32895) >> 16
                             : raw[i] * 255 / ((1u << k->bits) - 1);
    }
    if (k->type == INDEX) {
        const png_color p = palette_entry(raw[0]);
        return (k->keyed && raw[0] <= KEY ? 100 + raw[0] : 255u) << 24
             | (uint32_t)p.red << 16 | (uint32_t)p.green << 8 | p.blue;
    }
    if (k->type == GREYA || k->type == RGBA)
        alpha = c[channels(k) - 1];
    if (k->keyed && raw[0] == KEY && (k->type == GREY || (raw[1] == KEY && raw[2] == KEY)))
        alpha = 0;
    return k->type == GREY || k->type == GREYA
               ? alpha << 24 | c[0] * 0x010101
               : alpha << 24 | c[0] << 16 | c[1] << 8 | c[2];
}

static inline void put_chunks(png_structp png, png_infop info, const kind *k)
{
    png_color palette[256];
    png_byte alpha[KEY + 1] = { 100, 101 };
    const png_color_16 key = { .gray = KEY, .red = KEY, .green = KEY, .blue = KEY };
    for (uint32_t i = 0; i < 256; i++)
        palette[i] = palette_entry(i);
    if (k->type == INDEX)
        png_set_PLTE(png, info, palette, 1 << k->bits);
    if (k->keyed && k->type == INDEX)
        png_set_tRNS(png, info, alpha, KEY + 1, NULL);
    else if (k->keyed)
        png_set_tRNS(png, info, NULL, 0, &key);
}

static inline void pack_row(const kind *k, uint32_t y, uint8_t *row)
{
    memset(row, 0, (size_t)k->w * 8);
    for (uint32_t x = 0; x < k->w; x++)
        for (int c = 0; c < channels(k); c++) {
            const uint32_t v = sample(k, x, y, c),
                           n = x * (uint32_t)channels(k) + (uint32_t)c;
            if (k->bits == 16) {
                row[2 * n] = (uint8_t)(v >> 8);
                row[2 * n + 1] = (uint8_t)v;
            } else {
                const uint32_t bit = n * (uint32_t)k->bits;
                row[bit / 8] |= (uint8_t)(v << (8 - k->bits - (int)(bit % 8)));
            }
        }
}

static inline void write_kind(const kind *k, const char *name)
{
    FILE *file = fopen(name, "wb");
    assert_non_null(file);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    png_bytep rows[64];
    assert_in_range(k->h, 1, 64);
    png_init_io(png, file);
    png_set_IHDR(png, info, k->w, k->h, k->bits, k->type,
                 k->interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    put_chunks(png, info, k);
    png_write_info(png, info);
    for (uint32_t y = 0; y < k->h; y++) {
        rows[y] = malloc((size_t)k->w * 8);
        pack_row(k, y, rows[y]);
    }
    png_write_image(png, rows);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    for (uint32_t y = 0; y < k->h; y++)
        free(rows[y]);
    assert_int_equal(fclose(file), 0);
}
#endif
