/* SPDX-License-Identifier: MIT */
/* Grid vertices compared with the models in double precision; a vertex is the same for
 * every way of evaluation. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "view/grid.h"
#include "tests/lib/deep_water.h"
#include "tests/lib/camera.h"
#include "tests/lib/grids.h"

static uint64_t chance;

#define SIDE 40

/* A grid over deep water; the eye is anywhere above. */
typedef struct {
    tp_grid grid;
    void   *block;
    test_view    v;
    deep_water deep;
    tp_surface surface;
    tp_grid_view look;
} vertex_pond;

static void place(vertex_pond *p)
{
    p->surface.by = &tp_program_all.water;
    p->surface.deep = &p->deep.deep;
    p->surface.phases = p->deep.phases;
    p->look.projection = &p->v.projection;
    p->look.surface = &p->surface;
    p->look.width = p->v.width;
    p->look.height = p->v.height;
    tp_grid_evaluate_vertices(&p->grid, &p->look);
}

static void make(vertex_pond *p, deep_water deep, double cell, double reach)
{
    const tp_vec3 eye = { chance_fx(&chance, -500, 500), chance_fx(&chance, 0.5, 20),
                          chance_fx(&chance, -500, 500) };

    *p = (vertex_pond){ .deep = deep };
    p->v = view_of(eye, (tp_turn)random_next(&chance),
                   tp_turn_of_degrees(chance_fx(&chance, -60, 10)),
                   chance_fx(&chance, 30, 90), TP_FX(0.25), 640, 480);
    p->look.cell = (tp_fx)(cell * 65536);
    p->look.reach = (tp_fx)(reach * 65536);
    p->look.follow = true;
    p->block = grid_block(&p->grid, SIDE, SIDE, false);
    place(p);
}

static void pond_free(vertex_pond *p)
{
    free(p->block);
}

/* -- comparison with the models -------------------------------------------------------- */

/* World position of a grid vertex: its view coordinates along the projection's own axes. */
static ref_vec world_of(const test_view *v, const tp_view_vertex *c)
{
    const tp_dir3 axis[3] = { v->projection.right, v->projection.up, v->projection.ahead };
    const double way[3] = { c->x * LSB, c->y * LSB, c->depth * LSB };
    ref_vec p = v->ref.eye;

    for (int i = 0; i < 3; i++) {
        const ref_vec a = { axis[i].x / 1073741824.0, axis[i].y / 1073741824.0,
                            axis[i].z / 1073741824.0 };
        const double by = way[i] / ref_dot(a, a);
        p = (ref_vec){ p.x + by * a.x, p.y + by * a.y, p.z + by * a.z };
    }
    return p;
}

/* Multiplies the displacement of the waves by the fade; the normal follows. */
static ref_point faded(ref_point p, double x0, double z0, double fade, bool crossed)
{
    p.x = x0 + fade * (p.x - x0);
    p.y *= fade;
    p.z = z0 + fade * (p.z - z0);
    p.hx *= fade;
    p.hz *= fade;
    p.jxx = 1 - fade * (1 - p.jxx);
    p.jzz = 1 - fade * (1 - p.jzz);
    p.jxz *= fade;
    p.nx = p.hz * p.jxz - p.hx * p.jzz;
    p.ny = p.jxx * p.jzz - p.jxz * p.jxz;
    p.nz = p.hx * p.jxz - p.hz * p.jxx;
    return crossed ? p : ref_uncrossed(p);
}

/* Bound of the normal's error.  The normal is computed from sines and 16-bit numbers: each
 * product errs by 2^-16 of the number and by half a bit of its own format, two products for
 * each swell.  Slopes are in Q.12. */
static double coarse_normal_error(const deep_water *o, const tp_grid *grid,
                                  const ref_point *p, double x0, double z0)
{
    const double bit = ldexp(1, -grid->frame.tilt), e = 2 / 65536.0;
    double h = 0, j = 1e-8;

    for (int i = 0; i < o->ref.count; i++) {
        const ref_wave *w = &o->ref.wave[i];
        const double turn = e + phase_error(o, i, x0, z0) + SINE;
        h += w->k * w->amplitude * turn_most(w) * turn + bit + w->k * LSB;
        j += w->q * turn + 1 / 32768.0;
    }
    const double tilt = fabs(p->hx) + fabs(p->hz);
    const double size = fabs(p->jxx) + fabs(p->jxz) + fabs(p->jzz);
    const double n = 2 * (h * size + j * tilt + h * j) + 2 * j * size + j * j;
    const double length = sqrt(p->nx * p->nx + p->ny * p->ny + p->nz * p->nz);
    return asin(fmin(1, n / length)) + 3e-4;
}

