/* SPDX-License-Identifier: MIT */
/* From a place of the picture to a colour. */
#ifndef TP_REFERENCE_TRACE_H
#define TP_REFERENCE_TRACE_H
#include "solids.h"

typedef struct {
    ref_colour colour;
    ref_kind   kind;
    ref_kind   in_mirror;       /* of water: the object that it mirrors; REF_SKY: none */
    double     near;            /* 1 / m of depth ahead of the eye; 0: the sky */
} ref_seen;

/* u, v in pixels from the picture's top left corner. */
ref_seen ref_look(const ref_scene *s, double u, double v);

/* Things, ground and sky along a ray in air: no water. */
ref_seen ref_dry(const ref_scene *s, const ref_ray *ray, double t0, double t1,
                 ref_vec *at);
#endif
