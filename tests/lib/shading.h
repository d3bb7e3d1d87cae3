/* SPDX-License-Identifier: MIT */
/* Random spans, cameras, lights, colours and skies for the shading stages, the values that
 * the reference needs from them, and differences of colours. */
#ifndef TP_TESTS_LIB_SHADING_H
#define TP_TESTS_LIB_SHADING_H
#include "features/water/fast_shading.h"
#include "shade/rough_lobe.h"
#include "shade/shade.h"
#include "shade/env.h"
#include "tests/lib/measure.h"
#include "tests/lib/random.h"
#include "tools/reference/env.h"
#include "tools/reference/shading.h"

/* -- differences in levels of 255 ---------------------------------------------------- */

typedef struct {
    const char *what;
    uint64_t    count;
    double      largest, squares;
} colour_error;

static inline void colour_error_add_colour(colour_error *l, ref_colour got,
                                           ref_colour want)
{
    for (int k = 0; k < 3; k++) {
        const double off = fabs(got.c[k] - want.c[k]);
        l->count++;
        l->squares += off * off;
        l->largest = fmax(l->largest, off);
    }
}

static inline void colour_error_add(colour_error *l, uint32_t got, ref_colour want)
{
    colour_error_add_colour(l, ref_colour_unpack(got), want);
}

static inline double colour_error_rms(const colour_error *l)
{
    return sqrt(l->squares / (double)l->count);
}

static inline void colour_error_print(const colour_error *l)
{
    printf("    %-18s %10" PRIu64 " channels, largest %-6.2f rms %.3f levels\n", l->what,
           l->count, l->largest, colour_error_rms(l));
}

/* -- spans of random samples --------------------------------------------------------- */

typedef struct {
    tp_run   run;
    uint32_t key[TP_RUN], s[TP_RUN], t[TP_RUN], n[TP_RUN];
} test_run;

/* A full span of random colours and samples; slopes within +-`steep`, 4096 is 1. */
static inline void run_any(test_run *r, int32_t steep, uint64_t *state)
{
    memset(r, 0xa5, sizeof *r);
    r->run.x = TP_RUN * chance_int(state, 0, 9);
    r->run.y = chance_int(state, 0, 479);
    r->run.count = TP_RUN;
    r->run.material = 0;
    r->run.key = r->key;
    r->run.s = r->s;
    r->run.t = r->t;
    r->run.ls = r->s;
    r->run.lt = r->t;
    r->run.n = r->n;
    for (int i = 0; i < TP_RUN; i++) {
        const uint32_t sx = (uint32_t)chance_int(state, -steep, steep) & 0xffff;
        r->key[i] = (uint32_t)random_next(state) | 0x100;
        r->s[i] = (uint32_t)random_next(state);
        r->t[i] = (uint32_t)random_next(state);
        r->n[i] = sx << 16 | ((uint32_t)chance_int(state, -steep, steep) & 0xffff);
        r->run.colour[i] = (uint32_t)random_next(state) & 0xffffff;
    }
}

/* The part [from, end) of a span as a span of its own, with the data that stages hand
 * on. */
static inline tp_run run_part(const tp_run *r, int32_t from, int32_t end)
{
    tp_run part = *r;
    const size_t count = (size_t)(end - from);

    part.x = r->x + from;
    part.count = end - from;
    part.key = r->key + from;
    part.s = r->s + from;
    part.t = r->t + from;
    part.ls = part.s;
    part.lt = part.t;
    part.n = r->n + from;
    memmove(part.colour, r->colour + from, count * sizeof *part.colour);
    memmove(part.vx, r->vx + from, count * sizeof *part.vx);
    memmove(part.vy, r->vy + from, count * sizeof *part.vy);
    memmove(part.vz, r->vz + from, count * sizeof *part.vz);
    memmove(part.lv, r->lv + from, count * sizeof *part.lv);
    memmove(part.sx, r->sx + from, count * sizeof *part.sx);
    memmove(part.sz, r->sz + from, count * sizeof *part.sz);
    memmove(part.nv, r->nv + from, count * sizeof *part.nv);
    memmove(part.up, r->up + from, count * sizeof *part.up);
    memmove(part.glint, r->glint + from, count * sizeof *part.glint);
    memmove(part.rx, r->rx + from, count * sizeof *part.rx);
    memmove(part.rz, r->rz + from, count * sizeof *part.rz);
    memmove(part.mirror, r->mirror + from, count * sizeof *part.mirror);
    return part;
}

