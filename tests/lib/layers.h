/* SPDX-License-Identifier: MIT */
/* Random textures with odd sides, and the way the stages of the water apply texture
 * layers. */
#ifndef TP_TESTS_LIB_LAYERS_H
#define TP_TESTS_LIB_LAYERS_H
#include <stdlib.h>
#include "features/water/water.h"
#include "tests/lib/shading.h"
#include "tools/reference/texture.h"

typedef void stage(const tp_shade *shade, tp_run *run);

/* Data that the stages of the water modules read; tests use one instance of each at a
 * time. */
static struct {
    tp_base_layer base;
    tp_layers     layers;
    tp_ripple     ripple;
} own;

static inline void run_by(stage *by, const tp_shade *shade, const void *mine, tp_run *run)
{
    run->mine = mine;
    by(shade, run);
}

/* A texture of random texels, alpha included, in memory of its own. */
static inline tp_texture layer_texture(uint64_t *chance, uint32_t w, uint32_t h)
{
    uint32_t *const pixels = malloc((size_t)w * h * sizeof *pixels);
    tp_texture t;

    for (uint32_t i = 0; i < w * h; i++)
        pixels[i] = (uint32_t)random_next(chance);
    assert_int_equal(tp_texture_init(&t, pixels, w, h, malloc(tp_texture_bytes(w, h)),
                                     tp_texture_bytes(w, h), NULL),
                     TP_OK);
    free(pixels);
    return t;
}

static inline void layer_free(tp_texture *t)
{
    free((void *)(uintptr_t)t->level[0]);
}

/* Gives all samples one depth, at which `layer` uses the given mipmap level. */
static inline tp_shade layer_at_level(test_run *r, tp_layer *layer, int level)
{
    const tp_shade s = { .zi_log = 15 * 256 + 14 * 256 };

    for (int i = 0; i < TP_RUN; i++)
        r->key[i] = 0x10000000;
    layer->lod = level * 256 + 64 - tp_log_depth(&s, r->key[0]);
    if (tp_log_depth(&s, r->key[0]) > 0)
        layer->lod -= tp_log_depth(&s, r->key[0]) / 2;
    return s;
}

static inline tp_layer layer_any(uint64_t *chance, const tp_texture *texture)
{
    return (tp_layer){
        .texture = texture,
        .per_metre = (uint32_t)(random_next(chance) >> chance_int(chance, 32, 50)),
        .drift_s = (uint32_t)random_next(chance),
        .drift_t = (uint32_t)random_next(chance),
    };
}

/* Texture coordinate in repeats from the layer's parameters: Q0.32, wrapping. */
static inline double repeats(uint32_t place, uint32_t per_metre, uint32_t drift)
{
    return (place * per_metre + drift) / 4294967296.0;
}

static const uint32_t sides[][2] = { { 1, 1 },    { 2, 1 },   { 1, 64 },  { 256, 256 },
                                     { 16, 128 }, { 512, 2 }, { 4096, 1 } };
enum { SIDES = sizeof sides / sizeof sides[0] };
#endif
