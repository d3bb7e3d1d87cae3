/* SPDX-License-Identifier: MIT */
/* Means of packed pixels: both bodies have the same bits, every tiling gives the same
 * pictures, and the error against blended colours stays small and has no bias. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "pixel/packed_blend.h"
#include "tests/lib/frames.h"
#include "tests/lib/random.h"

enum { WIDTH = 96, HEIGHT = 70, ROUNDS = 8 };

static uint64_t  chance;
static test_boat boat;
static tp_assets assets;

typedef struct {
    uint16_t pixel[HEIGHT][WIDTH];
} picture;

static picture exact, packed, part;

/* -- both bodies --------------------------------------------------------------------- */

static void fill_pixels(uint16_t *to, int count)
{
    for (int i = 0; i < count; i++)
        to[i] = (uint16_t)random_next(&chance);
}

static void both_bodies_mean_rows_alike(void **state)
{
    (void)state;
    for (int n = 0; n < 400; n++) {
        _Alignas(8) uint16_t above[64], below[64], plain[64] = { 0 }, words[64] = { 0 };
        const int32_t x = 2 * chance_int(&chance, 0, 40), y = chance_int(&chance, 0, 239);
        const int32_t count = chance_int(&chance, 1, 64);
        fill_pixels(above, 64);
        fill_pixels(below, 64);
        plain_mean_rows(plain, above, below, x, y, count, 0);
        packed_mean_rows(words, above, below, x, y, count, 0);
        assert_memory_equal(plain, words, sizeof plain);
        plain_mean_rows(plain, above, below, x, y, count, 1);
        packed_mean_rows(words, above, below, x, y, count, 1);
        assert_memory_equal(plain, words, sizeof plain);
    }
}

static void both_bodies_widen_columns_alike(void **state)
{
    (void)state;
    for (int n = 0; n < 400; n++) {
        _Alignas(8) uint16_t half[48], plain[80] = { 0 }, words[80] = { 0 };
        const int32_t x = chance_int(&chance, 0, 255), y = chance_int(&chance, 0, 239);
        const int32_t count = chance_int(&chance, 1, TP_RUN - x % TP_RUN), skip = x & 15;
        uint16_t *const from = half + (skip >> 1);
        fill_pixels(half, 48);
        plain_widen_columns(plain + skip, from, x, y, 0, count, count, 0);
        packed_widen_run(words + skip, from, x, y, count, 0);
        assert_memory_equal(plain, words, sizeof plain);
        plain_widen_columns(plain + skip, from, x, y, 0, count, count, 1);
        packed_widen_run(words + skip, from, x, y, count, 1);
        assert_memory_equal(plain, words, sizeof plain);
    }
}

/* A channel of a pixel: 0 blue, 1 green, 2 red. */
static int level(uint32_t pixel, int channel)
{
    return channel == 0 ? (int)(pixel & 31) : channel == 1 ? (int)(pixel >> 5 & 63)
                                                           : (int)(pixel >> 11 & 31);
}

static void a_mean_is_half_a_level_off_at_most_and_not_darker(void **state)
{
    int sum = 0;

    (void)state;
    for (int n = 0; n < 20000; n++) {
        const uint32_t a = random_next(&chance) & 0xffff, b = random_next(&chance) & 0xffff;
        const uint32_t mean = tp_mean_565(a, b, n & 1);
        for (int c = 0; c < 3; c++) {
            const int off = 2 * level(mean, c) - level(a, c) - level(b, c);
            assert_in_range(off + 1, 0, 2);
            assert_true(n & 1 ? off >= 0 : off <= 0);
            sum += off;
        }
    }
    assert_in_range(sum + 1500, 0, 3000);       /* of 60000; 9 standard deviations */
}

/* -- pictures ------------------------------------------------------------------------ */

/* Fast water with a boat, from any height; by `pitch` the picture has water or none. */
static tp_scene any_scene(tp_fx pitch)
{
    tp_scene s = scene_of_boat_ahead(pitch, &chance);

    s.boat.edges = TP_EDGES_PLAIN;
    s.sky.kind = TP_SKY_DAY;
    s.sky.haze = chance_int(&chance, 0, 1) ? 30 * TP_FX_ONE : 0;    /* 0: light is last */
    s.hdr.exposure_factor = chance_int(&chance, 0, 1) ? TP_FX_ONE : TP_FX(1.3);
    s.water.reflection = TP_FX(0.8);
    s.quality.shading = TP_SHADING_QUICK;
    s.quality.light = s.quality.lines = s.quality.sky = TP_RUNG_FAST;
    return s;
}

