/* SPDX-License-Identifier: MIT */
/* A frame keeps laws, tables and maps from picture to picture. In every shipped scene it
 * draws cameras and moments in random order, and each picture equals that of a new frame. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/scene/assets.h"
#include "app/scene/scene_file.h"
#include "frame/frame.h"
#include "tests/lib/random.h"
#include "world/world.h"

enum { WIDTH = 96, HEIGHT = 72, PIXELS = WIDTH * HEIGHT,
       MOMENTS = 4, EVERY = 40,         /* ticks between moments */
       PICTURES = 24, SOME = 12 };      /* a scene; under the sanitizers */

typedef struct {
    scene_file file;
    asset_set  assets;
    tp_config  config;
    uint8_t   *worlds;                  /* one a moment, each of world_bytes */
    size_t     world_bytes;
} opened;

static uint64_t chance;
static uint32_t old[PIXELS], fresh[PIXELS];

static tp_world *moment(const opened *o, uint32_t at)
{
    return (tp_world *)(void *)(o->worlds + at * o->world_bytes);
}

static void open_scene(opened *o, const char *path)
{
    memset(o, 0, sizeof *o);
    assert_int_equal(scene_file_open(&o->file, path), 0);
    assert_int_equal(assets_open(&o->assets, &o->file), 0);
    const tp_scene *scene = &o->file.scene;
    o->config = (tp_config){ .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT,
                             .format = TP_FORMAT_XRGB8888, .assets = &o->assets.names };
    o->world_bytes = tp_world_bytes(&tp_program_all, scene, &o->assets.names);
    o->worlds = malloc((MOMENTS + 1) * o->world_bytes);
    tp_world *world = moment(o, MOMENTS);
    assert_int_equal(tp_world_init(&tp_program_all, world, o->world_bytes, scene,
                                   &o->assets.names, NULL), TP_OK);
    for (uint32_t m = 0; m < MOMENTS; m++) {
        memcpy(moment(o, m), world, o->world_bytes);
        for (uint32_t k = 0; k < EVERY; k++)
            tp_world_step(&tp_program_all, world, scene, NULL);
    }
}

static void close_scene(opened *o)
{
    free(o->worlds);
    assets_close(&o->assets);
    scene_file_close(&o->file);
}

static tp_frame *new_frame(const opened *o, void *block, size_t bytes)
{
    tp_frame *frame;

    memset(block, 0x5a, bytes);         /* leaves nothing of an earlier frame */
    assert_int_equal(tp_frame_init(&frame, &o->config, &o->file.scene, block, bytes, NULL),
                     TP_OK);
    return frame;
}

static void draw(tp_frame *frame, const tp_world *world, void *scratch, uint32_t *to)
{
    tp_tile tile;

    tp_frame_begin(frame, world);
    assert_true(tp_frame_draw_tile(frame, 0, scratch, &tile));
    memcpy(to, tile.pixels, sizeof old);
}

/* Takes the scene's own camera, one near it, or one under water. */
static void take_camera(tp_world *world)
{
    const uint32_t kind = random_below(&chance, 3);
    tp_vec3 eye = tp_world_camera(world).eye;

    if (kind == 0)
        return;
    eye.x += chance_fx(&chance, -6, 6);
    eye.z += chance_fx(&chance, -6, 6);
    eye.y = kind == 1 ? eye.y + chance_fx(&chance, -0.5, 6)
                      : tp_world_sample(&tp_program_all, world, eye.x, eye.z).height
                        - chance_fx(&chance, 0.1, 2);
    tp_world_set_camera(world, eye, (tp_turn)random_next(&chance),
                        (tp_turn)chance_int(&chance, -(3 << 27), 1 << 27), 0);
}

static void check_scene(const char *path)
{
    opened o;

    open_scene(&o, path);
    const size_t bytes = tp_frame_bytes(&o.config, &o.file.scene);
    void *blocks[2] = { malloc(bytes), malloc(bytes) };
    void *scratch = malloc(tp_frame_scratch_bytes(&o.config, &o.file.scene));
    tp_frame *kept = new_frame(&o, blocks[0], bytes);
    const uint32_t pictures = (uint32_t)random_rounds(PICTURES, SOME);
    for (uint32_t n = 0; n < pictures; n++) {
        const uint32_t at = random_below(&chance, MOMENTS);
        tp_world *world = moment(&o, MOMENTS);
        memcpy(world, moment(&o, at), o.world_bytes);
        take_camera(world);
        draw(kept, world, scratch, old);
        draw(new_frame(&o, blocks[1], bytes), world, scratch, fresh);
        if (memcmp(old, fresh, sizeof old) != 0)
            fail_msg("%s: picture %u is another than that of a new frame", path, n);
    }
    free(scratch);
    free(blocks[0]);
    free(blocks[1]);
    close_scene(&o);
}

static void each_picture_is_that_of_a_new_frame(void **state)
{
    DIR *folder = opendir("assets/scenes");
    char path[300];

    (void)state;
    chance = random_seed();
    assert_non_null(folder);
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        if (!strstr(entry->d_name, ".ini"))
            continue;
        snprintf(path, sizeof path, "assets/scenes/%s", entry->d_name);
        check_scene(path);
    }
    closedir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_picture_is_that_of_a_new_frame),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
