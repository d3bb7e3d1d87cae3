/* SPDX-License-Identifier: MIT */
/* Fans over rings, pools and tanks: dense rows up to the end of the detail, heights kept,
 * the water of a tank exactly in its rectangle, no hole around a pool, and the same picture
 * in every tile. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <cmocka.h>
#include "tests/lib/tilings.h"
#include "view/fan.h"
#include "world/pools.h"

enum { WIDTH = 160, HEIGHT = 120, PIXELS = WIDTH * HEIGHT };

static uint64_t chance;
static const tp_assets none;
static const tp_config config = { .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT,
                                  .format = TP_FORMAT_XRGB8888 };
static uint32_t key[PIXELS];

/* -- scenes -------------------------------------------------------------------------- */

static tp_scene rings_scene(void)
{
    tp_scene s;

    tp_scene_level(&s);
    s.drops.count = 32;
    s.drops.rings = 64;
    s.drops.radius = TP_FX(0.09);
    s.drops.interval = TP_FX(0.3);
    s.drops.scatter_radius = TP_FX(1.8);
    s.drops.y = TP_FX(1.8);
    s.camera.y = TP_FX(1.6);
    s.camera.z = TP_FX(4.4);
    s.camera.pitch = -15 * TP_FX_ONE;
    s.grid.vertices = 9000;
    return s;
}

/* A pool of 60 m between walls of stone, in a calm sea. */
static tp_scene harbour_scene(void)
{
    tp_scene s;

    tp_scene_level(&s);
    s.pool.cols = s.pool.rows = 120;
    s.pool.cell = TP_FX(0.5);
    s.pool.max_height = TP_FX(2);
    s.pool.splash_interval = TP_FX(0.5);
    s.pool.splash_height = TP_FX(0.5);
    s.pool.splash_width = TP_FX(2);
    s.tank.kind = TP_TANK_STONE;
    s.tank.depth = 3 * TP_FX_ONE;
    s.tank.rim = TP_FX(1.4);
    s.camera.x = 18 * TP_FX_ONE;
    s.camera.y = 8 * TP_FX_ONE;
    s.grid.vertices = 3000;
    return s;
}

/* A tank of 3 x 2 m whose walls end at the level of the water. */
static tp_scene tank_scene(void)
{
    tp_scene s;

    tp_scene_level(&s);
    s.pool.cols = 48;
    s.pool.rows = 32;
    s.pool.cell = TP_FX_ONE / 16;
    s.pool.x = TP_FX(0.3);
    s.tank.kind = TP_TANK_GLASS;
    s.tank.sea = 0;
    s.tank.rim = 0;
    s.camera.near = TP_FX(0.1);
    s.grid.vertices = chance_int(&chance, 4, 5000);
    return s;
}

static void look_any(tp_scene *s, double high, double aside)
{
    s->camera.x = chance_fx(&chance, -aside, aside);
    s->camera.z = chance_fx(&chance, -aside, aside);
    s->camera.y = chance_fx(&chance, high / 4, high);
    s->camera.heading = chance_fx(&chance, -180, 180);
    s->camera.pitch = chance_fx(&chance, -89, 5);
}

static tp_world *world_after(const tp_scene *s, int ticks)
{
    static const tp_input still;
    tp_world *world = scene_world(s, &none);

    assert_non_null(world);
    for (int k = 0; k < ticks; k++)
        tp_world_step(&tp_program_all, world, s, &still);
    return world;
}

/* -- the law ------------------------------------------------------------------------- */

static tp_fan_law law_of(const tp_scene *s, tp_grid_view *view)
{
    tp_world *world = scene_world(s, &none);
    test_frame f = frame_of(s, &none, &config);

    assert_non_null(world);
    tp_frame_begin(f.frame, world);
    *view = f.frame->grid_view;
    const tp_fan_law law = f.frame->buffers.grid->fan->law;
    free(world);
    frame_free(&f);
    return law;
}

/* The spacing is a r, with one a, up to the end of the detail, unless the rows cannot hold
 * half of its length up to there. */