/* A grid vertex anywhere in the grid, with its slopes. */
static tp_view_vertex corner_of(const vertex_pond *p, uint32_t i, uint32_t j)
{
    const bool still = p->grid.column[i].fade == 0 || p->grid.row[j].fade == 0;
    tp_vertex_row row = { .line = p->grid.row[j] };
    tp_grid_vertex vertex;

    tp_vertex_z_to_view(&p->grid.frame, row.line.place, row.rest);
    tp_vertex_set_row(&p->grid.frame, &row, true);
    tp_vertex_evaluate_batch(&p->grid.frame, &p->grid.columns, &row, i, 1, still, &vertex);
    tp_view_vertex c =
        tp_vertex_make_view_vertex(&p->grid.frame, &p->grid.columns, &row, i, still);
    c.n[0] = vertex.slope_x;
    c.n[1] = vertex.slope_z;
    return c;
}

static void compare(vertex_pond *p, uint32_t i, uint32_t j, bool usual, errors *e)
{
    const tp_grid_line *column = &p->grid.column[i], *row = &p->grid.row[j];
    const double x0 = column->place * LSB, z0 = row->place * LSB;
    const double fade = column->fade * LSB * row->fade * LSB;
    const ref_point want = faded(ref_at_rest(&p->deep.ref, p->deep.ref_phases, x0, z0), x0,
                                 z0, fade, p->deep.deep.crossed);
    const tp_view_vertex c = corner_of(p, i, j);
    const tp_surface_point slopes = { .slope_x = c.n[0] * 16, .slope_z = c.n[1] * 16 };
    const ref_vec got = world_of(&p->v, &c);
    const double height = got.y - want.y;
    const double off = fmax(fabs(got.x - want.x), fabs(got.z - want.z));
    const double angle = normal_angle(&want, &slopes);
    /* Three view coordinates to an LSB, scaled by 1/2 at least, on axes of Q.30. */
    const double seen = 4 * LSB + 2e-9 * (fabs(got.x - p->v.ref.eye.x)
                                          + fabs(got.z - p->v.ref.eye.z));

    measure_add(&e->height, height * 1000, (int64_t)p->deep.tick, i, j);
    measure_add(&e->place, off * 1000, (int64_t)p->deep.tick, i, j);
    measure_add(&e->normal, angle * 180 / PI, (int64_t)p->deep.tick, i, j);
    assert_true(fabs(height) <= height_error(&p->deep, x0, z0) + seen);
    assert_true(off <= place_error(&p->deep, x0, z0) + seen);
    assert_true(angle <= coarse_normal_error(&p->deep, &p->grid, &want, x0, z0));
    if (usual) {
        assert_true(fabs(height) < 0.25e-3);
        assert_true(angle * 180 / PI < 0.02);
    }
    assert_int_equal(c.s, column->place);
    assert_int_equal(c.t, row->place);
}

static void compare_some(vertex_pond *p, bool usual, errors *e)
{
    for (int k = 0; k < 40; k++)
        compare(p, random_below(&chance, SIDE), random_below(&chance, SIDE), usual, e);
}

/* Up to eight waves of 2 m with steepnesses up to 0.7, over ten years. */
static void usual_seas_are_right_to_a_quarter_millimetre_and_a_fiftieth_of_a_degree(
    void **state)
{
    (void)state;
    errors e = errors_of("usual height", "usual place", "usual normal");

    for (int n = 0; n < 600; n++) {
        vertex_pond p;
        make(&p, deep_water_usual(&chance, 8, chance_double(&chance, 0, 0.7)),
             chance_double(&chance, 0.2, 5), n % 2 ? 0 : 300);
        compare_some(&p, true, &e);
        pond_free(&p);
    }
    errors_print(&e);
}

static void any_legal_sea_follows_the_models(void **state)
{
    (void)state;
    errors e = errors_of("any height", "any place", "any normal");

    for (int n = 0; n < 600; n++) {
        vertex_pond p;
        make(&p, deep_water_any(&chance, TP_WAVES), chance_double(&chance, 0.05, 20),
             n % 2 ? 0 : 4000);
        compare_some(&p, false, &e);
        pond_free(&p);
    }
    errors_print(&e);
}

static void sharpened_seas_follow_the_models(void **state)
{
    (void)state;
    errors e = errors_of("sharp height", "sharp place", "sharp normal");

    for (int n = 0; n < 400; n++) {
        vertex_pond p;
        deep_water deep =
            n % 2 ? deep_water_any(&chance, TP_WAVES) : deep_water_usual(&chance, 8, 0.5);
        deep_water_sharpen(&chance, &deep);
        make(&p, deep, chance_double(&chance, 0.2, 5), n % 4 < 2 ? 0 : 300);
        compare_some(&p, false, &e);
        pond_free(&p);
    }
    errors_print(&e);
}

static void sines_of_phases_are_right_to_28_bits(void **state)
{
    (void)state;
    measure error = { .what = "sine, cosine", .unit = "of 2^30" };

    for (int n = 0; n < 300000; n++) {
        const tp_turn angle = (tp_turn)random_next(&chance);
        const tp_vertex_sincos got = tp_vertex_sincos_from_angle(angle);
        const double th = angle / 4294967296.0 * 2 * PI;
        measure_add(&error, got.sin - sin(th) * 1073741824.0, angle, 0, 0);
        measure_add(&error, got.cos - cos(th) * 1073741824.0, angle, 1, 0);
    }
    measure_print(&error);
    assert_true(error.worst < 8);
}

