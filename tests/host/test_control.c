/* SPDX-License-Identifier: MIT */
/* Control on a board: answers to lines; a refused line changes nothing; arbitrary bytes
 * do no harm; the picture is that of the changed scene. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <cmocka.h>
#include "interact/old_names.h"
#include "serial/control.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"
#include "pixel/pixel.h"
#include "world/text.h"
#include "world/world.h"

static const tp_config config = {
    .width = 64, .height = 48, .tile_height = 8, .format = TP_FORMAT_L8
};
static const tp_assets none;

typedef struct {
    tp_scene  scene;
    tp_world *world;
    tp_frame *frame;
    uint64_t *block, *scratch;
    control   control;
    control_setup setup;
    char      said[65536];
    size_t    length;
} board;

static void hear(void *to, const char *text)
{
    board *b = to;
    const size_t bytes = strlen(text);
    assert_true(b->length + bytes < sizeof b->said);
    memcpy(b->said + b->length, text, bytes + 1);
    b->length += bytes;
}

static void board_open(board *b)
{
    const size_t bytes = tp_world_bytes(&tp_program_all, &b->scene, &none);
    b->world = malloc(bytes);
    b->block = malloc(tp_frame_bytes(&config, &b->scene));
    b->scratch = malloc(tp_frame_scratch_bytes(&config, &b->scene));
    assert_int_equal(
        tp_world_init(&tp_program_all, b->world, bytes, &b->scene, &none, NULL), TP_OK);
    assert_int_equal(tp_frame_init(&b->frame, &config, &b->scene, b->block,
                                   tp_frame_bytes(&config, &b->scene), NULL),
                     TP_OK);
    b->setup = (control_setup){ &b->scene, &b->scene, &config, b->world, bytes,
                                hear,      NULL,      b,       NULL };
    control_begin(&b->control, &b->setup);
}

static void board_close(board *b)
{
    free(b->world);
    free(b->block);
    free(b->scratch);
}

/* Waves, a pool and drops; a grid of few cells. */
static int set_up(void **state)
{
    board *b = calloc(1, sizeof *b);
    b->scene = scene_plain();
    b->scene.boat.mesh[0] = '\0';
    b->scene.grid.vertices = 576;
    b->scene.pool.cols = b->scene.pool.rows = 16;
    b->scene.drops.count = 4;
    board_open(b);
    *state = b;
    return 0;
}

static int tear_down(void **state)
{
    board_close(*state);
    free(*state);
    return 0;
}

/* Feeds a text and returns the answer. */
static const char *answer_to(board *b, const char *text, size_t bytes)
{
    b->length = 0;
    b->said[0] = '\0';
    for (size_t i = 0; i < bytes; i++)
        control_byte(&b->control, (uint8_t)text[i]);
    return b->said;
}

static const char *ask(board *b, const char *text)
{
    return answer_to(b, text, strlen(text));
}

static uint32_t draw(board *b)
{
    uint32_t crc = 0;
    tp_tile  tile;
    tp_frame_begin(b->frame, b->world);
    for (uint32_t i = 0; tp_frame_draw_tile(b->frame, i, b->scratch, &tile); i++)
        crc = tp_crc32(crc, tile.pixels, tile.stride * (tile.y1 - tile.y0));
    return crc;
}

/* -- answers ----------------------------------------------------------------------- */

typedef struct { const char *line, *answer; } exchange;

static void hold(board *b, const exchange *e, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(ask(b, e[i].line), e[i].answer))
            fail_msg("to '%s': '%s', not '%s'", e[i].line, b->said, e[i].answer);
}

#define COUNT(list) (sizeof (list) / sizeof (list)[0])