static void draw(tp_scene *scene, const tp_world *world, int32_t rung,
                 const tp_config *size, picture *to)
{
    tp_config config = *size;
    tp_tile tile;

    config.width = WIDTH;
    config.height = HEIGHT;
    config.format = config.format ? config.format : TP_FORMAT_RGB565;
    scene->quality.blending = rung;
    test_frame f = frame_of(scene, &assets, &config);
    tp_frame_begin(f.frame, world);
    for (uint32_t i = 0; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++)
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            memcpy(&to->pixel[y][tile.x0],
                   (const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride,
                   (tile.x1 - tile.x0) * sizeof to->pixel[0][0]);
    assert_true(frame_guard_holds(f.block, f.bytes));
    assert_true(frame_guard_holds(f.scratch, f.scratch_bytes));
    frame_free(&f);
}

static const tp_config bands = { .tile_height = 16 };

static tp_world *any_world(tp_scene *scene, tp_fx pitch, bool with_boat)
{
    *scene = any_scene(pitch);
    if (!with_boat)
        scene->boat.z += 40 * TP_FX_ONE;        /* behind the camera */
    tp_world *world = scene_world(scene, &assets);
    world->tick = random_next(&chance) >> 40;
    tp_world_apply(&tp_program_all, world, scene, NULL);
    return world;
}

typedef struct {
    double sum, bias, count, far;
} difference;

/* True if the exact picture draws the pixel: it is in no row between, or differs from the
 * mean of its neighbours.  Without packed pixels rows that differ are drawn. */
static bool is_drawn(int x, int y)
{
    if (y % 2 == 0 || y % 16 == 15 || y + 1 == HEIGHT)
        return true;
    for (int c = 0; c < 3; c++)
        if (abs(2 * level(exact.pixel[y][x], c) - level(exact.pixel[y - 1][x], c)
                - level(exact.pixel[y + 1][x], c)) > 3)
            return true;
    return false;
}

/* Compares even rows, and pixels of rows between that are means in both pictures.  far:
 * channels off by more than `most`, left out of the sums. */
static void add_difference(difference *d, int most)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            for (int c = 0; c < 3 && !(y % 2 && is_drawn(x, y)); c++) {
                const int by = level(packed.pixel[y][x], c) - level(exact.pixel[y][x], c);
                const int of_255 = c == 1 ? by * 255 / 63 : by * 255 / 31;
                const bool is_far = abs(of_255) > most;
                d->sum += is_far ? 0 : abs(of_255);
                d->bias += is_far ? 0 : of_255;
                d->far += is_far;
                d->count++;
            }
}

/* Pixels of few levels are averaged in place of colours; with an exposure they are the
 * means of toned colours, darker than the toned mean.  The bounds are the worst of
 * 60 seeds and a quarter more; the textures are noise.  Only the water's row at the horizon
 * differs more: on a mean row it is a copy. */
static void the_error_is_small(void **state)
{
    static const tp_fx exposure[2] = { TP_FX_ONE, TP_FX(1.3) };
    static const struct { double mean, bias; int most; } bound[2] = { { 1.2, 0.25, 16 },
                                                                     { 1.3, 0.3, 32 } };

    (void)state;
    for (int k = 0; k < 2; k++) {
        difference d = { 0 };
        for (int n = 0; n < ROUNDS / 2; n++) {
            tp_scene scene;
            tp_world *world = any_world(&scene, chance_fx(&chance, -30, 0), n % 2);
            scene.hdr.exposure_factor = exposure[k];
            tp_world_apply(&tp_program_all, world, &scene, NULL);
            draw(&scene, world, TP_RUNG_EXACT, &bands, &exact);
            draw(&scene, world, TP_RUNG_FAST, &bands, &packed);
            add_difference(&d, bound[k].most);
            free(world);
        }
        printf("of 255: mean error %.2f, bias %.2f, far off %.4f\n", d.sum / d.count,
               d.bias / d.count, d.far / d.count);
        assert_true(d.sum / d.count > 0.1 && d.sum / d.count < bound[k].mean);
        assert_true(fabs(d.bias / d.count) < bound[k].bias);
        assert_true(d.far / d.count < 0.25 / HEIGHT);
    }
}

