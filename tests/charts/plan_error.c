/* SPDX-License-Identifier: MIT */
/* Error that the quality plan predicts against the error of its picture, for cameras at
 * random around a shipped scene's own, as rows of the chart "plan-error":
 *
 *     plan_error SCENE
 *
 * The plan chooses the rungs anew for each camera, within a budget of 8 levels and 1 pixel
 * of the outlines; most scenes would take the exact rungs within their own.  The errors are
 * those of tests/lib/quality_error.h, at 160x120, tick 60: beyond the error of the exact
 * rungs. */
#include <stdio.h>
#include "tests/lib/quality_error.h"

enum { CAMERAS = 12, TICK = 60 };

#define DEGREE 65536

/* Returns a number from -most to most; the sequence is the same on every machine. */
static int32_t random_of(uint32_t *seed, int32_t most)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (int32_t)((int64_t)(*seed >> 8) * (2 * (int64_t)most + 1) >> 24) - most;
}

/* Turns the camera by up to 25 degrees, tips it by up to 8, moves it by up to 1 m and
 * changes its height by up to a third. */
static tp_scene other_camera(const tp_scene *own, uint32_t *seed)
{
    tp_scene scene = *own;

    scene.camera.heading += random_of(seed, 25 * DEGREE);
    scene.camera.pitch += random_of(seed, 8 * DEGREE);
    scene.camera.x += random_of(seed, 65536);
    scene.camera.z += random_of(seed, 65536);
    scene.camera.y += random_of(seed, abs(own->camera.y) / 3);
    scene.quality.error_px = 65536;
    scene.quality.error_colour = 8 * 65536;
    return scene;
}

static void print_row(const char *name, int camera, const char *column, double value)
{
    printf("plan-error,%s;%d,%s,%.3f\n", name, camera, column, value);
}

/* Compares the planned picture of one camera. */
static void compare(loaded_scene *s, int camera)
{
    static truth_drawing planned, exact, truth;
    const tp_scene scene = s->file.scene;
    const tp_scene exactly = exact_scene(s);
    const tp_plan_report r = tp_plan_make(&scene, &s->assets.names, width, height);
    const tp_vec3 eye = { scene.camera.x, scene.camera.y, scene.camera.z };
    error more[2];

    tp_world_set_camera(s->world, eye, tp_turn_of_degrees(scene.camera.heading),
                        tp_turn_of_degrees(scene.camera.pitch), 0);
    draw(&planned, s, &scene, s->world);
    draw(&exact, s, &exactly, s->world);
    for (uint32_t parts = 1; parts <= 2; parts++) {
        draw_truth(&truth, s, s->world, parts);
        more[parts - 1] = beyond(error_of(&truth, &planned), error_of(&truth, &exact));
    }
    print_row(s->file.name, camera, "predicted_px", r.total.error_px / 65536.0);
    print_row(s->file.name, camera, "px", fmin(more[0].px, more[1].px));
    print_row(s->file.name, camera, "predicted", r.total.error_colour / 65536.0);
    print_row(s->file.name, camera, "colour", fmin(more[0].colour, more[1].colour));
}

int main(int count, char **words)
{
    char path[160];
    options o = { .command = "plan", .scene = path, .width = width, .height = height };
    loaded_scene s;
    uint32_t seed = 1;

    if (count != 2) {
        fprintf(stderr, "usage: plan_error SCENE\n");
        return 2;
    }
    snprintf(path, sizeof path, "assets/scenes/%s.ini", words[1]);
    if (loaded_scene_open(&s, &o))
        return 1;
    const tp_scene own = s.file.scene;
    for (uint32_t tick = 0; tick < TICK; tick++)
        tp_world_step(&tp_program_all, s.world, &own, NULL);
    for (int i = 0; i < CAMERAS;) {
        s.file.scene = other_camera(&own, &seed);
        if (tp_scene_check(&s.file.scene, NULL))
            continue;
        compare(&s, ++i);
    }
    loaded_scene_close(&s);
    return 0;
}
