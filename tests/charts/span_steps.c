/* SPDX-License-Identifier: MIT */
/* Compiles src/raster/span.c once for each step, in place of the library's copy; the names
 * of the functions end in _STEP. */
#include "raster/raster.h"
#include "tests/charts/span.h"
#include "tests/charts/span_true.h"

int32_t span_step = 16;

#define CORNERS                                                                          \
    const tp_screen_vertex *a, const tp_screen_vertex *b, const tp_screen_vertex *c
#define DECLARE(step) \
    void tp_tri_water_##step(const tp_gbuffer *tile, CORNERS); \
    void tp_tri_solid_##step(const tp_gbuffer *tile, CORNERS, uint32_t mark, \
                             uint32_t face, int opacity); \
    void tp_tri_solid_wide_##step(const tp_gbuffer *tile, CORNERS, uint32_t mark, \
                                  uint32_t face, int opacity); \
    void tp_tri_depth_only_##step(const tp_gbuffer *tile, CORNERS); \
    void tp_gbuffer_clear_##step(const tp_gbuffer *tile);
DECLARE(0)
DECLARE(1)
DECLARE(8)
DECLARE(16)
DECLARE(32)

void tp_tri_water(const tp_gbuffer *tile, CORNERS)
{
    switch (span_step) {
    case SPAN_TRUE: span_true(tile, a, b, c, tp_tri_water_1); break;
    case 0:  tp_tri_water_0(tile, a, b, c); break;
    case 1:  tp_tri_water_1(tile, a, b, c); break;
    case 8:  tp_tri_water_8(tile, a, b, c); break;
    case 32: tp_tri_water_32(tile, a, b, c); break;
    default: tp_tri_water_16(tile, a, b, c);
    }
}

/* Solids are drawn by the engine's step. */
void tp_tri_solid(const tp_gbuffer *tile, CORNERS, uint32_t mark, uint32_t face,
                  int opacity)
{
    tp_tri_solid_16(tile, a, b, c, mark, face, opacity);
}

void tp_tri_solid_wide(const tp_gbuffer *tile, CORNERS, uint32_t mark, uint32_t face,
                       int opacity)
{
    tp_tri_solid_wide_16(tile, a, b, c, mark, face, opacity);
}

void tp_tri_depth_only(const tp_gbuffer *tile, CORNERS)
{
    tp_tri_depth_only_16(tile, a, b, c);
}

void tp_gbuffer_clear(const tp_gbuffer *tile)
{
    tp_gbuffer_clear_16(tile);
}
