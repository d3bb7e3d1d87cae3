/* SPDX-License-Identifier: MIT */
/* The world's block: exact to the byte, its parts side by side, a snapshot by copying it,
 * refused where the scene cannot be used and refreshed where it can. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "scene/parts.h"
#include "scenes.h"

enum { SAMPLES = 24 };

static uint64_t chance;
static uint16_t sample[SAMPLES * SAMPLES];
static const tp_grey grey = { SAMPLES, SAMPLES, sample };

static tp_scene_pool some_pool(void)
{
    tp_scene s;

    tp_scene_default(&s);
    s.pool.cols = chance_int(&chance, 16, 40);
    s.pool.rows = chance_int(&chance, 16, 40);
    s.pool.cells = chance_int(&chance, 0, 2);
    s.pool.edges = chance_int(&chance, 0, 2);
    s.pool.sponge = 4;
    s.pool.poke_every = TP_FX(0.2);
    s.pool.paddle = TP_FX(0.1);
    return s.pool;
}

/* The parts by bits: floor, wind, pool, field, drops. */
static tp_scene scene_with(uint32_t parts)
{
    tp_scene s = scene_plain();

    s.floor.depth = parts & 1 ? TP_FX(6) : 0;
    s.floor.slope = TP_FX(0.02);
    s.wind.strength = parts & 2 ? TP_FX(0.05) : 0;
    if (parts & 4)
        s.pool = some_pool();
    if (parts & 8)
        s.field = some_pool();
    s.drops.count = parts & 16 ? chance_int(&chance, 1, 40) : 0;
    s.drops.rings = chance_int(&chance, 0, 40);
    s.drops.into = chance_int(&chance, 0, 1);
    s.drops.every = TP_FX(0.1);
    s.boat.wake = TP_FX(0.5);
    return s;
}

static tp_assets assets_with(tp_scene *s, bool map, bool masks)
{
    for (int i = 0; i < SAMPLES * SAMPLES; i++)
        sample[i] = (uint16_t)chance_int(&chance, 20000, 65535);
    if (map)
        strcpy(s->floor.map, "floor.png");
    return (tp_assets){ .floor = map ? &grey : NULL, .pool_mask = masks ? &grey : NULL,
                        .field_mask = masks ? &grey : NULL };
}

static tp_input input_any(void)
{
    return (tp_input){
        .ahead = chance_fx(&chance, -0.1, 0.1), .drops = chance_int(&chance, 0, 3),
        .sphere_x = chance_fx(&chance, -0.1, 0.1), .throttle = chance_fx(&chance, 0, 5),
        .poke = chance_int(&chance, 0, 9) ? 0 : TP_FX(0.3),
        .slower = chance_int(&chance, 0, 50) ? 0 : chance_int(&chance, -1, 1),
    };
}

static void run(tp_world *world, const tp_scene *scene, int ticks)
{
    for (int i = 0; i < ticks; i++) {
        const tp_input in = input_any();
        tp_world_frame(world);
        tp_world_step(world, scene, &in);
    }
}

/* -- the block ----------------------------------------------------------------------- */

/* Of these bytes exactly, full of other things: sanitizers see what lies outside. */
static void a_block_of_the_bytes_asked_for_is_enough(void **state)
{
    (void)state;
    for (uint32_t parts = 0; parts < 32; parts++) {
        tp_scene scene = scene_with(parts);
        const tp_assets assets = assets_with(&scene, parts & 1 && parts & 2, parts % 3);
        const size_t bytes = tp_world_bytes(&scene, &assets);
        tp_world *world = malloc(bytes);
        tp_error err = { .code = TP_OK };

        assert_true(bytes >= sizeof *world && bytes % 8 == 0);
        memset(world, 0xa5, bytes);
        assert_int_equal(tp_world_init(world, bytes, &scene, &assets, &err), TP_OK);
        assert_int_equal(world->parts.bytes, bytes);
        run(world, &scene, 40);
        assert_int_equal(world->tick, 40);
        assert_int_equal(tp_world_ocean(world) != NULL, (parts & 3) != 0);
        assert_int_equal(tp_world_pool(world) != NULL, (parts & 4) != 0);
        assert_int_equal(tp_world_field(world) != NULL, (parts & 8) != 0);
        assert_int_equal(tp_world_drops(world) != NULL, (parts & 16) != 0);
        free(world);
    }
}

static void a_world_without_parts_is_its_head_alone(void **state)
{
    (void)state;
    const tp_scene scene = scene_with(0);
    assert_int_equal(tp_world_bytes(&scene, NULL), sizeof(tp_world));
}

