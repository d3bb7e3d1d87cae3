/* SPDX-License-Identifier: MIT */
/* Measured costs and errors of the rungs.  Costs are Cortex-M4 instructions.  Errors
 * are relative to a reference picture (tests/lib/quality_error.h), minus the error of the
 * exact rungs.  The table is generated from assets/charts/prices.csv. */
#ifndef TP_QUALITY_PRICES_H
#define TP_QUALITY_PRICES_H
#include "quality/plan.h"
#include "tidepool/modules.h"
#include "world/module.h"

enum { TP_KIND_VISIBILITY, TP_KIND_SHADING, TP_KIND_RATE, TP_KIND_LOD };
enum { TP_VISIBILITIES = 4, TP_SHADINGS = 2, TP_RATES = 3, TP_LODS = 2 };

/* Classes of sea: by slope, then by gloss; both determine the errors. sparks: the
 * specular lobe is so sharp and bright that glints are smaller than a pixel. ocean: steep
 * coastal water, over a floor or in a wind. */
enum {
    TP_SEA_LEVEL, TP_SEA_LEVEL_GLOSSY, TP_SEA_LEVEL_SPARKS,
    TP_SEA_GENTLE, TP_SEA_GENTLE_GLOSSY, TP_SEA_GENTLE_SPARKS,
    TP_SEA_STEEP, TP_SEA_STEEP_GLOSSY, TP_SEA_STEEP_SPARKS,
    TP_SEA_OCEAN, TP_SEA_OCEAN_GLOSSY, TP_SEA_OCEAN_SPARKS, TP_SEA_CLASSES
};

/* The cost of a water renderer (visibility). */
typedef struct {
    bool  known;
    tp_fx pixel;                /* instructions per water pixel */
    tp_fx vertex;               /* instructions per evaluated point, plus the fields
                                 * below */
    tp_fx wave, sharp, pool;    /* per wave; per wave of a sharpened sea, extra; per pool */
    tp_fx ocean, floor, map;    /* coastal: with wind only; over a plane; over a map */
    tp_fx drawn;                /* per grid cell that gets a pixel */
    tp_fx slant;                /* times tp_view_estimate.slant */
    tp_fx still;                /* replaces `pixel` for level water */
} tp_seen_price;

/* The cost of a shading of the water, instructions per pixel; some parts are
 * negative. */
typedef struct {
    bool  known;
    tp_fx part[TP_TRAIT_COUNT];
} tp_shaded_price;

typedef struct {
    bool  known;
    tp_fx px, colour;
} tp_error_price;

/* Work besides finding and shading the water; fixed_cost.c counts each kind, and each
 * kind has a cost.  For the boat: boat_face counts the faces of the mesh; boat_scan
 * the faces visited per band of rows; boat_back, boat_piece and boat_fill the back
 * faces, front faces and pixels per band; boat_cut the faces clipped by the water
 * level or the view, per band. */
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
    uint32_t hidden;            /* water pixels behind solid objects */
    uint32_t solid;             /* pixels of solid objects */
} tp_fixed_cost;

typedef struct {
    tp_fx frame;                /* thousands of instructions per frame */
    tp_fx sky;                  /* instructions per sky pixel */
    tp_fx slope_colour;         /* rms colour error (of 255) caused by slopes of rms 1 */
    tp_seen_price   seen[TP_VISIBILITIES][TP_LODS];
    tp_shaded_price shaded[TP_SHADINGS][TP_RATES];
    tp_fx           work[TP_WORK_COUNT];
    tp_error_price  error[TP_KINDS][TP_KIND_RUNGS][TP_SEA_CLASSES];
} tp_prices;

extern const tp_prices tp_prices_measured;

/* The input of a plan: a scene that passes tp_scene_check, its assets, the picture size
 * and the modules of a program. */
typedef struct {
    const tp_use    *modules;
    const tp_scene  *scene;
    const tp_assets *assets;
    uint32_t width, height;
} tp_plan_input;

/* Returns the conditions for asking modules; view_estimate.c. */
tp_want tp_plan_want(const tp_plan_input *in);

/* Compute the rungs and the plan with a given cost table. */
tp_rungs tp_rungs_choose_priced(const tp_prices *prices, const tp_plan_input *in);
tp_plan_report tp_plan_make_priced(const tp_prices *prices, const tp_plan_input *in);

/* Returns the cost used to choose rungs.  The cost excludes the fixed cost: the rungs
 * hardly change the fixed cost, so only reports add it. */
tp_price tp_price_estimate(const tp_prices *prices, const tp_plan_input *in);

tp_ladder tp_ladder_make_priced(const tp_prices *prices, const tp_plan_input *in);

/* True if a wave is culled or drawn lower, seen from the scene's camera. */
bool tp_thins_sea(const tp_plan_input *in);

/* -- view_estimate.c: an estimate of the start camera's view ------------------------- */

typedef struct {
    uint32_t water_pixels, other_pixels, vertices, waves;
    int32_t  focal;             /* size in px of 1 m at a distance of 1 m */
    tp_fx    near;              /* distance to the nearest water, m */
    uint8_t  trait[TP_TRAIT_COUNT];     /* times that a pixel pays it */
    uint8_t  sea;               /* class of sea, TP_SEA_ */
    uint8_t  pools, rings, ocean;       /* number or flag; they raise grid vertices */
    uint8_t  stirred;           /* true with pools or rings, even as slopes only */
    uint8_t  floor;             /* 0: none, 1: a plane, 2: a map */
    uint32_t drawn;             /* grid cells that get a pixel */
    tp_fx    slant;             /* slant of the view to the grid's lines, 0..3 */
    uint8_t  sharp, still, plain;       /* a wave is sharpened; level water; swells only */
    uint32_t points[TP_VISIBILITIES];   /* points evaluated by each renderer */
    uint8_t  fits[TP_VISIBILITIES];     /* true if the renderer can draw the view */
    uint32_t modules;           /* bits of tp_module.is of the enabled modules */
    uint8_t  quick;             /* true if the fast stages support all features */
} tp_view_estimate;

tp_view_estimate tp_view_estimate_make(const tp_plan_input *in);

/* -- fixed_cost.c: fixed cost besides the water ---------------------------------------- */

/* Counts the fixed cost of a frame. `quick`: the water uses the fast stages. */
tp_fixed_cost tp_fixed_cost_estimate(const tp_plan_input *in,
                                     const tp_view_estimate *estimate, bool quick);
#endif
