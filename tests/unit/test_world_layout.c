/* SPDX-License-Identifier: MIT */
/* The world's block: exact to the byte, its buffers side by side, snapshots by copying, and
 * a refusal for an invalid scene. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/drops/drops.h"
#include "tests/lib/worlds.h"
#include "world/pools.h"

static uint64_t chance;

/* -- the block --------------------------------------------------------------------- */

/* A block of exactly these bytes, full of other data: sanitizers see any access outside. */
static void a_block_of_the_bytes_asked_for_is_enough(void **state)
{
    (void)state;
    for (uint32_t parts = 0; parts < 32; parts++) {
        tp_scene scene = scene_with(&chance, parts);
        const tp_assets assets = assets_with(&chance, &scene, parts & 1 && parts & 2,
                                             parts % 3);
        const size_t bytes = tp_world_bytes(&tp_program_all, &scene, &assets);
        tp_world *world = malloc(bytes);
        tp_error err = { .code = TP_OK };

        assert_true(bytes >= sizeof *world && bytes % 8 == 0);
        memset(world, 0xa5, bytes);
        assert_int_equal(
            tp_world_init(&tp_program_all, world, bytes, &scene, &assets, &err), TP_OK);
        assert_int_equal(world->layout.bytes, bytes);
        run(&chance, world, &scene, 40);
        assert_int_equal(world->tick, 40);
        assert_int_equal(tp_world_coastal(world) != NULL, (parts & 3) != 0);
        assert_int_equal(tp_world_pool(world) != NULL, (parts & 4) != 0);
        assert_int_equal(tp_world_field(world) != NULL, (parts & 8) != 0);
        assert_int_equal(tp_world_drops(world) != NULL, (parts & 16) != 0);
        free(world);
    }
}

static void a_world_without_parts_is_its_head_alone(void **state)
{
    (void)state;
    const tp_scene scene = scene_with(&chance, 0);
    assert_int_equal(tp_world_bytes(&tp_program_all, &scene, NULL), sizeof(tp_world));
}

/* With tp_water_few_swells a world ends after its scene's swells and moves as with all
 * swells; a change of their number needs another world.  A program without swells keeps no
 * swell. */
static void a_world_ends_after_the_swells_of_its_program(void **state)
{
    const size_t head = offsetof(tp_world, deep.swell);
    tp_scene scene = scene_with(&chance, 0);
    tp_program few = tp_program_all, none = tp_program_all;
    (void)state;

    few.water.swells = &tp_water_few_swells;
    none.water.swells = NULL;
    for (int n = 0; n <= TP_WAVES; n++) {
        for (int i = 0; i < TP_WAVES; i++)
            scene.wave[i].amplitude = i < n ? chance_fx(&chance, 0.01, 0.2) : 0;
        const size_t bytes = head + (size_t)n * sizeof(tp_swell);
        assert_int_equal(tp_world_bytes(&none, &scene, NULL), head);
        assert_int_equal(tp_world_bytes(&few, &scene, NULL), bytes);
        tp_world *a = malloc(bytes), b;         /* exact size */
        assert_int_equal(tp_world_init(&few, a, bytes, &scene, NULL, NULL), TP_OK);
        assert_int_equal(tp_world_init(&tp_program_all, &b, sizeof b, &scene, NULL, NULL),
                         TP_OK);
        tp_world_step(&few, a, &scene, NULL);
        tp_world_step(&tp_program_all, &b, &scene, NULL);
        assert_int_equal(a->deep.count, n);
        assert_memory_equal(a->phases, b.phases, sizeof b.phases);
        const tp_water at = tp_world_sample(&few, a, TP_FX_ONE, TP_FX_ONE);
        const tp_water want = tp_world_sample(&tp_program_all, &b, TP_FX_ONE, TP_FX_ONE);
        assert_memory_equal(&at, &want, sizeof at);
        assert_true(tp_world_apply(&few, a, &scene, NULL));
        scene.wave[n < TP_WAVES ? n : 0].amplitude = n < TP_WAVES ? TP_FX(0.1) : 0;
        assert_false(tp_world_apply(&few, a, &scene, NULL));
        free(a);
    }
}

