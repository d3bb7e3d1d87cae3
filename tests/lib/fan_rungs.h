/* SPDX-License-Identifier: MIT */
/* Fans by cheaper arithmetic, for tests: their vertices against the exact ones, parts of
 * their rows, and their pictures in tiles. */
#ifndef TP_TESTS_LIB_FAN_RUNGS_H
#define TP_TESTS_LIB_FAN_RUNGS_H
#include "tests/lib/fans.h"
#include "tests/lib/frames.h"
#include "tests/lib/picture_difference.h"

enum { WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT, MOST = FAN_MOST, PICTURES = 24 };

static uint64_t chance;

/* -- vertices ------------------------------------------------------------------------ */

typedef struct {
    int32_t  place, slope;      /* largest errors, 1 / 65536 m and 1 / 4096 */
    uint32_t count, steep;      /* steep: vertices without errors of slopes */
    uint64_t squares;           /* of slopes' errors */
    int32_t  share;             /* set by the test: of places' errors in the
                                 * displacement, 1 / 65536 */
} errors;

static inline void add_slope_error(errors *to, int32_t exact, int32_t fast)
{
    const int32_t by = distance(exact, fast);

    raise(&to->slope, by);
    to->squares += (uint64_t)(by * by);
}

/* Raises the errors of row j against the exact vertices: places in view space, slopes up to
 * `steepest`, 1 / 4096. */
static inline void compare_row(fan_sea *s, const struct tp_draw_fast_waves *by, uint32_t j,
                               int32_t steepest, errors *to)
{
    static tp_view_vertex a[MOST], b[MOST];
    static tp_grid_vertex m[MOST], n[MOST];
    const uint32_t cols = s->grid.cols;

    s->grid.waves = NULL;
    tp_fan_make_view_vertices(&s->grid, j, 0, cols, a);
    tp_fan_evaluate_row(&s->grid, j, 0, cols, m);
    s->grid.waves = by;
    tp_fan_make_view_vertices(&s->grid, j, 0, cols, b);
    tp_fan_evaluate_row(&s->grid, j, 0, cols, n);
    for (uint32_t i = 0; i < cols; i++) {
        raise(&to->place, distance(a[i].x, b[i].x));
        raise(&to->place, distance(a[i].y, b[i].y));
        raise(&to->place, distance(a[i].depth, b[i].depth));
        to->count++;
        if (distance(m[i].slope_x, 0) > steepest || distance(m[i].slope_z, 0) > steepest) {
            to->steep++;
            continue;
        }
        add_slope_error(to, m[i].slope_x, n[i].slope_x);
        add_slope_error(to, m[i].slope_z, n[i].slope_z);
    }
}

/* Compares rows evaluated whole and in two parts. */
static inline void check_parts_of_rows(const fan_sea *s)
{
    static tp_grid_vertex whole[MOST], part[MOST];
    const uint32_t cols = s->grid.cols, cut = (uint32_t)chance_int(&chance, 0, (int)cols);

    for (uint32_t j = 0; j < s->grid.rows; j += 7) {
        memset(whole, 0, sizeof whole);
        memset(part, 0, sizeof part);
        tp_fan_evaluate_row(&s->grid, j, 0, cols, whole);
        tp_fan_evaluate_row(&s->grid, j, cut, cols, part);
        tp_fan_evaluate_row(&s->grid, j, 0, cut, part);
        assert_memory_equal(part, whole, sizeof whole);
    }
}

/* -- pictures ------------------------------------------------------------------------ */

/* Draws the scene and returns the renderer. */
static inline tp_visibility draw(const tp_scene *scene, const tp_world *world,
                                 uint32_t wide, uint32_t high, uint32_t *pixels)
{
    const tp_assets none = { 0 };
    const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_width = wide,
                               .tile_height = high, .format = TP_FORMAT_XRGB8888 };
    test_frame f = frame_of(scene, &none, &config);

    frame_draw_picture(&f, world, pixels);
    const tp_visibility visibility = f.frame->visibility;
    frame_free(&f);
    return visibility;
}

/* A scene of swells with renderer and wind by the bits of n. */
static inline tp_scene scene_of_swells(int n)
{
    tp_scene s = scene_plain();

    s.quality.visibility = n & 1 ? TP_VISIBILITY_ROWS : TP_VISIBILITY_TRIANGLES;
    s.wind.strength = n & 2 ? TP_FX(0.2) : 0;
    s.camera.y = chance_fx(&chance, 3, 9);
    s.camera.pitch = chance_fx(&chance, -25, 2);
    s.grid.vertices = chance_int(&chance, 200, 3000);
    return s;
}

/* Draws picture n of a scene whole and in tiles, which must be the same, and returns the
 * sum of the squared differences from the picture of the same scene at exact rungs. */
static inline uint64_t check_tiles(int n, const tp_scene *exact_scene,
                                   const tp_scene *scene)
{
    static uint32_t exact[PIXELS], whole[PIXELS], other[PIXELS];
    const tp_assets none = { 0 };
    tp_world *world = scene_world(scene, &none);

    assert_non_null(world);
    draw(exact_scene, world, 0, HEIGHT, exact);
    draw(scene, world, 0, HEIGHT, whole);
    draw(scene, world, n % 3 ? 32 : 0, n % 2 ? 16 : 13, other);
    assert_memory_equal(other, whole, sizeof whole);
    free(world);
    return picture_square_sum(exact, whole, PIXELS);
}

/* Prints and returns the mean square of the differences of PICTURES pictures, 1 / 100. */
static inline uint64_t mean_square(uint64_t sum)
{
    const uint64_t mean = sum * 100 / (PICTURES * 3 * (uint64_t)PIXELS);

    printf("  mean square %u / 100 levels\n", (unsigned)mean);
    return mean;
}

#endif
