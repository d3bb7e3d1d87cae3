/* SPDX-License-Identifier: MIT */
/* The grid of coastal water: positions of its vertices, slopes of the surface between the
 * vertices, and vertices on land. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "view/fan.h"
#include "tests/lib/measure.h"
#include "tests/lib/coastal_water.h"
#include "tests/lib/camera.h"
#include "tests/lib/grids.h"

static uint64_t chance;

typedef struct {
    tp_grid grid;
    void   *block;
    test_view    v;
    coastal_water coastal;
    tp_turn phases[TP_WAVES];
    tp_surface surface;
    tp_grid_view look;
} beach;

/* A beach that rises from 8 m of water through the grid, with the eye anywhere above. */
static void make(beach *s)
{
    const tp_vec3 eye = { chance_fx(&chance, -60, 60), chance_fx(&chance, 1, 40),
                          chance_fx(&chance, -60, 60) };

    memset(s, 0, sizeof *s);
    s->coastal.count = (uint32_t)chance_int(&chance, 1, 3);
    for (uint32_t i = 0; i < s->coastal.count; i++)
        s->coastal.wave[i] =
            coastal_wave(chance_double(&chance, 0.05, 0.4), chance_double(&chance, 8, 40),
                         0.15, chance_double(&chance, 0, 360));
    s->coastal.config = coastal_usual();
    s->coastal.config.floor = (tp_floor){ .depth = 8 * TP_FX_ONE, .slope = TP_FX(0.15),
                                        .heading = chance_fx(&chance, 0, 360) };
    coastal_build(&s->coastal);
    tp_deep_water_phases(&s->coastal.deep, random_next(&chance) >> 30, 0, s->phases);
    s->v = view_of(eye, (tp_turn)random_next(&chance),
                   tp_turn_of_degrees(chance_fx(&chance, -80, 10)),
                   chance_fx(&chance, 30, 90), TP_FX(0.25), 320, 240);
    s->surface = (tp_surface){ .by = &tp_program_all.water,
                               .deep = &s->coastal.deep,
                               .phases = s->phases,
                               .coastal = s->coastal.coastal };
    s->look = (tp_grid_view){ .projection = &s->v.projection,
                              .surface = &s->surface,
                              .width = 320,
                              .height = 240,
                              .vertices = (uint32_t)chance_int(&chance, 64, 1600) };
    s->block = grid_block(&s->grid, s->look.vertices, true);
    tp_grid_evaluate_vertices(&s->grid, &s->look);
}

static void beach_free(beach *s)
{
    free(s->block);
    coastal_end(&s->coastal);
}

/* The point of the coastal water itself, of the waves that the row holds. */
static tp_coastal_point point_at(const beach *s, uint32_t i, uint32_t j)
{
    const tp_fan *fan = s->grid.fan;
    const tp_coastal_spacing spacing =
        tp_fan_row_spacing(fan, &fan->row[j], &s->coastal.deep);

    return tp_coastal_displace_filtered(s->coastal.coastal, s->phases, &spacing,
                                        tp_grid_s(&s->grid, i, j),
                                        tp_grid_t(&s->grid, i, j));
}

static bool is_needed(const beach *s, uint32_t i, uint32_t j)
{
    const tp_grid_span needed = tp_grid_needed_vertices(&s->grid, j);
    return needed.first <= i && i < needed.end;
}