static void a_byte_less_is_no_space(void **state)
{
    (void)state;
    for (uint32_t parts = 0; parts < 32; parts++) {
        tp_scene scene = scene_with(parts);
        const tp_assets assets = assets_with(&scene, false, false);
        const size_t bytes = tp_world_bytes(&scene, &assets);
        uint8_t *block = malloc(bytes);
        tp_error err = { .code = TP_OK };

        memset(block, 0xa5, bytes);
        assert_int_equal(tp_world_init((tp_world *)(void *)block, bytes - 1, &scene,
                                       &assets, &err), TP_E_NOSPACE);
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
        const tp_scene scene = scene_with(parts);
        tp_world *world = scene_world(&scene, NULL);
        const tp_world_parts *p = &world->parts;
        const uint32_t at[] = { p->ocean, p->pool, p->field, p->drops, p->rings, p->bytes };
        uint32_t before = 0;

        /* In the order in which they were laid out, each behind the one before. */
        for (size_t i = 0; i < 6; i++) {
            assert_int_equal(at[i] % 8, 0);
            if (at[i] == 0)
                continue;
            assert_true(at[i] >= before + (before ? 8 : (uint32_t)sizeof *world)
                        || (i == 5 && at[i] >= sizeof *world));
            before = at[i];
        }
        if (p->rings) {
            assert_true(p->rings >= p->drops + tp_drops_bytes(&scene.drops));
            assert_int_equal(p->bytes, p->rings + (uint32_t)scene.drops.rings
                                       * sizeof(tp_ring_now));
        }
        if (p->pool && p->field)
            assert_true(p->field - p->pool >= tp_world_pool(world)->cols
                                              * tp_world_pool(world)->rows * 2);
        free(world);
    }
}

static void a_snapshot_goes_on_bit_for_bit(void **state)
{
    (void)state;
    for (int n = 0; n < 4; n++) {
        tp_scene scene = scene_with(31);
        scene.boat.mode = n % 2;
        const tp_assets assets = assets_with(&scene, n & 2, false);
        tp_world *world = scene_world(&scene, &assets);
        const size_t bytes = world->parts.bytes;
        run(world, &scene, 50);
        tp_world *copy = malloc(bytes);
        memcpy(copy, world, bytes);
        const uint64_t same = chance;
        run(world, &scene, 50);
        chance = same;
        run(copy, &scene, 50);
        assert_memory_equal(copy, world, bytes);
        free(copy);
        free(world);
    }
}

static void the_same_scene_runs_the_same_in_any_memory(void **state)
{
    (void)state;
    const tp_scene scene = scene_with(31);
    const size_t bytes = tp_world_bytes(&scene, NULL);
    tp_world *a = malloc(bytes), *b = malloc(bytes);

    memset(a, 0xff, bytes);
    memset(b, 0, bytes);
    assert_int_equal(tp_world_init(a, bytes, &scene, NULL, NULL), TP_OK);
    assert_int_equal(tp_world_init(b, bytes, &scene, NULL, NULL), TP_OK);
    const uint64_t same = chance;
    run(a, &scene, 60);
    chance = same;
    run(b, &scene, 60);
    assert_memory_equal(a, b, bytes);
    free(a);
    free(b);
}

/* -- what cannot be used --------------------------------------------------------------- */

static void refuses(const tp_scene *scene, const tp_assets *assets, tp_status status)
{
    static uint64_t block[1 << 17];
    tp_error err = { .code = TP_OK };

    assert_int_equal(tp_world_bytes(scene, assets), 0);
    assert_int_equal(tp_world_init((tp_world *)(void *)block, sizeof block, scene, assets,
                                   &err), status);
    assert_int_equal(err.code, status);
}

static void a_bad_pool_gives_its_status(void **state)
{
    (void)state;
    static const tp_grey empty = { 0, 5, sample };
    const tp_assets masked = { .pool_mask = &empty, .field_mask = &empty };

    for (int n = 0; n < 2; n++) {
        tp_scene good = scene_with(12), bad = good;
        tp_scene_pool *pool = n ? &bad.field : &bad.pool;
        const tp_scene_pool kept = *pool;
        pool->cols = 15;
        refuses(&bad, NULL, TP_E_POOL_SIZE);
        pool->cols = -1;
        refuses(&bad, NULL, TP_E_POOL_SIZE);
        *pool = kept;
        pool->courant = TP_FX(0.8);
        refuses(&bad, NULL, TP_E_POOL_COURANT);
        *pool = kept;
        pool->cells = 3;
        refuses(&bad, NULL, TP_E_POOL_RANGE);
        *pool = kept;
        pool->feed_low = TP_FX_ONE;
        pool->feed_high = 0;
        refuses(&bad, NULL, TP_E_POOL_RANGE);
        assert_true(tp_world_bytes(&good, NULL) > 0);
        refuses(&good, &masked, TP_E_POOL_MASK);
    }
}

