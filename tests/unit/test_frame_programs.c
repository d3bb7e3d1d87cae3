/* SPDX-License-Identifier: MIT */
/* Programs without some modules: a feature that the program lacks is left out of the
 * picture for any scene, and nothing else changes. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "frame/tools.h"
#include "tests/lib/programs.h"
#include "tests/lib/tilings.h"

static uint64_t chance;
static test_kit kit;
static test_twice twice;

static const tp_program least = {
    .stage = { TP_STAGE(sky), TP_STAGE(plain) },
    .store = { [TP_FORMAT_XRGB8888] = tp_store_xrgb8888 },
    .draw = { TP_DRAW(cells), TP_DRAW(grid_rows), TP_DRAW(exact_triangles),
              TP_DRAW(exact_waves), TP_DRAW(exact_corners) },
    .method = { TP_METHOD(triangles) },
};

static tp_world *world_by(const tp_program *by, const tp_scene *scene,
                          const tp_assets *assets)
{
    const size_t bytes = tp_world_bytes(by, scene, assets);
    tp_world *world = bytes ? malloc(bytes) : NULL;

    if (world && tp_world_init(by, world, bytes, scene, assets, NULL) != TP_OK)
        abort();
    return world;
}

/* The frame's program may differ from the world's program. */
static void draw_by(const tp_program *by, const tp_program *moved_by)
{
    tp_scene scene = kit_scene(&chance, 1600, 24);
    const tp_assets assets = kit_assets(&kit, &scene, &chance);
    tp_world *world = world_by(moved_by, &scene, &assets);
    const tp_input input = { .drops = 2, .push[0].height = TP_FX(0.3) };

    if (!world)
        return;
    twice.by = by;
    twice_begin(&twice, &scene, &assets, &chance);
    twice_draw(&twice, world);
    for (int n = 0; n < 3; n++)
        tp_world_step(moved_by, world, &scene, &input);
    world->lag = chance_fx(&chance, 0, 1);
    tp_world_apply(moved_by, world, &scene, &assets);
    tp_world_sample(moved_by, world, TP_FX_ONE, TP_FX_ONE);
    twice_draw(&twice, world);
    twice_end(&twice);
    free(world);
}

static void any_program_draws_any_scene(void **state)
{
    (void)state;
    for (int n = 0; n < 400; n++) {
        const tp_program by = thin_program(&chance), other = thin_program(&chance);
        draw_by(&by, n % 3 ? &by : n % 2 ? &tp_program_all : &other);
    }
    twice_print(&twice.reached);
    const twice_reached *r = &twice.reached;    /* other tests cover rare features */
    assert_true(r->under && r->water && r->solids && r->drops && r->tank && r->mirrored
                && r->refraction_map && r->cube && r->caustics && r->bumps && r->foam
                && r->dome && r->cube_sky && r->exposed && r->dispersed
                && r->between_ticks);
}

/* -- features left out ------------------------------------------------------------- */

enum { W = 64, H = 48 };

static uint32_t drawn_by(const tp_program *by, const tp_scene *scene,
                         const tp_assets *assets, uint32_t *dropped)
{
    const tp_config config = {
        .width = W, .height = H, .tile_height = H, .format = TP_FORMAT_XRGB8888
    };
    test_frame f = frame_by(by, scene, assets, &config);
    tp_world *world = world_by(by, scene, assets);
    tp_tile tile;

    tp_frame_begin(f.frame, world);
    tp_frame_draw_tile(f.frame, 0, f.scratch, &tile);
    uint32_t crc = tp_crc32(0, tile.pixels, W * H * sizeof(uint32_t));
    *dropped = tp_frame_stats(f.frame).dropped + tile.dropped;
    frame_free(&f);
    free(world);
    return crc;
}

static void a_program_of_what_a_scene_needs_draws_it_as_all_does(void **state)
{
    tp_program own = least;
    tp_assets assets = { .layer[0] = &kit.picture[0] };
    uint32_t lacks;
    tp_scene scene;

    (void)state;
    tp_scene_level(&scene);
    scene.water.reflection = scene.water.specular = 0;
    scene.quality.visibility = TP_VISIBILITY_TRIANGLES;     /* no part of the plan */
    scene.quality.shading = TP_SHADING_EXACT;
    own.modules = (const tp_use[]){ TP_USE(haze), TP_USE(base_layer), TP_USE(diffuse),
                                    { 0 } };
    const uint32_t crc = drawn_by(&own, &scene, &assets, &lacks);
    assert_int_equal(lacks, 0);
    assert_int_equal(crc, drawn_by(&tp_program_all, &scene, &assets, &lacks));
}

