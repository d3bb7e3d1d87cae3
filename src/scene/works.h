/* SPDX-License-Identifier: MIT */
/* What the parts of works.c share. */
#ifndef TP_SCENE_WORKS_H
#define TP_SCENE_WORKS_H
#include "scene/prices.h"
#include "scene/stand.h"

#define TP_RAYS       32        /* each way; a row is a word */
#define TP_WORK_BAND  16        /* rows of a tile, as a board draws */
#define TP_WORK_STRIP 4         /* rows of a mirrored picture that are drawn at once */

typedef struct {
    const tp_scene  *scene;
    const tp_assets *assets;
    tp_stand at;
    uint32_t width, height;
    bool     mirrors;           /* objects */
    uint32_t solid[TP_RAYS];    /* rays that something stops, from the lowest row up */
    uint32_t wet[TP_RAYS];      /* rays that meet the level water */
    uint32_t walls, lands;      /* of the solid ones, that walls stop, and land */
    int64_t  far;               /* m to the farthest mirrored corner, Q16 */
    tp_works works;
} tp_site;

void tp_site_add_drops(tp_site *site, const tp_outlook *outlook);
void tp_site_add_walls(tp_site *site, const tp_outlook *outlook);
void tp_site_add_glass(tp_site *site);
void tp_site_add_bed(tp_site *site);

/* Whether the floor lies above the level where a ray would meet it, so far ahead. */
bool tp_site_land(const tp_site *site, tp_vec3 ray, int64_t far);

/* Whether a wall in the pool stops a ray that would meet water so far ahead. */
bool tp_site_wall(const tp_site *site, tp_vec3 ray, int64_t far);
#endif
