/* SPDX-License-Identifier: MIT */
/* Pictures painted in integers: noise, sines, normal maps, PNG files.
 *
 * All pictures tile: a coordinate is taken modulo the picture's side or the noise's period,
 * so the right edge meets the left and the bottom meets the top. The code uses only
 * integers, so all machines paint the same pixels. Sides are powers of two. */
#ifndef CANVAS_H
#define CANVAS_H
#include <stdbool.h>
#include <stdint.h>

#define CANVAS_SIDE 256 /* pixels, at most */

typedef struct {
    int w, h;
    bool alpha;                                /* save the pixels' top byte too */
    uint32_t pixel[CANVAS_SIDE * CANVAS_SIDE]; /* 0xAARRGGBB, rows from the top */
} canvas;

/* Heights in 1/256 of a texel's width. */
typedef struct {
    int w, h;
    int32_t at[CANVAS_SIDE * CANVAS_SIDE];
} relief;

int clamp_int(int v, int low, int high);
int wrap(int v, int period);          /* 0..period - 1 */
int mix_int(int a, int b, int t_256); /* t_256 = 0: a, 256: b */
uint32_t rgb(int r, int g, int b);    /* each clamped to 0..255 */
uint32_t rgb_mix(uint32_t a, uint32_t b, int t_256);
uint32_t rgb_scale(uint32_t c, int by_256); /* darker below 256 */
uint32_t root_u64(uint64_t v);              /* floor of the square root */

uint32_t hash(int x, int y, uint32_t seed); /* 32 well mixed bits */

/* Sine: one turn is 65536; the result is sin x 16384, with an error below 8. */
int32_t sine_q14(int32_t turn_q16);

/* Smooth noise 0..65535 on a lattice of period px x py cells; x, y in 1/256 cell. */
int noise(int32_t x_q8, int32_t y_q8, int px, int py, uint32_t seed);

/* `octaves` of noise over a w x h tile at pixel x, y; the first octave has nx x ny cells,
 * each next octave twice as many at half the weight. 0..65535. */
int fractal(int x, int y, int w, int h, int nx, int ny, int octaves, uint32_t seed);

/* Cellular noise: distances, in 1/256 cell, to the nearest and second nearest of one random
 * point in each of n x n cells; x, y in 1/256 cell. `id` identifies the nearest point. */
typedef struct {
    int32_t near, next;
    uint32_t id;
} cells;

cells cells_at(int32_t x_q8, int32_t y_q8, int n, uint32_t seed);

/* Colour of the tangent-space normal for slopes in 1/65536: red right, green up. */
uint32_t normal_rgb(int32_t slope_x_q16, int32_t slope_up_q16);

/* Normal map of a relief, by central differences, wrapped at the edges. */
void relief_normals(const relief *from, canvas *to);

/* Brightness of a relief lit from the upper left: 256 where the relief is level. */
int relief_light(const relief *from, int x, int y);

/* Writes DIR/NAME as an RGB or RGBA PNG without time or text; ends the program on
 * failure. */
void canvas_save(const canvas *picture, const char *dir, const char *name);
#endif
