/* SPDX-License-Identifier: MIT */
/* Comparison of a picture with another rung's and with the reference renderer's, for one
 * world. */
#define _POSIX_C_SOURCE 200809L
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <cmocka.h>
#include "../../ports/app/session/compare.h"
#include "../../ports/app/session/image_diff.h"
#include "../../ports/app/files/timing.h"

#define SEA   "assets/scenes/three-swells.ini"
#define POND  "assets/scenes/pond.ini"

/* Settings of "exact", as compare sets them. */
static const char *exact[] = { "quality.visibility=triangles", "quality.shading=exact",
                               "quality.rate=full",
                               "quality.error_px=0", "quality.error_colour=0" };
static const char *quick[] = { "quality.shading=quick", "quality.rate=colour",
                               "mirror.method=none", "foam.cells=0", "hdr.share=0" };

typedef struct {
    loaded_scene    loaded;
    options  options;
    comparison *compare;
} bench;

static void open_with(bench *b, const char *scene, uint32_t width, uint32_t height,
                      const char **settings, uint32_t n)
{
    *b = (bench){ .options = { .command = "test", .scene = scene, .width = width,
                               .height = height, .threads = 1, .settings = settings,
                               .n_settings = n } };
    assert_int_equal(loaded_scene_open(&b->loaded, &b->options), 0);
    b->compare = compare_begin();
    assert_non_null(b->compare);
    for (int i = 0; i < 20; i++)
        tp_world_step(&tp_program_all, b->loaded.world, &b->loaded.file.scene, NULL);
}

static const picture *draw(bench *b)
{
    frame_renderer_draw(&b->loaded.renderer, b->loaded.world);
    return compare_draw(b->compare, &b->loaded);
}

static void finish(bench *b)
{
    compare_end(b->compare);
    loaded_scene_close(&b->loaded);
}

static uint32_t pixel(const picture *p, uint32_t x, uint32_t y)
{
    uint32_t row[512];

    assert_true(p->width <= 512);
    picture_expand_row(p, y, row);
    return row[x];
}

/* ------------------------------------------------------------------------------------ */

static void the_number_is_that_of_the_formula(void **state)
{
    const uint32_t a[4] = { 0, 0, 0, 0 }, b[4] = { 0, 0x030000, 0x000400, 0x00000c };
    const uint32_t white[1] = { 0xffffff }, black[1] = { 0 };
    (void)state;
    assert_true(image_diff_psnr(a, a, 4) >= 100);
    assert_float_equal(image_diff_psnr(white, black, 1), 0, 1e-9);
    assert_float_equal(image_diff_psnr(b, a, 4), 36.6432, 1e-3);   /* (9 + 16 + 144) / 12 */
    assert_float_equal(image_diff_psnr(a, b, 4), image_diff_psnr(b, a, 4), 0);
}

static void a_difference_is_eightfold_and_held(void **state)
{
    const uint32_t a[16] = { 0x102030, 0x00ff80 }, b[16] = { 0x112030, 0xff0081 };
    uint32_t rows[16];
    picture to = { TP_FORMAT_XRGB8888, 16, 1, 64, (uint8_t *)rows };
    (void)state;
    image_diff_draw(&to, a, b);
    assert_int_equal(rows[0], 0x788080);
    assert_int_equal(rows[1], 0x00ff78);
    assert_int_equal(rows[2], 0x808080);
}

static void nothing_is_shown_when_it_is_off(void **state)
{
    bench b;
    (void)state;
    open_with(&b, SEA, 64, 48, NULL, 0);
    assert_null(draw(&b));
    assert_int_equal(compare_get_how(b.compare), COMPARE_OFF);
    assert_true(compare_psnr(b.compare) < 0);
    assert_string_equal(compare_note(b.compare), "");
    finish(&b);
}

