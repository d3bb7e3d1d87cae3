/* SPDX-License-Identifier: MIT */
/* Scenes filled in by a program: every row just beyond its range and far beyond, names
 * without an end, combinations.  Every entry point refuses the same scenes and names the
 * same row; accepted scenes are stepped and drawn under the sanitizers. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/base.h"
#include "quality/plan.h"
#include "tests/lib/frames.h"
#include "tests/lib/scenes.h"

enum { WIDTH = 32, HEIGHT = 24 };

static const tp_config picture = {
    .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_XRGB8888
};
static uint64_t chance;
static test_kit kit;

typedef struct {
    tp_scene  scene;            /* the world's scene */
    tp_world *world;
    size_t    world_bytes;
    void     *block;            /* as large as a frame of any scene here */
    size_t    block_bytes;
    void     *copy;             /* copy of the world */
} check_stand;

static check_stand stand_of(const tp_scene *scene)
{
    check_stand s = { .scene = *scene,
                      .world_bytes = tp_world_bytes(&tp_program_all, scene, NULL),
                      .block_bytes = 1 << 22 };

    s.world = malloc(s.world_bytes);
    s.copy = malloc(s.world_bytes);
    s.block = malloc(s.block_bytes);
    assert_int_equal(
        tp_world_init(&tp_program_all, s.world, s.world_bytes, scene, NULL, NULL), TP_OK);
    memcpy(s.copy, s.world, s.world_bytes);
    return s;
}

static void stand_free(check_stand *s)
{
    free(s->world);
    free(s->copy);
    free(s->block);
}

static void assert_refused(tp_status status, const tp_error *err, const tp_error *why,
                           const char *entry)
{
    if (status != why->code || err->code != why->code || err->a != why->a
        || err->b != why->b || strcmp(err->word, why->word) != 0)
        fail_msg("%s says %s of %s, tp_scene_check says %s of %s", entry,
                 tp_status_text(status), err->word, tp_status_text(why->code), why->word);
}

/* Asserts that every entry point refuses the scene as tp_scene_check does, and changes
 * nothing. */
static void all_refuse(check_stand *s, const tp_scene *bad, const tp_error *why)
{
    tp_error  err;
    tp_frame *frame = NULL;
    const tp_plan plan = tp_plan_make(bad, NULL, WIDTH, HEIGHT);

    assert_int_equal(tp_world_bytes(&tp_program_all, bad, NULL), 0);
    assert_int_equal(tp_frame_bytes(&picture, bad), 0);
    assert_int_equal(tp_frame_scratch_bytes(&picture, bad), 0);
    assert_int_equal(tp_frame_direct_scratch_bytes(&picture, bad), 0);
    assert_false(tp_world_apply(&tp_program_all, s->world, bad, NULL));
    assert_refused(
        tp_world_init(&tp_program_all, s->world, s->world_bytes, bad, NULL, &err), &err,
        why, "tp_world_init");
    assert_memory_equal(s->world, s->copy, s->world_bytes);
    assert_refused(tp_frame_init(&frame, &picture, bad, s->block,
                                 tp_frame_bytes(&picture, bad), &err),
                   &err, why, "tp_frame_init");
    assert_null(frame);
    assert_int_equal(plan.open, 0);
    assert_int_equal(plan.price.cost, 0);
}

/* Steps and draws the scene under the sanitizers. */
static void use(const tp_scene *scene, const tp_assets *assets)
{
    tp_world *world = scene_world(scene, assets);
    tp_tile   tile;

    assert_non_null(world);
    test_frame f = frame_of(scene, assets, &picture);
    for (int tick = 0; tick < 2; tick++) {
        tp_world_step(&tp_program_all, world, scene, NULL);
        tp_frame_begin(f.frame, world);
        for (uint32_t i = 0; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++)
            assert_non_null(tile.pixels);
    }
    assert_true(frame_guard_holds(f.block, f.bytes));
    frame_free(&f);
    free(world);
}

