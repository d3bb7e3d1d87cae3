/* SPDX-License-Identifier: MIT */
/* Parameters changed while the world moves: changes applied at once, changes with a new
 * world, no change by half; and the state carried into a new world. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../../ports/interact/setting.h"
#include "tests/lib/worlds.h"
#include "world/text.h"

static uint64_t chance;
static const tp_assets none;

typedef struct {
    tp_scene  scene;
    tp_world *world;
    tp_error  err;
} live;

static live live_of(const tp_scene *scene, int ticks)
{
    live l = { .scene = *scene, .world = scene_world(scene, &none) };

    assert_non_null(l.world);
    run(&chance, l.world, &l.scene, ticks);
    return l;
}

/* Deep water with a boat, a pool far from the boat, and drops. */
static tp_scene scene_some(void)
{
    tp_scene s = scene_with(&chance, 4 + 16);

    s.pool.cols = s.pool.rows = 32;
    s.pool.cell_bits = TP_CELLS_16;
    s.pool.boundary = TP_EDGES_WALL;
    s.pool.x = 300 * TP_FX_ONE;
    s.drops.rings = 20;
    s.drops.target = TP_DROPS_RINGS;
    s.drops.x = s.drops.z = 300 * TP_FX_ONE;
    s.boat.speed = TP_FX(2);
    s.light.turn = TP_FX(3);
    return s;
}

static setting_result put(live *l, const char *name, const char *text)
{
    const tp_param *param = tp_param_find(name, strlen(name));

    assert_non_null(param);
    return setting_put(&tp_program_all, &l->scene, l->world, &none, param, text,
                       strlen(text), &l->err);
}

/* Replaces the world by a new world with the carried state. */
static void make_anew(live *l)
{
    tp_world *from = l->world;

    l->world = scene_world(&l->scene, &none);
    assert_non_null(l->world);
    setting_carry(l->world, from);
    free(from);
}

/* -- one change --------------------------------------------------------------------- */

static void a_number_is_taken_and_the_world_goes_on(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    live l = live_of(&scene, 50), want = l;
    const size_t bytes = l.world->layout.bytes;
    want.world = malloc(bytes);
    memcpy(want.world, l.world, bytes);

    assert_int_equal(put(&l, "wave0.amplitude", " 0.7 "), SETTING_DONE);
    want.scene.wave[0].amplitude = TP_FX(0.7);
    assert_true(tp_world_apply(&tp_program_all, want.world, &want.scene, &none));
    assert_memory_equal(&l.scene, &want.scene, sizeof l.scene);
    assert_memory_equal(l.world, want.world, bytes);
    free(l.world);
    free(want.world);
}

static void a_text_that_is_no_value_changes_nothing(void **state)
{
    static const char *const bad[][2] = {
        { "wave0.amplitude", "99" }, { "wave0.amplitude", "" }, { "sky.kind", "noon" },
        { "pool.courant", "0.8" }, { "water.colour", "blue" }, { "boat.mesh", "a\tb" },
    };
    (void)state;
    const tp_scene scene = scene_some();
    live l = live_of(&scene, 5);
    const size_t bytes = l.world->layout.bytes;
    tp_world *before = malloc(bytes);
    const tp_scene kept = l.scene;
    memcpy(before, l.world, bytes);

    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(put(&l, bad[i][0], bad[i][1]), SETTING_REFUSED);
        assert_int_not_equal(l.err.code, TP_OK);
        assert_memory_equal(&l.scene, &kept, sizeof kept);
        assert_memory_equal(l.world, before, bytes);
        if (i == 3)
            assert_string_equal(l.err.word, "pool.courant");
    }
    free(before);
    free(l.world);
}

static void a_number_of_the_camera_moves_it_and_no_other_does(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    live l = live_of(&scene, 30);
    const tp_world from = *l.world;

    assert_int_equal(put(&l, "camera.fov", "70"), SETTING_DONE);
    assert_memory_equal(&l.world->eye, &from.eye, sizeof from.eye);
    assert_int_equal(put(&l, "camera.x", "-7"), SETTING_DONE);
    assert_int_equal(put(&l, "camera.y", "8"), SETTING_DONE);
    assert_int_equal(l.world->eye.z, from.eye.z);
    assert_int_equal(put(&l, "camera.z", "9"), SETTING_DONE);
    assert_int_equal(put(&l, "camera.heading", "90"), SETTING_DONE);
    assert_int_equal(put(&l, "camera.pitch", "-45"), SETTING_DONE);
    const tp_vec3 want = { -7 * TP_FX_ONE, 8 * TP_FX_ONE, 9 * TP_FX_ONE };
    assert_memory_equal(&l.world->eye, &want, sizeof want);
    assert_memory_equal(&l.world->last_eye, &want, sizeof want);
    assert_int_equal(l.world->heading, 0x40000000);
    assert_int_equal(l.world->last_heading, 0x40000000);
    assert_int_equal(l.world->pitch, 0xe0000000u);
    assert_int_equal(l.world->last_pitch, 0xe0000000u);
    free(l.world);
}

