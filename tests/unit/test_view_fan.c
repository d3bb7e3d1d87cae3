/* SPDX-License-Identifier: MIT */
/* The fan: rows by the law in double precision, water wherever a ray meets it, vertices on
 * the surface, and the filter of waves. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../reference/clip.h"
#include "view/fan.h"
#include "view/wave_models.h"
#include "tests/lib/camera.h"

#define METRE 65536.0
#define Q24 16777216.0

static uint64_t chance;

/* A fan with its memory and all the data of its view. */
typedef struct {
    tp_grid grid;
    void   *block;
    test_view v;
    tp_deep_water deep;
    tp_turn phases[TP_WAVES];
    tp_surface surface;
    tp_grid_view look;
} sea;

static void place(sea *s)
{
    s->surface =
        (tp_surface){ .by = &tp_program_all.water, .deep = &s->deep, .phases = s->phases };
    s->look.projection = &s->v.projection;
    s->look.surface = &s->surface;
    s->look.width = s->v.width;
    s->look.height = s->v.height;
    s->look.cell = TP_FX_ONE;
    tp_grid_evaluate_vertices(&s->grid, &s->look);
}

static void lay_out(sea *s, uint32_t vertices)
{
    tp_arena count = tp_arena_init(NULL, 0);

    s->look.vertices = vertices;
    tp_water_fan.layout(&s->grid, &count, vertices, false);
    s->block = malloc(count.used);
    assert_non_null(s->block);
    memset(s->block, 0xa5, count.used);
    tp_arena arena = tp_arena_init(s->block, count.used);
    tp_water_fan.layout(&s->grid, &arena, vertices, false);
    assert_false(arena.failed);
}

static sea any_sea(void)
{
    sea s = { .v = view_any(&chance) };
    tp_wave waves[TP_WAVES];
    const int count = chance_int(&chance, 0, 4);

    for (int i = 0; i < count; i++) {
        waves[i] = chance_wave(&chance);
        waves[i].amplitude = chance_scale(&chance, 0.01, 1);
    }
    tp_deep_water_init(&s.deep, waves, (uint32_t)count, TP_FX(9.81));
    tp_deep_water_phases(&s.deep, random_next(&chance) >> 20, 0, s.phases);
    lay_out(&s, (uint32_t)chance_int(&chance, 64, 6000));
    return s;
}

/* -- the law ------------------------------------------------------------------------- */

/* Distance of row n by the law, m. */
static double expected_distance(const tp_fan_law *law, uint32_t n)
{
    const double way = law->length / Q24 * n / (law->rows - 1), h = law->height / METRE;

    if (law->waves_end == TP_FX_MAX || way <= law->dense / Q24)
        return h * sinh(law->start / Q24 + way);
    if (n + 1 == law->rows)
        return law->last / METRE;
    const double left = fmax(1 - law->tail * (way - law->dense / Q24), 1 / Q24);
    const double r = fmin(law->waves_end / METRE / pow(left, 1.0 / law->tail), 22000);
    return sqrt(fmax(r * r - h * h, 0));
}

static double row_distance(const sea *s, uint32_t j)
{
    const tp_fan *fan = s->grid.fan;
    const tp_fan_row *row = &fan->row[j];
    const double half = (s->grid.cols - 1) / 2.0;
    const double x = row->x - (double)s->v.projection.eye.x + half * row->step_x;
    const double z = row->z - (double)s->v.projection.eye.z + half * row->step_z;
    return (x * fan->law.right.z - z * fan->law.right.x) / 1073741824 / METRE;
}

static void check_law(const sea *s)
{
    const tp_fan_law *law = &s->grid.fan->law;

    assert_true(law->rows >= 2 && law->cols >= 2);
    assert_true(law->rows * law->cols <= s->look.vertices);
    assert_true(law->rows <= s->grid.most_rows && law->cols <= s->grid.most_cols);
    for (uint32_t j = 0; j < law->rows; j++) {
        const double want = expected_distance(law, law->rows - 1 - j);
        const double off = fabs(row_distance(s, j) - want);
        const double spacing = s->grid.fan->row[j].along / METRE;
        assert_true(off <= 0.02 + fabs(want) * 2e-4 + spacing / 50);
    }
    for (uint32_t j = 0; j + 1 < law->rows; j++)
        assert_true(row_distance(s, j) >= row_distance(s, j + 1) - 0.02);
}

static void rows_follow_the_law(void **state)
{
    uint32_t ends = 0;

    (void)state;
    for (int n = 0; n < 400; n++) {
        sea s = any_sea();
        place(&s);
        check_law(&s);
        ends += s.grid.fan->law.waves_end < TP_FX_MAX;
        free(s.block);
    }
    assert_true(ends > 10);
}

/* -- no void ------------------------------------------------------------------------- */

/* True if the cell that holds a place of the level plane is among the visible cells. */
static bool is_covered(const sea *s, double x, double z)
{
    for (uint32_t j = 0; j + 1 < s->grid.rows; j++) {
        const tp_fan_row *a = &s->grid.fan->row[j], *b = a + 1;
        const tp_dir3 r = s->grid.fan->law.right;
        const double ahead = x * r.z - z * r.x;
        const double far = (double)a->x * r.z - (double)a->z * r.x;
        const double near = (double)b->x * r.z - (double)b->z * r.x;
        const double share = far > near ? (far - ahead) / (far - near) : 0;
        if (ahead > far || ahead < near)
            continue;
        const double x0 = a->x + share * ((double)b->x - a->x);
        const double z0 = a->z + share * ((double)b->z - a->z);
        const double step = (a->across + share * ((double)b->across - a->across))
                          * 1073741824;
        const double i = ((x - x0) * r.x + (z - z0) * r.z) / step;
        if (i >= s->grid.span[j].first - 0.01 && i <= s->grid.span[j].end + 0.01)
            return true;
    }
    return false;
}

