/* SPDX-License-Identifier: MIT */
/* Quick light as plain loops, which compilers vectorise: all in 32 bits, tables of
 * words, no branch.  quick_light_m4.h has the same bits. */
#ifndef TP_SHADE_QUICK_LIGHT_PLAIN_H
#define TP_SHADE_QUICK_LIGHT_PLAIN_H
#include "shade/quick_light.h"
#include "shade/slope.h"

/* The mirrored view, turned round, in the map of a cube's sky: its horizontal part drawn
 * in by half its height, so that the horizon has as many cells to a degree as the rest.
 * n is Q26, up too. */
TP_ALWAYS_INLINE int32_t plain_cube_place(int32_t sx, int32_t sz, int32_t vx, int32_t vz,
                                          int32_t n, int32_t up)
{
    int32_t twice = tp_usat(n, 12, 14);
    int32_t x = (twice * sx >> 11) - vx, z = (twice * sz >> 11) - vz;
    int32_t in = 16384 - tp_usat(up, 13, 13);
    int32_t u = tp_clamp(x * (in >> 2) >> 22, -16, 15);
    int32_t v = tp_clamp(z * (in >> 2) >> 22, -16, 15);

    return (v + 16) * TP_QUICK_SIDE + u + 16;
}

/* Shares sum up to 257, which stands for the half that a cut loses. */
TP_ALWAYS_INLINE uint32_t plain_mixed(uint32_t colour, uint32_t sky, uint32_t keeps,
                                      uint32_t mirrors)
{
    uint32_t rb = (colour & 0xff00ff) * keeps + (sky & 0xff00ff) * mirrors;
    uint32_t g = (colour >> 8 & 0xff) * keeps + (sky >> 8 & 0xff) * mirrors;

    return (rb >> 8 & 0xff00ff) | (g & 0xff00);
}

/* The arrays of a run and the tables, which do not overlap. */
TP_ALWAYS_INLINE void plain_lit(const struct tp_quick_light *restrict quick,
                                tp_quick_sun sun, const tp_run *restrict run,
                                uint32_t *restrict colours, int32_t count, int env,
                                int lobe)
{
    const uint32_t *sky = quick->sky + (env == TP_ENV_CUBE ? 0 : TP_QUICK_HEIGHTS / 2);
    const uint32_t *shares = quick->share, *lobes = quick->lobe;
    const int32_t least = quick->least;
    const int32_t lx = tp_high16(sun.back), lz = tp_low16(sun.back);

    for (int32_t i = 0; i < count; i++) {
        int32_t sx = tp_high16(run->slope[i]), sz = tp_low16(run->slope[i]);
        int32_t vx = tp_high16(run->back[i]), vz = tp_low16(run->back[i]);
        int32_t n = run->view_y[i] + sx * vx + sz * vz;
        int32_t l = sun.y + sx * lx + sz * lz;
        int32_t up = 2 * tp_usat(n, 0, 27) - run->view_y[i];
        int32_t place = env == TP_ENV_CUBE
                            ? plain_cube_place(sx, sz, vx, vz, n + least, up)
                      : env == TP_ENV_DOME
                            ? (int32_t)run->column[i] + tp_ssat(up, 21, 6)
                            : tp_ssat(up, 21, 6);
        uint32_t light = sky[place];
        uint32_t share = shares[tp_usat(n, 18, 8)];
        uint32_t lit = (uint32_t)(sun.ambient + sun.direct * tp_usat(l, 18, 8));
        uint32_t colour = plain_mixed(colours[i], light, lit * (share >> 16) >> 16,
                                      share & 0xffff);
        if (lobe == TP_LOBE_PHONG) {
            int32_t one_q = (int32_t)((1u << 24) + tp_slope_square(sx, sz));
            int32_t way = tp_smulwt(one_q, (uint32_t)run->view_l[i])
                        - (tp_smulwb(n + least, (uint32_t)tp_usat(l, 12, 14)) >> 1);
            colour = tp_colour_add(colour, lobes[tp_usat(way, 11, 9)]);
        }
        if (lobe == TP_LOBE_BLINN) {
            int32_t dx = (sx - tp_high16(run->half[i])) >> 1;
            int32_t dz = (sz - tp_low16(run->half[i])) >> 1;
            colour = tp_colour_add(colour, lobes[tp_usat(dx * dx + dz * dz, 11, 9)]);
        }
        colours[i] = colour;
    }
}

TP_ALWAYS_INLINE void plain_light(const tp_shade *shade, tp_run *run, int env, int lobe)
{
    tp_quick_view_run(shade, run, lobe);
    plain_lit(shade->quick, tp_quick_sun_of(shade), run, run->colour, run->count, env,
              lobe);
}
#endif
