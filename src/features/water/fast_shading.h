/* SPDX-License-Identifier: MIT */
/*
 * Fast shading of water: layers, ripples, light, the reflected sky and glints.  This header
 * has baked textures, tables of light, and the stepped view.
 *
 *     fast_water_drawing.c   its shader list
 *     fast_water_textures.c  a frame's baked textures
 *     fast_water_tables.c    bakes textures, for frames and for `tidepool bake`
 *     fast_light_tables.c    makes tables of light, and chooses those of a span
 *     fast_layers_stage.c    span stages of layers, distortion and ripples; loops in
 *                            fast_layers_plain.h and fast_layers_m4.h
 *     fast_light_stage.c     span stages of light; loops in fast_light_*.h and
 *                            fast_glints_m4.h
 */
#ifndef TP_FEATURES_WATER_FAST_SHADING_H
#define TP_FEATURES_WATER_FAST_SHADING_H
#include "base/base.h"
#include "base/word_pairs.h"
#include "fixed/arithmetic.h"
#include "shade/colour.h"
#include "shade/shade.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

/* -- baked textures ------------------------------------------------------------------ */

/* All work that is the same in every frame is done once per texel, in all mipmap levels.
 * A span stage then reads the nearest texel and adds it.
 *  - graded:  a layer's texels with saturation, clamp, colour and, in the base layer, the
 *             water's colour; 0x00RRGGBB
 *  - offsets: the distortion's s:t in 16-bit halves, displacement in 1/1024 m
 *  - slopes:  the ripple's x:z in 16-bit halves, Q3.12
 * A baked texture is square, with a side of 2..256.  Smaller sides are stretched; the
 * finest levels of larger sides are left out.  The level of one texel is not used. */

#define TP_QUICK_LOG2 8         /* log2 of the longest side */
#define TP_QUICK_LAYERS 3

/* A baked texture in the form read by the loops; see tp_layer. */
typedef struct {
    uint32_t per_metre, drift_s, drift_t;
    int32_t  lod;
    int32_t  last;              /* last level in use */
    uint32_t log2;              /* log2 of the side of level 0 */
    const uint32_t *const *level;       /* NULL: no texture */
} tp_quick_map;

typedef struct {
    tp_quick_map layer[TP_QUICK_LAYERS], bend, ripple;
} tp_quick_layers;

/* Returns the map of a layer; its texture is baked, or NULL. */
tp_quick_map tp_quick_map_make(const tp_layer *layer);

/* -- baking, at a frame's init or beforehand for textures in ROM --------------------- */

/* Returns the size of the baked texture in bytes; memory is aligned to 4. */
size_t tp_quick_bytes(const tp_texture *from);

/* Bake a texture into `mem`.  Texels darker than `clamp` become black.  The base layer's
 * colour is the water's colour times its own. */
void tp_quick_graded(tp_texture *to, const tp_texture *from, tp_fx saturation, tp_fx clamp,
                     uint32_t colour, void *mem);
void tp_quick_offsets(tp_texture *to, const tp_texture *from, tp_fx strength, void *mem);
void tp_quick_slopes(tp_texture *to, const tp_texture *from, tp_fx bump, void *mem);

/* -- loops over baked textures ------------------------------------------------------- */

/* Each loop reads one mipmap level of a baked texture at the places of a run.
 *
 * Places are 16.16 m.  Times repeats per metre they are Q0.32 repeats, which wrap; the
 * highest bits are a texel's column and row.  The places of layers are an array of 2
 * TP_RUN words, s in the first half and t in the second. */

typedef struct {
    const uint32_t *texel;
    uint32_t per_metre, drift_s, drift_t;
    uint32_t down, side;        /* 32 - log2 of the side, 24..31; the side */
} tp_lookup;

TP_ALWAYS_INLINE tp_lookup tp_lookup_make(const tp_quick_map *map, int32_t mip_offset)
{
    TP_ASSERT(map->level != NULL && map->last >= 0 && map->last <= (int32_t)map->log2);
    int32_t  level = tp_clamp((map->lod + mip_offset) >> 8, 0, map->last);
    uint32_t log2 = map->log2 - (uint32_t)level;

    return (tp_lookup){ map->level[level], map->per_metre, map->drift_s, map->drift_t,
                        32 - log2, 1u << log2 };
}

