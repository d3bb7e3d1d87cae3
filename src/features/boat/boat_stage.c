/* SPDX-License-Identifier: MIT */
/* Phong shading of a mesh with textures.  All vectors are in the mesh's own frame.  View
 * and light are turned into the frame once, so no normal is ever turned.
 *
 * A normal map's texel bends N along the face's tangent T and along B = +-N x T.  B is
 * perpendicular to both N and T, though T need not be perpendicular to N.  [F6] asks for
 * Gram-Schmidt here; this file omits the step, because the meshes' normals are within a
 * few degrees of their faces' normals. */
#include "features/boat/boat.h"
#include "shade/material.h"

typedef tp_vec_q14 vec;

static vec unpack_dir_q14(tp_packed_dir n)
{
    return (vec){ tp_dir_x(n) * 32, tp_dir_y(n) * 32, tp_dir_z(n) * 32 };
}

static vec cross(vec a, vec b)
{
    return (vec){ (a.y * b.z - a.z * b.y) >> 14, (a.z * b.x - a.x * b.z) >> 14,
                  (a.x * b.y - a.y * b.x) >> 14 };
}

/* Returns the texel at `st`, two coordinates in 0.16 repeats: s in the high half, t in
 * the low. */
static uint32_t fetch_texel(const tp_texture *texture, int level, uint32_t st)
{
    int w = texture->log2_w > level ? texture->log2_w - level : 0;
    int h = texture->log2_h > level ? texture->log2_h - level : 0;
    return texture->level[level][(st & 0xffff) >> (16 - h) << w | st >> 16 >> (16 - w)];
}

/* Returns the normal bent by a texel of the normal map, of any length; the caller
 * normalizes.  A sum has three products of 14 bits and, for the strongest bump, 12 bits. */
TP_ALWAYS_INLINE vec bend_normal(vec n, int32_t bump, uint32_t texel, tp_packed_dir tangent)
{
    vec t = unpack_dir_q14(tangent), b = cross(n, t);
    int32_t hand = tangent >> 30 & 1 ? -1 : 1;
    int32_t nx = ((int32_t)(texel >> 16 & 0xff) - 128) * bump >> 8;
    int32_t ny = ((int32_t)(texel >> 8 & 0xff) - 128) * bump * hand >> 8;
    int32_t nz = (int32_t)(texel & 0xff) - 128;

    nz = nz > 32 ? nz : 32;     /* a map that points inwards is faulty */
    return (vec){ n.x * nz + t.x * nx + b.x * ny, n.y * nz + t.y * nx + b.y * ny,
                  n.z * nz + t.z * nx + b.z * ny };
}

/* Returns the normal bent by the normal map's texel at `st`. */
static vec apply_normal_map(vec n, const tp_solid *solid, int level, uint32_t st,
                            tp_packed_dir tangent)
{
    return bend_normal(n, solid->bump, fetch_texel(solid->normal_map, level, st), tangent);
}

#include "features/boat/boat_wide.h"

#define LONG 8                  /* samples; loops over fewer gain nothing */

/* True if sample i begins a long part of a block. */
TP_ALWAYS_INLINE bool begins_long_part(const tp_run *run, int32_t i)
{
    return (i == 0 || ((run->x + i) & 15) == 0) && tp_block_end(run, i) - i >= LONG;
}

TP_ALWAYS_INLINE void solid_run(const tp_shade *shade, tp_run *run, int blinn)
{
    const tp_boat_shading *shading = run->mine;
    const tp_solid *solid = &shading->solid[run->material];
    const tp_texture *picture = solid->diffuse_map, *normals = solid->normal_map;
    const bool same_levels = picture && normals && picture->levels == normals->levels;
    const uint32_t shine = tp_solid_shine(shade, solid);

    tp_run_fill_vectors_to_eye(shade, &shading->axes, run);
    for (int32_t i = 0; i < run->count; i++) {
        if (TP_WIDE && !blinn && begins_long_part(run, i)) {
            const int32_t stop = tp_block_end(run, i);
            solid_columns_wide(shade, run, i, stop - i);
            i = stop - 1;
            continue;
        }
        int32_t  depth = tp_log_depth(shade, run->key[i]);
        uint32_t st = run->s[i], diffuse = solid->diffuse;
        vec n;
        int level = 0;
        if (picture) {
            level = tp_mip_level_choose(solid->lod, depth, false, picture->levels);
            diffuse = tp_colour_times(fetch_texel(picture, level, st), diffuse);
        }
        if (normals) {
            if (!same_levels)
                level = tp_mip_level_choose(solid->lod, depth, false, normals->levels);
            n = apply_normal_map(unpack_dir_q14(run->n[i]), solid, level, st,
                                 shading->mesh->faces[run->t[i]].tangent);
            n = tp_vec_q14_unit(n.x, n.y, n.z);
        } else {
            n = tp_vec_q14_unpack(run->n[i]);
        }
        run->colour[i] = tp_phong(shade, &shading->axes, solid, diffuse, shine, n,
                                  (vec){ run->vx[i], run->vy[i], run->vz[i] },
                                  run->lv[i], blinn);
    }
}

