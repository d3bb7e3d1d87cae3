/* SPDX-License-Identifier: MIT */
/* Checks the quality plan of shipped scenes: the plan's estimates against drawn frames, and
 * the error that the planned picture adds to the exact one, against the scene's error
 * budget: 95 of 100 pictures keep it.  At worst (night-sea, tick 200: normals=fast) the error
 * is 2.3 times the budget. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "tests/lib/picture_difference.h"
#include "tests/lib/drawings.h"
#include "app/files/path.h"

static uint32_t pictures, kept;

static double rms_between(const drawing *a, const drawing *b)
{
    const size_t pixels = (size_t)width * height;

    return sqrt((double)picture_square_sum(a->pixel, b->pixel, pixels) / 3
                / (double)pixels);
}

static void compare(const loaded_scene *s, uint32_t tick)
{
    static drawing planned, exact;
    const tp_rung_set none = { .of = { 0 } };
    const double most = s->file.scene.quality.error_colour / 65536.0;
    tp_scene scene = s->file.scene;
    tp_view_costs view;

    tp_rung_set_apply(&scene, &none);
    draw(&exact, s, &scene, s->world);
    scene = s->file.scene;
    tp_rung_set_apply_some(&scene, &s->plan.set, s->plan.open);
    draw(&planned, s, &scene, s->world);
    tp_plan_view(&view, &s->file.scene, &s->assets.names, width, height);
    const double off = rms_between(&exact, &planned);
    uint32_t waters = 0;
    for (size_t i = 0; i < width * height; i++)
        waters += exact.water[i];
    printf("    %-13s %3u %5u of %5u pixels, %5u of %5u vertices, %6.2f M; off %.2f of"
           " %.2f\n", s->file.name, tick, view.water, waters, view.estimate.vertices,
           exact.vertices, (double)s->plan.price.cost / 1e6, off, most);
    pictures++;
    kept += off <= most;
    assert_true(off <= 3 * most);
    if (tick == 0)              /* boats, drops and walls hide water */
        assert_true(view.water + width * height / 20 >= waters);
}

static void look_at(const char *name)
{
    char path[160];
    options o = { .command = "plan", .scene = path, .rung = "planned", .width = width,
                  .height = height };
    loaded_scene s;

    snprintf(path, sizeof path, "assets/scenes/%s.ini", name);
    assert_int_equal(loaded_scene_open(&s, &o), 0);
    assert_true(s.plan.price.cost > 0);
    for (uint32_t tick = 0; tick <= LAST; tick++) {
        if (is_looked_at(tick))
            compare(&s, tick);
        tp_world_step(&tp_program_all, s.world, &s.file.scene, NULL);
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
    printf("    %u of %u pictures keep their budget\n", kept, pictures);
    assert_true(kept >= pictures * 95 / 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shipped_scenes_keep_their_budgets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