static void every_number_beyond_its_range_is_refused_by_its_name(void **state)
{
    (void)state;
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    const tp_scene plain = scene_plain();
    check_stand s = stand_of(&plain);

    for (uint32_t i = 0; i < count; i++) {
        const int32_t beyond[] = { rows[i].low - 1, rows[i].high + 1, INT32_MIN,
                                   INT32_MAX };
        for (size_t k = 0; scene_is_number(&rows[i]) && k < 4; k++) {
            tp_scene bad = plain;
            tp_error why;
            *scene_number(&bad, &rows[i]) = beyond[k];
            assert_int_equal(tp_scene_check(&bad, &why), TP_E_RANGE);
            assert_string_equal(why.word, rows[i].name);
            assert_int_equal(why.a, rows[i].low);
            assert_int_equal(why.b, rows[i].high);
            assert_int_equal(tp_scene_check(&bad, NULL), TP_E_RANGE);
            all_refuse(&s, &bad, &why);
        }
    }
    stand_free(&s);
}

/* A scene of plain waves; a grid of the most points is left to slower tests. */
static void every_number_at_the_ends_of_its_range_is_taken(void **state)
{
    (void)state;
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    const tp_assets none = { 0 };

    for (uint32_t i = 0; i < 2 * count; i++) {
        const tp_param *row = &rows[i / 2];
        tp_scene scene = scene_plain();
        scene.grid.vertices = 144;
        if (!scene_is_number(row))
            continue;
        *scene_number(&scene, row) = i % 2 ? row->high : row->low;
        assert_int_equal(tp_scene_check(&scene, NULL), TP_OK);
        if (scene.grid.vertices < 10000)
            use(&scene, &none);
    }
}

static void names_without_an_end_and_with_control_characters_are_refused(void **state)
{
    (void)state;
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    const tp_scene plain = scene_plain();
    check_stand s = stand_of(&plain);

    for (uint32_t i = 0; i < count; i++) {
        tp_scene bad = plain;
        tp_error why;
        char *name = (char *)&bad + rows[i].offset;
        if (scene_is_number(&rows[i]))
            continue;
        memset(name, 'n', TP_NAME_BYTES);
        assert_int_equal(tp_scene_check(&bad, &why), TP_E_UNENDED);
        assert_string_equal(why.word, rows[i].name);
        all_refuse(&s, &bad, &why);
        name[TP_NAME_BYTES - 1] = '\0';             /* the longest possible name */
        assert_int_equal(tp_scene_check(&bad, NULL), TP_OK);
        name[1] = '\n';
        assert_int_equal(tp_scene_check(&bad, &why), TP_E_TEXT);
        assert_string_equal(why.word, rows[i].name);
        all_refuse(&s, &bad, &why);
    }
    stand_free(&s);
}

/* Combinations of rows are refused with the same words as from a file. */
static void combinations_that_cannot_be_used_are_refused(void **state)
{
    (void)state;
    const tp_scene plain = scene_plain();
    check_stand s = stand_of(&plain);

    for (int n = 0; n < 6; n++) {
        tp_scene bad = plain;
        tp_scene_pool *pool = n % 2 ? &bad.field : &bad.pool;
        const char *field = n % 2 ? "field" : "pool";
        char word[32];
        tp_error why;
        pool->cols = n / 2 == 0 ? 15 : 16;
        pool->courant = n / 2 == 1 ? TP_FX(0.8) : TP_FX(0.4);
        pool->drive_min = n / 2 == 2 ? TP_FX_ONE : 0;
        snprintf(word, sizeof word, "%s.%s", field,
                 n / 2 == 0 ? "cols" : n / 2 == 1 ? "courant" : "drive_min");
        assert_int_equal(tp_scene_check(&bad, &why),
                         n / 2 == 0 ? TP_E_POOL_SIZE : n / 2 == 1 ? TP_E_POOL_COURANT
                                                                  : TP_E_POOL_FEED);
        assert_string_equal(why.word, word);
        all_refuse(&s, &bad, &why);
    }
    stand_free(&s);
}