static void a_bad_picture_of_the_floor_is_refused(void **state)
{
    (void)state;
    static const tp_grey bad[] = { { 0, 8, sample }, { 8, 0, sample }, { 4097, 8, sample } };
    tp_scene scene = scene_with(0);

    strcpy(scene.floor.map, "floor.png");
    for (int i = 0; i < 3; i++) {
        const tp_assets assets = { .floor = &bad[i] };
        refuses(&scene, &assets, TP_E_ARG);
    }
}

/* -- refresh --------------------------------------------------------------------------- */

static void a_refresh_of_the_same_scene_changes_nothing(void **state)
{
    (void)state;
    tp_scene scene = scene_with(31);
    scene.boat.mesh[0] = '\0';          /* a boat is laid anew */
    tp_world *world = scene_world(&scene, NULL);
    const size_t bytes = world->parts.bytes;
    run(world, &scene, 30);
    tp_world *copy = malloc(bytes);
    memcpy(copy, world, bytes);

    assert_true(tp_world_refresh(world, &scene, NULL));
    assert_memory_equal(copy, world, bytes);
    free(copy);
    free(world);
}

/* Changes a number and tells whether the refresh was done; if not, that nothing was. */
static bool refreshes(tp_scene scene, int32_t *(*number)(tp_scene *), int32_t value)
{
    tp_world *world = scene_world(&scene, NULL);
    const size_t bytes = world->parts.bytes;
    run(world, &scene, 10);
    tp_world *copy = malloc(bytes);
    memcpy(copy, world, bytes);
    scene.wave[0].amplitude += 999;
    *number(&scene) = value;
    const bool done = tp_world_refresh(world, &scene, NULL);
    if (done)
        run(world, &scene, 10);
    else
        assert_memory_equal(copy, world, bytes);
    free(copy);
    free(world);
    return done;
}

#define NUMBER(name, member) \
    static int32_t *name(tp_scene *s) { return (int32_t *)&s->member; }
NUMBER(pool_cols, pool.cols) NUMBER(pool_cells, pool.cells) NUMBER(pool_cell, pool.cell)
NUMBER(pool_range, pool.range) NUMBER(pool_edges, pool.edges) NUMBER(field_cell, field.cell)
NUMBER(field_rows, field.rows) NUMBER(drops_count, drops.count)
NUMBER(drops_rings, drops.rings) NUMBER(drops_into, drops.into)
NUMBER(floor_depth, floor.depth) NUMBER(wind, wind.strength)
NUMBER(pool_courant, pool.courant) NUMBER(pool_damping, pool.damping)
NUMBER(pool_x, pool.x) NUMBER(pool_feed, pool.feed) NUMBER(pool_poke, pool.poke)
NUMBER(pool_paddle, pool.paddle) NUMBER(field_courant, field.courant)
NUMBER(wave_amplitude, wave[1].amplitude) NUMBER(wave_count, wave[7].amplitude)
NUMBER(floor_slope, floor.slope) NUMBER(drops_radius, drops.radius)
NUMBER(scale, clock.scale)
#undef NUMBER

static tp_scene scene_full(void)
{
    tp_scene s = scene_with(31);

    s.pool.cells = s.field.cells = TP_CELLS_16;
    s.pool.edges = s.field.edges = TP_EDGES_WALL;
    s.pool.cols = s.pool.rows = s.field.cols = s.field.rows = 32;
    s.wind.strength = 0;
    s.drops.rings = 20;
    s.drops.into = TP_DROPS_RINGS;
    return s;
}

static void what_sizes_the_block_asks_for_a_new_world(void **state)
{
    (void)state;
    const tp_scene s = scene_full();

    assert_false(refreshes(s, pool_cols, 40));
    assert_false(refreshes(s, pool_cols, 0));
    assert_false(refreshes(s, pool_cells, TP_CELLS_8));
    assert_false(refreshes(s, pool_edges, TP_EDGES_TILE));
    assert_false(refreshes(s, field_rows, 33));
    assert_false(refreshes(s, drops_count, s.drops.count + 1));
    assert_false(refreshes(s, drops_rings, 21));
    assert_false(refreshes(s, drops_into, TP_DROPS_POOL));
    assert_false(refreshes(s, floor_depth, 0));
    assert_false(refreshes(s, wave_count, TP_FX(0.1)));     /* the ocean has a table more */
}

