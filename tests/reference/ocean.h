/* SPDX-License-Identifier: MIT */
/* Waves over a floor and under wind in double precision: [B2], [B7]-[B15] of the models,
 * from the waves' own numbers.
 *
 * Over a picture of heights the floor and the phases come from the world's nodes, as
 * data: the eikonal equation is not solved again.  What overhangs ([B16]-[B19]) is left
 * out: the surface is a height field, so a breaking crest is met without its lip. */
#ifndef TP_REFERENCE_OCEAN_H
#define TP_REFERENCE_OCEAN_H
#include <stdbool.h>
#include "sea.h"
#include "wave/ocean.h"

enum { REF_DEPTHS = 64 * 15 + 1 };      /* 64 an octave from 1/16 to 2048 m */

/* A wave at a depth. */
typedef struct {
    double k, along, up, push;  /* rad/m; semi-axes, m; lambda up of [B10] */
    double way_x, way_z;        /* where it travels to */
    double sine;                /* of the tilt [B11], over a straight floor */
    double excess;              /* rad beyond deep water's phase */
} ref_depth_node;

typedef struct {
    ref_wave deep;
    double lambda, k_deep;      /* k_deep: of the phase's linear part */
    int    iterations;
    ref_depth_node node[REF_DEPTHS];
} ref_ocean_wave;

typedef struct {
    int    count;
    bool   floored;             /* there is a floor */
    double depth, slope, up_x, up_z, k0;
    const tp_ocean *map;        /* its nodes, or NULL */
    double high, reach, steep;  /* bounds */
    ref_ocean_wave wave[TP_WAVES];
} ref_ocean;

typedef struct {
    double depth, rise_x, rise_z;
} ref_bed;

/* NULL: the scene's sea has neither wind nor floor.  To free. */
ref_ocean *ref_ocean_of(const tp_scene *scene, const tp_world *world, const ref_sea *sea);

/* Depth of still water under a place, m; <= 0 is land. */
ref_bed ref_ocean_bed(const ref_ocean *ocean, double x, double z);

/* The point of a place at rest; its derivatives take depth, way and tilt for constants,
 * which is exact over level floors.  On land it is at rest. */
ref_point ref_ocean_rest(const ref_ocean *ocean, const double phase[TP_WAVES], double x0,
                         double z0);

/* The same with derivatives by differences of fourth order, exact to 1e-9. */
ref_point ref_ocean_exact(const ref_ocean *ocean, const double phase[TP_WAVES], double x0,
                          double z0);
#endif
