/* SPDX-License-Identifier: MIT */
/* Draws shipped scenes with a rolled camera: half a turn gives the same picture upside
 * down, and each water renderer draws the picture that triangles draw.
 *
 * An upside-down picture is the unrolled picture turned by half a turn, except where pixel
 * centres fall on an edge, where blocks of perspective begin, and for patterns tied to the
 * picture's own pixels: screen doors, faint stars. TP_ROLLED_PICTURES=FOLDER keeps the
 * pictures. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/scene/frame_renderer.h"
#include "world/world.h"
#include "tools/reference/shipped_scene.h"

enum { WIDTH = 320, HEIGHT = 240, PIXELS = WIDTH * HEIGHT, TICKS = 100 };

static void open_level(ref_stand *s, const char *name)
{
    char path[128];

    snprintf(path, sizeof path, "assets/scenes/%s.ini", name);
    assert_int_equal(ref_stand_open(s, path, NULL, 0, TICKS), 0);
    const tp_camera camera = tp_world_camera(s->world);
    tp_world_set_camera(s->world, camera.eye, s->world->heading, s->world->pitch, 0);
}

static void keep(const picture *p, const char *name, const char *how, int degrees)
{
    const char *folder = getenv("TP_ROLLED_PICTURES");
    char path[256];

    if (!folder)
        return;
    snprintf(path, sizeof path, "%s/%s-%s-%d.png", folder, name, how, degrees);
    assert_int_equal(picture_write_png(p, path), 0);
}

/* Draws with one water renderer; `quick`: with the plan's other rungs, else with the exact
 * rungs. */
static void draw(ref_stand *s, const char *name, tp_visibility how, bool quick, int degrees,
                 uint32_t *pixels)
{
    static const char *const names[] = { "planned", "triangles", "rows", "projected",
                                         "flat" };
    const tp_config config = { .width = WIDTH, .height = HEIGHT };
    frame_renderer c;

    s->world->roll = s->world->last_roll = tp_turn_of_degrees(degrees * TP_FX_ONE);
    s->file.scene.quality.visibility = (int32_t)how;
    s->file.scene.quality.shading = quick ? TP_SHADING_AUTO : TP_SHADING_EXACT;
    s->file.scene.quality.rate = quick ? TP_RATE_AUTO : TP_RATE_FULL;
    memset(&c, 0, sizeof c);
    frame_renderer_plan(&c, &config, 1);
    assert_int_equal(frame_renderer_open(&c, &s->file.scene, &s->assets.names), 0);
    frame_renderer_draw(&c, s->world);
    for (uint32_t y = 0; y < HEIGHT; y++)
        picture_expand_row(&c.picture, y, pixels + y * WIDTH);
    keep(&c.picture, name, names[how], degrees);
    frame_renderer_close(&c);
}

/* Share of pixels, %, with a channel off by more than 24. */
static double apart(const uint32_t *a, const uint32_t *b, bool turned)
{
    int count = 0;

    for (int i = 0; i < PIXELS; i++) {
        const uint32_t p = a[i], q = b[turned ? PIXELS - 1 - i : i];
        int most = 0;
        for (int k = 0; k < 24; k += 8) {
            const int by = abs((int)(p >> k & 255) - (int)(q >> k & 255));
            most = by > most ? by : most;
        }
        count += most > 24;
    }
    return 100.0 * count / PIXELS;
}

static const char *const scenes[] = { "storm",     "tank",         "pond",
                                      "raindrops", "three-swells", "night-sea",
                                      "harbour",   "shore-break",  "lava" };
enum { SCENES = sizeof scenes / sizeof *scenes };

static uint32_t level[PIXELS], rolled[PIXELS], other[PIXELS];

/* From within the water the surface is seen from below. */
static void under_water_half_a_turn_is_upside_down_too(void **state)
{
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        ref_stand s;
        open_level(&s, scenes[i]);
        const bool tank = s.file.scene.tank.kind != TP_TANK_NONE;
        const tp_scene_pool *pool = &s.file.scene.pool;
        const tp_vec3 eye = { tank ? pool->x : s.world->eye.x,
                              tank ? TP_FX(-0.2) : TP_FX(-4),
                              tank ? pool->z : s.world->eye.z };
        tp_world_set_camera(s.world, eye, s.world->heading, TP_DEG(10), 0);
        draw(&s, scenes[i], TP_VISIBILITY_TRIANGLES, false, 0, level);
        draw(&s, scenes[i], TP_VISIBILITY_TRIANGLES, false, 180, rolled);
        const double off = apart(level, rolled, true);
        printf("    %-12s under water %.2f %% of the pixels differ\n", scenes[i], off);
        assert_true(off <= 0.5);
        ref_stand_close(&s);
    }
}

static void half_a_turn_is_the_picture_upside_down(void **state)
{
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        ref_stand s;
        open_level(&s, scenes[i]);
        for (int quick = 0; quick < 2; quick++) {
            draw(&s, scenes[i], quick ? TP_VISIBILITY_AUTO : TP_VISIBILITY_TRIANGLES,
                 quick, 0, level);
            draw(&s, scenes[i], quick ? TP_VISIBILITY_AUTO : TP_VISIBILITY_TRIANGLES,
                 quick, 180, rolled);
            const double off = apart(level, rolled, true);
            printf("    %-12s %-9s %.2f %% of the pixels differ\n", scenes[i],
                   quick ? "planned" : "exact", off);
            assert_true(off <= (quick ? 2 : 0.5));
        }
        ref_stand_close(&s);
    }
}

/* Draws with each renderer that holds. Differences in %; `off`: of rows, projected, flat
 * and the plan's own. */
static void try_methods(ref_stand *s, const char *name, int degrees, double off[4])
{
    draw(s, name, TP_VISIBILITY_TRIANGLES, false, degrees, level);
    for (int how = TP_VISIBILITY_ROWS; how <= TP_VISIBILITY_FLAT; how++) {
        draw(s, name, (tp_visibility)how, false, degrees, other);
        off[how - TP_VISIBILITY_ROWS] = apart(level, other, false);
    }
    draw(s, name, TP_VISIBILITY_AUTO, true, degrees, other);
    off[3] = apart(level, other, false);
    printf("    %-12s %3d degrees: rows %5.2f %%, projected %5.2f %%, flat %5.2f %%,"
           " planned %5.2f %%\n",
           name, degrees, off[0], off[1], off[2], off[3]);
}

/* Projected and flat are approximations: rolled, the difference is at most twice the
 * difference of the upright picture. */
static void every_method_draws_what_triangles_draw(void **state)
{
    static const int degrees[] = { 10, 45, 90, 180, 225 };
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        double upright[4], off[4];
        ref_stand s;
        open_level(&s, scenes[i]);
        try_methods(&s, scenes[i], 0, upright);
        for (size_t k = 0; k < sizeof degrees / sizeof *degrees; k++) {
            try_methods(&s, scenes[i], degrees[k], off);
            for (int how = 0; how < 4; how++)
                assert_true(off[how] <= 2 * upright[how] + 0.5);
        }
        ref_stand_close(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(half_a_turn_is_the_picture_upside_down),
        cmocka_unit_test(under_water_half_a_turn_is_upside_down_too),
        cmocka_unit_test(every_method_draws_what_triangles_draw),
    };
    return cmocka_run_group_tests_name("rolled", tests, NULL, NULL);
}
