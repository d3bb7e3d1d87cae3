/* SPDX-License-Identifier: MIT */
/* Depth, texture coordinates and normals inside triangles, compared with the exact plane
 * and the exact perspective of the same corners in double precision. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/triangle.h"
#include "tests/lib/measure.h"
#include "tests/lib/random.h"
#include "raster/tri_begin.h"
#include "tests/lib/frames.h"

enum { WIDTH = 256, HEIGHT = 160 };

static uint64_t chance;

typedef struct {
    tp_screen_vertex corner[3];
    const tp_screen_vertex *at[3];
    bool      perspective;      /* decided as the rasterizer does */
    double    length;           /* longest side along an axis, 28.4 */
    double    thinness;         /* length^2 over twice the area */
    double    low, high;        /* zi */
} drawn_face;

/* False for a triangle without area, or too thin: then its values are those of the upper
 * corner. */
static bool face_of(drawn_face *f, const tp_gbuffer *tile)
{
    tp_tri tri;
    const tp_screen_vertex *c = f->corner;
    const double area = (double)llabs(tp_tri_twice_area(&c[0], &c[1], &c[2]));

    f->length = 1;
    f->low = f->high = c[0].zi;
    for (int i = 0; i < 3; i++) {
        f->at[i] = &c[i];
        f->length = fmax(f->length, abs(c[i].u - c[(i + 1) % 3].u));
        f->length = fmax(f->length, abs(c[i].v - c[(i + 1) % 3].v));
        f->low = fmin(f->low, c[i].zi);
        f->high = fmax(f->high, c[i].zi);
    }
    f->thinness = f->length * f->length / area;
    if (f->thinness > 65536 || !tp_tri_begin(&tri, tile, &c[0], &c[1], &c[2]))
        return false;
    f->perspective = tri.perspective;
    return true;
}

static tp_screen_vertex corner_within(int32_t far)
{
    return (tp_screen_vertex){ .u = WIDTH * 8 + chance_int(&chance, -far, far),
                               .v = HEIGHT * 8 + chance_int(&chance, -far, far) };
}

/* Error bound of a value with this `range`, far from its corner: the gradients'
 * factors, see set_gradient_factors(), and the truncation of each gradient by one unit
 * of its last place per pixel. */
static double plane_error(const drawn_face *f, double range, double unit)
{
    return 5 / 134217728.0 * range * f->thinness + unit * (2 + f->length / 8);
}

typedef void compare(const drawn_face *f, const test_tile *tile, int32_t x, int32_t y,
                     measure *m);

static void compare_all(const drawn_face *f, compare *at, measure *m)
{
    test_tile tile = tile_of(0, 0, WIDTH, HEIGHT, 0);

    tp_tri_water(&tile.samples, &f->corner[0], &f->corner[1], &f->corner[2]);
    for (int32_t y = 0; y < HEIGHT; y++) {
        for (int32_t x = 0; x < WIDTH; x++) {
            if (tile.samples.key[tile_at(&tile, x, y)])
                at(f, &tile, x, y, m);
        }
    }
    tile_free(&tile);
}

/* -- depth --------------------------------------------------------------------------- */

static void compare_depth(const drawn_face *f, const test_tile *tile, int32_t x, int32_t y,
                          measure *m)
{
    const uint32_t key = tile->samples.key[tile_at(tile, x, y)];
    const double want = ref_sample_at(f->at, x, y).zi;
    const double error = fabs(TP_ZI(key) - want);

    /* The key drops 7 bits of Q1.31. */
    assert_true(error <= 128 + plane_error(f, f->high - f->low, 1));
    measure_add(m, error / 128, x, y, (int64_t)want);
}

static void depth_lies_in_the_plane_of_the_corners(void **state)
{
    (void)state;
    measure error[3] = { { .what = "depth, 200 px", .unit = "of 2^24" },
                         { .what = "depth, 1000 px", .unit = "of 2^24" },
                         { .what = "depth, 8000 px", .unit = "of 2^24" } };
    static const int32_t fars[3] = { 1600, 8000, 8192 * 16 };

    for (int n = 0; n < random_rounds(450, 120); n++) {
        drawn_face f;
        for (int i = 0; i < 3; i++) {
            f.corner[i] = corner_within(fars[n % 3]);
            f.corner[i].zi = (uint32_t)chance_scale(&chance, 2, 32600);
        }
        const test_tile tile = { .samples = { .x1 = WIDTH, .y1 = HEIGHT } };
        if (face_of(&f, &tile.samples))
            compare_all(&f, compare_depth, &error[n % 3]);
    }
    for (int i = 0; i < 3; i++)
        measure_print(&error[i]);
}

