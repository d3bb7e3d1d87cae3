/* SPDX-License-Identifier: MIT */
/* The water grid: positions of its lines, visibility of its cells, contents of its
 * vertices. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/clip.h"
#include "view/grid.h"
#include "tests/lib/camera.h"
#include "tests/lib/grids.h"

#define LSB (1 / 65536.0)

static uint64_t chance;

/* A grid with its memory and all the data of its view. */
/* A grid with its memory and all the data of its view. */
typedef struct {
    tp_grid grid;
    void   *block;
    test_view    v;
    tp_deep_water  deep;
    tp_turn phases[TP_WAVES];
    tp_surface surface;
    tp_grid_view look;
} pond;

static void place(pond *p)
{
    p->look.projection = &p->v.projection;
    p->surface =
        (tp_surface){ .by = &tp_program_all.water, .deep = &p->deep, .phases = p->phases };
    p->look.surface = &p->surface;
    p->look.width = p->v.width;
    p->look.height = p->v.height;
    tp_grid_evaluate_vertices(&p->grid, &p->look);
}

/* Longest cell that keeps a grid within 16 km, the frame's bound. */
static tp_fx cell_most(uint32_t cols, uint32_t rows)
{
    const uint32_t lines = cols > rows ? cols : rows;
    return (tp_fx)(16000u * 65536u / (lines - 1));
}

static uint32_t any_lines(void)
{
    static const uint32_t usual[] = { 2, 3, 7, 8, 9, 15, 16, 17, 100, 1024 };
    return random_below(&chance, 2) ? usual[random_below(&chance, 10)]
                                    : (uint32_t)chance_int(&chance, 2, 120);
}

/* The grid of any legal scene; waves from the whole ranges of the table. */
static pond any_pond(uint32_t cols, uint32_t rows)
{
    pond p = { .v = view_any(&chance) };
    tp_wave waves[TP_WAVES];
    const int count = chance_int(&chance, 0, 6);

    p.block = grid_block(&p.grid, cols, rows, false);
    for (int i = 0; i < count; i++)
        waves[i] = chance_wave(&chance);
    tp_deep_water_init(&p.deep, waves, (uint32_t)count, TP_FX(9.81));
    tp_deep_water_phases(&p.deep, random_next(&chance) >> 20, 0, p.phases);
    p.look.cell = chance_scale(&chance, 0.05, 50);
    p.look.cell = tp_clamp(p.look.cell, 0, cell_most(cols, rows));
    p.look.reach = random_below(&chance, 3) ? chance_scale(&chance, 0.1, 16000) : 0;
    if (random_below(&chance, 4) == 0)
        p.look.reach = 16000 * TP_FX_ONE;
    p.look.follow = random_below(&chance, 4) > 0;
    return p;
}

static void pond_free(pond *p)
{
    free(p->block);
}

/* -- grid lines ---------------------------------------------------------------------- */

static uint32_t flank_of(const pond *p, uint32_t count)
{
    const uint32_t eighth = count / 8 < TP_GRID_FLANK ? count / 8 : TP_GRID_FLANK;
    return p->look.reach > 0 ? eighth : 0;
}

