/* SPDX-License-Identifier: MIT */
/* A program without a module refuses a scene by the module's name: in random scenes exactly
 * where the full program has the module on, by every init function alike, and without a
 * partial result. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/frame.h"
#include "tests/lib/scenes.h"
#include "world/module.h"
#include "tests/lib/frames.h"

enum { SCENES = 400 };

static uint64_t chance;
static test_kit kit;

static const char *const names[] = {
#define X(name) #name,
    TP_MODULE_LIST(X, X, X)
#undef X
};

static bool (*const conditions[])(const tp_module_conditions *) = {
#define X(name) tp_##name##_enabled,
    TP_MODULE_LIST(X, X, X)
#undef X
};

enum { COUNT = sizeof names / sizeof *names };

/* -- programs without some modules ------------------------------------------------- */

typedef struct {
    tp_program program;
    tp_use use[COUNT + 1];
    tp_lack lack[COUNT + 1];
} lacking;

static void leave_out(lacking *to, const bool out[COUNT])
{
    uint32_t uses = 0, lacks = 0;

    *to = (lacking){ .program = tp_program_all };
    for (uint32_t i = 0; i < COUNT; i++)
        if (out[i])
            to->lack[lacks++] = (tp_lack){ names[i], conditions[i], uses };
        else
            to->use[uses++] = tp_program_all.modules[i];
    to->program.modules = to->use;
    to->program.lacks = to->lack;
    to->program.refuse = tp_lacks_check;
}

/* -- scenes ------------------------------------------------------------------------- */

typedef struct {
    tp_scene scene;
    tp_assets assets;
    bool on[COUNT]; /* by the full program, in its frame */
} shown_modules;

static const tp_config config = {
    .width = 64, .height = 48, .tile_height = 48, .format = TP_FORMAT_XRGB8888
};

/* A random scene; half of the scenes have few features, so that fast stages are on too. */
static bool any_scene(shown_modules *s)
{
    s->scene = kit_scene(&chance, 14, 40);
    s->assets = kit_assets(&kit, &s->scene, &chance);
    if (random_below(&chance, 2))
        s->scene.water.clarity = s->scene.hdr.share = s->scene.foam.cells = 0;
    if (random_below(&chance, 2))
        s->scene.mirror.method = TP_MIRROR_NONE;
    if (random_below(&chance, 8) == 0) /* matt water */
        s->scene.water.clarity = s->scene.water.specular = s->scene.water.reflection = 0;
    if (random_below(&chance, 8) == 0) { /* one layer */
        s->assets.layer[1] = s->assets.layer[2] = NULL;
        s->scene.distortion.strength = 0;
    }
    s->scene.quality.shading = TP_SHADING_QUICK;
    s->scene.quality.rate = TP_RATE_FULL;
    if (tp_program_check_all(&tp_program_all, &s->scene, &s->assets, NULL) != TP_OK
        || tp_world_bytes(&tp_program_all, &s->scene, &s->assets) == 0)
        return false;
    test_frame f = frame_by(&tp_program_all, &s->scene, &s->assets, &config);
    tp_module_conditions want =
        tp_frame_module_conditions(&tp_program_all, &f.frame->buffers, &s->scene,
                                   &s->assets, &config);
    for (uint32_t i = 0; i < COUNT; i++)
        s->on[i] = tp_module_ask_condition(tp_program_all.modules[i].module, &want);
    frame_free(&f);
    return true;
}

/* -- refused or accepted ------------------------------------------------------------- */

static bool is_all(const uint64_t *block, size_t words, uint64_t value)
{
    for (size_t i = 0; i < words; i++)
        if (block[i] != value)
            return false;
    return true;
}

/* Asserts the same result from every function with a scene argument; `name` NULL: the scene
 * is accepted. */
static void compare_inits(const tp_program *by, const shown_modules *s, const char *name)
{
    static uint64_t block[4096];
    const tp_status expected = name ? TP_E_PROGRAM : TP_E_NOSPACE;
    const tp_config c = config_with(&config, by, &s->assets);
    tp_frame *frame = NULL;
    tp_error err = { 0 };

    assert_int_equal(tp_world_bytes(by, &s->scene, &s->assets) == 0, name != NULL);
    assert_int_equal(tp_frame_bytes(&c, &s->scene) == 0, name != NULL);
    memset(block, 0xa5, sizeof block);
    assert_int_equal(
        tp_world_init(by, (tp_world *)(void *)block, 0, &s->scene, &s->assets, &err),
        expected);
    if (!name)
        return;
    assert_string_equal(err.word, name);
    err = (tp_error){ 0 };
    assert_int_equal(tp_frame_init(&frame, &c, &s->scene, block, sizeof block, &err),
                     TP_E_PROGRAM);
    assert_string_equal(err.word, name);
    assert_null(frame);
    assert_true(is_all(block, sizeof block / sizeof *block, 0xa5a5a5a5a5a5a5a5));
}

