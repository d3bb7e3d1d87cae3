/* SPDX-License-Identifier: MIT */
/* Draws a whole picture by tiles, with one thread or several. */
#ifndef HOST_CANVAS_H
#define HOST_CANVAS_H
#include "crew.h"
#include "machine.h"
#include "picture.h"
#include "tidepool/modules.h"

#define CANVAS_THREADS 64

typedef struct {
    picture   picture;          /* pixels of the last canvas_draw */
    tp_frame *frame;
    const machine *machine;
    tp_program program;         /* copy of the machine's program; may stream or time */
    bool      stream;           /* stream grid vertices instead of storing them */
    void     *block;            /* memory of the frame */
    size_t    frame_bytes, scratch_bytes;       /* scratch: sum of all threads */
    uint32_t  threads;
    crew     *crew;             /* threads that help the caller; NULL: none */
    void     *scratch[CANVAS_THREADS];
    tp_config config;           /* configuration, with tile sides chosen */
    uint32_t  water_pixels;     /* pixels of water in the last canvas_draw */
    uint32_t  begin_us, tiles_us;       /* duration of the last canvas_draw, us: geometry,
                                         * then pixels by all threads */
} canvas;

/* Sets how the picture is drawn; allocates nothing.  Tile sides of 0: the canvas chooses.
 * The defaults are the best machine for this processor and stored grid vertices; the caller
 * may then set `machine` or `stream`. */
void canvas_plan(canvas *c, const tp_config *config, uint32_t threads);

/* To call after canvas_plan: computes frame_bytes and scratch_bytes without allocation. */
void canvas_count(canvas *c, const tp_scene *scene, const tp_assets *assets);

/* To call after canvas_plan.  scene and assets must outlive the canvas.  Returns an exit
 * code, and prints the reason of a failure; the caller calls canvas_close in every case. */
int  canvas_open(canvas *c, const tp_scene *scene, const tp_assets *assets);
void canvas_draw(canvas *c, const tp_world *world);
void canvas_close(canvas *c);
#endif
