/* SPDX-License-Identifier: MIT */
/* Shared by the files of the page's WebAssembly module.  There is one page, so the state
 * is global.  Pages call the exported functions; text is exchanged in web_text. */
#ifndef TP_WEB_WEB_H
#define TP_WEB_WEB_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/tidepool.h"

/* Defines web_NAME, exported to the page as NAME. */
#define EXPORT(type, name, ...) \
    type web_##name(__VA_ARGS__); \
    __attribute__((export_name(#name))) type web_##name(__VA_ARGS__)

/* -- memory.c: a stack of memory ----------------------------------------------------- */

void     *web_take(size_t bytes);       /* aligned to 16; NULL: out of memory */
uintptr_t web_mark(void);
void      web_restore_mark(uintptr_t mark);  /* frees all taken since the mark */

/* -- values.c ------------------------------------------------------------------------ */

#define WEB_TEXT_BYTES 65536            /* also the size of a piece of a file */
extern char     web_text[WEB_TEXT_BYTES];
extern tp_scene web_scene, web_filed;   /* changed scene; scene as in its file */

int web_refuse(const tp_error *err);    /* writes the error's text to web_text; returns
                                         * its code */

/* -- web.c --------------------------------------------------------------------------- */

tp_world *web_world(void);              /* NULL: none */
void      web_drop(void);               /* frees world and picture */
int       web_changed(bool anew);       /* after a change taken by the world; anew: make
                                         * a new frame */

/* -- plan.c: the rungs of the picture ------------------------------------------------ */

void      web_plan_make(uint32_t width, uint32_t height);   /* for a new world */
bool      web_plan_renew(uint32_t width, uint32_t height);  /* true if rungs change */
int       web_plan_took(uint32_t us);   /* time of a frame; steps down, negative: up */

/* Returns the scene as drawn, renewed from web_scene: the plan's rungs in open rows. */
const tp_scene *web_plan_drawn(void);

/* -- scenes: written by scenes.awk from assets/scenes -------------------------------- */

/* The text of each scene: the scene's name in the first line, then the lines "[section]"
 * and "name=value" of the scene's file.  The array has web_scene_count texts. */
extern const char *const web_scenes[];
extern const uint32_t web_scene_count;

/* -- assets.c: files named by scenes ------------------------------------------------- */

enum { WEB_NOTHING, WEB_PICTURE, WEB_GREY, WEB_TEXT };      /* kinds of files */

extern tp_assets web_assets;

/* Puts the present files into web_assets.  Returns false if a file is missing; its kind
 * and name are then in web_kind and web_name. */
bool web_find_assets(const tp_scene *scene);
extern int  web_kind;
extern char web_name[TP_NAME_BYTES];
#endif
