/* SPDX-License-Identifier: MIT */
/* Scene S, a benchmark on which other software renderers were measured.  Water of 20 m x 20
 * m on a grid, three waves, a texture of 256 x 256 texels repeated eight times.  The camera
 * is 3 m above the water, with a field of view of 60 degrees, 15.6 degrees down; the water
 * then covers 59 % of the picture.
 *
 * The textures are computed: the benchmark needs no file, and the other renderers get the
 * same texels. */
#ifndef TP_TOOLS_BENCH_BENCH_SCENE_H
#define TP_TOOLS_BENCH_BENCH_SCENE_H
#include <stdint.h>
#include "tidepool/assets.h"

enum { BENCH_MAP = 256, BENCH_FACE = 128 };     /* sides, texels */

typedef enum {
    BENCH_MOTTLE,               /* blues with a grid, to show skewed or swimming texels */
    BENCH_CRESTS, BENCH_DRIFT,  /* grey layers to add */
    BENCH_BEND,                 /* distortion: red, green = offset along s, t; 128 = none */
    BENCH_RIPPLE,               /* normal map */
    BENCH_MAPS
} bench_map;

typedef enum {
    BENCH_PLAIN,        /* one texture, nearest texels, diffuse light, depth */
    BENCH_FULL,         /* distortion, 3 layers, bump, Fresnel, cube, glitter, exposure */
    BENCH_SMOOTH,       /* as BENCH_FULL, with linear filter for the layers */
    BENCH_WORKS
} bench_work;

extern const char *const bench_work_name[BENCH_WORKS];      /* "plain", "full", "smooth" */

enum { BENCH_TICK = 60 };       /* tick of the picture that is compared with others */

typedef struct {
    tp_scene   scene;
    tp_assets  assets;          /* points at the members below: the struct must not move */
    tp_texture map[BENCH_MAPS], face[TP_FACES];
    uint32_t  *memory;          /* memory of all texels */
} bench_scene;

/* Makes the textures once; bench_scene_set then sets the scene of a work with points x
 * points grid vertices.  Returns an exit code. */
int  bench_scene_open(bench_scene *s);
void bench_scene_set(bench_scene *s, bench_work work, uint32_t points);
void bench_scene_close(bench_scene *s);

#endif
