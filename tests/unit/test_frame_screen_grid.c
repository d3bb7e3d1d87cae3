/* SPDX-License-Identifier: MIT */
/* Water drawn by a screen grid equals the picture of a fine mesh, up to the limit of the
 * renderer's validity. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#define LEVEL_WIDTH  320
#define LEVEL_HEIGHT 200
#include "tests/lib/tilings.h"

static uint64_t chance;
static test_boat boat;

/* Three swells and a mesh fine enough to represent the swells. */
static tp_scene fine_scene(void)
{
    tp_scene s = scene_plain();

    for (int i = 0; i < 3; i++) {
        s.wave[i].length = chance_fx(&chance, 6, 30);
        s.wave[i].amplitude = (tp_fx)(s.wave[i].length * chance_double(&chance, 0, 0.02));
        s.wave[i].steepness = chance_fx(&chance, 0, 0.2);
        s.wave[i].heading = chance_fx(&chance, 0, 360);
    }
    s.camera.y = chance_fx(&chance, 2.5, 12);
    s.camera.heading = chance_fx(&chance, 0, 360);
    s.camera.pitch = chance_fx(&chance, -50, 5);
    s.camera.fov = chance_fx(&chance, 30, 70);
    s.grid.vertices = 65536;
    s.water.specular = s.water.reflection = 0;      /* the mesh spreads them by variance */
    return s;
}

/* Topmost row of water in a column with water down to the bottom; -1 if there is a hole. */
static int top_of(const level_shot *shot, int x)
{
    int y = 0;

    while (y < LEVEL_HEIGHT && !level_is_water(shot, y * LEVEL_WIDTH + x))
        y++;
    const int top = y;
    while (y < LEVEL_HEIGHT && level_is_water(shot, y * LEVEL_WIDTH + x))
        y++;
    return y == LEVEL_HEIGHT ? top : -1;
}

typedef struct {
    int    most, columns;       /* largest row distance between the outlines */
    double sum, colour;         /* sum of rows; mean of 255 */
} picture_difference;

static picture_difference compare(const level_shot *mesh, const level_shot *lines)
{
    picture_difference d = { 0, LEVEL_WIDTH, 0, level_colour_apart(mesh, lines) };

    for (int x = 0; x < LEVEL_WIDTH; x++) {
        const int a = top_of(mesh, x), b = top_of(lines, x);
        assert_int_not_equal(b, -1);
        const int apart = a < 0 ? 0 : abs(a - b);
        d.most = apart > d.most ? apart : d.most;
        d.sum += apart;
    }
    return d;
}

static void add(picture_difference *all, const picture_difference *d)
{
    all->most = d->most > all->most ? d->most : all->most;
    all->columns += d->columns;
    all->sum += d->sum;
    all->colour = fmax(all->colour, d->colour);
}

/* True if the projected renderer is valid for the scene; then compares both pictures. */
static bool look(tp_scene *scene, const tp_assets *assets, picture_difference *all)
{
    static level_shot mesh, lines;

    level_draw(&lines, scene, assets, TP_VISIBILITY_PROJECTED, 40);
    const bool holds = lines.frame.frame->visibility == TP_VISIBILITY_PROJECTED;
    if (holds) {
        level_draw(&mesh, scene, assets, TP_VISIBILITY_TRIANGLES, 40);
        const picture_difference d = compare(&mesh, &lines);
        add(all, &d);
        assert_true(d.colour < 2);
        assert_true(d.sum / d.columns <= 1);    /* the horizon between two rows of pixels */
        assert_in_range(d.most, 0, 3);
        frame_free(&mesh.frame);
    }
    frame_free(&lines.frame);
    return holds;
}

static void print(const char *what, int views, const picture_difference *d)
{
    print_message("%s: %d views, outlines %d rows apart at the most, %.3f in the mean, "
                  "colours %.2f at the most\n", what, views, d->most,
                  d->sum / (d->columns ? d->columns : 1), d->colour);
}