static void the_same_rung_has_the_same_bits(void **state)
{
    bench b;
    (void)state;
    open_with(&b, SEA, 160, 120, exact, 5);
    compare_set(b.compare, COMPARE_DIFFERENCE, AGAINST_EXACT);
    const picture *p = draw(&b);
    assert_non_null(p);
    assert_int_equal(p->format, TP_FORMAT_XRGB8888);
    assert_true(p->width == 160 && p->height == 120);
    assert_true(compare_psnr(b.compare) >= 100);
    for (uint32_t y = 0; y < 120; y++)
        for (uint32_t x = 0; x < 160; x++)
            assert_int_equal(pixel(p, x, y), 0x808080);
    finish(&b);
}

/* The note says if the loaded scene draws by the compared rungs already, and only then. */
static void what_is_drawn_so_anyway_is_told(void **state)
{
    bench b;
    (void)state;
    open_with(&b, SEA, 64, 48, exact, 5);
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_EXACT);
    assert_non_null(draw(&b));
    assert_string_equal(compare_note(b.compare),
                        "the scene is drawn with this method: nothing to compare");
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_QUICK);
    assert_non_null(draw(&b));
    assert_null(strstr(compare_note(b.compare), "nothing to compare"));
    b.options.format = TP_FORMAT_RGB565;        /* fewer colours */
    assert_int_equal(loaded_scene_open_renderer(&b.loaded, &b.options), 0);
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_EXACT);
    assert_non_null(draw(&b));
    assert_string_equal(compare_note(b.compare), "");
    assert_int_equal(compare_usual(&b.loaded), AGAINST_EXACT);
    finish(&b);
}

/* For every quality plan the usual comparison uses other rungs than the plan. */
static void the_usual_other_picture_is_another(void **state)
{
    static const char *quick_sea[] = { "quality.shading=quick", "mirror.method=none",
                                       "foam.cells=0", "hdr.share=0" };
    static const char *plain_sea[] = { "quality.shading=exact", "mirror.method=none",
                                       "quality.visibility=triangles",
                                       "foam.cells=0", "hdr.share=0",
                                       "quality.error_colour=0" };
    static const char *cube_sea[] = { "quality.shading=exact", "mirror.method=cube",
                                      "quality.visibility=triangles",
                                      "quality.error_colour=0" };
    bench b;
    (void)state;
    open_with(&b, SEA, 64, 48, cube_sea, 4);    /* its mirror disables fast shading */
    assert_int_equal(compare_usual(&b.loaded), AGAINST_REFERENCE);
    finish(&b);
    open_with(&b, SEA, 64, 48, plain_sea, 6);
    assert_int_equal(compare_usual(&b.loaded), AGAINST_QUICK);
    compare_set(b.compare, COMPARE_SPLIT, compare_usual(&b.loaded));
    assert_non_null(draw(&b));
    assert_true(compare_psnr(b.compare) < 100);
    finish(&b);
    open_with(&b, SEA, 64, 48, quick_sea, 4);
    assert_int_equal(compare_usual(&b.loaded), AGAINST_EXACT);
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_EXACT);
    assert_non_null(draw(&b));
    assert_true(compare_psnr(b.compare) < 100);
    finish(&b);
}

static void another_rung_is_off_by_little(void **state)
{
    bench b;
    (void)state;
    open_with(&b, SEA, 160, 120, quick, 5);
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_EXACT);
    assert_non_null(draw(&b));
    assert_in_range((int)compare_psnr(b.compare), 20, 59);
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_COLOUR);
    assert_non_null(draw(&b));
    assert_true(compare_psnr(b.compare) > 40);          /* differs by culled waves only */
    finish(&b);
}

