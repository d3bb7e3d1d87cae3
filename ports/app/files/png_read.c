/* SPDX-License-Identifier: MIT */
/* Reads PNG files of any depth and colour type to 0xAARRGGBB, or to 16-bit grey.
 *
 * The file may be hostile: the sides are limited to the sides of a texture before any
 * allocation, ancillary chunks are limited, and every error of libpng is caught here. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "log.h"
#include "picture.h"

#define SIDE        4096
#define CHUNKS      64              /* ancillary chunks kept */
#define CHUNK_BYTES (8u << 20)      /* of a chunk, uncompressed; of any allocation */

typedef struct {
    FILE       *file;
    png_structp png;
    png_infop   info;
    uint32_t    w, h;
    bool        grey, lacks_memory;
    uint8_t    *bytes;              /* rows of R, G, B, A, or of high and low byte */
    png_bytep  *rows;
    char        hint[80];           /* last warning; explains more than the error */
    char        why[PICTURE_WHY];
} png_reader;

static void refuse(png_structp png, png_const_charp text)
{
    png_reader *r = png_get_error_ptr(png);
    r->lacks_memory = errno == ENOMEM;
    snprintf(r->why, sizeof r->why, "not a good PNG: %s%s%s", text,
             r->hint[0] ? ": " : "", r->hint);
    png_longjmp(png, 1);
}

static void remember(png_structp png, png_const_charp text)
{
    png_reader *r = png_get_error_ptr(png);
    snprintf(r->hint, sizeof r->hint, "%s", text);
}

/* Refuses with a message of tidepool's own. */
static void refuse_sides(png_reader *r)
{
    r->hint[0] = '\0';
    snprintf(r->why, sizeof r->why, "not a good PNG: %u x %u pixels; %d x %d at the most",
             (unsigned)r->w, (unsigned)r->h, SIDE, SIDE);
    png_longjmp(r->png, 1);
}

static void refuse_memory(png_reader *r)
{
    snprintf(r->why, sizeof r->why, "out of memory");
    r->lacks_memory = true;
    png_longjmp(r->png, 1);
}

static void get(png_structp png, png_bytep data, size_t bytes)
{
    png_reader *r = png_get_io_ptr(png);
    errno = 0;
    if (fread(data, 1, bytes, r->file) == bytes)
        return;
    r->hint[0] = '\0';
    png_error(png, ferror(r->file) ? strerror(errno) : "the file ends too early");
}

/* Bounds allocations.  A chunk may claim 2 GB; libpng only warns, and then asks for the
 * memory. */
static png_voidp take(png_structp png, png_alloc_size_t bytes)
{
    (void)png;
    return bytes <= CHUNK_BYTES ? malloc(bytes) : NULL;
}

static void give_back(png_structp png, png_voidp memory)
{
    (void)png;
    free(memory);
}

/* Converts every kind of PNG to rows of R, G, B, A bytes. */
static void ask_for_rgba(png_structp png, png_infop info)
{
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
}

/* Converts to rows of 16-bit grey, high byte first. */
static void ask_for_grey(png_structp png, png_infop info)
{
    png_set_expand_16(png);
    png_set_strip_alpha(png);
    png_set_rgb_to_gray(png, PNG_ERROR_ACTION_NONE, PNG_RGB_TO_GRAY_DEFAULT,
                        PNG_RGB_TO_GRAY_DEFAULT);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
}

static void allocate(png_reader *r)
{
    const size_t row = (r->grey ? 2 : 4) * (size_t)r->w;
    if (png_get_rowbytes(r->png, r->info) != row)
        png_error(r->png, "rows of an unexpected size");
    r->bytes = malloc(row * r->h);
    r->rows = malloc(r->h * sizeof *r->rows);
    if (!r->bytes || !r->rows)
        refuse_memory(r);
    for (uint32_t y = 0; y < r->h; y++)
        r->rows[y] = r->bytes + y * row;
}