/* A triangle with the third corner within an LSB or two of the line between the others. */
static void make_sliver(tp_screen_vertex c[3], int32_t far)
{
    const double way = chance_double(&chance, 0, 1);

    c[0] = corner_within(far);
    c[1] = corner_within(far);
    c[2].u =
        (int32_t)lround(c[0].u + way * (c[1].u - c[0].u)) + chance_int(&chance, -2, 2);
    c[2].v =
        (int32_t)lround(c[0].v + way * (c[1].v - c[0].v)) + chance_int(&chance, -2, 2);
}

/* A sliver that contains the centre of at least one pixel: an edge runs through the centre,
 * to whole coordinates on both sides, and the third corner is next to an end. */
static void make_sliver_through_centre(tp_screen_vertex c[3], int32_t far)
{
    const int32_t du = chance_int(&chance, -far / 8, far / 8);
    const int32_t dv =
        chance_int(&chance, -far / 8, far / 8) / (1 << chance_int(&chance, 0, 14));
    const int32_t u = 16 * chance_int(&chance, 0, WIDTH - 1) + 8;
    const int32_t v = 16 * chance_int(&chance, 0, HEIGHT - 1) + 8;
    const int32_t one = chance_int(&chance, 1, 6), two = chance_int(&chance, 1, 6);

    c[0].u = u - one * du;
    c[0].v = v - one * dv;
    c[1].u = u + two * du;
    c[1].v = v + two * dv;
    c[2].u = c[0].u + chance_int(&chance, -2, 2);
    c[2].v = c[0].v + chance_int(&chance, -2, 2);
}

/* Slivers of all kinds: no depth is nearer than the nearest corner or farther than the
 * farthest corner, except for 1/256 of the range, the allowance of projection.h for
 * rounding. */
static void no_sliver_leaves_the_depths_of_its_corners(void **state)
{
    (void)state;
    static const int32_t fars[3] = { 400, 8000, 8192 * 16 };
    test_tile tile = tile_of(0, 0, WIDTH, HEIGHT, 0);
    uint64_t pixels = 0;

    const int count = random_rounds(5000, 1000);
    for (int n = 0; n < count; n++) {
        tp_screen_vertex c[3] = { { .s = 0 } };
        int64_t low = INT32_MAX, high = 0;
        if (n & 1)
            make_sliver(c, fars[n % 3]);
        else
            make_sliver_through_centre(c, fars[n % 3]);
        for (int i = 0; i < 3; i++) {
            c[i].zi = (1u << 23) + random_below(&chance, 0x7f000000);
            low = c[i].zi < low ? c[i].zi : low;
            high = c[i].zi > high ? c[i].zi : high;
        }
        tp_gbuffer_clear(&tile.samples);
        tp_tri_water(&tile.samples, &c[0], &c[1], &c[2]);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            const uint32_t key = tile.samples.key[i];
            if (key == 0)
                continue;
            pixels++;
            assert_true(TP_ZI(key) <= high + (1 << 23) && TP_ZI(key) >= low - (1 << 23));
        }
    }
    printf("    %" PRIu64 " pixels of slivers\n", pixels);
    assert_true(pixels > (uint64_t)count);
    tile_free(&tile);
}

/* -- texture coordinates ------------------------------------------------------------- */

/* Ratio of the depths over the 16 pixels that contain x. */
static double ratio_at(const drawn_face *f, int32_t x, int32_t y)
{
    const double a = ref_sample_at(f->at, x & ~15, y).zi;
    const double b = ref_sample_at(f->at, (x & ~15) + 16, y).zi;
    const double low = fmax(f->low, fmin(a, b)), high = fmin(f->high, fmax(a, b));
    return high / low;
}

/* Measures the distance in pixels between (x, y) and the point where the reference has the
 * drawn value. */
