/* SPDX-License-Identifier: MIT */
/* Shading: a list of stages, each one small loop over a run of samples.
 *
 * A run is up to TP_RUN neighbouring samples of one kind in one row.  It never crosses
 * a multiple of TP_RUN, and what a stage works out once for several pixels it works out
 * at multiples of 16 or 32: so a run's place in its tile never shows.  Stages hand values on
 * through the run's arrays; a stage that a scene does not use is not in the list.
 *
 * Water goes through its list in this order, as far as the scene needs it:
 *     bend (ls lt), layers (colour), pool_bump and ripple (sx sz), view (vx vy vz lv),
 *     light (colour nv up glint), behind (what is seen through it, into colour),
 *     mirror; or in parts: reflect (mirror rx rz), mirrored (objects over it), fresnel
 *     (mirror into colour), for which slopes (sx sz) stands in for ripples; then foam,
 *     glint, haze, expose.
 * Seen from below it is: pool_bump, ripple, view, below, expose.  All else has a stage of
 * its own that does everything, then haze (in the water absorb) and expose.
 *
 * Unit vectors are Q1.14, slopes Q3.12, shares 0..256, colours as colour.h has them; the
 * mirror's alpha is light beyond white [F8]. */
#ifndef TP_SHADE_H
#define TP_SHADE_H
#include "base/base.h"
#include "shade/colour.h"
#include "shade/inside.h"
#include "shade/layer.h"
#include "shade/skies.h"
#include "shade/wide.h"

/* Shorter runs, of 32 or 16, take less stack where that counts: the same bits. */
#ifndef TP_RUN
#define TP_RUN 64
#endif
_Static_assert(TP_RUN == 64 || TP_RUN == 32 || TP_RUN == 16, "TP_RUN");

typedef struct tp_run {
    int32_t  x, y;              /* of the first sample, in the picture */
    int32_t  count;
    uint32_t material;          /* of a mesh */
    struct {                    /* of quick stages: neighbours of one distance */
        int16_t far;            /* level of the ground at lod 0, Q8 */
        uint8_t end, places;    /* column, and as many places as there are before it */
    } span[TP_RUN / 16];
    uint32_t spans;
    const void *mine;           /* data of the module whose stage runs */
    const uint32_t *key, *s, *t, *n;    /* the samples */
    const uint32_t *ls, *lt;    /* where layers are sampled: s and t, unless bent */
    uint32_t colour[TP_RUN];
    union {
        struct {
            int16_t  vx[TP_RUN], vy[TP_RUN], vz[TP_RUN];    /* to the eye */
            int16_t  lv[TP_RUN];        /* light . view */
        };
        struct { uint32_t back[TP_RUN]; int32_t view_y[TP_RUN]; };  /* quick_light.h */
    };
    union {                     /* slopes, once a ripple has bent them */
        struct { int16_t sx[TP_RUN], sz[TP_RUN]; };
        uint32_t slope[TP_RUN]; /* of quick stages: x:z, Q3.12 each */
    };
    union {
        struct {
            int16_t  nv[TP_RUN];        /* normal . view, 0..1 */
            int16_t  up[TP_RUN];        /* y of the mirrored view, -1..1 */
        };
        int32_t view_l[TP_RUN];         /* quick_light.h */
    };
    union {
        uint16_t glint[TP_RUN]; /* specular, 256 is the light's full colour, or more */
        uint32_t even[TP_RUN / 2 + 1];  /* quick colours of every second column */
    };
    union {                     /* once layers are laid, bent places are not needed */
        struct {
            int16_t  rx[TP_RUN], rz[TP_RUN];    /* of the mirrored view, with up */
            uint32_t mirror[TP_RUN];            /* what comes from there, 0xAARRGGBB */
        };
        struct { uint32_t bent_s[TP_RUN], bent_t[TP_RUN]; };
        uint32_t place[2 * TP_RUN];         /* the same, of quick stages */
        struct { uint32_t half[TP_RUN], column[TP_RUN]; };  /* quick_light.h */
    };
} tp_run;

/* The view's rays in a frame of axes: the world's, or a mesh's. */
typedef struct {
    tp_dir3 right, up, back;
    int32_t lx, ly, lz;         /* light, Q1.14 */
} tp_view_axes;

