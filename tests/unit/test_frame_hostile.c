/* SPDX-License-Identifier: MIT */
/* Whatever a scene, a world or an input asks for within the table's ranges can be drawn:
 * no undefined behaviour (under the sanitizers), nothing written outside the memory asked
 * for, and every pixel of the picture set. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "scenes.h"

enum { WIDTH = 64, HEIGHT = 48 };

static uint64_t chance;
static test_boat boat;

static tp_assets any_assets(void)
{
    return (tp_assets){
        .boat = random_below(&chance, 3) ? &boat.mesh : NULL,
        .layer[0] =
            random_below(&chance, 3) ? &boat.texture[random_below(&chance, 3)] : NULL,
        .ripple =
            random_below(&chance, 3) ? &boat.texture[random_below(&chance, 3)] : NULL,
    };
}

/* Grids as large as time allows: the points of one are one in twenty thousand. */
static void hold_grid(tp_scene *s)
{
    while (s->grid.cols * s->grid.rows > 4000) {
        if (s->grid.cols > s->grid.rows)
            s->grid.cols = s->grid.cols / 2 < 2 ? 2 : s->grid.cols / 2;
        else
            s->grid.rows = s->grid.rows / 2 < 2 ? 2 : s->grid.rows / 2;
    }
}

/* Draws all tiles; each pixel row of a tile is set anew although all was 0xA5. */
static uint32_t draw(const test_frame *f, tp_format format)
{
    tp_tile tile;
    uint32_t crc = 0;

    for (uint32_t i = 0; tp_frame_tile(f->frame, i, f->scratch, &tile); i++) {
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            crc = tp_crc32_pixels(
                crc, format, (const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride,
                (int)(tile.x1 - tile.x0));
        assert_true(tp_frame_water_pixels(f->frame, f->scratch, &tile)
                    <= (tile.x1 - tile.x0) * (tile.y1 - tile.y0));
        memset(f->scratch, 0x5a, f->scratch_bytes);     /* nothing is kept in it */
    }
    assert_true(frame_guard_holds(f->block, f->bytes));
    assert_true(frame_guard_holds(f->scratch, f->scratch_bytes));
    return crc;
}

/* As a whole and in tiles: the same picture. */
static uint32_t draw_both(const tp_scene *scene, const tp_assets *assets,
                          const tp_world *world)
{
    const tp_format format = (tp_format)random_below(&chance, TP_FORMAT_COUNT);
    const tp_frame_config whole = { WIDTH, HEIGHT, 0, 0, format };
    const tp_frame_config bands = { WIDTH, HEIGHT, 0, random_below(&chance, HEIGHT),
                                    format };
    test_frame a = frame_of(scene, assets, &whole), b = frame_of(scene, assets, &bands);

    tp_frame_begin(a.frame, world);
    tp_frame_begin(b.frame, world);
    const uint32_t crc = draw(&a, format);
    assert_int_equal(draw(&b, format), crc);
    frame_free(&a);
    frame_free(&b);
    return crc;
}

static tp_input any_input(void)
{
    const int32_t far = random_below(&chance, 2) ? INT32_MAX : 65536;
    return (tp_input){ .ahead = chance_int(&chance, -far, far),
                       .aside = chance_int(&chance, -far, far),
                       .up = chance_int(&chance, -far, far),
                       .turn = chance_int(&chance, -far, far),
                       .tilt = chance_int(&chance, -far, far) };
}

static void any_scene_of_the_table_is_drawn(void **state)
{
    (void)state;
    for (int n = 0; n < 300; n++) {
        tp_scene scene = scene_any(&chance);
        const tp_assets assets = any_assets();
        hold_grid(&scene);
        tp_world *world = scene_world(&scene, &assets);
        if (!world)
            continue;
        if (n % 3 == 0) {
            world->tick = random_next(&chance);
            tp_world_refresh(world, &scene, &assets);
        }
        for (int k = 0; k < n % 4; k++) {
            const tp_input input = any_input();
            tp_world_step(world, &scene, k ? &input : NULL);
        }
        draw_both(&scene, &assets, world);
        free(world);
    }
}

/* All rows at their least, all at their most, and each alone at either end. */
static void every_row_at_its_ends_is_drawn(void **state)
{
    (void)state;
    uint32_t count = 0;
    const tp_param *rows = tp_params(&count);
    const tp_assets assets = { .boat = &boat.mesh, .layer[0] = &boat.texture[0],
                               .ripple = &boat.texture[1] };

    for (uint32_t i = 0; i < 2 * (count + 1); i++) {
        const bool high = i % 2;
        tp_scene scene = scene_plain();
        for (uint32_t k = 0; k < count; k++) {
            if (scene_is_number(&rows[k]) && (i / 2 == k || i / 2 == count))
                *scene_number(&scene, &rows[k]) = high ? rows[k].high : rows[k].low;
        }
        hold_grid(&scene);
        tp_world *world = scene_world(&scene, &assets);
        if (world)
            draw_both(&scene, &assets, world);
        free(world);
    }
}

static void grids_of_any_shape_are_drawn(void **state)
{
    (void)state;
    static const int32_t sizes[][2] = { { 2, 2 }, { 1024, 2 }, { 2, 1024 }, { 3, 2 },
                                        { 8, 8 }, { 17, 33 }, { 2, 7 }, { 1024, 300 } };

    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        tp_scene scene = scene_plain();
        const tp_assets assets = { 0 };
        tp_world world;
        scene.grid.cols = sizes[i][0];
        scene.grid.rows = sizes[i][1];
        for (int k = 0; k < 8; k++) {
            scene.grid.cell = k & 1 ? 50 * TP_FX_ONE : TP_FX(0.05);
            scene.grid.reach = k & 2 ? 16000 * TP_FX_ONE : 0;
            scene.grid.follow = k >> 2;
            scene.camera.heading = 33 * k * TP_FX_ONE;
            if (sizes[i][1] == 300 && k % 3)
                continue;
            tp_world_init(&world, sizeof world, &scene, NULL, NULL);
            draw_both(&scene, &assets, &world);
        }
    }
}