static void rows_are_dense_up_to_the_end_of_the_detail(void **state)
{
    uint32_t ended = 0;

    (void)state;
    for (int n = 0; n < 200; n++) {
        tp_scene s = n % 2 ? rings_scene() : harbour_scene();
        tp_grid_view view;
        look_any(&s, n % 2 ? 5 : 20, 5);
        s.grid.vertices = chance_int(&chance, 500, 20000);
        const tp_fan_law law = law_of(&s, &view), again = law_of(&s, &view);
        assert_memory_equal(&law, &again, sizeof law);
        assert_true(view.detail.length > 0);
        if (law.waves_end == TP_FX_MAX || law.dense <= 0)
            continue;
        const tp_rectangle *r = &view.detail.sides;
        const double x = law.right.z > 0 ? r->x1 : r->x0, z = law.right.x > 0 ? r->z0 : r->z1;
        const double end = ((x - s.camera.x) * law.right.z - (z - s.camera.z) * law.right.x)
                         / 1073741824;
        const double step = law.length / 16777216.0 / (law.rows - 1);
        const bool held = step * law.waves_end > 0.98 * view.detail.length / 2;
        assert_true(held || law.waves_end > 0.99 * hypot(end, law.height));
        ended += !held;
    }
    assert_true(ended > 20);
}

/* A step of the camera moves the end of the detail by as much.  The length of the rows, whose
 * unit is the height near the eye and grows with the distance, changes by the step over the
 * height at most; columns and rows are whole numbers. */
static void a_step_of_the_camera_changes_the_spacing_little(void **state)
{
    const double metres = 0.01;

    (void)state;
    for (int n = 0; n < 200; n++) {
        tp_scene s = n % 2 ? rings_scene() : harbour_scene();
        tp_grid_view view;
        look_any(&s, n % 2 ? 5 : 20, 5);
        s.camera.pitch = chance_fx(&chance, -40, -5);
        const tp_fan_law a = law_of(&s, &view);
        s.camera.x += TP_FX(metres);
        const tp_fan_law b = law_of(&s, &view);
        const double before = a.length / (a.rows - 1.0), after = b.length / (b.rows - 1.0);
        const double length = (a.length < b.length ? a.length : b.length) / 16777216.0;
        const double moved = metres / (a.height / 65536.0) / length;
        const double counts = a.cols == b.cols ? 0 : 1.0 / a.cols + 1.0 / (a.rows - 1);
        assert_true(fabs(after - before) <= (moved + counts) * before);
        assert_true(abs((int)a.cols - (int)b.cols) <= 1);
    }
}

/* -- heights ------------------------------------------------------------------------- */

static double ring_height(const tp_frame *f, double x, double z, tp_fx weight)
{
    return tp_rings_pools_sample_faded(&f->surface, (tp_fx)x, (tp_fx)z, weight).height
         / 65536.0;
}

/* Adds the squares of the heights in the middle of the cells in view, and of their errors
 * there. */
static void add_cells(const tp_frame *f, double *heights, double *errors)
{
    const tp_grid *g = f->buffers.grid;

    for (uint32_t j = 0; j + 1 < g->rows; j++) {
        const tp_fx w[2] = { tp_fan_row_detail_weight(g->fan, &g->fan->row[j]),
                             tp_fan_row_detail_weight(g->fan, &g->fan->row[j + 1]) };
        for (uint32_t i = g->span[j].first; i < g->span[j].end; i++) {
            double x = 0, z = 0, sum = 0;
            for (uint32_t k = 0; k < 4; k++) {
                const double s = tp_grid_s(g, i + k % 2, j + k / 2);
                const double t = tp_grid_t(g, i + k % 2, j + k / 2);
                x += s / 4;
                z += t / 4;
                sum += ring_height(f, s, t, w[k / 2]) / 4;
            }
            const double want = ring_height(f, x, z, TP_FX_ONE);
            *heights += want * want;
            *errors += (sum - want) * (sum - want);
        }
    }
}

/* On a mesh of points 0.1 m apart the error in the middle of a cell was 0.0844 of the
 * heights. */
