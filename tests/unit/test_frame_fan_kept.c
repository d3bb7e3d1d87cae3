/* SPDX-License-Identifier: MIT */
/* A fan keeps its law, rows and slope variance while their numbers stay the same: each number
 * that determines them makes them new, and a kept fan has the bits of a fresh fan. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <cmocka.h>
#include "tests/lib/camera.h"
#include "tests/lib/deep_water.h"
#include "tests/lib/tilings.h"
#include "view/fan.h"

static uint64_t chance;
static const tp_assets none;

/* -- a law --------------------------------------------------------------------------- */

static void assert_same_law(const tp_fan_law *a, const tp_fan_law *b)
{
    assert_memory_equal(&a->right, &b->right, sizeof a->right);
    assert_int_equal(a->height, b->height);
    assert_int_equal(a->last, b->last);
    assert_int_equal(a->farthest, b->farthest);
    assert_int_equal(a->wide, b->wide);
    assert_int_equal(a->waves_end, b->waves_end);
    assert_int_equal(a->start, b->start);
    assert_int_equal(a->dense, b->dense);
    assert_int_equal(a->length, b->length);
    assert_int_equal(a->tail, b->tail);
    assert_int_equal(a->rows, b->rows);
    assert_int_equal(a->cols, b->cols);
    assert_ptr_equal(a->walls, b->walls);
}

typedef struct {
    test_view   v;
    tp_fan_view view;
    uint32_t    vertices;
} law_input;

static law_input any_input(void)
{
    law_input in = { .v = view_any(&chance),
                     .vertices = (uint32_t)chance_int(&chance, 64, 6000) };

    in.view = (tp_fan_view){
        .width = in.v.width, .height = in.v.height,
        .half_longest = chance_fx(&chance, 1, 200), .shortest = chance_fx(&chance, 0.5, 20),
        .high = chance_fx(&chance, 0, 4), .aside = chance_fx(&chance, 0, 4),
        .land = chance_fx(&chance, -20, 2), .detail = chance_fx(&chance, 0.1, 1),
        .detail_end = chance_fx(&chance, 1, 300),
        .walls = random_below(&chance, 2) ? &tp_fan_tank : NULL,
        .sides = { chance_fx(&chance, -9, -1), chance_fx(&chance, 1, 9),
                   chance_fx(&chance, -9, -1), chance_fx(&chance, 1, 9) },
    };
    return in;
}

/* Changes number n by `by`; false after the last number. */
static bool change_number(law_input *in, int n, int32_t by)
{
    tp_projection *p = &in->v.projection;
    tp_fan_view *v = &in->view;
    int32_t *const numbers[] = {
        &v->half_longest, &v->shortest, &v->high, &v->aside, &v->land, &v->detail,
        &v->sides.x0, &v->sides.x1, &v->sides.z0, &v->sides.z1, &p->eye.y, &p->focal,
        &p->turn.x.x, &p->turn.x.y, &p->turn.x.z, &p->turn.y.x, &p->turn.y.y, &p->turn.y.z,
        &p->turn.z.x, &p->turn.z.y, &p->turn.z.z,
    };
    const int count = sizeof numbers / sizeof *numbers;

    if (n < count)
        *numbers[n] += by;
    else if (n == count)
        v->width++;
    else if (n == count + 1)
        v->height++;
    else if (n == count + 2)
        in->vertices++;
    else if (n == count + 3)
        v->walls = v->walls ? NULL : &tp_fan_tank;
    else if (n == count + 4)
        v->detail_end += (int64_t)by * 65536 * 65536;
    else if (n == count + 5)
        v->detail_end += by;
    p->ahead = (tp_dir3){ -p->turn.z.x, -p->turn.z.y, -p->turn.z.z };
    return n <= count + 5;
}