static void a_byte_less_is_no_space(void **state)
{
    (void)state;
    for (uint32_t parts = 0; parts < 32; parts++) {
        tp_scene scene = scene_with(&chance, parts);
        const tp_assets assets = assets_with(&chance, &scene, false, false);
        const size_t bytes = tp_world_bytes(&tp_program_all, &scene, &assets);
        uint8_t *block = malloc(bytes);
        tp_error err = { .code = TP_OK };

        memset(block, 0xa5, bytes);
        assert_int_equal(tp_world_init(&tp_program_all, (tp_world *)(void *)block,
                                       bytes - 1, &scene, &assets, &err),
                         TP_E_NOSPACE);
        assert_int_equal(err.a, bytes);
        assert_int_equal(err.b, bytes - 1);
        for (size_t i = 0; i < bytes; i++)
            assert_int_equal(block[i], 0xa5);
        free(block);
    }
}

static void parts_are_aligned_and_lie_side_by_side(void **state)
{
    (void)state;
    for (uint32_t parts = 0; parts < 32; parts++) {
        const tp_scene scene = scene_with(&chance, parts);
        tp_world *world = scene_world(&scene, NULL);
        const tp_world_layout *p = &world->layout;
        const uint32_t at[] = { p->modules, p->bytes };
        uint32_t before = 0;

        /* Buffers are in the order of the layout, each behind the preceding buffer. */
        for (size_t i = 0; i < 2; i++) {
            assert_int_equal(at[i] % 8, 0);
            if (at[i] == 0)
                continue;
            assert_true(at[i] >= before + (before ? 8 : (uint32_t)sizeof *world)
                        || (i == 1 && at[i] >= sizeof *world));
            before = at[i];
        }
        const char *pool = (const char *)tp_world_pool(world);
        if (pool)
            assert_int_equal((pool - (const char *)world) % 8, 0);
        if (pool && tp_world_field(world))
            assert_true((const char *)tp_world_field(world) - pool
                        >= tp_world_pool(world)->cols * tp_world_pool(world)->rows * 2);
        free(world);
    }
}

static void a_snapshot_goes_on_bit_for_bit(void **state)
{
    (void)state;
    for (int n = 0; n < 4; n++) {
        tp_scene scene = scene_with(&chance, 31);
        scene.boat.mode = n % 2;
        const tp_assets assets = assets_with(&chance, &scene, n & 2, false);
        tp_world *world = scene_world(&scene, &assets);
        const size_t bytes = world->layout.bytes;
        run(&chance, world, &scene, 50);
        tp_world *copy = malloc(bytes);
        memcpy(copy, world, bytes);
        const uint64_t same = chance;
        run(&chance, world, &scene, 50);
        chance = same;
        run(&chance, copy, &scene, 50);
        assert_memory_equal(copy, world, bytes);
        free(copy);
        free(world);
    }
}

static void the_same_scene_runs_the_same_in_any_memory(void **state)
{
    (void)state;
    const tp_scene scene = scene_with(&chance, 31);
    const size_t bytes = tp_world_bytes(&tp_program_all, &scene, NULL);
    tp_world *a = malloc(bytes), *b = malloc(bytes);

    memset(a, 0xff, bytes);
    memset(b, 0, bytes);
    assert_int_equal(tp_world_init(&tp_program_all, a, bytes, &scene, NULL, NULL), TP_OK);
    assert_int_equal(tp_world_init(&tp_program_all, b, bytes, &scene, NULL, NULL), TP_OK);
    const uint64_t same = chance;
    run(&chance, a, &scene, 60);
    chance = same;
    run(&chance, b, &scene, 60);
    assert_memory_equal(a, b, bytes);
    free(a);
    free(b);
}

/* -- refused scenes ---------------------------------------------------------------- */

/* Asserts the refusal; `word` is the wrong parameter, or "". */
static void refuses(const tp_scene *scene, const tp_assets *assets, tp_status status,
                    const char *word)
{
    static uint64_t block[1 << 17];
    tp_error err = { .code = TP_OK };

    assert_int_equal(tp_world_bytes(&tp_program_all, scene, assets), 0);
    assert_int_equal(tp_world_init(&tp_program_all, (tp_world *)(void *)block,
                                   sizeof block, scene, assets, &err),
                     status);
    assert_int_equal(err.code, status);
    assert_string_equal(err.word, word);
}

