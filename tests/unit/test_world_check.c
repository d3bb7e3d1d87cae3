/* SPDX-License-Identifier: MIT */
/* Worlds from outside: any state that steps can reach is accepted, for any scene and input;
 * any other state is refused with the name of the faulty field. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/drops/drops.h"
#include "features/exposure/exposure.h"
#include "features/foam/foam.h"
#include "features/spray/spray.h"
#include "tests/lib/worlds.h"
#include "world/pools.h"
#include "waves/coastal_tables.h"

static uint64_t chance;

/* -- accepted worlds --------------------------------------------------------------- */

/* Asserts that the world is valid for the scene as it is now. */
static void assert_valid(const tp_world *world, const tp_scene *scene,
                         const tp_assets *assets)
{
    tp_world *fresh = scene_world(scene, assets);
    tp_error err = { .word = "" };

    if (tp_world_check(&tp_program_all, world, world->layout.bytes, fresh, &err) != TP_OK)
        fail_msg("seed %llu: tick %llu: %s", (unsigned long long)chance,
                 (unsigned long long)world->tick, err.word);
    free(fresh);
}

/* Input with everything at once, as extreme as a port can request. */
static tp_input input_wild(void)
{
    const int32_t most = chance_int(&chance, 0, 3) ? TP_FX_ONE : INT32_MAX;

    return (tp_input){
        .forward = chance_int(&chance, -most, most),
        .up = chance_int(&chance, -most, most),
        .strafe = chance_int(&chance, -most, most),
        .turn = (int32_t)random_next(&chance),
        .tilt = (int32_t)random_next(&chance),
        .drops = chance_int(&chance, 0, 1024),
        .sphere_x = chance_int(&chance, -most, most),
        .sphere_z = chance_int(&chance, -most, most),
        .throttle = chance_int(&chance, -most, most),
        .rudder = chance_int(&chance, -most, most),
        .push[0] = { chance_fx(&chance, -64, 64), chance_fx(&chance, -8, 8),
                     chance_fx(&chance, -8, 8) },
        .push[7].height = chance_int(&chance, INT32_MIN, INT32_MAX),
        .slowdown = chance_int(&chance, -3, 3),
        .light_turn = (int32_t)random_next(&chance),
        .light_tilt = (int32_t)random_next(&chance),
    };
}

/* Any scene of the table, limited to sizes that a test has time for. */
static tp_scene scene_small(void)
{
    tp_scene s = scene_any(&chance);
    tp_scene_pool *const pools[] = { &s.pool, &s.field };

    for (int i = 0; i < 2; i++) {
        pools[i]->cols = chance_int(&chance, 0, 1) ? chance_int(&chance, 16, 40) : 0;
        pools[i]->rows = chance_int(&chance, 16, 40);
        pools[i]->courant = TP_FX(0.3);
        pools[i]->drive_max = pools[i]->drive_min + TP_FX(0.1);
    }
    s.foam.cells = chance_int(&chance, 0, 40);
    if (chance_int(&chance, 0, 1))
        strcpy(s.boat.mesh, "boat.obj");
    else
        s.boat.mesh[0] = '\0';
    return s;
}

static void step_wildly(tp_world *world, const tp_scene *scene, int pictures)
{
    for (int i = 0; i < pictures; i++) {
        for (uint32_t n = tp_world_advance_clock(world); n > 0; n--) {
            const tp_input in = input_wild();
            tp_world_step(&tp_program_all, world, scene, &in);
        }
    }
}

static void worlds_that_step_are_valid(void **state)
{
    (void)state;
    const int scenes = getenv("TP_SOAK") ? 20000 : 60;

    for (int i = 0; i < scenes; i++) {
        tp_scene scene = scene_small();
        tp_assets assets = assets_with(&chance, &scene, chance_int(&chance, 0, 3) == 0,
                                       chance_int(&chance, 0, 1));
        tp_world *world = scene_world(&scene, &assets);
        if (!world)
            continue;
        assert_valid(world, &scene, &assets);
        step_wildly(world, &scene, 20);
        assert_valid(world, &scene, &assets);
        const tp_input look = input_wild();
        tp_world_move_camera(world, &look);
        assert_valid(world, &scene, &assets);
        free(world);
    }
}