static void compare_places(const drawn_face *f, const test_tile *tile, int32_t x, int32_t y,
                           measure *m)
{
    const size_t i = tile_at(tile, x, y);
    const ref_sample at = ref_sample_at(f->at, x, y);
    const ref_sample right = ref_sample_at(f->at, x + 1, y);
    const ref_sample below = ref_sample_at(f->at, x, y + 1);
    const double per_s = hypot(right.s - at.s, below.s - at.s);
    const double per_t = hypot(right.t - at.t, below.t - at.t);
    const double off_s = fabs((int32_t)tile->samples.s[i] - at.s);
    const double off_t = fabs((int32_t)tile->samples.t[i] - at.t);
    const double ratio = ratio_at(f, x, y), extent = f->high / f->low;
    double range = 0;

    for (int k = 0; k < 3; k++)
        range = fmax(range, fmax(fabs((double)f->corner[k].s - f->at[0]->s),
                                 fabs((double)f->corner[k].t - f->at[0]->t)));
    /* Exact every 16 pixels: a straight line over a depth ratio r deviates from the true
     * course by at most (r - 1) / 4 of its length, where pixels differ by r; and a 16th of
     * the length is known to 5e-5.  An affine triangle has r - 1 < 1 / its size, so it
     * deviates by a quarter of a pixel in each of two directions. */
    const double pixels = f->perspective ? 16 * ((ratio - 1) / 4 + 5e-5) * ratio : 0.5;
    /* 16 steps with a truncation of one unit each; 1/w s w with w of 29 bits in the nearest
     * corner. */
    const double units = 16 + range * extent / 67108864.0
                       + plane_error(f, range * extent,
                                     f->perspective ? extent / 256 : 1);
    assert_true(off_s <= pixels * per_s + units);
    assert_true(off_t <= pixels * per_t + units);
    if (per_s > 64 && per_t > 64)
        measure_add(m, fmax(off_s / per_s, off_t / per_t), x, y,
                    (int64_t)(1000 * extent));
}

static void places_follow_the_perspective(void **state)
{
    (void)state;
    static const double ratios[] = { 1.001, 1.1, 4, 30, 1000 };
    static const char *const names[] = { "w 1:1.001", "w 1:1.1", "w 1:4", "w 1:30",
                                         "w 1:1000" };

    for (int k = 0; k < 5; k++) {
        measure error = { .what = names[k], .unit = "px" };
        for (int n = 0; n < random_rounds(100, 30); n++) {
            drawn_face f;
            for (int i = 0; i < 3; i++) {
                const double depth = chance_double(&chance, 1, ratios[k]);
                f.corner[i] = corner_within(n % 2 ? 600 : 4000);
                f.corner[i].zi = (uint32_t)lround(0x7f7fffff / depth);
                f.corner[i].s = chance_fx(&chance, -100, 100);
                f.corner[i].t = chance_fx(&chance, -100, 100);
            }
            const test_tile tile = { .samples = { .x1 = WIDTH, .y1 = HEIGHT } };
            if (face_of(&f, &tile.samples))
                compare_all(&f, compare_places, &error);
        }
        measure_print(&error);
    }
}

/* -- normals ------------------------------------------------------------------------- */

static void compare_normals(const drawn_face *f, const test_tile *tile, int32_t x,
                            int32_t y, measure *m)
{
    const uint32_t n = tile->samples.n[tile_at(tile, x, y)];
    const ref_sample want = ref_sample_at(f->at, x, y);
    /* Truncated to a whole unit, with 16 more bits in between. */
    const double most = 1 + plane_error(f, 65454, 1 / 65536.0);
    const double off_x = fabs((int16_t)(n >> 16) + 0.5 - want.n[0]) - 0.5;
    const double off_z = fabs((int16_t)(n & 0xffff) + 0.5 - want.n[1]) - 0.5;

    assert_true(off_x <= most - 1 && off_z <= most - 1);
    measure_add(m, fmax(fmax(off_x, off_z), 0), x, y, 0);
}

static void slopes_are_linear_between_corners(void **state)
{
    (void)state;
    measure error = { .what = "slopes beyond cut", .unit = "of 1/4096" };

    for (int n = 0; n < random_rounds(200, 60); n++) {
        drawn_face f;
        for (int i = 0; i < 3; i++) {
            f.corner[i] = corner_within(n % 2 ? 4000 : 8192 * 16);
            f.corner[i].zi = 1u << 30;
            for (int k = 0; k < 2; k++)
                f.corner[i].n[k] = (int16_t)chance_int(&chance, -32727, 32727);
        }
        const test_tile tile = { .samples = { .x1 = WIDTH, .y1 = HEIGHT } };
        if (face_of(&f, &tile.samples))
            compare_all(&f, compare_normals, &error);
    }
    measure_print(&error);
}

static int32_t part(uint32_t n, int k)
{
    return (int32_t)((n >> 10 * k & 1023) ^ 512) - 512;
}

