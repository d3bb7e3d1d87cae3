/* SPDX-License-Identifier: MIT */
/* Figures of the preview, from invented times and from a scene. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/app/session/performance_texts.h"
#include "../../ports/app/scene/stopwatch.h"
#include "../../ports/app/files/timing.h"
#include "frame/tools.h"

#define SEA "assets/scenes/three-swells.ini"

enum { MS = 1000, SECOND = 1000000 };

static panel_performance shown_of(performance *f, uint64_t now)
{
    panel_performance p;

    performance_fill(f, now, &p);
    return p;
}

static const panel_time *part_of(const panel_performance *p, const char *name)
{
    for (uint32_t i = 0; i < p->part_count; i++)
        if (strcmp(p->parts[i].name, name) == 0)
            return &p->parts[i];
    return NULL;
}

/* ------------------------------------------------------------------------------------ */

static void nothing_is_told_of_nothing(void **state)
{
    performance *f = performance_begin();
    (void)state;
    const panel_performance p = shown_of(f, SECOND);
    assert_true(p.pictures == 0 && p.part_count == 0 && p.stage_count == 0);
    assert_true(p.median_ms <= 0 && p.latency_ms <= 0 && p.shown_per_s <= 0);
    assert_float_equal(p.limit_ms, 16.6667, 1e-3);
    assert_string_equal(p.ram, "");
    assert_string_equal(p.plan, "");
    assert_string_equal(p.state, "");
    performance_end(f);
    performance_end(NULL);
}

static void the_newest_picture_is_the_last(void **state)
{
    performance *f = performance_begin();
    (void)state;
    for (uint32_t i = 1; i <= 3; i++)
        performance_end_picture(f, i * MS);
    panel_performance p = shown_of(f, SECOND);
    assert_int_equal(p.pictures, 3);
    assert_float_equal(p.history[PANEL_HISTORY - 1], 3, 0);
    assert_float_equal(p.history[PANEL_HISTORY - 3], 1, 0);
    assert_float_equal(p.history[PANEL_HISTORY - 4], 0, 0);
    assert_float_equal(p.median_ms, 2, 0);
    for (uint32_t i = 4; i <= 1000; i++)
        performance_end_picture(f, i * MS);
    p = shown_of(f, SECOND);
    assert_int_equal(p.pictures, 1000);
    for (uint32_t i = 0; i < PANEL_HISTORY; i++)
        assert_int_equal((int)p.history[i], 761 + i);
    assert_float_equal(p.median_ms, 970.5, 0);          /* of the last 60 frames */
    performance_end(f);
}

static void parts_add_up_to_the_whole(void **state)
{
    performance *f = performance_begin();
    (void)state;
    for (int i = 0; i < 100; i++) {
        performance_add_time(f, PERFORMANCE_WORLD, 500);
        performance_add_time(f, PERFORMANCE_WORLD, 500);             /* a second tick */
        performance_add_time(f, PERFORMANCE_PIXELS, i % 2 ? 7000 : 9000);
        performance_end_picture(f, i < 40 ? 50000 : 10000);
    }
    const panel_performance p = shown_of(f, SECOND);
    assert_int_equal(p.part_count, 3);
    assert_string_equal(p.parts[0].name, "water moves");
    assert_float_equal(part_of(&p, "water moves")->mean, 1000, 0.01);
    assert_float_equal(part_of(&p, "water moves")->share, 0.1, 1e-5);
    assert_float_equal(part_of(&p, "pixels")->mean, 8000, 0.01);
    assert_float_equal(part_of(&p, "the rest")->mean, 1000, 0.01);
    assert_float_equal(part_of(&p, "the rest")->share, 0.1, 1e-5);
    assert_null(part_of(&p, "panel"));
    performance_end(f);
}

static void an_input_waits_for_its_picture(void **state)
{
    performance *f = performance_begin();
    const uint64_t at = 5 * SECOND;
    (void)state;
    performance_note_shown(f, at);
    performance_note_input(f, at + 2 * MS);
    performance_note_input(f, at + 9 * MS); /* the first input counts */
    performance_note_shown(f, at + 22 * MS);
    performance_note_shown(f, at + 39 * MS);                     /* answers no input */
    assert_float_equal(shown_of(f, at + 40 * MS).latency_ms, 20, 1e-4);
    performance_note_input(f, at + 40 * MS);
    performance_note_shown(f, at + 70 * MS);
    assert_float_equal(shown_of(f, at + 71 * MS).latency_ms, 25, 1e-4);
    for (int i = 0; i < 15; i++) {
        performance_note_input(f, at + SECOND);
        performance_note_shown(f, at + SECOND + 8 * MS);
    }
    assert_float_equal(shown_of(f, at + 2 * SECOND).latency_ms, 8, 1e-4);
    performance_end(f);
}

