/* SPDX-License-Identifier: MIT */
/* A world under changes of its scene: changes applied while the world moves, and changes
 * that need a new world. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/exposure/exposure.h"
#include "tests/lib/worlds.h"
#include "waves/coastal_tables.h"

static uint64_t chance;

/* -- refresh ----------------------------------------------------------------------- */

static void a_refresh_of_the_same_scene_changes_nothing(void **state)
{
    (void)state;
    tp_scene scene = scene_with(&chance, 31);
    scene.boat.mesh[0] = '\0';          /* a boat is placed anew */
    tp_world *world = scene_world(&scene, NULL);
    const size_t bytes = world->layout.bytes;
    run(&chance, world, &scene, 30);
    tp_world *copy = malloc(bytes);
    memcpy(copy, world, bytes);

    assert_true(tp_world_apply(&tp_program_all, world, &scene, NULL));
    assert_memory_equal(copy, world, bytes);
    free(copy);
    free(world);
}

/* Changes a number.  True if the refresh was done; otherwise asserts that nothing has
 * changed. */
static bool refreshes(tp_scene scene, int32_t *(*number)(tp_scene *), int32_t value)
{
    tp_world *world = scene_world(&scene, NULL);
    const size_t bytes = world->layout.bytes;
    run(&chance, world, &scene, 10);
    tp_world *copy = malloc(bytes);
    memcpy(copy, world, bytes);
    scene.wave[0].amplitude += 999;
    *number(&scene) = value;
    const bool done = tp_world_apply(&tp_program_all, world, &scene, NULL);
    if (done)
        run(&chance, world, &scene, 10);
    else
        assert_memory_equal(copy, world, bytes);
    free(copy);
    free(world);
    return done;
}

#define NUMBER(name, member) \
    static int32_t *name(tp_scene *s) { return (int32_t *)&s->member; }
NUMBER(pool_cols, pool.cols) NUMBER(pool_cells, pool.cell_bits) NUMBER(pool_cell, pool.cell)
NUMBER(pool_range, pool.max_height) NUMBER(pool_edges, pool.boundary)
NUMBER(field_cell, field.cell) NUMBER(pool_interval, pool.interval)
NUMBER(field_interval, field.interval) NUMBER(foam_slices, foam.slices)
NUMBER(field_rows, field.rows) NUMBER(drops_count, drops.count)
NUMBER(drops_rings, drops.rings) NUMBER(drops_into, drops.target)
NUMBER(floor_depth, floor.depth) NUMBER(wind, wind.strength)
NUMBER(pool_courant, pool.courant) NUMBER(pool_damping, pool.damping)
NUMBER(pool_x, pool.x) NUMBER(pool_drive, pool.drive_amplitude)
NUMBER(pool_splash, pool.splash_height)
NUMBER(pool_paddle, pool.paddle) NUMBER(field_courant, field.courant)
NUMBER(wave_amplitude, wave[1].amplitude) NUMBER(wave_count, wave[7].amplitude)
NUMBER(floor_slope, floor.slope) NUMBER(drops_radius, drops.radius)
NUMBER(scale, clock.scale)
#undef NUMBER

static tp_scene scene_full(void)
{
    tp_scene s = scene_with(&chance, 31);

    s.pool.cell_bits = s.field.cell_bits = TP_CELLS_16;
    s.pool.boundary = s.field.boundary = TP_EDGES_WALL;
    s.pool.cols = s.pool.rows = s.field.cols = s.field.rows = 32;
    s.wind.strength = 0;
    s.drops.rings = 20;
    s.drops.target = TP_DROPS_RINGS;
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
    assert_false(refreshes(s, wave_count, TP_FX(0.1)));     /* needs another table */
}

static void what_cannot_be_tuned_asks_for_a_new_world(void **state)
{
    (void)state;
    tp_scene s = scene_full();

    assert_false(refreshes(s, pool_cell, s.pool.cell + 1));
    assert_false(refreshes(s, field_cell, s.field.cell + 1));
    assert_false(refreshes(s, pool_range, s.pool.max_height + 1));
    assert_false(refreshes(s, pool_courant, TP_FX(0.7)));
    assert_false(refreshes(s, field_courant, TP_FX(0.7)));
    s.pool.courant = s.field.courant = TP_FX(0.1);      /* the interval would be allowed */
    assert_true(refreshes(s, pool_interval, 0));
    assert_false(refreshes(s, pool_interval, 1));
    assert_false(refreshes(s, field_interval, 1));
    s.foam.cells = 16;
    assert_true(refreshes(s, foam_slices, s.foam.slices));
    assert_false(refreshes(s, foam_slices, 4));
    s.field.cols = 64;                  /* the same number of cells in another shape */
    s.field.rows = 16;
    tp_world *world = scene_world(&s, NULL);
    s.field.cols = 16;
    s.field.rows = 64;
    assert_false(tp_world_apply(&tp_program_all, world, &s, NULL));
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
    assert_true(refreshes(s, pool_drive, TP_FX(0.3)));
    assert_true(refreshes(s, pool_splash, TP_FX(0.3)));
    assert_true(refreshes(s, pool_paddle, TP_FX(0.3)));
    assert_true(refreshes(s, drops_radius, TP_FX(0.2)));
    assert_true(refreshes(s, scale, TP_FX_ONE / 4));
}

