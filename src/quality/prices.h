/* SPDX-License-Identifier: MIT */
/*
 * Costs for the plan: the measured table of the exact rungs, the estimate of the start
 * camera's view, the fixed cost of features, and wave culling.
 *
 * Costs are Cortex-M4 instructions.  The table is generated from assets/charts/prices.csv.
 */
#ifndef TP_QUALITY_PRICES_H
#define TP_QUALITY_PRICES_H
#include "base/base.h"
#include "tidepool/assets.h"
#include "tidepool/modules.h"
#include "tidepool/scene.h"
#include "waves/deep_water.h"
#include "world/module.h"
#include "world/pools.h"

enum { TP_KIND_VISIBILITY, TP_KIND_SHADING, TP_KIND_RATE };
enum { TP_VISIBILITIES = 4, TP_SHADINGS = 2, TP_RATES = 3 };

/* Classes of sea: by slope, then by gloss; both determine the errors.  sparks: the
 * specular lobe is so sharp and bright that glints are smaller than a pixel. coastal: steep
 * coastal water, over a floor or in a wind. */
enum {
    TP_SEA_LEVEL, TP_SEA_LEVEL_GLOSSY, TP_SEA_LEVEL_SPARKS,
    TP_SEA_GENTLE, TP_SEA_GENTLE_GLOSSY, TP_SEA_GENTLE_SPARKS,
    TP_SEA_STEEP, TP_SEA_STEEP_GLOSSY, TP_SEA_STEEP_SPARKS,
    TP_SEA_COASTAL, TP_SEA_COASTAL_GLOSSY, TP_SEA_COASTAL_SPARKS, TP_SEA_CLASSES
};

/* The cost of a water renderer (visibility). */
typedef struct {
    tp_fx pixel;                /* instructions per water pixel */
    tp_fx vertex;               /* instructions per evaluated point, to which the fields
                                 * below are added */
    tp_fx wave, sharp, pool;    /* per wave; per wave of a sharpened sea, extra; per pool */
    tp_fx coastal, floor, map;  /* coastal: with wind only; over a plane; over a map */
    tp_fx still;                /* replaces `pixel` for level water */
} tp_seen_price;

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
    X(wall_face) X(pane) X(side) X(side_face) \
    X(caustic_pool) X(caustic_sea) X(land) X(land_row) X(land_cell) X(land_cut) \
    X(surf) X(land_drawn) X(land_fill) X(spray)

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
    tp_fx           frame;      /* thousands of instructions per frame */
    tp_fx           sky;        /* instructions per sky pixel */
    tp_fx           slope_colour; /* rms colour error (of 255) caused by slopes of rms 1 */
    tp_seen_price   seen[TP_VISIBILITIES];
    tp_fx           shaded[TP_TRAIT_COUNT];     /* exact shading, instructions per pixel;
                                                 * some are negative */
    tp_fx           work[TP_WORK_COUNT];
} tp_prices;

extern const tp_prices tp_prices_measured;

/* The input of a plan: a scene that passes tp_scene_check, its assets, the picture size
 * and the modules of a program. */
typedef struct {
    const tp_use    *modules;
    const tp_scene  *scene;
    const tp_assets *assets;
    uint32_t         width, height;
} tp_plan_input;

/* view_estimate.c: returns the conditions that decide if a module is on, with all shading
 * rungs allowed.  Chooses nothing itself. */
tp_module_conditions tp_plan_module_conditions(const tp_plan_input *in);

/* -- view_estimate.c: an estimate of the start camera's view ------------------------- */

typedef struct {
    uint32_t water_pixels, other_pixels, vertices, waves;
    tp_fx    unhazed;           /* mean square of the part of water's colour left by haze */
    int32_t  focal;             /* size in px of 1 m at a distance of 1 m */
    tp_fx    near;              /* distance to the nearest water, m */
    uint8_t  trait[TP_TRAIT_COUNT];     /* times that a pixel pays it */
    uint8_t  sea;               /* class of sea, TP_SEA_ */
    uint8_t  pools, rings, coastal;     /* number or flag; they raise grid vertices */
    uint8_t  stirred;           /* true with pools or rings, even as slopes only */
    uint8_t  floor;             /* 0: none, 1: a plane, 2: a map */
    uint8_t  sharp, still;      /* a wave is sharpened; level water */
    uint32_t points[TP_VISIBILITIES];   /* points evaluated by each renderer */
    uint16_t in_view;           /* part of the grid's vertices in view, 256ths: a basin's
                                 * grid is placed whole */
    uint32_t slope_cells;       /* pool cells whose slopes are set in each frame */
    uint8_t  fits[TP_VISIBILITIES];     /* true if the renderer can draw the view */
    uint32_t modules;           /* bits of tp_module.is of the enabled modules */
    uint8_t  quick;             /* true if the fast stages support all features */
    uint8_t  lobe;              /* true if water in view may show the specular lobe */
} tp_view_estimate;

