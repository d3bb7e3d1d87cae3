/* SPDX-License-Identifier: MIT */
/* Timed stages draw the same bits, and their times sum up to a frame's time.  TP_SOAK=1
 * prints the cost of timing. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/app/files/path.h"
#include "../../ports/app/scene/loaded_scene.h"
#include "../../ports/app/scene/stopwatch.h"
#include "../../ports/app/files/timing.h"

#define FOLDER "assets/scenes"
#define SCENE  FOLDER "/three-swells.ini"

enum { TICKS = 20 };

static void open_scene(loaded_scene *s, const char *scene, uint32_t width, uint32_t threads)
{
    const options o = { .command = "test", .scene = scene, .width = width,
                        .height = width * 3 / 4, .threads = threads };

    assert_int_equal(loaded_scene_open(s, &o), 0);
    for (int i = 0; i < TICKS; i++)
        tp_world_step(&tp_program_all, s->world, &s->file.scene, NULL);
}

static uint32_t crc_of(loaded_scene *s, bool timed)
{
    stopwatch_use(&s->renderer, timed);
    frame_renderer_draw(&s->renderer, s->world);
    return picture_crc(&s->renderer.picture);
}

static uint32_t place_of(const char *name)
{
    for (uint32_t i = 0; i < stopwatch_stages; i++)
        if (strcmp(stopwatch_name[i], name) == 0)
            return i;
    fail_msg("no stage %s", name);
    return 0;
}

static uint64_t sum_ns(void)
{
    uint64_t sum = 0;

    for (uint32_t i = 0; i < stopwatch_stages; i++)
        sum += stopwatch_ns(i);
    return sum;
}

/* ------------------------------------------------------------------------------------ */

static void check_scene(const char *path)
{
    loaded_scene s;

    open_scene(&s, path, 128, 1);
    const uint32_t plain = crc_of(&s, false);
    for (uint32_t threads = 1; threads <= 2; threads++) {
        const options o = { .width = 128, .height = 96, .threads = threads };
        assert_int_equal(loaded_scene_open_renderer(&s, &o), 0);
        stopwatch_zero();
        if (crc_of(&s, true) != plain || sum_ns() == 0)
            fail_msg("%s is another picture when timed, by %u threads", path,
                     (unsigned)threads);
    }
    assert_int_equal(crc_of(&s, false), plain);
    loaded_scene_close(&s);
}

static void every_scene_has_the_same_bits_timed(void **state)
{
    size_t count;
    char **names = path_scene_names(FOLDER, &count);
    (void)state;
    assert_true(count > 0);
    for (size_t i = 0; i < count; i++) {
        char *path = path_join(FOLDER, names[i], ".ini");
        check_scene(path);
        free(path);
    }
    path_free_names(names, count);
}

/* Draws a picture, timed: its stages take no longer than it does. */
static bool shading_takes_over_an_eighth(loaded_scene *s)
{
    stopwatch_zero();
    const uint64_t begin = now_us();
    crc_of(s, true);
    const uint64_t most = 1000 * (now_us() - begin + 1);
    assert_true(sum_ns() < most + most / 50);   /* measured by two clocks */
    return sum_ns() > most / 8;
}

static void what_is_timed_is_what_is_drawn(void **state)
{
    loaded_scene s;
    (void)state;
    open_scene(&s, SCENE, 320, 1);
    stopwatch_zero();
    assert_int_equal(sum_ns(), 0);
    crc_of(&s, false);
    assert_int_equal(sum_ns(), 0);              /* none while off */

    crc_of(&s, true);
    bool over = false;          /* another process may stop a picture between two stages */
    for (int tries = 0; tries < 5 && !over; tries++)
        over = shading_takes_over_an_eighth(&s);
    assert_true(over);
    assert_true(stopwatch_ns(place_of("sky_cube_hdr")) > 0);
    assert_int_equal(stopwatch_ns(place_of("spray")), 0);       /* the scene has no spray */
    assert_int_equal(stopwatch_ns(stopwatch_stages), 0);
    loaded_scene_close(&s);
}

static void threads_add_up(void **state)
{
    uint64_t one = UINT64_MAX, two = UINT64_MAX;        /* the least of 20 */
    loaded_scene s;
    (void)state;
    open_scene(&s, SCENE, 320, 1);
    crc_of(&s, true);
    for (int i = 0; i < 20; i++) {
        stopwatch_zero();
        crc_of(&s, true);
        one = sum_ns() < one ? sum_ns() : one;
    }
    loaded_scene_close(&s);
    for (int crews = 0; crews < 20; crews++) {  /* more threads than places in all */
        open_scene(&s, SCENE, 320, 2);
        stopwatch_zero();
        crc_of(&s, true);
        two = sum_ns() < two ? sum_ns() : two;
        loaded_scene_close(&s);
    }
    assert_in_range(two, one / 4, one * 8);     /* the machine may be busy */
}

static void a_timed_program_has_the_stages_that_it_had(void **state)
{
    tp_program program = tp_program_all;
    const machine poor = { "poor", &program };
    loaded_scene s;
    (void)state;
    program.stage.view = NULL;
    open_scene(&s, SCENE, 128, 1);
    s.renderer.machine = &poor;
    stopwatch_use(&s.renderer, true);
    assert_null(s.renderer.program.stage.view);
    assert_ptr_not_equal(s.renderer.program.stage.sky, program.stage.sky);
    stopwatch_use(&s.renderer, false);
    assert_memory_equal(&s.renderer.program.stage, &program.stage, sizeof program.stage);
    loaded_scene_close(&s);
}

/* -- cost of timing -------------------------------------------------------------------- */

enum { ROUNDS = 60 };

static void its_cost_is_told(void **state)
{
    timings times[2] = { { 0 }, { 0 } };
    loaded_scene s;
    (void)state;
    open_scene(&s, SCENE, 640, 1);
    for (int i = 0; i < 2 * ROUNDS; i++) {
        stopwatch_use(&s.renderer, i % 2);
        const uint64_t begin = now_us();
        frame_renderer_draw(&s.renderer, s.world);
        timings_add(&times[i % 2], now_us() - begin);
    }
    const double plain = timings_median(&times[0]), timed = timings_median(&times[1]);
    print_message("%.2f ms a frame, timed %.2f: %.3f times as long\n", plain / 1000,
                  timed / 1000, timed / plain);
    assert_true(timed < 1.25 * plain);
    timings_free(&times[0]);
    timings_free(&times[1]);
    loaded_scene_close(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scene_has_the_same_bits_timed),
        cmocka_unit_test(what_is_timed_is_what_is_drawn),
        cmocka_unit_test(threads_add_up),
        cmocka_unit_test(a_timed_program_has_the_stages_that_it_had),
    };
    const struct CMUnitTest told[] = { cmocka_unit_test(its_cost_is_told) };
    const int failed = cmocka_run_group_tests_name("stopwatch", tests, NULL, NULL);
    return failed || !getenv("TP_SOAK")     /* slow; the times are for people */
         ? failed : cmocka_run_group_tests_name("its cost", told, NULL, NULL);
}
