/* SPDX-License-Identifier: MIT */
/*
 * Shading: a shader list, each stage a small loop over a run of samples; and the data of
 * the environment that the samples mirror.
 *
 * A run is up to TP_RUN neighbouring samples of one kind in one row.  A run never crosses
 * a multiple of TP_RUN, and values shared by several pixels are computed at multiples of
 * 16 or 32 columns: a run's position in its tile does not change the picture.  Stages pass
 * values on in the run's arrays.  The list has only the stages that the scene uses.
 *
 * Order of the water's list; the scene decides on the stages that are present:
 *     bend (ls lt), layers (colour), pool_bump and ripple (sx sz), view (vx vy vz lv),
 *     light (colour nv up glint), refract (adds the colours seen through the water),
 *     mirror_gradient_sky; or in parts: reflect (mirror rx rz), mirrored (objects over the
 *     sky), fresnel (mirror into colour), for which slopes (sx sz) stands in for ripples;
 *     then foam, glint, haze, expose.
 * The list of water seen from below: pool_bump, ripple, view, underside, expose.  Any other
 * kind of sample has one stage that computes its colour, then haze (absorb in the water)
 * and expose.
 *
 * Unit vectors are Q1.14, slopes Q3.12, shares 0..256, colours as in colour.h.  The
 * mirror's alpha is light beyond white [F8].
 */
#ifndef TP_SHADE_SHADE_H
#define TP_SHADE_SHADE_H
#include <stdint.h>
#include "base/base.h"
#include "shade/colour.h"
#include "shade/optics.h"
#include "tidepool/assets.h"
#include "view/projection.h"
#include "view/rough.h"

/* -- data of an environment ---------------------------------------------------------- */

/* The tables of a generated sky, or six pictures.  skies.c fills the data, env.h looks
 * colours up. */

#define TP_SKY       256        /* entries: horizon to zenith, by the sine of elevation */
#define TP_GLOW_STEP 32         /* glow entries per doubling of the squared chord */
#define TP_GLOW_LOG2 14         /* log2 of the least squared chord, 0.45 degrees */
#define TP_GLOW      (TP_GLOW_STEP * (30 - TP_GLOW_LOG2))

typedef enum { TP_DOME_DAY, TP_DOME_DUSK, TP_DOME_NIGHT } tp_dome_kind;