static bool read_all(png_reader *r)
{
    if (setjmp(png_jmpbuf(r->png)))
        return false;
    png_set_read_fn(r->png, r, get);
    png_set_user_limits(r->png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_chunk_cache_max(r->png, CHUNKS);
    png_set_chunk_malloc_max(r->png, CHUNK_BYTES);
    png_read_info(r->png, r->info);
    r->w = png_get_image_width(r->png, r->info);
    r->h = png_get_image_height(r->png, r->info);
    if (r->w > SIDE || r->h > SIDE)
        refuse_sides(r);
    if (r->grey)
        ask_for_grey(r->png, r->info);
    else
        ask_for_rgba(r->png, r->info);
    allocate(r);
    png_read_image(r->png, r->rows);
    png_read_end(r->png, NULL);
    return true;
}

/* Converts in place: four bytes become one word. */
static uint32_t *pack_words(uint8_t *rgba, size_t count)
{
    uint32_t *words = (uint32_t *)(void *)rgba;
    for (size_t i = 0; i < count; i++) {
        const uint8_t *b = rgba + 4 * i;
        words[i] = (uint32_t)b[3] << 24 | (uint32_t)b[0] << 16 | (uint32_t)b[1] << 8
                 | b[2];
    }
    return words;
}

static uint16_t *pack_greys(uint8_t *bytes, size_t count)
{
    uint16_t *greys = (uint16_t *)(void *)bytes;
    for (size_t i = 0; i < count; i++)
        greys[i] = (uint16_t)(bytes[2 * i] << 8 | bytes[2 * i + 1]);
    return greys;
}

static bool read_open_file(png_reader *r)
{
    errno = 0;
    r->png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, r, refuse, remember, NULL,
                                      take, give_back);
    r->info = r->png ? png_create_info_struct(r->png) : NULL;
    r->lacks_memory = !r->info;
    if (!r->info)
        snprintf(r->why, sizeof r->why, "out of memory");
    const bool done = r->info && read_all(r);
    png_destroy_read_struct(&r->png, &r->info, NULL);
    free(r->rows);
    return done;
}

/* -- pictures of other kinds --------------------------------------------------------- */

/* First bytes of files, by kind; TGA files have no signature. */
static const struct { const char *name, *start; size_t bytes; } kinds[] = {
    { "JPEG", "\xff\xd8\xff", 3 }, { "GIF", "GIF8", 4 },        { "BMP", "BM", 2 },
    { "TIFF", "II*\0", 4 },        { "TIFF", "MM\0*", 4 },      { "WebP", "RIFF", 4 },
    { "DDS", "DDS ", 4 },          { "Photoshop", "8BPS", 4 },  { "OpenEXR", "v/1\1", 4 },
    { "Radiance", "#?", 2 },
};

static const char *detect_file_kind(const char *name, const uint8_t *start, size_t bytes)
{
    const char *dot = strrchr(name, '.');
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (bytes >= kinds[i].bytes && memcmp(start, kinds[i].start, kinds[i].bytes) == 0)
            return kinds[i].name;
    return dot && strcasecmp(dot, ".tga") == 0 ? "TGA" : NULL;
}

/* True if the file does not begin like a PNG; r->why names the kind.  An unreadable or
 * empty file is left to the PNG reader. */
static bool is_foreign(png_reader *r, const char *name)
{
    uint8_t start[8];
    const size_t bytes = fread(start, 1, sizeof start, r->file);
    if (bytes == 0 || png_sig_cmp(start, 0, bytes) == 0)
        return fseek(r->file, 0, SEEK_SET) != 0;
    const char *kind = detect_file_kind(name, start, bytes);
    snprintf(r->why, sizeof r->why, "%s", kind ? kind : "not a PNG");
    if (kind)
        strcat(r->why, ", expected PNG");
    return true;
}

/* -- files --------------------------------------------------------------------------- */

/* Returns NULL after a failure; r->why has the reason. */
static uint8_t *load_file(png_reader *r, const char *name)
{
    r->file = fopen(name, "rb");
    if (!r->file) {
        r->lacks_memory = errno == ENOMEM;
        snprintf(r->why, sizeof r->why, "%s", strerror(errno));
        return NULL;
    }
    const bool done = !is_foreign(r, name) && read_open_file(r);
    fclose(r->file);
    if (done)
        return r->bytes;
    free(r->bytes);
    errno = r->lacks_memory ? ENOMEM : EINVAL;
    return NULL;
}

static uint8_t *read_file(png_reader *r, const char *name, const char *who)
{
    uint8_t *bytes = load_file(r, name);
    if (!bytes)
        log_line("%s: %s: %s", who, name, r->why);
    return bytes;
}

uint32_t *picture_load_png(const char *name, uint32_t *w, uint32_t *h,
                           char why[PICTURE_WHY])
{
    png_reader r = { .grey = false };
    uint8_t *rgba = load_file(&r, name);
    const int error = errno;
    *w = r.w;
    *h = r.h;
    memcpy(why, r.why, PICTURE_WHY);
    errno = error;
    return rgba ? pack_words(rgba, (size_t)r.w * r.h) : NULL;
}

uint32_t *picture_read_png(const char *name, const char *who, uint32_t *w, uint32_t *h)
{
    png_reader r = { .grey = false };
    uint8_t *rgba = read_file(&r, name, who);
    *w = r.w;
    *h = r.h;
    return rgba ? pack_words(rgba, (size_t)r.w * r.h) : NULL;
}

uint16_t *picture_read_grey(const char *name, const char *who, uint32_t *w, uint32_t *h)
{
    png_reader r = { .grey = true };
    uint8_t *bytes = read_file(&r, name, who);
    *w = r.w;
    *h = r.h;
    return bytes ? pack_greys(bytes, (size_t)r.w * r.h) : NULL;
}
