/* SPDX-License-Identifier: MIT */
/*
 * Tables of fast shading: bakes textures, and makes the tables of light from the tables
 * of the exact stages.  See fast_shading.h.
 */
#include "features/water/fast_shading.h"
#include "features/water/water.h"
#include "shade/colour.h"
#include "shade/env.h"
#include "shade/rough_lobe.h"
#include "world/world.h"

/* -- baked textures ------------------------------------------------------------------ */

/* Parameters of the baking of a texel. */
typedef struct {
    tp_grade grade;
    uint32_t tint;
    bool     graded;
    int32_t  gain;              /* of normals, Q8; of offsets, 16.16 m */
} bake_work;

typedef uint32_t (*texel_work)(const bake_work *w, uint32_t texel);

static uint32_t longer_side_log2(const tp_texture *t)
{
    return t->log2_w > t->log2_h ? t->log2_w : t->log2_h;
}

/* Returns log2 of the baked side, 1..TP_QUICK_LOG2. */
static uint32_t baked_side_log2(const tp_texture *from)
{
    return (uint32_t)tp_clamp((int32_t)longer_side_log2(from), 1, TP_QUICK_LOG2);
}

/* Sum of 4^n words for n of 0..side. */
size_t tp_quick_bytes(const tp_texture *from)
{
    return ((4u << 2 * baked_side_log2(from)) - 1) / 3 * sizeof(uint32_t);
}

static uint32_t level_log2(uint32_t log2, uint32_t level)
{
    return log2 > level ? log2 - level : 0;
}

static void bake_level(uint32_t *to, uint32_t log2, const tp_texture *from,
                       uint32_t level, texel_work texel, const bake_work *w)
{
    const uint32_t log2_w = level_log2(from->log2_w, level);
    const uint32_t log2_h = level_log2(from->log2_h, level);
    const uint32_t right = log2 - log2_w, down = log2 - log2_h;

    for (uint32_t y = 0; y < 1u << log2; y++) {
        const uint32_t *row = from->level[level] + ((size_t)(y >> down) << log2_w);
        for (uint32_t x = 0; x < 1u << log2; x++)
            *to++ = texel(w, row[x >> right]);
    }
}

static void bake_levels(tp_texture *to, const tp_texture *from, texel_work texel,
                        const bake_work *w, uint32_t *mem)
{
    TP_ASSERT(from->levels > 0 && (uintptr_t)mem % 4 == 0);
    const uint32_t side = baked_side_log2(from), whole = longer_side_log2(from);
    const uint32_t left_out = whole > side ? whole - side : 0;

    *to = (tp_texture){ .log2_w = (uint8_t)side, .log2_h = (uint8_t)side,
                        .levels = (uint8_t)(side + 1) };
    for (uint32_t l = 0; l <= side; l++) {
        const uint32_t level = l + left_out;
        to->level[l] = mem;
        bake_level(mem, side - l, from, level <= whole ? level : whole, texel, w);
        mem += (size_t)1 << 2 * (side - l);
    }
}

tp_quick_map tp_quick_map_make(const tp_layer *layer)
{
    const tp_texture *texture = layer->texture;

    if (!texture)
        return (tp_quick_map){ .level = NULL };
    return (tp_quick_map){ layer->per_metre, layer->drift_s, layer->drift_t, layer->lod,
                           texture->levels - 2, texture->log2_w, texture->level };
}

/* -- layers: as in layers_stage.c ---------------------------------------------------- */

static uint32_t graded_texel(const bake_work *w, uint32_t texel)
{
    return w->graded ? tp_grade_texel(&w->grade, tp_split_rgb_make(texel))
                     : tp_colour_times(texel, w->tint);
}

void tp_quick_graded(tp_texture *to, const tp_texture *from, tp_fx saturation, tp_fx clamp,
                     uint32_t colour, void *mem)
{
    const bake_work w = { .grade = tp_grade_make(saturation, clamp, colour), .tint = colour,
                     .graded = tp_is_graded(saturation, clamp) };
    bake_levels(to, from, graded_texel, &w, mem);
}

/* -- distortion: red along s, green along t; 128 is 0, 0 full negative strength ------ */

/* Returns an offset in 1/1024 m.  2^7 x 20 m is below 2^28. */
static uint32_t channel_offset(const bake_work *w, uint32_t channel)
{
    int32_t m = ((int32_t)channel - 128) * w->gain;
    return (uint32_t)((m + (1 << 12)) >> 13);
}