static void vertices_are_coastal_points(void **state)
{
    (void)state;
    int checked = 0, dry = 0;

    for (int n = 0; n < 120; n++) {
        beach s;
        make(&s);
        for (uint32_t j = 0; j < s.grid.rows; j++) {
            for (uint32_t i = 0; i < s.grid.cols; i++) {
                if (!is_needed(&s, i, j))
                    continue;
                const tp_coastal_point p = point_at(&s, i, j);
                const tp_view_vertex got = grid_corner(&s.grid, i, j);
                const tp_grid_vertex *vertex = &s.grid.vertex[j * s.grid.cols + i];
                tp_view_vertex want;
                tp_projection_view_vertex(&s.v.projection, p.position, &want);
                assert_int_equal(got.x, want.x);
                assert_int_equal(got.y, want.y);
                assert_int_equal(got.depth, want.depth);
                assert_int_equal(tp_grid_vertex_is_dry(&s.grid, i, j), p.depth <= 0);
                int32_t u = TP_GRID_NEEDS_CLIP, v = vertex->v;
                uint32_t zi = vertex->zi;
                if (tp_projection_can_project(&s.v.projection, &want))
                    tp_projection_project(&s.v.projection, &want, &u, &v, &zi);
                assert_true(vertex->u == u && vertex->v == v && vertex->zi == zi);
                checked++;
                dry += p.depth <= 0;
            }
        }
        beach_free(&s);
    }
    assert_true(checked > 1000 && dry > 100);
}

/* dP/dcolumn x dP/drow in double precision, from four neighbours, or at a side from three.
 * Nearly vertical surfaces are left out, because their slopes are clamped. */
static void slopes_are_those_between_neighbours(void **state)
{
    (void)state;
    measure error = { .what = "slope", .unit = "of 2^12" };

    for (int n = 0; n < 120; n++) {
        beach s;
        make(&s);
        for (int k = 0; k < 200; k++) {
            const uint32_t i = random_below(&chance, s.grid.cols);
            const uint32_t j = random_below(&chance, s.grid.rows);
            if (!is_needed(&s, i, j))
                continue;
            const tp_grid_vertex *got = &s.grid.vertex[j * s.grid.cols + i];
            const tp_vec3 a = point_at(&s, i > 0 ? i - 1 : i, j).position;
            const tp_vec3 b = point_at(&s, i + 1 < s.grid.cols ? i + 1 : i, j).position;
            const tp_vec3 c = point_at(&s, i, j > 0 ? j - 1 : j).position;
            const tp_vec3 d = point_at(&s, i, j + 1 < s.grid.rows ? j + 1 : j).position;
            const double x[3] = { (double)b.x - a.x, (double)b.y - a.y, (double)b.z - a.z };
            const double z[3] = { (double)d.x - c.x, (double)d.y - c.y, (double)d.z - c.z };
            const double nx = z[1] * x[2] - z[2] * x[1], ny = z[2] * x[0] - z[0] * x[2];
            const double nz = z[0] * x[1] - z[1] * x[0];
            if (ny < 0.2 * (fabs(nx) + fabs(nz)))
                continue;
            const double off = fmax(fabs(got->slope_x + 4096 * nx / ny),
                                    fabs(got->slope_z + 4096 * nz / ny));
            assert_true(off <= 1);
            measure_add(&error, off, i, j, n);
        }
        beach_free(&s);
    }
    measure_print(&error);
    assert_true(error.inputs > 500);
}

static void cells_on_land_are_told(void **state)
{
    (void)state;
    int land = 0, water = 0;

    for (int n = 0; n < 120; n++) {
        beach s;
        make(&s);
        for (uint32_t j = 0; j + 1 < s.grid.rows; j++) {
            for (uint32_t i = s.grid.span[j].first; i < s.grid.span[j].end; i++) {
                bool dry = true;
                for (uint32_t k = 0; k < 4; k++)
                    dry = dry && point_at(&s, i + (k & 1), j + (k >> 1)).depth <= 0;
                assert_int_equal(tp_grid_cell_is_dry(&s.grid, i, j), dry);
                land += dry;
                water += !dry;
            }
        }
        s.surface.coastal = NULL;
        assert_false(tp_grid_cell_is_dry(&s.grid, 0, 0));
        beach_free(&s);
    }
    assert_true(land > 50 && water > 100);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_are_coastal_points),
        cmocka_unit_test(slopes_are_those_between_neighbours),
        cmocka_unit_test(cells_on_land_are_told),
    };
    return cmocka_run_group_tests_name("view/coastal_grid", tests, NULL, NULL);
}
