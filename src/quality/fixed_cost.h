/* SPDX-License-Identifier: MIT */
/*
 * The cost of a feature besides the water's pixels: the fourth part of a module, used for
 * reports of the plan.  A program without reports does not link this part.
 *
 * The fixed cost is counted without drawing: from the geometry of the objects, and with a
 * lattice of rays over the picture of the scene's start camera.  Some rays meet level
 * water, some are stopped by objects.  The view estimate uses the same camera.
 */
#ifndef TP_QUALITY_FIXED_COST_H
#define TP_QUALITY_FIXED_COST_H
#include "base/base.h"
#include "quality/prices.h"
#include "world/module.h"
#include "world/pools.h"

/* -- the start camera, and its view of level water ----------------------------------- */

typedef struct {
    tp_vec3     eye;
    tp_rotation turn;
    int64_t     wide, high;     /* tangents of half the picture's angles of view, Q16 */
    int64_t     x, z;           /* centre of the grid, m */
    tp_rectangle water;         /* extent of the water */
} tp_start_view;

tp_start_view tp_start_view_make(const tp_scene *scene, uint32_t width, uint32_t height);

/* Returns the coordinate of a position `line` lines (Q16) from the middle of an axis.
 * Steps between lines of the skirt grow outwards. */
int64_t tp_start_view_line_coordinate(const tp_scene *scene, int32_t lines, int64_t centre,
                           int64_t line);

/* Returns the ray through (x, y) of the picture: tangents, Q16 per unit ahead, below
 * 2^26. */
tp_vec3 tp_start_view_ray(const tp_start_view *at, int64_t x, int64_t y);

/* Returns the distance ahead, Q16 m, at that the ray through (x, y) meets level water, or
 * 0. */
int64_t tp_start_view_water_distance(const tp_start_view *at, int64_t x, int64_t y);

/* Returns to - from, clamped to 8 km along each axis. */
static inline tp_vec3 tp_start_view_clamped_vector(tp_vec3 from, tp_vec3 to)
{
    const int64_t most = 1 << 29;

    return (tp_vec3){ (tp_fx)tp_clamp_abs((int64_t)to.x - from.x, most),
                      (tp_fx)tp_clamp_abs((int64_t)to.y - from.y, most),
                      (tp_fx)tp_clamp_abs((int64_t)to.z - from.z, most) };
}

/* -- fixed cost ---------------------------------------------------------------------- */

#define TP_RAYS       32        /* rays along each axis; a row of bits is a word */
#define TP_WORK_BAND  16        /* rows of a tile, as a board draws */
#define TP_WORK_STRIP 4         /* rows of a reflection map drawn at once */

typedef struct tp_site {
    const tp_scene   *scene;
    const tp_assets  *assets;
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

/* All members may be NULL. */
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

#endif
