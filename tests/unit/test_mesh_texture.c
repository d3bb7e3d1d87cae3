/* SPDX-License-Identifier: MIT */
/* Textures: sizes, mipmap levels and resampling, in memory of exact size. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include "tests/lib/meshes.h"

static tp_texture make(const uint32_t *pixels, uint32_t w, uint32_t h, void **mem)
{
    const size_t bytes = tp_texture_bytes(w, h);
    assert_true(bytes > 0);
    *mem = malloc(bytes);
    memset(*mem, 0xA5, bytes);
    tp_texture texture;
    assert_int_equal(
        tp_texture_init(&texture, pixels, w, h, *mem, tp_texture_bytes(w, h), NULL),
        TP_OK);
    return texture;
}

static uint32_t channel(uint32_t texel, int shift) { return texel >> shift & 255; }

static void the_bytes_are_those_of_all_levels(void **state)
{
    (void)state;
    assert_int_equal(tp_texture_bytes(1, 1), 4);
    assert_int_equal(tp_texture_bytes(2, 2), 4 * 5);
    assert_int_equal(tp_texture_bytes(3, 1), 4 * (4 + 2 + 1));
    assert_int_equal(tp_texture_bytes(256, 64),
                     4 * (16384 + 4096 + 1024 + 256 + 64 + 16 + 4 + 2 + 1));
    assert_int_equal(tp_texture_bytes(4096, 4095), 4 * 22369621);
}

static void sizes_out_of_range_are_refused(void **state)
{
    (void)state;
    static const uint32_t size[][2] = {
        {0, 1}, {1, 0}, {4097, 1}, {1, 4097}, {65536, 65536}, {0x80000001u, 2},
        {UINT32_MAX, UINT32_MAX} };
    for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
        const uint32_t w = size[i][0], h = size[i][1];
        tp_texture texture;
        tp_error err;
        assert_int_equal(tp_texture_bytes(w, h), 0);
        assert_int_equal(tp_texture_init(&texture, NULL, w, h, NULL, 0, &err),
                         TP_E_TEXTURE);
        assert_int_equal((uint32_t)err.a, w);
        assert_int_equal((uint32_t)err.b, h);
    }
}

static void too_few_bytes_are_refused(void **state)
{
    (void)state;
    const uint32_t pixels[3] = { 1, 2, 3 };
    uint32_t memory[8] = { 0 };
    const size_t bytes = tp_texture_bytes(3, 1);
    tp_texture texture;
    tp_error err;

    assert_int_equal(bytes, 7 * sizeof *memory);
    assert_int_equal(tp_texture_init(&texture, pixels, 3, 1, memory, bytes - 1, &err),
                     TP_E_NOSPACE);
    assert_int_equal(err.a, bytes);
    assert_int_equal(err.b, bytes - 1);
    assert_int_equal(memory[0], 0);
    assert_int_equal(tp_texture_init(&texture, pixels, 3, 1, memory, bytes, &err), TP_OK);
}

static void a_picture_of_right_size_is_copied(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    uint32_t pixels[8 * 4];
    for (int i = 0; i < 32; i++)
        pixels[i] = next_random(&random);
    void *mem;
    const tp_texture t = make(pixels, 8, 4, &mem);
    assert_int_equal(t.log2_w, 3);
    assert_int_equal(t.log2_h, 2);
    assert_int_equal(t.levels, 4);
    assert_memory_equal(t.level[0], pixels, sizeof pixels);
    free(mem);
}

static void a_level_is_the_rounded_mean_of_the_one_before(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    static const uint32_t size[][2] = { {16, 16}, {32, 4}, {1, 8}, {8, 1}, {2, 2},
                                        {1, 1} };
    for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
        uint32_t pixels[256], w = size[i][0], h = size[i][1];
        for (uint32_t k = 0; k < w * h; k++)
            pixels[k] = next_random(&random) | 0xff00ff00u * (next_random(&random) & 1);
        void *mem;
        const tp_texture t = make(pixels, w, h, &mem);
        for (uint32_t level = 1; level < t.levels; level++) {
            const uint32_t *const from = t.level[level - 1];
            const uint32_t half_w = w > 1 ? w / 2 : 1, half_h = h > 1 ? h / 2 : 1;
            for (uint32_t k = 0; k < half_w * half_h; k++) {
                const uint32_t x = k % half_w * w / half_w, y = k / half_w * h / half_h;
                const uint32_t x2 = w > 1 ? x + 1 : x, y2 = h > 1 ? y + 1 : y;
                for (int shift = 0; shift < 32; shift += 8) {
                    const uint32_t sum = channel(from[y * w + x], shift)
                        + channel(from[y * w + x2], shift)
                        + channel(from[y2 * w + x], shift)
                        + channel(from[y2 * w + x2], shift);
                    assert_int_equal(channel(t.level[level][k], shift), (sum + 2) / 4);
                }
            }
            w = half_w;
            h = half_h;
        }
        assert_int_equal(w * h, 1);
        free(mem);
    }
}

/* One channel of the repeating texture at (x, y) in pixels, pixel centres at 1/2,
 * bilinear. */
