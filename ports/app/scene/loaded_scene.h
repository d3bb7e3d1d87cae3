/* SPDX-License-Identifier: MIT */
/* The loaded scene, ready to be drawn: its file, its assets, its world, a frame
 * renderer. */
#ifndef TP_APP_SCENE_LOADED_SCENE_H
#define TP_APP_SCENE_LOADED_SCENE_H
#include "app/cli/args.h"
#include "assets.h"
#include "frame_renderer.h"
#include "interact/boards.h"
#include "quality/plan.h"
#include "scene_file.h"
#include "waves/deep_water.h"

typedef struct {
    scene_file file;
    asset_set  assets;
    asset_set  whole;           /* with all of the boat's faces, by which the plan counts;
                                 * empty if `assets` has them */
    tp_world  *world;           /* in a block of world_bytes */
    size_t     world_bytes;
    frame_renderer renderer;
    board_frame frame;          /* of the board that the scene named when it was loaded */
    tp_plan    plan;            /* rungs of the rows that the scene leaves open */
} loaded_scene;

/* Each function returns an exit code, and prints the reason of a failure; the caller calls
 * loaded_scene_close in every case. */
int loaded_scene_open(loaded_scene *s, const options *o);
int loaded_scene_load(loaded_scene *s, const options *o); /* all but the renderer */
int loaded_scene_make_world(loaded_scene *s); /* at tick 0, of the current scene */
int loaded_scene_open_renderer(loaded_scene *s,
                               const options *o); /* again after a change of size */
void loaded_scene_close(loaded_scene *s);

/* loaded_scene_read reads the scene and its settings only.  loaded_scene_report_clamps
 * prints values that the core clamps, and pools with cells too coarse for their
 * parameters (tp_pool_rounding_noise). */
int  loaded_scene_read(scene_file *file, const options *o);
void loaded_scene_report_clamps(const scene_file *file, const tp_deep_water *deep);

/* -- changes while the world moves: loaded_scene_set.c ------------------------------- */

/* A value in the form of scene_file. */
typedef struct {
    char     text[TP_NAME_BYTES];
    uint32_t set_at;            /* as scene_file.set_at */
} loaded_scene_value;

loaded_scene_value loaded_scene_get(const loaded_scene *s, const tp_param *param);

/* Sets "name=value" like --set.  Applies the consequences: the world continues with the
 * value, or is made anew at the same place and time; files are loaded; the frame renderer,
 * if any, is reopened, and *opened is then set.  Returns EXIT_INPUT if the value is
 * refused: everything is unchanged to the bit, and the message begins with `place`. */
int loaded_scene_set(loaded_scene *s, const options *o, const char *place,
                     const char *setting, bool *opened);

/* The same for a value from loaded_scene_get. */
int loaded_scene_put(loaded_scene *s, const options *o, const char *place,
                     const tp_param *param, const loaded_scene_value *value,
                     bool *opened);

/* Sets several values of one moment, in order.  A refused value is tried again after the
 * others: of two bounds the lower cannot always come first.  Returns EXIT_INPUT if some
 * values are refused, each with a message; the others are set. */
typedef struct {
    const char *place, *setting;
} loaded_scene_setting;
int loaded_scene_set_all(loaded_scene *s, const options *o,
                         const loaded_scene_setting *all, size_t count, bool *opened);

/* -- shared by loaded_scene.c and loaded_scene_set.c --------------------------------- */

/* Loads the assets of the scene; the boat's mesh is the plan's, if the scene leaves it
 * open. */
int  loaded_scene_load_assets(const loaded_scene *s, asset_set *a, const options *o);

/* Returns a world at tick 0, which the caller frees.  NULL: no memory, or impossible for
 * the scene; *err has the reason. */
tp_world *loaded_scene_new_world(const tp_scene *scene, const tp_assets *names,
                                 size_t *bytes, tp_error *err);
void loaded_scene_take_world(loaded_scene *s, tp_world *world, size_t bytes);

/* Plans a frame renderer of the current scene; allocates nothing.  Returns EXIT_INPUT if
 * --memory does not suffice. */
int loaded_scene_plan_renderer(const loaded_scene *s, const options *o,
                               const asset_set *a, frame_renderer *c);
#endif
