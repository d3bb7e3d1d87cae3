/* SPDX-License-Identifier: MIT */
/* Materials and textures of a mesh: the direction in which a normal map tilts the normal,
 * the cases without tilt, and the choice of tangent, material and mipmap level for a
 * sample. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/boat/boat.h"
#include "mesh/mesh.h"
#include "tests/lib/shading.h"

#define NEAR TP_FX(0.25)
#define FLAT 0xff8080ffu        /* texel of a normal map that points straight out */

static uint64_t chance;

typedef struct {
    tp_shade shade;
    tp_boat_shading look;
    tp_mesh  mesh;
    tp_mesh_face face[4];
    tp_solid solid[4];
    tp_texture picture[2];
    uint32_t texel[2][64];
    uint8_t  gloss[TP_GLOSS];
    test_run samples;
} model;

static model m;

/* Packs a direction; 1.0 and 0 are exact, any other value is rounded to the format, 511 is
 * 1. */
static tp_packed_dir packed(double x, double y, double z)
{
    const double n = sqrt(x * x + y * y + z * z) / 1073741823.0;
    return tp_dir_pack((tp_dir3){ (tp_q30)(x / n), (tp_q30)(y / n), (tp_q30)(z / n) });
}

static void light_from(double x, double y, double z)
{
    const double n = sqrt(x * x + y * y + z * z) / 16384;
    m.look.axes.lx = (int32_t)lround(x / n);
    m.look.axes.ly = (int32_t)lround(y / n);
    m.look.axes.lz = (int32_t)lround(z / n);
}

/* A texture of one texel. */
static const tp_texture *dot_of(int which, uint32_t texel)
{
    assert_int_equal(tp_texture_init(&m.picture[which], &texel, 1, 1, m.texel[which],
                                     tp_texture_bytes(1, 1), NULL),
                     TP_OK);
    return &m.picture[which];
}

static uint32_t key_at(double depth)
{
    return (uint32_t)(NEAR / 65536.0 / depth * 2147483648.0) << 1 >> 8 << 8 | 2;
}

/* White samples facing +z at a depth of 1 m, lit from +z only, seen by a camera looking
 * along -z; tangents along +x, hence the top of the texture is +y. */
static void model_begin(void)
{
    memset(&m, 0, sizeof m);
    run_any(&m.samples, 0, &chance);
    m.shade = (tp_shade){
        .u0 = 320 * 16, .v0 = 240 * 16, .focal = 416 * 16,
        .zi_log = tp_log2_q8(NEAR) + 15 * 256,
        .light_colour = 0xffffff,
    };
    m.look = (tp_boat_shading){
        .mesh = &m.mesh, .solid = m.solid,
        .axes = { .right = { TP_Q30_ONE, 0, 0 }, .up = { 0, TP_Q30_ONE, 0 },
                  .back = { 0, 0, TP_Q30_ONE } },
    };
    m.mesh.faces = m.face;
    light_from(0, 0, 1);
    tp_shade_gloss(m.gloss, TP_FX_ONE);
    for (int i = 0; i < 4; i++) {
        m.face[i].tangent = packed(1, 0, 0);
        m.solid[i] = (tp_solid){ .diffuse = 0xffffff, .bump = 256, .gloss = m.gloss };
    }
    for (int i = 0; i < TP_RUN; i++) {
        m.samples.key[i] = key_at(1.01);
        m.samples.t[i] = 0;
        m.samples.n[i] = packed(0, 0, 1);
    }
}

static void model_draw(void)
{
    m.samples.run.mine = &m.look;
    tp_stage_solid(&m.shade, &m.samples.run);
}

/* -- direction of the tilt ------------------------------------------------------------- */

