/* SPDX-License-Identifier: MIT */
/* Tables of a frame as constants: the same picture without their memory and their makers;
 * other numbers, or a missing maker, are counted and named.  Then other parts that a
 * program may lack. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/frame.h"
#include "tests/lib/frames.h"
#include "tests/lib/scenes.h"

enum { W = 64, H = 48, TABLE_BYTES = 1 << 16 };

static uint64_t chance;
static test_kit kit;

/* A program that makes no table. */
static tp_program without_makers(void)
{
    tp_program own = tp_program_all;

    own.draw.shine = NULL;
    own.draw.tones = NULL;
    own.draw.dome = NULL;
    own.draw.light = NULL;
    own.draw.ripple_sums = NULL;
    own.draw.cube_map = NULL;
    own.draw.grid_rows = NULL;
    return own;
}

static tp_scene scene_of_tables(void)
{
    tp_scene scene;

    tp_scene_level(&scene);
    scene.sky.kind = TP_SKY_DAY;
    scene.sky.sun = TP_FX_ONE;
    scene.hdr.exposure = TP_EXPOSURE_FIXED;
    scene.hdr.exposure_factor = 2 * TP_FX_ONE;
    scene.light.model = TP_LIGHT_BLINN;
    scene.water.specular = TP_FX_ONE / 2;
    scene.water.rough = 1;
    scene.ripple.bump = TP_FX_ONE;
    scene.quality.shading = TP_SHADING_QUICK;
    scene.quality.visibility = TP_VISIBILITY_TRIANGLES;
    scene.wave[0].amplitude = TP_FX_ONE / 4;
    scene.wave[0].length = 8 * TP_FX_ONE;
    scene.camera.y = 20 * TP_FX_ONE;        /* above all crests */
    return scene;
}

static tp_assets assets_of_tables(void)
{
    return (tp_assets){ .layer[0] = &kit.picture[0], .ripple = &kit.picture[1] };
}

/* -- drawing ------------------------------------------------------------------------- */

typedef struct {
    uint32_t   crc, dropped;
    size_t     table_bytes;
    const char *lacks;
} picture;

/* Draws a picture.  tables: receives those of the frame, in `memory`; or NULL. */
static picture draw_by(const tp_program *by, const tp_scene *scene, const tp_assets *assets,
                       tp_tables *tables, int32_t *memory)
{
    const tp_config config = { .width = W, .height = H, .tile_height = H,
                               .format = TP_FORMAT_XRGB8888 };
    test_frame f = frame_by(by, scene, assets, &config);
    tp_world *world = scene_world(scene, assets);
    tp_tile tile;

    tp_frame_begin(f.frame, world);
    tp_frame_draw_tile(f.frame, 0, f.scratch, &tile);
    const picture p = { tp_crc32(0, tile.pixels, W * H * sizeof(uint32_t)),
                        tp_frame_stats(f.frame).dropped, tp_frame_ram(f.frame).tables,
                        tp_frame_lacks(f.frame) };
    for (int id = 0; tables && id < TP_TABLE_COUNT; id++) {
        size_t bytes;
        if (id == TP_TABLE_rows) {
            uint32_t count;
            tp_frame_pack_rows(f.frame, memory, memory + 32, &count);
            assert_in_range(count, 1, TABLE_BYTES / sizeof *memory - 32);
            tables->table[id] = (tp_table){ memory + 32, memory };
            continue;
        }
        const tp_table own = tp_frame_own_table(f.frame, (tp_table_id)id, &bytes);
        assert_non_null(own.entries);
        assert_true(bytes + 128 < TABLE_BYTES);
        memcpy(memory, own.made_of, 128);
        memcpy(memory + 32, own.entries, bytes);
        tables->table[id] = (tp_table){ memory + 32, memory };
        memory += TABLE_BYTES / sizeof *memory;
    }
    frame_free(&f);
    free(world);
    return p;
}

static int32_t memory[TP_TABLE_COUNT * TABLE_BYTES / sizeof(int32_t)];

/* -- tables -------------------------------------------------------------------------- */

static void baked_tables_draw_the_same_without_memory_and_makers(void **state)
{
    const tp_program least = without_makers();
    const tp_scene scene = scene_of_tables();
    tp_assets assets = assets_of_tables();
    tp_tables tables;

    (void)state;
    const picture all = draw_by(&tp_program_all, &scene, &assets, &tables, memory);
    assert_int_equal(all.dropped, 0);
    assets.tables = &tables;
    const picture baked = draw_by(&least, &scene, &assets, NULL, NULL);
    assert_int_equal(baked.crc, all.crc);
    assert_int_equal(baked.dropped, 0);
    assert_null(baked.lacks);
    const size_t entries = TP_SHINE * sizeof(tp_entry16) + 768 * sizeof(tp_entry8)
                   + sizeof(tp_dome) + TP_SKY * sizeof(uint32_t);
    assert_true(baked.table_bytes + entries < all.table_bytes);
}