static void the_halves_are_those_of_both(void **state)
{
    bench b, other;
    (void)state;
    open_with(&b, SEA, 160, 120, quick, 5);
    open_with(&other, SEA, 160, 120, quick, 5);
    for (int i = 0; i < 5; i++)
        assert_int_equal(scene_file_set(&other.loaded.file, exact[i]), 0);
    assert_int_equal(loaded_scene_open_renderer(&other.loaded, &other.options), 0);
    frame_renderer_draw(&other.loaded.renderer, other.loaded.world);
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_EXACT);
    const picture *p = draw(&b), *ours = &b.loaded.renderer.picture;
    const picture *theirs = &other.loaded.renderer.picture;
    uint32_t differ = 0;
    for (uint32_t y = 0; y < 120; y++) {
        for (uint32_t x = 0; x < 160; x++) {
            const picture *whose = x < 80 ? ours : theirs;
            if (x != 79 && x != 80)
                assert_int_equal(pixel(p, x, y), pixel(whose, x, y));
            differ += pixel(ours, x, y) != pixel(theirs, x, y);
        }
        assert_true(pixel(p, 79, y) == 0 && pixel(p, 80, y) == 0xffffff);
    }
    assert_true(differ > 1000);
    finish(&other);
    finish(&b);
}

static void a_format_costs_what_it_costs(void **state)
{
    bench b;
    double psnr[2];
    (void)state;
    open_with(&b, SEA, 160, 120, exact, 5);
    compare_set(b.compare, COMPARE_DIFFERENCE, AGAINST_EXACT);
    for (int i = 0; i < 2; i++) {
        b.options.format = i ? TP_FORMAT_I1 : TP_FORMAT_RGB565;
        assert_int_equal(loaded_scene_open_renderer(&b.loaded, &b.options), 0);
        assert_non_null(draw(&b));
        psnr[i] = compare_psnr(b.compare);
    }
    assert_in_range((int)psnr[0], 35, 50);
    assert_in_range((int)psnr[1], 3, 15);
    finish(&b);
}

static void it_follows_values_and_sizes(void **state)
{
    bench b;
    (void)state;
    open_with(&b, SEA, 96, 64, exact, 5);
    compare_set(b.compare, COMPARE_DIFFERENCE, AGAINST_EXACT);
    assert_non_null(draw(&b));
    assert_int_equal(scene_file_set(&b.loaded.file, "water.colour=#ff0000"), 0);
    assert_non_null(draw(&b));
    assert_true(compare_psnr(b.compare) >= 100);
    b.options.width = 128;
    assert_int_equal(loaded_scene_open_renderer(&b.loaded, &b.options), 0);
    const picture *p = draw(&b);
    assert_true(p && p->width == 128 && compare_psnr(b.compare) >= 100);
    finish(&b);
}

static void what_a_scene_cannot_have_is_told(void **state)
{
    bench b;
    (void)state;
    open_with(&b, POND, 96, 64, exact, 5);
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_PROJECTED);
    assert_non_null(draw(&b));
    assert_non_null(strstr(compare_note(b.compare), "not for this scene"));
    assert_true(compare_psnr(b.compare) >= 100);        /* triangles are drawn already */
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_TRIANGLES);
    assert_non_null(draw(&b));
    assert_non_null(strstr(compare_note(b.compare), "nothing to compare"));
    assert_true(compare_psnr(b.compare) >= 100);
    finish(&b);
}

/* -- the reference -------------------------------------------------------------------- */

static void rest(void)
{
    const struct timespec some = { 0, 2000000 };

    nanosleep(&some, NULL);
}

/* Waits for the next picture of the reference. */
static const picture *wait_for(bench *b)
{
    const uint64_t begin = now_us();

    while (!compare_moves(b->compare) && now_us() - begin < 60000000u)
        rest();
    return draw(b);
}

/* Waits for a picture with a sample in every pixel. */
static const picture *wait_for_all(bench *b)
{
    const picture *p = wait_for(b);

    while (compare_psnr(b->compare) < 0)
        p = wait_for(b);
    return p;
}

