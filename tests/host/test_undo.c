/* SPDX-License-Identifier: MIT */
/* Values changed and undone while the water stands still: scene, world and picture are
 * restored to the bit, for every row of the table; the same for redo. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#undef log_fail                     /* cmocka's, without arguments */
#include "app/files/log.h"
#include "app/session/undo.h"
#include "tests/lib/random.h"
#include "world/text.h"
#include "world/world.h"

static options given;           /* of the open stage */
static loaded_scene stood;
static undo_edits e;

/* Runs some ticks with input and in slow motion, so that no number of the world equals
 * the scene's. */
static void open_scene(const char *scene)
{
    const tp_input led = { .forward = 3 << 14,
                           .turn = 1 << 24,
                           .light_turn = 1 << 22,
                           .slowdown = 1,
                           .drops = 3,
                           .push[0] = { 9999, 0, 0 } };
    given = (options){ .scene = scene, .width = 24, .height = 16, .threads = 1,
                       .format = TP_FORMAT_XRGB8888 };
    assert_int_equal(loaded_scene_open(&stood, &given), 0);
    for (int i = 0; i < 40; i++)
        for (uint32_t n = tp_world_advance_clock(stood.world); n > 0; n--)
            tp_world_step(&tp_program_all, stood.world, &stood.file.scene,
                          i % 7 ? NULL : &led);
}

static void close_scene(void)
{
    undo_edits_clear(&e);
    loaded_scene_close(&stood);
}

/* -- state to be restored ---------------------------------------------------------- */

typedef struct {
    tp_scene  scene;
    uint32_t *set_at;
    size_t    bytes;
    void     *world;
    uint32_t  crc;
} undo_moment;

static uint32_t rows(void)
{
    uint32_t count;
    tp_params(&count);
    return count;
}

static void *copy_of(const void *from, size_t bytes)
{
    void *copy = malloc(bytes);
    assert_non_null(copy);
    return memcpy(copy, from, bytes);
}

/* `drawn`: with the picture's CRC, slower than all the rest. */
static undo_moment moment_now(bool drawn)
{
    if (drawn)
        frame_renderer_draw(&stood.renderer, stood.world);
    return (undo_moment){
        .scene = stood.file.scene, .bytes = stood.world_bytes,
        .set_at = copy_of(stood.file.set_at, rows() * sizeof(uint32_t)),
        .world = copy_of(stood.world, stood.world_bytes),
        .crc = drawn ? picture_crc(&stood.renderer.picture) : 0,
    };
}

static void moment_free(undo_moment *m)
{
    free(m->set_at);
    free(m->world);
}

static bool is_again(const undo_moment *then, const char *name, const char *what)
{
    undo_moment now = moment_now(then->crc != 0);
    const bool scene = memcmp(&then->scene, &now.scene, sizeof now.scene) == 0;
    const bool set_at = memcmp(then->set_at, now.set_at, rows() * sizeof(uint32_t)) == 0;
    const bool world = then->bytes == now.bytes
                    && memcmp(then->world, now.world, now.bytes) == 0;
    const bool same = scene && set_at && world && then->crc == now.crc;
    if (!same)
        print_error("%s: %s: another%s%s%s%s\n", name, what, scene ? "" : " scene",
                    set_at ? "" : " origin", world ? "" : " world",
                    then->crc == now.crc ? "" : " picture");
    moment_free(&now);
    return same;
}

/* -- changes ----------------------------------------------------------------------- */

static uint32_t row_of(const char *name)
{
    const tp_param *param = tp_param_find(name, strlen(name));
    uint32_t count;
    assert_non_null(param);
    return (uint32_t)(param - tp_params(&count));
}

static int change_row(uint32_t row, const char *text, bool going, bool stands)
{
    const undo_change change = { .row = row, .going = going, .stands = stands };
    bool opened = false;
    return undo_set(&e, &stood, &given, &change, text, &opened);
}

static void change(const char *name, const char *text)
{
    assert_int_equal(change_row(row_of(name), text, false, true), EXIT_DONE);
}

static undo_result undo(void)
{
    undo_edit *done;
    bool opened = false;
    return undo_back(&e, &stood, &given, &done, &opened);
}

static undo_result redo(void)
{
    undo_edit *done;
    bool opened = false;
    return undo_again(&e, &stood, &given, &done, &opened);
}

/* Returns a value unlike the current one; names are of existing files. */
static void other_value(uint32_t row, char text[TP_NAME_BYTES])
{
    uint32_t count;
    const tp_param *param = &tp_params(&count)[row];
    int32_t number, least = param->kind == TP_PARAM_FX ? 2048 : 1;
    if (param->kind == TP_PARAM_MESH) {
        snprintf(text, TP_NAME_BYTES, "assets/boats/longship.obj");
    } else if (tp_param_is_file(param)) {
        snprintf(text, TP_NAME_BYTES, "assets/textures/foam.png");
    } else if (tp_param_is_text(param)) {
        snprintf(text, TP_NAME_BYTES, "another");
    } else {
        memcpy(&number, (const char *)&stood.file.scene + param->offset, sizeof number);
        number = (int64_t)number + least <= param->high ? number + least : param->low;
        tp_param_number_text(param, number, text, TP_NAME_BYTES);
    }
}

