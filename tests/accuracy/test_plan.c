/* SPDX-License-Identifier: MIT */
/* Checks the quality plan of shipped scenes: the plan's estimates against drawn frames, and
 * the error that the planned picture adds to the error of the exact rungs, against the
 * scene's error budget. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "tests/lib/quality_error.h"
#include "app/files/path.h"

/* Compares the planned picture with the reference picture of outlines, and if that is not
 * enough with that of shading, which takes longer: the error is at most the plan's estimate
 * above the error of the exact rungs with all waves. */
static void compare(const loaded_scene *s, const tp_plan_report *r, uint32_t tick)
{
    static truth_drawing planned, exact, truth;
    tp_scene scene = s->file.scene;
    const double px_most = r->total.error_px / 65536.0;
    const double rms_most = r->total.error_colour / 65536.0;

    draw(&planned, s, &scene, s->world);
    scene = exact_scene(s);
    draw(&exact, s, &scene, s->world);
    draw_truth(&truth, s, s->world, 1);
    error more = beyond(error_of(&truth, &planned), error_of(&truth, &exact));
    if (more.px > px_most || more.colour > rms_most) {
        draw_truth(&truth, s, s->world, 2);
        const error mean = beyond(error_of(&truth, &planned), error_of(&truth, &exact));
        more = (error){ fmin(more.px, mean.px), fmin(more.colour, mean.colour) };
    }
    uint32_t waters = 0;
    for (size_t i = 0; i < width * height; i++)
        waters += exact.water[i] >= 2;
    printf("    %-13s %3u %5u of %5u pixels, %5u of %5u vertices, %6.2f M; off %.2f px of"
           " %.2f, %.2f of %.2f\n", s->file.name, tick, r->water_pixels, waters,
           r->vertices, exact.vertices, (double)r->total.cost / 1e6, more.px, px_most,
           more.colour,
           rms_most);
    assert_true(more.px <= px_most && more.colour <= rms_most);
    if (tick == 0)              /* boats, drops and walls hide water */
        assert_true(r->water_pixels + width * height / 20 >= waters);
}

static bool names_any(const tp_scene *s)
{
    return s->quality.visibility || s->quality.shading || s->quality.rate;
}

static void look_at(const char *name)
{
    char path[160];
    options o = { .command = "plan", .scene = path, .width = width, .height = height };
    loaded_scene s;

    snprintf(path, sizeof path, "assets/scenes/%s.ini", name);
    assert_int_equal(loaded_scene_open(&s, &o), 0);
    const tp_scene *scene = &s.file.scene;
    const tp_plan_report r = tp_plan_make(scene, &s.assets.names, width, height);
    assert_true(r.total.known);
    if (!names_any(scene)) {
        assert_true(r.total.error_px <= scene->quality.error_px);
        assert_true(r.total.error_colour <= scene->quality.error_colour);
    }
    for (uint32_t tick = 0; tick <= LAST; tick++) {
        if (is_looked_at(tick))
            compare(&s, &r, tick);
        tp_world_step(&tp_program_all, s.world, scene, NULL);
    }
    loaded_scene_close(&s);
}

static void shipped_scenes_keep_their_budgets(void **state)
{
    size_t count;
    char **names = path_scene_names("assets/scenes", &count);

    (void)state;
    assert_true(count > 10);
    for (uint32_t size = 1; size <= 2; size++) {
        width = 160 * size;
        height = 120 * size;
        for (size_t i = 0; i < count; i++)
            look_at(names[i]);
    }
    path_free_names(names, count);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shipped_scenes_keep_their_budgets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