/* Parameters change while the world moves: derived values equal those of a new world. */
static void worlds_that_were_refreshed_are_valid(void **state)
{
    (void)state;
    uint32_t count;
    const tp_param *rows = tp_params(&count);
    const int scenes = getenv("TP_SOAK") ? 2000 : 8;

    for (int i = 0; i < scenes; i++) {
        tp_scene scene = scene_small();
        tp_assets assets = assets_with(&chance, &scene, false, chance_int(&chance, 0, 1));
        tp_world *world = scene_world(&scene, &assets);
        for (int n = 0; world && n < 40; n++) {
            const tp_param *row = &rows[random_below(&chance, count)];
            const tp_scene before = scene;
            if (!scene_is_number(row))
                continue;
            *scene_number(&scene, row) = chance_int(&chance, row->low, row->high);
            if (!tp_world_apply(&tp_program_all, world, &scene, &assets))
                scene = before;
            if (n % 2)
                step_wildly(world, &scene, 2);
            assert_valid(world, &scene, &assets);
        }
        free(world);
    }
}

/* -- refused worlds ---------------------------------------------------------------- */

/* A world with every part after some time, and a world of the same scene at tick 0. */
static tp_scene scene;
static tp_world *kept, *fresh;

static int make(void **state)
{
    (void)state;
    uint64_t fixed = 5;

    scene = scene_with(&fixed, 31);
    scene.pool.cell_bits = TP_CELLS_16;
    scene.pool.boundary = TP_EDGES_SPONGE;
    scene.field.cell_bits = TP_CELLS_32;
    scene.field.boundary = TP_EDGES_WALL;
    scene.drops.target = TP_DROPS_RINGS;
    scene.foam.cells = 20;
    scene.spray.count = 60;
    scene.hdr.exposure = TP_EXPOSURE_AUTO;
    kept = scene_world(&scene, NULL);
    fresh = scene_world(&scene, NULL);
    run(&fixed, kept, &scene, 90);
    return kept && fresh && tp_world_drops(kept)->rings > 0
                   && tp_world_spray(kept)->count > 0 && tp_world_drops(kept)->count > 0
               ? 0
               : -1;
}

static int unmake(void **state)
{
    (void)state;
    free(kept);
    free(fresh);
    return 0;
}

static void assert_refused(const char *what, const char *word)
{
    tp_error err = { .word = "nothing" };
    tp_world_check(&tp_program_all, kept, kept->layout.bytes, fresh, &err);
    if (strcmp(err.word, word) != 0)
        fail_msg("%s is refused for %s, expected %s", what, err.word, word);
}

/* Writes hostile values into a number of 4 or 8 bytes; each value must be refused. */
static void refused(const void *at, size_t size, const char *what, const char *word)
{
    static const int32_t hostile[] = { INT32_MIN, INT32_MAX, -0x40000000, 0x40000000 };
    uint8_t before[8];
    void *const to = (void *)(uintptr_t)at;

    memcpy(before, to, size);
    for (size_t i = 0; i < sizeof hostile / sizeof *hostile; i++) {
        const int64_t wide = hostile[i] * ((int64_t)1 << 32);
        memcpy(to, size == 8 ? (const void *)&wide : (const void *)&hostile[i], size);
        if (memcmp(to, before, size) != 0)
            assert_refused(what, word);
    }
    memcpy(to, before, size);
    assert_int_equal(
        tp_world_check(&tp_program_all, kept, kept->layout.bytes, fresh, NULL), TP_OK);
}

#define REFUSED(member, word) refused(&(member), sizeof (member), #member, word)

static void the_head_is_checked(void **state)
{
    (void)state;
    REFUSED(kept->layout.version, "version");
    REFUSED(kept->layout.modules, "layout");
    REFUSED(kept->layout.bytes, "layout");
    REFUSED(kept->lag, "head");
    REFUSED(kept->aboard, "head");
    REFUSED(kept->eye.x, "camera");
    REFUSED(kept->last_eye.y, "camera");
    REFUSED(kept->exposure, "light");
    REFUSED(kept->last_exposure, "light");
    REFUSED(kept->clock.scale_q40, "clock");
    REFUSED(kept->clock.fraction_q40, "clock");
    REFUSED(kept->clock.target, "clock");
    REFUSED(kept->clock.zero, "clock");
    const uint64_t tick = kept->tick;
    kept->tick = (uint64_t)1 << 47;
    assert_refused("tick", "head");
    kept->tick = tick;
}