tp_view_estimate tp_view_estimate_make(const tp_plan_input *in);

/* -- fixed_cost.c: the start camera, and its view of level water --------------------- */

/* The camera of the view estimate and of the fixed cost. */

typedef struct {
    tp_vec3     eye;
    tp_rotation turn;
    int64_t     wide, high;     /* tangents of half the picture's angles of view, Q16 */
    tp_rectangle water;         /* extent of the water */
} tp_start_view;

/* Returns the scene's camera at tick 0, for a picture of width x height px, and the extent
 * of the scene's water. */
tp_start_view tp_start_view_make(const tp_scene *scene, uint32_t width, uint32_t height);

/* Returns the ray through (x, y) of the picture: tangents, Q16 per unit ahead, below
 * 2^26. */
tp_vec3 tp_start_view_ray(const tp_start_view *at, int64_t x, int64_t y);

/* Returns the distance ahead, Q16 m, at which the ray through (x, y) meets level water, or
 * 0. */
int64_t tp_start_view_water_distance_ahead(const tp_start_view *at, int64_t x, int64_t y);

/* Returns to - from, clamped to 8 km along each axis. */
static inline tp_vec3 tp_start_view_clamped_vector(tp_vec3 from, tp_vec3 to)
{
    const int64_t most = 1 << 29;

    return (tp_vec3){ (tp_fx)tp_clamp_abs((int64_t)to.x - from.x, most),
                      (tp_fx)tp_clamp_abs((int64_t)to.y - from.y, most),
                      (tp_fx)tp_clamp_abs((int64_t)to.z - from.z, most) };
}

/* -- fixed_cost.c: fixed cost besides the water's pixels ----------------------------- */

/* The fixed cost is counted without drawing: from the geometry of the objects, and with a
 * lattice of rays over the picture of the scene's start camera.  Some rays meet level
 * water, some are stopped by objects. */

/* Counts the fixed cost of a frame. `quick`: the water uses the fast stages. */
tp_fixed_cost tp_fixed_cost_estimate(const tp_plan_input *in,
                                     const tp_view_estimate *estimate, bool quick);

#define TP_RAYS       32        /* rays along each axis; a row of bits is a word */
#define TP_WORK_BAND  16        /* rows of a tile, as a board draws */
#define TP_WORK_STRIP 4         /* rows of a reflection map drawn at once */

typedef struct tp_site {
    const tp_scene *scene;
    const tp_assets *assets;
    const tp_view_estimate *estimate;
    tp_start_view at;
    uint32_t width, height;
    uint32_t is;                /* bits of tp_module.is of the enabled modules */
    bool     mirrors;           /* true if a reflection map of objects is drawn */
    bool     quick;             /* true if water uses the fast stages */
    uint32_t solid[TP_RAYS];    /* bit set: an object stops the ray; lowest row first */
    uint32_t wet[TP_RAYS];      /* bit set: the ray meets level water */
    uint32_t apart;             /* solid rays counted by a module's `stops` */
    int64_t  far;               /* farthest corner of a reflected object, distance, Q16 m */
    tp_fixed_cost fixed_cost;
} tp_site;

/* The number of pixels of a picture, by content. */
typedef struct {
    uint32_t sky, water, solid;
    uint32_t mirrored;          /* water pixels near enough to reflect objects */
    uint32_t stopped;           /* rays stopped by this feature's `stops` */
} tp_work_pixels;

/* The fourth part of a module, used by the plan: the cost of its objects.  A program without
 * the plan does not link this part.  All members may be NULL. */
