/* SPDX-License-Identifier: MIT */
/* Access to the field from outside: cover by place, means, the map of the floor. */
#include "base/base.h"
#include "features/foam/foam_visit.h"
#include "waves/coastal_tables.h"
#include "world/pools.h"

const tp_foam *tp_world_foam(const tp_world *world)
{
    return tp_foam_of_world(world);
}

/* Returns the distance of a place from the window's low side, cells, Q8.  The place may
 * lie outside. */
static int64_t window_offset_q8(const tp_foam *foam, tp_fx place, int32_t first,
                                int64_t drift)
{
    int64_t low = (int64_t)first * foam->cell + (drift >> 16);
    return ((int64_t)place - low) * 256 / foam->cell;
}

/* Adds cover to each cell with its centre within the radius, less towards the rim. */
void tp_foam_add_blob(tp_foam *foam, tp_fx x, tp_fx z, tp_fx radius, uint32_t cover)
{
    TP_ASSERT(radius >= 0 && cover <= 255);
    int64_t u = window_offset_q8(foam, x, foam->first_x, foam->drift_x);
    int64_t w = window_offset_q8(foam, z, foam->first_z, foam->drift_z);
    int64_t r = (int64_t)radius * 256 / foam->cell, cells = foam->cells;

    r = r < 192 ? 192 : r > 16 * 256 ? 16 * 256 : r;
    for (int64_t j = (w - r) >> 8; j <= (w + r) >> 8; j++) {
        for (int64_t i = (u - r) >> 8; i <= (u + r) >> 8; i++) {
            int64_t dx = i * 256 + 128 - u, dz = j * 256 + 128 - w;
            int64_t left = r * r - dx * dx - dz * dz;
            if (left <= 0 || i < 0 || j < 0 || i >= cells || j >= cells)
                continue;
            uint32_t col = tp_foam_mod(foam->first_x + (int32_t)i, foam->cells);
            uint32_t row = tp_foam_mod(foam->first_z + (int32_t)j, foam->cells);
            uint8_t *at = tp_foam_cover(foam) + (size_t)row * foam->cells + col;
            uint32_t more = *at + (uint32_t)(cover * left / (r * r));
            *at = (uint8_t)(more < 255 ? more : 255);
        }
    }
}

const struct tp_water_foam_splashes tp_water_foam_splashes = { tp_foam_add_blob };

uint8_t tp_foam_sample(const tp_foam *foam, tp_fx x, tp_fx z)
{
    int64_t u = window_offset_q8(foam, x, foam->first_x, foam->drift_x);
    int64_t w = window_offset_q8(foam, z, foam->first_z, foam->drift_z);
    const uint8_t *cover = (const uint8_t *)(foam + 1);
    int64_t most = (int64_t)foam->cells * 256, sum = 0;

    if (u < 0 || w < 0 || u >= most || w >= most)
        return 0;
    int32_t s = (int32_t)u - 128, t = (int32_t)w - 128;
    for (int32_t k = 0; k < 4; k++) {
        uint32_t col = tp_foam_mod(foam->first_x + (s >> 8) + (k & 1), foam->cells);
        uint32_t row = tp_foam_mod(foam->first_z + (t >> 8) + (k >> 1), foam->cells);
        int32_t  fs = k & 1 ? s & 255 : 256 - (s & 255);
        int32_t  ft = k >> 1 ? t & 255 : 256 - (t & 255);
        sum += (int64_t)cover[(size_t)row * foam->cells + col] * fs * ft;
    }
    return (uint8_t)((sum + 0x8000) >> 16);
}

bool tp_foam_is_empty(const uint8_t *cover, size_t bytes)
{
    uint64_t any = 0, word;

    for (; bytes >= 8; bytes -= 8, cover += 8) {
        memcpy(&word, cover, 8);
        any |= word;
    }
    for (; bytes > 0; bytes--)
        any |= *cover++;
    return any == 0;
}

uint32_t tp_foam_mean(const tp_foam *foam)
{
    const uint64_t most = (uint64_t)255 << 8;
    uint64_t sum = 0;

    for (int q = 0; q < TP_FOAM_TICKS; q++)
        sum += foam->sum[q];
    sum = sum * 256 / ((uint64_t)foam->cells * foam->cells);
    return (uint32_t)(sum < most ? sum : most);
}

const tp_coastal_water *tp_foam_map(const tp_world *world)
{
    const tp_coastal_water *coastal = tp_world_coastal(world);
    return coastal && coastal->map_cols && !tp_world_pool(world) ? coastal : NULL;
}

uint32_t tp_foam_open_mean(const tp_foam *foam, const tp_world *world)
{
    if (!tp_foam_map(world))
        return tp_foam_mean(foam);
    const tp_foam_open *open = tp_foam_open_water(foam);
    const uint64_t mean = open->count ? ((uint64_t)open->sum << 16) / open->count : 0;
    return mean < 255 << 8 ? (uint32_t)mean : 255 << 8;
}
