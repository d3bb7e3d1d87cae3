/* SPDX-License-Identifier: MIT */
/* The loaded scene, ready to be drawn: its file, its assets, its world, a canvas. */
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
    tp_ladder  ladder;          /* ladder at the time the canvas was opened */
} stage;

/* Each function returns an exit code, and prints the reason of a failure; the caller calls
 * stage_close in every case. */
int  stage_open(stage *s, const options *o);
int  stage_load(stage *s, const options *o);    /* all but the canvas */
int  stage_world(stage *s);                     /* at tick 0, of the current scene */
int  stage_canvas(stage *s, const options *o);  /* again after a change of size */
void stage_close(stage *s);

/* stage_read reads the scene and its settings only.  stage_report prints values that the
 * core clamps, and pools with cells too coarse for their parameters (tp_pool_noise). */
int  stage_read(scene_file *file, const options *o);
void stage_report(const scene_file *file, const tp_sea *sea);

/* -- changes while the world moves: stage_set.c ---------------------------------- */

/* A value in the form of scene_file. */
typedef struct {
    char     text[TP_NAME_BYTES];
    uint32_t set_at;            /* as scene_file.set_at */
} stage_value;

stage_value stage_get(const stage *s, const tp_param *param);

/* Sets "name=value" like --set.  Applies the consequences: the world continues with the
 * value, or is made anew at the same place and time; files are loaded; the canvas, if any,
 * is reopened, and *opened is then set.  Returns EXIT_INPUT if the value is refused:
 * everything is unchanged to the bit, and the message begins with `place`. */
int  stage_set(stage *s, const options *o, const char *place, const char *setting,
               bool *opened);

/* The same for a value from stage_get. */
int  stage_put(stage *s, const options *o, const char *place, const tp_param *param,
               const stage_value *value, bool *opened);

/* Sets several values of one moment, in order.  A refused value is tried again after the
 * others: of two bounds the lower cannot always come first.  Returns EXIT_INPUT if some
 * values are refused, each with a message; the others are set. */
typedef struct { const char *place, *setting; } stage_setting;
int  stage_set_all(stage *s, const options *o, const stage_setting *all, size_t count,
                   bool *opened);

/* -- shared by stage.c and stage_set.c ------------------------------------------- */

int  stage_load_assets(asset_set *a, const scene_file *file, const options *o);

/* Returns a world at tick 0, which the caller frees.  NULL: no memory, or impossible for
 * the scene; *err has the reason. */
tp_world *stage_new_world(const tp_scene *scene, const tp_assets *names, size_t *bytes,
                          tp_error *err);
void stage_take_world(stage *s, tp_world *world, size_t bytes);

/* Plans a canvas of the current scene; allocates nothing.  Returns EXIT_INPUT if --memory
 * does not suffice. */
int  stage_plan(const stage *s, const options *o, const asset_set *a, size_t world_bytes,
                canvas *c);
tp_ladder stage_ladder(const stage *s);
#endif
