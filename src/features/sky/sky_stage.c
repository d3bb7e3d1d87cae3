/* SPDX-License-Identifier: MIT */
/*
 * Stages of the cube sky and of the dome: look-up along the view ray where the sky is
 * visible, and along the reflected ray on water.
 */
#include "features/sky/sky.h"
#include "shade/env.h"
#include "shade/rough_lobe.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

/* -- the cube ------------------------------------------------------------------------ */

/*
 * Many directions are looked up at one mipmap level, with the result of env.h.  The
 * faces' data at the level are found once.  On processors with SIMD, steps for eight
 * directions at once are separate loops.
 */

/* -- look-ups along many directions -------------------------------------------------- */

typedef struct {
    int level;                  /* mipmap level of `side`; -1: not set */
    tp_cube_face_level side[TP_CUBE_FACES];
} tp_cube_sides;

TP_ALWAYS_INLINE void select_cube_sides(tp_cube_sides *sides, const tp_cube *cube,
                                        int level)
{
    if (sides->level == level)
        return;
    sides->level = level;
    for (int i = 0; i < TP_CUBE_FACES; i++)
        sides->side[i] = tp_cube_face_level_select(cube->face[i], level);
}

#define TP_CUBE_ROW 16

/* Looks up to TP_CUBE_ROW directions.  The faces and coordinates are computed eight at a
 * time, the texels are read one by one, the colours are mixed eight at a time. */
TP_ALWAYS_INLINE void sample_cube_wide(const tp_shade *restrict shade,
                                       const tp_cube_face_level *restrict side,
                                       const int32_t *restrict x,
                                       const int32_t *restrict y,
                                       const int32_t *restrict z, int32_t count,
                                       uint32_t *restrict out)
{
    int32_t  face[TP_CUBE_ROW], first[TP_CUBE_ROW];
    int32_t  right[TP_CUBE_ROW], below[TP_CUBE_ROW];
    uint32_t fu[TP_CUBE_ROW], fv[TP_CUBE_ROW], four[4][TP_CUBE_ROW];

    for (int32_t i = 0; i < count; i++) {
        tp_cube_ray  c = tp_cube_face(x[i], y[i], z[i]);
        tp_cube_four f = tp_cube_find_texels(shade->env.recip, c.m, c.right, c.down,
                                             side[c.face].log2_w, side[c.face].log2_h);
        face[i] = c.face;
        first[i] = f.first;
        right[i] = f.right;
        below[i] = f.below;
        fu[i] = f.fu;
        fv[i] = f.fv;
    }
    for (int32_t i = 0; i < count; i++) {
        const uint32_t *at = side[face[i]].texel + first[i], *low = at + below[i];
        four[0][i] = at[0];
        four[1][i] = at[right[i]];
        four[2][i] = low[0];
        four[3][i] = low[right[i]];
    }
    for (int32_t i = 0; i < count; i++)
        out[i] = tp_cube_mix(four[0][i], four[1][i], four[2][i], four[3][i], fu[i], fv[i])
               & shade->env.cube->mask[face[i]];
}

/* -- stages -------------------------------------------------------------------------- */

/* Shades the sky in samples [i, stop), at most TP_CUBE_ROW. */
TP_ALWAYS_INLINE void shade_cube_wide(const tp_shade *restrict shade, tp_run *restrict run,
                                     const tp_cube_face_level *side, int32_t i,
                                     int32_t stop, int hdr)
{
    int32_t  x[TP_CUBE_ROW], y[TP_CUBE_ROW], z[TP_CUBE_ROW], count = stop - i;
    uint32_t light[TP_CUBE_ROW];

    for (int32_t k = 0; k < count; k++) {
        x[k] = -run->vx[i + k];
        y[k] = -run->vy[i + k];
        z[k] = -run->vz[i + k];
    }
    sample_cube_wide(shade, side, x, y, z, count, light);
    for (int32_t k = 0; k < count; k++)
        run->colour[i + k] = tp_sky_colour(shade, light[k], hdr);
}

/* A block of samples in one face: the components of tp_cube_face, negated vectors to the
 * eye, and their signs. */
typedef struct {
    const int16_t *m, *right, *down;
    int32_t sign_m, sign_right, sign_down;
} face_block;

static face_block face_block_make(const tp_run *run, int face)
{
    const int16_t *x = run->vx, *y = run->vy, *z = run->vz;
    const int32_t  sign = face & 1 ? 1 : -1;

    if (face < 2)
        return (face_block){ x, z, y, sign, sign, 1 };
    if (face < 4)
        return (face_block){ y, x, z, sign, 1, sign };
    return (face_block){ z, x, y, sign, -sign, 1 };
}