/* A loop stays a separate function: inlined in its caller it would run out of registers. */
#if defined(__GNUC__)
#define TP_LOOP static __attribute__((noinline)) void
#else
#define TP_LOOP static void
#endif

/* Samples of a run from a column on: rest positions s and t, and slopes n.  column: the
 * first column of the picture; odd: 1 if it is odd. */
typedef struct {
    const uint32_t *s, *t, *n;
    int32_t  count;
    uint32_t column, odd;
} tp_columns;

/* -- light, in slope space ----------------------------------------------------------- */

/* N is never normalized.
 *
 * With N = (-sx, 1, -sz), q = sx^2 + sz^2, V to the eye and L to the light, one dual
 * product each gives n = N.V and l = N.L, both too large by sqrt(1 + q).  The terms are
 *   2 n - Vy                     height of the reflected view, exact for q = 0
 *   (1 + L.V)(1 + q) - 2 n l     (1 + q)(1 - R.V): never below 0, and 0 where Phong's
 *                                lobe is 1, however steep the water
 *   |s - h|^2                    square of the tangent of the angle to the half vector,
 *                                whose slopes are h: Blinn's lobe
 * Fresnel's share, the two lobes and the sky are tables over these terms.  For Fresnel
 * and sky n has the lower bound of lighting_stage.c, the part left by ripples below a
 * pixel.  A dome is looked up by the height of the reflected view, and by one value per
 * span: how much the view is towards the sun.  The dome's glow is added to the lobe,
 * weighted by Fresnel at the sun's image.  The sky of a cube is a square map of the
 * world's upper half.
 *
 * V and h are exact in every 32nd column and interpolated by equal steps: V steps every 4
 * columns, h every column, because steps of a sharp lobe show as a comb.  For Phong's
 * sharper lobe V and L.V are exact in every 16th column and step every 2.  A run may
 * begin in any column.
 *
 * Errors against the exact stages, rms in 1/255, for random slopes up to 0.1, 0.3 and
 * 0.6, as printed by tests/unit/test_features_water_quick_light.c: matt water and a
 * gradient 0.7, 3.1, 6.7; a dome 1.3, 3.3; a cube 1.0, 3.0, with light beyond white 1.6,
 * 5.4; with glints of Phong 1.3, 3.5, of Blinn 1.5, 7.
 *
 * Variance of slopes that a fan's cells and the ripples' levels do not show (MODELS V)
 * widens the lobe, bends N.V for Fresnel's share and the mirrored height, and lowers that
 * height to the sky's mean [V3]: a scene with a fan has the tables at TP_QUICK_LEVELS
 * variances, and a span takes those of the level water that it shows.  A dome's glow is
 * raised in the lobe's table.  Light gets the mean slope of waves that are seen. */

#define TP_QUICK_SHARES 256     /* entries for n of 0..1 */
#define TP_QUICK_LOBE   512     /* entries of 1/2048 of (1 + q)(1 - R.V), or of |s - h|^2 */
#define TP_QUICK_HEIGHTS 64     /* of the reflected view, 1/32 each; half are below 0 */
#define TP_QUICK_ROUGH_HEIGHTS 80       /* the same with 8 more at each end, of a level */
#define TP_QUICK_ROUGH_COLUMNS 8        /* of a dome, of a level */
#define TP_QUICK_STEP(lobe) ((lobe) == TP_LOBE_PHONG ? 2 : 4)       /* columns per step */
#define TP_QUICK_SPAN(lobe) (8 * TP_QUICK_STEP(lobe))
#define TP_QUICK_VIEWS  64      /* heights of the vector to the eye */
#define TP_QUICK_SIDE   32      /* side of the map of a cube's sky */
#define TP_QUICK_LEVELS 4       /* levels of roughness, of a scene with a fan; else 1 */