typedef struct tp_cost {
    /* Counts work known from the geometry, and the rays that its objects stop. */
    void (*work)(tp_site *site);

    /* True if its objects stop a ray that would meet the water `far` (Q16 m) ahead. */
    bool (*stops)(const tp_site *site, tp_vec3 ray, int64_t far);

    /* Counts work by pixels, after the content of all rays is known. */
    void (*pixels)(tp_site *site, const tp_work_pixels *pixels);
} tp_cost;

/* Returns the number of pixels for a number of rays. */
static inline uint32_t tp_work_ray_pixels(const tp_site *site, uint32_t rays)
{
    return (uint32_t)((uint64_t)site->width * site->height * rays / (TP_RAYS * TP_RAYS));
}

/* Returns the number of bands of `band` rows that an object `rows` rows high touches. */
static inline uint32_t tp_work_bands(int64_t rows, int32_t band)
{
    return (uint32_t)(rows / band) + 1;
}

/* Returns the ray in column i, row j of the lattice. */
static inline tp_vec3 tp_work_ray(const tp_site *site, int32_t i, int32_t j)
{
    TP_ASSERT(i >= 0 && i < TP_RAYS && j >= 0 && j < TP_RAYS);
    return tp_start_view_ray(&site->at, site->at.wide * (2 * i + 1 - TP_RAYS) / TP_RAYS,
                             site->at.high * (2 * j + 1 - TP_RAYS) / TP_RAYS);
}

/* -- wave_culling.c: waves too small to be visible ----------------------------------- */

/* Such waves are omitted or drawn lower. */

#define TP_WAVE_CULL_SHARE 4        /* part of the error budget for wave culling, 1/4 */

/* Visibility thresholds of a wave: `px` for its height at the nearest water in pixels,
 * `slope` for its slope.  The other fields convert a height from metres to pixels. */
typedef struct {
    tp_fx   px;
    tp_fx   slope;              /* slope k A */
    int32_t focal;              /* size in px of 1 m at a distance of 1 m */
    tp_fx   near;               /* distance to the nearest water in view, m; > 0 */
} tp_wave_cull_limits;

typedef struct {
    uint32_t left;              /* number of waves drawn */
    bool     any;               /* true if a wave is drawn lower or omitted */
    tp_fx    px, colour;        /* errors caused by culling, all waves together */
} tp_wave_cull;

/* `waves`: number of waves with an amplitude.  `slope_colour`: rms colour error (of 255)
 * caused by slopes of rms 1; 0 means unknown, and no wave is culled. */
tp_wave_cull_limits tp_wave_cull_limits_make(const tp_scene *scene, uint32_t waves,
                                             tp_fx slope_colour);

/* Returns the distance to the nearest water in view, for a camera `height` m above the
 * crests: the point where the lowest ray of the view meets the crest level. */
tp_fx tp_nearest_water_distance(tp_fx height, const tp_rotation *turn, tp_fx fov);

/* Returns the factor, 0..1, for the height of a drawn wave.  The factor is 0 if both
 * height and slope are below their limits, and 1 if either is at least twice its limit.
 * The ramp between the limits prevents sudden appearance or disappearance. */
tp_fx tp_wave_cull_weight(const tp_wave_cull_limits *limits, tp_fx amplitude, tp_fx slope);

tp_wave_cull tp_wave_cull_evaluate(const tp_scene *scene, const tp_wave_cull_limits *limits,
                                   tp_fx slope_colour);

/* Returns the culling of the scene's waves, seen from its start camera. */
tp_wave_cull tp_plan_wave_cull(const tp_scene *scene, const tp_view_estimate *estimate,
                               const tp_prices *prices);

/* True if a wave is culled or drawn lower, seen from the scene's camera. */
bool tp_plan_culls_waves(const tp_plan_input *in);

/* Writes the culled deep water and its phases to `culled` and `culled_phases`.
 * Returns false and writes nothing if no wave is culled.  The bounds in `culled` stay
 * the bounds of `whole`. */
bool tp_wave_cull_deep_water(tp_deep_water *culled, tp_turn culled_phases[TP_WAVES],
                             const tp_deep_water *whole, const tp_turn phases[TP_WAVES],
                             const tp_wave_cull_limits *limits);

#endif
