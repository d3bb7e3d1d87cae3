/* SPDX-License-Identifier: MIT */
/* Level of detail of the grid: omitted lines, the change of the picture, and continuity
 * under camera motion. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#define LEVEL_WIDTH  320
#define LEVEL_HEIGHT 240
#include "tests/lib/tilings.h"

static uint64_t chance;
static test_boat boat;

/* The mesh of count-100, seen at any heading. */
static tp_scene far_scene(void)
{
    tp_scene s = scene_plain();
    static const double size[3][2] = { { 0.4, 21 }, { 0.22, 12 }, { 0.12, 7 } };

    for (int i = 0; i < 3; i++)
        s.wave[i] = (tp_wave){ .amplitude = TP_FX(size[i][0]), .length = TP_FX(size[i][1]),
                               .steepness = TP_FX(0.2), .speed = TP_FX_ONE,
                               .heading = (30 + 45 * i) * TP_FX_ONE, .exponent = 1 };
    s.camera.x = chance_fx(&chance, -50, 50);
    s.camera.z = chance_fx(&chance, -50, 50);
    s.camera.y = 4 * TP_FX_ONE;
    s.camera.pitch = -8 * TP_FX_ONE;
    s.camera.heading = chance_fx(&chance, 0, 360);
    s.grid.cols = s.grid.rows = 100;
    s.grid.cell = TP_FX(1.06);
    s.grid.reach = 0;
    return s;
}

static const tp_grid *grid_of(const level_shot *shot)
{
    return shot->frame.frame->buffers.grid;
}

static void draw(level_shot *shot, tp_scene *scene, tp_visibility how, bool lod)
{
    const tp_assets none = { 0 };

    scene->quality.lod = lod ? TP_LOD_ON : TP_LOD_OFF;
    level_draw(shot, scene, &none, how, 40);
}

/* Counts cells in view with both sides below 6 px at their depth.  The remaining small
 * cells belong to lines that are seen nearer elsewhere, as at a heading between the
 * axes. */
static void fewer_cells_in_view_are_below_six_pixels(void **state)
{
    (void)state;
    static level_shot shot;
    uint32_t small[2] = { 0, 0 }, all = 0, vertices[2] = { 0, 0 };

    for (int n = 0; n < 40; n++) {
        tp_scene scene = far_scene();
        draw(&shot, &scene, TP_VISIBILITY_TRIANGLES, n % 2);
        const tp_grid *grid = grid_of(&shot);
        vertices[n % 2] += grid->vertices;
        for (uint32_t j = 1; j + 1 < grid->rows; j++) {
            const tp_fx along = grid->row[j + 1].place - grid->row[j].place;
            for (uint32_t i = grid->span[j].first; i < grid->span[j].end; i++) {
                const tp_grid_vertex *v = &grid->vertex[(size_t)j * grid->cols + i];
                if (v->u == TP_GRID_NEEDS_CLIP || v->u < 0 || v->u >= 16 * LEVEL_WIDTH)
                    continue;
                const tp_fx across = grid->column[i + 1].place - grid->column[i].place;
                const double depth = 0.25 * 255 / 256 * 2147483648.0 / v->zi;
                const double side = (along > across ? along : across) / 65536.0;
                all += (uint32_t)n % 2;
                small[n % 2] +=
                    side * shot.frame.frame->projection.focal / 65536 / depth < 6;
            }
        }
        frame_free(&shot.frame);
    }
    print_message("below 6 px: %u cells of %u, without LOD %u; vertices %u of %u\n",
                  small[1], all, small[0], vertices[1], vertices[0]);
    assert_true(small[1] * 5 < small[0] * 2);
    assert_true(vertices[1] * 5 < vertices[0] * 4);
}

static void the_picture_stays_what_it_was(void **state)
{
    (void)state;
    static level_shot even, thin;
    double most = 0, sum = 0;

    for (int n = 0; n < 12; n++) {
        const tp_visibility how = TP_VISIBILITY_TRIANGLES;
        tp_scene scene = far_scene();
        draw(&even, &scene, how, false);
        draw(&thin, &scene, how, true);
        assert_int_equal(thin.frame.frame->visibility, how);
        const double apart = level_colour_apart(&even, &thin);
        most = fmax(most, apart);
        sum += apart;
        assert_in_range(level_apart(&even, &thin), 0, LEVEL_WIDTH);
        frame_free(&even.frame);
        frame_free(&thin.frame);
    }
    print_message("mean of 255: %.2f at the most, %.2f on average\n", most, sum / 12);
    assert_true(most < 2);
}

/* Moves 2 m in steps of 1 cm, past every threshold of rows or columns, and returns the
 * largest change in a step. */
static double most_change(tp_scene *scene, bool lod, bool along_x)
{
    static level_shot shot[2];
    double most = 0;

    for (int n = 0; n <= 200; n++) {
        draw(&shot[n % 2], scene, TP_VISIBILITY_TRIANGLES, lod);
        if (n > 0) {
            most = fmax(most, level_colour_apart(&shot[0], &shot[1]));
            frame_free(&shot[(n + 1) % 2].frame);
        }
        *(along_x ? &scene->camera.x : &scene->camera.z) += 655;
    }
    frame_free(&shot[0].frame);
    return most;
}

static void nothing_pops_as_the_camera_moves(void **state)
{
    (void)state;
    for (int n = 0; n < 4; n++) {
        tp_scene scene = far_scene(), same = scene;
        const double even = most_change(&scene, false, n % 2);
        const double thin = most_change(&same, true, n % 2);
        print_message("1 cm changes at the most %.3f of 255, thinned %.3f\n", even, thin);
        assert_true(thin < even + 0.05);
    }
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fewer_cells_in_view_are_below_six_pixels),
        cmocka_unit_test(the_picture_stays_what_it_was),
        cmocka_unit_test(nothing_pops_as_the_camera_moves),
    };
    return cmocka_run_group_tests_name("frame/lod", tests, NULL, NULL);
}