/* -- cameras, lights and colours ----------------------------------------------------- */

#define Q14 16384.0
#define Q12 4096.0

typedef void stage(const tp_shade *shade, tp_run *run);

/* Focal lengths of 200 to 1000 pixels, as for 640 x 480 pixels at 60 degrees. */
/* Table shared by all shades: tests use one shade at a time. */
static tp_entry16 shade_shine[TP_SHINE + 1];
static uint32_t shade_gradient[TP_SKY + 1];

static inline tp_shade shade_any(uint64_t *state)
{
    const tp_rotation turn =
        tp_rotation_from_angles((tp_turn)random_next(state),
                                (tp_turn)chance_int(state, -400000000, 400000000), 0);
    const tp_dir3 light = tp_normalise(chance_int(state, -1000, 1000),
                                       chance_int(state, 20, 1000),
                                       chance_int(state, -1000, 1000));
    tp_shade s = {
        .u0 = 320 * 16, .v0 = 240 * 16,
        .focal = chance_int(state, 200, 1000) * 16,
        .world = { turn.x, turn.y, turn.z, light.x >> 16, light.y >> 16, light.z >> 16 },
        .zi_log = 15 * 256 + 14 * 256,
        .water_colour = (uint32_t)random_next(state) & 0xffffff,
        .light_colour = (uint32_t)random_next(state) & 0xffffff,
        .ambient = chance_int(state, 0, 256),
        .mirror = chance_int(state, 0, 256),
        .shine = shade_shine,
    };
    s.fresnel = tp_fresnel_table;
    s.sky = shade_gradient;
    tp_shade_sky(shade_gradient, (uint32_t)random_next(state) & 0xffffff,
                 (uint32_t)random_next(state) & 0xffffff);
    return s;
}

static inline tp_solid solid_any(const uint8_t gloss[TP_GLOSS], uint64_t *state)
{
    return (tp_solid){ .diffuse = (uint32_t)random_next(state) & 0xffffff,
                       .specular = (uint32_t)random_next(state) & 0xffffff,
                       .bump = 256, .gloss = gloss };
}

static inline ref_dir shade_dir(tp_dir3 d)
{
    return (ref_dir){ d.x / 1073741824.0, d.y / 1073741824.0, d.z / 1073741824.0 };
}

static inline ref_dir shade_light(const tp_view_axes *a)
{
    return (ref_dir){ a->lx / Q14, a->ly / Q14, a->lz / Q14 };
}

/* Direction from the pixel's centre to the eye. */
static inline ref_dir shade_view(const tp_shade *s, const tp_view_axes *axes, int32_t x,
                                 int32_t y)
{
    const ref_dir right = shade_dir(axes->right), up = shade_dir(axes->up),
                  back = shade_dir(axes->back);
    const double u = 16 * x + 8 - s->u0, v = s->v0 - 16 * y - 8, f = s->focal;

    return ref_unit((ref_dir){ f * back.x - u * right.x - v * up.x,
                               f * back.y - u * right.y - v * up.y,
                               f * back.z - u * right.z - v * up.z });
}

static inline double run_sx(const test_run *r, int i)
{
    return (int16_t)(r->n[i] >> 16) / Q12;
}

static inline double run_sz(const test_run *r, int i)
{
    return (int16_t)(r->n[i] & 0xffff) / Q12;
}

/* -- skies --------------------------------------------------------------------------- */

