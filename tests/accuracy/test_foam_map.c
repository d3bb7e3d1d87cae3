/* SPDX-License-Identifier: MIT */
/* Foam over a floor goes on beyond the window of its cells.
 *
 * Pictures: a beach straight from above. Foam alone is the picture less the picture without
 * foam; rings lie around the eye. The scene's own window ends amid the rings, and a window
 * twice as wide has all of them inside its full weight: ring by ring the foam of both is the
 * same but for the clumps of single crests, and no ring is bare. By the same bounds the foam
 * of each ring is alike in water and in surf.
 *
 * A straight beach beyond the window: all foam in the picture is that of a window with the
 * beach in it.
 *
 * Cover: the law by depth against the mean of a field's cells at the same depths. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "features/foam/foam.h"
#include "tests/lib/reference_difference.h"
#include "waves/coastal_tables.h"
#include "world/module.h"
#include "world/pools.h"

enum { WIDTH = 320, HEIGHT = 240, TICKS = 4, RINGS = 6, SETTINGS = 8, DEPTHS = 8 };

#define RING  8.0               /* m: width of a ring */
#define LEAST 0.85              /* bounds of ratios of means */
#define MOST  1.15
#define UNSEEN 1.5              /* of 255: a difference that nobody sees */
#define COVER 18               /* of 255: bound of a mean's difference */
#define RADIUS 32.0             /* m: half of a side of the scene's own window */

static const char *const places[][2] = {
    { "camera.x=60", "camera.z=0" }, { "camera.x=52", "camera.z=-44" },
};

enum { PLACES = sizeof places / sizeof *places };

static void open_beach(ref_stand *stand, const char *const place[2], uint32_t tick,
                       const char *cells, const char *fade)
{
    const char *const set[SETTINGS] = { place[0], place[1], "camera.y=90",
                                        "camera.pitch=-89", "water.specular=0", cells, fade };

    assert_int_equal(ref_stand_open(stand, "assets/scenes/shallows.ini", set,
                                    SETTINGS - 1 - !fade, tick), 0);
}

/* -- pictures ------------------------------------------------------------------------ */

typedef struct {
    double sum[RINGS], pixels[RINGS];
} ring_sums;

static void add_picture(ring_sums *rings, const ref_stand *stand, const drawn_image *with,
                        const drawn_image *bare)
{
    const ref_camera c = ref_scene_camera(&stand->file.scene, stand->world, WIDTH, HEIGHT);

    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const double u = (i % WIDTH + 0.5 - c.u0) / c.focal;
        const double v = (c.v0 - i / WIDTH - 0.5) / c.focal;
        const double far = -c.eye.y / (c.ahead.y + u * c.right.y + v * c.up.y);
        const int ring = (int)(far * hypot(c.ahead.x + u * c.right.x + v * c.up.x,
                                           c.ahead.z + u * c.right.z + v * c.up.z) / RING);
        if (ring >= RINGS || with->kind[i] != REF_WATER || bare->kind[i] != REF_WATER)
            continue;
        rings->sum[ring] += ref_colour_unpack(with->pixel[i]).c[1]
                          - ref_colour_unpack(bare->pixel[i]).c[1];
        rings->pixels[ring]++;
    }
}

/* Steps to picture `t` of a row of pictures. */
static void step_to(ref_stand *stand, uint32_t t)
{
    while (stand->world->tick < 300 + 130 * t)
        tp_world_step(&tp_program_all, stand->world, &stand->file.scene, NULL);
}

/* Foam in the scene's own window and in a wide window, less the same water without foam. */
static void look(ring_sums rings[2], const char *const place[2])
{
    static const char *const cells[3] = { "foam.cells=128", "foam.cells=256",
                                          "foam.cells=0" };
    ref_stand stand[3];

    memset(rings, 0, 2 * sizeof *rings);
    for (int i = 0; i < 3; i++)
        open_beach(&stand[i], place, 0, cells[i], NULL);
    for (uint32_t t = 0; t < TICKS; t++) {
        drawn_image drawn[3];
        for (int i = 0; i < 3; i++) {
            step_to(&stand[i], t);
            drawn[i] = drawn_of(&stand[i], WIDTH, HEIGHT);
        }
        for (int i = 0; i < 2; i++)
            add_picture(&rings[i], &stand[i], &drawn[i], &drawn[2]);
        for (int i = 0; i < 3; i++)
            drawn_free(&drawn[i]);
    }
    for (int i = 0; i < 3; i++)
        ref_stand_close(&stand[i]);
}

static bool is_alike(double a, double b)
{
    return (a >= LEAST * b && a <= MOST * b) || fabs(a - b) < UNSEEN;
}

static int check_place(const char *const place[2])
{
    ring_sums rings[2];
    double beyond = 0;
    int unlike = 0;

    look(rings, place);
    for (int i = 0; i < RINGS; i++) {
        const double a = rings[0].sum[i] / fmax(rings[0].pixels[i], 1),
                     b = rings[1].sum[i] / fmax(rings[1].pixels[i], 1);
        printf("    %s, %s: %2.0f m%s foam %6.2f, in a wide window %6.2f\n", place[0],
               place[1], RING * i, RING * i >= RADIUS ? " beyond" : "       ", a, b);
        unlike += !is_alike(a, b);
        beyond += RING * i >= RADIUS ? b : 0;
    }
    assert_true(beyond > 5);
    return unlike;
}

static void foam_goes_on_over_a_map(void **state)
{
    int unlike = 0;

    (void)state;
    for (int i = 0; i < PLACES; i++)
        unlike += check_place(places[i]);
    assert_int_equal(unlike, 0);
}

