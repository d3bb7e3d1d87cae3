/* SPDX-License-Identifier: MIT */
/* Any number of the parameter table is safe: every row at its ends, at 0 and at one LSB
 * beside each, in a scene that has every model at once; and scenes of random numbers.
 * Each scene is stepped, sampled for heights, and drawn whole and in tiles; then its
 * numbers change under the same frames.  The build with UBSan and ASan detects faults
 * inside.
 *
 *     TP_SCENES=n     number of random scenes, default 300 (`make soak`: 10000)
 *     TP_SOAK=1       each row also beside its ends, 0 and its usual value */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/tilings.h"

#define HIGHEST (2200 * (int64_t)TP_FX_ONE)     /* 16 waves, 1024 rings, two pools */

static uint64_t chance;
static test_kit kit;
static test_twice twice;

static tp_scene everything(void)
{
    tp_scene s = scene_plain();

    s.grid.vertices = 144;
    s.pool.cols = s.pool.rows = 24;
    s.pool.boundary = TP_EDGES_SPONGE;
    s.pool.sponge = 5;
    s.pool.splash_interval = TP_FX(0.02);
    s.field.cols = s.field.rows = 16;
    s.field.boundary = TP_EDGES_TILE;
    s.field.drive_min = TP_FX(0.02);
    s.field.drive_max = TP_FX(0.03);
    s.floor.depth = 4 * TP_FX_ONE;
    s.floor.slope = TP_FX(0.04);
    s.wind.strength = TP_FX(0.1);
    s.drops.count = 8;
    s.drops.rings = 8;
    s.drops.interval = TP_FX(0.02);
    s.boat.mode = TP_BOAT_DYNAMIC;
    s.boat.speed = 2 * TP_FX_ONE;
    kit_gather(&s, &chance);
    kit_switch_on(&s, &chance);
    kit_hold(&s, 144, 24);
    return s;
}

static tp_push any_push(void)
{
    return (tp_push){ chance_int(&chance, -999999, 999999),
                      chance_int(&chance, -300000, 300000),
                      chance_int(&chance, -300000, 300000) };
}

static tp_input any_input(void)
{
    return (tp_input){ .forward = chance_int(&chance, -99999, 99999),
                       .drops = 3,
                       .sphere_x = chance_int(&chance, -99999, 99999),
                       .throttle = chance_int(&chance, INT32_MIN, INT32_MAX),
                       .rudder = chance_int(&chance, INT32_MIN, INT32_MAX),
                       .push[0] = any_push(),
                       .push[7] = any_push(),
                       .slowdown = chance_int(&chance, -4, 4) };
}

static void ask(const tp_world *world)
{
    const tp_fx far = 16000 * TP_FX_ONE;
    const tp_fx x = chance_int(&chance, -far, far) >> random_below(&chance, 16);
    const tp_fx z = chance_int(&chance, -far, far) >> random_below(&chance, 16);
    const tp_water p = tp_world_sample(&tp_program_all, world, x, z);
    assert_true(llabs((int64_t)p.height) <= HIGHEST);
}

static void step(tp_world *world, const tp_scene *scene, int ticks)
{
    for (int n = 0; n < ticks; n++) {
        const tp_input input = any_input();
        tp_world_step(&tp_program_all, world, scene, n % 2 ? &input : NULL);
        ask(world);
    }
    for (uint32_t n = tp_world_advance_clock(world); n > 0; n--)
        tp_world_step(&tp_program_all, world, scene, NULL);
}

/* Changes any numbers to any others, except numbers that size a frame. */
static void change(tp_scene *scene)
{
    const tp_scene other = kit_scene(&chance, 196, 40);
    const int32_t vertices = scene->grid.vertices;
    uint32_t count = 0;
    const tp_param *row = tp_params(&count);
    const uint32_t one_in = 1u << random_below(&chance, 8);

    for (uint32_t i = 0; i < count; i++) {
        if (scene_is_number(&row[i]) && random_below(&chance, one_in) == 0)
            *scene_number(scene, &row[i]) = *(const int32_t *)(const void *)(
                (const char *)&other + row[i].offset);
    }
    scene->grid.vertices = vertices;
}