static void lines_are_answered_as_documented(void **state)
{
    static const exchange talk[] = {
        { "set wave0.amplitude 0.8\n", "ok wave0.amplitude = 0.8 m\n" },
        { "get wave0.amplitude\n", "ok wave0.amplitude = 0.8 m of 0..16\n" },
        { "set wave0.amplitude=0.5\r", "ok wave0.amplitude = 0.5 m\n" },
        { "\n", "" },
        { "  set \t wave0.amplitude  =  +.25 \r\n", "ok wave0.amplitude = 0.25 m\n" },
        { "get sky.kind\n",
          "ok sky.kind = gradient of gradient|day|dusk|night|cube\n" },
        { "set water.colour #204060\n", "ok water.colour = #204060\n" },
        { "set tank.sea off\n", "ok tank.sea = off\n" },
        { "set scene.title A pond, ours\n", "ok scene.title = A pond, ours\n" },
        { "list wave3.sp\n", "wave3.speed = 1\nok 1 parameter\n" },
        { "list surf.\n", "surf.tilt_decay = 0.1 1/m\nsurf.widening_decay = 0.11 1/m\n"
                        "surf.flattening_decay = 0.09 1/m\n"
          "surf.stretch = 1\nsurf.irregular = 0.3\nok 5 parameters\n" },
        { "drop\n", "ok drop\n" }, { "poke 1 -2\n", "ok poke\n" },
        { "input light_turn=9 drops=3\n", "ok input\n" },
        { "pause\n", "ok pause\n" }, { "go\n", "ok go\n" },
        { "step\n", "ok step 1\n" }, { "step 30\n", "ok step 30\n" },
        { "state\n", "ok tick 0\n" },
        { "\r\n\r\n \t \n", "" },
    };
    hold(*state, talk, COUNT(talk));
}

/* The world has no room for foam either: the answer names the missing module first. */
static void what_the_program_lacks_is_refused_by_name(void **state)
{
    static const exchange talk[] = {
        { "set foam.cells=64\n", "error foam.cells: the program lacks foam\n" },
        { "get foam.cells\n", "ok foam.cells = 0 cells of 0..256\n" },
        { "set sky.kind night\n", "error sky.kind: the program lacks stars\n" },
        { "get sky.kind\n", "ok sky.kind = gradient of gradient|day|dusk|night|cube\n" },
        { "set wave0.amplitude 0.5\n", "ok wave0.amplitude = 0.5 m\n" },
        { "restart\n", "ok restart\n" },
    };
    const tp_use *all = tp_program_all.modules;
    tp_use use[64];
    tp_lack lacks[3] = { TP_LACK(stars, 0), TP_LACK(foam, 0) };
    tp_program lacking = tp_program_all;
    board *b = *state;
    uint32_t uses = 0;

    for (; all->module; all++)
        if (all->module == &tp_stars_module)
            lacks[0].above = uses;
        else if (all->module == &tp_foam_module)
            lacks[1].above = uses;
        else
            use[uses++] = *all;
    use[uses] = (tp_use){ 0 };
    lacking.modules = use;
    lacking.lacks = lacks;
    lacking.refuse = tp_lacks_check;
    tp_config by = config;
    by.program = &lacking;
    b->setup.config = &by;
    hold(b, talk, COUNT(talk));
    lacking.refuse = NULL;              /* then silently ignored */
    assert_string_equal(ask(b, "set foam.cells=64\n"), "ok foam.cells = 64 cells\n");
}

/* The reply begins with a line that gives the present name. */
static void old_names_are_read_if_the_port_asks_for_them(void **state)
{
    static const exchange refused[] = {
        { "set pool.poke 0.5\n", "error no parameter is called pool.poke\n" },
    };
    static const exchange talk[] = {
        { "set pool.poke 0.5\n", "pool.poke is now called pool.splash_height\n"
                                 "ok pool.splash_height = 0.5 m\n" },
        { "get pool.poke\n", "pool.poke is now called pool.splash_height\n"
                             "ok pool.splash_height = 0.5 m of -16..16\n" },
        { "get pool.splash_height\n", "ok pool.splash_height = 0.5 m of -16..16\n" },
        { "set drops.into=lake\n", "drops.into is now called drops.target\n"
                                   "error drops.target = lake is none of rings|pool\n" },
        { "get pool.pokes\n", "error no parameter is called pool.pokes\n" },
        { "list pool.poke\n", "error 0 parameters\n" },
    };
    board *b = *state;
    hold(b, refused, COUNT(refused));
    b->setup.find = old_name_param;
    hold(b, talk, COUNT(talk));
    assert_int_equal(b->scene.pool.splash_height, TP_FX(0.5));
}

