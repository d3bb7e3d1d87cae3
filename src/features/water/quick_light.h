/* SPDX-License-Identifier: MIT */
/* Quick light on water, in slope space: N is never made a unit.
 *
 * With N = (-sx, 1, -sz), q = sx^2 + sz^2, V to the eye and L to the light, one dual
 * product each gives n = N.V and l = N.L, both too large by sqrt(1 + q), and then
 *   2 n - Vy                     height of the mirrored view, exact for q = 0
 *   (1 + L.V)(1 + q) - 2 n l     (1 + q)(1 - R.V): never below 0, and 0 where Phong's
 *                                lobe is 1, however steep the water
 *   |s - h|^2                    square of the tangent of the angle to the half vector,
 *                                whose slopes are h: Blinn's lobe
 * Fresnel's share, the two lobes and the sky are tables by these; for share and sky n is
 * not less than what ripples too small for a pixel leave of it (see lighting_stage.c).  A dome is
 * looked up by the mirrored view's height and, the same for a whole span, by how much the
 * view is towards the sun; its glow is added to the lobe, with Fresnel's share where the
 * sun's image is.  A cube's sky is a square map of the world's upper half.
 *
 * V and h are exact in every 32nd column and go by equal steps between, V of 4 columns, h
 * of one, as steps of a sharp lobe show as a comb; V and L.V for Phong's sharper lobe in
 * every 16th, by steps of 2.  A run may begin anywhere.
 *
 * Against the exact stages, slopes at random up to 0.1, 0.3 and 0.6, rms in 1/255 as
 * tests/unit/test_features_water_quick_light.c prints them: matt water and a gradient 0.7,
 * 3.1, 6.7; a dome 1.3, 3.3; a cube 1.0, 3.0; with glints of Phong 1.3, 3.5, of Blinn 1.5,
 * 7. */
#ifndef TP_WATER_QUICK_LIGHT_H
#define TP_WATER_QUICK_LIGHT_H
#include "base/dsp.h"
#include "shade/quick_ray.h"
#include "tidepool/modules.h"

#define TP_QUICK_SHARES 256     /* by n of 0..1 */
#define TP_QUICK_LOBE   512     /* of 1/2048 of (1 + q)(1 - R.V), or of |s - h|^2 */
#define TP_QUICK_HEIGHTS 64     /* of the mirrored view, a 32nd each; half are below 0 */
#define TP_QUICK_STEP(lobe) ((lobe) == TP_LOBE_PHONG ? 2 : 4)       /* columns */
#define TP_QUICK_SPAN(lobe) (8 * TP_QUICK_STEP(lobe))
#define TP_QUICK_KEY    16
#define TP_QUICK_SIDE   32      /* of the map of a cube's sky */

typedef enum { TP_LOBE_NONE, TP_LOBE_PHONG, TP_LOBE_BLINN } tp_lobe;

struct tp_quick_light {
    uint32_t share[TP_QUICK_SHARES];    /* of 256: what water keeps, what it mirrors */
    uint32_t lobe[TP_QUICK_LOBE];       /* colours */
    uint32_t sky[TP_QUICK_SIDE * TP_QUICK_SIDE];    /* columns of heights, or a map */
    int32_t  least;             /* that n is taken to be, Q26 */
    int32_t  made_for[TP_QUICK_KEY];    /* the frame's: numbers, the first not negative */
};

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

/* quick_tables.c: makes the tables from the shade's sky, light and numbers.  On the camera's
 * angles they depend only by this share, of 256, in a dome's lobe. */
uint32_t tp_quick_share_at_sun(const tp_shade *shade);
void tp_quick_light_init(struct tp_quick_light *quick, const tp_shade *shade,
                         tp_lobe lobe, bool shiny, bool rippled);

/* quick_layers_stage.c: colours of the odd columns, between those of the even ones. */
void tp_quick_fill_between(tp_run *run);

/* -- the view -------------------------------------------------------------------------- */

/* Of a step's columns: -V as x : z in Q1.14, h as x : z in Q3.12, Vy less the least n Q26,
 * 1 + L.V Q30. */
typedef struct {
    uint32_t back, half;
    int32_t  y, lv;
} tp_quick_view;

