/* SPDX-License-Identifier: MIT */
/* The module of the page: what its files share.  There is one page, so all that it shows
 * lies in one place.  Pages call what is exported; text goes both ways in web_text. */
#ifndef WEB_H
#define WEB_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/tidepool.h"

/* web_NAME, a function that the page calls as NAME. */
#define EXPORT(type, name, ...) \
    type web_##name(__VA_ARGS__); \
    __attribute__((export_name(#name))) type web_##name(__VA_ARGS__)

/* -- memory.c: a stack ----------------------------------------------------------- */

void     *web_take(size_t bytes);       /* aligned to 16; NULL: there is no more */
uintptr_t web_mark(void);
void      web_back_to(uintptr_t mark);  /* gives back all that was taken since */

/* -- values.c -------------------------------------------------------------------- */

#define WEB_TEXT_BYTES 65536            /* also of a piece of a file */
extern char     web_text[WEB_TEXT_BYTES];
extern tp_scene web_scene, web_filed;   /* as changed, and as the file has it */

int web_refuse(const tp_error *err);    /* its sentence into web_text; its code */

/* -- web.c ----------------------------------------------------------------------- */

tp_world *web_world(void);              /* NULL: there is none */
void      web_drop(void);               /* gives it back, and the picture */
int       web_changed(bool anew);       /* a value has, and the world goes on; anew: by
                                           another frame */

/* -- scenes: written by scenes.awk from assets/scenes -------------------------------
 *
 * A name in the first line, then "[section]" and "name=value" as in their files. */
extern const char *const web_scenes[];
extern const uint32_t web_scene_count;

/* -- assets.c: what scenes name -------------------------------------------------- */

enum { WEB_NOTHING, WEB_PICTURE, WEB_GREY, WEB_TEXT };      /* kinds of files */

extern tp_assets web_assets;

/* Puts what has been brought into web_assets; false: a file is missing, its kind and its
 * name in web_kind, web_name. */
bool web_find_assets(const tp_scene *scene);
extern int  web_kind;
extern char web_name[TP_NAME_BYTES];
#endif