static void the_boat_is_checked(void **state)
{
    (void)state;
    REFUSED(kept->boat.place.x, "hull");
    REFUSED(kept->last_boat.place.y, "hull");
    REFUSED(kept->boat_state.placed, "head");
    REFUSED(kept->boat_state.sailed_x, "hull");
    REFUSED(kept->boat_state.attitude.at[0], "hull");
    REFUSED(kept->boat_state.without_pool.speed[2], "hull");
    REFUSED(kept->boat_state.hull.z, "hull");
    REFUSED(kept->boat_state.wake_hull.immersion[1], "hull");
}

/* Boolean values of 2 to 255 are invalid. */
static void the_sea_is_checked(void **state)
{
    (void)state;
    uint8_t *const flags[] = { (uint8_t *)&kept->deep.clamped,
                               (uint8_t *)&kept->deep.capped,
                               (uint8_t *)&kept->deep.sharpened,
                               (uint8_t *)&kept->deep.crossed };
    for (int i = 0; i < 4; i++) {
        const uint8_t before = *flags[i];
        for (int value = 0; value < 256; value++) {
            *flags[i] = (uint8_t)value;
            assert_int_equal(
                tp_world_check(&tp_program_all, kept, kept->layout.bytes, fresh, NULL),
                value == before ? TP_OK : TP_E_WORLD);
        }
        *flags[i] = before;
    }
    REFUSED(kept->deep.count, "sea");
    REFUSED(kept->deep.swell[0].power, "sea");
    REFUSED(kept->deep.swell[2].mean_q24, "sea");
    REFUSED(kept->deep.swell[1].turns_x, "sea");
    const tp_coastal_water *coastal = tp_world_coastal(kept);
    REFUSED(coastal->count, "coastal");
    REFUSED(coastal->wave[0].wave_nodes, "coastal");
    REFUSED(tp_coastal_tables(coastal)[1].turns[TP_COASTAL_PHASES - 1], "coastal");
}

static void pools_are_checked(void **state)
{
    (void)state;
    const tp_pool *pool = tp_world_pool(kept), *field = tp_world_field(kept);
    const int32_t *heights = (const int32_t *)(const void *)(field + 1);
    const uint32_t count = field->cols * field->rows;

    REFUSED(pool->cols, "pool");
    REFUSED(pool->walls, "pool");
    REFUSED(pool->sponge, "pool");
    REFUSED(pool->courant_sq_q10, "pool");
    REFUSED(pool->unit_shift, "pool");
    REFUSED(pool->drive_peak, "pool");
    REFUSED(pool->drive_ticks, "pool");
    REFUSED(pool->drive_hits, "pool");
    REFUSED(pool->at_rest, "pool");
    REFUSED(field->edges, "field");
    REFUSED(heights[count / 2], "field");
    REFUSED(heights[count + count / 2], "field");
    int32_t *last = (int32_t *)(uintptr_t)&heights[2 * count - 1];  /* into the wall */
    *last = 1;
    assert_refused("a flux", "field");
    *last = 0;
    uint8_t *byte = (uint8_t *)(uintptr_t)pool + pool->walls + 3;
    *byte ^= 2;
    assert_refused("a wall", "pool");
    *byte ^= 2;
}