static void what_cannot_be_tuned_asks_for_a_new_world(void **state)
{
    (void)state;
    tp_scene s = scene_full();

    assert_false(refreshes(s, pool_cell, s.pool.cell + 1));
    assert_false(refreshes(s, field_cell, s.field.cell + 1));
    assert_false(refreshes(s, pool_range, s.pool.range + 1));
    assert_false(refreshes(s, pool_courant, TP_FX(0.7)));
    assert_false(refreshes(s, field_courant, TP_FX(0.7)));
    s.field.cols = 64;                  /* as many cells in another shape */
    s.field.rows = 16;
    tp_world *world = scene_world(&s, NULL);
    s.field.cols = 16;
    s.field.rows = 64;
    assert_false(tp_world_refresh(world, &s, NULL));
    free(world);
}

static void what_may_change_is_taken(void **state)
{
    (void)state;
    const tp_scene s = scene_full();

    assert_true(refreshes(s, wave_amplitude, TP_FX(0.3)));
    assert_true(refreshes(s, floor_depth, TP_FX(3)));
    assert_true(refreshes(s, floor_slope, TP_FX(0.1)));
    assert_true(refreshes(s, wind, TP_FX(0.2)));
    assert_true(refreshes(s, pool_courant, TP_FX(0.3)));
    assert_true(refreshes(s, pool_damping, 10));
    assert_true(refreshes(s, pool_x, 5 * TP_FX_ONE));
    assert_true(refreshes(s, pool_feed, TP_FX(0.3)));
    assert_true(refreshes(s, pool_poke, TP_FX(0.3)));
    assert_true(refreshes(s, pool_paddle, TP_FX(0.3)));
    assert_true(refreshes(s, drops_radius, TP_FX(0.2)));
    assert_true(refreshes(s, scale, TP_FX_ONE / 4));
}

/* -- pokes ----------------------------------------------------------------------------- */

/* Ticks at which the flat pool without paddle is stirred, by its random numbers. */
static void pokes_come_as_often_as_the_scene_says(void **state)
{
    (void)state;
    tp_scene scene = scene_with(4);
    scene.boat.mesh[0] = '\0';
    scene.pool.paddle = 0;
    scene.pool.poke_every = TP_FX(0.5);
    tp_world *world = scene_world(&scene, NULL);
    uint32_t pokes = 0, random = world->random;

    for (int i = 0; i < 600; i++) {
        tp_world_step(world, &scene, NULL);
        pokes += world->random != random;
        random = world->random;
    }
    assert_int_equal(pokes, 20);
    scene.pool.poke_every = 600 * TP_FX_ONE;
    for (int i = 0; i < 40; i++)
        tp_world_step(world, &scene, NULL);
    scene.pool.poke_every = TP_FX(0.1);     /* the long wait is not sat out */
    random = world->random;
    for (int i = 0; i < 7; i++)
        tp_world_step(world, &scene, NULL);
    assert_int_not_equal(world->random, random);
    free(world);
}

static void the_surface_names_every_part(void **state)
{
    (void)state;
    const tp_scene scene = scene_with(29);
    tp_world *world = scene_world(&scene, NULL);
    run(world, &scene, 60);
    const tp_surface s = tp_world_surface(world);

    assert_ptr_equal(s.ocean, tp_world_ocean(world));
    assert_ptr_equal(s.pool, tp_world_pool(world));
    assert_ptr_equal(s.field, tp_world_field(world));
    assert_ptr_equal(s.phases, world->phases);
    assert_int_equal(s.rings, world->rings);
    for (int n = 0; n < 50; n++) {
        const tp_fx x = chance_fx(&chance, -20, 20), z = chance_fx(&chance, -20, 20);
        const tp_sea_point a = tp_world_above(world, x, z);
        const tp_sea_point b = tp_surface_above(&s, x, z, NULL);
        assert_memory_equal(&a, &b, sizeof a);
    }
    free(world);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_block_of_the_bytes_asked_for_is_enough),
        cmocka_unit_test(a_world_without_parts_is_its_head_alone),
        cmocka_unit_test(a_byte_less_is_no_space),
        cmocka_unit_test(parts_are_aligned_and_lie_side_by_side),
        cmocka_unit_test(a_snapshot_goes_on_bit_for_bit),
        cmocka_unit_test(the_same_scene_runs_the_same_in_any_memory),
        cmocka_unit_test(a_bad_pool_gives_its_status),
        cmocka_unit_test(a_bad_picture_of_the_floor_is_refused),
        cmocka_unit_test(a_refresh_of_the_same_scene_changes_nothing),
        cmocka_unit_test(what_sizes_the_block_asks_for_a_new_world),
        cmocka_unit_test(what_cannot_be_tuned_asks_for_a_new_world),
        cmocka_unit_test(what_may_change_is_taken),
        cmocka_unit_test(pokes_come_as_often_as_the_scene_says),
        cmocka_unit_test(the_surface_names_every_part),
    };
    return cmocka_run_group_tests_name("parts", tests, NULL, NULL);
}
