/* SPDX-License-Identifier: MIT */
/* The module list of a baked program: the parts needed by a scene are found, and no
 * others; a list that draws another picture is refused; parts left out on purpose are
 * reported. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "../../ports/app/files/log.h"
#include <cmocka.h>
#include "../../ports/tools/bake/bake_program.h"
#include "../../ports/app/scene/loaded_scene.h"

/* A loaded scene, and a request for its list at a quick size. */
typedef struct {
    options   options;
    loaded_scene     loaded;
    tp_assets lacking;
    component_search_request request;
} asked;

static void ask(asked *a, const char *scene, bool acts)
{
    memset(a, 0, sizeof *a);
    a->options = (options){ .scene = scene, .texels = 16, .quiet = true };
    assert_int_equal(loaded_scene_load(&a->loaded, &a->options), 0);
    tp_scene *s = &a->loaded.file.scene;
    tp_rung_set_apply_some(s, &a->loaded.plan.set, a->loaded.plan.open);
    const tp_assets *names = &a->loaded.assets.names;
    a->request = (component_search_request){
        .scene = s,
        .assets = names,
        .baked = names,
        .config = { .width = 64, .height = 48, .format = TP_FORMAT_RGB565 },
        .terms = { .format = TP_FORMAT_RGB565, .few = true },
        .acts = acts,
    };
}

static bool has(const component_search_result *found, const char *name)
{
    component_set named = { .has = { false } };
    assert_true(components_add_named(&named, name, strlen(name)));
    for (size_t i = 0; i < component_count; i++)
        if (named.has[i] && found->in.has[i])
            return true;
    return false;
}

/* Each piece of the list, except sky and plain, is run or missed if removed; those two
 * are in every picture. */
static void a_list_has_what_the_scene_needs_and_no_more(void **state)
{
    asked a;
    component_search_result found, again;
    component_list list;
    dry_run run;

    (void)state;
    ask(&a, "assets/scenes/raindrops.ini", false);
    assert_int_equal(component_search_run(&found, &a.request), 0);
    assert_int_equal(component_search_run(&again, &a.request), 0);
    assert_memory_equal(&found.in, &again.in, sizeof found.in);
    assert_true(has(&found, "drop"));
    assert_false(has(&found, "foam") || has(&found, "land") || has(&found, "culling"));
    const dry_run_program by = { &list.program, a.request.scene, a.request.baked };
    components_list_traced(&list, &found.in, &a.request.terms);
    components_forget();
    assert_int_equal(dry_run_open(&run, &by, &a.request.config, false), 0);
    dry_run_picture *want = calloc(run.cameras, sizeof *want);
    assert_int_equal(dry_run_draw(&run, &by, NULL, run.cameras, want, NULL, NULL), 0);
    for (size_t i = 0; i < component_count; i++) {
        component_set less = found.in;
        uint32_t differs;
        less.has[i] = false;
        if (!found.in.has[i] || components[i].kind == COMPONENT_MODULE
            || components_have_run(i) || !strcmp(components[i].name, "sky")
            || !strcmp(components[i].name, "plain"))
            continue;
        components_list(&list, &less, &a.request.terms);
        assert_int_equal(dry_run_draw(&run, &by, NULL, run.cameras, NULL, want, &differs),
                         0);
        if (differs == run.cameras && dry_run_moves_same(&run, &by, run.moments))
            fail_msg("%s %s is in the list, and not needed", component_kind_name(i),
                     components[i].name);
    }
    free(want);
    dry_run_close(&run);
    loaded_scene_close(&a.loaded);
}

/* A camera can dive only if somebody controls it. */
static void cameras_go_where_somebody_may(void **state)
{
    asked a;
    component_search_result own, any;

    (void)state;
    ask(&a, "assets/scenes/minimal.ini", false);
    assert_int_equal(component_search_run(&own, &a.request), 0);
    a.request.acts = true;
    assert_int_equal(component_search_run(&any, &a.request), 0);
    assert_false(has(&own, "deep"));
    assert_true(has(&any, "deep"));
    assert_true(any.pictures >= 100);
    loaded_scene_close(&a.loaded);
}

static void what_draws_another_picture_is_refused(void **state)
{
    asked a;
    component_search_result found;

    (void)state;
    ask(&a, "assets/scenes/minimal.ini", false);
    a.lacking = *a.request.assets;
    a.request.baked = &a.lacking;
    assert_int_equal(component_search_run(&found, &a.request), 0);
    assert_non_null(a.lacking.layer[0]);
    a.lacking.layer[0] = NULL;
    assert_int_equal(component_search_run(&found, &a.request), EXIT_CHECK);
    loaded_scene_close(&a.loaded);
}

