/* SPDX-License-Identifier: MIT */
/* The plan: by which methods a scene is drawn.  A pure function of scene, picture size
 * and the scene's error budget, in integers, priced in Cortex-M4 instructions on every
 * machine: so every machine draws the same bits.
 *
 * A rung is one method of a kind, cheaper or closer to the truth than its neighbours. */
#ifndef TP_PLAN_H
#define TP_PLAN_H
#include <stdbool.h>
#include <stdint.h>
#include "tidepool/scene.h"

/* How water is found in the picture.  What a method cannot show (overhangs, a camera in
 * the water, strong roll ...) the frame draws as triangles. */
typedef enum {
    TP_VISIBILITY_AUTO, TP_VISIBILITY_TRIANGLES, TP_VISIBILITY_ROWS,
    TP_VISIBILITY_PROJECTED, TP_VISIBILITY_FLAT
} tp_visibility;

/* Exact stages, or those in slope space that take nearest texels. */
typedef enum { TP_SHADING_AUTO, TP_SHADING_EXACT, TP_SHADING_QUICK } tp_shading;

/* What is worked out for every second pixel only. */
typedef enum { TP_RATE_AUTO, TP_RATE_FULL, TP_RATE_LAYERS, TP_RATE_COLOUR } tp_rate;

/* Fewer lines of the grid where they lie close. */
typedef enum { TP_LOD_AUTO, TP_LOD_OFF, TP_LOD_ON } tp_lod;

typedef struct {
    tp_visibility visibility;   /* never AUTO, and so the others */
    tp_shading    shading;
    tp_rate       rate;
    tp_lod        lod;
} tp_rungs;

tp_rungs tp_rungs_of(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                     uint32_t height);
#endif