#define SKY_SIDE 64             /* side of a cube face, px */

typedef struct {
    tp_dome        dome;
    tp_dome_config config;
    tp_cube        cube;
    tp_texture     face[6];
    uint32_t       texel[6][2 * SKY_SIDE * SKY_SIDE];
    uint32_t       recip[TP_RECIP + 2];
} test_sky;

static inline void sky_dome(test_sky *sky, tp_shade *shade, uint64_t *state)
{
    sky->config = (tp_dome_config){
        .kind = chance_int(state, 0, 2),
        .horizon = (uint32_t)random_next(state) & 0xffffff,
        .zenith = (uint32_t)random_next(state) & 0xffffff,
        .light = (uint32_t)random_next(state) & 0xffffff,
        .sun = chance_fx(state, 0, 16),
    };
    tp_dome_init(&sky->dome, &sky->config);
    tp_recip_init(sky->recip);
    shade->env = (tp_env){ .kind = TP_ENV_DOME, .dome = &sky->dome, .recip = sky->recip,
                           .beyond = (uint32_t)chance_int(state, 0, 16 * 256) };
}

/* Makes a cube sky of faces painted by `paint`; only mipmap level 0 matters. */
static inline void sky_cube(test_sky *sky, tp_shade *shade,
                            uint32_t (*paint)(ref_dir d, void *with), void *with)
{
    const tp_texture *face[6];
    static uint32_t pixels[SKY_SIDE * SKY_SIDE];

    for (int f = 0; f < 6; f++) {
        for (int i = 0; i < SKY_SIDE * SKY_SIDE; i++)
            pixels[i] = paint(ref_cube_direction(f, (i % SKY_SIDE + 0.5) / SKY_SIDE,
                                          ((double)(i / SKY_SIDE) + 0.5) / SKY_SIDE), with);
        if (tp_texture_init(&sky->face[f], pixels, SKY_SIDE, SKY_SIDE, sky->texel[f],
                            tp_texture_bytes(SKY_SIDE, SKY_SIDE), NULL))
            abort();
        face[f] = &sky->face[f];
    }
    tp_cube_init(&sky->cube, face);
    tp_recip_init(sky->recip);
    shade->env = (tp_env){ .kind = TP_ENV_CUBE, .cube = &sky->cube, .recip = sky->recip };
}

static inline uint32_t sky_noise(ref_dir d, void *state)
{
    (void)d;
    return (uint32_t)random_next(state);
}

static inline ref_dir sky_direction(uint64_t *state)
{
    ref_dir d;
    do
        d = (ref_dir){ chance_double(state, -1, 1), chance_double(state, -1, 1),
                       chance_double(state, -1, 1) };
    while (ref_dir_dot(d, d) > 1 || ref_dir_dot(d, d) < 0.01);
    return ref_unit(d);
}

static inline int32_t sky_q14(double x)
{
    return (int32_t)lround(x * Q14);
}

/* -- fast shading -------------------------------------------------------------------- */

typedef struct {
    test_sky sky;
    struct tp_quick_light quick;
    tp_quick_tables tables;
    tp_quick_rough rough[TP_QUICK_LEVELS];
    uint32_t sky_words[16 * TP_QUICK_HEIGHTS
                       + (TP_QUICK_LEVELS - 1) * TP_QUICK_ROUGH_COLUMNS
                             * TP_QUICK_ROUGH_HEIGHTS];
    tp_filtered_waves filtered;
    uint32_t beyond;            /* of tp_env, for a cube */
} quick_lights;

/* A sky colour that varies slowly with the direction; in the south beyond white. */
static inline uint32_t quick_smooth(ref_dir d, void *with)
{
    (void)with;
    return (uint32_t)(d.z > 0.5 ? 300 * (d.z - 0.5) : 0) << 24
         | (uint32_t)(128 + 100 * d.x) << 16 | (uint32_t)(128 + 100 * d.y) << 8
         | (uint32_t)(128 + 100 * d.z);
}

