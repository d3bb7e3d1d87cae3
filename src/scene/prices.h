/* SPDX-License-Identifier: MIT */
/* Costs and errors of methods, as measured: instructions of a Cortex-M4; errors against the
 * truth (tests/budgets/truth.h), beyond those of the exact rungs.  The table is made from
 * assets/charts/prices.csv. */
#ifndef TP_SCENE_PRICES_H
#define TP_SCENE_PRICES_H
#include "scene/plan.h"
#include "tidepool/modules.h"

enum { TP_KIND_VISIBILITY, TP_KIND_SHADING, TP_KIND_RATE, TP_KIND_LOD };
enum { TP_VISIBILITIES = 4, TP_SHADINGS = 2, TP_RATES = 3, TP_LODS = 2 };

/* The traits of the water's pixels; each has a price.  plain: all pixels have it; diffuse:
 * light without the view; look: the view that gloss, mirror and depth share; objects: in
 * the mirror; lined: a layer of linear texels; bed, chart, tank: a floor that is a plane, a
 * map, a box. */
#define TP_TRAITS(X) \
    X(plain) X(texture) X(linear) X(bend) X(layer) X(lined) X(ripple) X(bump) \
    X(diffuse) X(look) X(mirror) \
    X(glint) X(haze) X(dome) X(cube) X(objects) X(behind) X(bed) \
    X(chart) X(tank) X(caustic) X(dispersion) X(foam) X(expose)

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

/* The price of a method of finding the water. */
typedef struct {
    bool  known;
    tp_fx pixel;                /* instructions a water pixel */
    tp_fx vertex;               /* a point that it works out; there besides ... */
    tp_fx wave, sharp, pool;    /* ... for each wave, of a sharp sea more, each pool */
    tp_fx ocean, floor, map;    /* ... an ocean; one over a plane, over a map */
    tp_fx drawn;                /* a cell of the grid that gets a pixel */
    tp_fx slant;                /* ... by how the view goes along the lines for across */
    tp_fx still;                /* instead of `pixel` of level water */
} tp_seen_price;

/* The price of a method of shading the water, a pixel; some are below 0. */
typedef struct {
    bool  known;
    tp_fx part[TP_TRAIT_COUNT];
} tp_shaded_price;

typedef struct {
    bool  known;
    tp_fx px, colour;
} tp_error_price;

/* Work besides finding and shading water, counted by works.c: each with its price.  Of the
 * boat: faces that a picture places; looked through for a band of rows; behind, in front,
 * in a band, and their pixels; cut by the level or the view, in a band. */
#define TP_WORKS(X) \
    X(sky_dome) X(sky_quick) X(sky_stars) X(sky_cube) X(sky_hdr) \
    X(haze) X(haze_dome) X(haze_cube) X(hdr) X(solid) \
    X(boat_face) X(boat_scan) X(boat_back) X(boat_piece) X(boat_fill) X(boat_cut) \
    X(mirror_fill) X(looked) X(looked_near) X(rings) X(ball) X(wall) X(walled) \
    X(wall_face)     X(pane) X(side) X(side_face) \
    X(caustic_pool) X(caustic_sea) X(land) X(land_row) X(land_cell) X(land_cut) \
    X(land_off)     X(surf) X(land_drawn) X(land_fill)

enum {
#define X(name) TP_WORK_##name,
    TP_WORKS(X)
#undef X
    TP_WORK_COUNT
};

typedef struct {
    uint32_t of[TP_WORK_COUNT];
    uint32_t hidden;            /* pixels of water behind what is not water */
    uint32_t solid;             /* pixels of that */
} tp_works;

typedef struct {
    tp_fx frame;                /* thousands a frame */
    tp_fx sky;                  /* a pixel */
    tp_fx slope_colour;         /* rms of 255 that slopes of rms 1 make */
    tp_seen_price   seen[TP_VISIBILITIES][TP_LODS];
    tp_shaded_price shaded[TP_SHADINGS][TP_RATES];
    tp_fx           work[TP_WORK_COUNT];
    tp_error_price  error[TP_KINDS][TP_KIND_RUNGS][TP_SEA_CLASSES];
} tp_prices;

extern const tp_prices tp_prices_measured;

/* The input of a plan: a scene that passes tp_scene_check, its assets, the picture's size
 * and the modules of a program. */
typedef struct {
    const tp_use    *modules;
    const tp_scene  *scene;
    const tp_assets *assets;
    uint32_t width, height;
} tp_plan_input;

/* The plan by any table. */
tp_rungs tp_rungs_by(const tp_prices *prices, const tp_plan_input *in);
tp_plan_report tp_plan_by(const tp_prices *prices, const tp_plan_input *in);

/* The price by which rungs are chosen.  It lacks the works, which no rung changes much and
 * which reports alone add. */
tp_price tp_price_by(const tp_prices *prices, const tp_plan_input *in);

tp_ladder tp_ladder_by(const tp_prices *prices, const tp_plan_input *in);

/* True if some wave is too faint to be drawn as it is, seen from the scene's camera. */
bool tp_thins_sea(const tp_plan_input *in);

/* -- outlook.c: an estimate of what the camera sees at the start ---------------------- */

typedef struct {
    uint32_t water_pixels, other_pixels, vertices, waves;
    int32_t  focal;             /* pixels of a metre, a metre away */
    tp_fx    near;              /* m to the nearest water */
    uint8_t  trait[TP_TRAIT_COUNT];     /* how often */
    uint8_t  sea;               /* its class */
    uint8_t  pools, rings, ocean;       /* that raise the grid's crossings */
    uint8_t  stirred;           /* pools or rings, also as slopes of a flat surface */
    uint8_t  floor;             /* 1: a plane, 2: a map */
    uint32_t drawn;             /* cells of the grid that get a pixel */
    tp_fx    slant;             /* of the view to the grid's lines, up to 3 */
    uint8_t  sharp, still, plain;       /* some wave is no sine; level; swells alone */
    uint32_t points[TP_VISIBILITIES];   /* that each method works out */
    uint8_t  fits[TP_VISIBILITIES];     /* whether it draws this view */
    uint32_t modules;           /* bits of tp_module.is of those that are on */
    uint8_t  quick;             /* whether the quick stages know all that the water has */
} tp_outlook;

tp_outlook tp_outlook_of(const tp_plan_input *in);

/* -- works.c: what else is done ------------------------------------------------------ */

/* `quick`: by the quick stages. */
tp_works tp_works_of(const tp_plan_input *in, const tp_outlook *outlook, bool quick);
#endif