static void wrong_lines_say_what_was_expected(void **state)
{
    static const exchange talk[] = {
        { "set wave0.amplitude 99\n",
          "error wave0.amplitude = 99 is outside 0..16 m\n" },
        { "set wave0.amplitude 1e9\n",
          "error wave0.amplitude = 1e9 is outside 0..16 m\n" },
        { "set wave0.exponent 2.5\n",
          "error wave0.exponent: expected a number, found 2.5\n" },
        { "set wave0.amplitude\n",
          "error wave0.amplitude: expected a number, found \n" },
        { "set sky.kind noon\n",
          "error sky.kind = noon is none of gradient|day|dusk|night|cube\n" },
        { "set tank.sea maybe\n", "error tank.sea = maybe is none of off|on\n" },
        { "set water.colour blue\n", "error water.colour: expected a colour such as "
          "#204060, found blue\n" },
        { "set wave99.amplitude 1\n", "error no parameter is called wave99.amplitude\n" },
        { "set\n", "error no parameter is called \n" },
        { "set layer0.texture x.png\n",
          "error layer0.texture is fixed when a scene is baked\n" },
        { "set grid.vertices 24\n", "error grid.vertices is fixed when a scene is baked\n" },
        { "list wavy\n", "error 0 parameters\n" },
        { "poke 1\n", "error expected poke X Z [HEIGHT], in m\n" },
        { "poke 1 2 3 4\n", "error expected poke X Z [HEIGHT], in m\n" },
        { "poke 1 2x\n", "error expected poke X Z [HEIGHT], in m\n" },
        { "poke 40000 2\n", "error expected poke X Z [HEIGHT], in m\n" },
        { "step -1\n", "error expected step [TICKS], at most 100000\n" },
        { "step 100001\n", "error expected step [TICKS], at most 100000\n" },
        { "step 99999999999\n", "error expected step [TICKS], at most 100000\n" },
        { "step 3 4\n", "error expected step [TICKS], at most 100000\n" },
        { "input height=3\n", "error no input is called height\n" },
        { "SET wave0.amplitude 1\n",
          "error expected set get list drop poke input pause go step restart state\n" },
        { "setwave0.amplitude 1\n",
          "error expected set get list drop poke input pause go step restart state\n" },
    };
    board *b = *state;
    const tp_scene before = b->scene;
    const tp_world world = *b->world;
    hold(b, talk, COUNT(talk));
    assert_memory_equal(&before, &b->scene, sizeof before);
    assert_memory_equal(&world, b->world, sizeof world);
    assert_false(b->control.changed);
    assert_int_equal(control_take(&b->control).push[0].height, 0);
}

static void scenes_without_a_pool_or_drops_say_so(void **state)
{
    board *b = *state;
    board_close(b);
    b->scene.pool.cols = b->scene.drops.count = 0;
    board_open(b);
    assert_string_equal(ask(b, "drop\n"), "error the scene has no drops\n");
    assert_string_equal(ask(b, "poke 1 2\n"), "error the scene has no pool\n");
}

static void a_constant_scene_is_read_but_not_set(void **state)
{
    board *b = *state;
    b->setup.scene = NULL;
    assert_string_equal(ask(b, "set camera.y 9\n"),
                        "error camera.y cannot change: the scene is constant\n");
    assert_string_equal(ask(b, "get camera.y\n"), "ok camera.y = 4 m of -100..2000\n");
}

/* -- memory -------------------------------------------------------------------------- */

