/* SPDX-License-Identifier: MIT */
/*
 * Materials: Phong or Blinn lighting of solids, with their normals, unpacked from samples,
 * and the argument of the table of a specular lobe; texture sampling of repeating
 * pictures, and the materials of floors and walls.
 */
#ifndef TP_SHADE_MATERIAL_H
#define TP_SHADE_MATERIAL_H
#include "base/dsp.h"
#include "fixed/arithmetic.h"
#include "mesh/mesh.h"
#include "shade/env.h"
#include "shade/shade.h"

/* -- normals of solids --------------------------------------------------------------- */

typedef struct {
    int32_t x, y, z;            /* Q1.14 unless a comment names another format */
} tp_vec_q14;

static inline int32_t tp_vec_q14_dot(tp_vec_q14 a, tp_vec_q14 b)
{
    return (a.x * b.x + a.y * b.y + a.z * b.z) >> 14;
}

/* Returns the unit vector along a vector of any length but 0. */
static inline tp_vec_q14 tp_vec_q14_unit(int32_t x, int32_t y, int32_t z)
{
    tp_dir3 d = tp_normalise(x, y, z);
    return (tp_vec_q14){ d.x >> 16, d.y >> 16, d.z >> 16 };
}

/* Returns (x 2^half inverse) / 2^33, rounded as Q2.30 and truncated to Q1.14.
 * |x| 2^half <= 2^25, half >= 6. */
static inline int32_t tp_dir_component_q14(int32_t x, int half, uint32_t inverse)
{
    return (int32_t)(((int64_t)(x * (1 << (half - 1))) * inverse + 0x8000) >> 32);
}

/* Returns the bits of tp_vec_q14_unit at lower cost: the sum of squares is below 2^20, so
 * 32 bits hold it, and each component is rounded from one product. */
static inline tp_vec_q14 tp_vec_q14_unpack(tp_packed_dir n)
{
    const int32_t x = tp_dir_x(n), y = tp_dir_y(n), z = tp_dir_z(n);
    const uint32_t sum = (uint32_t)(x * x + y * y + z * z);

    if (sum == 0)
        return (tp_vec_q14){ 0, 16384, 0 };
    const int half = tp_clz(sum) >> 1;
    const uint32_t inverse = tp_rsqrt_norm(sum << 2 * half);
    return (tp_vec_q14){ tp_dir_component_q14(x, half, inverse),
                         tp_dir_component_q14(y, half, inverse),
                         tp_dir_component_q14(z, half, inverse) };
}

/* -- the specular lobe --------------------------------------------------------------- */

/*
 * Argument of the lobe's table: R.V for Phong, 2 (N.H)^2 - 1 for Blinn, the same angle for
 * the same mirrored light.
 *
 * H is L + V normalised, and |L + V|^2 = 2 + 2 L.V.  Hence (N.H)^2 = (N.L + N.V)^2 / (2 +
 * 2 L.V): no vector and no root, only a reciprocal [F5].
 */

/* The part of the argument that L and V decide: 1 / (2 + 2 L.V). */
typedef struct {
    uint32_t recip, down;       /* a reciprocal, and the shift that scales it */
} tp_blinn_half;

/* All arguments and the result are Q1.14.  The square of the sum is below 2^30, the
 * reciprocal at most 2^32.  Where L is nearly -V (light from straight behind) hardly any
 * half vector exists; a result beyond the lobe's peak is clamped to the peak. */
TP_ALWAYS_INLINE tp_blinn_half tp_blinn_half_make(int32_t lv)
{
    uint32_t w = (uint32_t)tp_clamp(16384 + lv, 2, 32768);
    int      up = tp_clz(w);

    return (tp_blinn_half){ tp_recip_norm(w << up), (uint32_t)(63 - up) };
}

TP_ALWAYS_INLINE int32_t tp_blinn_half_cosine(const tp_blinn_half *half, int32_t nl,
                                              int32_t nv)
{
    uint32_t sum = (uint32_t)tp_clamp(nl + nv, 0, 32767);
    uint64_t square = (uint64_t)(sum * sum) * half->recip >> half->down;

    return square < 32768 ? (int32_t)square - 16384 : 16384;
}

TP_ALWAYS_INLINE int32_t tp_blinn_double_angle_cosine(int32_t nl, int32_t nv, int32_t lv)
{
    tp_blinn_half half = tp_blinn_half_make(lv);
    return tp_blinn_half_cosine(&half, nl, nv);
}

/* Returns the cosine for the lobe's table, Q1.14: R.V for Phong, 2 (N.H)^2 - 1 for
 * Blinn. */