void tp_stage_solid(const tp_shade *shade, tp_run *run)
{
    solid_run(shade, run, 0);
}

void tp_stage_solid_blinn(const tp_shade *shade, tp_run *run)
{
    solid_run(shade, run, 1);
}

/* -- the fast rung ------------------------------------------------------------------- */

/*
 * Samples carry the light of their vertices (boat_light.c) instead of a normal: no normal
 * map, no view vector, no root.  The mipmap level is chosen once per 16 columns.
 */

/* Factors of a texel's channels, Q8.16: a product of 8 and 16 bits has the channel in its
 * highest byte.  `shine`: the highlight to add. */
typedef struct {
    uint32_t r, g, b, shine;
} light_factors;

/* d is a channel of the material, 0..255, share at most 256; the result is at most
 * 65535. */
static inline uint32_t channel_factor(uint32_t d, uint32_t share)
{
    const uint32_t q = d * share;
    return q + (q >> 8);
}

static light_factors find_factors(const tp_shade *shade, const tp_solid *solid,
                                  uint32_t shine, uint32_t light)
{
    const int32_t nl = tp_dir_x(light), lobe = tp_dir_y(light);
    const uint32_t share =
        (uint32_t)tp_lit_share(shade->ambient, nl > 0 ? 32 * nl + 31 : 0);
    const uint32_t gloss = nl > 0 && lobe > 0 ? solid->gloss[lobe >> 1] : 0;

    return (light_factors){
        channel_factor(solid->diffuse >> 16 & 0xff, share),
        channel_factor(solid->diffuse >> 8 & 0xff, share),
        channel_factor(solid->diffuse & 0xff, share),
        gloss ? tp_colour_scale(shine, gloss) : 0,
    };
}

/* Half a channel is added before each cut.  255 x 65535 + 2^15 is below 2^24. */
TP_ALWAYS_INLINE uint32_t light_texel(uint32_t texel, const light_factors *f)
{
    const uint32_t r = (texel >> 16 & 0xff) * f->r + 0x8000,
                   g = (texel >> 8 & 0xff) * f->g + 0x8000,
                   b = (texel & 0xff) * f->b + 0x8000;
    const uint32_t colour = (r & 0xff0000) | (g >> 8 & 0xff00) | b >> 16;

    return f->shine ? tp_colour_add(colour, f->shine) : colour;
}

/* Texels of one mipmap level, by positions of 0.16 repeats. */
typedef struct {
    const uint32_t *texel;
    uint32_t down_s, down_t, log2_w;
} texels;

static const uint32_t white = 0xffffff;

static texels choose_texels(const tp_texture *picture, int level)
{
    if (!picture)
        return (texels){ &white, 16, 16, 0 };
    const uint32_t w = (uint32_t)(picture->log2_w > level ? picture->log2_w - level : 0),
                   h = (uint32_t)(picture->log2_h > level ? picture->log2_h - level : 0);
    return (texels){ picture->level[level], 16 - w, 16 - h, w };
}

TP_ALWAYS_INLINE uint32_t fetch_block_texel(const texels *p, uint32_t st)
{
    return p->texel[(st & 0xffff) >> p->down_t << p->log2_w | st >> 16 >> p->down_s];
}

/* Bits of the light that count: 128 steps of N.L, 64 of the lobe's cosine. */
#define STEPS (0x3fcu | 0xfe000u)

void tp_stage_solid_fast(const tp_shade *shade, tp_run *run)
{
    const tp_boat_shading *shading = run->mine;
    const tp_solid *solid = &shading->solid[run->material];
    const tp_texture *picture = solid->diffuse_map;
    const uint32_t shine = tp_solid_shine(shade, solid);
    uint32_t light = ~(uint32_t)0;
    light_factors f = { 0, 0, 0, 0 };

    for (int32_t i = 0; i < run->count; ) {
        const int32_t stop = tp_block_end(run, i), depth = tp_log_depth(shade, run->key[i]);
        const texels block = choose_texels(
            picture,
            picture ? tp_mip_level_choose(solid->lod, depth, false, picture->levels) : 0);
        for (; i < stop; i++) {
            if ((run->n[i] & STEPS) != light) {
                light = run->n[i] & STEPS;
                f = find_factors(shade, solid, shine, light);
            }
            run->colour[i] = light_texel(fetch_block_texel(&block, run->s[i]), &f);
        }
    }
}

const tp_stage tp_boat_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_boat(X)
#undef X
};
