/* SPDX-License-Identifier: MIT */
/* A frame for tools: the rungs that it is drawn by, counts of pixels, and pictures that
 * are prepared beforehand. */
#ifndef TP_FRAME_TOOLS_H
#define TP_FRAME_TOOLS_H
#include "scene/plan.h"
#include "tidepool/frame.h"

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
