/* SPDX-License-Identifier: MIT */
/* Pictures for the charts "span" and "filter": a baked scene's water, drawn with settings
 * and by triangles whose rows are true to the perspective at other distances than the
 * engine's 16 pixels.  span.c counts their instructions, span_errors.c judges them. */
#ifndef CHARTS_SPAN_H
#define CHARTS_SPAN_H
#include "tidepool/assets.h"

typedef struct {
    const char *chart;          /* NULL: the end */
    const char *from;           /* scene that it is made from; NULL: any */
    const char *key;            /* the point's keys behind the scene, or with it if `from` */
    const char *set;            /* settings, parted by blanks */
    int32_t     step;           /* pixels, see span_step */
    bool        one_level;      /* pictures have their first level alone */
} span_row;

extern const span_row span_rows[];

/* By what water's and solids' triangles are drawn from now on: 0, affine; 1, 8, 16 or 32
 * pixels from place to place; SPAN_TRUE, in double, here only (span_true.c). */
enum { SPAN_TRUE = -1 };
extern int32_t span_step;

typedef struct {
    tp_scene   scene;
    tp_assets  assets;
    tp_texture picture[TP_LAYERS + 2];
} span_scene;

/* A row's scene, and its step; false: a setting is not understood. */
bool span_begin(span_scene *s, const span_row *row);
#endif
