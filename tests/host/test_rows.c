/* SPDX-License-Identifier: MIT */
/* Scanline water against the same water in triangles, in every shipped scene: mean
 * differences, and pixels with water in one picture only.  Then cameras on both sides of
 * the limit beyond which frames choose triangles. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "frame/frame.h"
#include "app/scene/assets.h"
#include "app/scene/scene_file.h"
#include "world/text.h"

enum { MOST_WIDTH = 320, MOST_HEIGHT = 240, MOST = MOST_WIDTH * MOST_HEIGHT };

#define MEAN_MOST 2.0           /* of 255 */

typedef struct {
    scene_file file;
    asset_set  assets;
    tp_world  *world;
} opened;

typedef struct {
    uint32_t colour[MOST];
    uint8_t  mark[MOST];
    bool     by_rows;
} drawn;

static void draw(const opened *o, uint32_t width, uint32_t height, tp_visibility how,
                 drawn *to)
{
    const tp_config config = { .width = width,
                               .height = height,
                               .tile_height = height,
                               .format = TP_FORMAT_XRGB8888,
                               .assets = &o->assets.names };
    tp_scene scene = o->file.scene;
    tp_frame *frame;
    tp_tile tile;

    scene.quality.visibility = (int32_t)how;
    void *block = malloc(tp_frame_bytes(&config, &scene));
    uint32_t *scratch = malloc(tp_frame_scratch_bytes(&config, &scene));
    assert_int_equal(tp_frame_init(&frame, &config, &scene, block,
                                   tp_frame_bytes(&config, &scene), NULL),
                     TP_OK);
    tp_frame_begin(frame, o->world);
    assert_true(tp_frame_draw_tile(frame, 0, scratch, &tile));
    memcpy(to->colour, tile.pixels, 4 * (size_t)width * height);
    for (uint32_t i = 0; i < width * height; i++)
        to->mark[i] = (uint8_t)TP_MARK(scratch[i]);
    to->by_rows = frame->visibility == TP_VISIBILITY_ROWS;
    free(scratch);
    free(block);
}

typedef struct {
    double   mean;
    uint32_t lone;              /* sky or water not found near in the other picture */
} row_difference;

static bool has_near(const drawn *d, uint32_t width, uint32_t height, uint32_t i,
                     uint8_t mark)
{
    const int x = (int)(i % width), y = (int)(i / width);

    for (int v = y - 1; v <= y + 1; v++)
        for (int u = x - 1; u <= x + 1; u++)
            if (u >= 0 && v >= 0 && u < (int)width && v < (int)height
                && d->mark[(uint32_t)v * width + (uint32_t)u] == mark)
                return true;
    return false;
}

static row_difference compare(const drawn *a, const drawn *b, uint32_t width,
                              uint32_t height)
{
    row_difference d = { 0, 0 };

    for (uint32_t i = 0; i < width * height; i++) {
        for (int k = 0; k < 24; k += 8)
            d.mean += abs((int)(a->colour[i] >> k & 255) - (int)(b->colour[i] >> k & 255));
        d.lone += a->mark[i] + b->mark[i] == TP_MARK_SKY + TP_MARK_WATER
               && !has_near(a, width, height, i, b->mark[i]);
    }
    d.mean /= 3.0 * width * height;
    return d;
}

static bool open_scene(opened *o, const char *path)
{
    memset(o, 0, sizeof *o);
    if (scene_file_open(&o->file, path) || assets_open(&o->assets, &o->file))
        return false;
    const size_t bytes =
        tp_world_bytes(&tp_program_all, &o->file.scene, &o->assets.names);
    o->world = malloc(bytes);
    return tp_world_init(&tp_program_all, o->world, bytes, &o->file.scene,
                         &o->assets.names, NULL)
           == TP_OK;
}

static void close_scene(opened *o)
{
    free(o->world);
    assets_close(&o->assets);
    scene_file_close(&o->file);
}

static drawn triangles, rows;

