/* SPDX-License-Identifier: MIT */
/*
 * Stars over a night's dome.
 *
 * The sky is a cube of 6 x 64 x 64 cells.  A hash of the cell decides whether the cell has a
 * star, and its place.  No list is stored, and a pixel examines its own cell only.
 *
 * A star is a round dot of a fixed width in pixels (shade->env.star) at any picture size,
 * so no star falls between two pixels.  Few stars are bright.  Water reflects no stars: the
 * slightest ripple would blur them.
 */
#include "features/sky/sky.h"
#include "shade/env.h"
#include "tidepool/modules.h"

#define CELL_LOG2 10            /* of a face's 65536 units */
#define MARGIN    256           /* distance of stars from their cell's edges */
#define AIR       500           /* height of a direction below which stars are dark, Q1.14 */

TP_ALWAYS_INLINE uint32_t hash(uint32_t n)
{
    n = (n ^ n >> 15) * 0x2c1b3c6du;
    n = (n ^ n >> 12) * 0x297a2d39u;
    return n ^ n >> 15;
}

/* Returns the brightness 0..256 of the dot at (ds, dt) from its centre.  A unit of a face
 * covers a smaller angle farther out; m is the cosine of the angle to the face's centre. */
TP_ALWAYS_INLINE uint32_t dot_brightness(const tp_shade *shade, int32_t ds, int32_t dt,
                                         int32_t cosine)
{
    uint32_t square = (uint32_t)(ds * ds + dt * dt) >> 2;
    uint32_t narrow = (uint32_t)(cosine * cosine) >> 16;          /* Q12 */
    uint32_t down = (uint32_t)((uint64_t)(square * narrow >> 10) * shade->env.star >> 16);
    return down < 256 ? 256 - down : 0;
}

static const uint32_t tints[4] = { 0xffffff, 0xd8e4ff, 0xfff0d8, 0xecf2ff };

/* Returns the hash of the cell at (s, t) of a face. */
TP_ALWAYS_INLINE uint32_t hash_cell(int face, int32_t s, int32_t t)
{
    return hash((uint32_t)(face * 4096 + (t >> CELL_LOG2) * 64 + (s >> CELL_LOG2)) + 1);
}

TP_ALWAYS_INLINE bool has_star(const tp_shade *shade, uint32_t cell_hash)
{
    return (cell_hash & 0xff) < shade->env.stars;
}

/* Returns the light 0x00RRGGBB of a cell's star at (s, t).  `m` is the cosine of the angle
 * to the face's centre, y the height of the direction; Q1.14.  Near the horizon the air
 * absorbs the stars. */
TP_ALWAYS_INLINE uint32_t star_light(const tp_shade *shade, uint32_t h, int32_t s, int32_t t,
                                     int32_t m, int32_t y)
{
    int32_t mask = (1 << CELL_LOG2) - 1, room = mask + 1 - 2 * MARGIN;
    int32_t ds = (s & mask) - MARGIN - (int32_t)((h >> 8 & 0xff) * (uint32_t)room >> 8);
    int32_t dt = (t & mask) - MARGIN - (int32_t)((h >> 16 & 0xff) * (uint32_t)room >> 8);
    uint32_t rank = h >> 24, bright = 56 + (rank * rank * rank >> 16) * 7 / 4;
    uint32_t air = (uint32_t)tp_clamp((y - AIR) >> 3, 0, 256);
    uint32_t share = (dot_brightness(shade, ds, dt, m) * bright >> 8) * air >> 8;

    return tp_colour_scale(tints[h >> 14 & 3], share < 256 ? share : 256);
}

TP_ALWAYS_INLINE uint32_t sample_star(const tp_shade *shade, int32_t x, int32_t y,
                                      int32_t z)
{
    tp_cube_place p = tp_cube_project(shade->env.recip, x, y, z);
    uint32_t h = hash_cell(p.face, p.s, p.t);

    return has_star(shade, h) ? star_light(shade, h, p.s, p.t, p.m, y) : 0;
}

void tp_stage_stars(const tp_shade *shade, tp_run *run)
{
    TP_ASSERT(shade->env.recip != NULL);
    for (int32_t i = 0; i < run->count; i++) {
        if (run->vy[i] < 0)
            run->colour[i] = tp_colour_add(run->colour[i],
                                           sample_star(shade, -run->vx[i], -run->vy[i],
                                                   -run->vz[i]));
    }
}

const tp_stage tp_stars_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_stars(X)
#undef X
};
