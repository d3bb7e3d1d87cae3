/* SPDX-License-Identifier: MIT */
/* Skies in whole frames: every tiling gives the same picture, no memory is laid out for
 * unused parts; a cube with a missing face, or a sky that the program lacks, falls back to
 * the gradient. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/sky/sky.h"
#include "frame/frame.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

enum { WIDTH = 150, HEIGHT = 90 };

static uint64_t chance;
static test_boat boat;
static uint32_t picture[2][WIDTH * HEIGHT];

static tp_assets assets_of(bool cube)
{
    tp_assets a = { .boat = &boat.mesh, .layer[0] = &boat.texture[0],
                    .ripple = random_below(&chance, 2) ? &boat.texture[1] : NULL };
    for (int i = 0; i < TP_FACES && cube; i++)
        a.sky[i] = &boat.texture[i % 2];
    return a;
}

static tp_scene sky_scene(int32_t kind)
{
    tp_scene s = scene_plain();

    s.sky.kind = kind;
    s.camera.pitch = chance_fx(&chance, -20, 30);
    s.boat.x = chance_fx(&chance, -4, 4);
    s.boat.z = chance_fx(&chance, -14, -2);
    s.light.heading = chance_fx(&chance, -30, 30);
    s.light.elevation = chance_fx(&chance, 1, 20);
    s.light.model = chance_int(&chance, 0, 1);
    s.water.fresnel = chance_int(&chance, 0, 1);
    s.water.specular = chance_int(&chance, 0, 1) * TP_FX_ONE;
    s.hdr.share = chance_int(&chance, 0, 1) * TP_FX_ONE;
    s.hdr.exposure = chance_int(&chance, 0, 1);
    s.hdr.exposure_factor = chance_fx(&chance, 0.5, 2);
    s.sky.stars = TP_FX_ONE;
    s.sky.haze = chance_int(&chance, 0, 1) * chance_fx(&chance, 20, 500);
    s.quality.sky = chance_int(&chance, TP_RUNG_AUTO, TP_RUNG_FAST);
    s.quality.haze = chance_int(&chance, TP_RUNG_AUTO, TP_RUNG_FAST);
    return s;
}

static void draw(const tp_scene *s, const tp_assets *assets, const tp_world *world,
                 uint32_t tile_width, uint32_t tile_height, uint32_t *to)
{
    const tp_config c = { .width = WIDTH,
                          .height = HEIGHT,
                          .tile_width = tile_width,
                          .tile_height = tile_height,
                          .format = TP_FORMAT_XRGB8888 };
    test_frame f = frame_of(s, assets, &c);

    frame_draw_picture(&f, world, to);
    frame_free(&f);
}

static void every_sky_is_the_same_in_every_tiling(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = { { 0, 1 }, { 16, 0 }, { 48, 7 }, { 144, 89 } };

    for (int n = 0; n < 20; n++) {
        const tp_scene s = sky_scene(n % 5);
        const tp_assets a = assets_of(n % 5 == TP_SKY_CUBE);
        tp_world *w = scene_world(&s, &a);
        for (int t = 0; t < 5; t++)
            tp_world_step(&tp_program_all, w, &s, NULL);
        w->lag = TP_FX_ONE / 3;
        draw(&s, &a, w, 0, 0, picture[0]);
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            draw(&s, &a, w, sizes[i][0], sizes[i][1], picture[1]);
            assert_memory_equal(picture[1], picture[0], sizeof picture[0]);
        }
        free(w);
    }
}

static void a_cube_with_a_hole_is_the_gradient(void **state)
{
    (void)state;
    tp_scene s = sky_scene(TP_SKY_CUBE);
    tp_assets a = assets_of(true);
    a.sky[random_below(&chance, TP_FACES)] = NULL;
    tp_world *w = scene_world(&s, &a);

    draw(&s, &a, w, 0, 0, picture[0]);
    s.sky.kind = TP_SKY_GRADIENT;
    draw(&s, &a, w, 0, 0, picture[1]);
    assert_memory_equal(picture[1], picture[0], sizeof picture[0]);
    free(w);
}

static void skies_are_carved_for_those_who_have_them(void **state)
{
    (void)state;
    const tp_config c = { .width = WIDTH,
                          .height = HEIGHT,
                          .tile_height = HEIGHT,
                          .format = TP_FORMAT_XRGB8888 };
    tp_scene s = scene_plain();
    const size_t plain = tp_frame_bytes(&c, &s);

    s.sky.kind = TP_SKY_CUBE;           /* without its textures */
    assert_int_equal(tp_frame_bytes(&c, &s), plain);
    s.sky.kind = TP_SKY_DAY;
    const size_t domed = plain + sizeof(tp_dome) + 6 * sizeof(int32_t) + sizeof(void *);
    assert_in_range(tp_frame_bytes(&c, &s), domed, domed + 16);
    s.quality.sky = TP_RUNG_FAST;
    assert_in_range(tp_frame_bytes(&c, &s), domed, domed + 16);
    s.sky.haze = 100 * TP_FX_ONE;
    const size_t exact = tp_frame_bytes(&c, &s);
    s.quality.haze = TP_RUNG_FAST;      /* the horizon's colours */
    assert_int_equal(tp_frame_bytes(&c, &s) - exact,
                     ((sizeof(tp_horizon) + 7) & ~(size_t)7) - sizeof(tp_haze));
    s.sky.kind = TP_SKY_GRADIENT;       /* one colour */
    assert_int_equal(tp_frame_bytes(&c, &s), plain);
    s.sky.haze = scene_plain().sky.haze;
    s.sky.kind = TP_SKY_GRADIENT;
    s.hdr.exposure_factor = 2 * TP_FX_ONE;
    const size_t toned = plain + 256 * sizeof(tp_entry8) + sizeof(tp_rgb565_tone_map)
                       + 2 * sizeof(int32_t) + 2 * sizeof(void *);
    assert_in_range(tp_frame_bytes(&c, &s), toned, toned + 16);
}