typedef struct {
    uint32_t diffuse, specular; /* colours */
    int32_t  lod;
    int32_t  bump;              /* 256 is as drawn */
    const tp_texture *diffuse_map, *normal_map;
    const uint8_t *gloss;       /* TP_GLOSS entries */
} tp_solid;

/* A picture at half the picture's resolution (or a quarter, then places in it are halved
 * first), drawn before any tile, that water looks
 * into: 0xAARRGGBB, alpha the share that something covers.  Half pixel (i, j) stands for
 * the picture's pixels 2 i, 2 i + 1 and 2 j, 2 j + 1. */
typedef struct {
    const uint32_t *colour;     /* row-major from (x0, y0); NULL: nothing is there */
    int32_t x0, y0, x1, y1;     /* in half pixels, x1 and y1 not included */
    int32_t coarser;            /* 1: of a quarter's */
} tp_half;

#define TP_SHINE 1024           /* entries: the lobe over 0..1 */
#define TP_GLOSS 256
#define TP_STEEP 512            /* 1/sqrt(1 + q), q in 0..4 */

typedef struct tp_shade {
    int32_t  u0, v0;            /* the picture's centre, 28.4 */
    int32_t  focal;             /* 28.4 */
    uint32_t per_focal;         /* 2^32 / focal */
    tp_view_axes world;
    int32_t  zi_log;            /* log2 of the depth at zi = 1, Q8 */

    uint32_t water_colour;      /* multiplies the first layer */
    uint32_t light_colour;
    int32_t  ambient;           /* 0..256 */
    int32_t  mirror;            /* share of the reflection, 0..256 */


    tp_vec3  eye;
    const tp_inside *inside;    /* what lies in and under the water, or NULL */
    const tp_caustic *caustic;  /* light on its floor; NULL: even */

    const tp_entry16 *shine;    /* TP_SHINE + 1: 256 at 1, times the specular; or NULL */
    const tp_entry8 *fresnel;           /* share of the reflection at N.V = i / 256 */
    uint32_t sky[TP_SKY + 1];
    tp_env   env;               /* what else the sky is */
    const struct tp_quick_light *quick; /* of quick light alone */
} tp_shade;

/* -- tables of every scene ----------------------------------------------------------- */

extern const tp_entry16 tp_steep_table[TP_STEEP + 1];       /* Q1.14 */
extern const tp_entry8 tp_fresnel_table[257];               /* the exact law, */
extern const tp_entry8 tp_schlick_table[257];               /* and the shortcut [F2] */
extern const uint8_t tp_drop_gloss[TP_GLOSS];               /* of drops and land */

/* -- for the frame, that fills the others -------------------------------------------- */

void tp_shade_shine(tp_entry16 shine[TP_SHINE + 1], tp_fx shininess, tp_fx strength);
void tp_shade_sky(tp_shade *shade, uint32_t horizon, uint32_t zenith);
void tp_shade_gloss(uint8_t gloss[TP_GLOSS], tp_fx shininess);
void tp_shade_shine_blinn(tp_entry16 shine[TP_SHINE + 1], tp_fx shininess, tp_fx strength);
void tp_shade_gloss_blinn(uint8_t gloss[TP_GLOSS], tp_fx shininess);

/* -- for stages ---------------------------------------------------------------------- */

void tp_view_run(const tp_shade *shade, const tp_view_axes *axes, tp_run *run);

/* Where the 16 columns of sample i end, or the run. */
static inline int32_t tp_block_end(const tp_run *run, int32_t i)
{
    TP_ASSERT(i < run->count);
    int32_t end = i + 16 - ((run->x + i) & 15);
    return end < run->count ? end : run->count;
}

/* Q16 of so many sixteenths of a pixel over the focal length. */
static inline int64_t tp_over_focal(const tp_shade *shade, int32_t sixteenths)
{
    return sixteenths * (int64_t)shade->per_focal >> 16;
}

/* The unit vector to the eye from pixel (x, y), and its product with the light. */
typedef struct {
    int32_t x, y, z, l;
} tp_ray;

tp_ray tp_view_ray(const tp_shade *shade, const tp_view_axes *axes, int32_t x, int32_t y);
#endif