/* Solids pack three components of 10 bits, and s and t into 16 bits each, which wrap. */
static void solids_carry_normal_texture_and_face(void **state)
{
    (void)state;
    for (int n = 0; n < random_rounds(100, 30); n++) {
        drawn_face f;
        for (int i = 0; i < 3; i++) {
            f.corner[i] = corner_within(3000);
            f.corner[i].zi = 1u << 30;
            f.corner[i].s = chance_fx(&chance, -40, 40);
            f.corner[i].t = chance_fx(&chance, -40, 40);
            for (int k = 0; k < 3; k++)
                f.corner[i].n[k] = (int16_t)chance_int(&chance, -511, 511);
        }
        test_tile tile = tile_of(0, 0, WIDTH, HEIGHT, 0);
        const tp_gbuffer *s = &tile.samples;
        const tp_screen_vertex *c = f.corner;
        tp_tri_solid(s, &c[0], &c[1], &c[2], TP_MARK_SOLID + 3, 0x12345678, 16);
        const bool thick = face_of(&f, s);
        for (int32_t i = 0; thick && i < WIDTH * HEIGHT; i++) {
            if (s->key[i] == 0)
                continue;
            const ref_sample want = ref_sample_at(f.at, i % WIDTH, i / WIDTH);
            const double most = 4 + plane_error(&f, 80 * 65536, 1);
            assert_int_equal(TP_MARK(s->key[i]), TP_MARK_SOLID + 3);
            assert_int_equal(s->t[i], 0x12345678);
            assert_true(fabs(remainder((s->s[i] >> 16) - want.s, 65536)) <= most);
            assert_true(fabs(remainder((s->s[i] & 0xffff) - want.t, 65536)) <= most);
            for (int k = 0; k < 3; k++)
                assert_true(fabs(part(s->n[i], k) + 0.5 - want.n[k])
                            <= 0.5 + plane_error(&f, 1022, 1 / 4194304.0));
        }
        tile_free(&tile);
    }
}

/* -- any input ----------------------------------------------------------------------- */

/* Triangles as thin as they can be without being slivers have the smallest exponents. */
static void planes_have_room_for_their_bits(void **state)
{
    (void)state;
    test_tile tile = tile_of(0, 0, WIDTH, HEIGHT, 0);
    int least = 62, drawn = 0;

    for (int32_t side = 8; side < 4096; side++)
        for (int32_t area = 1; area <= 5; area++) {
            const tp_screen_vertex c[3] = {
                { .u = 8, .v = 8, .zi = 1 },
                { .u = 8 + area, .v = 8 + area, .zi = 1 },
                { .u = 8 + side + 1, .v = 8 + side, .zi = 1 },
            };
            tp_tri tri;
            if (!tp_tri_begin(&tri, &tile.samples, &c[0], &c[1], &c[2])
                || (tri.cx1 == 0 && tri.cx2 == 0))
                continue;
            least = tri.shift < least ? tri.shift : least;
            drawn++;
        }
    assert_in_range(drawn, 1000, 30000);
    assert_in_range(least, TP_LEAST_SHIFT, TP_LEAST_SHIFT + 1);
    tile_free(&tile);
}

/* Any corners within the guard band: defined behaviour, as UBSan sees it, and no access
 * outside the tile, as ASan sees it. */
static void any_corners_are_safe(void **state)
{
    (void)state;
    test_tile tile = tile_of(1000, 500, 1064, 516, 0);
    static const int32_t ends[] = { -8192 * 16, 8192 * 16, 0, 16000, 8000, 7999, 16001 };

    for (int n = 0; n < random_rounds(30000, 10000); n++) {
        tp_screen_vertex c[3];
        for (int i = 0; i < 3; i++) {
            c[i].u =
                2048 * 16 + ends[random_below(&chance, 7)] + chance_int(&chance, -3, 3);
            c[i].v =
                2048 * 16 + ends[random_below(&chance, 7)] + chance_int(&chance, -3, 3);
            c[i].zi = random_below(&chance, n % 2 ? 0x7f800000 : 100000);
            c[i].s = chance_int(&chance, 1 - (1 << 30), (1 << 30) - 1);
            c[i].t = random_below(&chance, 2) ? (1 << 30) - 1 : 1 - (1 << 30);
            for (int k = 0; k < 3; k++)
                c[i].n[k] = (int16_t)chance_int(&chance, -511, 511);
        }
        if (n % 3 == 0)
            tp_gbuffer_clear(&tile.samples);
        if (n % 4)
            tp_tri_water(&tile.samples, &c[0], &c[1], &c[2]);
        else
            tp_tri_solid(&tile.samples, &c[0], &c[1], &c[2], TP_MARK_SOLID, 1, 16);
    }
    tile_free(&tile);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_lies_in_the_plane_of_the_corners),
        cmocka_unit_test(no_sliver_leaves_the_depths_of_its_corners),
        cmocka_unit_test(places_follow_the_perspective),
        cmocka_unit_test(slopes_are_linear_between_corners),
        cmocka_unit_test(solids_carry_normal_texture_and_face),
        cmocka_unit_test(planes_have_room_for_their_bits),
        cmocka_unit_test(any_corners_are_safe),
    };
    return cmocka_run_group_tests_name("raster/attributes", tests, NULL, NULL);
}
