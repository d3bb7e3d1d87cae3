/* SPDX-License-Identifier: MIT */
/* Pictures for the charts "span" and "filter": a baked scene's water with other settings,
 * drawn by triangles with exact perspective at other distances than the engine's 16 pixels.
 * span.c counts the instructions, span_errors.c measures the errors. */
#ifndef TP_TESTS_CHARTS_SPAN_H
#define TP_TESTS_CHARTS_SPAN_H
#include "tidepool/assets.h"

typedef struct {
    const char *chart;          /* NULL: end of the list */
    const char *from;           /* base scene; NULL: any scene */
    const char *key;            /* the point's keys; with the scene if `from` is set */
    const char *set;            /* settings, separated by blanks */
    int32_t     step;           /* pixels; see span_step */
    bool        one_level;      /* textures have only their first mipmap level */
} span_row;

extern const span_row span_rows[];

/* Perspective step of the triangles of water and solids: 0 affine; 1, 8, 16 or 32 pixels
 * between exact places; SPAN_TRUE: double precision, available here only (span_true.c). */
enum { SPAN_TRUE = -1 };
extern int32_t span_step;

typedef struct {
    tp_scene   scene;
    tp_assets  assets;
    tp_texture picture[TP_LAYERS + 2];
} span_scene;

/* Sets the row's scene and its step. Returns false if a setting is not understood. */
bool span_begin(span_scene *s, const span_row *row);
#endif
