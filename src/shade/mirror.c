/* SPDX-License-Identifier: MIT */
/* What the water mirrors, by Fresnel's share.
 *
 * The plain gradient needs only the mirrored view's height: one fused stage.  Other skies
 * are looked up by the whole vector R = 2 (N.V) N - V [F3], whose height is at hand: with
 * k = Ry + Vy = 2 (N.V) Ny and N = Ny (-sx, 1, -sz) the others are -k sx - Vx and
 * -k sz - Vz.  Then they are mixed in, as light that may be beyond white [F8]. */
#include "shade/cubes.h"
#include "shade/slope.h"

/* A mirrored ray that goes down meets other water, which is half as bright as the
 * horizon: its share fades to a half within 7 degrees below level. */
TP_ALWAYS_INLINE uint32_t above_of(int32_t up)
{
    return (uint32_t)tp_clamp(256 + 4 * (up >> 6), 128, 256);
}

TP_ALWAYS_INLINE uint32_t share_of(const tp_shade *shade, int32_t nv, int32_t up)
{
    uint32_t share = shade->fresnel[nv >> 6] * (uint32_t)shade->mirror >> 8;
    return share * above_of(up) >> 8;
}

/* The same in 65536ths: many whites multiply what a cut would lose. */
TP_ALWAYS_INLINE uint32_t fine_share_of(const tp_shade *shade, int32_t nv, int32_t up)
{
    uint32_t share = shade->fresnel[nv >> 6] * (uint32_t)shade->mirror;
    return share * above_of(up) >> 8;
}

void tp_stage_mirror(const tp_shade *restrict shade, tp_run *restrict run)
{
    const int32_t count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t sky = tp_env_gradient(shade, run->up[i]);
        run->colour[i] = tp_colour_mix(run->colour[i], sky,
                                       share_of(shade, run->nv[i], run->up[i]));
    }
}

/* The slopes as sampled, for stages that ask no more whether ripples have bent them. */
void tp_stage_slopes(const tp_shade *restrict shade, tp_run *restrict run)
{
    const int32_t count = run->count;

    (void)shade;
    for (int32_t i = 0; i < count; i++) {
        run->sx[i] = (int16_t)tp_slope_x(run, i, 0);
        run->sz[i] = (int16_t)tp_slope_z(run, i, 0);
    }
}

/* Fills rx and rz of sample i; Q1.14. */
TP_ALWAYS_INLINE tp_ray mirrored_at(tp_run *run, int32_t i)
{
    int32_t up = run->up[i], k = up + run->vy[i];
    int32_t rx = -(k * run->sx[i] >> 12) - run->vx[i];
    int32_t rz = -(k * run->sz[i] >> 12) - run->vz[i];

    rx = tp_clamp(rx, -16384, 16384);
    rz = tp_clamp(rz, -16384, 16384);
    run->rx[i] = (int16_t)rx;
    run->rz[i] = (int16_t)rz;
    return (tp_ray){ rx, up > 0 ? up : 0, rz, 0 };
}

void tp_stage_reflect_gradient(const tp_shade *restrict shade, tp_run *restrict run)
{
    const int32_t count = run->count;

    for (int32_t i = 0; i < count; i++) {
        tp_ray to = mirrored_at(run, i);
        run->mirror[i] = tp_env_gradient(shade, to.y);
    }
}

TP_ALWAYS_INLINE void dome_wide(const tp_dome *restrict dome,
                                const uint32_t *restrict square,
                                const int16_t *restrict up,
                                const uint32_t *restrict glow, int32_t count,
                                uint32_t *restrict out)
{
    for (int32_t i = 0; i < count; i++)
        out[i] = tp_dome_with(dome, square[i], up[i] > 0 ? up[i] : 0, glow[i]);
}

/* In three loops: a logarithm, which the glow is looked up by, is for one at a time. */
TP_ALWAYS_INLINE void reflect_dome_wide(const tp_shade *restrict shade,
                                        tp_run *restrict run)
{
    const tp_dome *dome = shade->env.dome;
    const int32_t count = run->count;
    uint32_t square[TP_RUN], glow[TP_RUN];

    for (int32_t i = 0; i < count; i++) {
        tp_ray to = mirrored_at(run, i);
        square[i] = tp_from_light(shade, to.x, to.y, to.z);
    }
    for (int32_t i = 0; i < count; i++)
        glow[i] = tp_dome_halo(dome, shade->env.least, square[i]);
    dome_wide(dome, square, run->up, glow, count, run->mirror);
}

