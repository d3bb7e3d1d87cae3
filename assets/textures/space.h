/* SPDX-License-Identifier: MIT */
/* Directions, light and noise in space, in integers; for skies. */
#ifndef SPACE_H
#define SPACE_H
#include <stdint.h>

/* Vector: a unit vector in Q14 or a place in metres; x east, y up, z south. */
typedef struct {
    int32_t x, y, z;
} vec;

/* Light: red, green and blue in 1/256 of a level of 255; may exceed white. */
typedef struct {
    int32_t r, g, b;
} light;

vec unit(int32_t x, int32_t y, int32_t z);
vec heading_at(int32_t heading_degrees,
               int32_t elevation_degrees); /* clockwise from -z */
int32_t cosine(vec a, vec b);              /* Q14 */
int32_t chord(vec a, vec b);               /* Q14; for small angles equal to the radians */

light light_of(uint32_t rgb);
uint32_t light_rgb(light l); /* rounded, clamped at white */
light light_mix(light a, light b, int32_t t_q14);
light light_scale(light l, int32_t by_q14);
light light_add(light a, light b);

/* Colour at a height (y of a unit vector) between stops with rising heights. */
typedef struct {
    int32_t y;
    uint32_t rgb;
} stop;

light ramp_at(const stop *stops, int count, int32_t y);

/* Smooth noise 0..65535 in space, without repetition; coordinates in 1/256 cell. */
int noise3(int32_t x_q8, int32_t y_q8, int32_t z_q8, uint32_t seed);

/* `octaves` of noise, 0..65535; the first octave has cells of `cell` m, each next octave
 * cells of half the size. */
int fractal3(vec place, int cell, int octaves, uint32_t seed);
#endif
