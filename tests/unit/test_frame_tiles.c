/* SPDX-License-Identifier: MIT */
/* A frame is the same for every tiling, in memory of exactly the requested size. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/boat/boat.h"
#include "frame/tools.h"
#include "tests/lib/tilings.h"

enum { WIDTH = 150, HEIGHT = 90 };

static uint64_t chance;
static test_boat boat;

/* The whole picture as 0x00RRGGBB, assembled from tiles in the order of `step`. */
static void draw(const test_frame *f, const tp_config *config, uint32_t step,
                 uint32_t *picture)
{
    const uint32_t tiles = tp_frame_tiles(f->frame);
    tp_tile tile;

    for (uint32_t n = 0; n < tiles; n++) {
        assert_true(tp_frame_draw_tile(f->frame, n * step % tiles, f->scratch, &tile));
        for (uint32_t y = tile.y0; y < tile.y1; y++) {
            const uint8_t *row =
                (const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride;
            for (uint32_t x = tile.x0; x < tile.x1; x++)
                picture[y * config->width + x]
                    = tp_pixel_read(config->format, row, (int)(x - tile.x0));
        }
    }
    assert_false(tp_frame_draw_tile(f->frame, tiles, f->scratch, &tile));
    assert_true(frame_guard_holds(f->block, f->bytes));
    assert_true(frame_guard_holds(f->scratch, f->scratch_bytes));
}

static void draw_all(const tp_scene *scene, const tp_assets *assets,
                     const tp_world *world, const tp_config *config, uint32_t *picture)
{
    test_frame f = frame_of(scene, assets, config);

    tp_frame_begin(f.frame, world);
    draw(&f, config, 1, picture);
    frame_free(&f);
}

static const tp_assets *all_assets(void)
{
    static tp_assets assets;
    assets = (tp_assets){ .boat = &boat.mesh, .layer[0] = &boat.texture[0],
                          .ripple = &boat.texture[1] };
    return &assets;
}

/* The plain scene with the boat close by, seen from a random position. */
static tp_scene busy_scene(tp_world *world)
{
    tp_scene s = scene_plain();

    s.camera.x = chance_fx(&chance, -30, 30);
    s.camera.y = chance_fx(&chance, 0.1, 12);
    s.camera.heading = chance_fx(&chance, -20, 20);
    s.camera.pitch = chance_fx(&chance, -40, 15);
    s.boat.x = s.camera.x + chance_fx(&chance, -4, 4);
    s.boat.z = chance_fx(&chance, -14, 2);
    s.boat.heading = chance_fx(&chance, 0, 360);
    s.water.filter = chance_int(&chance, 0, 1);
    s.mirror.method = chance_int(&chance, TP_MIRROR_NONE, TP_MIRROR_CUBE);
    s.mirror.size = chance_int(&chance, TP_MIRROR_HALF, TP_MIRROR_FULL);
    s.mirror.colours = s.camera.x % 2 ? TP_MIRROR_RGB565 : TP_MIRROR_RGB888;
    s.water.clarity = chance_int(&chance, 0, 1) * TP_FX_ONE;
    s.layer[0].map.size = 3 * TP_FX_ONE;
    s.boat.length = 4 * TP_FX_ONE;
    s.boat.beam = 2 * TP_FX_ONE;
    if (random_below(&chance, 3) == 0) {        /* from the rolling deck */
        s.camera.follow = TP_FOLLOW_BOAT;
        s.camera.x = 0;
        s.camera.y = chance_fx(&chance, 0.6, 2);
    }
    tp_world_init(&tp_program_all, world, sizeof *world, &s, NULL, NULL);
    world->tick = random_next(&chance) >> 30;
    tp_world_apply(&tp_program_all, world, &s, NULL);
    return s;
}

static void every_tiling_gives_the_same_bits(void **state)
{
    (void)state;
    static uint32_t whole[WIDTH * HEIGHT], part[WIDTH * HEIGHT];
    static const uint32_t sizes[][2] = { { 0, 1 },     { 0, 7 },      { 0, 16 },
                                         { 16, 0 },    { 48, 0 },     { 64, 0 },
                                         { 16, 1 },    { 32, 13 },    { 144, 89 },
                                         { 160, 100 }, { 4096, 4096 } };

    for (int n = 0; n < random_rounds(18, 9); n++) {
        tp_world world;
        const tp_scene scene = busy_scene(&world);
        const tp_format format = (tp_format)(n % TP_FORMAT_COUNT);
        tp_config config = {
            .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = format
        };
        draw_all(&scene, all_assets(), &world, &config, whole);
        for (size_t i = 0; i <= sizeof sizes / sizeof sizes[0]; i++) {
            const bool any = i == sizeof sizes / sizeof sizes[0];
            config.tile_width = any ? 16 * random_below(&chance, 10) : sizes[i][0];
            config.tile_height = any ? random_below(&chance, HEIGHT) : sizes[i][1];
            memset(part, 0, sizeof part);
            draw_all(&scene, all_assets(), &world, &config, part);
            assert_memory_equal(part, whole, sizeof whole);
        }
    }
}

/* Every feature that a scene can have, at ticks and between ticks, in frames that live on
 * while world and scene change. */
static void every_kind_of_scene_gives_the_same_bits_in_tiles(void **state)
{
    (void)state;
    static test_kit kit;
    static test_twice twice;

    kit_make(&kit, &chance);
    for (int n = 0; n < 150; n++) {
        tp_scene scene = scene_plain();
        kit_gather(&scene, &chance);
        kit_switch_on(&scene, &chance);
        scene.floor.depth = chance_int(&chance, 0, 1) * 2 * TP_FX_ONE;
        scene.clock.scale = TP_FX(0.7);
        tp_scene other = scene;
        kit_switch_on(&other, &chance);
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        tp_world *world = scene_world(&scene, &assets);
        assert_non_null(world);
        twice_begin(&twice, &scene, &assets, &chance);
        for (int k = 0; k < 3; k++) {
            for (uint32_t i = 5 * (uint32_t)k + tp_world_advance_clock(world); i > 0; i--)
                tp_world_step(&tp_program_all, world, &scene, NULL);
            twice_draw(&twice, world);
            scene.water = other.water;
            scene.mirror = other.mirror;
            scene.sky.kind = other.sky.kind;
            scene.hdr.share = other.hdr.share;
            scene.tank.kind = other.tank.kind;
            assert_true(tp_world_apply(&tp_program_all, world, &scene, &assets));
        }
        twice_end(&twice);
        free(world);
    }
    twice_print(&twice.reached);
    assert_true(twice_reached_all(&twice.reached));
}

/* Draws the tiles backwards or in leaps, into a scratch full of other data, and into other
 * memory. */
static void order_and_old_memory_do_not_matter(void **state)
{
    (void)state;
    static uint32_t whole[WIDTH * HEIGHT], part[WIDTH * HEIGHT];
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_width = 32,
                               .tile_height = 9,
                               .format = TP_FORMAT_XRGB8888 };

    for (int n = 0; n < 6; n++) {
        tp_world world;
        const tp_scene scene = busy_scene(&world);
        draw_all(&scene, all_assets(), &world, &config, whole);
        test_frame f = frame_of(&scene, all_assets(), &config);
        tp_frame_begin(f.frame, &world);
        for (size_t i = 0; i < f.scratch_bytes; i++)
            f.scratch[i] = (uint8_t)random_next(&chance);
        draw(&f, &config, 7, part);         /* 50 tiles: 7 and 49 reach all tiles */
        assert_memory_equal(part, whole, sizeof whole);
        draw(&f, &config, 49, part);
        assert_memory_equal(part, whole, sizeof whole);

        memset(f.block, 0, f.bytes);
        const tp_config c = config_with(&config, NULL, all_assets());
        assert_int_equal(tp_frame_init(&f.frame, &c, &scene, f.block, f.bytes, NULL),
                         TP_OK);
        tp_frame_begin(f.frame, &world);
        draw(&f, &config, 1, part);
        assert_memory_equal(part, whole, sizeof whole);
        tp_frame_begin(f.frame, &world);    /* once more over its own remains */
        draw(&f, &config, 1, part);
        assert_memory_equal(part, whole, sizeof whole);
        frame_free(&f);
    }
}