void tp_stage_reflect_dome(const tp_shade *restrict shade, tp_run *restrict run)
{
    TP_ASSERT(shade->env.dome != NULL);
    const int32_t count = run->count;

    if (TP_WIDE) {
        reflect_dome_wide(shade, run);
        return;
    }
    for (int32_t i = 0; i < count; i++) {
        tp_ray to = mirrored_at(run, i);
        run->mirror[i] = tp_env_dome(shade, shade->env.least, to.x, to.y, to.z);
    }
}

/* Samples [i, stop), no more than TP_CUBE_ROW. */
TP_ALWAYS_INLINE void reflect_wide(const tp_shade *restrict shade, tp_run *restrict run,
                                   const tp_cube_side *side, int32_t i, int32_t stop)
{
    int32_t x[TP_CUBE_ROW], y[TP_CUBE_ROW], z[TP_CUBE_ROW], count = stop - i;

    for (int32_t k = 0; k < count; k++) {
        tp_ray to = mirrored_at(run, i + k);
        x[k] = to.x;
        y[k] = to.y;
        z[k] = to.z;
    }
    tp_cube_row_wide(shade, side, x, y, z, count, run->mirror + i);
}

/* A level of a cube is chosen for 16 columns: far water has more waves in a pixel than it
 * has normals, and they scatter what is mirrored. */
void tp_stage_reflect_cube(const tp_shade *restrict shade, tp_run *restrict run)
{
    TP_ASSERT(shade->env.cube != NULL && shade->env.recip != NULL);
    tp_cube_sides sides = { .level = -1 };

    for (int32_t i = 0; i < run->count; ) {
        int32_t depth = tp_log_depth(shade, run->key[i]), stop = tp_block_end(run, i);
        int     coarser = 128 + (depth > 0 ? depth / 2 : 0);
        tp_cube_sides_at(&sides, shade->env.cube,
                         tp_env_level(shade, TP_ENV_CUBE, coarser));
        if (TP_WIDE) {
            reflect_wide(shade, run, sides.side, i, stop);
            i = stop;
        }
        for (; i < stop; i++) {
            tp_ray to = mirrored_at(run, i);
            tp_cube_ray ray = tp_cube_face(to.x, to.y, to.z);
            run->mirror[i] = tp_cube_look(shade, &ray, &sides.side[ray.face]);
        }
    }
}

/* Light beyond white times a small share need not be beyond it: the share comes first. */
TP_ALWAYS_INLINE uint32_t bright_mix(uint32_t a, uint32_t light, uint32_t share,
                                     uint32_t gain)
{
    uint32_t part = share * gain >> 8, left = 65536 - share, sum = 0;

    for (int k = 0; k < 24; k += 8) {
        uint32_t c = ((a >> k & 0xff) * left + (light >> k & 0xff) * part) >> 16;
        sum |= (c < 255 ? c : 255) << k;
    }
    return sum;
}

TP_ALWAYS_INLINE void fresnel(const tp_shade *restrict shade, tp_run *restrict run,
                              int hdr)
{
    const int32_t count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t light = run->mirror[i], colour = run->colour[i], bright = 0;
        int32_t  nv = run->nv[i], up = run->up[i];
        if (hdr && (TP_WIDE || light >> 24))
            bright = bright_mix(colour, light, fine_share_of(shade, nv, up),
                                tp_light_gain(shade, light));
        uint32_t mixed = tp_colour_mix(colour, light, share_of(shade, nv, up));
        run->colour[i] = hdr && light >> 24 ? bright : mixed;
    }
}

#define FRESNEL_STAGE(name, hdr) \
    void tp_stage_##name(const tp_shade *restrict shade, tp_run *restrict run) \
    { fresnel(shade, run, hdr); }
FRESNEL_STAGE(fresnel, 0)
FRESNEL_STAGE(fresnel_hdr, 1)