static void check_lines(const pond *p, const tp_grid_line *line, uint32_t count)
{
    const uint32_t flank = flank_of(p, count), last = count - 1 - flank;
    const double core = (double)p->look.cell * (last - flank);
    double ratio = 0;

    for (uint32_t k = 0; k + 1 < count; k++) {
        const int64_t step = (int64_t)line[k + 1].place - line[k].place;
        assert_true(step > 0);
        if (k >= flank && k < last)
            assert_int_equal(step, p->look.cell);
    }
    for (uint32_t k = last; k + 2 < count; k++) {       /* by one ratio, truncated */
        const double a = line[k + 1].place - (double)line[k].place;
        const double b = line[k + 2].place - (double)line[k + 1].place;
        const double cut = 1 / a + 1 / 65536.0 + b / (a * a);
        assert_true(b >= a - 1);
        assert_true(ratio == 0 || fabs(b / a - ratio) <= 2 * cut + ratio / a);
        ratio = b / a;
    }
    for (uint32_t k = 0; k < count; k++) {              /* the same in both directions */
        assert_true(labs((long)line[k].place - line[0].place
                         - ((long)line[count - 1].place - line[count - 1 - k].place))
                    <= 1);
        assert_in_range(line[k].fade, 0, TP_FX_ONE);
        assert_int_equal(line[k].fade, line[count - 1 - k].fade);
        if (flank > 0 && (k <= flank || k >= last))
            assert_int_equal(line[k].fade, 0);
    }
    if (flank == 0)
        assert_int_equal(line[0].fade, TP_FX_ONE);
    /* The grid extends as far as requested beyond its middle, at most 16 km from the
     * centre.  An error of 2^-16 in the ratio counts `flank` times; the truncation of a
     * step, up to one unit, is in all later steps: of reach/cell the next step makes
     * 1/ratio, the second 1/ratio^2 and so on.  A step grows by a factor of 256 at most. */
    const double way = (line[count - 1].place - (double)line[0].place) / 2;
    const double reach = fmin(p->look.reach, 16000 * 65536.0 - core / 2);
    const double most = 256.0 * p->look.cell, cuts = fmin(flank, 1 / (ratio - 1));
    if (flank > 1 && reach > flank * (double)p->look.cell
        && reach / flank < most)
        assert_true(fabs(way - core / 2 - reach)
                    <= reach * flank / 65536.0 + cuts * reach / p->look.cell + 2);
    if (flank == 0)
        assert_true(fabs(way - core / 2) <= 1);
}

static void lines_grow_evenly_then_by_one_ratio(void **state)
{
    (void)state;
    for (int n = 0; n < 1500; n++) {
        pond p = any_pond(any_lines(), 2);
        place(&p);
        check_lines(&p, p.grid.column, p.grid.cols);
        check_lines(&p, p.grid.row, p.grid.rows);
        pond_free(&p);
    }
    for (uint32_t count = 2; count <= 1024; count += count < 20 ? 1 : 53) {
        pond p = any_pond(2, count);
        place(&p);
        check_lines(&p, p.grid.row, p.grid.rows);
        pond_free(&p);
    }
}

/* For any eye position, the middle's lines are the same lines of the world. */
static void a_grid_that_follows_moves_by_whole_cells(void **state)
{
    (void)state;
    for (int n = 0; n < 300; n++) {
        pond p = any_pond(any_lines(), any_lines());
        p.look.follow = true;
        if (p.grid.cols * p.grid.rows > 4000) {
            pond_free(&p);
            continue;
        }
        place(&p);
        const tp_fx cell = p.look.cell;
        const tp_fx first = p.grid.column[flank_of(&p, p.grid.cols)].place % cell;
        for (int k = 0; k < 5; k++) {
            p.v.projection.eye.x = chance_fx(&chance, -8000, 8000);
            p.v.projection.eye.z = chance_fx(&chance, -8000, 8000);
            place(&p);
            const tp_fx now = p.grid.column[flank_of(&p, p.grid.cols)].place % cell;
            assert_int_equal((now - first + 2 * (int64_t)cell) % cell, 0);
            /* The grid extends below the eye, also between its rear lines. */
            assert_true(p.grid.column[0].place <= p.v.projection.eye.x + 2 * cell);
            assert_true(p.grid.column[p.grid.cols - 1].place
                        >= p.v.projection.eye.x - 2 * cell);
        }
        pond_free(&p);
    }
}

static void a_grid_that_stays_lies_around_the_origin(void **state)
{
    (void)state;
    for (int n = 0; n < 300; n++) {
        pond p = any_pond(any_lines(), 9);
        p.look.follow = false;
        place(&p);
        const int64_t ends = (int64_t)p.grid.column[0].place
                           + p.grid.column[p.grid.cols - 1].place;
        assert_true(ends >= -2 && ends <= 2);
        pond_free(&p);
    }
}