TP_ALWAYS_INLINE int32_t tp_lobe_table_cosine(int32_t nl, int32_t nv, int32_t lv, int blinn)
{
    return blinn ? tp_blinn_double_angle_cosine(nl, nv, lv) : (2 * nl * nv >> 14) - lv;
}

/* -- the lit colour ------------------------------------------------------------------ */

/* The specular lobe at R.V, interpolated between table entries: near the peak of a sharp
 * lobe neighbouring entries differ much. */
static inline uint32_t tp_gloss_lookup(const tp_solid *solid, int32_t rv)
{
    int32_t at = rv * (TP_GLOSS - 1), i = at >> 14, part = (at & 16383) >> 6;
    int32_t here = solid->gloss[i], next = solid->gloss[i + 1 < TP_GLOSS ? i + 1 : i];

    return (uint32_t)(here + ((next - here) * part >> 8));
}

/* Returns the colour of a material's highlight at its peak. */
static inline uint32_t tp_solid_shine(const tp_shade *shade, const tp_solid *solid)
{
    return tp_colour_times(solid->specular, shade->light_colour);
}

/* Lit colour of a normal and a view vector in the given axes; lv is light . view; `shine`
 * of tp_solid_shine. */
TP_ALWAYS_INLINE uint32_t tp_phong(const tp_shade *shade, const tp_view_axes *axes,
                                   const tp_solid *solid, uint32_t diffuse, uint32_t shine,
                                   tp_vec_q14 n, tp_vec_q14 v, int32_t lv, int blinn)
{
    tp_vec_q14 light = { axes->lx, axes->ly, axes->lz };
    int32_t nl = tp_clamp(tp_vec_q14_dot(n, light), 0, 16384);
    int32_t rv =
        tp_clamp(tp_lobe_table_cosine(nl, tp_vec_q14_dot(n, v), lv, blinn), 0, 16384);
    uint32_t bright = (uint32_t)tp_lit_share(shade->ambient, nl);
    uint32_t gloss = nl > 0 ? tp_gloss_lookup(solid, rv) : 0;

    return tp_colour_add(tp_colour_scale(diffuse, bright), tp_colour_scale(shine, gloss));
}

/* -- texture sampling ---------------------------------------------------------------- */

/*
 * The mipmap level is chosen once per 16 columns, from the first sample there.  The nearest
 * filter takes one texel; the linear filter weighs four texels in steps of 1/256 of a
 * texel.
 *
 * One level per 16 columns is enough.  Measured on a still sea with a linear texture
 * drifting 1 cm a frame, seen from 3 m at 640 x 480: the change of a row from frame to
 * frame exceeds the change with 16 samples a pixel by at most 0.3 levels of 255, and level
 * changes show no edges.
 *
 * Sides are powers of two: the highest bits of a position in repeats are the texel's
 * column, and shifts of one word extract them.  Indices are signed because vector gathers
 * of eight take signed indices.
 */

/* -- one mipmap level, and four of its texels ---------------------------------------- */

typedef struct {
    const uint32_t *texel;
    uint32_t half_s, half_t;    /* half a texel, Q0.32 repeats */
    uint32_t down_s, down_t;    /* shift to 1/256 texel: 24 - log2(side) */
    uint32_t last_s, last_t;    /* number of columns, of rows, minus 1 */
    uint32_t log2_w;
} tp_mip_level;

static inline tp_mip_level tp_mip_level_select(const tp_texture *texture, int l)
{
    uint32_t log2_w = (uint32_t)(texture->log2_w > l ? texture->log2_w - l : 0);
    uint32_t log2_h = (uint32_t)(texture->log2_h > l ? texture->log2_h - l : 0);

    return (tp_mip_level){
        .texel = texture->level[l],
        .half_s = 0x80000000u >> log2_w, .half_t = 0x80000000u >> log2_h,
        .down_s = 24 - log2_w, .down_t = 24 - log2_h,
        .last_s = (1u << log2_w) - 1, .last_t = (1u << log2_h) - 1,
        .log2_w = log2_w,
    };
}

/* Four texels, the upper pair first, and the weights of the right and the lower texels. */
typedef struct {
    uint32_t texel[4], fs, ft;
} tp_four;

/* Returns the texel at (s, t), Q0.32 repeats, and its right and lower neighbours.  The
 * caller subtracts half a texel from the sampled point first. */
TP_ALWAYS_INLINE tp_four tp_four_gather(const tp_mip_level *l, uint32_t s, uint32_t t)
{
    uint32_t su = s >> l->down_s, tv = t >> l->down_t, u = su >> 8, v = tv >> 8;
    uint32_t u1 = (u + 1) & l->last_s, row = v << l->log2_w;
    uint32_t below = ((v + 1) & l->last_t) << l->log2_w;

    return (tp_four){ { l->texel[(int32_t)(row + u)], l->texel[(int32_t)(row + u1)],
                        l->texel[(int32_t)(below + u)], l->texel[(int32_t)(below + u1)] },
                      su & 0xff, tv & 0xff };
}