#define CLEAR 1024              /* Q14: distance to a face's edges */

/* True if a vector is far from the face's edges. */
TP_ALWAYS_INLINE bool is_clear(const face_block *block, int32_t i)
{
    const int32_t m = block->sign_m * block->m[i] - CLEAR;

    return tp_abs(block->right[i]) < m && tp_abs(block->down[i]) < m;
}

/* True if samples i..last of a block lie on one face.  Between the ends a component strays
 * from their chord by at most an eighth of the square of the angle: 440 of 16384 if the
 * ends' components differ by less than a quarter; two components by less than CLEAR. */
static bool is_on_face(const face_block *block, int32_t i, int32_t last)
{
    return is_clear(block, i) && is_clear(block, last)
        && tp_abs(block->m[last] - block->m[i]) < 4096
        && tp_abs(block->right[last] - block->right[i]) < 4096
        && tp_abs(block->down[last] - block->down[i]) < 4096;
}

TP_ALWAYS_INLINE void shade_face(const tp_shade *shade, tp_run *run, int face,
                                 const face_block *block, const tp_cube_face_level *side,
                                 int32_t i, int32_t stop, int hdr)
{
    for (; i < stop; i++) {
        const tp_cube_ray ray = { face, block->sign_right * block->right[i],
                                  block->sign_down * block->down[i],
                                  block->sign_m * block->m[i] };
        run->colour[i] = tp_sky_colour(shade, tp_cube_sample(shade, &ray, side), hdr);
    }
}

TP_ALWAYS_INLINE void shade_any_face(const tp_shade *shade, tp_run *run,
                                     const tp_cube_sides *sides, int32_t i, int32_t stop,
                                     int hdr)
{
    for (; i < stop; i++) {
        tp_cube_ray ray = tp_cube_face(-run->vx[i], -run->vy[i], -run->vz[i]);
        uint32_t    light = tp_cube_sample(shade, &ray, &sides->side[ray.face]);
        run->colour[i] = tp_sky_colour(shade, light, hdr);
    }
}

TP_ALWAYS_INLINE void shade_cube(const tp_shade *shade, tp_run *run, int hdr)
{
    TP_ASSERT(shade->env.cube != NULL);
    tp_cube_sides sides = { .level = -1 };

    tp_run_fill_sky_vectors(shade, run);
    select_cube_sides(&sides, shade->env.cube, tp_env_mip_level(shade, TP_ENV_CUBE, 0));
    for (int32_t i = 0, stop; i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        if (TP_WIDE) {
            shade_cube_wide(shade, run, sides.side, i, stop, hdr);
            continue;
        }
        const int face = tp_cube_face(-run->vx[i], -run->vy[i], -run->vz[i]).face;
        const face_block block = face_block_make(run, face);
        if (is_on_face(&block, i, stop - 1))
            shade_face(shade, run, face, &block, &sides.side[face], i, stop, hdr);
        else
            shade_any_face(shade, run, &sides, i, stop, hdr);
    }
}

void tp_stage_sky_cube(const tp_shade *shade, tp_run *run)
{
    shade_cube(shade, run, 0);
}

void tp_stage_sky_cube_hdr(const tp_shade *shade, tp_run *run)
{
    shade_cube(shade, run, 1);
}

/* Shades the reflection in samples [i, stop), at most TP_CUBE_ROW. */
TP_ALWAYS_INLINE void reflect_wide(const tp_shade *restrict shade, tp_run *restrict run,
                                   const tp_cube_face_level *side, int32_t i, int32_t stop)
{
    int32_t x[TP_CUBE_ROW], y[TP_CUBE_ROW], z[TP_CUBE_ROW], count = stop - i;

    for (int32_t k = 0; k < count; k++) {
        tp_ray to = tp_reflected_compute(run, i + k);
        x[k] = to.x;
        y[k] = to.y;
        z[k] = to.z;
    }
    sample_cube_wide(shade, side, x, y, z, count, run->mirror + i);
}

/* Returns the levels, Q8, by which the mirrored cube is coarser at a depth.  In far water
 * a pixel holds more waves than normals, and the waves scatter the reflection: the level
 * gets coarser with depth, and so much that a texel, 2 / side of a radian, is twice the
 * spread of the mirrored rays, which is twice that of the slopes [V3]. */