static void the_world_may_move_on_while_tiles_are_drawn(void **state)
{
    (void)state;
    static uint32_t before[WIDTH * HEIGHT], after[WIDTH * HEIGHT];
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_height = HEIGHT,
                               .format = TP_FORMAT_XRGB8888 };
    tp_world world;
    const tp_scene scene = busy_scene(&world);
    test_frame f = frame_of(&scene, all_assets(), &config);

    tp_frame_begin(f.frame, &world);
    draw(&f, &config, 1, before);
    for (int i = 0; i < 30; i++)
        tp_world_step(&tp_program_all, &world, &scene, NULL);
    draw(&f, &config, 1, after);
    assert_memory_equal(after, before, sizeof before);
    tp_frame_begin(f.frame, &world);
    draw(&f, &config, 1, after);
    assert_memory_not_equal(after, before, sizeof before);
    frame_free(&f);
}

/* Every format equals the true colours passed through the format's store. */
static void formats_differ_only_in_how_colours_are_stored(void **state)
{
    (void)state;
    static uint32_t colours[WIDTH * HEIGHT], got[WIDTH * HEIGHT];
    tp_world world;
    const tp_scene scene = busy_scene(&world);
    tp_config config = { .width = WIDTH,
                         .height = HEIGHT,
                         .tile_height = HEIGHT,
                         .format = TP_FORMAT_XRGB8888 };

    draw_all(&scene, all_assets(), &world, &config, colours);
    for (int format = 0; format < TP_FORMAT_COUNT; format++) {
        uint32_t row[WIDTH + 1];
        config.format = (tp_format)format;
        config.tile_width = 48;
        draw_all(&scene, all_assets(), &world, &config, got);
        for (int y = 0; y < HEIGHT; y++) {
            tp_program_all.store[config.format](row, 0, 0, y, colours + y * WIDTH, WIDTH);
            for (int x = 0; x < WIDTH; x++)
                assert_int_equal(got[y * WIDTH + x],
                                 tp_pixel_read(config.format, row, x));
        }
    }
}

