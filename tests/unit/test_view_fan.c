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
#include "tests/lib/fans.h"

#define METRE 65536.0
#define Q24 16777216.0

static uint64_t chance;

static fan_sea any_sea(void)
{
    fan_sea s = { .v = view_any(&chance) };

    fan_sea_make_swells(&s, chance_int(&chance, 0, 4), true, &chance);
    fan_sea_lay_out_grid(&s, (uint32_t)chance_int(&chance, 64, 6000));
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

static double row_distance(const fan_sea *s, uint32_t j)
{
    const tp_fan *fan = s->grid.fan;
    const tp_fan_row *row = &fan->row[j];
    const double half = (s->grid.cols - 1) / 2.0;
    const double x = row->x - (double)s->v.projection.eye.x + half * row->step_x;
    const double z = row->z - (double)s->v.projection.eye.z + half * row->step_z;
    return (x * fan->law.right.z - z * fan->law.right.x) / 1073741824 / METRE;
}

static void check_law(const fan_sea *s)
{
    const tp_fan_law *law = &s->grid.fan->law;

    assert_true(law->rows >= 2 && law->cols >= 2);
    assert_true(law->rows * law->cols <= s->look.vertices);
    assert_true(law->rows <= tp_fan_most_rows(s->look.vertices) && law->cols <= s->grid.most_cols);
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
        fan_sea s = any_sea();
        fan_sea_place(&s);
        check_law(&s);
        ends += s.grid.fan->law.waves_end < TP_FX_MAX;
        free(s.block);
    }
    assert_true(ends > 10);
}

/* -- no void ------------------------------------------------------------------------- */

/* True if the cell that holds a place of the level plane is among the visible cells. */
static bool is_covered(const fan_sea *s, double x, double z)
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

/* Turns the camera about its line of sight. */
static void roll(test_view *v)
{
    tp_projection *p = &v->projection;
    const tp_dir3 x = p->turn.x, y = p->turn.y;
    const tp_turn by = (tp_turn)random_next(&chance);
    const tp_q30 s = tp_sin(by), c = tp_cos(by);
    tp_rotation turn = p->turn;

    turn.x = (tp_dir3){ tp_q30_mul(x.x, c) + tp_q30_mul(y.x, s),
                        tp_q30_mul(x.y, c) + tp_q30_mul(y.y, s),
                        tp_q30_mul(x.z, c) + tp_q30_mul(y.z, s) };
    turn.y = (tp_dir3){ tp_q30_mul(y.x, c) - tp_q30_mul(x.x, s),
                        tp_q30_mul(y.y, c) - tp_q30_mul(x.y, s),
                        tp_q30_mul(y.z, c) - tp_q30_mul(x.z, s) };
    tp_projection_init_turned(p, p->eye, turn, chance_fx(&chance, 20, 100), p->near,
                              v->width, v->height);
}

static void check_ray(const fan_sea *s, double u, double v, uint32_t *met)
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
        fan_sea s = any_sea();
        if (n % 2)
            roll(&s.v);
        fan_sea_place(&s);
        const double w = s.v.width / 2.0, h = s.v.height / 2.0;
        for (int k = 0; k < 20; k++)
            check_ray(&s, k < 4 ? (k & 1 ? w : -w) : chance_double(&chance, -w, w),
                      k < 4 ? (k & 2 ? h : -h) : chance_double(&chance, -h, h), &met);
        free(s.block);
    }
    assert_true(met > 1000);
}

/* -- vertices ------------------------------------------------------------------------ */

static tp_fx row_weight(const fan_sea *s, uint32_t j, uint32_t i)
{
    return tp_fan_row_weight(s->grid.fan, &s->grid.fan->row[j], &s->deep.swell[i]);
}

static bool keeps_all(const fan_sea *s, uint32_t j)
{
    for (uint32_t i = 0; i < s->deep.count; i++)
        if (row_weight(s, j, i) < TP_FX_ONE)
            return false;
    return true;
}

/* Compares a vertex with the surface of waves that are as high as the row makes them, its
 * slopes with those of waves that do not fold more than without gain. */
