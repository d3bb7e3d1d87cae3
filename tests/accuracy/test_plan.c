/* SPDX-License-Identifier: MIT */
/* Shipped scenes as planned: the estimates beside what is drawn, and the picture beside
 * that of the exact rungs, within the scene's budget. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "host/path.h"
#include "host/stage.h"
#include "raster/raster.h"
#include "tidepool/plan.h"

enum { WIDTH = 320, HEIGHT = 240, COUNT = WIDTH * HEIGHT, LATE = 100 };

typedef struct {
    uint32_t pixel[COUNT];
    bool     water[COUNT];
    uint32_t waters, vertices;
} drawing;

/* One tile over all; the samples' keys are the first plane of its scratch. */
static void draw(drawing *to, const stage *s, const tp_scene *scene)
{
    const tp_frame_config config = { .width = WIDTH, .height = HEIGHT };
    void *block = malloc(tp_frame_bytes(scene, &s->assets.names, &config));
    uint32_t *scratch = malloc(tp_frame_scratch_bytes(&config));
    tp_frame *frame;
    tp_tile   tile;

    assert_true(block && scratch);
    assert_int_equal(tp_frame_init(&frame, scene, &s->assets.names, &config, block, NULL),
                     TP_OK);
    tp_frame_begin(frame, s->world);
    tp_frame_tile(frame, 0, scratch, &tile);
    to->waters = 0;
    for (size_t i = 0; i < COUNT; i++) {
        to->water[i] = TP_MARK(scratch[i]) == TP_MARK_WATER;
        to->waters += to->water[i];
    }
    memcpy(to->pixel, tile.pixels, sizeof to->pixel);
    to->vertices = tp_frame_last_stats(frame).vertices;
    free(scratch);
    free(block);
}

static double rms_of(const drawing *a, const drawing *b)
{
    double sum[3] = { 0, 0, 0 };
    uint32_t count = 1;

    for (size_t i = 0; i < COUNT; i++) {
        if (!a->water[i] || !b->water[i])
            continue;
        count++;
        for (int c = 0; c < 3; c++) {
            const int off = (int)(a->pixel[i] >> 8 * c & 255)
                          - (int)(b->pixel[i] >> 8 * c & 255);
            sum[c] += off * off;
        }
    }
    return sqrt(fmax(sum[0], fmax(sum[1], sum[2])) / count);
}

static double px_of(const drawing *exact, const drawing *b)
{
    uint32_t elsewhere = 0, borders = 1;

    for (size_t i = 0; i < COUNT; i++) {
        elsewhere += exact->water[i] != b->water[i];
        borders += i >= WIDTH && exact->water[i] != exact->water[i - WIDTH];
    }
    return (double)elsewhere / borders;
}

/* Against the exact rungs with every wave. */
static void compare(const stage *s, const tp_plan_report *r, uint32_t tick)
{
    static drawing planned, exact;
    tp_scene scene = s->file.scene;
    const double px_most = scene.quality.error_px / 65536.0;
    const double rms_most = scene.quality.error_colour / 65536.0;

    draw(&planned, s, &scene);
    scene.quality.visibility = TP_VISIBILITY_TRIANGLES;
    scene.quality.shading = TP_SHADING_EXACT;
    scene.quality.rate = TP_RATE_FULL;
    scene.quality.lod = TP_LOD_OFF;
    scene.quality.error_px = scene.quality.error_colour = 0;
    draw(&exact, s, &scene);
    const double px = px_of(&exact, &planned), rms = rms_of(&exact, &planned);
    printf("    %-13s %5u of %5u pixels, %5u of %5u vertices, %6.2f M; off %.2f px of"
           " %.2f, %.2f of %.2f\n", s->file.name, r->water_pixels, exact.waters,
           r->vertices, exact.vertices, (double)r->total.cost / 1e6, px, px_most, rms,
           rms_most);
    assert_true(px <= px_most && rms <= rms_most);
    if (tick == 0)              /* boats, drops and walls hide water */
        assert_true(r->water_pixels + COUNT / 20 >= exact.waters);
}

static void look_at(const char *name)
{
    char path[160];
    options o = { .command = "plan", .scene = path, .width = WIDTH, .height = HEIGHT };
    stage s;

    snprintf(path, sizeof path, "assets/scenes/%s.ini", name);
    assert_int_equal(stage_open(&s, &o), 0);
    const tp_scene *scene = &s.file.scene;
    const tp_plan_report r = tp_plan_of(scene, &s.assets.names, WIDTH, HEIGHT);
    assert_true(r.total.known);
    assert_true(r.total.error_px <= scene->quality.error_px);
    assert_true(r.total.error_colour <= scene->quality.error_colour);
    compare(&s, &r, 0);
    for (int i = 0; i < LATE; i++)
        tp_world_step(s.world, scene, NULL);
    compare(&s, &r, LATE);
    stage_close(&s);
}

static void shipped_scenes_keep_their_budgets(void **state)
{
    size_t count;
    char **names = path_scene_names("assets/scenes", &count);

    (void)state;
    assert_true(count > 10);
    for (size_t i = 0; i < count; i++)
        look_at(names[i]);
    path_free_names(names, count);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shipped_scenes_keep_their_budgets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