static void the_reference_comes_with_ever_more_samples(void **state)
{
    const char *last = "16 samples";
    bench b;
    (void)state;
    open_with(&b, SEA, 64, 48, NULL, 0);
    compare_set(b.compare, COMPARE_DIFFERENCE, AGAINST_REFERENCE);
    assert_null(draw(&b));
    assert_true(compare_psnr(b.compare) < 0);
    assert_non_null(strstr(compare_note(b.compare), "drawing the reference"));
    assert_non_null(wait_for(&b));
    assert_true(compare_psnr(b.compare) < 0             /* coarse, if drawn yet */
                || !strstr(compare_note(b.compare), "16 pixels"));
    assert_non_null(wait_for_all(&b));
    while (strncmp(compare_note(b.compare), last, strlen(last)) != 0) {
        assert_in_range((int)compare_psnr(b.compare), 20, 50);
        assert_non_null(wait_for(&b));
    }
    assert_int_equal(strncmp(compare_note(b.compare), last, strlen(last)), 0);
    assert_string_equal(compare_note(b.compare), "16 samples per pixel");
    assert_false(compare_moves(b.compare));
    finish(&b);
}

/* The world changes during the reference: the compared pair is of the old world. */
static void the_pair_is_of_one_world(void **state)
{
    bench b;
    (void)state;
    open_with(&b, SEA, 64, 48, NULL, 0);
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_REFERENCE);
    assert_null(draw(&b));
    uint32_t first[48];
    for (uint32_t y = 0; y < 48; y++)
        first[y] = pixel(&b.loaded.renderer.picture, 7, y);
    for (int i = 0; i < 30; i++)
        tp_world_step(&tp_program_all, b.loaded.world, &b.loaded.file.scene, NULL);
    const picture *p = wait_for_all(&b);
    uint32_t moved = 0;
    for (uint32_t y = 0; y < 48; y++) {
        assert_int_equal(pixel(p, 7, y), first[y]);
        moved += pixel(&b.loaded.renderer.picture, 7, y) != first[y];
    }
    assert_true(moved > 4);
    p = wait_for(&b);                                   /* then the pair of the new world */
    for (uint32_t y = 0; y < 48; y++)
        assert_int_equal(pixel(p, 7, y), pixel(&b.loaded.renderer.picture, 7, y));
    finish(&b);
}

static void it_is_given_up_at_once(void **state)
{
    bench b;
    uint64_t begin;
    (void)state;
    open_with(&b, SEA, 512, 384, NULL, 0);
    compare_set(b.compare, COMPARE_SPLIT, AGAINST_REFERENCE);
    for (int i = 0; i < 3; i++) {
        assert_null(draw(&b));
        for (int k = 0; k < 20; k++)
            rest();
        begin = now_us();
        if (i == 0)
            compare_forget(b.compare);
        else if (i == 1)
            compare_set(b.compare, COMPARE_SPLIT, AGAINST_EXACT);
        else
            compare_end(b.compare);
        assert_true(now_us() - begin < 1000000u);
        if (i == 1)
            compare_set(b.compare, COMPARE_SPLIT, AGAINST_REFERENCE);
    }
    loaded_scene_close(&b.loaded);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_number_is_that_of_the_formula),
        cmocka_unit_test(a_difference_is_eightfold_and_held),
        cmocka_unit_test(nothing_is_shown_when_it_is_off),
        cmocka_unit_test(the_same_rung_has_the_same_bits),
        cmocka_unit_test(what_is_drawn_so_anyway_is_told),
        cmocka_unit_test(the_usual_other_picture_is_another),
        cmocka_unit_test(another_rung_is_off_by_little),
        cmocka_unit_test(the_halves_are_those_of_both),
        cmocka_unit_test(a_format_costs_what_it_costs),
        cmocka_unit_test(it_follows_values_and_sizes),
        cmocka_unit_test(what_a_scene_cannot_have_is_told),
        cmocka_unit_test(the_reference_comes_with_ever_more_samples),
        cmocka_unit_test(the_pair_is_of_one_world),
        cmocka_unit_test(it_is_given_up_at_once),
    };
    return cmocka_run_group_tests_name("compare", tests, NULL, NULL);
}
