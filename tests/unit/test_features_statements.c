/* SPDX-License-Identifier: MIT */
/* A module's own statement is the single source: the frame's memory, the drawn passes and
 * the plan's counts agree with the statement in random scenes, and a scene gets the fast
 * stages that the plan promised. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/frame.h"
#include "tests/lib/scenes.h"
#include "quality/prices.h"
#include "tests/lib/frames.h"

enum { SCENES = 1000 };

static uint64_t chance;
static test_kit kit;

typedef struct {
    int drawn, fast, exact, on[TP_MODULES];
} truth_tally;

static void compare_modules(const tp_frame *frame, tp_module_conditions want,
                            truth_tally *t)
{
    const tp_use *u = frame->program->modules;

    for (uint32_t i = 0; u[i].module; i++) {
        const bool on = tp_module_ask_condition(u[i].module, &want);
        const bool seen = on && u[i].drawing;
        assert_int_equal(frame->buffers.laid >> i & 1, seen);
        assert_int_equal(frame->modules_on >> i & 1, seen);
        if (u[i].drawing && u[i].drawing->layout)
            assert_int_equal(tp_frame_module_memory(frame, u[i].module->id) != NULL, on);
        if (u[i].module->bytes)
            assert_int_equal(tp_world_module_state(frame->world, u[i].module->id) != NULL,
                             on);
        t->on[i] += on;
    }
}

static void compare_scene(truth_tally *t)
{
    tp_scene scene = kit_scene(&chance, 196, 40);
    tp_assets assets = kit_assets(&kit, &scene, &chance);
    const tp_config config = {
        .width = 64, .height = 48, .tile_height = 48, .format = TP_FORMAT_XRGB8888
    };

    if (random_below(&chance, 2))           /* the fast stages support none of these */
        scene.water.clarity = scene.hdr.share = scene.foam.cells = 0;
    scene.quality.shading = TP_SHADING_QUICK;
    scene.quality.rate = TP_RATE_FULL;
    if (tp_scene_check(&scene, NULL) != TP_OK)
        return;
    tp_world *world = scene_world(&scene, &assets);
    if (!world)
        return;
    const tp_plan_input in = { tp_program_all.modules, &scene, &assets, 64, 48 };
    const tp_view_estimate told = tp_view_estimate_make(&in);
    test_frame f = frame_by(&tp_program_all, &scene, &assets, &config);
    tp_frame_begin(f.frame, world);
    const tp_module_conditions want = tp_frame_module_conditions(
        &tp_program_all, &f.frame->buffers, &scene, &f.frame->assets, &f.frame->config);
    compare_modules(f.frame, want, t);
    const bool fast = tp_frame_list(f.frame, TP_MARK_WATER)->kind == TP_LIST_FAST;
    if (!f.frame->under)
        assert_int_equal(fast, told.quick);
    t->drawn++;
    t->fast += fast;
    t->exact += !fast;
    frame_free(&f);
    free(world);
}

static void plan_frame_and_modules_agree_on_random_scenes(void **state)
{
    (void)state;
    truth_tally t = { .drawn = 0 };

    for (int i = 0; i < SCENES; i++)
        compare_scene(&t);
    printf("# %d drawn, %d fast, %d exact; modules on:", t.drawn, t.fast, t.exact);
    for (uint32_t i = 0; tp_program_all.modules[i].module; i++) {
        printf(" %s %d", tp_program_all.modules[i].module->name, t.on[i]);
        assert_true(t.on[i] > 0);
        if (!(tp_program_all.modules[i].module->is & TP_MODULE_UNDERWATER)) /* always on */
            assert_true(t.on[i] < t.drawn);
    }
    printf("\n");
    assert_true(t.fast > 20 && t.exact > 20);
}

static void modules_have_ids_of_their_own(void **state)
{
    const tp_use *u = tp_program_all.modules;

    (void)state;
    for (uint32_t i = 0; u[i].module; i++)
        for (uint32_t k = 0; k < i; k++)
            if (u[k].module->id == u[i].module->id)
                fail_msg("%s has the id of %s", u[i].module->name, u[k].module->name);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(modules_have_ids_of_their_own),
        cmocka_unit_test(plan_frame_and_modules_agree_on_random_scenes),
    };
    chance = random_seed();
    kit_make(&kit, &chance);
    return cmocka_run_group_tests_name("features/statements", tests, NULL, NULL);
}
