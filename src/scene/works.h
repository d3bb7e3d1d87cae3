/* SPDX-License-Identifier: MIT */
/* The cost of a feature besides the water's pixels: the fourth piece of a module, which
 * reports of the plan ask.  A program that makes no reports does not link it.
 *
 * Works are counted without drawing: by the things' own geometry, and by rays of a lattice
 * over the picture, of which some meet the level water and some are stopped by things. */
#ifndef TP_SCENE_WORKS_H
#define TP_SCENE_WORKS_H
#include "scene/module.h"
#include "scene/stand.h"

#define TP_RAYS       32        /* each way; a row is a word */
#define TP_WORK_BAND  16        /* rows of a tile, as a board draws */
#define TP_WORK_STRIP 4         /* rows of a mirrored picture that are drawn at once */

typedef struct tp_site {
    const tp_scene   *scene;
    const tp_assets  *assets;
    const tp_outlook *outlook;
    tp_stand at;
    uint32_t width, height;
    uint32_t is;                /* bits of tp_module.is of the modules that are on */
    bool     mirrors;           /* a picture of objects in the water is drawn, */
    bool     quick;             /* water by the fast stages */
    uint32_t solid[TP_RAYS];    /* rays that something stops, from the lowest row up */
    uint32_t wet[TP_RAYS];      /* rays that meet the level water */
    uint32_t apart;             /* solid rays whose stoppers have a price of their own */
    int64_t  far;               /* m to the farthest mirrored corner, Q16 */
    tp_works works;
} tp_site;

/* Pixels of a picture by what they show. */
typedef struct {
    uint32_t sky, water, solid;
    uint32_t mirrored;          /* of the water, near enough to mirror objects */
    uint32_t stopped;           /* rays that this feature's `stops` stopped */
} tp_work_pixels;

/* All may be NULL. */
typedef struct tp_cost {
    /* Counts works that its geometry tells, and the rays that its things stop. */
    void (*work)(tp_site *site);

    /* True if its things stop a ray that would meet the water `far` m ahead, Q16. */
    bool (*stops)(const tp_site *site, tp_vec3 ray, int64_t far);

    /* Counts works by pixels, when it is known what all rays meet. */
    void (*pixels)(tp_site *site, const tp_work_pixels *pixels);
} tp_cost;

/* The pixels that so many rays stand for. */
static inline uint32_t tp_work_pixels_of(const tp_site *site, uint32_t rays)
{
    return (uint32_t)((uint64_t)site->width * site->height * rays / (TP_RAYS * TP_RAYS));
}

/* Bands of so many rows that a thing of such a height touches. */
static inline uint32_t tp_work_bands(int64_t rows, int32_t band)
{
    return (uint32_t)(rows / band) + 1;
}

/* The ray of the lattice in column i of row j. */
static inline tp_vec3 tp_work_ray(const tp_site *site, int32_t i, int32_t j)
{
    TP_ASSERT(i >= 0 && i < TP_RAYS && j >= 0 && j < TP_RAYS);
    return tp_stand_ray(&site->at, site->at.wide * (2 * i + 1 - TP_RAYS) / TP_RAYS,
                        site->at.high * (2 * j + 1 - TP_RAYS) / TP_RAYS);
}
#endif