typedef struct {
    int32_t  kind;              /* tp_dome_kind */
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

/* Single table entries, for tables smaller than the sky's: the colour of the gradient at a
 * sine in 256ths; the colour of the glow at a squared chord in Q28, with light beyond white
 * in the alpha. */
uint32_t tp_dome_gradient(const tp_dome_config *config, bool towards_light, int32_t sine);
uint32_t tp_dome_glow(const tp_dome_config *config, uint32_t squared_chord);

void tp_dome_init(tp_dome *dome, const tp_dome_config *config);

#define TP_DISC_END 131072u     /* squared chord at the disc's outer edge: 1.27 degrees */

/* Returns the squared chord of entry i of the glow, Q28. */
uint32_t tp_glow_entry_squared_chord(uint32_t i);

/* Returns false if a face is missing; the cube is then not usable. */
bool tp_cube_init(tp_cube *cube, const tp_texture *const face[TP_CUBE_FACES]);
void tp_recip_init(uint32_t recip[TP_RECIP + 2]);

/* -- drifting textures on the water, as a frame stores them -------------------------- */

/* A texture with the numbers that a span stage samples it by. */
typedef struct {
    const tp_texture *texture;
    uint32_t per_metre;         /* repeats a metre, Q0.32 over Q16.16: s x this wraps */
    uint32_t drift_s, drift_t;  /* offsets in repeats, Q0.32 */
    int32_t  lod;               /* mipmap level at 1 m, Q8, for tp_mip_level_choose */
} tp_layer;

/* -- a run, and the numbers of a picture --------------------------------------------- */

/* Largest run.  32 or 16 take less stack on small targets; the picture is the same to the
 * bit. */
#ifndef TP_RUN
#define TP_RUN 64
#endif
_Static_assert(TP_RUN == 64 || TP_RUN == 32 || TP_RUN == 16, "TP_RUN");

typedef struct tp_run {
    int32_t  x, y;              /* picture position of the first sample, px */
    int32_t  count;
    uint32_t material;          /* material index of a mesh */
    struct {                    /* fast stages: neighbours of one mipmap level */
        int16_t mip_offset;     /* mipmap level minus the texture's lod, Q8 */
        uint8_t end, places;    /* end column; stored positions up to there */
    } span[TP_RUN / 16];
    uint32_t spans;
    uint32_t objects;           /* fast stages: bit k: `mirror` has the mirrored objects of
                                 * the run's block k, see tp_block_number */
    const void *mine;           /* data of the module whose stage runs */
    const uint32_t *key, *s, *t, *n;    /* the G-buffer: depth_stencil, s, t, normal */
    const uint32_t *ls, *lt;    /* positions for layers: s and t, unless bent */
    uint32_t colour[TP_RUN];
    union {
        struct {
            int16_t  vx[TP_RUN], vy[TP_RUN], vz[TP_RUN];    /* unit vector to the eye */
            int16_t  lv[TP_RUN];        /* light . view */
        };
        struct { uint32_t back[TP_RUN]; int32_t view_y[TP_RUN]; };  /* fast_shading.h */
    };
    union {                     /* slopes, valid after a ripple stage */
        struct { int16_t sx[TP_RUN], sz[TP_RUN]; };
        uint32_t slope[TP_RUN]; /* fast stages: x:z, Q3.12 each */
    };
    union {
        struct {
            int16_t  nv[TP_RUN];        /* normal . view, 0..1 */
            int16_t  up[TP_RUN];        /* y of the mirrored view, -1..1 */
        };
        int32_t view_l[TP_RUN];         /* fast_shading.h */
    };
    union {
        uint16_t glint[TP_RUN]; /* specular, 256 is the light's full colour, or more */
        uint32_t even[TP_RUN / 2 + 1];  /* fast stages: colours of even columns */
    };
    union {                     /* bent positions are unused after the layers */
        struct {
            int16_t  rx[TP_RUN], rz[TP_RUN];    /* x and z of the mirrored view; y is up */
            uint32_t mirror[TP_RUN];            /* mirrored colour, 0xAARRGGBB */
        };
        struct { uint32_t bent_s[TP_RUN], bent_t[TP_RUN]; };
        uint32_t place[2 * TP_RUN];         /* bent positions of fast stages */
        struct { uint32_t half[TP_RUN], water[TP_RUN]; };  /* fast_shading.h */
    };
} tp_run;

/* Axes of the view in a coordinate system: the world's or a mesh's. */
typedef struct {
    tp_dir3 right, up, back;
    int32_t lx, ly, lz;         /* direction to the light, Q1.14 */
} tp_view_axes;

typedef struct {
    uint32_t diffuse, specular; /* colours, 0x00RRGGBB */
    int32_t  lod;
    int32_t  bump;              /* normal map strength, 256 is as drawn */
    const tp_texture *diffuse_map, *normal_map;
    const uint8_t *gloss;       /* TP_GLOSS entries */
} tp_solid;

/* A planar map: a picture drawn before any tile, that the water's stages sample.
 * 0xAARRGGBB; alpha is the coverage.  With s = 2^halvings, 1, 2 or 4, map pixel (i, j)
 * stands for the picture's pixels s i .. s i + s - 1 and s j .. s j + s - 1. */
typedef struct {
    const uint32_t *colour;     /* row-major from (x0, y0); NULL: empty map */
    int32_t x0, y0, x1, y1;     /* box in map pixels, x1 and y1 excluded */
    int32_t halvings;           /* of the picture's sides: 0, 1 or 2 */
} tp_planar_map;

#define TP_SHINE 1024           /* entries of the lobe's table over 0..1 */
#define TP_GLOSS 256
#define TP_STEEP 512            /* entries of 1/sqrt(1 + q), q in 0..4 */

/* The water's lobe.  weak, strong: of the peak of a wider lobe, Q14; see rough_lobe.h. */
typedef struct {
    uint32_t exponent;          /* 1..1000 */
    int32_t  weak, strong;
} tp_lobe_form;

/* Slope variance that the mipmap levels of the ripples have lost, an axis, Q24.
 * gain_square: its factor, 16.16; lod: the ripples' level at 1 m, Q8. */
typedef struct {
    uint32_t lost[TP_TEXTURE_LEVELS], gain_square;
    int32_t  lod, levels;
} tp_ripple_variance;

typedef struct tp_shade {
    int32_t  u0, v0;            /* picture centre, px, 28.4 */
    int32_t  focal;             /* focal length, px, 28.4 */
    uint32_t per_focal;         /* 2^32 / focal */
    tp_view_axes world;
    int32_t  zi_log;            /* log2 of the depth at zi = 1, Q8 */

    uint32_t water_colour;      /* multiplies the first layer */
    uint32_t light_colour;
    int32_t  ambient;           /* ambient light, 0..256 */
    int32_t  mirror;            /* strength of the reflection, 0..256 */

    tp_vec3  eye;
    const tp_underwater *underwater;    /* the water volume and its floor, or NULL */
    const tp_caustic *caustic;  /* caustics map; NULL: even light */
    const tp_filtered_waves *filtered;  /* waves missing in the grid; NULL: none */
    const tp_ripple_variance *ripple;   /* NULL: no ripples */
    tp_lobe_form lobe;

    const tp_entry16 *shine;    /* TP_SHINE + 1: 256 at 1, times the specular; or NULL */
    int32_t  dark;              /* number of its first entries that are 0; fewer is safe */
    const tp_entry8 *fresnel;   /* reflected share at N.V = i / 256; NULL: no stage of this
                                 * picture reads it */
    const uint32_t *sky;        /* TP_SKY + 1: the gradient */
    tp_env   env;               /* sky beyond the gradient */
    const struct tp_quick_light *quick; /* fast lighting alone */
    bool     evens_only;        /* true: light of every second column leaves tp_run.even and
                                 * fills no colours */
} tp_shade;

/* -- tables shared by all scenes ----------------------------------------------------- */

extern const tp_entry16 tp_steep_table[TP_STEEP + 1];       /* Q1.14 */
extern const tp_entry8 tp_fresnel_table[257];               /* the exact law [F1] */
extern const tp_entry8 tp_schlick_table[257];               /* Schlick's law [F2] */
extern const uint8_t tp_drop_gloss[TP_GLOSS];               /* for drops and land */

/* -- tables filled for a scene ------------------------------------------------------- */

/* Called by the frame and by modules: optics.c, skies.c. */

void tp_shade_shine(tp_entry16 shine[TP_SHINE + 1], tp_fx shininess, tp_fx strength);
void tp_shade_sky(uint32_t sky[TP_SKY + 1], uint32_t horizon, uint32_t zenith);
void tp_shade_gloss(uint8_t gloss[TP_GLOSS], tp_fx shininess);
void tp_shade_shine_blinn(tp_entry16 shine[TP_SHINE + 1], tp_fx shininess, tp_fx strength);
void tp_shade_gloss_blinn(uint8_t gloss[TP_GLOSS], tp_fx shininess);

/* -- called by stages ---------------------------------------------------------------- */

void tp_run_fill_vectors_to_eye(const tp_shade *shade, const tp_view_axes *axes,
                                tp_run *run);

/* Fills vx, vy and vz in world axes, and leaves lv as it is. */
void tp_run_fill_sky_vectors(const tp_shade *shade, tp_run *run);

/* Returns the end of the 16 columns that sample i lies in, or of the run. */
static inline int32_t tp_block_end(const tp_run *run, int32_t i)
{
    TP_ASSERT(i < run->count);
    int32_t end = i + 16 - ((run->x + i) & 15);
    return end < run->count ? end : run->count;
}

/* Returns the number of the block of sample i, 0..TP_RUN / 16 - 1. */
static inline uint32_t tp_block_number(const tp_run *run, int32_t i)
{
    return (uint32_t)(run->x + i) % TP_RUN / 16;
}

/* Returns sixteenths of a pixel over the focal length, Q16. */
static inline int64_t tp_over_focal(const tp_shade *shade, int32_t sixteenths)
{
    return sixteenths * (int64_t)shade->per_focal >> 16;
}

/* The unit vector to the eye from pixel (x, y), and its dot product l with the light;
 * Q1.14. */
typedef struct {
    int32_t x, y, z, l;
} tp_ray;

tp_ray tp_vector_to_eye(const tp_shade *shade, const tp_view_axes *axes, int32_t x,
                        int32_t y);

/* -- depth of a sample from its key, and the mipmap level at that depth -------------- */

/* Returns log2(n) of n != 0, Q8, within 1/12: the exponent by clz, the fraction from the
 * next eight bits.  tp_log2_q8_shifted takes the leading zeros of n. */
static inline int32_t tp_log2_q8_shifted(uint32_t n, int shift)
{
    return (31 - shift) * 256 + (int32_t)((n << shift) >> 23 & 0xff);
}

static inline int32_t tp_log2_q8(uint32_t n)
{
    return tp_log2_q8_shifted(n, tp_clz(n));
}

/* Inverse depth of a sample: near plane / depth, Q1.31.  The low bits keep the sample's
 * mark; they are below the precision.  The result is never 0. */
static inline uint32_t tp_key_zi(uint32_t key)
{
    return key >> 1 | 0x80;
}

/* Returns the depth for zi != 0 in m, 16.16, within a relative error of 2^-16. */
static inline int64_t tp_depth_from_zi(tp_fx zi_near, uint32_t zi)
{
    int shift = tp_clz(zi);
    return (int64_t)zi_near * tp_recip_rough(zi << shift) >> (31 - shift);
}

/* Returns log2 of the depth in metres, Q8. */
static inline int32_t tp_log_depth(const tp_shade *shade, uint32_t key)
{
    return shade->zi_log - tp_log2_q8(tp_key_zi(key));
}

/* Mipmap level at a depth, from `lod`, the texture's level at 1 m; Q8.  On upright
 * surfaces texels per pixel grow in proportion to the depth.  On level ground they grow in
 * proportion across the view and by the square along the view; the geometric mean
 * counts. */
static inline int32_t tp_mip_level_choose(int32_t lod, int32_t log_depth, bool ground,
                                          int levels)
{
    int32_t level = lod + log_depth + (ground && log_depth > 0 ? log_depth / 2 : 0);
    return tp_clamp(level >> 8, 0, levels - 1);
}

/* -- bilinear look-up in a planar map ------------------------------------------------ */

/* Returns a position in the map, in 32nds of its pixels, from one in the picture, 28.4. */
static inline int32_t tp_planar_map_position(const tp_planar_map *map, int32_t sixteenths)
{
    return 2 * sixteenths >> map->halvings;
}

/* Returns a pixel of the map; 0 outside of the map's box. */
static inline uint32_t tp_planar_map_pixel(const tp_planar_map *map, int32_t i, int32_t j)
{
    if (i < map->x0 || i >= map->x1 || j < map->y0 || j >= map->y1)
        return 0;
    return map->colour[(size_t)(uint32_t)(j - map->y0)
                        * (uint32_t)(map->x1 - map->x0) + (uint32_t)(i - map->x0)];
}

/* True if no sample at position u of the map reaches it. */
static inline bool tp_planar_map_misses_column(const tp_planar_map *map, int32_t u)
{
    const int32_t i = (u - 16) >> 5;
    return i < map->x0 - 1 || i >= map->x1;
}

/* Mixes the four neighbours of a sample: a b in the upper row, c d in the lower.  Equal
 * neighbours mix to themselves. */
static inline uint32_t tp_planar_map_mix(uint32_t a, uint32_t b, uint32_t c, uint32_t d,
                                         uint32_t fu, uint32_t fv)
{
    if (((a ^ b) | (a ^ c) | (a ^ d)) == 0)
        return a;
    return tp_argb_mix_32nds(tp_argb_mix_32nds(a, b, fu), tp_argb_mix_32nds(c, d, fu), fv);
}

/* Samples the map at position (u, v).  The result is premultiplied by
 * its alpha, because uncovered pixels are 0. */
static inline uint32_t tp_planar_map_sample(const tp_planar_map *map, int32_t u, int32_t v)
{
    const int32_t i = (u - 16) >> 5, j = (v - 16) >> 5;
    const uint32_t fu = (uint32_t)(u - 16) & 31, fv = (uint32_t)(v - 16) & 31;
    const uint32_t right = (uint32_t)(i - map->x0), down = (uint32_t)(j - map->y0);
    const uint32_t cols = (uint32_t)(map->x1 - map->x0),
                   rows = (uint32_t)(map->y1 - map->y0);

    if (right < cols - 1 && down < rows - 1) {          /* all four in the box */
        const uint32_t *at = map->colour + (size_t)down * cols + right;
        return tp_planar_map_mix(at[0], at[1], at[cols], at[cols + 1], fu, fv);
    }
    if (i < map->x0 - 1 || i >= map->x1 || j < map->y0 - 1 || j >= map->y1)
        return 0;
    return tp_planar_map_mix(
        tp_planar_map_pixel(map, i, j), tp_planar_map_pixel(map, i + 1, j),
        tp_planar_map_pixel(map, i, j + 1), tp_planar_map_pixel(map, i + 1, j + 1), fu, fv);
}

#endif