/* -- tiles --------------------------------------------------------------------------- */

static void tiles_are_rows_of_the_size_asked_for(void **state)
{
    (void)state;
    const tp_scene scene = scene_plain();
    const tp_assets none = { 0 };
    tp_world world;
    tp_world_init(&tp_program_all, &world, sizeof world, &scene, NULL, NULL);

    for (int n = 0; n < 40; n++) {
        const tp_config c = { .width = (uint32_t)chance_int(&chance, 16, 200),
                              .height = (uint32_t)chance_int(&chance, 16, 99),
                              .tile_width = 16 * random_below(&chance, 9),
                              .tile_height = random_below(&chance, 60),
                              .format =
                                  (tp_format)random_below(&chance, TP_FORMAT_COUNT) };
        test_frame f = frame_of(&scene, &none, &c);
        uint32_t x = 0, y = 0, i = 0;
        tp_tile tile;
        tp_frame_begin(f.frame, &world);
        for (; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++) {
            const uint32_t wide = c.tile_width ? c.tile_width : c.width;
            const uint32_t high = c.tile_height ? c.tile_height : 16;
            assert_int_equal(tile.x0, x);
            assert_int_equal(tile.y0, y);
            assert_int_equal(tile.x1, x + wide < c.width ? x + wide : c.width);
            assert_int_equal(tile.y1, y + high < c.height ? y + high : c.height);
            assert_true((const uint8_t *)tile.pixels >= f.scratch);
            assert_true((const uint8_t *)tile.pixels + tile.stride * (tile.y1 - tile.y0)
                        <= f.scratch + f.scratch_bytes);
            assert_true(tile.stride >= tp_format_row_bytes(c.format,
                                                           (int)(tile.x1 - tile.x0)));
            x = tile.x1 < c.width ? tile.x1 : 0;
            y = tile.x1 < c.width ? y : tile.y1;
        }
        assert_int_equal(y, c.height);
        assert_int_equal(i, tp_frame_tiles(f.frame));
        frame_free(&f);
    }
}

#define CONFIG(w, h, tile_w, tile_h, f)                                                  \
    {                                                                                    \
        .width = w, .height = h, .tile_width = tile_w, .tile_height = tile_h,            \
        .format = f                                                                      \
    }

static void a_config_out_of_range_is_refused(void **state)
{
    (void)state;
    static const struct {
        tp_config config;
        tp_status status;
        int32_t a, b;
    } bad[] = {
        { CONFIG(15, 48, 0, 0, TP_FORMAT_P8), TP_E_SIZE, 15, 48 },
        { CONFIG(64, 15, 0, 0, TP_FORMAT_P8), TP_E_SIZE, 64, 15 },
        { CONFIG(4097, 48, 0, 0, TP_FORMAT_P8), TP_E_SIZE, 4097, 48 },
        { CONFIG(64, 4097, 0, 0, TP_FORMAT_P8), TP_E_SIZE, 64, 4097 },
        { CONFIG(0, 0, 0, 0, TP_FORMAT_P8), TP_E_SIZE, 0, 0 },
        { CONFIG(64, 48, 17, 8, TP_FORMAT_P8), TP_E_TILE, 17, 8 },
        { CONFIG(64, 48, 63, 8, TP_FORMAT_P8), TP_E_TILE, 63, 8 },
        { CONFIG(64, 48, 0, 0, TP_FORMAT_COUNT), TP_E_ARG, 0, 0 },
        { CONFIG(64, 48, 0, 0, (tp_format)-1), TP_E_ARG, 0, 0 },
    };
    const tp_scene scene = scene_plain();
    uint64_t block[8];

    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        tp_frame *frame = NULL;
        tp_error err = { .code = TP_OK };
        assert_int_equal(tp_frame_bytes(&bad[i].config, &scene), 0);
        assert_int_equal(tp_frame_scratch_bytes(&bad[i].config, &scene), 0);
        assert_int_equal(
            tp_frame_init(&frame, &bad[i].config, &scene, block, sizeof block, &err),
            bad[i].status);
        assert_int_equal(err.code, bad[i].status);
        assert_int_equal(err.a, bad[i].a);
        assert_int_equal(err.b, bad[i].b);
        assert_null(frame);
    }
}