static void lines_over_the_picture_are_the_fine_mesh(void **state)
{
    (void)state;
    const tp_assets assets = { .layer[0] = &boat.texture[0] };
    picture_difference all = { 0, 0, 0, 0 };
    int held = 0;

    const int count = random_rounds(60, 20);
    for (int n = 0; n < count; n++) {
        tp_scene scene = fine_scene();
        scene.layer[0].map.size = 40 * TP_FX_ONE;
        held += look(&scene, &assets, &all);
    }
    print("any view", held, &all);
    assert_in_range(held, count / 4, count - 1);
}

/* A scene parameter that moves from the validity of the projected renderer to outside: up
 * to the last valid step the picture equals the mesh's picture. */
typedef struct {
    const char *name;
    int32_t     from, to;
} frame_sweep;

static void set(tp_scene *s, int which, int32_t to)
{
    if (which == 0)
        s->camera.pitch = to;
    else if (which == 1)
        s->camera.y = to;
    else if (which == 2)
        s->wave[0].steepness = to;
    else
        s->camera.fov = to;
}

static void up_to_the_border_it_is_the_mesh(void **state)
{
    (void)state;
    static const frame_sweep sweeps[] = {
        { "pitch", 0, -89 * TP_FX_ONE }, { "height", 6 * TP_FX_ONE, TP_FX(0.5) },
        { "steepness", 0, TP_FX_ONE }, { "fov", 40 * TP_FX_ONE, 100 * TP_FX_ONE },
    };
    const tp_assets none = { 0 };

    for (int k = 0; k < 4; k++) {
        picture_difference all = { 0, 0, 0, 0 };
        int views = 0;
        for (int n = 0; n < random_rounds(3, 2); n++) {
            tp_scene scene = fine_scene();
            scene.camera.pitch = k == 3 ? -25 * TP_FX_ONE : -4 * TP_FX_ONE;
            scene.camera.y = 5 * TP_FX_ONE;
            int32_t low = sweeps[k].from, high = sweeps[k].to;
            set(&scene, k, low);
            if (!look(&scene, &none, &all))
                continue;
            for (int i = 0; i < 9; i++) {
                const int32_t middle = (low + high) / 2;
                set(&scene, k, middle);
                const bool holds = look(&scene, &none, &all);
                views += holds;
                low = holds ? middle : low;
                high = holds ? high : middle;
            }
        }
        print(sweeps[k].name, views, &all);
        assert_true(views > 2);
    }
}

static void every_tiling_of_projected_water_is_the_same(void **state)
{
    (void)state;
    const tp_assets assets = { .boat = &boat.mesh, .layer[0] = &boat.texture[0] };
    int held = 0, rolled = 0;

    for (int n = 0; n < 12; n++) {
        static level_shot whole;
        tp_scene scene = fine_scene();
        if (n % 3 == 0) {
            level_board(&scene, 5 * TP_FX_ONE);
            scene.camera.pitch = -10 * TP_FX_ONE;
        }
        level_draw(&whole, &scene, &assets, TP_VISIBILITY_PROJECTED, 17);
        const bool holds = whole.frame.frame->visibility == TP_VISIBILITY_PROJECTED;
        held += holds;
        rolled += holds && whole.frame.frame->buffers.level->rolled;
        if (holds)
            level_compare_tilings(&whole, &scene, &assets);
        frame_free(&whole.frame);
    }
    print_message("%d pictures, %d of them roll\n", held, rolled);
    assert_true(held > 4 && rolled > 0);
}

int main(void)
{
    chance = random_seed();
    boat_make(&boat, &chance);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_over_the_picture_are_the_fine_mesh),
        cmocka_unit_test(up_to_the_border_it_is_the_mesh),
        cmocka_unit_test(every_tiling_of_projected_water_is_the_same),
    };
    return cmocka_run_group_tests_name("frame/screen_grid", tests, NULL, NULL);
}