static void heights_of_rings_are_kept(void **state)
{
    double heights = 0, errors = 0;

    (void)state;
    for (int ticks = 60; ticks <= 420; ticks += 120) {
        tp_scene s = rings_scene();
        tp_world *world = world_after(&s, ticks);
        test_frame f = frame_of(&s, &none, &config);
        tp_frame_begin(f.frame, world);
        add_cells(f.frame, &heights, &errors);
        frame_free(&f);
        free(world);
    }
    printf("# rms error of rings %.4f of their heights\n", sqrt(errors / heights));
    assert_true(heights > 0 && errors < 0.0844 * 0.0844 * heights);
}

/* -- a tank -------------------------------------------------------------------------- */

/* True if the ray of a pixel's middle, or one within half a pixel of it, meets still water
 * in the rectangle, by `all` of them or any. */
static bool meets_water(const tp_frame *f, int px, int py, bool all)
{
    const tp_projection *p = &f->projection;
    const tp_rectangle r = tp_pool_sides(f->scene);
    const double q = 1073741824, focal = p->focal / 65536.0;

    for (int k = 0; k < 9; k++) {
        const double u = px + 0.5 + (k % 3 - 1) * 0.5 - WIDTH / 2.0;
        const double v = HEIGHT / 2.0 - (py + 0.5 + (k / 3 - 1) * 0.5);
        const double x = focal * p->ahead.x + u * p->turn.x.x + v * p->turn.y.x;
        const double y = focal * p->ahead.y + u * p->turn.x.y + v * p->turn.y.y;
        const double z = focal * p->ahead.z + u * p->turn.x.z + v * p->turn.y.z;
        const double way = -p->eye.y / (y / q);
        const double at_x = p->eye.x + way * x / q, at_z = p->eye.z + way * z / q;
        const bool in = y < 0 && at_x > r.x0 && at_x < r.x1 && at_z > r.z0 && at_z < r.z1
                     && way / 65536 * focal > p->near / 65536.0;
        if (in != all)
            return !all;
    }
    return all;
}

static void check_tank(const tp_scene *s, uint32_t *inside, uint32_t *outside)
{
    tp_world *world = scene_world(s, &none);
    test_frame f = frame_of(s, &none, &config);

    assert_non_null(world);
    marks_draw(s, &none, world, config, key, NULL);
    tp_frame_begin(f.frame, world);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const bool water = TP_MARK(key[y * WIDTH + x]) == MARKS_WATER;
            if (meets_water(f.frame, x, y, true)) {
                assert_true(water);
                ++*inside;
            } else if (!meets_water(f.frame, x, y, false)) {
                assert_false(water);
                ++*outside;
            }
        }
    frame_free(&f);
    free(world);
}

static void a_tank_has_water_in_its_rectangle_alone(void **state)
{
    uint32_t inside = 0, outside = 0;

    (void)state;
    for (int n = 0; n < 150; n++) {
        tp_scene s = tank_scene();
        look_any(&s, 5, 3);
        if (n % 10 == 0)
            s.camera.pitch = -89 * TP_FX_ONE;
        s.quality.visibility = n % 2 ? TP_VISIBILITY_ROWS : TP_VISIBILITY_TRIANGLES;
        check_tank(&s, &inside, &outside);
    }
    assert_true(inside > PIXELS && outside > PIXELS);
}

/* The corners of rows are those of the rectangle, and places rise along rows and across, so
 * cells cover the rectangle once. */
