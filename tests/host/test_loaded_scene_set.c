/* SPDX-License-Identifier: MIT */
/* Changes while a scene moves: the picture continues as for a scene opened with the
 * changes; a refused change has no effect. */
#define _XOPEN_SOURCE 700
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#undef fail                     /* cmocka's, without arguments */
#include "app/scene/loaded_scene.h"
#include "world/pools.h"
#include "world/text.h"
#include "world/world.h"

static options given;           /* of the open stage */
static loaded_scene stood;

static void open_scene(const char *scene)
{
    given = (options){ .scene = scene, .width = 48, .height = 32, .threads = 1,
                       .format = TP_FORMAT_XRGB8888 };
    assert_int_equal(loaded_scene_open(&stood, &given), 0);
}

static uint32_t drawn(void)
{
    frame_renderer_draw(&stood.renderer, stood.world);
    return picture_crc(&stood.renderer.picture);
}

static void steps(int count)
{
    for (; count > 0; count--)
        tp_world_step(&tp_program_all, stood.world, &stood.file.scene, NULL);
}

static bool set(const char *setting)
{
    bool opened = false;
    assert_int_equal(loaded_scene_set(&stood, &given, "here", setting, &opened), 0);
    return opened;
}

/* -- accepted changes ------------------------------------------------------------ */

/* Compares the running frame renderer with a newly opened one. */
static void assert_drawn_as_new(const char *setting)
{
    const uint32_t crc = drawn();
    assert_int_equal(loaded_scene_open_renderer(&stood, &given), 0);
    const bool same = drawn() == crc;
    if (!same)
        print_error("%s: the picture is not that of a new canvas\n", setting);
    assert_true(same);
}

static uint32_t seed;

static uint32_t chance(uint32_t most)
{
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)seed * most >> 32);
}

/* Sets a random value and the old one; values for large memory are kept small. */
static void there_and_back(const tp_param *param)
{
    char value[64], before[64], there[128], back[128];
    const int64_t span = (int64_t)param->high - param->low;
    int32_t number = (int32_t)(param->low
                    + (int64_t)((double)span * chance(1u << 30) / (1u << 30)));
    bool opened = false;
    if (param->kind == TP_PARAM_INT && span > 100)
        number = param->low + (int32_t)chance(100);
    tp_param_number_text(param, number, value, sizeof value);
    tp_param_text(&stood.file.scene, param, before, sizeof before);
    snprintf(there, sizeof there, "%s=%s", param->name, value);
    snprintf(back, sizeof back, "%s=%s", param->name, before);
    if (loaded_scene_set(&stood, &given, "here", there, &opened))
        return;                                 /* with this value no pool comes to rest */
    steps(2);
    assert_drawn_as_new(there);
    (void)set(back);
    steps(1);
    assert_drawn_as_new(back);
}

static void pictures_go_on_as_if_opened_anew(void **state)
{
    (void)state;
    static const char *const scenes[] = { "assets/scenes/harbour.ini",
                                          "assets/scenes/three-swells.ini" };
    uint32_t count;
    const tp_param *params = tp_params(&count);
    const char *given_seed = getenv("TP_SEED");
    seed = given_seed ? (uint32_t)strtoul(given_seed, NULL, 10) : (uint32_t)time(NULL);
    print_message("seed %u\n", (unsigned)seed);
    for (int i = 0; i < 2; i++) {
        open_scene(scenes[i]);
        there_and_back(tp_param_find(i ? "drops.count" : "pool.x", i ? 11 : 6));
        for (int n = 0; n < 30; n++) {
            const tp_param *param = &params[chance(count)];
            if (param->kind < TP_PARAM_MESH)
                there_and_back(param);
        }
        loaded_scene_close(&stood);
    }
}

static void numbers_need_no_new_canvas(void **state)
{
    (void)state;
    open_scene("assets/scenes/three-swells.ini");
    const uint32_t before = drawn();
    assert_false(set("wave0.amplitude=1.25"));
    assert_false(set("light.elevation=15"));
    assert_int_not_equal(drawn(), before);
    assert_int_equal(stood.file.scene.wave[0].amplitude, 5 << 14);
    loaded_scene_close(&stood);
}

/* The harbour's pool has inner walls: only changes that move walls need a new frame
 * renderer. */
static void walls_that_move_open_the_canvas(void **state)
{
    (void)state;
    open_scene("assets/scenes/harbour.ini");
    (void)drawn();
    assert_false(set("pool.damping=9"));
    assert_false(set("pool.splash_height=0.3"));
    assert_drawn_as_new("pool.splash_height");
    assert_true(set("pool.x=1.5"));
    steps(1);
    assert_drawn_as_new("pool.x");
    loaded_scene_close(&stood);
}