/* -- equal bits ------------------------------------------------------------------------ */

/* A row in runs of any lengths gives the same as vertex by vertex. */
static void where_a_run_begins_does_not_show(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        vertex_pond p;
        tp_vertex_row row;
        tp_grid_vertex whole[SIDE], parts[SIDE];
        deep_water deep = deep_water_any(&chance, TP_WAVES);
        if (n % 4 == 0)
            deep_water_sharpen(&chance, &deep);
        make(&p, deep, chance_double(&chance, 0.2, 5), 0);
        row.line = p.grid.row[random_below(&chance, SIDE)];
        tp_vertex_z_to_view(&p.grid.frame, row.line.place, row.rest);
        tp_vertex_set_row(&p.grid.frame, &row, true);
        memset(whole, 0, sizeof whole);
        memset(parts, 0, sizeof parts);
        for (uint32_t i = 0; i < SIDE; i++)
            tp_vertex_evaluate_batch(&p.grid.frame, &p.grid.columns, &row, i, 1, false,
                                     &whole[i]);
        for (uint32_t i = 0, count; i < SIDE; i += count) {
            count = 1 + random_below(&chance, TP_VERTEX_BATCH);
            count = count < SIDE - i ? count : SIDE - i;
            tp_vertex_evaluate_batch(&p.grid.frame, &p.grid.columns, &row, i, count, false,
                                   &parts[i]);
        }
        assert_memory_equal(whole, parts, sizeof whole);
        pond_free(&p);
    }
}

/* -- models on top of the swells ------------------------------------------------------- */

/* A ring raises a grid vertex by its height at the displaced position and adds its slopes,
 * less where the mesh fades the ring's waves.  The position is read from the view, to 4
 * LSB. */
static void rings_lie_on_the_displaced_water(void **state)
{
    (void)state;
    int raised = 0, faded = 0;

    for (int n = 0; n < 200; n++) {
        vertex_pond p;
        deep_water deep = deep_water_usual(&chance, 4, 0.5);
        if (n % 4 == 0)
            deep_water_sharpen(&chance, &deep);
        make(&p, deep, 0.5, n % 2 ? 0 : 300);
        const tp_ring ring = {
            .x = p.grid.column[SIDE / 2].place, .z = p.grid.row[SIDE / 2].place,
            .amplitude = TP_FX(0.3), .length = 4 * TP_FX_ONE, .speed = TP_FX_ONE,
            .decay = 10 * TP_FX_ONE, .spread = 10 * TP_FX_ONE, .attack = TP_FX(0.1),
        };
        tp_ring_now now;
        assert_true(tp_ring_evaluate(
            &ring, (int64_t)(60 + random_below(&chance, 120)) << 16, &now));
        for (int k = 0; k < 100; k++) {
            const uint32_t i = random_below(&chance, SIDE), j = random_below(&chance, SIDE);
            p.surface.rings = 0;
            const tp_view_vertex still = corner_of(&p, i, j);
            p.surface.ring = &now;
            p.surface.rings = 1;
            const tp_view_vertex c = corner_of(&p, i, j);
            const ref_vec a = world_of(&p.v, &still), b = world_of(&p.v, &c);
            const tp_height_slope want = tp_ring_height_slope(
                &now, 1, (tp_fx)lround(a.x / LSB), (tp_fx)lround(a.z / LSB));
            assert_true(fabs(b.x - a.x) < 8 * LSB && fabs(b.z - a.z) < 8 * LSB);
            const double fade = p.grid.column[i].fade * LSB * p.grid.row[j].fade * LSB;
            assert_true(fabs(b.y - a.y - fade * want.height * LSB) < 12 * LSB);
            assert_true(fabs(16 * (c.n[0] - still.n[0]) - fade * want.slope_x) < 60);
            assert_true(fabs(16 * (c.n[1] - still.n[1]) - fade * want.slope_z) < 60);
            raised += fade * want.height > 1000;
            faded += fade < 1 && want.height > 1000;
        }
        pond_free(&p);
    }
    assert_true(raised > 100 && faded > 20);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(
            usual_seas_are_right_to_a_quarter_millimetre_and_a_fiftieth_of_a_degree),
        cmocka_unit_test(any_legal_sea_follows_the_models),
        cmocka_unit_test(sharpened_seas_follow_the_models),
        cmocka_unit_test(sines_of_phases_are_right_to_28_bits),
        cmocka_unit_test(where_a_run_begins_does_not_show),
        cmocka_unit_test(rings_lie_on_the_displaced_water),
    };
    return cmocka_run_group_tests_name("view/vertex", tests, NULL, NULL);
}
