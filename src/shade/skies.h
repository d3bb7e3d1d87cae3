/* SPDX-License-Identifier: MIT */
/* Data of an environment: the tables of a generated sky, or six pictures.  skies.c
 * fills the data, env.h looks colours up. */
#ifndef TP_SHADE_SKIES_H
#define TP_SHADE_SKIES_H
#include "tidepool/assets.h"

#define TP_SKY       256        /* entries: horizon to zenith, by the sine of elevation */
#define TP_GLOW_STEP 32         /* glow entries per doubling of the squared chord */
#define TP_GLOW_LOG2 14         /* log2 of the least squared chord, 0.45 degrees */
#define TP_GLOW      (TP_GLOW_STEP * (30 - TP_GLOW_LOG2))

typedef enum { TP_DOME_DAY, TP_DOME_DUSK, TP_DOME_NIGHT } tp_dome_kind;

typedef struct {
    tp_dome_kind kind;
    uint32_t horizon, zenith;   /* colours of the day */
    uint32_t light;             /* colour of sun or moon */
    tp_fx    sun;               /* intensity of the disc, 0..TP_WHITES */
} tp_dome_config;

/* A generated sky: a gradient on the light's side, a gradient on the other side, and the
 * glow around the light, indexed by the squared chord to the light on the unit sphere. */
typedef struct {
    uint32_t away[TP_SKY + 1], towards[TP_SKY + 1];
    uint32_t glow[TP_GLOW + 1];         /* 0xAARRGGBB, includes the disc */
    tp_dome_config made_of;
} tp_dome;

#define TP_RECIP 256            /* entries: 1 / m for m from 1/2 to 1 */
#define TP_CUBE_FACES 6         /* +x -x +y -y +z -z: east west up down south north */

typedef struct {
    const tp_texture *face[TP_CUBE_FACES];
    uint32_t mask[TP_CUBE_FACES];       /* texel mask: no alpha if the face is solid */
    int32_t  lod;               /* mipmap level of a face as the eye sees it, Q8 */
} tp_cube;

typedef enum { TP_ENV_GRADIENT, TP_ENV_DOME, TP_ENV_CUBE } tp_env_kind;

/* The environment of a frame.  All zero is the plain gradient. */
typedef struct {
    tp_env_kind     kind;
    const tp_dome  *dome;
    const tp_cube  *cube;
    const uint32_t *recip;      /* TP_RECIP + 2 entries: for cubes and stars */
    uint32_t        least;      /* least squared chord of mirrored glow: no disc */
    uint32_t        beyond;     /* whites that an alpha of 1 adds, Q8; 0: no HDR [F8] */
    uint32_t        stars;      /* number of stars per 256 cells */
    uint32_t        star;       /* 2^24 / (star radius on its face)^2 */
} tp_env;

#define TP_WHITES 16            /* an alpha of 1 is light of 16 whites more */

/* Single table entries, for tables smaller than the sky's: the gradient at a sine in
 * 256ths; the glow at a squared chord in Q28. */
uint32_t tp_dome_gradient(const tp_dome_config *config, bool towards_light, int32_t sine);
uint32_t tp_dome_glow(const tp_dome_config *config, uint32_t squared_chord);

void tp_dome_init(tp_dome *dome, const tp_dome_config *config);

#define TP_DISC_END 131072u     /* squared chord at the disc's outer edge: 1.27 degrees */

/* Returns the squared chord of entry i of the glow, Q28. */
uint32_t tp_glow_entry_squared_chord(uint32_t i);

/* Returns false if a face is missing; the cube is then not usable. */
bool tp_cube_init(tp_cube *cube, const tp_texture *const face[TP_CUBE_FACES]);
void tp_recip_init(uint32_t recip[TP_RECIP + 2]);
#endif
