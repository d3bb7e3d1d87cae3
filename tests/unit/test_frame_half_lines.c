/* SPDX-License-Identifier: MIT */
/* Water at half the rows: rows between are means of their neighbours where these are alike,
 * all other pixels are those of the exact picture, in every tiling. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/dsp.h"
#include "tests/lib/random.h"
#include "tests/lib/frames.h"

enum { WIDTH = 96, HEIGHT = 70, ROUNDS = 10 };

static uint64_t  chance;
static test_boat boat;
static tp_assets assets;
static uint32_t  half[HEIGHT][WIDTH], full[HEIGHT][WIDTH], part[HEIGHT][WIDTH];
static uint8_t   kind[HEIGHT][WIDTH];

static void draw(const tp_scene *scene, const tp_world *world, uint32_t tile_width,
                 uint32_t tile_height, uint32_t to[HEIGHT][WIDTH])
{
    const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_width = tile_width,
                               .tile_height = tile_height };
    test_frame f = frame_of(scene, &assets, &config);
    tp_tile tile;

    frame_draw_picture(&f, world, to[0]);
    for (uint32_t i = 0; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++)
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            tp_frame_sample_row(f.frame, f.scratch, &tile, y, NULL, &kind[y][tile.x0]);
    frame_free(&f);
}

/* Draws a random scene in full and at half the rows; returns its world.  Outlines are
 * blended over the means. */
static tp_world *draw_both(tp_scene *scene, tp_fx pitch, bool outlines)
{
    *scene = scene_of_boat_ahead(pitch, &chance);
    scene->boat.edges = outlines ? TP_EDGES_SMOOTH : TP_EDGES_PLAIN;
    tp_world *world = scene_world(scene, &assets);
    world->tick = random_next(&chance) >> 40;
    tp_world_apply(&tp_program_all, world, scene, NULL);
    draw(scene, world, 0, 16, full);
    scene->quality.lines = TP_RUNG_FAST;
    draw(scene, world, 0, 16, half);
    return world;
}

static bool is_between(int y)
{
    return y % 2 == 1 && y % 16 != 15;
}

static bool is_water(int x, int y)
{
    return y >= 0 && y < HEIGHT && kind[y][x] == TP_SAMPLE_WATER;
}

static bool is_inside(int x, int y)
{
    return is_between(y) && is_water(x, y) && is_water(x, y - 1) && is_water(x, y + 1);
}

static int difference(uint32_t a, uint32_t b)
{
    int sum = 0;

    for (int shift = 0; shift < 24; shift += 8)
        sum += abs((int)(a >> shift & 255) - (int)(b >> shift & 255));
    return sum;
}

static int green_difference(uint32_t a, uint32_t b)
{
    return abs((int)(a >> 8 & 255) - (int)(b >> 8 & 255));
}

/* True if the rows beside the pixel's block of eight columns differ by 16 levels of green
 * in the mean of a whole block.  Other pixels part a block: each part counts alone. */
static bool is_apart(int x, int y)
{
    int sum = 0;

    for (int i = x; i >= x / 8 * 8 && is_inside(i, y); i--)
        sum += green_difference(full[y - 1][i], full[y + 1][i]);
    for (int i = x + 1; i < x / 8 * 8 + 8 && is_inside(i, y); i++)
        sum += green_difference(full[y - 1][i], full[y + 1][i]);
    return sum >= 8 * 16;
}

/* True if a pixel of a row between is a mean: all three are water, and the rows alike. */
static bool is_mean(int x, int y)
{
    return is_inside(x, y) && !is_apart(x, y);
}

/* True if the pixel is other water of a row between.  It is shaded, but in a shorter run: a
 * stage takes some numbers from the first pixel of a run. */
static bool is_alone(int x, int y)
{
    return is_between(y) && is_water(x, y) && !is_mean(x, y);
}

static uint32_t wanted(int x, int y)
{
    return is_mean(x, y) ? tp_uhadd8(full[y - 1][x], full[y + 1][x]) : full[y][x];
}