static void what_the_world_has_no_room_for_is_taken_back(void **state)
{
    board *b = *state;
    const tp_scene before = b->scene;
    char said[160];
    tp_scene more = b->scene;
    more.pool.rows = 64;
    snprintf(said, sizeof said,
             "error pool.rows = 64 cells needs %zu bytes of the world,"
             " which has %u\n",
             tp_world_bytes(&tp_program_all, &more, &none),
             (unsigned)b->world->layout.bytes);
    const uint32_t crc = draw(b);
    assert_string_equal(ask(b, "set pool.rows 64\n"), said + 0);
    assert_memory_equal(&before, &b->scene, sizeof before);
    assert_int_equal(draw(b), crc);
    assert_string_equal(ask(b, "set pool.courant 0.8\n"),
                        "error pool.courant: pool.courant of 0.800 is above 0.497, the"
                        " bound of this damping; water would not come to rest\n");
    assert_memory_equal(&before, &b->scene, sizeof before);
    assert_string_equal(ask(b, "set pool.max_height 2\n"),
                        "error pool.max_height = 2 m cannot change in a running world\n");
    assert_memory_equal(&before, &b->scene, sizeof before);
}

static void what_the_frame_lacks_memory_for_is_said(void **state)
{
    board *b = *state;
    const char *said = ask(b, "set sky.kind day\n");
    assert_non_null(strstr(said, "ok sky.kind = day, in part: needs "));
    assert_non_null(strstr(said, " bytes of the frame, which has "));
    assert_string_equal(ask(b, "set camera.y 3\n"), "ok camera.y = 3 m\n");
    draw(b);
}

/* -- pictures ------------------------------------------------------------------------ */

static void a_picture_is_that_of_the_scene_so_changed(void **state)
{
    static const char *const lines[] = {
        "set wave0.amplitude 0.9\n", "set camera.y 2.5\n", "set camera.heading 77\n",
        "set camera.pitch -20\n", "set camera.x -3\n", "set camera.z 5\n",
        "set camera.fov 90\n", "set light.elevation 10\n", "set water.colour #ff0000\n",
        "set sky.zenith #000000\n",
    };
    board *b = *state, *fresh = calloc(1, sizeof *fresh);
    for (size_t i = 0; i < COUNT(lines); i++) {
        const uint32_t before = draw(b);
        assert_memory_equal(ask(b, lines[i]), "ok ", 3);
        fresh->scene = b->scene;
        board_open(fresh);
        const uint32_t now = draw(b);
        assert_int_equal(now, draw(fresh));
        if (now == before)
            fail_msg("%s changes nothing", lines[i]);
        board_close(fresh);
    }
    free(fresh);
}

/* An accepted value, at either end of the range, stays in the scene and can be drawn and
 * moved. */
static void every_parameter_takes_its_ends(void **state)
{
    uint32_t count, taken = 0;
    const tp_param *rows = tp_params(&count);
    board *b = *state;
    for (uint32_t i = 0; i < 2 * count; i++) {
        const tp_param *row = &rows[i / 2];
        char line[256], value[32], want[256];
        if (!scene_is_number(row))
            continue;
        tp_param_number_text(row, i % 2 ? row->high : row->low, value, sizeof value);
        snprintf(line, sizeof line, "set %s %s\n", row->name, value);
        const bool ok = memcmp(ask(b, line), "ok ", 3) == 0;
        snprintf(want, sizeof want, "%s %s = %s", ok ? "ok" : "error", row->name, value);
        if (memcmp(b->said, want, strlen(want)) && !strstr(b->said, " is fixed when ")
            && !strstr(b->said, ": pool.") && !strstr(b->said, ": field."))
            fail_msg("to '%s': '%s'", line, b->said);
        assert_true(!ok || *scene_number(&b->scene, row)
                           == (i % 2 ? row->high : row->low));
        taken += ok;
        draw(b);
        tp_world_step(&tp_program_all, b->world, &b->scene, NULL);
    }
    assert_true(taken > count);
}

/* -- input --------------------------------------------------------------------------- */