static double sample(const uint32_t *pixels, int w, int h, double x, double y, int shift)
{
    const double at_x = x - 0.5, at_y = y - 0.5;
    const int x0 = (int)floor(at_x), y0 = (int)floor(at_y);
    double sum = 0;
    for (int k = 0; k < 4; k++) {
        const int px = (x0 + (k & 1) + w) % w, py = (y0 + (k >> 1) + h) % h;
        sum += (1 - fabs(at_x - (x0 + (k & 1)))) * (1 - fabs(at_y - (y0 + (k >> 1))))
             * channel(pixels[py * w + px], shift);
    }
    return sum;
}

static void other_sizes_are_resampled_to_the_next_above(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    static const int size[][2] = { {3, 5}, {5, 4}, {7, 1}, {1, 3}, {33, 12}, {6, 17} };
    double worst = 0;
    for (size_t i = 0; i < sizeof size / sizeof *size; i++) {
        const int w = size[i][0], h = size[i][1];
        uint32_t pixels[33 * 12];
        for (int k = 0; k < w * h; k++)
            pixels[k] = next_random(&random);
        void *mem;
        const tp_texture t = make(pixels, (uint32_t)w, (uint32_t)h, &mem);
        const int w2 = 1 << t.log2_w, h2 = 1 << t.log2_h;
        assert_true(w2 >= w && w2 < 2 * w && h2 >= h && h2 < 2 * h);
        for (int k = 0; k < w2 * h2; k++)
            for (int shift = 0; shift < 32; shift += 8) {
                const double want = sample(pixels, w, h, (k % w2 + 0.5) * w / w2,
                                           (k / w2 + 0.5) * h / h2, shift);
                worst = fmax(worst, fabs(channel(t.level[0][k], shift) - want));
            }
        free(mem);
    }
    /* Rounding, and positions truncated to 1/256 pixel along both axes. */
    assert_true(worst <= 0.5 + 2 * 255 / 256.);
}

static void the_largest_picture_keeps_an_even_colour(void **state)
{
    (void)state;
    enum { W = 4095, H = 2049 };
    uint32_t *const pixels = malloc(W * H * sizeof *pixels);
    for (size_t i = 0; i < W * H; i++)
        pixels[i] = 0xff3c7f01;
    void *mem;
    const tp_texture t = make(pixels, W, H, &mem);
    assert_int_equal(t.levels, TP_TEXTURE_LEVELS);
    for (uint32_t level = 0; level < t.levels; level++) {
        const size_t texels = (size_t)(level < 12 ? 1 << (12 - level) : 1)
                            * (size_t)(level < 12 ? 1 << (12 - level) : 1);
        for (size_t i = 0; i < texels; i += level < 3 ? 61 : 1)
            assert_true(t.level[level][i] == 0xff3c7f01);
    }
    free(mem);
    free(pixels);
}

int main(void)
{
    static uint64_t seed;
    seed = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_bytes_are_those_of_all_levels),
        cmocka_unit_test(sizes_out_of_range_are_refused),
        cmocka_unit_test(too_few_bytes_are_refused),
        cmocka_unit_test_prestate(a_picture_of_right_size_is_copied, &seed),
        cmocka_unit_test_prestate(a_level_is_the_rounded_mean_of_the_one_before, &seed),
        cmocka_unit_test_prestate(other_sizes_are_resampled_to_the_next_above, &seed),
        cmocka_unit_test(the_largest_picture_keeps_an_even_colour),
    };
    return cmocka_run_group_tests_name("mesh/texture", tests, NULL, NULL);
}
