/* SPDX-License-Identifier: MIT */
/* A whole picture drawn by the core's tiles, by one thread or several. */
#ifndef HOST_CANVAS_H
#define HOST_CANVAS_H
#include "picture.h"
#include "tidepool/frame.h"

#define CANVAS_THREADS 64

typedef struct {
    picture   picture;          /* of the last canvas_draw */
    tp_frame *frame;
    void     *block;            /* that the frame lies in */
    uint32_t  threads;
    void     *scratch[CANVAS_THREADS];
    uint32_t  water_pixels;     /* of the last canvas_draw */
} canvas;

/* Tile sides of 0 let the canvas choose.  The scene and the assets must outlive it.
 * Returns an exit code and has said why; close in any case. */
int  canvas_open(canvas *c, const tp_scene *scene, const tp_assets *assets,
                 const tp_frame_config *config, uint32_t threads);
void canvas_draw(canvas *c, const tp_world *world);
void canvas_close(canvas *c);
#endif