/* Returns the four texels around the point (s, t).  Weights are the eight bits below a
 * texel. */
TP_ALWAYS_INLINE tp_four tp_four_gather_centred(const tp_mip_level *l, uint32_t s,
                                                uint32_t t)
{
    return tp_four_gather(l, s - l->half_s, t - l->half_t);
}

/* Mixes the greens of both rows in the halves of a word, then the rows. */
TP_ALWAYS_INLINE uint32_t tp_four_interpolate_green(const tp_four *f)
{
    const uint32_t left = tp_odd_bytes(tp_pack_low_halves(f->texel[0], f->texel[2]));
    const uint32_t right = tp_odd_bytes(tp_pack_low_halves(f->texel[1], f->texel[3]));
    const uint32_t rows = tp_odd_bytes(left * (256 - f->fs) + right * f->fs + TP_HALF_RB);

    return (uint32_t)tp_smlad(rows, tp_pack_low_halves(256 - f->ft, f->ft), 128) >> 8;
}

TP_ALWAYS_INLINE tp_split_rgb tp_four_interpolate(const tp_four *f)
{
    tp_split_rgb above = tp_split_rgb_mix(tp_split_rgb_make(f->texel[0]),
                                          tp_split_rgb_make(f->texel[1]), f->fs);
    tp_split_rgb below = tp_split_rgb_mix(tp_split_rgb_make(f->texel[2]),
                                          tp_split_rgb_make(f->texel[3]), f->fs);
    tp_split_rgb mixed = tp_split_rgb_mix(above, below, f->ft);

    if (TP_DSP)
        mixed.g = tp_four_interpolate_green(f);
    return mixed;
}

TP_ALWAYS_INLINE uint32_t tp_mip_level_sample_linear(const tp_mip_level *l, uint32_t s,
                                                     uint32_t t)
{
    tp_four f = tp_four_gather_centred(l, s, t);
    return tp_split_rgb_join(tp_four_interpolate(&f));
}

/* The channel at bit `shift` of tp_mip_level_sample_linear, 0..255. */
TP_ALWAYS_INLINE uint32_t tp_mip_level_channel_linear(const tp_mip_level *l, uint32_t s,
                                                      uint32_t t, int shift)
{
    tp_four  f = tp_four_gather_centred(l, s, t);
    uint32_t above = tp_channel_mix(f.texel[0] >> shift & 0xff,
                                    f.texel[1] >> shift & 0xff, f.fs);
    uint32_t below = tp_channel_mix(f.texel[2] >> shift & 0xff,
                                    f.texel[3] >> shift & 0xff, f.fs);

    return tp_channel_mix(above, below, f.ft);
}

/* -- the mipmap level of a layer ----------------------------------------------------- */

static inline int tp_layer_mip_level(const tp_shade *shade, const tp_layer *layer,
                                     uint32_t key)
{
    return tp_mip_level_choose(layer->lod, tp_log_depth(shade, key), true,
                               layer->texture->levels);
}

/* Neighbouring samples of a run with one mipmap level: the unit of the sampling loops. */
typedef struct {
    const uint32_t *s, *t;      /* positions, from the stretch's first sample on */
    int32_t begin, count;
    int     level;
} tp_stretch;

/* Returns the stretch that starts at sample `begin`, the start of 16 columns or of the
 * run; s and t are the run's arrays. */
static inline tp_stretch tp_stretch_find(const tp_shade *shade, const tp_run *run,
                                         const tp_layer *layer, const uint32_t *s,
                                         const uint32_t *t, int32_t begin)
{
    int     level = tp_layer_mip_level(shade, layer, run->key[begin]);
    int32_t stop = tp_block_end(run, begin);

    while (stop < run->count && tp_layer_mip_level(shade, layer, run->key[stop]) == level)
        stop = tp_block_end(run, stop);
    return (tp_stretch){ s + begin, t + begin, begin, stop - begin, level };
}

/* A layer at one level.  A product and a sum turn positions in m into repeats. */
typedef struct {
    tp_mip_level level;
    uint32_t per_s, per_t, drift_s, drift_t;
} tp_sampler;

/* Sampler of four texels. */
static inline tp_sampler tp_sampler_linear(const tp_layer *layer, int level)
{
    tp_mip_level l = tp_mip_level_select(layer->texture, level);

    return (tp_sampler){ l, layer->per_metre, layer->per_metre,
                         layer->drift_s - l.half_s, layer->drift_t - l.half_t };
}