static void each_number_solves_the_law_again(void **state)
{
    uint32_t changes = 0;

    (void)state;
    for (int round = 0; round < 20; round++) {
        law_input in = any_input();
        tp_fan_law law;
        int32_t key[TP_FAN_KEY] = { 0 };
        in.view.projection = &in.v.projection;
        assert_true(tp_fan_law_update(&law, key, &in.view, in.vertices));
        for (int n = 0; change_number(&in, n, round % 2 ? 1 : -1); n++, changes++) {
            assert_true(tp_fan_law_update(&law, key, &in.view, in.vertices));
            const tp_fan_law fresh = tp_fan_law_solve(&in.view, in.vertices);
            assert_same_law(&law, &fresh);
            assert_false(tp_fan_law_update(&law, key, &in.view, in.vertices));
            assert_same_law(&law, &fresh);
        }
        in.v.projection.eye.x += 65536;
        in.v.projection.eye.z -= 3;
        const tp_fan_law fresh = tp_fan_law_solve(&in.view, in.vertices);
        assert_false(tp_fan_law_update(&law, key, &in.view, in.vertices));
        assert_same_law(&law, &fresh);
    }
    assert_int_equal(changes, 20 * TP_FAN_KEY);
}

/* -- a grid -------------------------------------------------------------------------- */

typedef struct {
    tp_grid grid;
    tp_filtered_waves filtered;
    void   *block;
} kept_grid;

/* The numbers of a camera, a sea and a scene's pools; a projection is made of them. */
typedef struct {
    tp_vec3  eye;
    tp_turn  heading, pitch, roll;
    tp_fx    fov, near;
    uint32_t width, height;
    tp_wave  wave[TP_WAVES];
    uint32_t waves;
    int64_t  more[2];           /* turns added to swell 1, which move no row */
    int32_t  steeper[2];        /* slopes added to it */
    tp_water_detail detail;
} numbers;

static void lay_out(kept_grid *g, uint32_t vertices, uint32_t swells, bool streams)
{
    tp_arena count = tp_arena_init(NULL, 0);

    tp_grid_layout(&g->grid, &count, vertices, swells, streams);
    g->block = malloc(count.used);
    assert_non_null(g->block);
    memset(g->block, 0xa5, count.used);
    tp_arena arena = tp_arena_init(g->block, count.used);
    tp_grid_layout(&g->grid, &arena, vertices, swells, streams);
    g->grid.exact_waves = &tp_draw_exact_waves;
    g->grid.exact_corners = &tp_draw_exact_corners;
    assert_false(arena.failed);
    tp_filtered_waves_clear(&g->filtered);
}

/* Rows of the turn by heading and pitch, turned by a roll. */
static tp_rotation rolled(tp_rotation turn, tp_turn roll)
{
    const int64_t s = tp_sin(roll), c = tp_cos(roll);
    const tp_dir3 x = turn.x, y = turn.y;

    turn.x = (tp_dir3){ (tp_q30)((x.x * c + y.x * s) >> 30), (tp_q30)((x.y * c + y.y * s) >> 30),
                        (tp_q30)((x.z * c + y.z * s) >> 30) };
    turn.y = (tp_dir3){ (tp_q30)((y.x * c - x.x * s) >> 30), (tp_q30)((y.y * c - x.y * s) >> 30),
                        (tp_q30)((y.z * c - x.z * s) >> 30) };
    return turn;
}

/* A wave that hides no plane of the view by its displacement. */
static tp_wave low_wave(void)
{
    tp_wave wave = chance_wave(&chance);

    wave.amplitude = chance_scale(&chance, 0.001, 0.05);
    wave.length = chance_scale(&chance, 0.5, 50);
    return wave;
}

static void add_to_swell(tp_swell *w, const numbers *n)
{
    w->turns_x += n->more[0];
    w->turns_z += n->more[1];
    w->slope_x += n->steeper[0];
    w->slope_z += n->steeper[1];
}