static void check_vertex(const fan_sea *s, uint32_t i, uint32_t j)
{
    const tp_grid_vertex *vertex = &s->grid.vertex[j * s->grid.cols + i];
    const tp_view_vertex c = grid_corner(&s->grid, i, j);
    tp_deep_water raised = s->deep;
    tp_surface surface = s->surface;
    tp_view_vertex want;
    bool steep = false;                 /* slopes of 2 and more are cut */

    for (uint32_t k = 0; k < raised.count; k++) {
        tp_swell *w = &raised.swell[k];
        const tp_fx weight = row_weight(s, j, k);
        w->amplitude = tp_fx_mul(w->amplitude, weight);
        w->orbit_x = tp_fx_mul(w->orbit_x, weight);
        w->orbit_z = tp_fx_mul(w->orbit_z, weight);
        steep = steep || hypot(w->slope_x, w->slope_z) * weight > 0x1p47;
        w->slope_x = tp_fx_saturate((int64_t)w->slope_x * weight >> 16);
        w->slope_z = tp_fx_saturate((int64_t)w->slope_z * weight >> 16);
    }
    raised.crossed = true;              /* as the rows sum them */
    surface.deep = &raised;
    const tp_vec3 at = tp_surface_displace(&surface, tp_grid_s(&s->grid, i, j),
                                           tp_grid_t(&s->grid, i, j));
    tp_projection_view_vertex(&s->v.projection, at, &want);
    assert_true(tp_abs(c.x - want.x) < 100 && tp_abs(c.y - want.y) < 100
                && tp_abs(c.depth - want.depth) < 100);
    if (steep)
        return;
    const tp_surface_point point = tp_deep_water_displace_point(
        &raised, s->phases, tp_grid_s(&s->grid, i, j), tp_grid_t(&s->grid, i, j));
    assert_true(tp_abs(vertex->slope_x * 16 - point.slope_x) <= 24);
    assert_true(tp_abs(vertex->slope_z * 16 - point.slope_z) <= 24);
}