static void a_number_that_is_not_the_tables_is_counted_and_named(void **state)
{
    static const struct {
        size_t      at;
        const char *lacks;
    } changes[] = {
        { offsetof(tp_scene, water.shininess), "glint" },
        { offsetof(tp_scene, hdr.exposure_factor), "exposure" },
        { offsetof(tp_scene, light.colour), "sky_dome" },
        { offsetof(tp_scene, sky.zenith), "sky" },
        { offsetof(tp_scene, water.reflection), "fast water" },
        { offsetof(tp_scene, camera.y), "grid_rows" },
    };
    tp_assets assets = assets_of_tables();
    tp_scene scene = scene_of_tables();
    tp_tables tables;

    (void)state;
    draw_by(&tp_program_all, &scene, &assets, &tables, memory);
    assets.tables = &tables;
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        scene = scene_of_tables();
        int32_t *number = (int32_t *)(void *)((char *)&scene + changes[i].at);
        *number -= *number / 2 + 1;
        const picture p = draw_by(&tp_program_all, &scene, &assets, NULL, NULL);
        assert_in_range(p.dropped, 1, 3);
        assert_string_equal(p.lacks, changes[i].lacks);
    }
}

static void a_table_without_its_maker_is_counted_and_named(void **state)
{
    const tp_program least = without_makers();
    const tp_scene scene = scene_of_tables();
    const tp_assets assets = assets_of_tables();

    (void)state;
    const picture p = draw_by(&least, &scene, &assets, NULL, NULL);
    assert_int_equal(p.dropped, TP_TABLE_COUNT - 1);    /* all but the gradient */
    assert_string_equal(p.lacks, "ripple");
}

/* -- other parts --------------------------------------------------------------------- */

static void water_without_cells_is_counted_and_named(void **state)
{
    tp_program own = tp_program_all;
    const tp_scene scene = scene_of_tables();
    const tp_assets assets = assets_of_tables();

    (void)state;
    own.draw.cells = NULL;
    const picture p = draw_by(&own, &scene, &assets, NULL, NULL);
    assert_int_equal(p.dropped, 1);
    assert_string_equal(p.lacks, "cells");
}

static void a_hull_on_swells_without_samples_is_counted_and_named(void **state)
{
    tp_program own = tp_program_all;
    tp_scene scene = scene_of_tables();
    const tp_assets assets = assets_of_tables();

    (void)state;
    scene.water.clarity = 0;
    own.water.samples = NULL;
    assert_int_equal(draw_by(&own, &scene, &assets, NULL, NULL).dropped, 0);
    strcpy(scene.boat.mesh, "boat.obj");
    const tp_assets with_boat = { .boat = &kit.boat.mesh, .layer[0] = &kit.picture[0],
                                  .ripple = &kit.picture[1] };
    const picture p = draw_by(&own, &scene, &with_boat, NULL, NULL);
    assert_int_equal(p.dropped, 1);
    assert_string_equal(p.lacks, "samples");
    own.water.samples = tp_program_all.water.samples;
    assert_int_equal(draw_by(&own, &scene, &with_boat, NULL, NULL).dropped, 0);
}

static void an_input_without_steering_is_told(void **state)
{
    static const size_t members[] = {
        offsetof(tp_input, forward), offsetof(tp_input, strafe), offsetof(tp_input, up),
        offsetof(tp_input, turn), offsetof(tp_input, tilt), offsetof(tp_input, slowdown),
    };
    tp_program own = tp_program_all;
    const tp_scene scene = scene_of_tables();
    tp_world *world = scene_world(&scene, NULL);
    const tp_input drops = { .drops = 1, .throttle = 1, .light_turn = 1 };

    (void)state;
    own.steering = NULL;
    assert_null(tp_world_step(&own, world, &scene, NULL));
    assert_null(tp_world_step(&own, world, &scene, &drops));
    for (size_t i = 0; i < sizeof members / sizeof *members; i++) {
        tp_input input = { .drops = 0 };
        *(int32_t *)(void *)((char *)&input + members[i]) = -1;
        assert_string_equal(tp_world_step(&own, world, &scene, &input), "steering");
        assert_null(tp_world_step(&tp_program_all, world, &scene, &input));
    }
    free(world);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(baked_tables_draw_the_same_without_memory_and_makers),
        cmocka_unit_test(a_number_that_is_not_the_tables_is_counted_and_named),
        cmocka_unit_test(a_table_without_its_maker_is_counted_and_named),
        cmocka_unit_test(water_without_cells_is_counted_and_named),
        cmocka_unit_test(a_hull_on_swells_without_samples_is_counted_and_named),
        cmocka_unit_test(an_input_without_steering_is_told),
    };
    chance = random_seed();
    kit_make(&kit, &chance);
    return cmocka_run_group_tests_name("frame/tables", tests, NULL, NULL);
}