/* Changes one number by little or much, or none. */
static void change_any(numbers *n)
{
    const bool little = random_below(&chance, 2);
    const tp_fx by = little ? (tp_fx)chance_int(&chance, -2, 2) : chance_fx(&chance, -3, 3);
    const tp_turn turn = little ? (tp_turn)chance_int(&chance, -2, 2)
                                : tp_turn_of_degrees(chance_fx(&chance, -40, 40));
    const uint32_t which = random_below(&chance, 20);
    tp_wave *wave = &n->wave[random_below(&chance, n->waves + 1)];
    tp_fx *const place[] = { &n->eye.x, &n->eye.y, &n->eye.z };
    tp_turn *const turns[] = { &n->heading, &n->pitch, &n->roll };

    if (which < 3)
        *place[which] += by;
    else if (which < 6)
        *turns[which - 3] += turn;
    else if (which == 6)
        n->fov = tp_clamp(n->fov + by, 20 * TP_FX_ONE, 100 * TP_FX_ONE);
    else if (which == 7)
        n->near = chance_scale(&chance, 0.05, 10);
    else if (which == 8)
        n->width = (uint32_t)chance_int(&chance, 16, 640);
    else if (which == 9)
        n->height = (uint32_t)chance_int(&chance, 16, 480);
    else if (which == 10)
        wave->amplitude = chance_scale(&chance, 0.001, 0.05);
    else if (which == 11)
        *wave = low_wave();
    else if (which == 12)
        n->waves = random_below(&chance, 7);
    else if (which == 13)
        n->detail.length = random_below(&chance, 2) ? chance_fx(&chance, 0.1, 2) : 0;
    else if (which == 14)
        n->detail.sides.x1 += tp_abs(by);
    else if (which == 15)
        n->detail.walls = n->detail.walls ? NULL : &tp_fan_tank;
    else if (which == 16)
        n->more[random_below(&chance, 2)] += (int64_t)by * 1024;
    else if (which == 17)
        n->steeper[random_below(&chance, 2)] += by * 16;
}

static void place(kept_grid *g, const tp_grid_view *view)
{
    g->grid.surface = view->surface;
    tp_grid_evaluate_vertices(&g->grid, view);
    tp_fan_fill_variance(&g->grid, &g->filtered);
}

static void assert_same_rows(const tp_grid *a, const tp_grid *b)
{
    assert_true(a->cols == b->cols && a->rows == b->rows && a->blocks == b->blocks);
    assert_int_equal(a->vertices, b->vertices);
    assert_true(a->fan->detail == b->fan->detail && a->fan->end == b->fan->end
                && a->fan->end_column == b->fan->end_column);
    assert_memory_equal(a->fan->row, b->fan->row, a->rows * sizeof *a->fan->row);
    assert_memory_equal(a->span, b->span, (a->rows - 1) * sizeof *a->span);
    for (uint32_t j = 0; !a->streams && j < a->rows; j++) {
        const tp_grid_span s = tp_grid_needed_vertices(a, j);
        for (uint32_t i = s.first; i < s.end; i++) {
            const tp_grid_vertex *p = &a->vertex[j * a->cols + i];
            const tp_grid_vertex *q = &b->vertex[j * a->cols + i];
            assert_true(p->u == q->u && p->slope_x == q->slope_x && p->slope_z == q->slope_z);
            assert_true(p->u == TP_GRID_NEEDS_CLIP || (p->v == q->v && p->zi == q->zi));
        }
    }
}