/* A texel tilted by half along red, green or straight out (64 of 128), and a light. */
static const struct {
    uint32_t texel, mirrored;
    double   light[3], cosine;
} leanings[] = {
    { 0xc080c0, 0, {  1,  0, 0 }, 0.7071 },     /* red: along the tangent */
    { 0xc080c0, 0, { -1,  0, 0 }, 0 },
    { 0x4080c0, 0, { -1,  0, 0 }, 0.7071 },
    { 0x80c0c0, 0, {  0,  1, 0 }, 0.7071 },     /* green: to the top of the texture */
    { 0x80c0c0, 0, {  0, -1, 0 }, 0 },
    { 0x8040c0, 0, {  0, -1, 0 }, 0.7071 },
    { 0x80c0c0, 1, {  0, -1, 0 }, 0.7071 },     /* mirrored: the top is -y */
    { 0xc080c0, 1, {  1,  0, 0 }, 0.7071 },
    { 0xc0c0c0, 0, {  1,  1, 1 }, 1 },
    { 0xc080c0, 0, {  0,  0, 1 }, 0.7071 },
    { 0x8080ff, 0, {  0,  0, 1 }, 1 },
};
enum { LEANINGS = sizeof leanings / sizeof leanings[0] };

/* Rounding of the formats is at most 1/511; the share is truncated to 1/256, the product is
 * rounded. */
static void red_leans_along_the_tangent_and_green_to_the_top(void **state)
{
    (void)state;

    for (int k = 0; k < LEANINGS; k++) {
        model_begin();
        m.solid[0].normal_map = dot_of(0, leanings[k].texel);
        if (leanings[k].mirrored)
            m.face[0].tangent |= TP_TANGENT_MIRRORED;
        light_from(leanings[k].light[0], leanings[k].light[1], leanings[k].light[2]);
        model_draw();
        const double want = 255 * leanings[k].cosine;
        for (int i = 0; i < TP_RUN; i++)
            assert_true(fabs((m.samples.run.colour[i] & 0xff) - want) <= 2.5);
    }
}

/* Twice the bump gives twice the slope; a bump of 0 gives a slope of 0. */
static void bump_is_the_slope_s_factor(void **state)
{
    (void)state;

    for (int bump = 0; bump <= 2048; bump += 64) {
        model_begin();
        m.solid[0].normal_map = dot_of(0, 0xa080c0);    /* a slope of 32 / 64 */
        m.solid[0].bump = bump;
        light_from(1, 0, 0);
        model_draw();
        const double slope = 0.5 * bump / 256;
        const double want = 255 * slope / sqrt(1 + slope * slope);
        assert_true(fabs((m.samples.run.colour[0] & 0xff) - want) <= 2.5);
    }
}

/* -- maps without effect --------------------------------------------------------------- */

/* Draws random normals under a random light without a map and with this map.  The
 * difference is at most one 256th in the diffuse share and one in the lobe, a level
 * each. */
static void assert_unbent(uint32_t texel, int32_t bump)
{
    uint32_t plain[TP_RUN];

    model_begin();
    light_from(chance_double(&chance, -1, 1), chance_double(&chance, -1, 1),
               chance_double(&chance, 0.1, 1));
    m.solid[0].diffuse = m.solid[0].specular = 0x808080;
    m.shade.ambient = 64;
    for (int i = 0; i < TP_RUN; i++)
        m.samples.n[i] = packed(chance_double(&chance, -1, 1),
                                chance_double(&chance, -1, 1), 1.5);
    model_draw();
    memcpy(plain, m.samples.run.colour, sizeof plain);
    m.solid[0].normal_map = dot_of(0, texel);
    m.solid[0].bump = bump;
    model_draw();
    for (int i = 0; i < TP_RUN; i++) {
        const int32_t now = (int32_t)(m.samples.run.colour[i] & 0xff);
        const int32_t was = (int32_t)(plain[i] & 0xff);
        if (was > 33)           /* a darker light may be about to set, with its lobe */
            assert_true(abs(now - was) <= 2);
    }
}

static void a_flat_map_changes_nothing(void **state)
{
    (void)state;

    for (int n = 0; n < 500; n++)
        assert_unbent(FLAT, chance_int(&chance, 0, 2048));
}

static void without_bump_a_map_changes_nothing(void **state)
{
    (void)state;

    for (int n = 0; n < 500; n++)
        assert_unbent((uint32_t)random_next(&chance), 0);
}

