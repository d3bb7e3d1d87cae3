/* SPDX-License-Identifier: MIT */
/* Vertices of a fan in 32 bits: close to those in 64 bits, the same in every part of a row,
 * and the same picture in every tiling. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "tests/lib/fan_rungs.h"

/* Places within 6 / 65536 m, slopes up to 1 within 4 / 4096; measured: 4 and 2. */
static void vertices_are_those_of_64_bits(void **state)
{
    errors e = { 0 };

    (void)state;
    for (int n = 0; n < 60; n++) {
        fan_sea s;
        fan_sea_lay_out(&s, n % 7, &chance);
        for (uint32_t j = 0; j < s.grid.rows; j += 3)
            compare_row(&s, &tp_draw_fast_waves, j, 4096, &e);
        free(s.block);
    }
    printf("  %u vertices, %u steep; places within %d / 65536 m, slopes %d / 4096\n",
           (unsigned)e.count, (unsigned)e.steep, (int)e.place, (int)e.slope);
    assert_true(e.count > 10000 && e.steep < e.count / 4);
    assert_in_range(e.place, 0, 6);
    assert_in_range(e.slope, 0, 4);
}

static void parts_of_a_row_have_the_same_bits(void **state)
{
    (void)state;
    for (int n = 0; n < 30; n++) {
        fan_sea s;
        fan_sea_lay_out(&s, 1 + n % 6, &chance);
        s.grid.waves = &tp_draw_fast_waves;
        check_parts_of_rows(&s);
        free(s.block);
    }
}

/* The pictures with fast waves: rms of the difference from the exact ones below 2 levels. */
static void tiles_change_no_pixel(void **state)
{
    uint64_t sum = 0;

    (void)state;
    for (int n = 0; n < PICTURES; n++) {
        const tp_scene plain = scene_of_swells(n);
        tp_scene scene = plain;
        scene.quality.waves = TP_RUNG_FAST;
        sum += check_tiles(n, &plain, &scene);
    }
    assert_in_range(mean_square(sum), 1, 400);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_are_those_of_64_bits),
        cmocka_unit_test(parts_of_a_row_have_the_same_bits),
        cmocka_unit_test(tiles_change_no_pixel),
    };
    return cmocka_run_group_tests_name("view/fan_fast", tests, NULL, NULL);
}
