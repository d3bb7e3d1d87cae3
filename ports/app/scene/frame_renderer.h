/* SPDX-License-Identifier: MIT */
/* Draws a whole picture by tiles, with one thread or several. */
#ifndef TP_APP_SCENE_FRAME_RENDERER_H
#define TP_APP_SCENE_FRAME_RENDERER_H
#include "app/files/picture.h"
#include "machine.h"
#include "quality/plan.h"
#include "thread_pool.h"
#include "tidepool/modules.h"

#define FRAME_RENDERER_THREADS 64

typedef struct {
    picture   picture;          /* pixels of the last frame_renderer_draw */
    tp_frame *frame;
    const machine *machine;
    tp_program program;         /* copy of the machine's program; may stream or time */
    bool      stream;           /* stream grid vertices instead of storing them */
    tp_plan   plan;             /* rungs that the scene leaves open; open = 0: none */
    const tp_scene *scene;      /* of the caller */
    tp_scene *drawn;            /* copy of it with the plan's rungs */
    void     *block;            /* memory of the frame */
    size_t    frame_bytes, scratch_bytes;       /* scratch: sum of all threads */
    uint32_t  threads;
    thread_pool *pool;          /* threads that help the caller; NULL: none */
    void     *scratch[FRAME_RENDERER_THREADS];
    tp_config config;           /* configuration, with tile sides chosen */
    uint32_t  water_pixels;     /* pixels of water in the last frame_renderer_draw */
    uint32_t begin_us,
        tiles_us;               /* duration of the last frame_renderer_draw, us: geometry,
                                 * then pixels by all threads */
} frame_renderer;

/* Sets how the picture is drawn; allocates nothing.  Tile sides of 0: the frame renderer
 * chooses.  The defaults are the best machine for this processor and stored grid vertices;
 * the caller may then set `machine`, `stream` or `plan`. */
void frame_renderer_plan(frame_renderer *c, const tp_config *config, uint32_t threads);

/* To call after frame_renderer_plan: computes frame_bytes and scratch_bytes without
 * allocation. */
void frame_renderer_measure(frame_renderer *c, const tp_scene *scene,
                            const tp_assets *assets);

/* To call after frame_renderer_plan.  scene and assets must outlive the frame renderer.
 * Returns an exit code, and prints the reason of a failure; the caller calls
 * frame_renderer_close in every case. */
int  frame_renderer_open(frame_renderer *c, const tp_scene *scene, const tp_assets *assets);

/* Opens the frame again with other rungs for the scene's open rows; picture and threads
 * stay.  Returns an exit code; without memory the frame is as it was. */
int  frame_renderer_set_rungs(frame_renderer *c, const tp_rung_set *set);

void frame_renderer_draw(frame_renderer *c, const tp_world *world);
void frame_renderer_close(frame_renderer *c);
#endif