/* The eye at the world's corners, at the surface, below it, straight down and up. */
static void the_eye_may_be_anywhere(void **state)
{
    (void)state;
    const tp_assets assets = { .boat = &boat.mesh, .layer[0] = &boat.texture[0] };
    static const tp_fx far[3] = { TP_FX(-8000), 0, TP_FX(8000) };
    static const tp_fx high[5] = { TP_FX(-100), 0, 1, TP_FX(0.3), TP_FX(2000) };
    static const tp_fx pitch[3] = { TP_FX(-89), TP_FX(3), TP_FX(89) };

    for (int n = 0; n < 135; n++) {
        tp_scene scene = scene_plain();
        tp_world world;
        scene.camera.x = far[n % 3];
        scene.camera.z = far[n / 3 % 3];
        scene.camera.y = high[n / 9 % 5];
        scene.camera.pitch = pitch[n / 45];
        scene.camera.heading = chance_fx(&chance, 0, 360);
        scene.camera.near = random_below(&chance, 2) ? TP_FX(0.05) : 10 * TP_FX_ONE;
        scene.grid.follow = n & 1;
        scene.grid.reach = 16000 * TP_FX_ONE;
        scene.boat.x = far[random_below(&chance, 3)];
        scene.boat.z = far[random_below(&chance, 3)];
        tp_world_init(&world, sizeof world, &scene, NULL, NULL);
        draw_both(&scene, &assets, &world);
    }
}

/* A mesh at the ends of what the reader takes, at every scale. */
static void a_boat_of_any_size_is_drawn(void **state)
{
    (void)state;
    static test_boat giant;
    static const tp_fx scales[] = { TP_FX(0.01), TP_FX_ONE, 3 * TP_FX_ONE,
                                    100 * TP_FX_ONE };

    boat_make(&giant, &chance);
    for (int n = 0; n < 96; n++) {
        tp_scene scene = scene_plain();
        const tp_assets assets = { .boat = &giant.mesh };
        const tp_fx side =
            n & 1 ? 16384 * TP_FX_ONE - 1 : chance_scale(&chance, 0.01, 16000);
        tp_world world;
        boat_box(&giant, side, n & 2 ? 1 : side, n & 4 ? 1 : side);
        for (int i = 0; i < 8; i++) {
            giant.vertex[i].s = i & 1 ? 16384 * TP_FX_ONE - 1 : 1 - 16384 * TP_FX_ONE;
            giant.vertex[i].t = i & 2 ? 16384 * TP_FX_ONE - 1 : 1 - 16384 * TP_FX_ONE;
        }
        scene.boat.scale = scales[n / 8 % 4];
        scene.boat.x = n & 8 ? 8000 * TP_FX_ONE : 0;
        scene.boat.z = n & 16 ? -8000 * TP_FX_ONE : 0;
        scene.camera.x = n & 32 ? -8000 * TP_FX_ONE : 0;
        scene.camera.heading = chance_fx(&chance, 0, 360);
        tp_world_init(&world, sizeof world, &scene, NULL, NULL);
        draw_both(&scene, &assets, &world);
    }
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_scene_of_the_table_is_drawn),
        cmocka_unit_test(every_row_at_its_ends_is_drawn),
        cmocka_unit_test(grids_of_any_shape_are_drawn),
        cmocka_unit_test(the_eye_may_be_anywhere),
        cmocka_unit_test(a_boat_of_any_size_is_drawn),
    };
    return cmocka_run_group_tests_name("hostile", tests, NULL, NULL);
}