typedef enum { TP_LOBE_NONE, TP_LOBE_PHONG, TP_LOBE_BLINN } tp_lobe;

/* Tables of water of one slope variance. */
typedef struct {
    uint32_t share[TP_QUICK_SHARES];    /* 1/256: kept by the water; mirrored */
    uint32_t lobe[TP_QUICK_LOBE];       /* colours */
    uint32_t beyond;            /* of tp_env: scale of a cube's light beyond white */
    int32_t  least;             /* lower bound of n, Q26 */
    uint32_t shift[TP_QUICK_VIEWS / 4]; /* entries of the sky by Vy, from 0 to 1: signed
                                         * bytes, the lowest first */
} tp_quick_rough;

/* Returns the words of a sky: a cube's map, or columns of heights of each level. */
TP_ALWAYS_INLINE size_t tp_quick_sky_words(int env, uint32_t levels)
{
    const size_t rough = (levels - 1) * (size_t)TP_QUICK_ROUGH_HEIGHTS;

    return env == TP_ENV_CUBE ? TP_QUICK_SIDE * TP_QUICK_SIDE
         : env == TP_ENV_DOME ? 16 * TP_QUICK_HEIGHTS + TP_QUICK_ROUGH_COLUMNS * rough
                              : TP_QUICK_HEIGHTS + rough;
}

struct tp_quick_light {
    const tp_quick_rough *rough;        /* by level of roughness */
    uint32_t levels;                    /* in use */
    bool     lit;                       /* true: an earlier stage lights the colours */
    const uint32_t *sky;                /* tp_quick_sky_words */
};

/* The same tables while they are made. */
typedef struct {
    tp_quick_rough *rough;
    uint32_t *sky, levels;
} tp_quick_tables;

/* name, kind of environment, lobe */
#define TP_QUICK_LIGHT_STAGES(X) \
    X(gradient,       TP_ENV_GRADIENT, TP_LOBE_NONE) \
    X(gradient_phong, TP_ENV_GRADIENT, TP_LOBE_PHONG) \
    X(gradient_blinn, TP_ENV_GRADIENT, TP_LOBE_BLINN) \
    X(dome_phong,     TP_ENV_DOME,     TP_LOBE_PHONG) \
    X(dome_blinn,     TP_ENV_DOME,     TP_LOBE_BLINN) \
    X(cube,           TP_ENV_CUBE,     TP_LOBE_NONE) \
    X(cube_phong,     TP_ENV_CUBE,     TP_LOBE_PHONG) \
    X(cube_blinn,     TP_ENV_CUBE,     TP_LOBE_BLINN)

/* fast_light_tables.c.  tp_quick_light_init makes the tables from the shade's sky, light
 * and numbers.  The camera's angles enter only through tp_quick_share_at_sun, 1/256, in a
 * dome's lobe; ripples through their whole variance, an axis, Q24. */
uint32_t tp_quick_share_at_sun(const tp_shade *shade);
uint32_t tp_quick_ripple_variance(const tp_shade *shade);
void tp_quick_light_init(const tp_quick_tables *to, const tp_shade *shade,
                         tp_lobe lobe, bool specular, bool rippled);

/* fast_cube_map.c: fills the map of a cube's light, which tp_quick_light_init leaves. */
void tp_quick_fill_cube_map(const tp_quick_tables *to, const tp_shade *shade);

struct tp_draw_cube_map {
    void (*fill)(const tp_quick_tables *to, const tp_shade *shade);
};

/* Adds the part beyond white of mirrored light [F8]; light: of the cube's map; mirrors: share
 * of 256; beyond: of tp_env. */
TP_ALWAYS_INLINE uint32_t tp_quick_add_bright(uint32_t colour, uint32_t light,
                                              uint32_t mirrors, uint32_t beyond)
{
    const uint32_t gain = (light >> 24) * beyond >> 8;      /* 1/256 */
    return tp_colour_add(colour & 0xffffff, tp_colour_brighten(light, gain * mirrors >> 8));
}