static void check_ray(const sea *s, double u, double v, uint32_t *met)
{
    const tp_projection *p = &s->v.projection;
    const double f = p->focal / METRE, q = 1073741824;
    const double x = f * p->ahead.x / q + u * p->turn.x.x / q + v * p->turn.y.x / q;
    const double y = f * p->ahead.y / q + u * p->turn.x.y / q + v * p->turn.y.y / q;
    const double z = f * p->ahead.z / q + u * p->turn.x.z / q + v * p->turn.y.z / q;
    const double way = -p->eye.y / METRE / y;

    if (fabs(y) < 1e-9 || way * f * METRE < p->near
        || way * hypot(x, z) * METRE > 0.99 * s->grid.fan->law.farthest)
        return;                         /* not in view, or beyond the water */
    ++*met;
    assert_true(is_covered(s, p->eye.x + way * x * METRE, p->eye.z + way * z * METRE));
}

static void water_is_wherever_a_ray_meets_it(void **state)
{
    uint32_t met = 0;

    (void)state;
    for (int n = 0; n < 600; n++) {
        sea s = any_sea();
        place(&s);
        const double w = s.v.width / 2.0, h = s.v.height / 2.0;
        for (int k = 0; k < 20; k++)
            check_ray(&s, k < 4 ? (k & 1 ? w : -w) : chance_double(&chance, -w, w),
                      k < 4 ? (k & 2 ? h : -h) : chance_double(&chance, -h, h), &met);
        free(s.block);
    }
    assert_true(met > 1000);
}

/* -- vertices ------------------------------------------------------------------------ */

static bool keeps_all(const sea *s, const tp_fan_row *row)
{
    for (uint32_t i = 0; i < s->deep.count; i++)
        if (tp_fan_row_weight(s->grid.fan, row, &s->deep.swell[i]) != TP_FX_ONE)
            return false;
    return true;
}

static void check_vertex(const sea *s, uint32_t i, uint32_t j)
{
    const tp_view_vertex c = tp_grid_make_view_vertex(
        &s->grid, &s->grid.vertex[j * s->grid.cols + i], i, j);
    const tp_vec3 at = tp_surface_displace(&s->surface, tp_grid_s(&s->grid, i, j),
                                           tp_grid_t(&s->grid, i, j));
    tp_view_vertex want;

    tp_projection_view_vertex(&s->v.projection, at, &want);
    assert_true(tp_abs(c.x - want.x) < 100 && tp_abs(c.y - want.y) < 100
                && tp_abs(c.depth - want.depth) < 100);
}

static void kept_waves_are_those_of_the_surface(void **state)
{
    uint32_t met = 0;

    (void)state;
    for (int n = 0; n < 400; n++) {
        sea s = any_sea();
        place(&s);
        for (uint32_t j = 0; j + 1 < s.grid.rows; j++) {
            const tp_grid_span span = s.grid.span[j];
            if (span.first >= span.end || !keeps_all(&s, &s.grid.fan->row[j]))
                continue;
            check_vertex(&s, span.first, j);
            check_vertex(&s, span.end, j);
            met++;
        }
        free(s.block);
    }
    assert_true(met > 100);
}

/* -- the filter ---------------------------------------------------------------------- */

static void weights_fall_from_one_to_zero(void **state)
{
    const int64_t ten = ((int64_t)1 << 32) / 10;        /* a wave of 10 m */
    tp_fx last = TP_FX_ONE;

    (void)state;
    for (tp_fx spacing = 0; spacing < 8 * TP_FX_ONE; spacing += 100) {
        const tp_fx weight = tp_fan_wave_weight(spacing, -ten);
        assert_int_equal(weight, tp_fan_wave_weight(spacing, ten));
        assert_true(weight <= last + 2);
        last = weight;
        if (spacing < TP_FX(2.99))
            assert_int_equal(weight, TP_FX_ONE);
        if (spacing > TP_FX(5.01))
            assert_int_equal(weight, 0);
    }
}

/* A row without waves leaves half of (k A)^2, over both axes. */
static void variance_is_that_of_the_waves_left_out(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        sea s = any_sea();
        double sum = 0;
        place(&s);
        tp_fan_row row = { .along = 8000 * TP_FX_ONE, .across = 8000 * TP_FX_ONE };
        const tp_slope_variance v = tp_fan_row_variance(s.grid.fan, &row, &s.surface);
        row.along = row.across = 1;
        const tp_slope_variance none = tp_fan_row_variance(s.grid.fan, &row, &s.surface);
        for (uint32_t i = 0; i < s.deep.count; i++) {
            const double x = s.deep.swell[i].slope_x / 1073741824.0;
            const double z = s.deep.swell[i].slope_z / 1073741824.0;
            sum += (x * x + z * z) / 2;
        }
        if (sum < 0.9)
            assert_true(fabs((v.along + (double)v.across) / Q24 - sum) < 1e-4 + sum / 100);
        assert_true(none.along + none.across < 64);
        free(s.block);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_follow_the_law),
        cmocka_unit_test(water_is_wherever_a_ray_meets_it),
        cmocka_unit_test(kept_waves_are_those_of_the_surface),
        cmocka_unit_test(weights_fall_from_one_to_zero),
        cmocka_unit_test(variance_is_that_of_the_waves_left_out),
    };
    return cmocka_run_group_tests_name("view/fan", tests, NULL, NULL);
}