/* The same as if the scene did not ask for the feature; the count covers only modules in
 * the program's list. */
static void what_a_program_lacks_is_left_out_and_counted(void **state)
{
    tp_assets assets = { .boat = &kit.boat.mesh, .layer[0] = &kit.picture[0],
                         .layer[1] = &kit.picture[1], .ripple = &kit.picture[2] };
    const tp_assets none = { .layer[0] = &kit.picture[0] };
    static const tp_stage unlit[TP_COUNT_OF_boat];
    static const tp_use uses[] = {
        TP_USE(base_layer), TP_USE(lighting), TP_USE(haze),
        { &tp_boat_module, &tp_boat_drawing, unlit, NULL }, TP_USE_UNSEEN(hull),
        TP_USE(reflectance), TP_USE(glint), { 0 }
    };
    tp_program own = tp_program_all;
    uint32_t lacks;
    tp_scene scene;

    (void)state;
    tp_scene_level(&scene);
    own.modules = uses;
    scene.quality.shading = TP_SHADING_EXACT;
    strcpy(scene.boat.mesh, "boat.obj");
    const uint32_t crc = drawn_by(&own, &scene, &assets, &lacks);
    assert_int_equal(lacks, 1);
    scene.boat.mesh[0] = '\0';
    assert_int_equal(crc, drawn_by(&tp_program_all, &scene, &none, &lacks));
    assert_int_equal(lacks, 0);
}

/* A program that lacks a part draws another picture than all modules, and counts why. */
static void assert_told(const tp_program *by, const tp_scene *scene)
{
    const tp_assets assets = { .layer[0] = &kit.picture[0] };
    uint32_t lacks;
    const uint32_t crc = drawn_by(by, scene, &assets, &lacks);

    assert_true(lacks > 0);
    assert_int_not_equal(crc, drawn_by(&tp_program_all, scene, &assets, &lacks));
    assert_int_equal(lacks, 0);
}

/* Cells that fast triangles cannot draw are counted in their tile. */
static void triangles_that_a_program_lacks_are_counted_by_tiles(void **state)
{
    tp_program own = tp_program_all;
    tp_scene scene;

    (void)state;
    tp_scene_level(&scene);
    own.draw.exact_triangles = NULL;
    scene.quality.visibility = TP_VISIBILITY_TRIANGLES;
    for (int fast = 0; fast < 2; fast++) {
        scene.quality.triangles = fast ? TP_RUNG_FAST : TP_RUNG_EXACT;
        assert_told(&own, &scene);
    }
}

/* Nothing places rows that are not baked, of exact columns or of fast ones. */
static void rows_that_a_program_lacks_are_told(void **state)
{
    tp_program own = tp_program_all;
    tp_scene scene;

    (void)state;
    tp_scene_level(&scene);
    own.draw.grid_rows = NULL;
    scene.quality.shading = TP_SHADING_QUICK;
    scene.quality.visibility = TP_VISIBILITY_ROWS;
    for (int rung = TP_RUNG_EXACT; rung <= TP_RUNG_PAIRS; rung++) {
        scene.quality.rows = rung;
        assert_told(&own, &scene);
    }
}