/* Blue below the middle would turn surfaces inside out; the stage clamps blue. */
static void a_map_that_points_inwards_does_not_turn_the_surface(void **state)
{
    (void)state;

    for (int n = 0; n < 500; n++)
        assert_unbent(0x808000u | random_below(&chance, 128), 256);
}

/* -- tangent and material -------------------------------------------------------------- */

/* Samples carry the number of their face, the span that of its material. */
static void each_face_brings_its_own_tangent(void **state)
{
    (void)state;
    static const double along[4][2] = { { 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } };

    model_begin();
    light_from(1, 0, 0);
    m.solid[0].normal_map = dot_of(0, 0xc080c0);
    for (int i = 0; i < 4; i++)
        m.face[i].tangent = packed(along[i][0], along[i][1], 0);
    for (int i = 0; i < TP_RUN; i++)
        m.samples.t[i] = (uint32_t)i % 4;
    model_draw();
    for (int i = 0; i < TP_RUN; i++)
        assert_true(fabs((m.samples.run.colour[i] & 0xff)
                         - 180.3 * fmax(0, along[i % 4][0])) <= 2.5);
}

static void a_run_has_the_colours_of_its_material(void **state)
{
    (void)state;
    static const uint32_t kd[4] = { 0x102030, 0xff0080, 0, 0xffffff };

    for (uint32_t k = 0; k < 4; k++) {
        model_begin();
        m.shade.ambient = 256;
        for (int i = 0; i < 4; i++)
            m.solid[i].diffuse = kd[i];
        m.samples.run.material = k;
        model_draw();
        assert_int_equal(m.samples.run.colour[5], kd[k]);
    }
}

/* Kd times the texel; full ambient light shows the product unchanged. */
static void kd_tints_the_picture(void **state)
{
    (void)state;

    for (int n = 0; n < 1000; n++) {
        const uint32_t texel = (uint32_t)random_next(&chance);
        const uint32_t kd = (uint32_t)random_next(&chance) & 0xffffff;
        model_begin();
        m.shade.ambient = 256;
        m.solid[0].diffuse = kd;
        m.solid[0].diffuse_map = dot_of(0, texel);
        model_draw();
        assert_int_equal(m.samples.run.colour[0], tp_colour_times(texel, kd));
        m.solid[0].diffuse = 0xffffff;
        model_draw();
        assert_int_equal(m.samples.run.colour[0], texel & 0xffffff);
    }
}

/* The lobe peaks where sun and eye are on the normal: Ks times the sun's colour is added,
 * or slightly less.  Rounding of normal and view costs a level of Kd and perhaps one entry
 * of the lobe: the last entry but one is 0.96 at this exponent. */
static void the_lobe_peaks_where_sun_and_eye_meet(void **state)
{
    (void)state;

    model_begin();
    tp_shade_gloss(m.gloss, 10 * TP_FX_ONE);
    m.shade.u0 = 16 * m.samples.run.x + 8;          /* the first pixel is in the middle */
    m.shade.v0 = 16 * m.samples.run.y + 8;
    m.shade.light_colour = 0x80ff40;
    m.solid[0].diffuse = 0x100010;
    m.solid[0].specular = 0xff8000;
    model_draw();
    assert_in_range(m.samples.run.colour[0] >> 16, 0x0f + 0x7a, 0x10 + 0x80);
    assert_in_range(m.samples.run.colour[0] >> 8 & 0xff, 0x7a, 0x80);
    assert_in_range(m.samples.run.colour[0] & 0xff, 0x0f, 0x10);
    for (int i = 1; i < TP_RUN; i++)
        assert_true(m.samples.run.colour[i] >> 16 <= m.samples.run.colour[i - 1] >> 16);
    light_from(0, 0, -1);                           /* from behind: black, without a lobe */
    model_draw();
    assert_int_equal(m.samples.run.colour[0], 0);
}

/* -- mipmap levels --------------------------------------------------------------------- */