static void what_needs_memory_opens_the_canvas(void **state)
{
    (void)state;
    static const char *const settings[] = { "grid.vertices=999", "sky.kind=day",
                                            "mirror.method=cube", "boat.mesh=",
                                            "drops.count=300" };
    open_scene("assets/scenes/three-swells.ini");
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
        assert_true(set(settings[i]));
        steps(1);
        assert_drawn_as_new(settings[i]);
    }
    loaded_scene_close(&stood);
}

/* Two error budgets with different rungs in the plan. */
static void another_plan_opens_the_canvas(void **state)
{
    (void)state;
    open_scene("assets/scenes/lava.ini");
    assert_true(set("quality.error_colour=12"));
    steps(1);
    assert_drawn_as_new("quality.error_colour");
    assert_false(set("quality.error_colour=12.001"));
    loaded_scene_close(&stood);
}

/* A new world continues with time, camera and light. */
static void a_world_is_made_anew_where_it_was(void **state)
{
    (void)state;
    const tp_input input = { .forward = 3 << 16, .turn = 1 << 24, .light_turn = 1 << 25 };
    open_scene("assets/scenes/pond.ini");
    tp_world_step(&tp_program_all, stood.world, &stood.file.scene, &input);
    steps(30);
    const tp_world was = *stood.world;
    const size_t bytes = stood.world_bytes;
    assert_true(set("pool.cols=20"));
    assert_int_not_equal(stood.world_bytes, bytes);
    assert_int_equal(tp_world_pool(stood.world)->cols, 20);
    assert_int_equal(stood.world->tick, was.tick);
    assert_memory_equal(&stood.world->eye, &was.eye, sizeof was.eye);
    assert_int_equal(stood.world->heading, was.heading);
    assert_int_equal(stood.world->light_heading, was.light_heading);
    steps(2);
    assert_drawn_as_new("pool.cols");
    loaded_scene_close(&stood);
}

static void files_are_loaded_and_let_go(void **state)
{
    (void)state;
    open_scene("assets/scenes/minimal.ini");
    const uint32_t before = drawn();
    assert_null(stood.assets.names.boat);
    assert_true(set("boat.mesh=assets/boats/longship.obj"));
    assert_ptr_equal(stood.assets.names.boat, &stood.assets.boat);
    assert_true(set("layer1.texture=assets/textures/foam.png"));
    assert_ptr_equal(stood.assets.names.layer[1], &stood.assets.picture[1]);
    assert_int_not_equal(drawn(), before);
    assert_drawn_as_new("boat.mesh");
    assert_true(set("boat.mesh="));
    assert_true(set("layer1.texture="));
    assert_null(stood.assets.names.boat);
    assert_int_equal(drawn(), before);
    loaded_scene_close(&stood);
}

/* -- refused changes ------------------------------------------------------------- */

static void what_is_refused_changes_nothing(void **state)
{
    (void)state;
    static const char *const settings[] = {
        "wave0.amplitude=99", "wave0.amplitude", "=1", "nothing=1", "pool.courant=0.8",
        "boat.mesh=no.obj", "boat.mesh=assets/scenes/pond.ini", "sky.kind=cube",
        "layer1.texture=assets/boats/longship.obj", "grid.vertices=65536", "pool.cols=512",
        "layer1.texture=assets/textures/foam.png",
    };
    open_scene("assets/scenes/pond.ini");
    assert_false(set("pool.damping=10"));
    steps(10);
    const uint32_t before = drawn();
    const tp_scene scene = stood.file.scene;
    const tp_assets names = stood.assets.names;
    const tp_frame *frame = stood.renderer.frame;
    const tp_world *world = stood.world;
    uint8_t *copy = malloc(stood.world_bytes);
    memcpy(copy, world, stood.world_bytes);
    given.memory = 1000;                        /* nothing larger fits */
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
        bool opened = false;
        const int code = loaded_scene_set(&stood, &given, "here", settings[i], &opened);
        if (code != 3)
            print_error("%s was taken\n", settings[i]);
        assert_int_equal(code, 3);
        assert_false(opened);
        assert_memory_equal(&scene, &stood.file.scene, sizeof scene);
        assert_memory_equal(&names, &stood.assets.names, sizeof names);
        assert_ptr_equal(frame, stood.renderer.frame);
        assert_ptr_equal(world, stood.world);
        assert_memory_equal(copy, world, stood.world_bytes);
    }
    assert_int_equal(drawn(), before);
    free(copy);
    loaded_scene_close(&stood);
}

