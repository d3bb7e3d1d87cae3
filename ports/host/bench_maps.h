/* SPDX-License-Identifier: MIT */
/* Pictures of the benchmark's scene, made by arithmetic: it needs no file, and another
 * renderer is given the same texels. */
#ifndef HOST_BENCH_MAPS_H
#define HOST_BENCH_MAPS_H
#include <stdint.h>

enum { BENCH_MAP = 256, BENCH_FACE = 128 };     /* sides, texels */

typedef enum {
    BENCH_MOTTLE,               /* blues in a grid: skewed or swimming texels are seen */
    BENCH_CRESTS, BENCH_DRIFT,  /* greys to add */
    BENCH_BEND,                 /* red and green: ways along s and t, 128 is none */
    BENCH_RIPPLE,               /* a normal map */
    BENCH_MAPS
} bench_map;

/* 0xffRRGGBB, row-major: BENCH_MAP^2 of them; a cube's side 0..5, BENCH_FACE^2. */
void bench_map_fill(bench_map map, uint32_t *texels);
void bench_face_fill(int face, uint32_t *texels);
#endif