TP_ALWAYS_INLINE tp_four tp_sampler_four(const tp_sampler *p, uint32_t s, uint32_t t)
{
    return tp_four_gather(&p->level, s * p->per_s + p->drift_s, t * p->per_s + p->drift_t);
}

/* Sampler of one texel: shifts go to whole texels.  A side of one texel would need a shift
 * by 32; its positions are set to 0 instead. */
static inline tp_sampler tp_sampler_nearest(const tp_layer *layer, int level)
{
    tp_mip_level l = tp_mip_level_select(layer->texture, level);
    bool one_s = l.last_s == 0, one_t = l.last_t == 0;

    l.down_s = one_s ? 0 : l.down_s + 8;
    l.down_t = one_t ? 0 : l.down_t + 8;
    return (tp_sampler){
        l, one_s ? 0 : layer->per_metre, one_t ? 0 : layer->per_metre,
        one_s ? 0 : layer->drift_s, one_t ? 0 : layer->drift_t,
    };
}

TP_ALWAYS_INLINE uint32_t tp_sampler_texel(const tp_sampler *p, uint32_t s, uint32_t t)
{
    uint32_t u = (s * p->per_s + p->drift_s) >> p->level.down_s;
    uint32_t v = (t * p->per_t + p->drift_t) >> p->level.down_t;

    return p->level.texel[(int32_t)((v << p->level.log2_w) + u)];
}

/* Sampler of one texel, or of the mean of four; `filter` is a literal, 0 or 1. */
static inline tp_sampler tp_sampler_choose(const tp_layer *layer, int level, int filter)
{
    TP_ASSERT(level >= 0 && level < layer->texture->levels);
    return filter ? tp_sampler_linear(layer, level) : tp_sampler_nearest(layer, level);
}

TP_ALWAYS_INLINE tp_split_rgb tp_sampled(const tp_sampler *p, uint32_t s, uint32_t t,
                                         int filter)
{
    if (!filter)
        return tp_split_rgb_make(tp_sampler_texel(p, s, t));
    tp_four f = tp_sampler_four(p, s, t);
    return tp_four_interpolate(&f);
}

/* -- materials of static geometry ---------------------------------------------------- */

/*
 * The material of static geometry (floor, walls): its colour at a distance, and its colour
 * in the light.
 */

TP_ALWAYS_INLINE tp_mip_level tp_wall_material_level(const tp_wall_material *material,
                                                     tp_fx far, bool ground)
{
    int32_t log_far = tp_log2_q8((uint32_t)far | 1) - 16 * 256;
    return tp_mip_level_select(
        material->texture,
        tp_mip_level_choose(material->lod, log_far, ground, material->texture->levels));
}

/* Colour of the material at (x, z) metres in its plane, seen from `far` metres away.
 * `ground`: true if the plane is level. */
TP_ALWAYS_INLINE uint32_t tp_wall_material_sample(const tp_wall_material *material, tp_fx x,
                                                  tp_fx z, tp_fx far, bool ground)
{
    if (!material->texture)
        return material->colour;
    tp_mip_level level = tp_wall_material_level(material, far, ground);
    uint32_t texel = tp_mip_level_sample_linear(&level, (uint32_t)x * material->per_metre,
                                                (uint32_t)z * material->per_metre);
    return tp_colour_times(texel, material->colour);
}

/* The channel at bit `shift` of tp_wall_material_sample, 0..255. */
TP_ALWAYS_INLINE uint32_t tp_wall_material_channel(const tp_wall_material *material,
                                                   tp_fx x, tp_fx z, tp_fx far,
                                                   bool ground, int shift)
{
    uint32_t colour = material->colour >> shift & 0xff;

    if (!material->texture)
        return colour;
    tp_mip_level level = tp_wall_material_level(material, far, ground);
    return tp_divide_by_255(
        tp_mip_level_channel_linear(&level, (uint32_t)x * material->per_metre,
                                    (uint32_t)z * material->per_metre, shift) * colour);
}

/* Returns a matt colour lit by sun and ambient light; `normal` is the surface normal. */
static inline uint32_t tp_light_matt_colour(const tp_shade *shade, uint32_t colour,
                                            tp_packed_dir normal)
{
    const tp_view_axes *world = &shade->world;
    int32_t nl = tp_vec_q14_dot(tp_vec_q14_unpack(normal),
                                (tp_vec_q14){ world->lx, world->ly, world->lz });
    return tp_colour_scale(colour, (uint32_t)tp_lit_share(shade->ambient,
                                                          tp_clamp(nl, 0, 16384)));
}

#endif