static void compare(const tp_program *by, const shown_modules *s, const char *name)
{
    tp_error err = { 0 };
    const tp_status status = tp_program_check_all(by, &s->scene, &s->assets, &err);

    if (status != (name ? TP_E_PROGRAM : TP_OK) || (name && strcmp(err.word, name) != 0))
        fail_msg("%s is on, and '%s' refused", name ? name : "none", err.word);
    compare_inits(by, s, name);
}

static void one_module_lacked_is_refused_where_it_is_on(void **state)
{
    static lacking l;
    int refused[COUNT] = { 0 }, drawn = 0;
    shown_modules s;

    (void)state;
    for (int n = 0; n < SCENES; n++) {
        if (!any_scene(&s))
            continue;
        drawn++;
        for (uint32_t i = 0; i < COUNT; i++) {
            bool out[COUNT] = { false };
            out[i] = true;
            leave_out(&l, out);
            compare(&l.program, &s, s.on[i] ? names[i] : NULL);
            refused[i] += s.on[i];
        }
    }
    for (uint32_t i = 0; i < COUNT; i++) {
        if (refused[i] == 0)
            fail_msg("no scene has %s", names[i]);
        if (strcmp(names[i], "underwater") != 0) /* always on */
            assert_true(refused[i] < drawn);
    }
}

/* The name is that of the first missing module in the list's order. */
static void many_modules_lacked_are_refused_by_the_first_that_is_on(void **state)
{
    static lacking l;
    int refused = 0, taken = 0;
    shown_modules s;

    (void)state;
    for (int n = 0; n < 4 * SCENES; n++) {
        const uint32_t in = 2 + random_below(&chance, 20);
        bool out[COUNT];
        const char *first = NULL;
        if (!any_scene(&s))
            continue;
        for (uint32_t i = 0; i < COUNT; i++) {
            out[i] = random_below(&chance, in) == 0;
            if (out[i] && s.on[i] && !first)
                first = names[i];
        }
        leave_out(&l, out);
        compare(&l.program, &s, first);
        refused += first != NULL;
        taken += first == NULL;
    }
    assert_true(refused > 50 && taken > 50);
}

/* -- while the water moves ------------------------------------------------------------ */

static void a_world_refuses_to_switch_on_what_its_program_lacks(void **state)
{
    static lacking l;
    static uint64_t before[65536];
    bool out[COUNT] = { false };
    tp_assets assets = { .boat = NULL };
    tp_scene scene;
    tp_error err = { 0 };

    (void)state;
    for (uint32_t i = 0; i < COUNT; i++)
        out[i] = strcmp(names[i], "exposure") == 0 || strcmp(names[i], "haze") == 0;
    leave_out(&l, out);
    tp_scene_level(&scene);
    scene.sky.haze = 0;
    const size_t bytes = tp_world_bytes(&l.program, &scene, &assets);
    tp_world *world = malloc(bytes);
    assert_true(bytes > 0 && bytes <= sizeof before);
    assert_int_equal(tp_world_init(&l.program, world, bytes, &scene, &assets, &err),
                     TP_OK);
    tp_world_step(&l.program, world, &scene, NULL);
    memcpy(before, world, bytes);
    scene.hdr.exposure_factor = 2 * TP_FX_ONE;
    scene.wave[0].amplitude = TP_FX_ONE;
    assert_false(tp_world_apply(&l.program, world, &scene, &assets));
    assert_memory_equal(before, world, bytes);
    assert_int_equal(tp_program_check_all(&l.program, &scene, &assets, &err), TP_E_PROGRAM);
    assert_string_equal(err.word, "exposure");
    l.program.refuse = NULL;            /* left out of the picture, as always */
    assert_true(tp_world_apply(&l.program, world, &scene, &assets));
    assert_memory_not_equal(before, world, bytes);
    free(world);
}

/* Without fast stages the exact stages draw the plan's rungs. */
static void fast_stages_are_lacking_only_by_name(void **state)
{
    static lacking l;
    bool out[COUNT] = { false };
    const tp_assets assets = { .layer[0] = &kit.picture[0] };
    tp_scene scene;
    tp_error err = { 0 };

    (void)state;
    for (uint32_t i = 0; i < COUNT; i++)
        out[i] = strcmp(names[i], "fast_water") == 0;
    leave_out(&l, out);
    tp_scene_level(&scene);
    assert_int_equal(scene.quality.shading, TP_SHADING_AUTO);
    assert_int_equal(tp_program_check_all(&l.program, &scene, &assets, NULL), TP_OK);
    scene.quality.shading = TP_SHADING_QUICK;
    assert_int_equal(tp_program_check_all(&l.program, &scene, &assets, &err), TP_E_PROGRAM);
    assert_string_equal(err.word, "fast_water");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_module_lacked_is_refused_where_it_is_on),
        cmocka_unit_test(many_modules_lacked_are_refused_by_the_first_that_is_on),
        cmocka_unit_test(a_world_refuses_to_switch_on_what_its_program_lacks),
        cmocka_unit_test(fast_stages_are_lacking_only_by_name),
    };
    chance = random_seed();
    kit_make(&kit, &chance);
    return cmocka_run_group_tests_name("world/lacks", tests, NULL, NULL);
}