/* The scene's numbers may change while a frame lives: a sky without tables stays the
 * gradient; the light model and the reflection law are taken over. */
static void a_live_change_is_drawn_as_far_as_there_are_tables(void **state)
{
    (void)state;
    tp_scene s = sky_scene(TP_SKY_GRADIENT);
    const tp_assets a = assets_of(false);
    const tp_config c = { .width = WIDTH,
                          .height = HEIGHT,
                          .tile_height = HEIGHT,
                          .format = TP_FORMAT_XRGB8888 };
    s.hdr.exposure = TP_EXPOSURE_FIXED;
    s.hdr.exposure_factor = TP_FX_ONE;
    tp_world *w = scene_world(&s, &a);
    test_frame f = frame_of(&s, &a, &c);
    tp_tile tile;

    s.sky.kind = TP_SKY_NIGHT;
    s.light.model = !s.light.model;
    s.water.fresnel = !s.water.fresnel;
    tp_frame_begin(f.frame, w);
    assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
    s.sky.kind = TP_SKY_GRADIENT;
    draw(&s, &a, w, 0, 0, picture[0]);
    assert_memory_equal(tile.pixels, picture[0], sizeof picture[0]);
    frame_free(&f);
    free(w);
}

/* Tables that a frame keeps do not affect the next picture. */
static void a_camera_that_turns_draws_as_a_fresh_frame_does(void **state)
{
    (void)state;
    tp_scene s = sky_scene(TP_SKY_DAY);
    const tp_assets a = { .layer[0] = &boat.texture[0], .ripple = &boat.texture[1] };
    const tp_config c = { .width = WIDTH,
                          .height = HEIGHT,
                          .tile_height = HEIGHT,
                          .format = TP_FORMAT_XRGB8888 };
    s.boat.mesh[0] = '\0';
    s.quality.shading = TP_SHADING_QUICK;
    s.water.specular = s.water.reflection = s.ripple.bump = TP_FX_ONE;
    s.hdr.share = 0;
    s.light.heading = 0;
    tp_world *w = scene_world(&s, &a);
    test_frame f = frame_of(&s, &a, &c);
    tp_tile tile;

    for (int step = 0; step < 60; step++) {
        w->pitch = w->last_pitch = tp_turn_of_degrees(-step * TP_FX_ONE / 2);
        tp_frame_begin(f.frame, w);
        assert_non_null(f.frame->shade.quick);
        assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
        draw(&s, &a, w, 0, 0, picture[0]);
        assert_memory_equal(tile.pixels, picture[0], sizeof picture[0]);
    }
    frame_free(&f);
    free(w);
}

/* -- light beyond white ---------------------------------------------------------------- */

/* A cube of pictures without alpha, as loaded, or with light beyond white. */
static tp_assets cube_of_alpha(uint32_t alpha)
{
    static uint32_t  texel[16];
    static tp_texture face;
    tp_assets a = assets_of(true);

    for (int i = 0; i < 16; i++)
        texel[i] = alpha << 24 | (uint32_t)(random_next(&chance) & 0xffffff);
    face = (tp_texture){ .level[0] = texel, .levels = 1, .log2_w = 2, .log2_h = 2 };
    for (int i = 0; i < TP_FACES; i++)
        a.sky[i] = &face;
    return a;
}

/* Draws the scene without hdr.share and with it; true if the pictures are the same. */
static bool is_alike_at_any_share(tp_scene *s, const tp_assets *a)
{
    for (int i = 0; i < 2; i++) {
        s->hdr.share = i * TP_FX_ONE;
        tp_world *w = scene_world(s, a);
        draw(s, a, w, 0, 0, picture[i]);
        free(w);
    }
    return memcmp(picture[0], picture[1], sizeof picture[0]) == 0;
}

