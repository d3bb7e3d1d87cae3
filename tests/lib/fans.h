/* SPDX-License-Identifier: MIT */
/* Fans over random swells, with all data of their views, for tests of vertices. */
#ifndef TP_TESTS_LIB_FANS_H
#define TP_TESTS_LIB_FANS_H
#include "tests/lib/camera.h"
#include "tests/lib/grids.h"
#include "tests/lib/scenes.h"
#include "view/fan.h"
#include "view/wave_models.h"

enum { FAN_MOST = 2000 };       /* vertices */

/* A fan with its memory and all the data of its view. */
typedef struct {
    tp_grid grid;
    void   *block;
    test_view v;
    tp_deep_water deep;
    tp_turn phases[TP_WAVES];
    tp_surface surface;
    tp_grid_view look;
} fan_sea;

/* Makes a sea of `count` random waves, of amplitudes from 0.01 to 1 m if `low`. */
static inline void fan_sea_make_swells(fan_sea *s, int count, bool low, uint64_t *chance)
{
    tp_wave waves[TP_WAVES];

    for (int i = 0; i < count; i++) {
        waves[i] = chance_wave(chance);
        if (low)
            waves[i].amplitude = chance_scale(chance, 0.01, 1);
    }
    tp_deep_water_init(&s->deep, waves, (uint32_t)count, TP_FX(9.81));
    tp_deep_water_phases(&s->deep, random_next(chance) >> 20, 0, s->phases);
}

/* Lays out the fan's memory; the caller frees the block. */
static inline void fan_sea_lay_out_grid(fan_sea *s, uint32_t vertices)
{
    s->look.vertices = vertices;
    s->block = grid_block(&s->grid, vertices, false);
}

/* Points the fan's view to the sea, which must not move in memory afterwards. */
static inline void fan_sea_point_view(fan_sea *s)
{
    s->surface =
        (tp_surface){ .by = &tp_program_all.water, .deep = &s->deep, .phases = s->phases };
    s->look = (tp_grid_view){ .projection = &s->v.projection, .surface = &s->surface,
                              .width = s->v.width, .height = s->v.height,
                              .vertices = s->look.vertices };
}

/* Places the fan and evaluates its vertices. */
static inline void fan_sea_place(fan_sea *s)
{
    fan_sea_point_view(s);
    tp_grid_evaluate_vertices(&s->grid, &s->look);
}

/* Lays out a fan over `count` low swells and places its rows; the caller frees the
 * block. */
static inline void fan_sea_lay_out(fan_sea *s, int count, uint64_t *chance)
{
    *s = (fan_sea){ .v = view_any(chance) };
    fan_sea_make_swells(s, count, true, chance);
    fan_sea_lay_out_grid(s, FAN_MOST);
    fan_sea_point_view(s);
    tp_grid_place_rows(&s->grid, &s->look);
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