/* Places both grids for the numbers; returns true if the kept grid kept its rows. */
static bool compare(kept_grid *kept, kept_grid *fresh, const numbers *n, uint64_t tick)
{
    tp_deep_water deep;
    tp_turn phases[TP_WAVES];
    test_view v = view_of(n->eye, n->heading, n->pitch, n->fov, n->near, n->width, n->height);
    const tp_surface surface = { .by = &tp_program_all.water, .deep = &deep,
                                 .phases = phases };
    const tp_grid_view view = { .projection = &v.projection, .surface = &surface,
                                .width = n->width, .height = n->height,
                                .vertices = kept->grid.fan->vertices, .detail = n->detail };

    tp_projection_init_turned(&v.projection, n->eye, rolled(v.projection.turn, n->roll),
                              n->fov, n->near, n->width, n->height);
    tp_deep_water_init(&deep, n->wave, n->waves, TP_FX(9.81));
    add_to_swell(&deep.swell[1], n);
    if (random_below(&chance, 8) == 0)          /* by a renderer without a grid */
        tp_filtered_waves_clear(&kept->filtered);
    tp_deep_water_phases(&deep, tick, 0, phases);
    place(kept, &view);
    place(fresh, &view);
    assert_true(fresh->grid.fan->moved);
    assert_same_law(&kept->grid.fan->law, &fresh->grid.fan->law);
    assert_same_rows(&kept->grid, &fresh->grid);
    assert_memory_equal(kept->filtered.at, fresh->filtered.at, sizeof fresh->filtered.at);
    return !kept->grid.fan->moved;
}

/* In every other walk the grid has no room to remember all swells. */
static void a_kept_grid_has_the_bits_of_a_fresh_grid(void **state)
{
    uint32_t stayed = 0, moved = 0;

    (void)state;
    for (int walk = 0; walk < 30; walk++) {
        const uint32_t vertices = (uint32_t)chance_int(&chance, 64, 2500);
        const uint32_t swells = walk % 2 ? TP_WAVES : 2;
        numbers n = { .eye = { chance_fx(&chance, -50, 50), chance_scale(&chance, 0.5, 30),
                               chance_fx(&chance, -50, 50) },
                      .heading = (tp_turn)random_next(&chance), .fov = 60 * TP_FX_ONE,
                      .pitch = tp_turn_of_degrees(chance_fx(&chance, -60, 5)),
                      .near = TP_FX(0.25), .width = 320, .height = 240, .waves = 4,
                      .detail.sides = { -TP_FX_ONE, TP_FX_ONE, -TP_FX_ONE, TP_FX_ONE } };
        kept_grid kept;
        for (int i = 0; i < TP_WAVES; i++)
            n.wave[i] = low_wave();
        lay_out(&kept, vertices, swells, walk % 3 == 0);
        for (uint64_t step = 0; step < 100; step++) {
            kept_grid fresh;
            lay_out(&fresh, vertices, swells, walk % 3 == 0);
            if (step % 3)
                change_any(&n);
            const bool stays = compare(&kept, &fresh, &n, step);
            stayed += stays;
            moved += !stays;
            assert_true(stays || step % 3 || step == 0);
            free(fresh.block);
        }
        free(kept.block);
    }
    printf("# rows stayed %u times and moved %u times\n", stayed, moved);
    assert_true(stayed > 1000 && moved > 1000);
}

/* -- pictures ------------------------------------------------------------------------ */

enum { WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT, TILINGS = 3 };

static tp_scene any_scene(int n)
{
    tp_scene s;

    tp_scene_level(&s);
    s.grid.vertices = chance_int(&chance, 200, 2000);
    s.camera.y = chance_fx(&chance, 2, 12);
    s.camera.pitch = chance_fx(&chance, -40, 0);
    s.quality.visibility = n % 4 == 0   ? TP_VISIBILITY_TRIANGLES
                           : n % 4 == 1 ? TP_VISIBILITY_FLAT
                           : n % 4 == 2 ? TP_VISIBILITY_PROJECTED : TP_VISIBILITY_ROWS;
    for (int i = 0; i < 3; i++) {
        s.wave[i] = chance_wave(&chance);
        s.wave[i].amplitude = chance_scale(&chance, 0.02, 0.3);
        s.wave[i].exponent = 1;
    }
    if (n % 3 == 1) {
        s.pool.cols = s.pool.rows = 40;
        s.pool.cell = TP_FX(0.25);
        s.pool.splash_interval = TP_FX(0.5);
        s.pool.splash_height = TP_FX(0.3);
        s.pool.splash_width = TP_FX(1);
        s.tank.kind = n % 2 ? TP_TANK_GLASS : TP_TANK_STONE;
        s.tank.sea = n % 2 == 0;
        s.tank.depth = 2 * TP_FX_ONE;
    } else if (n % 3 == 2) {
        s.drops.count = s.drops.rings = 8;
        s.drops.radius = TP_FX(0.05);
        s.drops.interval = TP_FX(0.2);
        s.drops.scatter_radius = TP_FX(2);
        s.drops.y = TP_FX(1);
    }
    return s;
}

