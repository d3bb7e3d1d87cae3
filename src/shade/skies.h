/* SPDX-License-Identifier: MIT */
/* What an environment is made of: tables of a generated sky, or six pictures.  env.h
 * looks into them, dome.c and cube.c fill them. */
#ifndef TP_SHADE_SKIES_H
#define TP_SHADE_SKIES_H
#include "tidepool/assets.h"

#define TP_SKY       256        /* entries: horizon to zenith, by the sine of elevation */
#define TP_GLOW_STEP 32         /* entries of the glow to a doubling of the square */
#define TP_GLOW_LOG2 14         /* of the least square, 0.45 degrees from the light */
#define TP_GLOW      (TP_GLOW_STEP * (30 - TP_GLOW_LOG2))

typedef enum { TP_DOME_DAY, TP_DOME_DUSK, TP_DOME_NIGHT } tp_dome_kind;

typedef struct {
    tp_dome_kind kind;
    uint32_t horizon, zenith;   /* of day */
    uint32_t light;             /* the light's colour */
    tp_fx    sun;               /* intensity of its disc, 0..TP_WHITES */
} tp_dome_config;

/* A generated sky: two gradients, that on the light's side and the other, and what is
 * added around the light by the square of the distance to it, on the unit sphere. */
typedef struct {
    uint32_t away[TP_SKY + 1], towards[TP_SKY + 1];
    uint32_t glow[TP_GLOW + 1];         /* 0xAARRGGBB, the disc included */
    tp_dome_config made_of;
} tp_dome;

#define TP_RECIP 256            /* 1 / m for m from 1/2 to 1 */
#define TP_CUBE_FACES 6         /* +x -x +y -y +z -z: east west up down south north */

typedef struct {
    const tp_texture *face[TP_CUBE_FACES];
    uint32_t mask[TP_CUBE_FACES];       /* of a texel: without alpha where all are solid */
    int32_t  lod;               /* level of a picture as the eye sees it, Q8 */
} tp_cube;

typedef enum { TP_ENV_GRADIENT, TP_ENV_DOME, TP_ENV_CUBE } tp_env_kind;

/* All 0 is the plain gradient. */
typedef struct {
    tp_env_kind     kind;
    const tp_dome  *dome;
    const tp_cube  *cube;
    const uint32_t *recip;      /* TP_RECIP + 2 entries: cubes and stars */
    uint32_t        least;      /* square that mirrors see of the dome's glow, at least */
    uint32_t        beyond;     /* whites that an alpha of 1 adds, Q8; 0: no HDR [F8] */
    uint32_t        stars;      /* of 256 cells, so many have one */
    uint32_t        star;       /* 2^24 over the square of a star's radius on its face */
} tp_env;

#define TP_WHITES 16            /* an alpha of 1 is light of so many whites more */

/* Single entries, for tables smaller than the sky's: the gradient at a sine in 256ths, and
 * the glow at a square of 28 places. */
uint32_t tp_dome_gradient(const tp_dome_config *config, bool towards, int32_t sine);
uint32_t tp_dome_glow(const tp_dome_config *config, uint32_t square);

void tp_dome_init(tp_dome *dome, const tp_dome_config *config);

#define TP_DISC_END 131072u     /* the square where the disc has ended: 1.27 degrees */

/* The square of entry i of the glow. */
uint32_t tp_glow_square(uint32_t i);

/* False: a face is missing, there is no cube. */
bool tp_cube_init(tp_cube *cube, const tp_texture *const face[TP_CUBE_FACES]);
void tp_recip_init(uint32_t recip[TP_RECIP + 2]);
#endif
