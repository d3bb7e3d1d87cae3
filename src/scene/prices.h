/* SPDX-License-Identifier: MIT */
/* What methods cost and how far they are off, as measured: instructions of a Cortex-M4;
 * errors against the truth (tests/budgets/truth.h), beyond those of the exact rungs.  The
 * table is made from tests/budgets/prices.csv. */
#ifndef TP_SCENE_PRICES_H
#define TP_SCENE_PRICES_H
#include "tidepool/plan.h"

enum { TP_KIND_VISIBILITY, TP_KIND_SHADING, TP_KIND_RATE, TP_KIND_LOD };
enum { TP_VISIBILITIES = 4, TP_SHADINGS = 2, TP_RATES = 3, TP_LODS = 2 };

/* What the water's pixels may have, each with its price; plain: what all have; look: the
 * view that gloss, mirror and depth share; objects: in the mirror; bed: ground below. */
#define TP_TRAITS(X) \
    X(plain) X(texture) X(linear) X(bend) X(layer) X(ripple) X(bump) X(look) X(mirror) \
    X(glint) X(haze) X(dome) X(cube) X(objects) X(behind) X(bed) \
    X(dispersion) X(foam) X(expose)

enum {
#define X(name) TP_TRAIT_##name,
    TP_TRAITS(X)
#undef X
    TP_TRAIT_COUNT
};

/* Seas by what makes errors: their slopes, and how they glitter; sparks: by a lobe so
 * sharp and bright that its points are smaller than pixels; ocean: steep, over a bed or
 * in a wind. */
enum {
    TP_SEA_LEVEL, TP_SEA_LEVEL_GLOSSY, TP_SEA_LEVEL_SPARKS,
    TP_SEA_GENTLE, TP_SEA_GENTLE_GLOSSY, TP_SEA_GENTLE_SPARKS,
    TP_SEA_STEEP, TP_SEA_STEEP_GLOSSY, TP_SEA_STEEP_SPARKS,
    TP_SEA_OCEAN, TP_SEA_OCEAN_GLOSSY, TP_SEA_OCEAN_SPARKS, TP_SEA_CLASSES
};

/* Of a way to find the water. */
typedef struct {
    bool  known;
    tp_fx pixel;                /* instructions a water pixel */
    tp_fx vertex;               /* a point that it works out; there besides ... */
    tp_fx wave, pool, ocean;    /* ... for each wave, each pool, an ocean */
} tp_seen_price;

/* Of a way to shade it, a pixel; some are below 0. */
typedef struct {
    bool  known;
    tp_fx part[TP_TRAIT_COUNT];
} tp_shaded_price;

typedef struct {
    bool  known;
    tp_fx px, colour;
} tp_error_price;

typedef struct {
    tp_fx frame;                /* thousands a frame */
    tp_fx sky;                  /* a pixel */
    tp_fx slope_colour;         /* rms of 255 that slopes of rms 1 make */
    tp_seen_price   seen[TP_VISIBILITIES][TP_LODS];
    tp_shaded_price shaded[TP_SHADINGS][TP_RATES];
    tp_error_price  error[TP_KINDS][TP_KIND_RUNGS][TP_SEA_CLASSES];
} tp_prices;

extern const tp_prices tp_prices_measured;

/* The plan by any table. */
tp_plan_report tp_plan_by(const tp_prices *prices, const tp_scene *scene,
                          const tp_assets *assets, uint32_t width, uint32_t height);
tp_ladder tp_ladder_by(const tp_prices *prices, const tp_scene *scene,
                       const tp_assets *assets, uint32_t width, uint32_t height);

/* Whether some wave is too faint to be drawn as it is, seen from the scene's camera. */
bool tp_thins_sea(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                  uint32_t height);

/* -- outlook.c: what a scene puts before the camera ---------------------------------- */

typedef struct {
    uint32_t water_pixels, other_pixels, vertices, waves;
    int32_t  focal;             /* pixels of a metre, a metre away */
    tp_fx    near;              /* m to the nearest water */
    uint8_t  trait[TP_TRAIT_COUNT];     /* how often */
    uint8_t  sea;               /* its class */
    uint8_t  pools, ocean;      /* that displace the grid */
    uint32_t points[TP_VISIBILITIES];   /* that each method works out */
    uint8_t  fits[TP_VISIBILITIES];     /* whether it draws this view */
    uint8_t  quick;             /* whether the quick stages know all that the water has */
} tp_outlook;

tp_outlook tp_outlook_of(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                         uint32_t height);
#endif
