/* SPDX-License-Identifier: MIT */
/* Stars; see the header. */
#include "stars.h"
#include "env.h"

enum { CELLS = 64 };            /* along a side of the cube's face */

/* Radius on the unit sphere. Pictures of a focal length below 110 px would need stars that
 * leave their cells, those above 3481 px stars that are smaller than the engine's unit. */
static double star_radius(const ref_scene *s)
{
    return fmax(0.85 / fmax(s->camera.focal, 110), 8 / 32768.0);
}

static uint32_t hash(uint32_t n)
{
    n = (n ^ n >> 15) * 0x2c1b3c6du;
    n = (n ^ n >> 12) * 0x297a2d39u;
    return n ^ n >> 15;
}

/* Place within a cell, 0..1: a quarter of the cell from each edge, in 256 steps. */
static double place_in_cell(uint32_t bits)
{
    return 0.25 + (bits & 255) / 512.0;
}

/* Brightness at the centre; 1: white. Few stars are bright. */
static double star_brightness(uint32_t rank)
{
    const double x = rank / 256.0;
    return (56 + 448 * x * x * x) / 256;
}

ref_colour ref_stars(const ref_scene *s, ref_vec way)
{
    static const uint32_t tints[4] = { 0xffffff, 0xd8e4ff, 0xfff0d8, 0xecf2ff };
    const ref_place p = ref_cube_place((ref_dir){ way.x, way.y, way.z });
    const int col = (int)fmin(CELLS - 1, p.s * CELLS);
    const int row = (int)fmin(CELLS - 1, p.t * CELLS);
    const uint32_t h = hash((uint32_t)((p.face * CELLS + row) * CELLS + col) + 1);

    if (s->scene->sky.kind != TP_SKY_NIGHT || way.y <= 0
        || (h & 255) >= floor(ref_number(s->scene->sky.stars) * 64))
        return (ref_colour){ { 0, 0, 0 } };
    const ref_dir star = ref_cube_direction(p.face, (col + place_in_cell(h >> 8)) / CELLS,
                                            (row + place_in_cell(h >> 16)) / CELLS);
    const ref_vec off = { way.x - star.x, way.y - star.y, way.z - star.z };
    const double far = ref_dot(off, off) / (star_radius(s) * star_radius(s));
    const double air = ref_clamp((way.y - 500 / 16384.0) * 8, 0, 1);

    return ref_scale(ref_colour_unpack(tints[h >> 14 & 3]),
                     fmin(1, fmax(0, 1 - far) * star_brightness(h >> 24) * air));
}
