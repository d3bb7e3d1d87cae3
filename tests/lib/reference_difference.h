/* SPDX-License-Identifier: MIT */
/* Compares the engine's picture with the reference's: the same moment, one sample a
 * pixel. */
#ifndef TP_TESTS_LIB_REFERENCE_DIFFERENCE_H
#define TP_TESTS_LIB_REFERENCE_DIFFERENCE_H
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "tests/lib/frames.h"
#include "tools/reference/image.h"
#include "tools/reference/shipped_scene.h"

/* Settings that turn off features the reference does not draw, or draws in another way; and
 * foam and spray, which test_engine_foam.c compares. */
#define REF_WITHOUT "foam.cells=0", "spray.count=0", "water.caustics=0", \
                    "sky.stars=0", "mirror.distortion=1"

/* The engine's picture: colours and the kind of surface in each pixel. */
typedef struct {
    uint32_t  width, height;
    uint32_t *pixel;            /* 0x00RRGGBB */
    uint8_t  *kind;             /* ref_kind */
} drawn_image;

/* Draws the picture as a single tile; the G-buffer's keys are the first plane of the tile's
 * scratch memory. */
static inline drawn_image drawn_of(const ref_stand *stand, uint32_t width,
                                   uint32_t height)
{
    const tp_config config = { .width = width,
                               .height = height,
                               .tile_height = height,
                               .assets = &stand->assets.names };
    const tp_scene *scene = &stand->file.scene;
    const size_t count = (size_t)width * height;
    static const uint8_t kind_of[] = {
        [MARKS_SKY] = REF_SKY, [MARKS_WATER] = REF_WATER, [MARKS_BOAT] = REF_BOAT,
        [MARKS_LAND] = REF_LAND, [MARKS_DROP] = REF_DROP, [MARKS_TANK] = REF_WALL,
        [MARKS_SIDE] = REF_SIDE,
    };
    uint8_t kind[TP_MARKS];
    drawn_image image = { width, height, malloc(count * 4), malloc(count) };
    void *block = malloc(tp_frame_bytes(&config, scene));
    uint32_t *scratch = malloc(tp_frame_scratch_bytes(&config, scene));
    tp_frame *frame;
    tp_tile tile;

    if (!image.pixel || !image.kind || !block || !scratch
        || tp_frame_init(&frame, &config, scene, block, tp_frame_bytes(&config, scene),
                         NULL))
        abort();
    tp_frame_begin(frame, stand->world);
    tp_frame_draw_tile(frame, 0, scratch, &tile);
    marks_list_kinds(frame, kind);
    for (size_t i = 0; i < count; i++)
        image.kind[i] = kind_of[kind[TP_MARK(scratch[i])]];
    for (uint32_t y = 0; y < height; y++)
        memcpy(image.pixel + (size_t)y * width,
               (const char *)tile.pixels + y * tile.stride, (size_t)width * 4);
    free(scratch);
    free(block);
    return image;
}

/* Memory of rays for several reference pictures of one surface; to be freed. */
static inline ref_memory *memory_new(void)
{
    ref_memory *memory = calloc(1, sizeof *memory);

    if (!memory)
        abort();
    return memory;
}

static inline void drawn_free(drawn_image *image)
{
    free(image->pixel);
    free(image->kind);
}

/* Difference of two pictures. */
typedef struct {
    uint32_t pixels, water;     /* pixels of the picture; pixels compared */
    uint32_t elsewhere;         /* pixels with another kind of surface */
    double   rms[3], worst[3];  /* of 255: water away from edges */
    double   mean[3];           /* engine minus reference, of 255 */
} difference;

/* True if the reciprocal depth changes its slope by more than a tenth of its value across
 * the pixel. 1 / depth is linear on a plane, so a bend marks the edge of a crest. */
static inline bool is_bent(const ref_image *b, size_t at, size_t step)
{
    return fabs(b->near[at - step] + b->near[at + step] - 2 * b->near[at])
           > 0.1 * b->near[at];
}

/* True if a mirrored object ends within two pixels. The engine draws the mirror at half the
 * size, so two pixels are one pixel of the mirror's picture. */
static inline bool is_mirror_edge(const ref_image *b, uint32_t x, uint32_t y)
{
    const uint8_t own = b->in_mirror[(size_t)y * b->width + x];

    for (uint32_t j = y > 2 ? y - 2 : 0; j <= y + 2 && j < b->height; j++)
        for (uint32_t i = x > 2 ? x - 2 : 0; i <= x + 2 && i < b->width; i++) {
            const size_t at = (size_t)j * b->width + i;
            if (b->kind[at] == REF_WATER && b->in_mirror[at] != own)
                return true;
        }
    return false;
}

/* True if the pixel and its eight neighbours are water in both pictures and neither a crest
 * nor a mirrored object ends at the pixel. */
static inline bool is_inner(const drawn_image *a, const ref_image *b, uint32_t x,
                            uint32_t y)
{
    const size_t middle = (size_t)y * a->width + x;

    for (uint32_t j = y - 1; j <= y + 1; j++)
        for (uint32_t i = x - 1; i <= x + 1; i++) {
            const size_t at = (size_t)j * a->width + i;
            if (a->kind[at] != REF_WATER || b->kind[at] != REF_WATER)
                return false;
        }
    return !is_bent(b, middle, 1) && !is_bent(b, middle, a->width)
        && !is_mirror_edge(b, x, y);
}

static inline void difference_add(difference *d, uint32_t drawn, ref_colour want)
{
    const ref_colour got = ref_colour_unpack(drawn);

    d->water++;
    for (int c = 0; c < 3; c++) {
        const double off = got.c[c] - ref_clamp(want.c[c], 0, 255);
        d->rms[c] += off * off;
        d->mean[c] += off;
        d->worst[c] = fmax(d->worst[c], fabs(off));
    }
}

static inline difference difference_of(const drawn_image *a, const ref_image *b)
{
    difference d = { .pixels = a->width * a->height };

    for (size_t i = 0; i < d.pixels; i++)
        d.elsewhere += a->kind[i] != b->kind[i];
    for (uint32_t y = 1; y + 1 < a->height; y++)
        for (uint32_t x = 1; x + 1 < a->width; x++) {
            const size_t at = (size_t)y * a->width + x;
            if (is_inner(a, b, x, y))
                difference_add(&d, a->pixel[at], b->colour[at]);
        }
    for (int c = 0; c < 3 && d.water; c++) {
        d.rms[c] = sqrt(d.rms[c] / d.water);
        d.mean[c] /= d.water;
    }
    return d;
}

/* Mean magnitude of the difference over all pixels and channels, of 255. */
static inline double difference_mean(const drawn_image *a, const ref_image *b)
{
    const size_t pixels = (size_t)a->width * a->height;
    double sum = 0;

    for (size_t i = 0; i < pixels; i++) {
        const ref_colour got = ref_colour_unpack(a->pixel[i]);
        for (int c = 0; c < 3; c++)
            sum += fabs(got.c[c] - ref_clamp(b->colour[i].c[c], 0, 255));
    }
    return sum / (3 * (double)pixels);
}

static inline double greatest(const double of[3])
{
    return fmax(of[0], fmax(of[1], of[2]));
}
#endif