static void input_is_taken_once(void **state)
{
    board *b = *state;
    ask(b, "drop\ndrop\ninput ahead=0.5 drops=2\npoke 1.5 -2 0.25\n");
    const tp_input first = control_take(&b->control), second = control_take(&b->control);
    const tp_input want = { .forward = TP_FX(0.5),
                            .drops = 4,
                            .push[0] = { TP_FX(0.25), TP_FX(1.5), TP_FX(-2) } };
    assert_memory_equal(&first, &want, sizeof want);
    assert_memory_equal(&second, &(tp_input){ 0 }, sizeof second);
    ask(b, "poke 1 2\ninput turn=5\n");
    assert_int_equal(control_take(&b->control).push[0].height, b->scene.pool.splash_height);
    for (int i = 0; i < 2000; i++)
        ask(b, "drop\n");
    ask(b, "input drops=1000\n");
    assert_int_equal(control_take(&b->control).drops, 1024);
}

/* One tick takes lines of several kinds in order, up to its limit.  A line exceeding the
 * limit is refused as a whole. */
static void every_poke_of_a_tick_is_taken(void **state)
{
    board *b = *state;
    ask(b, "poke 1 2 0.5\ninput poke=0.25 poke_x=3 poke2=0.5 drops=1\npoke 4 5 -1\n");
    tp_input got = control_take(&b->control), want = { .drops = 1 };
    want.push[0] = (tp_push){ TP_FX(0.5), TP_FX(1), TP_FX(2) };
    want.push[1] = (tp_push){ TP_FX(0.25), TP_FX(3), 0 };
    want.push[2] = (tp_push){ TP_FX(0.5), 0, 0 };
    want.push[3] = (tp_push){ TP_FX(-1), TP_FX(4), TP_FX(5) };
    assert_memory_equal(&got, &want, sizeof want);

    for (int i = 0; i < TP_PUSHES - 1; i++)
        ask(b, "poke 1 1\n");
    const tp_input before = b->control.input;
    ask(b, "input poke=1 poke2=1 turn=9\n");
    assert_string_equal(b->said, "error 8 pokes wait for the next tick, the most it"
                                 " takes\n");
    assert_memory_equal(&before, &b->control.input, sizeof before);
    ask(b, "poke 1 1\n");
    assert_string_equal(b->said, "ok poke\n");
    ask(b, "poke 1 1\n");
    assert_non_null(strstr(b->said, "error 8 pokes wait"));
    (void)control_take(&b->control);
    ask(b, "poke 1 1\n");
    assert_string_equal(b->said, "ok poke\n");
}

static void a_step_is_so_many_ticks_and_then_it_pauses(void **state)
{
    board *b = *state;
    uint32_t ticks = 0;
    assert_true(control_reads(&b->control));
    ask(b, "step 30\n");
    assert_false(control_reads(&b->control));
    while (control_ticks(&b->control))
        ticks++;
    assert_int_equal(ticks, 30);
    assert_true(control_reads(&b->control));
    ask(b, "go\n");
    for (int i = 0; i < 100; i++)
        assert_true(control_ticks(&b->control));
}

static void a_restart_is_a_world_of_the_changed_scene(void **state)
{
    board *b = *state, *fresh = calloc(1, sizeof *fresh);
    for (int i = 0; i < 90; i++)
        tp_world_step(&tp_program_all, b->world, &b->scene, NULL);
    ask(b, "set wave0.amplitude 1.2\nset drops.y 3\ndrop\nrestart\n");
    assert_non_null(strstr(b->said, "ok restart\n"));
    fresh->scene = b->scene;
    board_open(fresh);
    assert_memory_equal(b->world, fresh->world, b->world->layout.bytes);
    assert_int_equal(control_take(&b->control).drops, 0);
    board_close(fresh);
    free(fresh);
}

/* -- hostile bytes ------------------------------------------------------------------- */

