/* SPDX-License-Identifier: MIT */
/* The map of a cube's light that water mirrors, for fast shading; see fast_shading.h. */
#include "features/water/fast_shading.h"
#include "shade/env.h"

/* Returns the root of a Q28 number, Q14. */
static int32_t root_q14(int32_t q28)
{
    return (int32_t)tp_isqrt64((uint64_t)(q28 > 0 ? q28 : 0));
}

/* Returns the height y, Q14, at which the contracted horizontal part sqrt(1 - y^2) (1 -
 * y / 2) is `radius` / 16384.  The horizontal part falls with y. */
static int32_t sky_map_radius_to_direction_y(int32_t radius)
{
    int32_t low = 0, high = 16384;

    for (int k = 0; k < 14; k++) {
        int32_t y = (low + high) / 2;
        if (root_q14((1 << 28) - y * y) * (int64_t)(32768 - y) >> 15 > radius)
            low = y;
        else
            high = y;
    }
    return low;
}

/* Returns the mipmap level of a face with 16 texels across, about as many as in the map. */
static int choose_level(const tp_texture *face)
{
    return face->log2_w > 4 ? face->log2_w - 4 : 0;
}

/* Fills a cell of the map of a cube, which holds the light from the direction opposite to
 * its place: (x, y, z), Q14.  Alpha is light beyond white, 0 in a scene without HDR. */
static void fill_cell(const tp_quick_tables *quick, const tp_shade *shade, int32_t u,
                      int32_t v, int32_t x, int32_t y, int32_t z)
{
    const tp_texture *face = shade->env.cube->face[tp_cube_face(x, y, z).face];
    const int32_t at = (v >> 10) * TP_QUICK_SIDE + (u >> 10)
                     + TP_QUICK_SIDE * TP_QUICK_SIDE / 2 + TP_QUICK_SIDE / 2;

    quick->sky[at] = tp_env_cube(shade, choose_level(face), x, y, z)
                   & (shade->env.beyond ? 0xffffffff : 0x00ffffff);
}

/* Cells whose places differ by signs or by order have the same height. */
void tp_quick_fill_cube_map(const tp_quick_tables *quick, const tp_shade *shade)
{
    for (int32_t a = 512; a < TP_QUICK_SIDE * 512; a += 1024)
        for (int32_t b = 512; b <= a; b += 1024) {
            const int32_t far = tp_clamp(root_q14(a * a + b * b), 1, 32767);
            const int32_t y = sky_map_radius_to_direction_y(far);
            const int32_t level_part = root_q14((1 << 28) - y * y);
            const int32_t x = a * level_part / far, z = b * level_part / far;
            for (int32_t k = 0; k < 4; k++) {
                const int32_t m = k & 1 ? -1 : 1, n = k & 2 ? -1 : 1;
                fill_cell(quick, shade, m * a, n * b, -m * x, y, -n * z);
                if (a != b)
                    fill_cell(quick, shade, n * b, m * a, -n * z, y, -m * x);
            }
        }
}

const struct tp_draw_cube_map tp_draw_cube_map = { tp_quick_fill_cube_map };
