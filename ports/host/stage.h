/* SPDX-License-Identifier: MIT */
/* A scene made ready to be drawn: its file, what it names, its world. */
#ifndef HOST_STAGE_H
#define HOST_STAGE_H
#include "args.h"
#include "assets.h"
#include "canvas.h"
#include "scene/plan.h"
#include "scene_file.h"
#include "wave/wave.h"

typedef struct {
    scene_file file;
    asset_set  assets;
    tp_world  *world;           /* in a block of world_bytes */
    size_t     world_bytes;
    canvas     canvas;
    tp_ladder  ladder;          /* that the canvas was opened for */
} stage;

/* Each returns an exit code and has said why; close in any case. */
int  stage_open(stage *s, const options *o);
int  stage_load(stage *s, const options *o);    /* all but the canvas */
int  stage_world(stage *s);                     /* at tick 0, of the scene as it is now */
int  stage_canvas(stage *s, const options *o);  /* again after the size has changed */
void stage_close(stage *s);

/* The scene and its settings alone; and a report of it: what the core has to clamp, and
 * pools whose cells are too coarse for their numbers (tp_pool_noise). */
int  stage_read(scene_file *file, const options *o);
void stage_report(const scene_file *file, const tp_sea *sea);

/* -- changes while the world moves: stage_set.c ---------------------------------- */

/* A value, as scene_file has it. */
typedef struct {
    char     text[TP_NAME_BYTES];
    uint32_t set_at;            /* as scene_file.set_at */
} stage_value;

stage_value stage_get(const stage *s, const tp_param *param);

/* "name=value" as by the command line's --set.  What it needs is done: the world goes on
 * with it, or is made anew at the same place and time, files are loaded, and the canvas,
 * if there is one, is opened again; *opened is then set.  EXIT_INPUT: refused, all is as
 * it was to the bit, and the message begins with `place`. */
int  stage_set(stage *s, const options *o, const char *place, const char *setting,
               bool *opened);

/* The same of one value that was had by stage_get. */
int  stage_put(stage *s, const options *o, const char *place, const tp_param *param,
               const stage_value *value, bool *opened);

/* Several of one moment, in their order; what is refused is tried again after the others:
 * of two bounds the lower cannot always come first.  EXIT_INPUT: some are refused, which
 * is said of each, and the others are done. */
typedef struct { const char *place, *setting; } stage_setting;
int  stage_set_all(stage *s, const options *o, const stage_setting *all, size_t count,
                   bool *opened);

/* -- between stage.c and stage_set.c --------------------------------------------- */

int  stage_load_assets(asset_set *a, const scene_file *file, const options *o);

/* At tick 0, to free; NULL: no memory, or not of this scene, and *err tells. */
tp_world *stage_new_world(const tp_scene *scene, const tp_assets *names, size_t *bytes,
                          tp_error *err);
void stage_take_world(stage *s, tp_world *world, size_t bytes);

/* What a canvas of the scene as it is now will be; nothing is allocated.  EXIT_INPUT:
 * --memory does not allow it. */
int  stage_plan(const stage *s, const options *o, const asset_set *a, size_t world_bytes,
                canvas *c);
tp_ladder stage_ladder(const stage *s);
#endif