/* A random shade for the sky and the lobe, with levels of roughness; valid as long as
 * `kept` is. */
static inline tp_shade quick_rough_shade(quick_lights *kept, int env, int lobe,
                                         uint32_t levels, uint64_t *state)
{
    tp_shade s = shade_any(state);

    if (env == TP_ENV_DOME)
        sky_dome(&kept->sky, &s, state);
    if (env == TP_ENV_CUBE)
        sky_cube(&kept->sky, &s, quick_smooth, NULL);
    s.env.beyond = env == TP_ENV_CUBE ? kept->beyond : 0;
    s.per_focal = (uint32_t)(((uint64_t)1 << 32) / (uint32_t)s.focal);
    s.env.least = lobe == TP_LOBE_NONE ? 0 : TP_DISC_END;
    const tp_fx shininess = chance_int(state, 10, 200) * TP_FX_ONE;
    if (lobe == TP_LOBE_BLINN)
        tp_shade_shine_blinn(shade_shine, shininess, TP_FX_ONE);
    else
        tp_shade_shine(shade_shine, shininess, TP_FX_ONE);
    s.quick = &kept->quick;
    kept->quick.rough = kept->rough;
    kept->quick.sky = kept->sky_words;
    kept->quick.levels = levels;
    kept->quick.lit = false;
    tp_filtered_waves_clear(&kept->filtered);
    for (tp_fx depth = TP_FX_ONE; levels > 1 && depth < 4000 * TP_FX_ONE; depth *= 2)
        tp_filtered_waves_add_row(&kept->filtered, depth, (tp_slope_variance){
            (uint32_t)depth >> 9, (uint32_t)depth >> 10, 0 });
    tp_filtered_waves_finish(&kept->filtered);
    s.filtered = levels > 1 ? &kept->filtered : NULL;
    s.lobe = tp_lobe_form_make(shininess, TP_FX_ONE);
    kept->tables = (tp_quick_tables){ kept->rough, kept->sky_words, levels };
    tp_quick_light_init(&kept->tables, &s, (tp_lobe)lobe, lobe != TP_LOBE_NONE, true);
    if (s.env.kind == TP_ENV_CUBE)
        tp_quick_fill_cube_map(&kept->tables, &s);
    return s;
}

/* A shade of smooth water. */
static inline tp_shade quick_shade(quick_lights *kept, int env, int lobe, uint64_t *state)
{
    return quick_rough_shade(kept, env, lobe, 1, state);
}

/* Slopes as sampled.  If `steep` is large, every eighth slope has the steepest 16-bit
 * value. */
static inline void quick_run(test_run *r, uint32_t *slope, int32_t steep, uint64_t *state)
{
    run_any(r, steep, state);
    for (int i = 0; i < TP_RUN; i++)
        slope[i] = steep > 30000 && i % 8 == 0
                       ? 0x80008000u ^ (uint32_t)chance_int(state, 0, 3) * 0xffff
                       : r->n[i];
}

/* Asserts that both bodies of a stage compute the same colours for a span, with alpha 0. */
static inline void quick_assert_same(stage *plain, stage *packed, const tp_shade *shade,
                                     const tp_run *run)
{
    tp_run one = *run, other = *run;

    plain(shade, &one);
    packed(shade, &other);
    assert_memory_equal(one.colour, other.colour, (size_t)run->count * 4);
    for (int i = 0; i < run->count; i++)
        assert_int_equal(one.colour[i] >> 24, 0);
}

/* Asserts that a span has the same colours whole and in two parts. */
static inline void quick_assert_cut(stage *body, const tp_shade *shade, tp_run whole,
                                    tp_run left, tp_run right)
{
    body(shade, &whole);
    body(shade, &left);
    body(shade, &right);
    assert_memory_equal(whole.colour, left.colour, (size_t)left.count * 4);
    assert_memory_equal(whole.colour + left.count, right.colour, (size_t)right.count * 4);
}
#endif
