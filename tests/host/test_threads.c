/* SPDX-License-Identifier: MIT */
/* Every shipped scene drawn by 1 to 16 threads has the same bits, frame after frame.
 * threads.sh runs this under ThreadSanitizer too, with TP_SCENE_STEP=n for every n-th
 * scene only, and TP_THREAD_STEP=n for 2, 2 + n, ... threads only. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/app/scene/thread_pool.h"
#include "../../ports/app/files/path.h"
#include "../../ports/app/scene/loaded_scene.h"

#define FOLDER "assets/scenes"

enum { FRAMES = 3, THREADS = 16 };

/* CRCs of ticks 20, 21, 22: with rings and spray by then. */
static void draw(loaded_scene *s, options *o, uint32_t threads, uint32_t crc[FRAMES])
{
    o->threads = threads;
    assert_int_equal(loaded_scene_make_world(s), 0);
    assert_int_equal(loaded_scene_open_renderer(s, o), 0);
    for (int i = 0; i < 20; i++)
        tp_world_step(&tp_program_all, s->world, &s->file.scene, NULL);
    for (int i = 0; i < FRAMES; i++) {
        frame_renderer_draw(&s->renderer, s->world);
        crc[i] = picture_crc(&s->renderer.picture);
        tp_world_step(&tp_program_all, s->world, &s->file.scene, NULL);
    }
}

/* The step that a variable of the environment gives, or 1. */
static uint32_t step_given(const char *variable)
{
    const char *given = getenv(variable);
    const uint32_t step = given ? (uint32_t)strtoul(given, NULL, 10) : 1;
    assert_true(step > 0);
    return step;
}

static void check_scene(const char *name)
{
    const uint32_t step = step_given("TP_THREAD_STEP");
    options o = { .command = "test", .scene = name, .width = 144, .height = 108 };
    uint32_t one[FRAMES], many[FRAMES], water;
    loaded_scene s;
    assert_int_equal(loaded_scene_open(&s, &o), 0);
    draw(&s, &o, 1, one);
    water = s.renderer.water_pixels;
    for (uint32_t threads = 2; threads <= THREADS; threads += step) {
        draw(&s, &o, threads, many);
        if (memcmp(one, many, sizeof one) || s.renderer.water_pixels != water)
            fail_msg("%s is another picture by %u threads", name, (unsigned)threads);
    }
    loaded_scene_close(&s);
}

static void every_scene_is_the_same_by_1_to_16_threads(void **state)
{
    const uint32_t step = step_given("TP_SCENE_STEP");
    size_t count;
    (void)state;
    char **names = path_scene_names(FOLDER, &count);
    assert_true(count > 0);
    for (size_t i = 0; i < count; i += step) {
        char *path = path_join(FOLDER, names[i], ".ini");
        check_scene(path);
        free(path);
    }
    path_free_names(names, count);
}

/* -- a thread pool --------------------------------------------------------------- */

enum { JOBS = 2000, HANDS = 7 };

typedef struct { uint32_t calls[HANDS + 1]; } call_tally;

static void count_call(void *user, uint32_t i)
{
    ((call_tally *)user)->calls[i]++;        /* each thread has its own */
}

static void a_crew_begins_each_job_once_and_ends_it(void **state)
{
    thread_pool *c = thread_pool_open(HANDS);
    call_tally all = { { 0 } };
    (void)state;
    for (uint32_t job = 1; job <= JOBS; job++) {
        thread_pool_run(c, count_call, &all);
        assert_int_equal(all.calls[0], job);
        for (int i = 1; i <= HANDS; i++)
            assert_true(all.calls[i] <= job);
    }
    thread_pool_close(c);
}

static void no_crew_is_the_caller_alone(void **state)
{
    call_tally all = { { 0 } };
    (void)state;
    assert_null(thread_pool_open(0));
    thread_pool_run(NULL, count_call, &all);
    thread_pool_close(NULL);
    assert_int_equal(all.calls[0], 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scene_is_the_same_by_1_to_16_threads),
        cmocka_unit_test(a_crew_begins_each_job_once_and_ends_it),
        cmocka_unit_test(no_crew_is_the_caller_alone),
    };
    return cmocka_run_group_tests_name("threads", tests, NULL, NULL);
}