/* The smoothstep in double precision; x and the result are rounded to 16.16. */
static void waves_fade_alike_on_lines_and_between(void **state)
{
    (void)state;
    for (int n = 0; n < 1500; n++) {
        pond p = any_pond(any_lines(), 2);
        place(&p);
        const tp_grid_extent e = tp_grid_lines_extent(p.grid.cols, &p.look, false);
        for (uint32_t k = 0; k < p.grid.cols; k++)
            assert_true(abs(tp_grid_extent_wave_weight(&e, p.grid.column[k].place)
                            - p.grid.column[k].fade) <= 3);
        for (int k = 0; k < 100; k++) {
            const tp_fx at = k ? chance_fx(&chance, -16000, 16000) : TP_FX_MIN;
            const double edge = fmin((double)at - e.calm[0], (double)e.calm[1] - at);
            const double x = e.fading ? fmax(0, fmin(1, edge / e.fading)) : 1;
            const double want = x * x * (3 - 2 * x);
            assert_true(fabs(tp_grid_extent_wave_weight(&e, at) * LSB - want) <= 3 * LSB);
        }
        assert_true((e.fading == 0) == (flank_of(&p, p.grid.cols) == 0));
        pond_free(&p);
    }
}

/* -- grid vertices ------------------------------------------------------------------- */

/* Away from the fading edge a grid vertex is the point of the deep water itself.  x, y and
 * depth agree within the errors of both sines, 5e-6 of the wave heights, and within the two
 * bits that a wide view lacks.  Slopes are compared in test_view_vertex.c. */
static void vertices_are_points_of_deep_water(void **state)
{
    (void)state;
    int checked = 0, flat = 0;

    for (int n = 0; n < 200; n++) {
        pond p = any_pond((uint32_t)chance_int(&chance, 2, 60),
                          (uint32_t)chance_int(&chance, 2, 60));
        place(&p);
        const double reach = (p.deep.height + p.deep.max_displacement) * LSB;
        for (int k = 0; k < 200; k++) {
            const uint32_t i = random_below(&chance, p.grid.cols);
            const uint32_t j = random_below(&chance, p.grid.rows);
            const tp_grid_line *column = &p.grid.column[i], *row = &p.grid.row[j];
            const tp_view_vertex got = grid_corner(&p.grid, i, j);
            const tp_fx fade = tp_fx_mul(column->fade, row->fade);
            tp_surface_point at = { .position = { column->place, 0, row->place } };
            if (fade > 0 && fade < TP_FX_ONE)
                continue;
            if (fade)
                at = tp_deep_water_displace_point(&p.deep, p.phases, column->place,
                                                  row->place);
            tp_view_vertex want;
            tp_projection_view_vertex(&p.v.projection, at.position, &want);
            const double off = (p.grid.frame.wide ? 8 : 4) + 1.5 * reach / LSB * 1e-5;
            if (abs(want.x) < 31000 * TP_FX_ONE && abs(want.y) < 31000 * TP_FX_ONE) {
                assert_true(fabs((double)got.x - want.x) <= off);
                assert_true(fabs((double)got.y - want.y) <= off);
                assert_true(fabs((double)got.depth - want.depth) <= off);
            }
            assert_int_equal(got.s, column->place);
            assert_int_equal(got.t, row->place);
            checked++;
            flat += fade == 0;
        }
        pond_free(&p);
    }
    assert_true(checked > 1000 && flat > 100);
}

/* The four corners of each possibly visible cell are evaluated, and no corner
 * needlessly. */
static void every_corner_of_a_seen_cell_is_there(void **state)
{
    (void)state;
    uint64_t cells = 0, vertices = 0;

    for (int n = 0; n < 150; n++) {
        pond p = any_pond((uint32_t)chance_int(&chance, 2, 70),
                          (uint32_t)chance_int(&chance, 2, 70));
        place(&p);
        for (uint32_t j = 0; j + 1 < p.grid.rows; j++) {
            for (uint32_t i = p.grid.span[j].first; i < p.grid.span[j].end; i++) {
                cells++;
                for (uint32_t k = 0; k < 4; k++) {
                    const uint32_t x = i + (k & 1), y = j + (k >> 1);
                    const tp_grid_vertex *got = &p.grid.vertex[y * p.grid.cols + x];
                    const tp_view_vertex c = grid_corner(&p.grid, x, y);
                    int32_t u = TP_GRID_NEEDS_CLIP, w = got->v;
                    uint32_t zi = got->zi;
                    if (tp_projection_can_project(&p.v.projection, &c))
                        tp_projection_project(&p.v.projection, &c, &u, &w, &zi);
                    assert_int_equal(got->u, u);
                    assert_int_equal(got->v, w);
                    assert_int_equal(got->zi, zi);
                    assert_int_equal(got->slope_x, c.n[0]);
                    assert_int_equal(got->slope_z, c.n[1]);
                }
            }
        }
        vertices += p.grid.vertices;
        assert_true(p.grid.vertices <= p.grid.cols * p.grid.rows);
        pond_free(&p);
    }
    printf("    %" PRIu64 " cells, %" PRIu64 " vertices\n", cells, vertices);
    assert_true(cells > 1000);
}