/* -- a straight beach ---------------------------------------------------------------- */

static drawn_image draw_shore_break(const char *cells, const char *cell, uint32_t tick)
{
    const char *const set[] = { "camera.z=90", "camera.y=40", "camera.pitch=-18",
                                "water.specular=0", cell, cells };
    ref_stand stand;

    assert_int_equal(ref_stand_open(&stand, "assets/scenes/shore-break.ini", set, 6, tick),
                     0);
    const drawn_image drawn = drawn_of(&stand, WIDTH, HEIGHT);
    ref_stand_close(&stand);
    return drawn;
}

/* Returns the mean of the foam in the picture's water over TICKS moments. */
static double beach_foam(const char *cells, const char *cell)
{
    double sum = 0, pixels = 0;

    for (uint32_t t = 0; t < TICKS; t++) {
        drawn_image with = draw_shore_break(cells, cell, 300 + 130 * t);
        drawn_image bare = draw_shore_break("foam.cells=0", cell, 300 + 130 * t);
        for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
            if (with.kind[i] != REF_WATER || bare.kind[i] != REF_WATER)
                continue;
            sum += ref_colour_unpack(with.pixel[i]).c[1]
                 - ref_colour_unpack(bare.pixel[i]).c[1];
            pixels++;
        }
        drawn_free(&with);
        drawn_free(&bare);
    }
    return sum / pixels;
}

static void foam_goes_on_along_a_beach(void **state)
{
    const double by_depth = beach_foam("foam.cells=128", "foam.cell=0.4"),
                 field = beach_foam("foam.cells=256", "foam.cell=1.2");

    (void)state;
    printf("    foam of a beach 71 m away: by the depth %.2f, of the field %.2f\n",
           by_depth, field);
    assert_true(field > 2);
    assert_true(is_alike(by_depth, field));
}

/* -- cover --------------------------------------------------------------------------- */

typedef struct {
    double field[DEPTHS], law[DEPTHS], cells[DEPTHS];
} depth_sums;

static void add_cells(depth_sums *sums, ref_stand *stand)
{
    const tp_foam *foam = tp_world_foam(stand->world);
    const tp_coastal_water *map = tp_foam_map(stand->world);
    tp_foam_maker make;

    assert_non_null(map);
    tp_foam_maker_begin(&make, tp_foam_of_world(stand->world),
                        &tp_program_all.water, stand->world,
                        &stand->file.scene);
    for (uint32_t i = 0; i < foam->cells * foam->cells; i++) {
        const int32_t col = foam->first_x + (int32_t)(i % foam->cells),
                      row = foam->first_z + (int32_t)(i / foam->cells);
        const tp_fx x = col * foam->cell + foam->cell / 2,
                    z = row * foam->cell + foam->cell / 2;
        const tp_fx depth = tp_coastal_floor(map, x, z).depth;
        const int at = depth / TP_FX(0.25);
        if (depth <= 0 || at >= DEPTHS)
            continue;
        sums->field[at] += tp_foam_sample(foam, x, z);
        sums->law[at] += tp_foam_maker_mean_cover(&make, depth,
                                                  foam->visits / TP_FOAM_TICKS);
        sums->cells[at]++;
    }
}

static int check_depths(const char *fade)
{
    static depth_sums sums;
    ref_stand stand;
    int unlike = 0;

    sums = (depth_sums){ { 0 }, { 0 }, { 0 } };
    open_beach(&stand, places[0], 0, "foam.cells=256", fade);
    for (uint32_t t = 0; t < TICKS; t++) {
        step_to(&stand, t);
        add_cells(&sums, &stand);
    }
    ref_stand_close(&stand);
    for (int i = 0; i < DEPTHS; i++) {
        const double n = fmax(sums.cells[i], 1), a = sums.law[i] / n, b = sums.field[i] / n;
        printf("    %-10s %4.2f m: cover by depth %5.1f, field %5.1f in %5.0f cells\n",
               fade, i * 0.25, a, b, sums.cells[i]);
        unlike += fabs(a - b) > COVER;
    }
    return unlike;
}

static void cover_by_depth_is_the_mean_of_the_field(void **state)
{
    (void)state;
    assert_int_equal(check_depths("foam.fade=5") + check_depths("foam.fade=1")
                     + check_depths("foam.fade=15"), 0);
}

/* An eye that flies 24 m along the beach in a second leaves no bare water in the window. */
static void window_that_moves_has_foam(void **state)
{
    static depth_sums sums;
    const tp_input aside = { .strafe = TP_FX(0.4) };
    double field = 0, law = 0;
    ref_stand stand;

    (void)state;
    sums = (depth_sums){ { 0 }, { 0 }, { 0 } };
    open_beach(&stand, places[0], 400, "foam.cells=128", NULL);
    const tp_fx from = stand.world->eye.x;
    for (int n = 0; n < 60; n++)
        tp_world_step(&tp_program_all, stand.world, &stand.file.scene, &aside);
    assert_true(tp_abs(stand.world->eye.x - from) > TP_FX(10));
    add_cells(&sums, &stand);
    for (int i = 0; i < DEPTHS; i++) {
        field += sums.field[i];
        law += sums.law[i];
    }
    printf("    cover of the field over that by depth %.3f\n", field / law);
    assert_true(field > LEAST * law && field < MOST * law);
    ref_stand_close(&stand);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(foam_goes_on_over_a_map),
        cmocka_unit_test(foam_goes_on_along_a_beach),
        cmocka_unit_test(cover_by_depth_is_the_mean_of_the_field),
        cmocka_unit_test(window_that_moves_has_foam),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