/* A camera that stays for two pictures, then moves, turns or rolls by one number. */
static void move_camera(tp_world *world, int step, tp_vec3 *eye, tp_turn turn[3])
{
    tp_fx *const place[] = { &eye->x, &eye->y, &eye->z };
    const uint32_t which = random_below(&chance, 6);

    if (step % 2 == 0 && which < 3)
        *place[which] += chance_fx(&chance, -1, 1);
    else if (step % 2 == 0)
        turn[which - 3] += tp_turn_of_degrees(chance_fx(&chance, -9, 9));
    tp_world_set_camera(world, *eye, turn[0], turn[1], turn[2]);
}

static void walk(int n, uint32_t *vertices, uint32_t *compared)
{
    static const uint32_t size[TILINGS][2] = { { 0, HEIGHT }, { 0, 8 }, { 32, 24 } };
    static uint32_t picture[TILINGS][PIXELS], fresh[PIXELS];
    tp_scene s = any_scene(n);
    tp_world *world = scene_world(&s, &none);
    test_frame kept[TILINGS];
    tp_config c = { .width = WIDTH, .height = HEIGHT, .format = TP_FORMAT_XRGB8888 };
    tp_vec3 eye = { s.camera.x, s.camera.y, s.camera.z };
    tp_turn turn[3] = { 0, tp_turn_of_degrees(s.camera.pitch), 0 };

    assert_non_null(world);
    for (int k = 0; k < TILINGS; k++) {
        c.tile_width = size[k][0];
        c.tile_height = size[k][1];
        kept[k] = frame_of(&s, &none, &c);
    }
    for (int step = 0; step < 12; step++) {
        static const tp_input still;
        tp_world_step(&tp_program_all, world, &s, &still);
        move_camera(world, step, &eye, turn);
        test_frame again = frame_of(&s, &none, &c);
        frame_draw_picture(&again, world, fresh);
        for (int k = 0; k < TILINGS; k++) {
            frame_draw_picture(&kept[k], world, picture[k]);
            if (again.frame->visibility != kept[k].frame->visibility)
                continue;               /* a grid streamed for these tiles alone */
            assert_memory_equal(picture[k], fresh, sizeof fresh);
            ++*compared;
        }
        *vertices += again.frame->stats.vertices;
        frame_free(&again);
    }
    for (int k = 0; k < TILINGS; k++)
        frame_free(&kept[k]);
    free(world);
}

static void frames_that_live_on_draw_as_fresh_frames(void **state)
{
    uint32_t vertices = 0, compared = 0;

    (void)state;
    for (int n = 0; n < 48; n++)
        walk(n, &vertices, &compared);
    printf("# %u pictures of %u vertices\n", compared, vertices);
    assert_true(compared > 48 * 12 && vertices > 10000);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_number_solves_the_law_again),
        cmocka_unit_test(a_kept_grid_has_the_bits_of_a_fresh_grid),
        cmocka_unit_test(frames_that_live_on_draw_as_fresh_frames),
    };
    return cmocka_run_group_tests_name("frame/fan_kept", tests, NULL, NULL);
}