static void a_bad_line_does_not_cost_the_next(void **state)
{
    char line[4096];
    board *b = *state;
    for (size_t bytes = CONTROL_LINE - 2; bytes < sizeof line - 32; bytes += bytes / 8) {
        memset(line, 'x', bytes);
        strcpy(line + bytes, "\nget camera.y\n");
        const char *said = ask(b, line);
        if (bytes > CONTROL_LINE)
            assert_string_equal(said, "error line longer than 160 bytes\n"
                                      "ok camera.y = 4 m of -100..2000\n");
    }
    for (int byte = 0; byte < 256; byte++) {
        char want[128], odd[] = "get camera.y?\nget camera.y\n";
        if (byte == '\n' || byte == '\r' || byte == '\t' || (byte >= ' ' && byte <= '~'))
            continue;
        odd[12] = (char)byte;
        snprintf(want, sizeof want, "error line with byte %d, which is not text\n"
                 "ok camera.y = 4 m of -100..2000\n", byte);
        assert_string_equal(answer_to(b, odd, sizeof odd - 1), want);
    }
}

static void the_longest_line_is_read_whole(void **state)
{
    char line[CONTROL_LINE + 2];
    board *b = *state;
    memset(line, ' ', sizeof line);
    memcpy(line, "set camera.y", 12);
    memcpy(line + CONTROL_LINE - 3, "7.5\n", 4);
    assert_string_equal(answer_to(b, line, CONTROL_LINE + 1), "ok camera.y = 7.5 m\n");
    memcpy(line + CONTROL_LINE - 2, "7.5\n", 4);
    assert_string_equal(answer_to(b, line, CONTROL_LINE + 2),
                        "error line longer than 160 bytes\n");
}

/* Returns random bytes mixed with words of commands and names. */
static uint8_t any_byte(uint64_t *chance)
{
    static const char text[] = "set get list poke drop input wave0.length = 0.5 #fff\n\n";
    const uint32_t kind = random_below(chance, 400);
    return kind == 0 ? (uint8_t)random_below(chance, 256)
                     : (uint8_t)text[random_below(chance, sizeof text - 1)];
}

static void any_bytes_are_answered_by_lines_of_text(void **state)
{
    uint64_t chance = random_seed();
    board *b = *state;
    for (int n = 0; n < 3000; n++) {
        char bytes[200];
        for (size_t i = 0; i < sizeof bytes; i++)
            bytes[i] = (char)any_byte(&chance);
        if (n % 3 == 0)
            memcpy(bytes, "\nlist wave1\n", 12);
        answer_to(b, bytes, sizeof bytes);
        for (size_t i = 0; i < b->length; i++)
            assert_true(b->said[i] == '\n' || (b->said[i] >= ' ' && b->said[i] <= '~'));
        assert_true(b->length == 0 || b->said[b->length - 1] == '\n');
        ask(b, "\nget camera.pitch\n");
        assert_non_null(strstr(b->said, "ok camera.pitch = -6 degrees of -89..89\n"));
    }
}

int main(void)
{
#define HELD(test) cmocka_unit_test_setup_teardown(test, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        HELD(lines_are_answered_as_documented),
        HELD(what_the_program_lacks_is_refused_by_name),
        HELD(old_names_are_read_if_the_port_asks_for_them),
        HELD(wrong_lines_say_what_was_expected),
        HELD(scenes_without_a_pool_or_drops_say_so),
        HELD(a_constant_scene_is_read_but_not_set),
        HELD(what_the_world_has_no_room_for_is_taken_back),
        HELD(what_the_frame_lacks_memory_for_is_said),
        HELD(a_picture_is_that_of_the_scene_so_changed),
        HELD(every_parameter_takes_its_ends),
        HELD(input_is_taken_once),
        HELD(every_poke_of_a_tick_is_taken),
        HELD(a_step_is_so_many_ticks_and_then_it_pauses),
        HELD(a_restart_is_a_world_of_the_changed_scene),
        HELD(a_bad_line_does_not_cost_the_next),
        HELD(the_longest_line_is_read_whole),
        HELD(any_bytes_are_answered_by_lines_of_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
