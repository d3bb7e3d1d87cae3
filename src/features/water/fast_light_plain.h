/* SPDX-License-Identifier: MIT */
/*
 * Fast light as plain loops for vectorizing compilers: 32-bit arithmetic, tables of
 * words, no branches.  fast_light_m4.h gives identical results.
 */
#ifndef TP_FEATURES_WATER_FAST_LIGHT_PLAIN_H
#define TP_FEATURES_WATER_FAST_LIGHT_PLAIN_H
#include "features/water/fast_shading.h"
#include "fixed/arithmetic.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

/* -- every column -------------------------------------------------------------------- */

/* Returns the index of the negated reflected view in the map of a cube's sky.  The
 * horizontal part is contracted by half its height, so the horizon has as many cells per
 * degree as the rest.  n and `up` are Q26. */
TP_ALWAYS_INLINE int32_t plain_cube_index(int32_t sx, int32_t sz, int32_t vx, int32_t vz,
                                          int32_t n, int32_t up, tp_quick_offset row)
{
    int32_t twice = tp_usat(n, 12, 14);
    int32_t x = (twice * sx >> 11) - vx, z = (twice * sz >> 11) - vz;
    int32_t in = 16384 - tp_usat(up, 13, 13);
    int32_t u = tp_clamp((x * (in >> 2) + row.u) >> 22, -16, 15);
    int32_t v = tp_clamp((z * (in >> 2) + row.v) >> 22, -16, 15);

    return (v + 16) * TP_QUICK_SIDE + u + 16;
}

/* Mixes two colours.  The shares sum to 257; the extra 1/256 replaces the half lost by
 * truncation. */
TP_ALWAYS_INLINE uint32_t plain_mixed(uint32_t colour, uint32_t sky, uint32_t keeps,
                                      uint32_t mirrors)
{
    uint32_t rb = (colour & 0xff00ff) * keeps + (sky & 0xff00ff) * mirrors;
    uint32_t g = (colour >> 8 & 0xff) * keeps + (sky >> 8 & 0xff) * mirrors;

    return (rb >> 8 & 0xff00ff) | (g & 0xff00);
}

/* Pointers and constants of the loops; the tables do not overlap. */
typedef struct {
    const uint32_t *restrict sky, *restrict shares, *restrict lobes;
    tp_quick_sun sun;
    int32_t least, lx, lz;
    uint32_t beyond;
    tp_quick_offset row;
} plain_tables;

TP_ALWAYS_INLINE plain_tables plain_tables_make(const tp_shade *shade, int32_t level,
                                                int32_t y)
{
    const struct tp_quick_light *quick = shade->quick;
    const tp_quick_rough *rough = &quick->rough[level];
    const tp_quick_sun sun = tp_quick_sun_make(shade);

    return (plain_tables){
        quick->sky, rough->share, rough->lobe, sun, rough->least, tp_high16(sun.back),
        tp_low16(sun.back), rough->beyond, tp_quick_row_offset(y),
    };
}

/* Returns the end of the columns from i on that have one level of roughness. */
TP_ALWAYS_INLINE int32_t plain_level_end(const tp_run *run, int32_t i, int lobe)
{
    const int log2 = lobe == TP_LOBE_PHONG ? 4 : 5;
    const int32_t first = run->x >> log2, last = (run->x + run->count - 1) >> log2;
    int32_t k = (run->x + i) >> log2;
    const int32_t level = run->span[k - first].mip_offset;

    while (k < last && run->span[k + 1 - first].mip_offset == level)
        k++;
    return k < last ? ((k + 1) << log2) - run->x : run->count;
}

/* Returns the level of column i. */
TP_ALWAYS_INLINE int32_t plain_level(const tp_run *run, int32_t i, int lobe)
{
    const int log2 = lobe == TP_LOBE_PHONG ? 4 : 5;
    return run->span[((run->x + i) >> log2) - (run->x >> log2)].mip_offset;
}

/* Values of one column: slopes, -V, y of the view, n and l. */
typedef struct {
    int32_t sx, sz, vx, vz, y, n, l;
} plain_column;

TP_ALWAYS_INLINE plain_column plain_column_make(const plain_tables *t, uint32_t slope,
                                                uint32_t back, int32_t y)
{
    int32_t sx = tp_high16(slope), sz = tp_low16(slope);
    int32_t vx = tp_high16(back), vz = tp_low16(back);

    return (plain_column){ sx, sz, vx, vz, y, y + sx * vx + sz * vz,
                           t->sun.y + sx * t->lx + sz * t->lz };
}

/* Returns light and reflection; `water` is that of the run. */
TP_ALWAYS_INLINE uint32_t plain_light_and_reflect(const plain_tables *t, plain_column c,
                                                  uint32_t water, uint32_t colour, int env)
{
    int32_t up = 2 * tp_usat(c.n, 0, 27) - c.y;
    int32_t place = env == TP_ENV_CUBE
                        ? plain_cube_index(c.sx, c.sz, c.vx, c.vz, c.n + t->least, up,
                                               t->row)
                        : tp_low16(water) + tp_ssat(up, 21, 6);
    tp_quick_sun sun = tp_quick_sun_seen(t->sun, tp_high16(water));
    uint32_t share = t->shares[tp_usat(c.n, 18, 8)];
    uint32_t lit = (uint32_t)(sun.ambient + sun.direct * tp_usat(c.l, 18, 8));
    uint32_t light = t->sky[place], mirrors = share & 0xffff;

    colour = plain_mixed(colour, light, lit * (share >> 16) >> 16, mirrors);
    return env == TP_ENV_CUBE
               ? tp_quick_add_bright(colour, light, mirrors, t->beyond)
               : colour;
}