static void a_sky_has_light_beyond_white_by_its_sun_or_alpha(void **state)
{
    static const int32_t kinds[] = { TP_SKY_GRADIENT, TP_SKY_DAY, TP_SKY_DUSK, TP_SKY_NIGHT,
                                     TP_SKY_CUBE };

    (void)state;
    for (int n = 0; n < 40; n++) {
        const bool bright = n & 1;
        const tp_assets a = cube_of_alpha(bright ? 200 : 255);
        tp_scene s = sky_scene(kinds[n / 2 % 5]);
        s.boat.mesh[0] = '\0';
        s.hdr.exposure = TP_EXPOSURE_FIXED;
        s.quality.exposure = TP_RUNG_EXACT;
        s.quality.shading = n / 10 & 1 ? TP_SHADING_QUICK : TP_SHADING_EXACT;
        s.sky.sun = bright ? 8 * TP_FX_ONE : 0;
        s.water.reflection = TP_FX_ONE;
        const bool alike = is_alike_at_any_share(&s, &a);
        const bool has = tp_beyond_white(&s, &a) > 0;
        assert_int_equal(has, bright && s.sky.kind != TP_SKY_GRADIENT);
        assert_true(alike || has);
        if (s.sky.kind == TP_SKY_CUBE)
            assert_int_equal(alike, !has);
    }
}

/* -- a program without one of the skies ------------------------------------------------ */

/* The full module list with another use of the dome, or with none. */
static tp_program program_with_dome(const tp_use *dome)
{
    static tp_use list[TP_MODULES + 1];
    tp_program program = tp_program_all;
    uint32_t n = 0;

    for (const tp_use *u = tp_program_all.modules; u->module; u++) {
        if (u->module->id != TP_SKY_DOME_ID)
            list[n++] = *u;
        else if (dome)
            list[n++] = *dome;
    }
    list[n] = (tp_use){ 0 };
    program.modules = list;
    return program;
}

/* Returns the number of features left out. */
static uint32_t draw_by(const tp_program *program, const tp_scene *s, uint32_t *to)
{
    const tp_assets a = { .layer[0] = &boat.texture[0] };
    const tp_config c = { .width = WIDTH,
                          .height = HEIGHT,
                          .tile_height = HEIGHT,
                          .format = TP_FORMAT_XRGB8888 };
    tp_world *w = scene_world(s, &a);
    test_frame f = frame_by(program, s, &a, &c);
    tp_tile tile;

    tp_frame_begin(f.frame, w);
    assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
    memcpy(to, tile.pixels, sizeof picture[0]);
    const uint32_t dropped = tp_frame_stats(f.frame).dropped;
    frame_free(&f);
    free(w);
    return dropped;
}

static tp_scene day_scene(void)
{
    tp_scene s = sky_scene(TP_SKY_DAY);

    s.boat.mesh[0] = '\0';
    s.hdr.exposure = TP_EXPOSURE_FIXED;
    s.mirror.method = TP_MIRROR_NONE;
    s.quality.shading = TP_SHADING_EXACT;
    s.quality.visibility = TP_VISIBILITY_TRIANGLES;
    s.water.specular = s.water.reflection = TP_FX_ONE;
    return s;
}

static void a_sky_that_a_program_lacks_is_the_gradient_and_is_told(void **state)
{
    const tp_program lacking = program_with_dome(NULL);
    (void)state;

    for (int kind = TP_SKY_DAY; kind <= TP_SKY_NIGHT; kind++) {
        tp_scene s = day_scene();
        s.sky.kind = kind;
        assert_int_equal(draw_by(&lacking, &s, picture[0]), 1);
        s.sky.kind = TP_SKY_GRADIENT;
        assert_int_equal(draw_by(&lacking, &s, picture[1]), 0);
        assert_memory_equal(picture[1], picture[0], sizeof picture[0]);
    }
}

/* The use's table has no mirror stage: */
static const tp_use unmirrored =
    TP_USE_WITH(sky_dome, tp_stage_sky_dome, tp_stage_sky_dome_hdr, NULL, NULL, NULL);

/* the water is drawn without the Fresnel share. */
static void a_mirror_stage_that_a_program_lacks_is_left_out_and_is_told(void **state)
{
    const tp_program lacking = program_with_dome(&unmirrored);
    tp_scene s = day_scene();
    (void)state;

    assert_int_equal(draw_by(&lacking, &s, picture[0]), 1);
    assert_int_equal(draw_by(&tp_program_all, &s, picture[1]), 0);
    assert_memory_not_equal(picture[1], picture[0], sizeof picture[0]);
    s.water.reflection = 0;
    assert_int_equal(draw_by(&lacking, &s, picture[1]), 0);
    assert_memory_equal(picture[1], picture[0], sizeof picture[0]);
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_sky_is_the_same_in_every_tiling),
        cmocka_unit_test(a_cube_with_a_hole_is_the_gradient),
        cmocka_unit_test(skies_are_carved_for_those_who_have_them),
        cmocka_unit_test(a_live_change_is_drawn_as_far_as_there_are_tables),
        cmocka_unit_test(a_sky_has_light_beyond_white_by_its_sun_or_alpha),
        cmocka_unit_test(a_camera_that_turns_draws_as_a_fresh_frame_does),
        cmocka_unit_test(a_sky_that_a_program_lacks_is_the_gradient_and_is_told),
        cmocka_unit_test(a_mirror_stage_that_a_program_lacks_is_left_out_and_is_told),
    };
    return cmocka_run_group_tests_name("features/sky", tests, NULL, NULL);
}