/* A world is refused by the name of the part. */
static void foam_whose_source_a_program_lacks_is_refused(void **state)
{
    tp_program own = tp_program_all;
    const tp_assets assets = { .boat = &kit.boat.mesh };
    tp_error err = { 0 };
    uint64_t block[1];
    tp_scene scene;

    (void)state;
    tp_scene_level(&scene);
    scene.foam.cells = 32;
    scene.foam.hull = TP_FX_ONE;
    own.water.foam_hull = NULL;
    assert_true(tp_world_bytes(&own, &scene, &assets) > 0);
    strcpy(scene.boat.mesh, "boat.obj");
    assert_true(tp_world_bytes(&tp_program_all, &scene, &assets) > 0);
    assert_int_equal(tp_world_init(&own, (tp_world *)(void *)block, 0, &scene, &assets,
                                   &err), TP_E_PROGRAM);
    assert_string_equal(err.word, "foam_hull");
    scene.foam.slices = 2;
    own.water.foam_hull = &tp_water_foam_hull;
    own.water.foam_slices = NULL;
    assert_int_equal(tp_world_init(&own, (tp_world *)(void *)block, 0, &scene, &assets,
                                   &err), TP_E_PROGRAM);
    assert_string_equal(err.word, "foam_slices");
    scene.foam.slices = 1;
    scene.floor.depth = TP_FX_ONE;
    own.water.foam_coast = NULL;
    assert_int_equal(tp_world_init(&own, (tp_world *)(void *)block, 0, &scene, &assets,
                                   &err), TP_E_PROGRAM);
    assert_string_equal(err.word, "foam_coast");
}

#define OF_LIST(X) X(quick_mip_spans) X(quick_bend) X(quick_layers) X(quick_ripple)
#define OF_HALVES(X) \
    X(quick_bend_thin) X(quick_layers_even) X(quick_gradient_even) X(quick_glint_phong)
#define OF_OTHERS(X) \
    X(quick_still) X(quick_still_thin) X(quick_layers_thin) X(quick_slopes) \
    X(quick_gradient) X(quick_dome_phong) X(quick_cube_phong) X(quick_dome_even)

/* A scene with distorted layers and ripples under a plain sky, drawn by the fast stages. */
static tp_scene quick_scene(int32_t rate)
{
    tp_scene s;

    tp_scene_level(&s);
    s.quality.visibility = TP_VISIBILITY_TRIANGLES;
    s.quality.shading = TP_SHADING_QUICK;
    s.quality.rate = rate;
    s.quality.layers = s.quality.distortion = s.quality.ripple = TP_RUNG_FAST;
    s.distortion.strength = TP_FX_ONE;
    return s;
}

/* A stage reads the results of the preceding stage: a program without a stage of the fast
 * list draws exactly, and without a stage of the half rate the program draws all columns.
 * Fast stages that the scene does not run are not required. */