static void set_any_row_anyhow(tp_scene *scene)
{
    static const int32_t odd[] = { INT32_MIN, INT32_MAX, -1, 0, 1, -TP_FX_ONE, TP_FX_ONE };
    uint32_t count;
    const tp_param *const rows = tp_params(&count);
    const tp_param *row = &rows[random_below(&chance, count)];
    const uint32_t kind = random_below(&chance, 4);

    if (scene_is_number(row))
        *scene_number(scene, row) =
            kind == 0 ? odd[random_below(&chance, sizeof odd / sizeof *odd)]
          : kind == 1 ? chance_int(&chance, INT32_MIN, INT32_MAX)
          : kind == 2 ? row->low - 1 : chance_int(&chance, row->low, row->high);
    else if (kind == 0)
        memset((char *)scene + row->offset, 1 + (int)random_below(&chance, 255),
               TP_NAME_BYTES - random_below(&chance, 2));
}

static bool in_range(const tp_scene *scene)
{
    uint32_t count;
    const tp_param *const rows = tp_params(&count);

    for (uint32_t i = 0; i < count; i++) {
        const int32_t *number = scene_number((tp_scene *)(uintptr_t)scene, &rows[i]);
        if (scene_is_number(&rows[i])
            && (*number < rows[i].low || *number > rows[i].high))
            return false;
    }
    return true;
}

/* Any scene of the table with up to three rows set to any value: every entry point refuses
 * the scene, or the scene works. */
static void scenes_of_any_numbers_are_refused_or_can_be_used(void **state)
{
    (void)state;
    const tp_scene plain = scene_plain();
    check_stand s = stand_of(&plain);
    uint32_t used = 0, refused = 0;

    for (int n = 0; n < 300; n++) {
        tp_scene scene = kit_scene(&chance, 100, 24);
        const tp_assets assets = kit_assets(&kit, &scene, &chance);
        tp_error why = { 0 };
        for (uint32_t k = random_below(&chance, 4); k > 0; k--)
            set_any_row_anyhow(&scene);
        if (tp_scene_check(&scene, &why) == TP_OK) {
            assert_true(in_range(&scene));
            kit_hold(&scene, 100, 24);
            use(&scene, &assets);
            used++;
        } else {
            all_refuse(&s, &scene, &why);
            refused++;
        }
    }
    print_message("# %u scenes used, %u refused\n", used, refused);
    assert_true(used > 30 && refused > 30);
    stand_free(&s);
}

/* A program without the check accepts unread content of a baked scene: texts. */
static void a_program_without_the_check_trusts_its_scene(void **state)
{
    (void)state;
    tp_program trusting = tp_program_all;
    tp_scene scene = scene_plain();
    tp_error err;

    trusting.check = NULL;
    memset(scene.title, 'n', sizeof scene.title);
    assert_int_equal(tp_world_bytes(&tp_program_all, &scene, NULL), 0);
    assert_true(tp_world_bytes(&trusting, &scene, NULL) > 0);
    assert_int_equal(tp_world_init(&trusting, NULL, 0, &scene, NULL, &err), TP_E_NULL);
    assert_string_equal(err.word, "world");
}

int main(void)
{
    chance = random_seed();
    kit_make(&kit, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_beyond_its_range_is_refused_by_its_name),
        cmocka_unit_test(every_number_at_the_ends_of_its_range_is_taken),
        cmocka_unit_test(names_without_an_end_and_with_control_characters_are_refused),
        cmocka_unit_test(combinations_that_cannot_be_used_are_refused),
        cmocka_unit_test(scenes_of_any_numbers_are_refused_or_can_be_used),
        cmocka_unit_test(a_program_without_the_check_trusts_its_scene),
    };
    return cmocka_run_group_tests_name("world/scene_check", tests, NULL, NULL);
}
