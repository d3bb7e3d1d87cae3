/* SPDX-License-Identifier: MIT */
/* Fast sky of a dome compared with the exact sky, for any cuts of spans; the fast map of a
 * cube sky. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/sky/sky.h"
#include "tests/lib/shading.h"

static uint64_t chance;
static test_sky sky;
static quick_lights lights;

/* Cameras that look up, also near the sun: a picture of 640 columns at 60 degrees. */
static tp_shade shade_for(int32_t focal)
{
    tp_shade s = shade_any(&chance);

    sky_dome(&sky, &s, &chance);
    s.env.beyond = 0;
    s.focal = focal * 16;
    s.per_focal = (uint32_t)(((uint64_t)1 << 32) / (uint32_t)s.focal);
    return s;
}

static void both_fills_have_the_same_bits(void **state)
{
    (void)state;
    for (int n = 0; n < 100000; n++) {
        const uint32_t a = (uint32_t)random_next(&chance) & 0xffffff;
        const uint32_t b = (uint32_t)random_next(&chance) & 0xffffff;
        const int32_t k = chance_int(&chance, 0, 15);
        const int32_t end = chance_int(&chance, k + 1, 16);
        uint32_t plain[16], packed[16];
        tp_gradient_fill_scalar(plain, tp_quick_shade_make(a, b), k, end);
        tp_gradient_fill_packed(packed, tp_quick_shade_make(a, b), k, end);
        assert_memory_equal(plain, packed, (size_t)(end - k) * 4);
        assert_true(k > 0 || plain[0] == a);
    }
}

static void where_a_run_is_cut_does_not_show(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        const tp_shade s = shade_for(554);
        test_run r;
        run_any(&r, 0, &chance);
        const int32_t cut = chance_int(&chance, 1, TP_RUN - 1);
        tp_run left = run_part(&r.run, 0, cut), right = run_part(&r.run, cut, TP_RUN);
        tp_stage_quick_sky_dome(&s, &r.run);
        tp_stage_quick_sky_dome(&s, &left);
        tp_stage_quick_sky_dome(&s, &right);
        assert_memory_equal(r.run.colour, left.colour, (size_t)cut * 4);
        assert_memory_equal(r.run.colour + cut, right.colour, (size_t)(TP_RUN - cut) * 4);
    }
}

static void compare(const char *what, int32_t focal, double most)
{
    colour_error off = { .what = what };

    for (int n = 0; n < 4000; n++) {
        const tp_shade s = shade_for(focal);
        test_run r;
        run_any(&r, 0, &chance);
        tp_run quick = r.run;
        tp_stage_sky_dome(&s, &r.run);
        tp_stage_quick_sky_dome(&s, &quick);
        for (int i = 0; i < TP_RUN; i++)
            if (r.run.vy[i] < -100)
                colour_error_add(&off, quick.colour[i], ref_colour_unpack(r.run.colour[i]));
    }
    colour_error_print(&off);
    assert_true(colour_error_rms(&off) < most);
}

static void it_is_the_sky_that_it_was(void **state)
{
    (void)state;
    compare("640 columns", 554, 1.5);
    compare("320 columns", 277, 1.5);
}

/* -- map of a cube sky ----------------------------------------------------------------- */

/* Paints faces of 8 to 64 texels a side with a slowly varying sky. */
static void paint_unequal(const int log2_side[6])
{
    static uint32_t pixels[SKY_SIDE * SKY_SIDE];
    const tp_texture *face[6];

    for (int f = 0; f < 6; f++) {
        const int side = 1 << log2_side[f];
        for (int i = 0; i < side * side; i++)
            pixels[i] = quick_smooth(ref_cube_direction(f, (i % side + 0.5) / side,
                                                 ((double)(i / side) + 0.5) / side), NULL);
        assert_int_equal(tp_texture_init(&lights.sky.face[f], pixels, (uint32_t)side,
                                         (uint32_t)side, lights.sky.texel[f],
                                         tp_texture_bytes((uint32_t)side, (uint32_t)side),
                                         NULL),
                         TP_OK);
        face[f] = &lights.sky.face[f];
    }
    assert_true(tp_cube_init(&lights.sky.cube, face));
}

/* The cell at (u, v) shows the sky towards -(u, v), for any sizes of the faces. */
static void faces_of_unequal_size_are_one_sky(void **state)
{
    (void)state;
    colour_error off = { .what = "unequal faces" };

    for (int n = 0; n < 60; n++) {
        tp_shade s = quick_shade(&lights, TP_ENV_CUBE, TP_LOBE_NONE, &chance);
        const uint32_t *map = lights.quick.sky;
        uint32_t equal[TP_QUICK_SIDE * TP_QUICK_SIDE];
        int log2_side[6];
        memcpy(equal, map, sizeof equal);
        for (int f = 0; f < 6; f++)
            log2_side[f] = chance_int(&chance, 3, 6);
        paint_unequal(log2_side);
        tp_quick_light_init(&lights.tables, &s, TP_LOBE_NONE, false, true);
        if (s.env.kind == TP_ENV_CUBE)
            tp_quick_fill_cube_map(&lights.tables, &s);
        for (int i = 0; i < TP_QUICK_SIDE * TP_QUICK_SIDE; i++)
            colour_error_add(&off, map[i], ref_colour_unpack(equal[i]));
    }
    colour_error_print(&off);
    assert_true(colour_error_rms(&off) < 1 && off.largest < 6);
}

/* For directions above the horizon too; positions are scaled towards the centre by half the
 * height.  The centre of a cell is up to 1/32 away in u and v, that of a texel, 16 on a
 * face, 1/16 in both.  The colour changes by 100 over a unit, an error of about 9. */
static void a_direction_finds_its_own_sky(void **state)
{
    (void)state;
    colour_error off = { .what = "map of a cube" };

    quick_shade(&lights, TP_ENV_CUBE, TP_LOBE_NONE, &chance);
    for (int n = 0; n < 100000; n++) {
        ref_dir d = sky_direction(&chance);
        d.y = fabs(d.y);
        const double in = 16 * (1 - d.y / 2);
        const int u = (int)floor(-d.x * in) + 16, v = (int)floor(-d.z * in) + 16;
        colour_error_add(&off, lights.quick.sky[v * TP_QUICK_SIDE + u],
                  ref_colour_unpack(quick_smooth(d, NULL)));
    }
    colour_error_print(&off);
    assert_true(colour_error_rms(&off) < 3 && off.largest < 12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_fills_have_the_same_bits),
        cmocka_unit_test(where_a_run_is_cut_does_not_show),
        cmocka_unit_test(it_is_the_sky_that_it_was),
        cmocka_unit_test(faces_of_unequal_size_are_one_sky),
        cmocka_unit_test(a_direction_finds_its_own_sky),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("features/sky_dome_quick", tests, NULL, NULL);
}
