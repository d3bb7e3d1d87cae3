/* SPDX-License-Identifier: MIT */
/* A frame for tools: its RAM by use, the rungs that it is drawn by, counts of pixels, and
 * pictures that are prepared beforehand. */
#ifndef TP_FRAME_TOOLS_H
#define TP_FRAME_TOOLS_H
#include "scene/plan.h"
#include "tidepool/frame.h"

/* Bytes of RAM by use. */
typedef struct {
    size_t frame;                   /* the block of tp_frame_bytes */
    size_t vertices, tables;        /* the two large parts of it */
    size_t mirror;                  /* of the block, for mirrored and sunken objects */
    size_t scratch;                 /* of one tile: its samples and pixels */
} tp_ram_use;

/* The frame's block holds what the scene needs at init, nothing for what it lacks:
 *  - vertices: the grid and its crossings, the boat's and the land's corners, drops, rings,
 *    specks of spray
 *  - tables: a sky's gradient; shininess, if the program has lit water; of a
 *    generated or cube sky, the exposure, the boat's materials, slopes of pools that bend
 *    the light only; glass, walls inside a pool, the map of caustics (2 bytes a cell)
 *  - mirror: with mirror.objects = stencil a picture of half the size and four rows of
 *    samples, 88320 bytes at 320x240; with mirror.size = quarter 24960.  88320 more for
 *    objects seen under water (water.clear).  With mirror.objects = cube 24576 bytes at
 *    any size.  Each has up to 128 bytes of numbers besides. */

tp_ram_use tp_frame_ram(const tp_frame *frame);

/* The rungs of the frames from the next on, as a governor wants them; NULL: the plan's
 * again, which is made at init, and anew when quality.* has changed.  Where the frame has
 * no memory for a rung (tp_reach) the exact one is taken. */
void tp_frame_set_rungs(tp_frame *frame, const tp_rungs *rungs);

/* Tiles of the picture. */
uint32_t tp_frame_tiles(const tp_frame *frame);

/* Pictures as the quick rung wants them, made beforehand for whoever puts them in ROM:
 * assets.graded by the layer, then offsets, then slopes.  0: the scene has none; memory
 * aligned to 4. */
#define TP_PREPARED (TP_LAYERS + 2)
size_t tp_prepared_bytes(const tp_assets *assets, int i);
void   tp_prepare(tp_texture *to, const tp_scene *scene, const tp_assets *assets, int i,
                  void *memory);

/* The name of the first module that the last tp_frame_begin found without a stage that the
 * picture needs; "sky": no module draws the sky that the scene names.  NULL: no stage was
 * missing.  Other things that are dropped have no name. */
const char *tp_frame_lacks(const tp_frame *frame);

/* Water pixels of a drawn tile: still in the scratch until the next tile. */
uint32_t tp_frame_water_pixels(const tp_frame *frame, const void *scratch,
                               const tp_tile *tile);
#endif