static void a_bad_pool_gives_its_status(void **state)
{
    (void)state;
    static const tp_grey empty = { 0, 5, sample };
    const tp_assets masked = { .pool_mask = &empty, .field_mask = &empty };

    for (int n = 0; n < 2; n++) {
        tp_scene good = scene_with(&chance, 12), bad = good;
        tp_scene_pool *pool = n ? &bad.field : &bad.pool;
        const tp_scene_pool kept = *pool;
        pool->cols = 15;
        refuses(&bad, NULL, TP_E_POOL_SIZE, n ? "field.cols" : "pool.cols");
        pool->cols = -1;
        refuses(&bad, NULL, TP_E_RANGE, n ? "field.cols" : "pool.cols");
        *pool = kept;
        pool->rows = 513;
        refuses(&bad, NULL, TP_E_RANGE, n ? "field.rows" : "pool.rows");
        *pool = kept;
        pool->courant = TP_FX(0.8);
        refuses(&bad, NULL, TP_E_POOL_COURANT, n ? "field.courant" : "pool.courant");
        *pool = kept;
        pool->cell_bits = 3;
        refuses(&bad, NULL, TP_E_RANGE, n ? "field.cell_bits" : "pool.cell_bits");
        *pool = kept;
        pool->drive_min = TP_FX_ONE;
        pool->drive_max = 0;
        refuses(&bad, NULL, TP_E_POOL_FEED, n ? "field.drive_min" : "pool.drive_min");
        assert_true(tp_world_bytes(&tp_program_all, &good, NULL) > 0);
        refuses(&good, &masked, TP_E_POOL_MASK, "pool.mask");
    }
}

static void a_bad_picture_of_the_floor_is_refused(void **state)
{
    (void)state;
    static const tp_grey bad[] = { { 0, 8, sample }, { 8, 0, sample },
                                   { 4097, 8, sample } };
    tp_scene scene = scene_with(&chance, 0);

    strcpy(scene.floor.map, "floor.png");
    for (int i = 0; i < 3; i++) {
        const tp_assets assets = { .floor = &bad[i] };
        refuses(&scene, &assets, TP_E_ARG, "floor.map");
    }
}

/* -- pokes ------------------------------------------------------------------------- */

/* Counts the ticks at which a flat pool without paddle is stirred, by its random
 * numbers. */
static void pokes_come_as_often_as_the_scene_says(void **state)
{
    (void)state;
    tp_scene scene = scene_with(&chance, 4);
    scene.boat.mesh[0] = '\0';
    scene.pool.paddle = 0;
    scene.pool.splash_interval = TP_FX(0.5);
    tp_world *world = scene_world(&scene, NULL);
    uint32_t pokes = 0, random = world->random;

    for (int i = 0; i < 600; i++) {
        tp_world_step(&tp_program_all, world, &scene, NULL);
        pokes += world->random != random;
        random = world->random;
    }
    assert_int_equal(pokes, 20);
    scene.pool.splash_interval = 600 * TP_FX_ONE;
    for (int i = 0; i < 40; i++)
        tp_world_step(&tp_program_all, world, &scene, NULL);
    scene.pool.splash_interval = TP_FX(0.1);     /* the long interval is not simulated */
    random = world->random;
    for (int i = 0; i < 7; i++)
        tp_world_step(&tp_program_all, world, &scene, NULL);
    assert_int_not_equal(world->random, random);
    free(world);
}

/* Tables in a block of exactly their bytes, which the caller frees. */
static tp_coastal_water *copy_tables(const tp_world *world)
{
    const tp_coastal_water *coastal = tp_world_coastal(world);
    const size_t bytes = tp_coastal_table_bytes(coastal);
    tp_coastal_water *copy = malloc(bytes);

    memcpy(copy, coastal, bytes);
    return copy;
}

/* A world with baked tables is smaller by its own, and runs the same; other numbers need a
 * world with tables of its own. */
