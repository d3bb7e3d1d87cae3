/* SPDX-License-Identifier: MIT */
/* Waves over a floor and in wind in double precision: [B2], [B7]-[B15] of the models, from
 * the waves' own numbers.
 *
 * Over a height map the floor and the phases come from the world's nodes, as data: the
 * eikonal equation is not solved again. Overhanging water ([B16]-[B19]) is left out: the
 * surface is a height field, so a ray meets a breaking crest without its lip. */
#ifndef TP_TOOLS_REFERENCE_COASTAL_WATER_H
#define TP_TOOLS_REFERENCE_COASTAL_WATER_H
#include <stdbool.h>
#include "deep_water.h"
#include "waves/coastal_water.h"

enum { REF_DEPTHS = 64 * 15 + 1,        /* 64 an octave from 1/16 to 2048 m */
       REF_NODE = 8 };                  /* numbers of a depth */

/* A wave at one depth. */
typedef union {
    struct {
        double k, along, up, push;  /* rad/m; semi-axes, m; lambda up of [B10] */
        double way_x, way_z;        /* direction of travel */
        double sine;                /* sine of the tilt [B11], over a straight floor */
        double excess;              /* phase beyond the deep-water phase, rad */
    };
    double all[REF_NODE];
} ref_depth_node;

typedef struct {
    ref_wave deep;
    double lambda, k_deep;      /* k_deep: wave number of the linear part of the phase */
    int    iterations;
    ref_depth_node node[REF_DEPTHS];
} ref_coastal_wave;

typedef struct {
    int    count;
    bool   floored;             /* true: the scene has a floor */
    double depth, slope, up_x, up_z, k0;
    const tp_coastal_water *map;        /* map with nodes, or NULL */
    double high, reach, steep;  /* bounds of height, displacement and slope */
    ref_coastal_wave wave[TP_WAVES];
} ref_coastal;

typedef struct {
    double depth, rise_x, rise_z;
} ref_bed;

/* Builds the coastal water. Returns NULL if the scene has neither wind nor floor. The
 * caller frees it. */
ref_coastal *ref_coastal_make(const tp_scene *scene, const tp_world *world,
                              const ref_deep_water *sea);

/* Depth of still water at (x, z), m; <= 0 is land. */
ref_bed ref_coastal_floor(const ref_coastal *coastal, double x, double z);

/* Displaced point of a rest point. The derivatives treat depth, direction and tilt as
 * constant, which is exact over level floors. On land the point is at rest. */
ref_point ref_coastal_rest(const ref_coastal *coastal, const double phase[TP_WAVES],
                           double x0, double z0);

/* Displaced point with derivatives by differences of fourth order, exact to 1e-9. */
ref_point ref_coastal_exact(const ref_coastal *coastal, const double phase[TP_WAVES],
                            double x0, double z0);
#endif