static void the_ends_of_the_config_are_taken(void **state)
{
    (void)state;
    static const tp_config good[] = {
        CONFIG(16, 16, 0, 0, TP_FORMAT_I1),
        CONFIG(16, 4096, 16, 1, TP_FORMAT_L8),
        CONFIG(4096, 16, 4096, 16, TP_FORMAT_RGB565),
        CONFIG(17, 16, 17, 999, TP_FORMAT_P8),
        CONFIG(4095, 17, 16, 16, TP_FORMAT_XRGB8888),
    };
    const tp_scene scene = scene_plain();
    tp_world world;

    tp_world_init(&tp_program_all, &world, sizeof world, &scene, NULL, NULL);
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        uint32_t *picture = malloc((size_t)good[i].width * good[i].height * 4);
        draw_all(&scene, all_assets(), &world, &good[i], picture);
        free(picture);
    }
}

/* -- statistics ---------------------------------------------------------------------- */

static void the_numbers_of_a_frame_add_up(void **state)
{
    (void)state;
    tp_world world;
    const tp_scene scene = busy_scene(&world);
    const tp_config config = {
        .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_P8
    };
    test_frame f = frame_of(&scene, all_assets(), &config);
    const tp_ram_use ram = tp_frame_ram(f.frame);

    assert_int_equal(ram.frame, f.bytes);
    assert_int_equal(ram.scratch, f.scratch_bytes);
    assert_true(ram.vertices + ram.tables <= ram.frame);
    assert_true(ram.vertices >= 1000 * sizeof(tp_grid_vertex));
    assert_true(ram.tables >= 8 * sizeof(tp_boat_vertex));
    tp_frame_begin(f.frame, &world);
    const tp_draw_stats stats = tp_frame_stats(f.frame);
    assert_in_range(stats.vertices, 1, 60 * 50 + 8);
    assert_in_range(stats.triangles, 1, 2 * 59 * 49 + 12);
    assert_int_equal(stats.dropped, 0);
    frame_free(&f);
}

static void materials_beyond_the_marks_are_counted_and_drawn(void **state)
{
    (void)state;
    static test_boat many;
    static tp_material material[300];
    tp_world world;
    const tp_scene scene = busy_scene(&world);
    const tp_config config = {
        .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_P8
    };
    static uint32_t picture[WIDTH * HEIGHT];

    boat_make(&many, &chance);
    for (int i = 0; i < 300; i++)
        material[i] = many.material[0];
    for (uint32_t i = 0; i < 12; i++)
        many.face[i].material = 299 - i;
    many.mesh.materials = material;
    many.mesh.n_materials = 300;
    const tp_assets assets = { .boat = &many.mesh };
    test_frame f = frame_of(&scene, &assets, &config);
    tp_frame_begin(f.frame, &world);
    assert_int_equal(tp_frame_stats(f.frame).dropped, 300 - TP_BOAT_MATERIALS);
    draw(&f, &config, 1, picture);
    frame_free(&f);
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_gives_the_same_bits),
        cmocka_unit_test(every_kind_of_scene_gives_the_same_bits_in_tiles),
        cmocka_unit_test(order_and_old_memory_do_not_matter),
        cmocka_unit_test(the_world_may_move_on_while_tiles_are_drawn),
        cmocka_unit_test(formats_differ_only_in_how_colours_are_stored),
        cmocka_unit_test(tiles_are_rows_of_the_size_asked_for),
        cmocka_unit_test(a_config_out_of_range_is_refused),
        cmocka_unit_test(the_ends_of_the_config_are_taken),
        cmocka_unit_test(the_numbers_of_a_frame_add_up),
        cmocka_unit_test(materials_beyond_the_marks_are_counted_and_drawn),
    };
    return cmocka_run_group_tests_name("frame/tiles", tests, NULL, NULL);
}