/* The smallest assets are tried first; insufficient assets are refused if others
 * suffice. */
static void lean_assets_are_tried_first(void **state)
{
    asked a;
    component_search_result found;

    (void)state;
    ask(&a, "assets/scenes/minimal.ini", false);
    a.lacking = *a.request.assets;
    a.lacking.foam = NULL;
    a.request.lean = &a.lacking;
    assert_int_equal(component_search_run(&found, &a.request), 0);
    assert_true(found.lean);
    a.lacking.layer[0] = NULL;
    assert_int_equal(component_search_run(&found, &a.request), 0);
    assert_false(found.lean);
    loaded_scene_close(&a.loaded);
}

static void pieces_are_added_and_left_out_by_name(void **state)
{
    asked a;
    component_search_result found;

    (void)state;
    ask(&a, "assets/scenes/minimal.ini", false);
    assert_true(components_add_named(&a.request.with, "foam", 4));
    assert_true(components_add_named(&a.request.without, "haze", 4));
    assert_true(components_add_named(&a.request.without, "spray", 5));
    assert_false(components_add_named(&a.request.without, "spra", 4));
    assert_int_equal(component_search_run(&found, &a.request), 0);
    assert_true(has(&found, "foam"));
    assert_false(has(&found, "haze"));
    for (size_t i = 0; i < component_count; i++) {
        assert_false(a.request.with.has[i] && !found.in.has[i]);
        if (!strcmp(components[i].name, "spray"))
            assert_false(found.lacks.has[i]);
    }
    bool lacks_haze = false;
    for (size_t i = 0; i < component_count; i++)
        lacks_haze |= found.lacks.has[i] && !strcmp(components[i].name, "haze");
    assert_true(lacks_haze);
    loaded_scene_close(&a.loaded);
}

static void modules_bring_the_models_that_they_work_on(void **state)
{
    static const char *const asked_for[][2] = { { "drops", "rings" },
                                                { "field", "pools" },
                                                { "coastal", "coastal" } };
    (void)state;
    for (size_t n = 0; n < sizeof asked_for / sizeof *asked_for; n++) {
        component_set set = { .has = { false } };
        bool there = false;
        components_add_named(&set, asked_for[n][0], strlen(asked_for[n][0]));
        components_add_models(&set);
        for (size_t i = 0; i < component_count; i++)
            there |= set.has[i] && components[i].kind == COMPONENT_WATER
                     && strcmp(components[i].name, asked_for[n][1]) == 0;
        assert_true(there);
    }
}

/* A scene allowed to change: each module is in the list, left out on purpose, or
 * refused.  Modules switched on are drawn by all their stages except fast stages,
 * visible or not. */
static void what_may_not_be_switched_on_is_refused(void **state)
{
    asked a;
    component_search_result found;
    uint32_t refused = 0, undrawn = 0;

    (void)state;
    ask(&a, "assets/scenes/minimal.ini", false);
    assert_int_equal(component_search_run(&found, &a.request), 0);
    for (size_t i = 0; i < component_count; i++)
        assert_false(found.refused.has[i]);
    a.request.terms.checks = true;
    components_add_named(&a.request.with, "foam", 4);
    components_add_named(&a.request.without, "spray", 5);
    assert_int_equal(component_search_run(&found, &a.request), 0);
    for (size_t i = 0; i < component_count; i++) {
        const bool module = components[i].kind == COMPONENT_MODULE;
        const int where =
            found.in.has[i] + found.refused.has[i] + a.request.without.has[i];
        assert_int_equal(module ? where : found.refused.has[i], module);
        if (module && found.refused.has[i])
            assert_false(component_is_active(i, &found.in, &a.request.terms,
                                             a.request.scene, a.request.assets));
        refused += found.refused.has[i];
        undrawn += module && found.in.has[i] && components[i + 1].kind == COMPONENT_DRAWING
                   && !found.in.has[i + 1];
    }
    assert_true(refused > 20);
    assert_int_equal(undrawn, 0);
    assert_true(has(&found, "underwater") && has(&found, "texture_linear"));
    assert_false(has(&found, "quick_bend"));
    loaded_scene_close(&a.loaded);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_list_has_what_the_scene_needs_and_no_more),
        cmocka_unit_test(cameras_go_where_somebody_may),
        cmocka_unit_test(what_draws_another_picture_is_refused),
        cmocka_unit_test(lean_assets_are_tried_first),
        cmocka_unit_test(pieces_are_added_and_left_out_by_name),
        cmocka_unit_test(modules_bring_the_models_that_they_work_on),
        cmocka_unit_test(what_may_not_be_switched_on_is_refused),
    };
    return cmocka_run_group_tests_name("dry find", tests, NULL, NULL);
}
