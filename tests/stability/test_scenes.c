/* SPDX-License-Identifier: MIT */
/* Any number that the table of parameters allows is safe: every row at its ends, at 0 and
 * one least bit beside each, in a scene that has every model at once; and scenes of random
 * numbers.  Each is stepped, asked for heights, and drawn.  The build with UBSan and ASan
 * sees what goes wrong inside.
 *
 *     TP_SCENES=n     so many random scenes instead of 1000 (`make soak`: 100000) */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/unit/scenes.h"

#define HIGHEST (2200 * (int64_t)TP_FX_ONE)     /* 16 waves, 1024 rings, two pools */

static uint64_t chance;
static test_boat boat;

/* Small heights that rise to the north-east, with a hole. */
static const tp_grey *little_map(void)
{
    static uint16_t sample[24 * 16];
    static const tp_grey map = { 24, 16, sample };
    for (uint32_t i = 0; i < 24 * 16; i++)
        sample[i] = (uint16_t)(i % 24 * 2000 + (16 - i / 24) * 1000);
    sample[24 * 8 + 12] = 0;
    return &map;
}

static tp_assets all_assets(void)
{
    return (tp_assets){ .boat = &boat.mesh, .layer[0] = &boat.texture[0],
                        .ripple = &boat.texture[1], .floor = little_map(),
                        .pool_mask = little_map() };
}

static tp_scene everything(void)
{
    tp_scene s = scene_plain();

    s.grid.cols = s.grid.rows = 12;
    s.pool.cols = s.pool.rows = 24;
    s.pool.edges = TP_EDGES_SPONGE;
    s.pool.sponge = 5;
    s.pool.poke_every = TP_FX(0.02);
    s.field.cols = s.field.rows = 16;
    s.field.edges = TP_EDGES_TILE;
    s.field.feed_low = TP_FX(0.02);
    s.field.feed_high = TP_FX(0.03);
    s.floor.depth = 4 * TP_FX_ONE;
    s.floor.slope = TP_FX(0.04);
    s.wind.strength = TP_FX(0.1);
    s.drops.count = 8;
    s.drops.rings = 8;
    s.drops.every = TP_FX(0.02);
    s.boat.mode = TP_BOAT_DYNAMIC;
    s.boat.speed = 2 * TP_FX_ONE;
    return s;
}

static void draw(const tp_scene *scene, const tp_assets *assets, const tp_world *world)
{
    const tp_frame_config config = { 48, 32, 0, 8, TP_FORMAT_XRGB8888 };
    void *block = malloc(tp_frame_bytes(scene, assets, &config));
    void *scratch = malloc(tp_frame_scratch_bytes(&config));
    tp_frame *frame;
    tp_tile   tile;

    assert_non_null(block);
    assert_int_equal(tp_frame_init(&frame, scene, assets, &config, block, NULL), TP_OK);
    tp_frame_begin(frame, world);
    for (uint32_t i = 0; tp_frame_tile(frame, i, scratch, &tile); i++)
        ;
    free(block);
    free(scratch);
}

static tp_input any_input(void)
{
    return (tp_input){ .ahead = chance_int(&chance, -99999, 99999), .drops = 3,
                       .sphere_x = chance_int(&chance, -99999, 99999),
                       .throttle = chance_int(&chance, INT32_MIN, INT32_MAX),
                       .rudder = chance_int(&chance, INT32_MIN, INT32_MAX),
                       .poke = chance_int(&chance, -999999, 999999),
                       .poke_x = chance_int(&chance, -300000, 300000),
                       .poke_z = chance_int(&chance, -300000, 300000),
                       .slower = chance_int(&chance, -4, 4) };
}

static void ask(const tp_world *world)
{
    const tp_fx far = 16000 * TP_FX_ONE;
    const tp_fx x = chance_int(&chance, -far, far) >> random_below(&chance, 16);
    const tp_fx z = chance_int(&chance, -far, far) >> random_below(&chance, 16);
    const tp_sea_point p = tp_world_above(world, x, z);
    assert_true(llabs((int64_t)p.position.y) <= HIGHEST);
}

