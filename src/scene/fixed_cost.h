/* SPDX-License-Identifier: MIT */
/* The cost of a feature besides the water's pixels: the fourth part of a module, used for
 * reports of the plan.  A program without reports does not link this part.
 *
 * Works are counted without drawing: from the geometry of the objects, and with a lattice
 * of rays over the picture.  Some rays meet level water, some are stopped by objects. */
#ifndef TP_SCENE_FIXED_COST_H
#define TP_SCENE_FIXED_COST_H
#include "scene/module.h"
#include "scene/start_view.h"

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
    /* Counts works known from the geometry, and the rays that its objects stop. */
    void (*work)(tp_site *site);

    /* True if its objects stop a ray that would meet the water `far` (Q16 m) ahead. */
    bool (*stops)(const tp_site *site, tp_vec3 ray, int64_t far);

    /* Counts works by pixels, after the content of all rays is known. */
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