static void baked_tables_of_coastal_water_take_no_memory(void **state)
{
    (void)state;
    for (uint32_t parts = 1; parts < 32; parts++) {
        tp_scene scene = scene_with(&chance, parts);
        tp_assets assets = assets_with(&chance, &scene, parts & 1 && parts & 2, parts % 3);
        const size_t bytes = tp_world_bytes(&tp_program_all, &scene, &assets);
        if (!(parts & 3))
            continue;
        tp_world *own = scene_world(&scene, &assets);
        assets.coastal = copy_tables(own);
        const size_t tables = tp_module_state_bytes(tp_world_coastal(own));
        assert_int_equal(tp_world_bytes(&tp_program_all, &scene, &assets),
                         bytes - tables + sizeof(uint64_t));
        tp_world *baked = scene_world(&scene, &assets);
        assert_ptr_equal(tp_world_coastal(baked), assets.coastal);
        for (int i = 0; i < 40; i++) {
            tp_world_step(&tp_program_all, own, &scene, NULL);
            tp_world_step(&tp_program_all, baked, &scene, NULL);
            const tp_fx x = chance_fx(&chance, -90, 90), z = chance_fx(&chance, -90, 90);
            const tp_water a = tp_world_sample(&tp_program_all, own, x, z);
            const tp_water b = tp_world_sample(&tp_program_all, baked, x, z);
            assert_memory_equal(&a, &b, sizeof a);
        }
        assert_true(tp_world_apply(&tp_program_all, baked, &scene, &assets));
        scene.wave[0].length += TP_FX_ONE;
        assert_int_equal(tp_world_bytes(&tp_program_all, &scene, &assets), bytes);
        assert_false(tp_world_apply(&tp_program_all, baked, &scene, &assets));
        free(own);
        free(baked);
        free((void *)(uintptr_t)assets.coastal);
    }
}

static void the_surface_names_every_part(void **state)
{
    (void)state;
    tp_scene scene = scene_with(&chance, 29);
    scene.drops.target = TP_DROPS_RINGS;
    scene.drops.rings = 40;
    tp_world *world = scene_world(&scene, NULL);
    run(&chance, world, &scene, 60);
    const tp_surface s = tp_world_surface(&tp_program_all, world);

    assert_ptr_equal(s.coastal, tp_world_coastal(world));
    assert_ptr_equal(s.pool, tp_world_pool(world));
    assert_ptr_equal(s.field, tp_world_field(world));
    assert_ptr_equal(s.phases, world->phases);
    const tp_drops *drops = tp_world_drops(world);
    int64_t now = (int64_t)(world->tick * TP_FX_ONE);
    uint32_t rings = 0;
    for (uint32_t i = 0; i < drops->rings; i++) {
        tp_ring_now at;
        if (tp_ring_evaluate(&tp_drops_rings(drops)[i], now, &at))
            assert_memory_equal(&at, &s.ring[rings++], sizeof at);
    }
    assert_int_equal(s.rings, rings);
    for (int n = 0; n < 50; n++) {
        const tp_fx x = chance_fx(&chance, -20, 20), z = chance_fx(&chance, -20, 20);
        const tp_water a = tp_world_sample(&tp_program_all, world, x, z);
        const tp_surface_point b = tp_surface_sample(&s, x, z, NULL);
        assert_int_equal(a.height, b.position.y);
        assert_int_equal(a.slope_x, b.slope_x);
        assert_int_equal(a.slope_z, b.slope_z);
    }
    free(world);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_block_of_the_bytes_asked_for_is_enough),
        cmocka_unit_test(a_world_without_parts_is_its_head_alone),
        cmocka_unit_test(a_world_ends_after_the_swells_of_its_program),
        cmocka_unit_test(a_byte_less_is_no_space),
        cmocka_unit_test(parts_are_aligned_and_lie_side_by_side),
        cmocka_unit_test(a_snapshot_goes_on_bit_for_bit),
        cmocka_unit_test(the_same_scene_runs_the_same_in_any_memory),
        cmocka_unit_test(a_bad_pool_gives_its_status),
        cmocka_unit_test(a_bad_picture_of_the_floor_is_refused),
        cmocka_unit_test(pokes_come_as_often_as_the_scene_says),
        cmocka_unit_test(baked_tables_of_coastal_water_take_no_memory),
        cmocka_unit_test(the_surface_names_every_part),
    };
    return cmocka_run_group_tests_name("world/layout", tests, NULL, NULL);
}
