/* SPDX-License-Identifier: MIT */
/* Makes the tables of fast light from the tables of the exact stages. */
#include "scene/world.h"
#include "shade/env.h"
#include "features/water/quick_light.h"

#define RIPPLED_VIEW (1638 << 12)       /* same value as in lighting_stage.c */

/* Fills the table of shares.  In the middle of entry i, n is the lower bound plus
 * (i + 1/2) / 256. */
static void make_shares(struct tp_quick_light *quick, const tp_shade *shade)
{
    for (int32_t i = 0; i < TP_QUICK_SHARES; i++) {
        int32_t  n = (quick->least + ((i + 1) << 18)) >> 18;
        uint32_t share = shade->fresnel[n < 256 ? n : 256];
        uint32_t mirrors = share * (uint32_t)shade->mirror >> 8;
        quick->share[i] = (256 - mirrors) << 16 | (mirrors + 1);
    }
}

/* Returns the root of a Q28 number, Q14. */
static int32_t root_q14(int32_t q28)
{
    return (int32_t)tp_isqrt64((uint64_t)(q28 > 0 ? q28 : 0));
}

/* Returns Fresnel's share at the sun's image, for a view with the camera's pitch.
 * N.L = N.V is the cosine of half the angle between sun and view, on opposite sides. */
uint32_t tp_quick_share_at_sun(const tp_shade *shade)
{
    int32_t l = shade->world.ly, v = tp_clamp(shade->world.back.y >> 16, 0, 16384);
    int32_t far = (root_q14((1 << 28) - l * l) * root_q14((1 << 28) - v * v)) >> 14;
    int32_t cos_lv = tp_clamp((l * v >> 14) - far, -16384, 16384);

    return shade->fresnel[root_q14((16384 + cos_lv) << 13) >> 6]
         * (uint32_t)shade->mirror >> 8;
}

/* Returns the colour of lobe and glow at c, Q14; c is R.V or 2 (N.H)^2 - 1. */
static uint32_t lobe_colour(const tp_shade *shade, int32_t c, bool shiny,
                            uint32_t glow_share)
{
    uint32_t light = 0;

    if (shiny) {
        int32_t  up = tp_clamp(c, 0, 16384);
        uint32_t here = shade->shine[up >> 4], next = shade->shine[(up + 15) >> 4];
        uint32_t shine = here + (((next - here) * (uint32_t)(up & 15)) >> 4);
        light = tp_colour_scale(shade->light_colour, shine < 256 ? shine : 256);
    }
    if (shade->env.kind != TP_ENV_DOME)
        return light;
    uint32_t square = (uint32_t)(16384 - c) << 15;
    uint32_t least = shade->env.least;
    uint32_t glow = shade->env.dome->glow[tp_glow_index(square > least ? square : least)];
    return tp_colour_add(light, tp_colour_scale(glow & 0xffffff, glow_share));
}

/* Fills the lobe's table.  In the middle of entry i, w is (i + 1/2) / 2048.  For Phong
 * R.V is 1 - w.  For Blinn w is the square of the tangent, and c = (1 - w) / (1 + w). */
static void make_lobe(struct tp_quick_light *quick, const tp_shade *shade, tp_lobe lobe,
                      bool shiny)
{
    uint32_t glow_share = tp_quick_share_at_sun(shade);

    for (int32_t i = 0; i < TP_QUICK_LOBE; i++) {
        int32_t w = 8 * i + 4;
        int32_t c = lobe == TP_LOBE_BLINN ? (16384 - w) * 16384 / (16384 + w)
                                          : 16384 - w;
        quick->lobe[i] = lobe_colour(shade, c, shiny, glow_share);
    }
}

/* Returns the sky as mirrored at a height.  A reflected view downwards meets other water,
 * with a share of the horizon's brightness by the rule of reflectance_stage.c. */
static uint32_t mirrored_sky_colour(uint32_t sky, int32_t up)
{
    return tp_colour_scale(sky, (uint32_t)tp_clamp(256 + 4 * up, 128, 256));
}

/* Fills the columns of heights.  Entry i is in the middle of a 32nd; `up` is in 256ths.
 * A gradient has one column; a dome has 16 columns, mixed from its two sides. */
static void fill_sky_heights(struct tp_quick_light *quick, const tp_shade *shade)
{
    const tp_dome *dome = shade->env.kind == TP_ENV_DOME ? shade->env.dome : NULL;
    const int32_t least = quick->least >> 18;

    for (uint32_t k = 0; k < (dome ? 16 : 1); k++) {
        for (int32_t i = 0; i < TP_QUICK_HEIGHTS; i++) {
            int32_t  up = 8 * (i - TP_QUICK_HEIGHTS / 2) + 4 + least;
            int32_t  at = tp_clamp(up, 0, TP_SKY);
            uint32_t sky = dome ? tp_colour_mix(dome->away[at], dome->towards[at],
                                                16 * k + 8)
                                : shade->sky[at];
            quick->sky[k * TP_QUICK_HEIGHTS + (uint32_t)i] = mirrored_sky_colour(sky, up);
        }
    }
}

/* Returns the height y, Q14, at which the contracted horizontal part sqrt(1 - y^2) (1 -
 * y / 2) is `far` / 16384.  The horizontal part falls with y. */
static int32_t solve_height(int32_t far)
{
    int32_t low = 0, high = 16384;

    for (int k = 0; k < 14; k++) {
        int32_t y = (low + high) / 2;
        if (root_q14((1 << 28) - y * y) * (int64_t)(32768 - y) >> 15 > far)
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

/* Fills the map of a cube.  A cell holds the light from the direction opposite to its
 * place. */
static void make_cube(struct tp_quick_light *quick, const tp_shade *shade)
{
    for (int32_t i = 0; i < TP_QUICK_SIDE * TP_QUICK_SIDE; i++) {
        int32_t u = (i % TP_QUICK_SIDE - 16) * 1024 + 512;
        int32_t v = (i / TP_QUICK_SIDE - 16) * 1024 + 512;
        int32_t far = tp_clamp(root_q14(u * u + v * v), 1, 32767), y = solve_height(far);
        int32_t level_part = root_q14((1 << 28) - y * y);
        int32_t x = -u * level_part / far, z = -v * level_part / far;
        const tp_texture *face = shade->env.cube->face[tp_cube_face(x, y, z).face];
        quick->sky[i] = tp_env_cube(shade, choose_level(face), x, y, z) & 0xffffff;
    }
}

void tp_quick_light_init(struct tp_quick_light *quick, const tp_shade *shade,
                         tp_lobe lobe, bool shiny, bool rippled)
{
    TP_ASSERT((unsigned)lobe <= TP_LOBE_BLINN && shade->fresnel != NULL);
    quick->least = rippled ? RIPPLED_VIEW : 0;
    make_shares(quick, shade);
    make_lobe(quick, shade, lobe, shiny);
    if (shade->env.kind == TP_ENV_CUBE)
        make_cube(quick, shade);
    else
        fill_sky_heights(quick, shade);
}