/* -- visibility ---------------------------------------------------------------------- */

/* True if a triangle of three grid vertices shows in the picture, in double precision.  x
 * is scaled to make the picture square. */
static bool is_seen(const pond *p, const uint32_t at[3][2])
{
    const double tall = p->v.height / 2.0 / ldexp(1, p->v.projection.m);
    ref_clip_corner corner[3], left[8];

    for (int k = 0; k < 3; k++) {
        const tp_view_vertex c = grid_corner(&p->grid, at[k][0], at[k][1]);
        corner[k] = (ref_clip_corner){ c.x * LSB * p->v.height / p->v.width, c.y * LSB,
                                       c.depth * LSB };
    }
    return ref_clip(corner, left, p->v.ref.near, tall) >= 3;
}

static void no_cell_that_shows_is_left_out(void **state)
{
    (void)state;
    int seen = 0, taken = 0;

    for (int n = 0; n < 400; n++) {
        pond p = any_pond((uint32_t)chance_int(&chance, 2, 40),
                          (uint32_t)chance_int(&chance, 2, 40));
        place(&p);
        for (uint32_t j = 0; j + 1 < p.grid.rows; j++) {
            const tp_grid_span span = p.grid.span[j];
            assert_true(span.first <= span.end && span.end <= p.grid.cols - 1);
            taken += span.end - span.first;
            for (uint32_t i = 0; i + 1 < p.grid.cols; i++) {
                const uint32_t a[3][2] = { { i, j }, { i, j + 1 }, { i + 1, j + 1 } };
                const uint32_t b[3][2] = { { i, j }, { i + 1, j + 1 }, { i + 1, j } };
                if (!is_seen(&p, a) && !is_seen(&p, b))
                    continue;
                seen++;
                assert_true(span.first <= i && i < span.end);
            }
        }
        pond_free(&p);
    }
    printf("    %d cells show, %d are taken\n", seen, taken);
    assert_true(seen > 1000);
}

static void boxes_hold_their_cells(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        pond p = any_pond((uint32_t)chance_int(&chance, 2, 70),
                          (uint32_t)chance_int(&chance, 2, 40));
        place(&p);
        for (uint32_t j = 0; j + 1 < p.grid.rows; j++) {
            for (uint32_t i = p.grid.span[j].first; i < p.grid.span[j].end; i++) {
                const tp_grid_box *box =
                    &p.grid.box[j * p.grid.blocks + i / TP_GRID_BLOCK];
                for (uint32_t k = 0; k < 4; k++) {
                    const tp_grid_vertex *at
                        = &p.grid.vertex[(j + (k >> 1)) * p.grid.cols + i + (k & 1)];
                    if (at->u == TP_GRID_NEEDS_CLIP) {
                        assert_int_equal(box->x0, INT16_MIN);
                        assert_int_equal(box->y1, INT16_MAX);
                    } else {
                        assert_true(16 * box->x0 <= at->u && at->u <= 16 * box->x1 + 15);
                        assert_true(16 * box->y0 <= at->v && at->v <= 16 * box->y1 + 15);
                    }
                }
            }
        }
        pond_free(&p);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_grow_evenly_then_by_one_ratio),
        cmocka_unit_test(a_grid_that_follows_moves_by_whole_cells),
        cmocka_unit_test(a_grid_that_stays_lies_around_the_origin),
        cmocka_unit_test(waves_fade_alike_on_lines_and_between),
        cmocka_unit_test(vertices_are_points_of_deep_water),
        cmocka_unit_test(every_corner_of_a_seen_cell_is_there),
        cmocka_unit_test(no_cell_that_shows_is_left_out),
        cmocka_unit_test(boxes_hold_their_cells),
    };
    return cmocka_run_group_tests_name("view/grid", tests, NULL, NULL);
}