static void what_floats_in_the_air_is_checked(void **state)
{
    (void)state;
    const tp_drops *drops = tp_world_drops(kept);
    const tp_drop *drop = tp_drops_list(drops);
    const tp_ring *ring = tp_drops_rings(drops);
    const uint32_t *now = (const uint32_t *)(const void *)(ring + drops->ring_capacity);
    const tp_spray *spray = tp_world_spray(kept);
    const tp_speck *speck = tp_spray_list(spray);
    const tp_foam *foam = tp_world_foam(kept);

    REFUSED(drops->capacity, "drops");
    REFUSED(drops->count, "drops");
    REFUSED(drops->rings, "drops");
    REFUSED(drops->sphere.x, "drops");
    REFUSED(drops->sphere.y, "drops");
    REFUSED(drops->sphere.z, "drops");
    REFUSED(drops->last_sphere.x, "drops");
    REFUSED(drops->last_sphere.y, "drops");
    REFUSED(drops->last_sphere.z, "drops");
    REFUSED(drop->place.x, "drops");
    REFUSED(drop->high_q32, "drops");
    REFUSED(drop->radius, "drops");
    REFUSED(drop->squash_speed, "drops");
    REFUSED(ring->decay, "drops");
    REFUSED(ring->start, "drops");
    REFUSED(now[0], "drops");                   /* number and room of the tick's rings */
    REFUSED(now[1], "drops");
    REFUSED(spray->capacity, "spray");
    REFUSED(spray->count, "spray");
    REFUSED(speck->place.y, "spray");
    REFUSED(speck->speed.x, "spray");
    REFUSED(foam->cells, "foam");
    REFUSED(foam->scratch, "foam");
    REFUSED(foam->first_x, "foam");
    REFUSED(foam->seen[3][1], "foam");
    REFUSED(foam->drift_z, "foam");
    uint8_t *probe = tp_world_module_state(kept, TP_METER_ID);
    *probe ^= 1;
    assert_refused("a table", "meter");
    *probe ^= 1;
}

/* The id and the length before the state of every module with a state. */
static void the_chunks_are_checked(void **state)
{
    (void)state;
    uint32_t chunks = 0;

    for (const tp_use *u = tp_program_all.modules; u->module; u++) {
        const uint32_t *mine = tp_world_module_state(kept, u->module->id);
        if (!mine)
            continue;
        refused(&mine[-2], sizeof *mine, "an id", u->module->name);
        refused(&mine[-1], sizeof *mine, "a length", u->module->name);
        chunks++;
    }
    assert_true(chunks >= 7);
}

/* A head that ends before its version, a head of version 0 as before version numbers
 * existed, and a head of a later version. */
static void worlds_of_other_versions_are_refused(void **state)
{
    (void)state;
    const uint32_t other[] = { 0, TP_WORLD_VERSION - 1, TP_WORLD_VERSION + 1 };

    for (int i = 0; i < 3; i++) {
        tp_error err;
        kept->layout.version = other[i];
        assert_int_equal(
            tp_world_check(&tp_program_all, kept, kept->layout.bytes, fresh, &err),
            TP_E_WORLD);
        assert_string_equal(err.word, "version");
        assert_int_equal(
            tp_world_check(&tp_program_all, kept, offsetof(tp_world, layout), fresh, &err),
            TP_E_WORLD);
        assert_string_equal(err.word, "layout");
    }
    kept->layout.version = TP_WORLD_VERSION;
    assert_int_equal(
        tp_world_check(&tp_program_all, kept, kept->layout.bytes, fresh, NULL), TP_OK);
}

static void short_blocks_are_refused(void **state)
{
    (void)state;
    tp_error err;
    assert_int_equal(
        tp_world_check(&tp_program_all, kept, kept->layout.bytes - 1, fresh, &err),
        TP_E_WORLD);
    assert_string_equal(err.word, "layout");
    assert_int_equal(tp_world_check(&tp_program_all, kept, 0, fresh, &err), TP_E_WORLD);
    assert_int_equal(tp_world_check(&tp_program_all, NULL, 99, fresh, &err), TP_E_NULL);
    assert_string_equal(err.word, "world");
    assert_int_equal(tp_world_check(&tp_program_all, kept, 99, NULL, &err), TP_E_NULL);
    assert_string_equal(err.word, "fresh");
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worlds_that_step_are_valid),
        cmocka_unit_test(worlds_that_were_refreshed_are_valid),
        cmocka_unit_test(the_head_is_checked),
        cmocka_unit_test(the_boat_is_checked),
        cmocka_unit_test(the_sea_is_checked),
        cmocka_unit_test(pools_are_checked),
        cmocka_unit_test(what_floats_in_the_air_is_checked),
        cmocka_unit_test(the_chunks_are_checked),
        cmocka_unit_test(worlds_of_other_versions_are_refused),
        cmocka_unit_test(short_blocks_are_refused),
    };
    return cmocka_run_group_tests_name("world check", tests, make, unmake);
}