/* A texture of 4 x 4 texels and its mipmap levels: level k is `texel[k]` everywhere. */
static const tp_texture *levels_of(int which, const uint32_t texel[4])
{
    tp_texture *t = &m.picture[which];
    uint32_t *at = m.texel[which];

    *t = (tp_texture){ .log2_w = 2, .log2_h = 2, .levels = 3 };
    for (int k = 0, side = 4; k < 3; k++, side /= 2) {
        t->level[k] = at;
        for (int i = 0; i < side * side; i++)
            *at++ = texel[k];
    }
    return t;
}

/* For surfaces that face the eye, texels per pixel are proportional to the depth: one level
 * for each doubling.  Water takes one and a half. */
static void levels_double_with_the_depth(void **state)
{
    (void)state;
    const uint32_t grey[4] = { 10, 20, 30 };
    const uint32_t lean[4] = { FLAT, 0xc080c0, FLAT };

    model_begin();
    m.shade.ambient = 256;
    m.solid[0].diffuse_map = levels_of(0, grey);
    for (int i = 0; i < TP_RUN; i++)
        m.samples.key[i] = key_at(1.4 * (1 << i % 6));
    for (int lod = -2; lod <= 2; lod++) {
        m.solid[0].lod = lod * 256;
        model_draw();
        for (int i = 0; i < TP_RUN; i++)
            assert_int_equal(m.samples.run.colour[i],
                             10 * tp_clamp(lod + i % 6, 0, 2) + 10);
    }
    m.solid[0].diffuse_map = NULL;
    m.solid[0].normal_map = levels_of(1, lean);
    m.solid[0].lod = -256;
    m.shade.ambient = 0;
    model_draw();
    for (int i = 0; i < TP_RUN; i++)
        assert_true(((m.samples.run.colour[i] & 0xff) < 200) == (i % 6 == 2));
}

/* Each sample selects its level without its neighbours: spans of solids with maps too may
 * be cut anywhere. */
static void mapped_runs_may_be_cut_anywhere(void **state)
{
    (void)state;

    for (int n = 0; n < 500; n++) {
        uint32_t pixels[16];
        model_begin();
        for (int which = 0; which < 2; which++) {
            for (int i = 0; i < 16; i++)
                pixels[i] = (uint32_t)random_next(&chance);
            assert_int_equal(tp_texture_init(&m.picture[which], pixels, 4, 4,
                                             m.texel[which], tp_texture_bytes(4, 4),
                                             NULL),
                             TP_OK);
        }
        m.solid[0].diffuse_map = &m.picture[0];
        m.solid[0].normal_map = &m.picture[1];
        m.solid[0].specular = 0xffffff;
        for (int i = 0; i < TP_RUN; i++) {
            m.samples.key[i] = key_at(chance_double(&chance, 0.3, 8));
            m.samples.t[i] = random_below(&chance, 4);
        }
        const tp_run before = m.samples.run;
        model_draw();
        const int32_t from = chance_int(&chance, 0, TP_RUN - 1);
        const int32_t end = chance_int(&chance, from + 1, TP_RUN);
        tp_run part = run_part(&before, from, end);
        part.mine = &m.look;
        tp_stage_solid(&m.shade, &part);
        assert_memory_equal(part.colour, m.samples.run.colour + from,
                            (size_t)(end - from) * sizeof *part.colour);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(red_leans_along_the_tangent_and_green_to_the_top),
        cmocka_unit_test(bump_is_the_slope_s_factor),
        cmocka_unit_test(a_flat_map_changes_nothing),
        cmocka_unit_test(without_bump_a_map_changes_nothing),
        cmocka_unit_test(a_map_that_points_inwards_does_not_turn_the_surface),
        cmocka_unit_test(each_face_brings_its_own_tangent),
        cmocka_unit_test(a_run_has_the_colours_of_its_material),
        cmocka_unit_test(kd_tints_the_picture),
        cmocka_unit_test(the_lobe_peaks_where_sun_and_eye_meet),
        cmocka_unit_test(levels_double_with_the_depth),
        cmocka_unit_test(mapped_runs_may_be_cut_anywhere),
    };
    return cmocka_run_group_tests_name("features/boat stage", tests, NULL, NULL);
}