/* fast_layers_stage.c.  Fills the colours of odd columns from the even columns. */
void tp_quick_odd_fill(tp_run *run);

/* -- the view ------------------------------------------------------------------------ */

/* The view in the columns of a step.  back: -V as x : z, Q1.14; half: h as x : z, Q3.12;
 * y: Vy, and in a span's loop Vy minus the lower bound of n, Q26; lv: 1 + L.V, Q30. */
typedef struct {
    uint32_t back, half;
    int32_t  y, lv;
} tp_quick_view;

/* Water of a span.  level: of the slope variance that level water does not show; light
 * stages keep it in run->span, since layers are shaded before.  seen: light that waves add
 * that are seen, or take away, see tp_quick_sun_seen.  sky: index in the sky of height 0;
 * of a cube 0. */
typedef struct {
    uint32_t level;
    int32_t  seen;
    uint32_t sky;
} tp_quick_water;

/* Return the view in the middle of the step from column x on: the first with L.V; the
 * second with h, also used without a lobe. */
tp_quick_view tp_quick_phong_sample(const tp_shade *shade, const tp_quick_ray_row *row,
                                    int32_t x);
tp_quick_view tp_quick_blinn_sample(const tp_shade *shade, const tp_quick_ray_row *row,
                                    int32_t x);

TP_ALWAYS_INLINE tp_quick_view tp_quick_view_sample(const tp_shade *shade,
                                                    const tp_quick_ray_row *row, int32_t x,
                                                    int lobe)
{
    return lobe == TP_LOBE_PHONG ? tp_quick_phong_sample(shade, row, x)
                                 : tp_quick_blinn_sample(shade, row, x);
}

/* Offset of places in the map of a cube's sky, cells, Q22. */
typedef struct {
    int32_t u, v;
} tp_quick_offset;

/* Returns the offset of a row of the picture, up to 3/8 of a cell.  Four offsets take turns;
 * those of rows 0 and 2, 1 and 3 are opposite.  Without them water without ripples would
 * show the map's cells as facets. */
TP_ALWAYS_INLINE tp_quick_offset tp_quick_row_offset(int32_t y)
{
    const int32_t eighth = y & 2 ? 1 << 19 : -(1 << 19);

    return y & 1 ? (tp_quick_offset){ -eighth, 3 * eighth }
                 : (tp_quick_offset){ 3 * eighth, eighth };
}

/* Fills the arrays of a whole run, for the plain loops. */
void tp_quick_view_run(const tp_shade *shade, tp_run *run, int env, int lobe);

/* Returns a dome's column of heights for a span, 0..15.  The value (1 + cos)^2 / 4, with
 * the angle from the sun to the view reflected by smooth water, is the share of the sky's
 * sunny side, as in tp_light_side_weight. */
TP_ALWAYS_INLINE uint32_t tp_quick_column(const tp_shade *shade, const tp_quick_view *v)
{
    const tp_view_axes *a = &shade->world;
    int32_t c = (v->y >> 12) * a->ly + tp_high16(v->back) * a->lx
              + tp_low16(v->back) * a->lz;
    int32_t part = tp_clamp(((1 << 28) + c) >> 15, 0, 16383);

    return (uint32_t)(part * part) >> 24;
}

/* fast_light_tables.c.  Return a span's water by the view at its first column: of several
 * levels; of any number. */
tp_quick_water tp_quick_rough_water(const tp_shade *shade, const tp_quick_view *v, int env);
TP_ALWAYS_INLINE tp_quick_water tp_quick_water_make(const tp_shade *shade,
                                                    const tp_quick_view *v, int env)
{
    if (shade->quick->levels > 1)
        return tp_quick_rough_water(shade, v, env);
    return (tp_quick_water){
        0, 0, env == TP_ENV_CUBE ? 0 : TP_QUICK_HEIGHTS / 2
            + (env == TP_ENV_DOME ? tp_quick_column(shade, v) * TP_QUICK_HEIGHTS : 0)
    };
}

