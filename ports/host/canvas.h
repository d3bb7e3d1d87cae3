/* SPDX-License-Identifier: MIT */
/* A whole picture drawn by the core's tiles, by one thread or several. */
#ifndef HOST_CANVAS_H
#define HOST_CANVAS_H
#include "crew.h"
#include "machine.h"
#include "picture.h"
#include "tidepool/modules.h"

#define CANVAS_THREADS 64

typedef struct {
    picture   picture;          /* of the last canvas_draw */
    tp_frame *frame;
    const machine *machine;
    tp_program program;         /* a copy of the machine's, streaming or timed if asked */
    bool      stream;           /* without stored crossings */
    void     *block;            /* that the frame lies in */
    size_t    frame_bytes, scratch_bytes;       /* scratch: of all threads */
    uint32_t  threads;
    crew     *crew;             /* that helps the caller; NULL: none */
    void     *scratch[CANVAS_THREADS];
    tp_config config;           /* with the tiles' sides chosen */
    uint32_t  water_pixels;     /* of the last canvas_draw ... */
    uint32_t  begin_us, tiles_us;       /* ... and what its two parts took: geometry, then
                                           pixels by all threads */
} canvas;

/* Sets how the picture will be drawn; nothing is allocated.  Tile sides of 0 let the canvas
 * choose.  The plan takes the best machine that runs here and stores crossings; the caller
 * may then set another `machine` or `stream`. */
void canvas_plan(canvas *c, const tp_config *config, uint32_t threads);

/* After the plan: frame_bytes and scratch_bytes, before anything is allocated. */
void canvas_count(canvas *c, const tp_scene *scene, const tp_assets *assets);

/* After the plan; scene and assets must outlive the canvas.  Returns an exit code and has
 * said why; close in any case. */
int  canvas_open(canvas *c, const tp_scene *scene, const tp_assets *assets);
void canvas_draw(canvas *c, const tp_world *world);
void canvas_close(canvas *c);
#endif