static void kept_waves_are_those_of_the_surface(void **state)
{
    uint32_t met = 0;

    (void)state;
    for (int n = 0; n < 400; n++) {
        fan_sea s = any_sea();
        fan_sea_place(&s);
        for (uint32_t j = 0; j + 1 < s.grid.rows; j++) {
            const tp_grid_span span = s.grid.span[j];
            if (span.first >= span.end || !keeps_all(&s, j))
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

static void a_weight_is_the_gain_up_to_three_tenths_and_falls_to_zero(void **state)
{
    const int64_t ten = ((int64_t)1 << 32) / 10;        /* a wave of 10 m */

    (void)state;
    for (tp_fx spacing = 0; spacing < 8 * TP_FX_ONE; spacing += 100) {
        const tp_fx weight = tp_fan_wave_weight(spacing, -ten);
        const double step = 2 * 3.14159265358979 * spacing / 65536 / 10;
        assert_int_equal(weight, tp_fan_wave_weight(spacing, ten));
        assert_true(weight <= TP_FX(1.3229));       /* sqrt(TP_FAN_GAIN) */
        if (spacing < TP_FX(2.99))
            assert_true(fabs(weight / 65536.0 - 1 - step * step / 12) < 0.0005);
        if (spacing > TP_FX(5.01))
            assert_int_equal(weight, 0);
    }
}

/* Returns the rms of the error of a wave of 1, linear between points `cells` to the wave. */
static double interpolation_error(double cells, double weight)
{
    const double k = 2 * 3.14159265358979 / cells;
    double sum = 0;

    for (int i = 0; i < 64 * 64; i++) {
        const double share = (i / 64 + 0.5) / 64, phase = i % 64 * 0.0981747704246810;
        const double drawn = (1 - share) * cos(phase) + share * cos(k + phase);
        sum += pow(weight * drawn - cos(k * share + phase), 2);
    }
    return sqrt(sum / (64 * 64));
}

/* The gain takes a third of the error at 3.4 cells a wave, and half from 5.2 cells on. */
static void the_gain_lowers_the_error_of_linear_interpolation(void **state)
{
    (void)state;
    for (double cells = 3.4; cells < 12; cells += 0.1) {
        const int64_t turns = llround(4294967296.0 / cells);
        const double weight = tp_fan_wave_weight(TP_FX_ONE, turns) / 65536.0;
        assert_true(interpolation_error(cells, weight)
                    < interpolation_error(cells, 1) * (cells < 5.2 ? 2.0 / 3 : 0.5));
    }
}

/* A row without waves leaves half of (k A)^2, over both axes. */
static void variance_is_that_of_the_waves_left_out(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        fan_sea s = any_sea();
        double sum = 0;
        fan_sea_place(&s);
        tp_fan_row row = { .along = 8000 * TP_FX_ONE, .across = 8000 * TP_FX_ONE };
        const tp_slope_variance v = tp_fan_row_variance(&s.grid, &row,
                                                        TP_FX_ONE);
        row.along = row.across = 1;
        const tp_slope_variance none = tp_fan_row_variance(&s.grid, &row,
                                                           TP_FX_ONE);
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

/* Returns the mean square, over that of a wave, of the wave interpolated over a spacing of
 * so many wavelengths. */
static double interpolated_square(double spacing)
{
    enum { PHASES = 40, PARTS = 40 };
    const double turn = 6.283185307179586;
    double sum = 0;

    for (int i = 0; i < PHASES; i++)
        for (int j = 0; j < PARTS; j++) {
            const double a = sin(turn * i / PHASES);
            const double b = sin(turn * (i / (double)PHASES + spacing));
            const double at = a + (b - a) * (j + 0.5) / PARTS;
            sum += at * at;
        }
    return 2 * sum / (PHASES * PARTS);
}

/* What a row keeps is interpolated along it and across; a pixel as large as the row's
 * spacing does not show what that loses. */
static void variance_counts_the_loss_of_interpolation(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        fan_sea s = any_sea();
        double want = 0, sum = 0;
        fan_sea_place(&s);
        const double rx = s.grid.fan->law.right.x / 0x1p30;
        const double rz = s.grid.fan->law.right.z / 0x1p30;
        const tp_fan_row row = { .along = chance_fx(&chance, 0.1, 4),
                                 .across = chance_fx(&chance, 0.1, 4) };
        const tp_slope_variance v = tp_fan_row_variance(&s.grid, &row,
                                                        TP_FX_ONE);
        const tp_slope_variance seen = tp_fan_row_variance(&s.grid, &row, 0);
        for (uint32_t i = 0; i < s.deep.count; i++) {
            const tp_swell *w = &s.deep.swell[i];
            const double x = w->slope_x / 0x1p30, z = w->slope_z / 0x1p30;
            const double tx = (double)w->turns_x / 0x1p32, tz = (double)w->turns_z / 0x1p32;
            const double weight = tp_fan_row_weight(s.grid.fan, &row, w) / 65536.0;
            const double kept =
                interpolated_square((tx * rz - tz * rx) * row.along / 65536.0)
                * interpolated_square((tx * rx + tz * rz) * row.across / 65536.0);
            want += (x * x + z * z) / 2 * (1 - weight * weight * kept);
            sum += (x * x + z * z) / 2;
        }
        free(s.block);
        if (sum >= 0.9)             /* near the largest variance */
            continue;
        assert_true(fabs((v.along + (double)v.across) / Q24 - want) < 1e-4 + sum / 100);
        assert_true(fabs((double)seen.left - seen.along - seen.across) < 300); /* 2^-16 */
        assert_int_equal(v.left, seen.left);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_follow_the_law),
        cmocka_unit_test(water_is_wherever_a_ray_meets_it),
        cmocka_unit_test(kept_waves_are_those_of_the_surface),
        cmocka_unit_test(a_weight_is_the_gain_up_to_three_tenths_and_falls_to_zero),
        cmocka_unit_test(the_gain_lowers_the_error_of_linear_interpolation),
        cmocka_unit_test(variance_is_that_of_the_waves_left_out),
        cmocka_unit_test(variance_counts_the_loss_of_interpolation),
    };
    return cmocka_run_group_tests_name("view/fan", tests, NULL, NULL);
}