/* The scene's world; NULL if the scene is refused, also a valid result. */
static tp_world *world_of(const tp_scene *scene, const tp_assets *assets)
{
    const size_t bytes = tp_world_bytes(&tp_program_all, scene, assets);
    tp_world *world = bytes ? malloc(bytes) : NULL;

    if (bytes == 0)
        return NULL;
    assert_non_null(world);
    assert_int_equal(tp_world_init(&tp_program_all, world, bytes, scene, assets, NULL),
                     TP_OK);
    return world;
}

/* Draws with the same frames while numbers change; a world that refuses the change is made
 * anew. */
static void live_on(tp_world **world, tp_scene *scene, const tp_assets *assets)
{
    change(scene);
    if (!tp_world_apply(&tp_program_all, *world, scene, assets)) {
        free(*world);
        *world = world_of(scene, assets);
    }
    if (*world)
        step(*world, scene, chance_int(&chance, 0, 4));
}

/* Asserts that a copy of a world continues as the world does. */
static void compare_with_copy(tp_world *world, const tp_scene *scene)
{
    tp_world *copy = malloc(world->layout.bytes);

    memcpy(copy, world, world->layout.bytes);
    for (int n = 0; n < 2; n++) {
        tp_world_step(&tp_program_all, world, scene, NULL);
        tp_world_step(&tp_program_all, copy, scene, NULL);
    }
    assert_memory_equal(copy, world, world->layout.bytes);
    free(copy);
}

static bool run(const tp_scene *wanted, int ticks, int lives)
{
    tp_scene  scene = *wanted;
    const tp_assets assets = kit_assets(&kit, &scene, &chance);
    tp_world *world = world_of(&scene, &assets);

    if (!world)
        return false;
    twice_begin(&twice, &scene, &assets, &chance);
    step(world, &scene, ticks);
    compare_with_copy(world, &scene);
    twice_draw(&twice, world);
    for (int n = 0; n < lives && world; n++) {
        live_on(&world, &scene, &assets);
        if (world)
            twice_draw(&twice, world);
    }
    twice_end(&twice);
    free(world);
    return true;
}

/* -- one row at a time ----------------------------------------------------------------- */

/* True if value k of the row is valid and has not been tried before. */
static bool is_another(const tp_param *row, const int64_t *value, size_t k)
{
    for (size_t i = 0; i < k; i++)
        if (value[i] == value[k])
            return false;
    return value[k] >= row->low && value[k] <= row->high;
}

static void every_number_is_safe_at_its_ends_and_beside_them(void **state)
{
    (void)state;
    uint32_t count = 0, tried = 0, refused = 0;
    const tp_param *rows = tp_params(&count);
    const size_t tries = getenv("TP_SOAK") ? 9 : 3;

    for (uint32_t i = 0; i < count; i++) {
        const tp_param *row = &rows[i];
        if (!scene_is_number(row))
            continue;
        const int64_t value[] = { row->low, row->high, 0, (int64_t)row->low + 1,
                                  (int64_t)row->high - 1, 1, -1,
                                  (int64_t)row->normal + 1, (int64_t)row->normal - 1 };
        for (size_t k = 0; k < tries; k++) {
            tp_scene scene = everything();
            if (!is_another(row, value, k))
                continue;
            if (strncmp(row->name, "grid.", 5) == 0 && value[k] > 1000)
                continue;               /* these rows belong to the frame and take long */
            *scene_number(&scene, row) = (int32_t)value[k];
            refused += !run(&scene, 3, 0);
            tried++;
        }
    }
    printf("# %u values of %u rows, %u refused\n", (unsigned)tried, (unsigned)count,
           (unsigned)refused);
    assert_true(refused < tried / 50);  /* only courant and sizes of pools */
}

/* -- all at once ----------------------------------------------------------------------- */

static void random_scenes_are_safe(void **state)
{
    (void)state;
    const char *asked = getenv("TP_SCENES");
    const int count = asked ? atoi(asked) : 300;
    int ran = 0;

    for (int i = 0; i < count; i++) {
        const tp_scene scene = kit_scene(&chance, 196, 40);
        ran += run(&scene, chance_int(&chance, 1, 12), i % 3);
    }
    printf("# %d of %d random scenes ran, the others were refused\n", ran, count);
    twice_print(&twice.reached);
    assert_true(count < 300 || twice_reached_all(&twice.reached));
    assert_true(ran > count / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_is_safe_at_its_ends_and_beside_them),
        cmocka_unit_test(random_scenes_are_safe),
    };
    chance = random_seed();
    kit_make(&kit, &chance);
    return cmocka_run_group_tests_name("stability of scenes", tests, NULL, NULL);
}