static void names_ask_for_loading_and_texts_for_nothing(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    live l = live_of(&scene, 3);

    assert_int_equal(put(&l, "layer0.texture", "a.png"), SETTING_LOAD);
    assert_string_equal(l.scene.layer[0].map.texture, "a.png");
    assert_int_equal(put(&l, "boat.mesh", ""), SETTING_LOAD);
    assert_int_equal(put(&l, "floor.map", "b.png"), SETTING_LOAD);
    assert_int_equal(put(&l, "scene.title", "A pond"), SETTING_DONE);
    assert_string_equal(l.scene.title, "A pond");
    free(l.world);
}

static void what_is_a_name_or_the_grid_is_known(void **state)
{
    (void)state;
    uint32_t count, names = 0, grids = 0;
    const tp_param *rows = tp_params(&count);

    for (uint32_t i = 0; i < count; i++) {
        const bool grid = !strcmp(rows[i].name, "grid.vertices");
        assert_int_equal(setting_is_grid(&rows[i]), grid);
        assert_int_equal(tp_param_is_file(&rows[i]), !scene_is_number(&rows[i])
                                                    && rows[i].kind != TP_PARAM_TEXT);
        names += tp_param_is_file(&rows[i]);
        grids += grid;
    }
    assert_true(names > 15);
    assert_int_equal(grids, 1);
}

/* A page that opens a link sets values before a world exists. */
static void without_a_world_numbers_are_checked_all_the_same(void **state)
{
    (void)state;
    tp_scene scene = scene_some(), kept = scene;
    tp_error err = { 0 };
    const tp_param *row = tp_param_find("pool.cols", 9);

    assert_int_equal(
        setting_put(&tp_program_all, &scene, NULL, &none, row, "40", 2, &err),
        SETTING_ANEW);
    assert_int_equal(scene.pool.cols, 40);
    kept.pool.cols = 40;
    row = tp_param_find("pool.courant", 12);
    assert_int_equal(
        setting_put(&tp_program_all, &scene, NULL, &none, row, "0.8", 3, &err),
        SETTING_REFUSED);
    assert_string_equal(err.word, "pool.courant");
    assert_memory_equal(&scene, &kept, sizeof kept);
}

static void walls_move_with_a_pool_that_has_some(void **state)
{
    (void)state;
    const tp_assets walls = { .pool_mask = &grey }, others = { .field_mask = &grey };
    uint32_t count, found = 0;
    const tp_param *rows = tp_params(&count);

    for (uint32_t i = 0; i < count; i++) {
        const bool moves = !strcmp(rows[i].name, "pool.x")
                        || !strcmp(rows[i].name, "pool.z");
        assert_int_equal(setting_is_wall(&rows[i], &walls), moves);
        assert_false(setting_is_wall(&rows[i], &others));
        found += moves;
    }
    assert_int_equal(found, 2);
}

/* Both ends of every row, one after another, each on top of the preceding values. */
static void every_parameter_is_taken_made_anew_or_refused(void **state)
{
    (void)state;
    uint32_t count, results[4] = { 0, 0, 0, 0 };
    const tp_param *rows = tp_params(&count);
    const tp_scene scene = scene_some();
    live l = live_of(&scene, 10);

    for (uint32_t i = 0; i < 2 * count; i++) {
        const tp_param *row = &rows[i / 2];
        char text[32], old[32];
        if (!scene_is_number(row))
            continue;
        const tp_scene before = l.scene;
        tp_param_number_text(row, i % 2 ? row->high : row->low, text, sizeof text);
        tp_param_text(&l.scene, row, old, sizeof old);
        const setting_result result = put(&l, row->name, text);
        results[result]++;
        if (result == SETTING_REFUSED)
            assert_memory_equal(&before, &l.scene, sizeof before);
        else
            assert_int_equal(*scene_number(&l.scene, row), i % 2 ? row->high : row->low);
        if (result == SETTING_ANEW && i % 2) {
            make_anew(&l);
        } else if (result == SETTING_ANEW) {
            tp_world_step(&tp_program_all, l.world, &before,
                          NULL); /* continues unchanged */
            assert_int_equal(put(&l, row->name, old), SETTING_DONE);
            assert_memory_equal(&before, &l.scene, sizeof before);
        }
        if (i % (uint32_t)random_rounds(1, 7) == 0)
            tp_world_step(&tp_program_all, l.world, &l.scene, NULL);
    }
    printf("    %u done, %u anew, %u refused\n", results[SETTING_DONE],
           results[SETTING_ANEW], results[SETTING_REFUSED]);
    assert_true(results[SETTING_DONE] > count && results[SETTING_ANEW] > 10
                && results[SETTING_REFUSED] > 3 && results[SETTING_LOAD] == 0);
    free(l.world);
}

