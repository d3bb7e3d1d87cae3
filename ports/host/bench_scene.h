/* SPDX-License-Identifier: MIT */
/* Scene S, on which other software renderers were measured: 20 m x 20 m of water on a
 * grid, three waves, a picture of 256 x 256 texels repeated eight times.  The eye is 3 m
 * up, 60 degrees of view, looking 15.6 degrees down; the water then covers 59 % of the
 * picture. */
#ifndef HOST_BENCH_SCENE_H
#define HOST_BENCH_SCENE_H
#include "bench_maps.h"
#include "tidepool/assets.h"

typedef enum {
    BENCH_PLAIN,        /* that picture, nearest texels, diffuse light, depth */
    BENCH_FULL,         /* distortion, 3 layers, bump, Fresnel, cube, glitter, exposure */
    BENCH_SMOOTH,       /* the same with linear layers */
    BENCH_WORKS
} bench_work;

extern const char *const bench_work_name[BENCH_WORKS];      /* "plain" ... */

enum { BENCH_TICK = 60 };       /* of the picture that is compared with others */

typedef struct {
    tp_scene   scene;
    tp_assets  assets;          /* points below: it must not move */
    tp_texture map[BENCH_MAPS], face[TP_FACES];
    uint32_t  *memory;          /* of all texels */
} bench_scene;

/* The pictures, once; then the scene of a work on points x points.  An exit code. */
int  bench_scene_open(bench_scene *s);
void bench_scene_set(bench_scene *s, bench_work work, uint32_t points);
void bench_scene_close(bench_scene *s);
#endif