/* -- every row --------------------------------------------------------------------- */

typedef struct { uint32_t taken, refused, wrong; } undo_tally;

/* `before`: the moment before the change; it is the moment after as well. */
static void try_row(uint32_t row, undo_moment *before, undo_tally *t)
{
    uint32_t count;
    const char *name = tp_params(&count)[row].name;
    const uint32_t crc = before->crc;
    char text[TP_NAME_BYTES];
    other_value(row, text);
    if (change_row(row, text, false, true) != EXIT_DONE) {
        t->refused++;
        t->wrong += !is_again(before, name, "refused");
        return;
    }
    undo_moment after = moment_now(false);
    t->taken++;
    t->wrong += undo() != UNDO_ALL || !is_again(before, name, "undone");
    t->wrong += redo() != UNDO_VALUE || !is_again(&after, name, "made again");
    before->crc = 0;
    t->wrong += undo() != UNDO_ALL || !is_again(before, name, "undone again");
    before->crc = crc;
    moment_free(&after);
}

/* Tries all rows without file names, or the rows of file names only, slow to load. */
static void try_rows(const char *scene, bool names, uint32_t least)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    undo_tally t = { 0, 0, 0 };
    open_scene(scene);
    undo_moment before = moment_now(true);
    for (uint32_t row = 0; row < count; row++)
        if (tp_param_is_file(&params[row]) == names)
            try_row(row, &before, &t);
    moment_free(&before);
    print_message("%s: %u rows taken, %u refused\n", scene, (unsigned)t.taken,
                  (unsigned)t.refused);
    close_scene();
    assert_int_equal(t.wrong, 0);
    assert_true(t.taken >= least);
}

static void every_number_comes_back_to_the_bit(void **state)
{
    (void)state;
    try_rows("assets/scenes/three-swells.ini", false, 280);
    try_rows("assets/scenes/tank.ini", false, 280);
    if (random_rounds(1, 0))
        try_rows("assets/scenes/night-sea.ini", false, 280);
}

static void every_name_comes_back_to_the_bit(void **state)
{
    (void)state;
    try_rows("assets/scenes/pond.ini", true, 10);
}

/* -- several ----------------------------------------------------------------------- */

static void several_changes_lead_back_and_forth(void **state)
{
    (void)state;
    static const char *const changes[][2] = {
        { "pool.cols", "40" }, { "light.ambient", "0.1" }, { "camera.x", "3" },
        { "pool.rows", "20" }, { "tank.wall", "" }, { "camera.fov", "50" },
        { "drops.count", "9" }, { "light.heading", "12" },
    };
    enum { CHANGES = sizeof changes / sizeof *changes };
    undo_moment at[CHANGES + 1];
    open_scene("assets/scenes/tank.ini");
    for (int i = 0; i < CHANGES; i++) {
        at[i] = moment_now(true);
        change(changes[i][0], changes[i][1]);
    }
    at[CHANGES] = moment_now(true);
    const uint32_t made = e.count;
    for (int round = 0; round < 2; round++) {
        for (uint32_t i = made; i-- > 0;)
            assert_int_equal(undo(), UNDO_ALL);
        assert_int_equal(undo(), UNDO_NOTHING);
        assert_true(is_again(&at[0], "all", "undone"));
        for (uint32_t i = 0; i < made; i++)
            assert_int_equal(redo(), UNDO_VALUE);
        assert_int_equal(redo(), UNDO_NOTHING);
        assert_true(is_again(&at[CHANGES], "all", "made again"));
    }
    for (int i = 0; i <= CHANGES; i++)
        moment_free(&at[i]);
    close_scene();
}

static void a_drag_is_undone_as_one(void **state)
{
    (void)state;
    open_scene("assets/scenes/tank.ini");
    undo_moment before = moment_now(true);
    for (int cells = 30; cells < 40; cells++) {
        char text[16];
        snprintf(text, sizeof text, "%d", cells);
        assert_int_equal(change_row(row_of("pool.cols"), text, cells < 39, true), 0);
    }
    assert_int_equal(e.count, 1);
    assert_int_equal(undo(), UNDO_ALL);
    assert_true(is_again(&before, "pool.cols", "dragged and undone"));
    moment_free(&before);
    close_scene();
}

/* -- the camera, and water that moved ---------------------------------------------- */

static void look(void)
{
    const tp_input way = { .forward = 9999, .turn = 1 << 25, .tilt = -99999 };
    tp_world_move_camera(stood.world, &way);
}