static uint32_t offset_texel(const bake_work *w, uint32_t texel)
{
    return channel_offset(w, texel >> 16 & 0xff) << 16
           | (channel_offset(w, texel >> 8 & 0xff) & 0xffff);
}

void tp_quick_offsets(tp_texture *to, const tp_texture *from, tp_fx strength, void *mem)
{
    const bake_work w = { .gain = strength };
    bake_levels(to, from, offset_texel, &w, mem);
}

/* -- ripples: slopes -nx / nz along s and ny / nz along t ---------------------------- */

/* Returns n / nz in Q3.12, rounded.  nz is at least 1/8; n is below 2^18. */
static uint32_t slope(int32_t n, int32_t nz)
{
    int32_t twice = 32 * n + (n < 0 ? -nz : nz);
    return (uint32_t)tp_clamp(twice / (2 * nz), -32000, 32000);
}

static uint32_t slope_texel(const bake_work *w, uint32_t texel)
{
    int32_t nx = (int32_t)(texel >> 16 & 0xff) - 128,
            ny = (int32_t)(texel >> 8 & 0xff) - 128;
    int32_t nz = (int32_t)(texel & 0xff) - 128;

    nz = nz < 16 ? 16 : nz;
    return slope(-nx * w->gain, nz) << 16 | (slope(ny * w->gain, nz) & 0xffff);
}

void tp_quick_slopes(tp_texture *to, const tp_texture *from, tp_fx bump, void *mem)
{
    const bake_work w = { .gain = bump >> 8 };
    bake_levels(to, from, slope_texel, &w, mem);
}

/* -- light --------------------------------------------------------------------------- */

#define RIPPLED_VIEW (1638 << 12)       /* same value as in lighting_stage.c */

/* Slope variances of the levels of roughness, Q24: none, then four times the one before.
 * A level's root reaches half way to the roots of its neighbours. */
static const uint32_t variance_of_level[TP_QUICK_LEVELS] = { 0, 1 << 15, 1 << 17, 1 << 19 };
static const uint32_t variance_from[TP_QUICK_LEVELS] = { 0, 1 << 13, 73728, 294912 };

/* Returns N.V as water of a level shows it, both in 256ths. */
static int32_t rough_cosine(int32_t n, uint32_t level, const tp_rough_view *view)
{
    return level ? (tp_rough_view_cosine(n << 6, view) + 32) >> 6 : n;
}

/* Fills the table of shares.  In the middle of entry i, n is the lower bound plus
 * (i + 1/2) / 256. */
static void fill_fresnel_by_view_cosine(struct tp_quick_light *quick, const tp_shade *shade,
                                        uint32_t level)
{
    const tp_rough_view view = tp_rough_view_make(0, variance_of_level[level]);

    for (int32_t i = 0; i < TP_QUICK_SHARES; i++) {
        int32_t  n = (quick->least + ((i + 1) << 18)) >> 18;
        uint32_t share = shade->fresnel[rough_cosine(n < 256 ? n : 256, level, &view)];
        uint32_t mirrors = share * (uint32_t)shade->mirror >> 8;
        quick->rough[level].share[i] = (256 - mirrors) << 16 | (mirrors + 1);
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

/* A lobe widened by a factor: 1 over the factor, and its peak; Q14. */
typedef struct {
    int32_t narrow, peak;
} wide_lobe;

static wide_lobe wide_lobe_make(const tp_shade *shade, uint32_t level)
{
    if (level == 0)
        return (wide_lobe){ 16384, 16384 };
    const int32_t narrow = tp_rough_narrowing(shade->lobe.exponent,
                                              variance_of_level[level]);
    return (wide_lobe){ narrow, tp_rough_peak(&shade->lobe, narrow) };
}

/* Returns the specular lobe at a cosine, 0..256. */
static uint32_t wide_lobe_shine(const tp_shade *shade, wide_lobe lobe, int32_t c)
{
    const int32_t  wide = 16384 - ((16384 - c) * lobe.narrow >> 14);
    const uint32_t up = (uint32_t)tp_clamp(wide, 0, 16384);
    const uint32_t here = shade->shine[up >> 4], next = shade->shine[(up + 15) >> 4];
    const uint32_t shine = here + (((next - here) * (up & 15)) >> 4);
    const uint32_t share = shine * (uint32_t)lobe.peak >> 14;

    return share < 256 ? share : 256;
}

/* Returns the colour of the specular lobe, if `specular`, plus the glow of a dome times
 * `glow_share`, 0..256.  c: cosine of the angle from the lobe's axis, R.V or 2 (N.H)^2 - 1,
 * Q14. */
static uint32_t lobe_colour(const tp_shade *shade, int32_t c, bool specular,
                            uint32_t glow_share, wide_lobe wide)
{
    const uint32_t light = specular ? tp_colour_scale(shade->light_colour,
                                                      wide_lobe_shine(shade, wide, c))
                                    : 0;

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
                      bool specular, uint32_t level)
{
    uint32_t glow_share = tp_quick_share_at_sun(shade);
    const wide_lobe wide = wide_lobe_make(shade, level);

    for (int32_t i = 0; i < TP_QUICK_LOBE; i++) {
        int32_t w = 8 * i + 4;
        int32_t c = lobe == TP_LOBE_BLINN ? (16384 - w) * 16384 / (16384 + w)
                                          : 16384 - w;
        quick->rough[level].lobe[i] =
            lobe_colour(shade, c, specular, glow_share, wide);
    }
}

/* Returns the sky as mirrored at a height.  A reflected view downwards meets other water,
 * with a share of the horizon's brightness by the rule of lighting_stage.c. */
static uint32_t darken_sky_below_horizon(uint32_t sky, int32_t up)
{
    return tp_colour_scale(sky, (uint32_t)tp_clamp(256 + 4 * up, 128, 256));
}

/* Fills the columns of heights, for all levels of roughness: the mirrored ray is that of
 * the slope, not the mean [V3], since a dome's columns for each level would take 12 KB
 * more, and a height bent by the level an instruction more a pixel.  Entry i is in the
 * middle of a 32nd; `up` is in 256ths.  A gradient has one column; a dome has 16 columns,
 * mixed from its two sides. */
static void fill_sky_colours_by_height(struct tp_quick_light *quick, const tp_shade *shade)
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
            quick->sky[k * TP_QUICK_HEIGHTS + (uint32_t)i] =
                darken_sky_below_horizon(sky, up);
        }
    }
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

