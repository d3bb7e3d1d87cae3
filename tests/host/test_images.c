/* SPDX-License-Identifier: MIT */
/* Pictures of every kind in every place of a scene: read exactly to the texel, loaded,
 * and used to draw a frame. */
#define _XOPEN_SOURCE 700
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include "../../ports/app/scene/frame_renderer.h"
#include "tests/lib/png_files.h"

static void good_pictures_are_read_to_the_texel(void **state)
{
    (void)state;
    for (int i = 0; i < KINDS; i++) {
        const kind *k = &kinds[i];
        uint32_t w = 0, h = 0;
        write_kind(k, "kind.png");
        uint32_t *read = picture_read_png("kind.png", k->name, &w, &h);
        assert_non_null(read);
        assert_int_equal(w, k->w);
        assert_int_equal(h, k->h);
        for (uint32_t n = 0; n < w * h; n++)
            if (read[n] != expected(k, n % w, n / w))
                fail_msg("%s: texel %u is %08x, not %08x", k->name, (unsigned)n,
                         (unsigned)read[n], (unsigned)expected(k, n % w, n / w));
        free(read);
    }
}

static void good_pictures_load_in_every_place(void **state)
{
    (void)state;
    for (int i = 0; i < KINDS; i++) {
        write_kind(&kinds[i], "kind.png");
        for (int n = 0; n < TEXTURES; n++)
            if (open_one(textures[n], "kind.png") || said[0])
                fail_msg("%s as %s: %s", kinds[i].name, textures[n], said);
        for (int n = 0; n < GREYS; n++)
            if (open_one(greys[n], "kind.png") || said[0])
                fail_msg("%s as %s: %s", kinds[i].name, greys[n], said);
    }
}

/* All features at once: a tank in a pool with foam, under a cube sky, by the shore. */
static void write_whole_scene(void)
{
    static const char *const others[][2] = {
        { "sky.kind", "cube" },       { "tank.kind", "glass" },
        { "foam.cells", "32" },       { "pool.cols", "24" },
        { "pool.rows", "24" },        { "field.cols", "16" },
        { "field.rows", "16" },       { "distortion.strength", "2" },
        { "wave0.amplitude", "0.3" }, { "grid.vertices", "900" },
        { "water.clarity", "3" },
    };
    FILE *file = fopen("case.ini", "w");
    assert_non_null(file);
    for (int i = 0; i < TEXTURES; i++)
        put_setting(file, textures[i], "kind.png");
    for (int i = 0; i < GREYS; i++)
        put_setting(file, greys[i], "kind.png");
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        put_setting(file, others[i][0], others[i][1]);
    fclose(file);
}

static void draw_whole_scene(const char *name)
{
    const tp_config config = { .width = 70, .height = 50 };
    scene_file scene;
    asset_set a;
    frame_renderer c;
    listen();
    int code = scene_file_open(&scene, "./case.ini");
    if (!code)
        code = assets_open(&a, &scene);
    stop_listening();
    if (code)
        fail_msg("%s: %s", name, said);
    const size_t bytes = tp_world_bytes(&tp_program_all, &scene.scene, &a.names);
    tp_world *world = malloc(bytes);
    assert_non_null(world);
    assert_int_equal(
        tp_world_init(&tp_program_all, world, bytes, &scene.scene, &a.names, NULL),
        TP_OK);
    frame_renderer_plan(&c, &config, 1);
    assert_int_equal(frame_renderer_open(&c, &scene.scene, &a.names), EXIT_DONE);
    for (int i = 0; i < 3; i++)
        tp_world_step(&tp_program_all, world, &scene.scene, NULL);
    frame_renderer_draw(&c, world);
    frame_renderer_close(&c);
    free(world);
    assets_close(&a);
    scene_file_close(&scene);
}

static void scenes_are_drawn_with_pictures_of_every_kind(void **state)
{
    (void)state;
    write_whole_scene();
    for (int i = 0; i < KINDS; i++) {
        write_kind(&kinds[i], "kind.png");
        draw_whole_scene(kinds[i].name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(good_pictures_are_read_to_the_texel),
        cmocka_unit_test(good_pictures_load_in_every_place),
        cmocka_unit_test(scenes_are_drawn_with_pictures_of_every_kind),
    };
    return cmocka_run_group_tests_name("images", tests, enter, leave);
}
