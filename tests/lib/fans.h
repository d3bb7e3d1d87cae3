/* SPDX-License-Identifier: MIT */
/* Fans over random swells, for tests of vertices. */
#ifndef TP_TESTS_LIB_FANS_H
#define TP_TESTS_LIB_FANS_H
#include "tests/lib/camera.h"
#include "tests/lib/grids.h"
#include "tests/lib/scenes.h"
#include "view/fan.h"
#include "view/wave_models.h"

enum { FAN_MOST = 2000 };       /* vertices */

/* A placed fan over swells. */
typedef struct {
    tp_grid grid;
    void   *block;
    test_view v;
    tp_deep_water deep;
    tp_turn phases[TP_WAVES];
    tp_surface surface;
} fan_sea;

/* Lays out a fan over `count` swells; the caller frees the block. */
static inline void fan_sea_lay_out(fan_sea *s, int count, uint64_t *chance)
{
    tp_wave waves[TP_WAVES];

    s->v = view_any(chance);
    for (int i = 0; i < count; i++) {
        waves[i] = chance_wave(chance);
        waves[i].amplitude = chance_scale(chance, 0.01, 1);
    }
    tp_deep_water_init(&s->deep, waves, (uint32_t)count, TP_FX(9.81));
    tp_deep_water_phases(&s->deep, random_next(chance) >> 20, 0, s->phases);
    s->surface =
        (tp_surface){ .by = &tp_program_all.water, .deep = &s->deep, .phases = s->phases };
    s->block = grid_block(&s->grid, FAN_MOST, false);
    const tp_grid_view look = { .projection = &s->v.projection, .surface = &s->surface,
                                .width = s->v.width, .height = s->v.height,
                                .vertices = FAN_MOST };
    tp_grid_place_rows(&s->grid, &look);
}

static inline int32_t distance(int32_t a, int32_t b)
{
    return a > b ? a - b : b - a;
}

static inline void raise(int32_t *most, int32_t by)
{
    *most = by > *most ? by : *most;
}

#endif