static void a_sky_without_pictures_is_refused(void **state)
{
    (void)state;
    bool opened = false;
    open_scene("assets/scenes/minimal.ini");
    const tp_scene scene = stood.file.scene;
    const tp_world world = *stood.world;
    assert_int_equal(loaded_scene_set(&stood, &given, "here", "sky.kind=cube", &opened), 3);
    assert_memory_equal(&scene, &stood.file.scene, sizeof scene);
    assert_memory_equal(&world, stood.world, sizeof world);
    assert_false(opened);
    loaded_scene_close(&stood);
}

/* Set one by one in the table's order, each is refused because of the later ones. */
static void several_are_taken_in_any_order(void **state)
{
    (void)state;
    static const loaded_scene_setting all[] = {
        { "1", "sky.kind=cube" }, { "2", "sky.east=assets/skies/dusk-east.png" },
        { "3", "sky.west=assets/skies/dusk-west.png" },
        { "4", "sky.up=assets/skies/dusk-up.png" },
        { "5", "sky.down=assets/skies/dusk-down.png" },
        { "6", "sky.south=assets/skies/dusk-south.png" },
        { "7", "sky.north=assets/skies/dusk-north.png" }, { "8", "pool.cols=32" },
        { "9", "pool.drive_min=0.5" }, { "10", "pool.drive_max=1" },
    }, some[] = { { "1", "boat.mesh=no.obj" }, { "2", "pool.drive_min=3" },
                  { "3", "camera.fov=50" } };
    bool opened = false;
    open_scene("assets/scenes/minimal.ini");
    assert_int_equal(
        loaded_scene_set_all(&stood, &given, all, sizeof all / sizeof *all, &opened), 0);
    assert_true(opened);
    assert_int_equal(stood.file.scene.sky.kind, TP_SKY_CUBE);
    assert_int_equal(stood.file.scene.pool.drive_min, 1 << 15);
    assert_drawn_as_new("all of them");
    assert_int_equal(loaded_scene_set_all(&stood, &given, some, 3, &opened), 3);
    assert_int_equal(stood.file.scene.pool.drive_min, 1 << 15);
    assert_int_equal(stood.file.scene.camera.fov, 50 << 16);
    assert_int_equal(loaded_scene_set_all(&stood, &given, all, 0, &opened), 0);
    loaded_scene_close(&stood);
}

/* A name from the file, set again by hand. */
static void names_are_told_from_the_current_folder(void **state)
{
    (void)state;
    char text[256], setting[300];
    const tp_param *param = tp_param_find("layer0.texture", 14);
    open_scene("assets/scenes/minimal.ini");
    const uint32_t before = drawn();
    scene_file_text(&stood.file, param, text, sizeof text);
    assert_string_equal(text, "assets/scenes/../textures/water.png");
    assert_true(set("layer0.texture="));
    assert_int_not_equal(drawn(), before);
    snprintf(setting, sizeof setting, "layer0.texture=%s", text);
    assert_true(set(setting));
    assert_int_equal(drawn(), before);
    scene_file_text(&stood.file, param, text, sizeof text);
    assert_string_equal(text, "assets/scenes/../textures/water.png");
    loaded_scene_close(&stood);
}

static void a_stage_without_a_canvas_takes_changes(void **state)
{
    (void)state;
    given = (options){ .scene = "assets/scenes/pond.ini" };
    assert_int_equal(loaded_scene_load(&stood, &given), 0);
    assert_false(set("pool.cols=20"));
    assert_false(set("boat.mesh=assets/boats/longship.obj"));
    assert_false(set("grid.vertices=999"));
    assert_null(stood.renderer.frame);
    loaded_scene_close(&stood);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_go_on_as_if_opened_anew),
        cmocka_unit_test(numbers_need_no_new_canvas),
        cmocka_unit_test(walls_that_move_open_the_canvas),
        cmocka_unit_test(what_needs_memory_opens_the_canvas),
        cmocka_unit_test(another_plan_opens_the_canvas),
        cmocka_unit_test(a_world_is_made_anew_where_it_was),
        cmocka_unit_test(files_are_loaded_and_let_go),
        cmocka_unit_test(what_is_refused_changes_nothing),
        cmocka_unit_test(a_sky_without_pictures_is_refused),
        cmocka_unit_test(several_are_taken_in_any_order),
        cmocka_unit_test(names_are_told_from_the_current_folder),
        cmocka_unit_test(a_stage_without_a_canvas_takes_changes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