static void every_tiling_gives_the_same_bits(void **state)
{
    static const tp_config sizes[] = {
        { .tile_height = 1 }, { .tile_height = 3 }, { .tile_height = 6 },
        { .tile_width = 16 }, { .tile_width = 32, .tile_height = 5 },
        { .tile_width = 48, .tile_height = 32 }, { .tile_height = HEIGHT },
    };

    (void)state;
    for (int n = 0; n < ROUNDS; n++) {
        tp_scene scene;
        tp_world *world = any_world(&scene, chance_fx(&chance, -30, 0), n % 2);
        scene.quality.lines = n % 4 == 3 ? TP_RUNG_EXACT : TP_RUNG_FAST;
        scene.quality.rows = chance_int(&chance, TP_RUNG_EXACT, TP_RUNG_PAIRS);
        scene.quality.visibility = n < ROUNDS / 2 ? TP_VISIBILITY_ROWS
                                                  : TP_VISIBILITY_TRIANGLES;
        draw(&scene, world, TP_RUNG_FAST, &bands, &packed);
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            draw(&scene, world, TP_RUNG_FAST, &sizes[i], &part);
            assert_memory_equal(&part, &packed, sizeof packed);
        }
        free(world);
    }
}

static void swapped_pixels_are_the_same_pixels(void **state)
{
    static const tp_config swapped = { .tile_height = 16, .format = TP_FORMAT_RGB565BE };
    tp_scene scene;

    (void)state;
    tp_world *world = any_world(&scene, -10 * TP_FX_ONE, true);
    draw(&scene, world, TP_RUNG_FAST, &bands, &packed);
    draw(&scene, world, TP_RUNG_FAST, &swapped, &part);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(tp_swap_pixel(part.pixel[y][x], 1), packed.pixel[y][x]);
    free(world);
}

/* Draws into a picture that begins at an odd pixel, with an odd number of pixels a row. */
static void any_place_of_a_picture_gives_the_same_bits(void **state)
{
    static uint32_t words[HEIGHT * (WIDTH + 3) / 2 + 2];
    const size_t stride = 2 * (WIDTH + 3);
    uint8_t *const at = (uint8_t *)words + 2;
    tp_scene scene;
    tp_tile tile;

    (void)state;
    tp_world *world = any_world(&scene, -10 * TP_FX_ONE, true);
    draw(&scene, world, TP_RUNG_FAST, &bands, &packed);
    const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_height = 5,
                               .format = TP_FORMAT_RGB565 };
    test_frame f = frame_of(&scene, &assets, &config);
    tp_frame_begin(f.frame, world);
    for (uint32_t i = 0;
         tp_frame_draw_tile_direct(f.frame, i, f.scratch, at, stride, &tile); i++)
        ;
    for (size_t y = 0; y < HEIGHT; y++)
        assert_memory_equal(at + y * stride, packed.pixel[y], sizeof packed.pixel[y]);
    frame_free(&f);
    free(world);
}

static void only_rgb565_pictures_with_means_change(void **state)
{
    tp_scene scene;

    (void)state;
    tp_world *world = any_world(&scene, -10 * TP_FX_ONE, true);
    scene.quality.light = scene.quality.lines = TP_RUNG_EXACT;
    draw(&scene, world, TP_RUNG_EXACT, &bands, &exact);
    draw(&scene, world, TP_RUNG_FAST, &bands, &packed);
    assert_memory_equal(&packed, &exact, sizeof packed);
    free(world);
    world = any_world(&scene, 80 * TP_FX_ONE, true);    /* the sky alone */
    scene.quality.sky = TP_RUNG_EXACT;
    draw(&scene, world, TP_RUNG_EXACT, &bands, &exact);
    draw(&scene, world, TP_RUNG_FAST, &bands, &packed);
    assert_memory_equal(&packed, &exact, sizeof packed);
    free(world);
    static uint32_t colours[2][HEIGHT][WIDTH];
    const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_height = 16 };
    world = any_world(&scene, -10 * TP_FX_ONE, true);
    for (int i = 0; i < 2; i++) {
        scene.quality.blending = i ? TP_RUNG_FAST : TP_RUNG_EXACT;
        test_frame f = frame_of(&scene, &assets, &config);
        frame_draw_picture(&f, world, colours[i][0]);
        frame_free(&f);
    }
    assert_memory_equal(colours[0], colours[1], sizeof colours[0]);
    free(world);
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    assets = boat_assets(&boat);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_bodies_mean_rows_alike),
        cmocka_unit_test(both_bodies_widen_columns_alike),
        cmocka_unit_test(a_mean_is_half_a_level_off_at_most_and_not_darker),
        cmocka_unit_test(the_error_is_small),
        cmocka_unit_test(every_tiling_gives_the_same_bits),
        cmocka_unit_test(swapped_pixels_are_the_same_pixels),
        cmocka_unit_test(any_place_of_a_picture_gives_the_same_bits),
        cmocka_unit_test(only_rgb565_pictures_with_means_change),
    };
    return cmocka_run_group_tests_name("frame/packed_rows", tests, NULL, NULL);
}
