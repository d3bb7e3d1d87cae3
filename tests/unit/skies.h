/* SPDX-License-Identifier: MIT */
/* Random sky domes and sky cubes for the shades of tests. */
#ifndef TP_TESTS_SKIES_H
#define TP_TESTS_SKIES_H
#include "../reference/env.h"
#include "tally.h"
#include "shade/env.h"
#include "shades.h"

#define SKY_SIDE 64             /* side of a cube face, px */

typedef struct {
    tp_dome        dome;
    tp_dome_config config;
    tp_cube        cube;
    tp_texture     face[6];
    uint32_t       texel[6][2 * SKY_SIDE * SKY_SIDE];
    uint32_t       recip[TP_RECIP + 2];
} test_sky;

static inline void sky_dome(test_sky *sky, tp_shade *shade, uint64_t *state)
{
    sky->config = (tp_dome_config){
        .kind = (tp_dome_kind)chance_int(state, 0, 2),
        .horizon = (uint32_t)random_next(state) & 0xffffff,
        .zenith = (uint32_t)random_next(state) & 0xffffff,
        .light = (uint32_t)random_next(state) & 0xffffff,
        .sun = chance_fx(state, 0, 16),
    };
    tp_dome_init(&sky->dome, &sky->config);
    tp_recip_init(sky->recip);
    shade->env = (tp_env){ .kind = TP_ENV_DOME, .dome = &sky->dome, .recip = sky->recip,
                           .beyond = (uint32_t)chance_int(state, 0, 16 * 256) };
}

/* Makes a cube sky of faces painted by `paint`; only mipmap level 0 matters. */
static inline void sky_cube(test_sky *sky, tp_shade *shade,
                            uint32_t (*paint)(ref_dir d, void *with), void *with)
{
    const tp_texture *face[6];
    static uint32_t pixels[SKY_SIDE * SKY_SIDE];

    for (int f = 0; f < 6; f++) {
        for (int i = 0; i < SKY_SIDE * SKY_SIDE; i++)
            pixels[i] = paint(ref_cube_to(f, (i % SKY_SIDE + 0.5) / SKY_SIDE,
                                          ((double)(i / SKY_SIDE) + 0.5) / SKY_SIDE), with);
        if (tp_texture_init(&sky->face[f], pixels, SKY_SIDE, SKY_SIDE, sky->texel[f],
                            tp_texture_bytes(SKY_SIDE, SKY_SIDE), NULL))
            abort();
        face[f] = &sky->face[f];
    }
    tp_cube_init(&sky->cube, face);
    tp_recip_init(sky->recip);
    shade->env = (tp_env){ .kind = TP_ENV_CUBE, .cube = &sky->cube, .recip = sky->recip };
}

static inline uint32_t sky_noise(ref_dir d, void *state)
{
    (void)d;
    return (uint32_t)random_next(state);
}

static inline ref_dir sky_direction(uint64_t *state)
{
    ref_dir d;
    do
        d = (ref_dir){ chance_double(state, -1, 1), chance_double(state, -1, 1),
                       chance_double(state, -1, 1) };
    while (ref_dir_dot(d, d) > 1 || ref_dir_dot(d, d) < 0.01);
    return ref_unit(d);
}

static inline int32_t sky_q14(double x)
{
    return (int32_t)lround(x * Q14);
}
#endif