static void a_program_without_a_quick_stage_takes_the_next_better_rung(void **state)
{
    const tp_assets assets = { .layer[0] = &kit.picture[0], .layer[1] = &kit.picture[1],
                               .ripple = &kit.picture[2],
                               .distortion = &kit.picture[4] };
    const tp_scene full = quick_scene(TP_RATE_FULL), half = quick_scene(TP_RATE_COLOUR);
    tp_scene exact = full;
    tp_stage table[TP_COUNT_OF_fast_water];
    tp_use use[THIN_MODULES];
    uint32_t lacks;

    (void)state;
    exact.quality.shading = TP_SHADING_EXACT;
    const uint32_t by_exact = drawn_by(&tp_program_all, &exact, &assets, &lacks);
    const uint32_t by_full = drawn_by(&tp_program_all, &full, &assets, &lacks);
    assert_int_not_equal(by_full, by_exact);
    assert_int_not_equal(by_full, drawn_by(&tp_program_all, &half, &assets, &lacks));
#define X(name)                                                                          \
    {                                                                                    \
        tp_program own = tp_program_all;                                                 \
        WITHOUT_STAGE(own, use, table, fast_water, name);                                \
        if (drawn_by(&own, &full, &assets, &lacks) != by_exact)                          \
            fail_msg("without %s: not the exact picture", #name);                        \
    }
    OF_LIST(X)
#undef X
#define X(name)                                                                          \
    {                                                                                    \
        tp_program own = tp_program_all;                                                 \
        WITHOUT_STAGE(own, use, table, fast_water, name);                                \
        if (drawn_by(&own, &half, &assets, &lacks) != by_full)                           \
            fail_msg("without %s: not the picture of every column", #name);              \
    }
    OF_HALVES(X)
#undef X
    tp_program own = tp_program_all;
    WITHOUT_STAGE(own, use, table, fast_water, quick_odd_fill);
#define X(name) table[TP_NTH_##name] = NULL;
    OF_OTHERS(X)
#undef X
    assert_int_equal(drawn_by(&own, &full, &assets, &lacks), by_full);
    assert_int_equal(lacks, 0);
}

/* -- missing stages by name --------------------------------------------------------- */

static const char *lacks_of(const tp_program *by, const tp_scene *scene,
                            const tp_assets *assets)
{
    const tp_config config = {
        .width = W, .height = H, .tile_height = H, .format = TP_FORMAT_XRGB8888
    };
    test_frame f = frame_by(by, scene, assets, &config);
    tp_world *world = world_by(by, scene, assets);

    tp_frame_begin(f.frame, world);
    const char *name = tp_frame_lacks(f.frame);
    assert_int_equal(tp_frame_stats(f.frame).dropped > 0, name != NULL);
    frame_free(&f);
    free(world);
    return name;
}

/* The sky's stages are requested first, then those of solids, then those of the water. */
static void the_first_module_without_a_stage_is_told(void **state)
{
    const tp_assets assets = { .boat = &kit.boat.mesh, .layer[0] = &kit.picture[0] };
    tp_stage layer[TP_COUNT_OF_base_layer], solids[TP_COUNT_OF_boat] = { NULL };
    tp_use use[2][THIN_MODULES];
    tp_program own = tp_program_all;
    tp_scene scene;

    (void)state;
    tp_scene_level(&scene);
    scene.quality.shading = TP_SHADING_EXACT;
    scene.water.filter = TP_FILTER_NEAREST;
    assert_null(lacks_of(&own, &scene, &assets));
    WITHOUT_STAGE(own, use[0], layer, base_layer, texture_linear_tinted);
    assert_null(lacks_of(&own, &scene, &assets));
    scene.water.filter = TP_FILTER_LINEAR;
    assert_string_equal(lacks_of(&own, &scene, &assets), "base layer");
    own.stage.view = NULL;
    assert_string_equal(lacks_of(&own, &scene, &assets), "base layer");
    strcpy(scene.boat.mesh, "boat.obj");
    memcpy(use[1], own.modules, sizeof use[1]);
    for (tp_use *u = use[1]; u->module; u++)
        if (u->drawing == &tp_boat_drawing)
            u->stage = solids;
    own.modules = use[1];
    assert_string_equal(lacks_of(&own, &scene, &assets), "boat");
    own = tp_program_all;
    own.stage.view = NULL;
    assert_string_equal(lacks_of(&own, &scene, &assets), "lighting");
    scene.sky.kind = TP_SKY_DAY;
    own.modules = NULL;
    assert_string_equal(lacks_of(&own, &scene, &assets), "sky");
}

static void refused(const tp_program *by, tp_format format, const char *word)
{
    static uint64_t block[65536];
    const tp_config config = {
        .width = 16, .height = 16, .format = format, .program = by
    };
    tp_frame *frame = NULL;
    tp_error err = { 0 };
    tp_scene scene;

    tp_scene_level(&scene);
    scene.grid.vertices = 64;
    assert_int_equal(tp_frame_init(&frame, &config, &scene, block, sizeof block, &err),
                     TP_E_PROGRAM);
    assert_string_equal(err.word, word);
    assert_null(frame);
}

static void a_program_without_plain_or_the_format_is_refused(void **state)
{
    tp_program lacking = least;

    (void)state;
    refused(&least, TP_FORMAT_RGB565, "rgb565");
    lacking.stage.plain = NULL;
    refused(&lacking, TP_FORMAT_XRGB8888, "plain");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_program_draws_any_scene),
        cmocka_unit_test(a_program_of_what_a_scene_needs_draws_it_as_all_does),
        cmocka_unit_test(what_a_program_lacks_is_left_out_and_counted),
        cmocka_unit_test(triangles_that_a_program_lacks_are_counted_by_tiles),
        cmocka_unit_test(rows_that_a_program_lacks_are_told),
        cmocka_unit_test(foam_whose_source_a_program_lacks_is_refused),
        cmocka_unit_test(a_program_without_a_quick_stage_takes_the_next_better_rung),
        cmocka_unit_test(the_first_module_without_a_stage_is_told),
        cmocka_unit_test(a_program_without_plain_or_the_format_is_refused),
    };
    chance = random_seed();
    kit_make(&kit, &chance);
    return cmocka_run_group_tests_name("frame/programs", tests, NULL, NULL);
}