static void check_scene(const char *name, opened *o)
{
    static const uint32_t size[2][2] = { { 320, 240 }, { 160, 120 } };

    for (uint32_t tick = 0; tick <= 80; tick++) {
        if (tick % 40 == 0) {
            for (int i = tick == 40 && !getenv("TP_SOAK"); i < 2; i++) {
                draw(o, size[i][0], size[i][1], TP_VISIBILITY_TRIANGLES, &triangles);
                draw(o, size[i][0], size[i][1], TP_VISIBILITY_ROWS, &rows);
                const row_difference d = compare(&triangles, &rows, size[i][0], size[i][1]);
                printf("  %-14s %3ux%u tick %2u: %s, mean %.2f, %u lone\n", name,
                       size[i][0], size[i][1], tick,
                       rows.by_rows ? "rows" : "triangles", d.mean, d.lone);
                assert_true(d.mean <= MEAN_MOST);
                assert_int_equal(d.lone, 0);
            }
        }
        tp_world_step(&tp_program_all, o->world, &o->file.scene, NULL);
    }
}

static void rows_look_like_triangles_in_every_scene(void **state)
{
    (void)state;
    DIR *folder = opendir("assets/scenes");
    uint32_t by_rows = 0;

    assert_non_null(folder);
    for (struct dirent *e = readdir(folder); e; e = readdir(folder)) {
        char path[300];
        opened o;
        if (!strstr(e->d_name, ".ini"))
            continue;
        snprintf(path, sizeof path, "assets/scenes/%s", e->d_name);
        assert_true(open_scene(&o, path));
        check_scene(e->d_name, &o);
        by_rows += rows.by_rows;
        close_scene(&o);
    }
    closedir(folder);
    assert_true(by_rows >= 9);
}

/* -- the limit ------------------------------------------------------------------------- */

static const struct {
    const char *name;
    double from, to, step;
} sweeps[] = {
    { "camera.heading", -180, 180, 11 }, { "camera.pitch", -85, 20, 7 },
    { "camera.y", 0.2, 12, 0.7 },
    { "wave0.steepness", 0, 1, 0.1 },    { "wave1.steepness", 0, 1, 0.1 },
};

static void make_world(opened *o)
{
    assert_int_equal(tp_world_init(&tp_program_all, o->world,
                                   tp_world_bytes(&tp_program_all, &o->file.scene,
                                                  &o->assets.names),
                                   &o->file.scene, &o->assets.names, NULL),
                     TP_OK);
}

/* Moves a number over its range, in the soak in steps half as long. */
static void sweep(opened *o, const char *scene, size_t k)
{
    const double step = sweeps[k].step * (getenv("TP_SOAK") ? 1 : 2);
    const tp_param *row = tp_param_find(sweeps[k].name, strlen(sweeps[k].name));
    double worst = 0;
    uint32_t count[2] = { 0, 0 };

    assert_non_null(row);
    int32_t *const number = (int32_t *)(void *)((char *)&o->file.scene + row->offset);
    const int32_t own = *number;
    for (double v = sweeps[k].from; v <= sweeps[k].to; v += step) {
        *number = (int32_t)(v * 65536);
        make_world(o);
        draw(o, 160, 120, TP_VISIBILITY_TRIANGLES, &triangles);
        draw(o, 160, 120, TP_VISIBILITY_ROWS, &rows);
        const row_difference d = compare(&triangles, &rows, 160, 120);
        count[rows.by_rows]++;
        worst = d.mean > worst ? d.mean : worst;
        if (d.mean > MEAN_MOST || d.lone > 0 || (!rows.by_rows && d.mean > 0))
            printf("  %s %s %.2f: mean %.2f, %u lone\n", scene, sweeps[k].name, v, d.mean,
                   d.lone);
        assert_true(rows.by_rows || d.mean == 0);
        assert_true(d.mean <= MEAN_MOST);
        assert_true(d.lone <= 0);
    }
    *number = own;
    printf("  %-14s %-16s %2u by rows, %2u by triangles, worst mean %.2f\n", scene,
           sweeps[k].name, count[1], count[0], worst);
}

/* Beyond the limit frames equal triangles bit for bit; within the limit they look like
 * triangles. */
static void frames_take_triangles_before_rows_show(void **state)
{
    (void)state;
    static const char *const scenes[] = { "count-64", "three-swells", "deep-sea", "storm" };

    for (int n = 0; n < 4; n++) {
        char path[60];
        opened o;
        snprintf(path, sizeof path, "assets/scenes/%s.ini", scenes[n]);
        assert_true(open_scene(&o, path));
        for (size_t k = 0; k < sizeof sweeps / sizeof *sweeps; k++)
            sweep(&o, scenes[n], k);
        close_scene(&o);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_look_like_triangles_in_every_scene),
        cmocka_unit_test(frames_take_triangles_before_rows_show),
    };
    return cmocka_run_group_tests_name("rows", tests, NULL, NULL);
}