static void rows_of_a_tank_end_at_its_walls(void **state)
{
    (void)state;
    for (int n = 0; n < 100; n++) {
        tp_scene s = tank_scene();
        s.pool.cell = chance_fx(&chance, 0.01, 3);
        look_any(&s, 5, 3);
        tp_world *world = scene_world(&s, &none);
        test_frame f = frame_of(&s, &none, &config);
        tp_frame_begin(f.frame, world);
        const tp_grid *g = f.frame->buffers.grid;
        const tp_rectangle r = tp_pool_sides(&s);
        const uint32_t cols = g->cols - 1, rows = g->rows - 1;
        tp_fx low[2] = { TP_FX_MAX, TP_FX_MAX }, high[2] = { TP_FX_MIN, TP_FX_MIN };
        for (uint32_t k = 0; k < 4; k++) {
            const tp_fx at[2] = { tp_grid_s(g, k & 1 ? cols : 0, k & 2 ? rows : 0),
                                  tp_grid_t(g, k & 1 ? cols : 0, k & 2 ? rows : 0) };
            for (int axis = 0; axis < 2; axis++) {
                low[axis] = at[axis] < low[axis] ? at[axis] : low[axis];
                high[axis] = at[axis] > high[axis] ? at[axis] : high[axis];
            }
        }
        assert_true(low[0] == r.x0 && high[0] == r.x1 && low[1] == r.z0 && high[1] == r.z1);
        const bool along_x = g->fan->law.right.x != 0;
        const int64_t sign = along_x ? g->fan->law.right.x : g->fan->law.right.z;
        for (uint32_t i = 0; i < cols; i++)
            assert_true((along_x ? (int64_t)tp_grid_s(g, i + 1, 0) - tp_grid_s(g, i, 0)
                                 : (int64_t)tp_grid_t(g, i + 1, 0) - tp_grid_t(g, i, 0))
                            * sign > 0);
        frame_free(&f);
        free(world);
    }
}

/* -- pictures ------------------------------------------------------------------------ */

/* From each height no pixel of the lower rows is without water or a solid. */
static void water_around_pools_and_rings_has_no_hole(void **state)
{
    static const double heights[] = { 2, 14, 50, 150 };
    static const double pitches[] = { -10, -25, -60, -89 };

    (void)state;
    for (int n = 0; n < 96; n++) {
        tp_scene s = n / 16 % 2 ? rings_scene() : harbour_scene();
        s.camera.y = (tp_fx)(heights[n % 4] * 65536);
        s.camera.pitch = (tp_fx)(pitches[n / 4 % 4] * 65536);
        s.camera.heading = chance_fx(&chance, -180, 180);
        s.camera.x = chance_fx(&chance, -20, 20);
        s.quality.visibility = n / 32 % 2 ? TP_VISIBILITY_ROWS : TP_VISIBILITY_TRIANGLES;
        tp_world *world = world_after(&s, 30);
        marks_draw(&s, &none, world, config, key, NULL);
        const double half = tan(s.camera.fov / 65536.0 * 3.14159265358979 / 360);
        const double dip = atan(heights[n % 4] / 15800);
        const double up = tan(s.camera.pitch / 65536.0 * 3.14159265358979 / 180 + dip);
        const int first = (int)fmax(0, ceil(HEIGHT / 2.0 * (1 + up / half)) + 2);
        for (int y = first; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                assert_int_not_equal(TP_MARK(key[y * WIDTH + x]), MARKS_SKY);
        free(world);
    }
}

static void they_are_drawn_the_same_in_tiles(void **state)
{
    static const uint32_t size[][2] = { { WIDTH, 16 }, { 48, 40 }, { 16, 120 } };

    (void)state;
    for (int n = 0; n < 45; n++) {
        tp_scene s = n % 3 == 0 ? rings_scene() : n % 3 == 1 ? harbour_scene() : tank_scene();
        look_any(&s, n % 3 == 1 ? 20 : 4, 4);
        s.quality.visibility = n / 3 % 2 ? TP_VISIBILITY_ROWS : TP_VISIBILITY_TRIANGLES;
        tp_world *world = world_after(&s, 40);
        marks_assert_tiled(&s, &none, world, config, size, 3, key);
        free(world);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_dense_up_to_the_end_of_the_detail),
        cmocka_unit_test(a_step_of_the_camera_changes_the_spacing_little),
        cmocka_unit_test(heights_of_rings_are_kept),
        cmocka_unit_test(a_tank_has_water_in_its_rectangle_alone),
        cmocka_unit_test(rows_of_a_tank_end_at_its_walls),
        cmocka_unit_test(water_around_pools_and_rings_has_no_hole),
        cmocka_unit_test(they_are_drawn_the_same_in_tiles),
    };
    return cmocka_run_group_tests_name("frame/fan_detail", tests, NULL, NULL);
}