/* -- new worlds --------------------------------------------------------------------- */

/* With a pool of another size, everything except the pool continues as in the old world. */
static void a_world_made_anew_goes_on(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    live l = live_of(&scene, 200), was = l;
    was.world = malloc(l.world->layout.bytes);
    memcpy(was.world, l.world, l.world->layout.bytes);

    assert_int_equal(put(&l, "pool.cols", "40"), SETTING_ANEW);
    make_anew(&l);
    for (int n = 0; n < 120; n++) {
        const tp_world *a = l.world, *b = was.world;
        const tp_camera eye = tp_world_camera(a), want = tp_world_camera(b);
        assert_memory_equal(&eye, &want, sizeof eye);
        assert_int_equal(a->tick, b->tick);
        assert_memory_equal(a->phases, b->phases, sizeof a->phases);
        assert_memory_equal(&a->boat, &b->boat, sizeof a->boat);
        assert_memory_equal(&a->clock, &b->clock, sizeof a->clock);
        assert_int_equal(a->light_heading, b->light_heading);
        assert_int_equal(a->light_elevation, b->light_elevation);
        assert_int_equal(tp_world_sample(&tp_program_all, a, TP_FX(5), TP_FX(9)).height,
                         tp_world_sample(&tp_program_all, b, TP_FX(5), TP_FX(9)).height);
        const tp_input in = { .forward = TP_FX(0.1),
                              .turn = 99999,
                              .light_turn = 12345,
                              .slowdown = n == 9,
                              .throttle = TP_FX(1) };
        assert_int_equal(tp_world_advance_clock(l.world),
                         tp_world_advance_clock(was.world));
        tp_world_step(&tp_program_all, l.world, &l.scene, &in);
        tp_world_step(&tp_program_all, was.world, &was.scene, &in);
    }
    free(l.world);
    free(was.world);
}

static void what_the_scene_says_anew_is_not_carried(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    live l = live_of(&scene, 100);
    l.scene.pool.cols = 40;
    l.scene.light.heading = 33 * TP_FX_ONE;
    l.scene.clock.scale = TP_FX_ONE / 2;
    make_anew(&l);
    assert_int_equal(l.world->light_heading, tp_turn_of_degrees(33 * TP_FX_ONE));
    assert_int_equal(l.world->clock.target, TP_FX_ONE / 2);
    free(l.world);
}

static void a_camera_whose_deck_is_gone_stands_where_the_scene_says(void **state)
{
    (void)state;
    tp_scene scene = scene_some();
    scene.camera.follow = TP_FOLLOW_BOAT;
    live l = live_of(&scene, 100);
    assert_int_equal(put(&l, "boat.mesh", ""), SETTING_LOAD);
    assert_int_not_equal(l.world->eye.z, scene.camera.z);
    make_anew(&l);
    assert_int_equal(l.world->aboard, 0);
    assert_int_equal(l.world->eye.z, scene.camera.z);
    const tp_pose nowhere = { { 0, 0, 0 }, 0, 0, 0 };
    assert_memory_equal(&l.world->boat, &nowhere, sizeof nowhere);
    free(l.world);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_number_is_taken_and_the_world_goes_on),
        cmocka_unit_test(a_text_that_is_no_value_changes_nothing),
        cmocka_unit_test(a_number_of_the_camera_moves_it_and_no_other_does),
        cmocka_unit_test(names_ask_for_loading_and_texts_for_nothing),
        cmocka_unit_test(what_is_a_name_or_the_grid_is_known),
        cmocka_unit_test(without_a_world_numbers_are_checked_all_the_same),
        cmocka_unit_test(walls_move_with_a_pool_that_has_some),
        cmocka_unit_test(every_parameter_is_taken_made_anew_or_refused),
        cmocka_unit_test(a_world_made_anew_goes_on),
        cmocka_unit_test(what_the_scene_says_anew_is_not_carried),
        cmocka_unit_test(a_camera_whose_deck_is_gone_stands_where_the_scene_says),
    };
    return cmocka_run_group_tests_name("interact/setting", tests, NULL, NULL);
}
