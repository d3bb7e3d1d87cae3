/* SPDX-License-Identifier: MIT */
/* Colour seen at a place of the picture. */
#ifndef TP_TOOLS_REFERENCE_TRACE_H
#define TP_TOOLS_REFERENCE_TRACE_H
#include "solids.h"

typedef struct {
    ref_colour colour;
    ref_kind   kind;
    ref_kind   in_mirror;       /* object in the water's mirror; REF_SKY: none */
    double     near;            /* 1 / depth ahead of the eye, 1/m; 0: the sky */
    double     spray;           /* opacity of all specks, 0..1 */
} ref_seen;

/* Traces the place (u, v), in pixels from the picture's top left corner. */
ref_seen ref_look(const ref_scene *s, double u, double v);

/* Traces a ray in air: objects, ground and sky, no water. */
ref_seen ref_dry(const ref_scene *s, const ref_ray *ray, double t0, double t1,
                 ref_vec *at);
#endif