static int32_t coarser_mirror(const tp_shade *shade, int32_t log_depth)
{
    const int32_t far = 128 + (log_depth > 0 ? log_depth / 2 : 0);

    if (!shade->ripple && !shade->filtered)
        return far;
    const uint32_t variance = tp_rough_variance(shade, log_depth).along;
    const int32_t spread = (tp_log2_q8(variance | 1) - 24 * 256) / 2
                         + shade->env.cube->face[0]->log2_w * 256;
    return spread - shade->env.cube->lod > far ? spread - shade->env.cube->lod : far;
}

/* Reflects the cube.  The mipmap level is chosen for blocks of 16 columns. */
void tp_stage_reflect_cube(const tp_shade *restrict shade, tp_run *restrict run)
{
    TP_ASSERT(shade->env.cube != NULL && shade->env.recip != NULL);
    tp_cube_sides sides = { .level = -1 };

    for (int32_t i = 0; i < run->count; ) {
        int32_t stop = tp_block_end(run, i);
        int32_t coarser = coarser_mirror(shade, tp_log_depth(shade, run->key[i]));
        select_cube_sides(&sides, shade->env.cube,
                          tp_env_mip_level(shade, TP_ENV_CUBE, coarser));
        if (TP_WIDE) {
            reflect_wide(shade, run, sides.side, i, stop);
            i = stop;
        }
        for (; i < stop; i++) {
            tp_ray to = tp_reflected_compute(run, i);
            tp_cube_ray ray = tp_cube_face(to.x, to.y, to.z);
            run->mirror[i] = tp_cube_sample(shade, &ray, &sides.side[ray.face]);
        }
    }
}

const tp_stage tp_sky_cube_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_sky_cube(X)
#undef X
};

/* -- the dome ------------------------------------------------------------------------ */

TP_ALWAYS_INLINE void compute_dome_colours(const tp_dome *restrict dome, uint32_t least,
                                           const uint32_t *restrict square,
                                           const int32_t *restrict height, int32_t count,
                                           uint32_t *restrict out)
{
    for (int32_t i = 0; i < count; i++)
        out[i] = tp_dome_colour(dome, square[i], height[i],
                                tp_dome_lookup_glow(dome, least, square[i]));
}

/* Shades the sky in loops over all samples. */
TP_ALWAYS_INLINE void shade_dome_wide(const tp_shade *restrict shade, tp_run *restrict run,
                                      int hdr)
{
    const int32_t count = run->count;
    uint32_t square[TP_RUN], light[TP_RUN];
    int32_t  height[TP_RUN];

    for (int32_t i = 0; i < count; i++) {
        height[i] = -run->vy[i];
        square[i] = tp_light_chord_square(shade, -run->vx[i], -run->vy[i], -run->vz[i]);
    }
    compute_dome_colours(shade->env.dome, 0, square, height, count, light);
    for (int32_t i = 0; i < count; i++)
        run->colour[i] = tp_sky_colour(shade, light[i], hdr);
}

TP_ALWAYS_INLINE void shade_dome(const tp_shade *shade, tp_run *run, int hdr)
{
    TP_ASSERT(shade->env.dome != NULL);
    const int32_t count = run->count;

    tp_run_fill_sky_vectors(shade, run);
    if (TP_WIDE) {
        shade_dome_wide(shade, run, hdr);
        return;
    }
    for (int32_t i = 0; i < count; i++) {
        uint32_t light = tp_env_dome(shade, 0, -run->vx[i], -run->vy[i], -run->vz[i]);
        run->colour[i] = tp_sky_colour(shade, light, hdr);
    }
}

void tp_stage_sky_dome(const tp_shade *shade, tp_run *run)
{
    shade_dome(shade, run, 0);
}

void tp_stage_sky_dome_hdr(const tp_shade *shade, tp_run *run)
{
    shade_dome(shade, run, 1);
}

/* Shades the reflection in two loops. */
TP_ALWAYS_INLINE void reflect_dome_wide(const tp_shade *restrict shade,
                                        tp_run *restrict run)
{
    const int32_t count = run->count;
    uint32_t square[TP_RUN];
    int32_t  height[TP_RUN];

    for (int32_t i = 0; i < count; i++) {
        tp_ray to = tp_reflected_compute(run, i);
        height[i] = to.y;
        square[i] = tp_light_chord_square(shade, to.x, to.y, to.z);
    }
    compute_dome_colours(shade->env.dome, shade->env.least, square, height, count,
                         run->mirror);
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
        tp_ray to = tp_reflected_compute(run, i);
        run->mirror[i] = tp_env_dome(shade, shade->env.least, to.x, to.y, to.z);
    }
}

const tp_stage tp_sky_dome_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_sky_dome(X)
#undef X
};