/* -- refresh by need --------------------------------------------------------------- */

/* Spoils the keys that the tables keep of their input parameters, so the next refresh
 * computes all tables again. */
static void forget_numbers(tp_world *world)
{
    tp_coastal_water *coastal = tp_world_module_state(world, TP_COASTAL_ID);
    if (coastal) {
        coastal->floor_key.depth ^= 1;
        for (uint32_t i = 0; i < coastal->count; i++)
            tp_coastal_tables(coastal)[i].key.length ^= 1;
    }
    uint32_t *meter = tp_world_module_state(world, TP_METER_ID);
    if (meter)                          /* the part begins with the kind of sky */
        *meter ^= 1u << 30;
}

typedef struct {
    tp_scene  scene;
    tp_assets assets;
    tp_world *need, *full;      /* refreshed by need, and with all tables each time */
    uint32_t  done;
} refresh_pair;

static void assert_same(const refresh_pair *p, const tp_param *row, const char *when)
{
    if (memcmp(p->need, p->full, p->need->layout.bytes) != 0)
        fail_msg("%s: %s the world is another than by a full refresh", row->name, when);
}

static void refresh_both(refresh_pair *p, const tp_param *row)
{
    const bool taken = tp_world_apply(&tp_program_all, p->need, &p->scene, &p->assets);

    forget_numbers(p->full);
    if (tp_world_apply(&tp_program_all, p->full, &p->scene, &p->assets) != taken)
        fail_msg("%s is taken by one refresh and not by the other", row->name);
    if (!taken)
        memcpy(p->full, p->need, p->need->layout.bytes);
    p->done += taken;
    assert_same(p, row, "at once");
}

static void step_both(refresh_pair *p, const tp_param *row)
{
    const tp_input in = input_any(&chance);

    tp_world_step(&tp_program_all, p->need, &p->scene, &in);
    tp_world_step(&tp_program_all, p->full, &p->scene, &in);
    assert_same(p, row, "after a tick");
}

/* Sets every row to a random value and back, with ticks between. */
static void turn_every_row(refresh_pair *p)
{
    uint32_t count;
    const tp_param *rows = tp_params(&count);

    for (uint32_t i = 0; i < count; i++) {
        if (!scene_is_number(&rows[i]))
            continue;
        int32_t *number = scene_number(&p->scene, &rows[i]), before = *number;
        *number = chance_int(&chance, rows[i].low, rows[i].high);
        const uint32_t done = p->done;
        refresh_both(p, &rows[i]);
        if (p->done == done)            /* needs a new world */
            *number = before;
        step_both(p, &rows[i]);
        *number = before;
        refresh_both(p, &rows[i]);
        step_both(p, &rows[i]);
    }
}

static void a_refresh_by_need_is_a_full_one(void **state)
{
    static const tp_grey strip = { SAMPLES, 3, sample };    /* few nodes: quick */
    (void)state;
    for (uint32_t kind = 0; kind < 4; kind++) {
        refresh_pair p = { .scene = scene_with(&chance, kind == 0 ? 4 : 3 + 4 + 16) };
        p.assets = assets_with(&chance, &p.scene, kind == 2, true);
        p.assets.floor = kind == 2 ? &strip : NULL;
        p.scene.wind.strength = kind == 1 ? TP_FX(0.05) : 0;
        p.scene.hdr.exposure = kind % 2 ? TP_EXPOSURE_AUTO : TP_EXPOSURE_FIXED;
        p.scene.sky.kind = kind == 3 ? TP_SKY_DAY : TP_SKY_GRADIENT;
        p.scene.boat.mode = kind == 1 ? TP_BOAT_DYNAMIC : TP_BOAT_KINEMATIC;
        p.scene.floor.depth = kind == 3 ? 0 : p.scene.floor.depth;
        p.need = scene_world(&p.scene, &p.assets);
        run(&chance, p.need, &p.scene, 20);
        p.full = malloc(p.need->layout.bytes);
        memcpy(p.full, p.need, p.need->layout.bytes);
        turn_every_row(&p);
        printf("    kind %u: %u refreshes, coastal water %s, meter %s\n", (unsigned)kind,
               (unsigned)p.done, tp_world_coastal(p.need) ? "yes" : "no",
               tp_world_is_metered(p.need) ? "yes" : "no");
        assert_true(p.done > 300);
        free(p.need);
        free(p.full);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_refresh_of_the_same_scene_changes_nothing),
        cmocka_unit_test(what_sizes_the_block_asks_for_a_new_world),
        cmocka_unit_test(what_cannot_be_tuned_asks_for_a_new_world),
        cmocka_unit_test(what_may_change_is_taken),
        cmocka_unit_test(a_refresh_by_need_is_a_full_one),
    };
    return cmocka_run_group_tests_name("world/refresh", tests, NULL, NULL);
}