TP_ALWAYS_INLINE uint32_t plain_add_phong_glint(const plain_tables *t, plain_column c,
                                                int32_t view_l, uint32_t colour)
{
    int32_t one_q = (int32_t)((1u << 24) + tp_slope_square(c.sx, c.sz));
    int32_t way = tp_smulwt(one_q, (uint32_t)view_l)
                - (tp_smulwb(c.n + t->least, (uint32_t)tp_usat(c.l, 12, 14)) >> 1);

    return tp_colour_add(colour, t->lobes[tp_usat(way, 11, 9)]);
}

TP_ALWAYS_INLINE uint32_t plain_add_blinn_glint(const plain_tables *t, uint32_t slope,
                                                uint32_t half_vector, uint32_t colour)
{
    int32_t dx = (tp_high16(slope) - tp_high16(half_vector)) >> 1;
    int32_t dz = (tp_low16(slope) - tp_low16(half_vector)) >> 1;

    return tp_colour_add(colour, t->lobes[tp_usat(dx * dx + dz * dz, 11, 9)]);
}

/* Shades columns of a run; its arrays do not overlap. */
TP_ALWAYS_INLINE void plain_shade_loop(const plain_tables tables,
                                       const tp_run *restrict run,
                                       uint32_t *restrict colours, int32_t i, int32_t end,
                                       int env, int lobe)
{
    for (; i < end; i++) {
        plain_column c = plain_column_make(&tables, run->slope[i], run->back[i],
                                         run->view_y[i]);
        uint32_t colour = plain_light_and_reflect(&tables, c, run->water[i], colours[i],
                                                  env);
        if (lobe == TP_LOBE_PHONG)
            colour = plain_add_phong_glint(&tables, c, run->view_l[i], colour);
        if (lobe == TP_LOBE_BLINN)
            colour = plain_add_blinn_glint(&tables, run->slope[i], run->half[i], colour);
        colours[i] = colour;
    }
}

TP_ALWAYS_INLINE void plain_light(const tp_shade *shade, tp_run *run, int env, int lobe)
{
    tp_quick_view_run(shade, run, env, lobe);
    for (int32_t i = 0, end; i < run->count; i = end) {
        end = plain_level_end(run, i, lobe);
        plain_shade_loop(plain_tables_make(shade, plain_level(run, i, lobe), run->y), run,
                         run->colour, i, end, env, lobe);
    }
}

/* -- every second column, and glints of all columns ---------------------------------- */

/* Lights `count` even columns of the picture; `first`, 0 or 1, is the first one's column in
 * the run.  even[k] contains the colour of the layers and receives the lit colour. */
TP_ALWAYS_INLINE void plain_light_even_columns_loop(const plain_tables tables,
                                                    const tp_run *restrict run,
                                                    uint32_t *restrict even, int32_t first,
                                                    int32_t count, int env)
{
    const uint32_t *restrict slope = run->slope + first, *restrict back = run->back + first;
    const uint32_t *restrict water = run->water + first;
    const int32_t  *restrict y = run->view_y + first;

    for (int32_t k = 0; k < count; k++) {
        plain_column c = plain_column_make(&tables, slope[2 * k], back[2 * k], y[2 * k]);
        even[k] = plain_light_and_reflect(&tables, c, water[2 * k], even[k], env);
    }
}

TP_ALWAYS_INLINE void plain_light_even_columns(const tp_shade *shade, tp_run *run, int env)
{
    const int32_t odd = run->x & 1;

    tp_quick_view_run(shade, run, env, TP_LOBE_BLINN);
    if (odd) {
        const plain_tables tables =
            plain_tables_make(shade, plain_level(run, 0, TP_LOBE_BLINN), run->y);
        plain_column c = plain_column_make(&tables, run->slope[0], run->back[0],
                                         run->view_y[0]);
        run->even[0] =
            plain_light_and_reflect(&tables, c, run->water[0], run->even[0], env);
    }
    for (int32_t i = odd, end; i < run->count; i = end) {
        end = plain_level_end(run, i, TP_LOBE_BLINN);
        plain_light_even_columns_loop(
            plain_tables_make(shade, plain_level(run, i, TP_LOBE_BLINN), run->y), run,
            run->even + ((i + odd) >> 1), i, (end - i + 1) >> 1, env);
    }
}

/* Adds the glints of columns of one level. */
TP_ALWAYS_INLINE void plain_glint_loop(const plain_tables tables, tp_run *restrict run,
                                       int32_t i, int32_t end, int lobe)
{
    uint32_t *restrict colour = run->colour;

    for (; i < end; i++) {
        plain_column c = plain_column_make(&tables, run->slope[i], run->back[i],
                                         run->view_y[i]);
        colour[i] =
            lobe == TP_LOBE_PHONG
                ? plain_add_phong_glint(&tables, c, run->view_l[i], colour[i])
                : plain_add_blinn_glint(&tables, run->slope[i], run->half[i], colour[i]);
    }
}

/* Adds the glints.  The half vectors are those left in the run by the light of the even
 * columns. */
TP_ALWAYS_INLINE void plain_glint(const tp_shade *shade, tp_run *run, int lobe)
{
    tp_quick_odd_fill(run);
    if (lobe == TP_LOBE_PHONG)
        tp_quick_view_run(shade, run, TP_ENV_CUBE, lobe);
    for (int32_t i = 0, end; i < run->count; i = end) {
        end = plain_level_end(run, i, lobe);
        plain_glint_loop(plain_tables_make(shade, plain_level(run, i, lobe), run->y), run,
                         i, end, lobe);
    }
}

#endif