static void the_rate_is_that_of_the_last_second(void **state)
{
    performance *f = performance_begin();
    uint64_t now = SECOND;
    (void)state;
    for (int i = 0; i < 300; i++)
        performance_note_shown(f, now += 10 * MS);
    assert_float_equal(shown_of(f, now).shown_per_s, 100, 1e-3);
    for (int i = 0; i < 120; i++)
        performance_note_shown(f, now += 20 * MS);
    assert_float_equal(shown_of(f, now).shown_per_s, 50, 1e-3);
    assert_true(shown_of(f, now + 2 * SECOND).shown_per_s <= 0);
    performance_end(f);
}

/* -- a real scene -------------------------------------------------------------------- */

static void open_scene(loaded_scene *s, const char **settings, uint32_t n)
{
    const options o = { .command = "test", .scene = SEA, .width = 160, .height = 120,
                        .threads = 2, .settings = settings, .n_settings = n };

    assert_int_equal(loaded_scene_open(s, &o), 0);
}

static void the_dearest_stages_come_first(void **state)
{
    performance *f = performance_begin();
    loaded_scene s;
    (void)state;
    open_scene(&s, NULL, 0);
    stopwatch_use(&s.renderer, true);
    performance_set_stopwatch(f, true);
    assert_int_equal(shown_of(f, SECOND).stage_count, 0);
    for (int i = 0; i < 4; i++) {
        frame_renderer_draw(&s.renderer, s.world);
        performance_end_picture(f, 1000);
    }
    assert_int_equal(shown_of(f, SECOND + MS).stage_count, 0);          /* not yet */
    panel_performance p = shown_of(f, SECOND + 300 * MS);
    assert_in_range(p.stage_count, 8, 30);
    float share = 0;
    for (uint32_t i = 0; i < p.stage_count; i++) {
        assert_true(i == 0 || p.stages[i].mean <= p.stages[i - 1].mean);
        assert_true(p.stages[i].mean > 0 && p.stages[i].mean < 1e6f);
        share += p.stages[i].share;
    }
    assert_float_equal(share, 1, 1e-3);
    assert_int_equal(stopwatch_ns(0), 0);
    p = shown_of(f, SECOND + 600 * MS);                 /* paused: they stay */
    assert_in_range(p.stage_count, 8, 30);
    performance_set_stopwatch(f, false);
    assert_int_equal(shown_of(f, SECOND + 900 * MS).stage_count, 0);
    loaded_scene_close(&s);
    performance_end(f);
}

/* Returns the number behind "use" in a list of memory. */
static size_t bytes_of(const char *list, const char *use)
{
    const char *at = strstr(list, use);
    size_t bytes = 0;

    if (!at)
        fail_msg("no %s in %s", use, list);
    for (at += strlen(use) + 1; *at && *at != '\n'; at++)
        if (*at != ',')
            bytes = bytes * 10 + (size_t)(*at - '0');
    return bytes;
}

static void memory_is_that_of_the_scene(void **state)
{
    performance *f = performance_begin();
    performance_plan kept = { .made = false };
    loaded_scene s;
    (void)state;
    open_scene(&s, NULL, 0);
    performance_describe_scene(f, &kept, &s, NULL);
    const char *ram = shown_of(f, SECOND).ram;
    assert_int_equal(bytes_of(ram, "frame"), tp_frame_ram(s.renderer.frame).frame);
    assert_int_equal(bytes_of(ram, "frame"), s.renderer.frame_bytes);
    assert_int_equal(bytes_of(ram, "scratches"), s.renderer.scratch_bytes);
    assert_int_equal(bytes_of(ram, "world"), s.world_bytes);
    assert_int_equal(bytes_of(ram, "textures"), s.assets.texture_bytes);
    assert_int_equal(bytes_of(ram, "picture"), 160 * 120 * 4);
    assert_non_null(strstr(ram, "picture\t76,800\n"));
    assert_int_equal(bytes_of(ram, "in all"),
                     s.renderer.frame_bytes + s.renderer.scratch_bytes + s.world_bytes
                         + 160 * 120 * 4 + s.assets.mesh_bytes + s.assets.texture_bytes);
    loaded_scene_close(&s);
    performance_end(f);
}

static void the_plan_follows_the_scene(void **state)
{
    performance *f = performance_begin();
    performance_plan kept = { .made = false };
    char want[64];
    loaded_scene s;
    (void)state;
    open_scene(&s, NULL, 0);
    performance_describe_scene(f, &kept, &s, NULL);
    const tp_plan plan = tp_plan_make(&s.file.scene, &s.assets.names, 160, 120);
    panel_performance p = shown_of(f, SECOND);
    snprintf(want, sizeof want, "*0\t%.2f M, off ", (double)plan.price.cost / 1e6);
    assert_memory_equal(p.plan, want, strlen(want));
    assert_non_null(strstr(p.plan, "\tthe plan\n1\t"));
    assert_non_null(strstr(p.plan, "\n1\t"));
    assert_int_equal(scene_file_set(&s.file, "quality.lines=half"), 0);
    performance_describe_scene(f, &kept, &s, NULL);
    assert_int_not_equal(strncmp(shown_of(f, SECOND).plan, want, strlen(want)), 0);
    loaded_scene_close(&s);
    performance_end(f);
}