/* Fills the map of a cube.  A cell holds the light from the direction opposite to its
 * place. */
static void make_cube_sky_map(struct tp_quick_light *quick, const tp_shade *shade)
{
    for (int32_t i = 0; i < TP_QUICK_SIDE * TP_QUICK_SIDE; i++) {
        int32_t u = (i % TP_QUICK_SIDE - 16) * 1024 + 512;
        int32_t v = (i / TP_QUICK_SIDE - 16) * 1024 + 512;
        int32_t far = tp_clamp(root_q14(u * u + v * v), 1, 32767),
                y = sky_map_radius_to_direction_y(far);
        int32_t level_part = root_q14((1 << 28) - y * y);
        int32_t x = -u * level_part / far, z = -v * level_part / far;
        const tp_texture *face = shade->env.cube->face[tp_cube_face(x, y, z).face];
        quick->sky[i] = tp_env_cube(shade, choose_level(face), x, y, z) & 0xffffff;
    }
}

void tp_quick_light_init(struct tp_quick_light *quick, const tp_shade *shade,
                         tp_lobe lobe, bool specular, bool rippled)
{
    TP_ASSERT((unsigned)lobe <= TP_LOBE_BLINN && shade->fresnel != NULL);
    quick->least = rippled ? RIPPLED_VIEW : 0;
    for (uint32_t level = 0; level < quick->levels; level++) {
        fill_fresnel_by_view_cosine(quick, shade, level);
        make_lobe(quick, shade, lobe, specular, level);
    }
    if (shade->env.kind == TP_ENV_CUBE)
        make_cube_sky_map(quick, shade);
    else
        fill_sky_colours_by_height(quick, shade);
}

/* -- the choice of a level ------------------------------------------------------------ */

/* Returns the variance at a depth, the mean of both axes. */
static uint32_t mean_variance(const tp_shade *shade, int32_t log_depth)
{
    const tp_slope_variance v = tp_rough_variance(shade, log_depth);
    return (v.along + v.across) / 2;
}

uint32_t tp_quick_level_choose(const tp_shade *shade, int32_t vy)
{
    const int64_t above = shade->eye.y > 1 << 12 ? shade->eye.y : 1 << 12;
    const int32_t log_depth = tp_log2_q8((uint32_t)above)
                            - tp_log2_q8((uint32_t)(vy > 1 ? vy : 1)) + 10 * 256;
    const uint32_t variance = mean_variance(shade, log_depth);
    uint32_t level = 0;

    while (level + 1 < shade->quick->levels && variance >= variance_from[level + 1])
        level++;
    return level;
}
