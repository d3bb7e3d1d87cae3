/* SPDX-License-Identifier: MIT */
/* The water grid: visibility of its cells, contents of its vertices. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/clip.h"
#include "tests/lib/fans.h"

#define LSB (1 / 65536.0)

static uint64_t chance;

/* The grid of any legal scene; waves from the whole ranges of the table. */
static fan_sea any_sea(int most)
{
    fan_sea s = { .v = view_any(&chance) };
    const int count = chance_int(&chance, 0, 6);

    fan_sea_lay_out_grid(&s, (uint32_t)chance_int(&chance, 64, most));
    fan_sea_make_swells(&s, count, false, &chance);
    return s;
}

/* -- grid vertices ------------------------------------------------------------------- */

/* The four corners of each possibly visible cell are evaluated, and no corner
 * needlessly. */
static void every_corner_of_a_seen_cell_is_there(void **state)
{
    (void)state;
    uint64_t cells = 0, vertices = 0;

    for (int n = 0; n < 150; n++) {
        fan_sea p = any_sea(2450);
        fan_sea_place(&p);
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
        free(p.block);
    }
    printf("    %" PRIu64 " cells, %" PRIu64 " vertices\n", cells, vertices);
    assert_true(cells > 1000);
}

/* -- visibility ---------------------------------------------------------------------- */

/* True if a triangle of three grid vertices shows in the picture, in double precision.  x
 * is scaled to make the picture square. */
static bool is_seen(const fan_sea *p, const uint32_t at[3][2])
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
        fan_sea p = any_sea(800);
        fan_sea_place(&p);
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
        free(p.block);
    }
    printf("    %d cells show, %d are taken\n", seen, taken);
    assert_true(seen > 1000);
}

static void boxes_hold_their_cells(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        fan_sea p = any_sea(1400);
        fan_sea_place(&p);
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
        free(p.block);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_corner_of_a_seen_cell_is_there),
        cmocka_unit_test(no_cell_that_shows_is_left_out),
        cmocka_unit_test(boxes_hold_their_cells),
    };
    return cmocka_run_group_tests_name("view/grid", tests, NULL, NULL);
}