/* In the middle of the step that begins with column x: with L.V; with h,
 * or for no lobe. */
tp_quick_view tp_quick_phong_at(const tp_shade *shade, const tp_quick_row *row,
                                int32_t x);
tp_quick_view tp_quick_blinn_at(const tp_shade *shade, const tp_quick_row *row,
                                int32_t x);

TP_ALWAYS_INLINE tp_quick_view tp_quick_view_at(const tp_shade *shade,
                                                const tp_quick_row *row, int32_t x,
                                                int lobe)
{
    return lobe == TP_LOBE_PHONG ? tp_quick_phong_at(shade, row, x)
                                 : tp_quick_blinn_at(shade, row, x);
}

/* The arrays of a whole run, which plain bodies want. */
void tp_quick_view_run(const tp_shade *shade, tp_run *run, int lobe);

/* Where in the sky of a dome the column of a span begins. */
uint32_t tp_quick_column(const tp_shade *shade, const tp_quick_view *v);

/* The halves of b less those of a, over 8. */
TP_ALWAYS_INLINE uint32_t tp_quick_eighth(uint32_t a, uint32_t b)
{
    return tp_shadd16(tp_shadd16(tp_shsub16(b, a), 0), 0);
}

/* Of the 8 steps from a to b. */
TP_ALWAYS_INLINE tp_quick_view tp_quick_step(tp_quick_view a, tp_quick_view b, int lobe)
{
    return (tp_quick_view){
        tp_quick_eighth(a.back, b.back),
        lobe == TP_LOBE_BLINN ? tp_quick_eighth(a.half, b.half) : 0,
        (b.y - a.y) >> 3, lobe == TP_LOBE_PHONG ? (b.lv - a.lv) >> 3 : 0,
    };
}

/* Of h from column to column: a quarter of a step, cut, three times, then what is left
 * of the step. */
typedef struct {
    uint32_t quarter, rest;
} tp_quick_walk;

TP_ALWAYS_INLINE tp_quick_walk tp_quick_walk_of(uint32_t step)
{
    uint32_t quarter = tp_shadd16(tp_shadd16(step, 0), 0);

    return (tp_quick_walk){
        quarter, tp_ssub16(tp_ssub16(tp_ssub16(step, quarter), quarter), quarter)
    };
}

/* h in column 0 of a span, by h in the middle of its first step: 3/8 of a step less. */
TP_ALWAYS_INLINE uint32_t tp_quick_half_first(uint32_t half, tp_quick_walk walk)
{
    return tp_ssub16(tp_ssub16(half, walk.quarter), tp_shadd16(walk.quarter, 0));
}

static inline uint32_t tp_quick_plus(uint32_t a, uint32_t step, int32_t k)
{
    return tp_pair16(tp_high16(a) + k * tp_high16(step),
                     tp_low16(a) + k * tp_low16(step));
}

/* h in column k by that in column 0. */
TP_ALWAYS_INLINE uint32_t tp_quick_half_at(uint32_t first, uint32_t step, int32_t k)
{
    return tp_pair16(tp_high16(first) + (k >> 2) * tp_high16(step)
                         + (k & 3) * (tp_high16(step) >> 2),
                     tp_low16(first) + (k >> 2) * tp_low16(step)
                         + (k & 3) * (tp_low16(step) >> 2));
}

TP_ALWAYS_INLINE tp_quick_view tp_quick_at(tp_quick_view v, tp_quick_view step, int32_t k)
{
    return (tp_quick_view){ tp_quick_plus(v.back, step.back, k),
                            tp_quick_plus(v.half, step.half, k),
                            v.y + k * step.y, v.lv + k * step.lv };
}

/* The light's part: -L as x : z, Q1.14, and Ly Q26; the ambient share Q16, and what is
 * added for each of 255 of N.L, up to 65535. */
typedef struct {
    uint32_t back;
    int32_t  y, ambient, direct;
} tp_quick_sun;

static inline tp_quick_sun tp_quick_sun_of(const tp_shade *shade)
{
    return (tp_quick_sun){ tp_pair16(-shade->world.lx, -shade->world.lz),
                           shade->world.ly * 4096, shade->ambient * 256,
                           (256 - shade->ambient) * 257 >> 8 };
}
#endif