/* With a board the plan is the board's, and the last line tells what it does. */
static void a_board_is_told(void **state)
{
    const char *settings[] = { "quality.board=stm32f405", "quality.frame_ms=1000" };
    performance *f = performance_begin();
    performance_plan kept = { .made = false };
    loaded_scene s;
    (void)state;
    open_scene(&s, settings, 2);
    performance_describe_scene(f, &kept, &s, NULL);
    const char *board = strstr(shown_of(f, SECOND).plan, "\nstm32f405\t");
    assert_non_null(board);
    assert_non_null(strstr(board, " pictures/s\tin time"));
    loaded_scene_close(&s);
    settings[1] = "quality.frame_ms=0.1";
    open_scene(&s, settings, 2);
    performance_describe_scene(f, &kept, &s, NULL);
    assert_non_null(strstr(shown_of(f, SECOND).plan, " pictures/s\ttoo slow"));
    loaded_scene_close(&s);
    performance_end(f);
}

static void a_governors_step_is_told(void **state)
{
    const char *settings[] = { "quality.frame_ms=4", "quality.visibility=auto" };
    performance *f = performance_begin();
    performance_plan kept = { .made = false };
    frame_governor g;
    loaded_scene s;
    (void)state;
    open_scene(&s, settings, 2);
    frame_governor_begin(&g, &s);
    assert_true(frame_governor_is_active(&g));
    performance_describe_scene(f, &kept, &s, &g);
    assert_memory_equal(shown_of(f, SECOND).plan, "*0\t", 3);
    assert_float_equal(shown_of(f, SECOND).limit_ms, 4, 1e-3);
    for (uint32_t i = 0; i < 64 && g.governor.at == 0; i++)
        tp_governor_add_frame_time(&g.governor, 20000);
    assert_true(g.governor.at > 0);
    performance_describe_scene(f, &kept, &s, &g);
    char star[16];
    snprintf(star, sizeof star, "\n*%u\t", (unsigned)g.governor.at);
    assert_non_null(strstr(shown_of(f, SECOND).plan, star));
    performance_describe_scene(f, &kept, &s, NULL);
    assert_float_equal(shown_of(f, SECOND).limit_ms, 16.6667, 1e-3);
    loaded_scene_close(&s);
    performance_end(f);
}

static void a_state_is_one_line(void **state)
{
    performance *f = performance_begin();
    loaded_scene s;
    (void)state;
    open_scene(&s, NULL, 0);
    tp_world_step(&tp_program_all, s.world, &s.file.scene, NULL);
    performance_describe_world(f, &s, "tape of 3 s");
    const char *text = shown_of(f, SECOND).state;
    assert_memory_equal(text, "tick 1, clock 1, camera at ", 27);
    assert_non_null(strstr(text, "; tape of 3 s"));
    performance_describe_world(f, &s, "");
    assert_null(strchr(shown_of(f, SECOND).state, ';'));
    loaded_scene_close(&s);
    performance_end(f);
}

static void a_canvas_tells_its_two_parts(void **state)
{
    loaded_scene s;
    (void)state;
    open_scene(&s, NULL, 0);
    const uint64_t begin = now_us();
    frame_renderer_draw(&s.renderer, s.world);
    const uint64_t took = now_us() - begin;
    assert_true(s.renderer.begin_us + s.renderer.tiles_us <= took + 1);
    assert_true(s.renderer.tiles_us > 0);
    loaded_scene_close(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_told_of_nothing),
        cmocka_unit_test(the_newest_picture_is_the_last),
        cmocka_unit_test(parts_add_up_to_the_whole),
        cmocka_unit_test(an_input_waits_for_its_picture),
        cmocka_unit_test(the_rate_is_that_of_the_last_second),
        cmocka_unit_test(the_dearest_stages_come_first),
        cmocka_unit_test(memory_is_that_of_the_scene),
        cmocka_unit_test(the_plan_follows_the_scene),
        cmocka_unit_test(a_board_is_told),
        cmocka_unit_test(a_governors_step_is_told),
        cmocka_unit_test(a_state_is_one_line),
        cmocka_unit_test(a_canvas_tells_its_two_parts),
    };
    return cmocka_run_group_tests_name("figures", tests, NULL, NULL);
}
