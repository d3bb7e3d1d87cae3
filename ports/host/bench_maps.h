/* SPDX-License-Identifier: MIT */
/* Textures of the benchmark's scene, computed: the benchmark needs no file, and the other
 * renderers get the same texels. */
#ifndef HOST_BENCH_MAPS_H
#define HOST_BENCH_MAPS_H
#include <stdint.h>

enum { BENCH_MAP = 256, BENCH_FACE = 128 };     /* sides, texels */

typedef enum {
    BENCH_MOTTLE,               /* blues with a grid, to show skewed or swimming texels */
    BENCH_CRESTS, BENCH_DRIFT,  /* grey layers to add */
    BENCH_BEND,                 /* distortion: red, green = offset along s, t; 128 = none */
    BENCH_RIPPLE,               /* normal map */
    BENCH_MAPS
} bench_map;

/* Fill texels 0xffRRGGBB, row-major: BENCH_MAP^2 of a map, BENCH_FACE^2 of face 0..5 of a
 * cube. */
void bench_map_fill(bench_map map, uint32_t *texels);
void bench_face_fill(int face, uint32_t *texels);
#endif