static void rows_between_are_means_and_others_exact(void **state)
{
    uint32_t means = 0, changed = 0, apart = 0;
    int64_t off = 0, off_of_means = 0;

    (void)state;
    for (int n = 0; n < ROUNDS; n++) {
        tp_scene scene;
        free(draw_both(&scene, chance_fx(&chance, -30, 0), false));
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                if (!is_alone(x, y) && (half[y][x] ^ wanted(x, y)) & 0xffffff)
                    fail_msg("pixel %d %d is %06x, not %06x", x, y, (unsigned)half[y][x],
                             (unsigned)wanted(x, y));
                means += is_mean(x, y);
                changed += is_mean(x, y) && half[y][x] != full[y][x];
                if (!is_inside(x, y) || is_mean(x, y))
                    continue;
                apart++;
                off += difference(half[y][x], full[y][x]);
                off_of_means += difference(
                    tp_uhadd8(full[y - 1][x], full[y + 1][x]), full[y][x]);
            }
    }
    printf("    %u means, %u pixels of rows that differ: %.1f off, their means %.1f\n",
           means, apart, (double)off / apart, (double)off_of_means / apart);
    assert_in_range(means, ROUNDS * WIDTH, ROUNDS * WIDTH * HEIGHT / 2);
    assert_in_range(apart, ROUNDS * WIDTH / 4, ROUNDS * WIDTH * HEIGHT / 2);
    assert_true(off < off_of_means / 8);
    assert_in_range(changed, means / 4, means);
}

static void every_tiling_gives_the_same_bits(void **state)
{
    static const uint32_t sizes[][2] = { { 0, 1 }, { 0, 3 }, { 0, 4 }, { 0, 6 }, { 0, 17 },
                                         { 16, 0 }, { 32, 5 }, { 48, 32 }, { 64, HEIGHT },
                                         { 0, 4096 } };

    (void)state;
    for (int n = 0; n < ROUNDS / 2; n++) {
        tp_scene scene;
        tp_world *world = draw_both(&scene, chance_fx(&chance, -30, 0), n % 2);
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            draw(&scene, world, sizes[i][0], sizes[i][1], part);
            assert_memory_equal(part, half, sizeof half);
        }
        free(world);
    }
}

static void a_picture_without_water_does_not_change(void **state)
{
    tp_scene scene;

    (void)state;
    free(draw_both(&scene, 80 * TP_FX_ONE, true));
    assert_memory_equal(half, full, sizeof full);
}

static void mark_row(void *user, const tp_overlay_row *row)
{
    uint32_t *rows = user;
    row->colour[0] = 0x123456;
    *rows += 1;
}

static void the_application_draws_over_the_means(void **state)
{
    uint32_t rows = 0;
    tp_scene scene;
    const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_height = 6,
                               .overlay = tp_overlay_make(mark_row, &rows) };

    (void)state;
    tp_world *world = draw_both(&scene, -10 * TP_FX_ONE, true);
    test_frame f = frame_of(&scene, &assets, &config);
    frame_draw_picture(&f, world, part[0]);
    assert_int_equal(rows, HEIGHT);
    for (int y = 0; y < HEIGHT; y++) {
        assert_int_equal(part[y][0] & 0xffffff, 0x123456);
        assert_memory_equal(&part[y][1], &half[y][1], sizeof half[y] - sizeof half[y][0]);
    }
    frame_free(&f);
    free(world);
}

/* Without the row at init the scratch may have no room for rows beside a tile. */
static void the_row_set_after_init_changes_nothing(void **state)
{
    tp_scene scene;
    const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_height = 5 };

    (void)state;
    tp_world *world = draw_both(&scene, -10 * TP_FX_ONE, true);
    scene.quality.lines = TP_RUNG_EXACT;
    test_frame f = frame_of(&scene, &assets, &config);
    scene.quality.lines = TP_RUNG_FAST;
    frame_draw_picture(&f, world, part[0]);
    assert_memory_equal(part, full, sizeof full);
    assert_memory_not_equal(half, full, sizeof full);
    frame_free(&f);
    free(world);
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    assets = boat_assets(&boat);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_between_are_means_and_others_exact),
        cmocka_unit_test(every_tiling_gives_the_same_bits),
        cmocka_unit_test(a_picture_without_water_does_not_change),
        cmocka_unit_test(the_application_draws_over_the_means),
        cmocka_unit_test(the_row_set_after_init_changes_nothing),
    };
    return cmocka_run_group_tests_name("frame/half_lines", tests, NULL, NULL);
}