/* False: refused, which is as good. */
static bool run(const tp_scene *scene, int ticks)
{
    const tp_assets assets = all_assets();
    const size_t bytes = tp_world_bytes(scene, &assets);
    tp_world *world = bytes ? malloc(bytes) : NULL;
    tp_error  err;

    if (bytes == 0)
        return false;
    assert_non_null(world);
    assert_int_equal(tp_world_init(world, bytes, scene, &assets, &err), TP_OK);
    for (int n = 0; n < ticks; n++) {
        const tp_input input = any_input();
        tp_world_step(world, scene, n % 2 ? &input : NULL);
        ask(world);
    }
    tp_world_frame(world);
    draw(scene, &assets, world);
    free(world);
    return true;
}

/* -- one row at a time ----------------------------------------------------------------- */

static void every_number_is_safe_at_its_ends_and_beside_them(void **state)
{
    (void)state;
    uint32_t count = 0, tried = 0, refused = 0;
    const tp_param *rows = tp_params(&count);

    for (uint32_t i = 0; i < count; i++) {
        const tp_param *row = &rows[i];
        if (!scene_is_number(row))
            continue;
        const int64_t value[] = { row->low, (int64_t)row->low + 1, row->high,
                                  (int64_t)row->high - 1, 0, 1, -1,
                                  (int64_t)row->normal + 1, (int64_t)row->normal - 1 };
        for (size_t k = 0; k < sizeof value / sizeof *value; k++) {
            tp_scene scene = everything();
            if (value[k] < row->low || value[k] > row->high)
                continue;
            if (strncmp(row->name, "grid.", 5) == 0 && value[k] > 1000)
                continue;               /* those are the frame's, and take long */
            *scene_number(&scene, row) = (int32_t)value[k];
            refused += !run(&scene, 3);
            tried++;
        }
    }
    printf("# %u values of %u rows, %u refused\n", (unsigned)tried, (unsigned)count,
           (unsigned)refused);
    assert_true(refused < tried / 50);  /* courant and sizes of pools alone */
}

/* -- all at once ----------------------------------------------------------------------- */

static int32_t at_most(int32_t x, int32_t most)
{
    return x > most ? most : x;
}

static tp_scene any_small_scene(void)
{
    tp_scene s = scene_any(&chance);

    s.grid.cols = at_most(s.grid.cols, 14);
    s.grid.rows = at_most(s.grid.rows, 14);
    s.pool.cols = at_most(s.pool.cols, 40);
    s.pool.rows = at_most(s.pool.rows, 40);
    s.field.cols = at_most(s.field.cols, 40);
    s.field.rows = at_most(s.field.rows, 40);
    s.pool.courant = at_most(s.pool.courant, TP_FX(0.48));
    s.field.courant = at_most(s.field.courant, TP_FX(0.48));
    s.drops.count = at_most(s.drops.count, 20);
    s.drops.rings = at_most(s.drops.rings, 20);
    if (random_below(&chance, 2))
        strcpy(s.floor.map, "map.png");
    strcpy(s.pool.mask, "mask.png");
    strcpy(s.boat.mesh, "boat.obj");
    return s;
}

static void random_scenes_are_safe(void **state)
{
    (void)state;
    const char *asked = getenv("TP_SCENES");
    const int count = asked ? atoi(asked) : 1000;
    int ran = 0;

    for (int i = 0; i < count; i++) {
        const tp_scene scene = any_small_scene();
        ran += run(&scene, chance_int(&chance, 1, 12));
    }
    printf("# %d of %d random scenes ran, the others were refused\n", ran, count);
    assert_true(ran > count / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_is_safe_at_its_ends_and_beside_them),
        cmocka_unit_test(random_scenes_are_safe),
    };
    chance = random_seed();
    boat_make(&boat, &chance);
    return cmocka_run_group_tests_name("stability of scenes", tests, NULL, NULL);
}