/* If only the camera has moved since, undo restores the water and keeps the camera. */
static void a_camera_that_was_led_since_stays(void **state)
{
    (void)state;
    open_scene("assets/scenes/tank.ini");
    undo_moment led;
    tp_world before = *stood.world;
    change("pool.cols", "40");
    look();
    change("light.ambient", "0.2");
    assert_int_equal(undo(), UNDO_ALL);
    look();
    assert_int_equal(undo(), UNDO_WORLD);
    assert_int_not_equal(stood.world->heading, before.heading);
    assert_memory_equal(stood.world->phases, before.phases, sizeof before.phases);
    led = moment_now(true);
    assert_int_equal(redo(), UNDO_VALUE);
    assert_int_equal(undo(), UNDO_WORLD);
    assert_true(is_again(&led, "pool.cols", "undone elsewhere"));
    moment_free(&led);
    close_scene();
}

static void a_change_of_the_camera_takes_it_back(void **state)
{
    (void)state;
    open_scene("assets/scenes/tank.ini");
    undo_moment before = moment_now(true);
    change("camera.x", "3");
    look();
    assert_int_equal(undo(), UNDO_ALL);
    assert_true(is_again(&before, "camera.x", "led on and undone"));
    moment_free(&before);
    close_scene();
}

/* Restores the old value and keeps the current water. */
static void water_that_moved_on_goes_on(void **state)
{
    (void)state;
    open_scene("assets/scenes/tank.ini");
    const tp_scene before = stood.file.scene;
    change("pool.damping", "9");
    tp_world_step(&tp_program_all, stood.world, &stood.file.scene, NULL);
    void *now = copy_of(stood.world, stood.world_bytes);
    assert_int_equal(undo(), UNDO_VALUE);
    assert_memory_equal(&before, &stood.file.scene, sizeof before);
    assert_true(
        tp_world_apply(&tp_program_all, now, &stood.file.scene, &stood.assets.names));
    assert_memory_equal(now, stood.world, stood.world_bytes);
    free(now);
    assert_int_equal(change_row(row_of("pool.cols"), "40", false, false), EXIT_DONE);
    assert_int_equal(undo(), UNDO_VALUE);
    assert_memory_equal(&before, &stood.file.scene, sizeof before);
    close_scene();
}

/* A name from the file becomes the file's again, and gives the same picture. */
static void a_name_of_the_file_is_the_files_again(void **state)
{
    (void)state;
    open_scene("assets/scenes/tank.ini");
    const uint32_t row = row_of("tank.wall");
    const uint32_t line = stood.file.set_at[row];
    assert_in_range(line, 1, 1000);
    change("tank.wall", "assets/textures/foam.png");
    assert_int_equal(stood.file.set_at[row], SET_BY_COMMAND);
    tp_world_step(&tp_program_all, stood.world, &stood.file.scene, NULL);
    assert_int_equal(undo(), UNDO_VALUE);
    assert_int_equal(stood.file.set_at[row], line);
    assert_string_equal(stood.file.scene.tank.wall,
                        "../textures/tiles.png");
    close_scene();
}

/* A number set to its current value, at once or by a drag, leaves no trace. */
static void what_is_no_change_leaves_no_trace(void **state)
{
    (void)state;
    open_scene("assets/scenes/tank.ini");
    undo_moment before = moment_now(false);
    const uint32_t row = row_of("pool.damping");
    const loaded_scene_value value =
        loaded_scene_get(&stood, &tp_params(&(uint32_t){ 0 })[row]);
    change("pool.damping", value.text);
    assert_true(is_again(&before, "pool.damping", "set to what it is"));
    assert_int_equal(change_row(row, "9", true, true), EXIT_DONE);
    assert_int_equal(change_row(row, "8", true, true), EXIT_DONE);
    assert_int_equal(change_row(row, value.text, false, true), EXIT_DONE);
    assert_true(is_again(&before, "pool.damping", "dragged forth and back"));
    assert_int_equal(undo(), UNDO_NOTHING);
    moment_free(&before);
    close_scene();
}

/* -- what is refused --------------------------------------------------------------- */

static void an_undo_that_is_refused_may_be_tried_again(void **state)
{
    (void)state;
    open_scene("assets/scenes/three-swells.ini");
    change("grid.vertices", "9000");
    undo_moment small = moment_now(true);
    given.memory = 1000;                /* the larger world no longer fits */
    assert_int_equal(undo(), UNDO_REFUSED);
    assert_true(is_again(&small, "grid.vertices", "refused"));
    moment_free(&small);
    given.memory = 0;
    assert_int_equal(undo(), UNDO_ALL);
    assert_int_equal(undo(), UNDO_NOTHING);
    close_scene();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_comes_back_to_the_bit),
        cmocka_unit_test(every_name_comes_back_to_the_bit),
        cmocka_unit_test(several_changes_lead_back_and_forth),
        cmocka_unit_test(a_drag_is_undone_as_one),
        cmocka_unit_test(a_camera_that_was_led_since_stays),
        cmocka_unit_test(a_change_of_the_camera_takes_it_back),
        cmocka_unit_test(water_that_moved_on_goes_on),
        cmocka_unit_test(a_name_of_the_file_is_the_files_again),
        cmocka_unit_test(what_is_no_change_leaves_no_trace),
        cmocka_unit_test(an_undo_that_is_refused_may_be_tried_again),
    };
    return cmocka_run_group_tests_name("undo", tests, NULL, NULL);
}