/* Returns (b - a) / 8 in both halves. */
TP_ALWAYS_INLINE uint32_t tp_quick_eighth(uint32_t a, uint32_t b)
{
    return tp_shadd16(tp_shadd16(tp_shsub16(b, a), 0), 0);
}

/* Returns one of the 8 equal steps from a to b. */
TP_ALWAYS_INLINE tp_quick_view tp_quick_step(tp_quick_view a, tp_quick_view b, int lobe)
{
    return (tp_quick_view){ tp_quick_eighth(a.back, b.back),
                            lobe == TP_LOBE_BLINN ? tp_quick_eighth(a.half, b.half) : 0,
                            (b.y - a.y) >> 3,
                            lobe == TP_LOBE_PHONG ? (b.lv - a.lv) >> 3 : 0 };
}

/* Steps of the half vector h from column to column: three times a quarter of a step,
 * truncated, then the rest of the step. */
typedef struct {
    uint32_t quarter, rest;
} tp_quick_walk;

TP_ALWAYS_INLINE tp_quick_walk tp_quick_walk_make(uint32_t step)
{
    uint32_t quarter = tp_shadd16(tp_shadd16(step, 0), 0);

    return (tp_quick_walk){
        quarter, tp_ssub16(tp_ssub16(tp_ssub16(step, quarter), quarter), quarter)
    };
}

/* Returns h in column 0 of a span.  `half` is h in the middle of the first step, 3/8 of a
 * step later. */
TP_ALWAYS_INLINE uint32_t tp_quick_half_first(uint32_t half, tp_quick_walk walk)
{
    return tp_ssub16(tp_ssub16(half, walk.quarter), tp_shadd16(walk.quarter, 0));
}

static inline uint32_t tp_quick_plus(uint32_t a, uint32_t step, int32_t k)
{
    return tp_pair16(tp_high16(a) + k * tp_high16(step),
                     tp_low16(a) + k * tp_low16(step));
}

/* Returns h in column k; `first` is h in column 0, `step` the change in four columns.
 * Quarters of a step are truncated, as in tp_quick_walk. */
TP_ALWAYS_INLINE uint32_t tp_quick_half_advance(uint32_t first, uint32_t step, int32_t k)
{
    return tp_pair16(tp_high16(first) + (k >> 2) * tp_high16(step)
                         + (k & 3) * (tp_high16(step) >> 2),
                     tp_low16(first) + (k >> 2) * tp_low16(step)
                         + (k & 3) * (tp_low16(step) >> 2));
}

TP_ALWAYS_INLINE tp_quick_view tp_quick_view_advance(tp_quick_view v, tp_quick_view step,
                                                     int32_t k)
{
    return (tp_quick_view){ tp_quick_plus(v.back, step.back, k),
                            tp_quick_plus(v.half, step.half, k),
                            v.y + k * step.y, v.lv + k * step.lv };
}

/* The light.  back: -L as x : z, Q1.14; y: Ly, Q26; ambient: ambient share, Q16; direct:
 * added light per 1/255 of N.L; the sum is at most 65536. */
typedef struct {
    uint32_t back;
    int32_t  y, ambient, direct;
} tp_quick_sun;

static inline tp_quick_sun tp_quick_sun_make(const tp_shade *shade)
{
    const int32_t ambient = shade->quick->lit ? 256 : shade->ambient;

    return (tp_quick_sun){ tp_pair16(-shade->world.lx, -shade->world.lz),
                           shade->world.ly * 4096, ambient * 256,
                           (256 - ambient) * 257 >> 8 };
}

/* Returns the light where waves that face the eye hide the others.  seen, -direct..direct:
 * below 0 the direct light is less by it, and still 0 at N.L = 0; above 0 so much of it
 * does not depend on N.L, and the sum at N.L = 1 stays. */
TP_ALWAYS_INLINE tp_quick_sun tp_quick_sun_seen(tp_quick_sun sun, int32_t seen)
{
    sun.ambient += 255 * (seen > 0 ? seen : 0);
    sun.direct -= seen > 0 ? seen : -seen;
    return sun;
}

#endif
