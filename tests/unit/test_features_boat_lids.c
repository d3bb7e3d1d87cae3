/* SPDX-License-Identifier: MIT */
/* A lid keeps water out of the covered area and lets higher water in. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/tilings.h"
#include "tests/lib/frames.h"

enum { WIDTH = 160, HEIGHT = 120, FLOOR = 2 };

/* -- in the rasterizer ---------------------------------------------------------------- */

static void square(const test_tile *tile, int32_t side, uint32_t zi, uint32_t mark)
{
    const tp_screen_vertex p[4] = { { .u = 0, .v = 0, .zi = zi },
                                    { .u = 0, .v = side, .zi = zi },
                                    { .u = side, .v = side, .zi = zi },
                                    { .u = side, .v = 0, .zi = zi } };

    for (int k = 2; k < 4; k++) {
        if (mark == TP_MARK_SKY)
            tp_tri_depth_only(&tile->samples, &p[0], &p[k - 1], &p[k]);
        else if (mark == TP_MARK_WATER)
            tp_tri_water(&tile->samples, &p[0], &p[k - 1], &p[k]);
        else
            tp_tri_solid(&tile->samples, &p[0], &p[k - 1], &p[k], mark, 7, 16);
    }
}

static uint32_t mark_at(const test_tile *tile, int32_t x)
{
    return TP_MARK(tile->samples.key[tile_at(tile, x, x)]);
}

/* A solid of 8 px and a lid of 12 px before the solid; then water behind the lid, then
 * before the lid. */
static void a_lid_holds_water_back_only_before_solids(void **state)
{
    (void)state;
    test_tile tile = tile_of(0, 0, 16, 16, 0);

    square(&tile, 8 * 16, 1u << 28, TP_MARK_SOLID);
    const size_t at = tile_at(&tile, 3, 3);
    const uint32_t s = tile.samples.s[at], t = tile.samples.t[at], n = tile.samples.n[at];
    square(&tile, 12 * 16, 1u << 29, TP_MARK_SKY);
    assert_int_equal(mark_at(&tile, 3), TP_MARK_SOLID);
    assert_int_equal(mark_at(&tile, 10), TP_MARK_SKY);
    assert_int_equal(TP_ZI(tile.samples.key[at]), 1u << 29);
    assert_int_equal(tile.samples.key[tile_at(&tile, 10, 10)], 0);
    square(&tile, 16 * 16, 3u << 27, TP_MARK_WATER);
    assert_int_equal(mark_at(&tile, 3), TP_MARK_SOLID);
    assert_int_equal(mark_at(&tile, 10), TP_MARK_WATER);
    assert_true(tile.samples.s[at] == s && tile.samples.t[at] == t
                && tile.samples.n[at] == n);
    square(&tile, 16 * 16, 1u << 30, TP_MARK_WATER);
    assert_int_equal(mark_at(&tile, 3), TP_MARK_WATER);
    tile_free(&tile);
}

static void a_lid_behind_a_solid_changes_nothing(void **state)
{
    (void)state;
    test_tile tile = tile_of(0, 0, 16, 16, 0);

    square(&tile, 16 * 16, 1u << 29, TP_MARK_SOLID);
    const uint32_t key = tile.samples.key[tile_at(&tile, 5, 5)];
    square(&tile, 16 * 16, 1u << 28, TP_MARK_SKY);
    assert_int_equal(tile.samples.key[tile_at(&tile, 5, 5)], key);
    tile_free(&tile);
}

/* -- in a picture --------------------------------------------------------------------- */

/* A floor of 4 x 8 m at y = 0 and a lid of the same size 1 m above the floor, both facing
 * up. */
typedef struct {
    tp_mesh        mesh;
    tp_mesh_vertex vertex[8];
    tp_mesh_face   face[4];
    tp_material    material[2];
} hull;

static void hull_make(hull *h, bool lid)
{
    static const int8_t corner[4][2] = { { -1, -1 }, { -1, 1 }, { 1, 1 }, { 1, -1 } };

    for (uint32_t i = 0; i < 8; i++)
        h->vertex[i] = (tp_mesh_vertex){
            .position = { corner[i % 4][0] * 2 * TP_FX_ONE, i < 4 ? 0 : TP_FX_ONE,
                          corner[i % 4][1] * 4 * TP_FX_ONE },
            .normal = tp_dir_pack((tp_dir3){ 0, TP_Q30_ONE, 0 }),
        };
    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t first = i / 2 * 4, k = i % 2;
        h->face[i] = (tp_mesh_face){ .vertex = { first, first + 1 + k, first + 2 + k },
                                     .material = i / 2 };
    }
    h->material[0] = (tp_material){ .diffuse = 0xffffff, .shininess = TP_FX_ONE,
                                    .opacity = TP_FX_ONE };
    h->material[1] = h->material[0];
    h->material[1].opacity = 0;
    h->mesh = (tp_mesh){ .vertices = h->vertex, .faces = h->face,
                         .materials = h->material, .n_vertices = 8,
                         .n_faces = lid ? 4 : 2, .n_materials = 2 };
}

/* The floor is `immersion` m below still water; seen from above the floor fills the
 * picture. */
static uint32_t floor_pixels(bool lid, double immersion)
{
    static uint32_t key[WIDTH * HEIGHT];
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_height = HEIGHT,
                               .format = TP_FORMAT_XRGB8888 };
    hull h;
    tp_scene s = scene_plain();

    hull_make(&h, lid);
    for (int i = 0; i < 3; i++)
        s.wave[i].amplitude = 0;
    s.camera.x = 0;
    s.camera.y = 4 * TP_FX_ONE;
    s.camera.z = 5 * TP_FX_ONE;
    s.camera.pitch = -50 * TP_FX_ONE;
    s.camera.heading = 0;
    s.boat.x = s.boat.z = 0;
    s.boat.lift = TP_FX(-immersion);
    const tp_assets assets = { .boat = &h.mesh };
    tp_world *world = scene_world(&s, &assets);
    marks_draw(&s, &assets, world, config, key, NULL);
    free(world);
    return marks_count(key, WIDTH * HEIGHT, MARKS_BOAT);
}

static void water_over_the_floor_is_drawn_unless_a_lid_is_over_it(void **state)
{
    (void)state;
    const uint32_t dry = floor_pixels(false, -0.2), open = floor_pixels(false, 0.3);
    const uint32_t closed = floor_pixels(true, 0.3), over = floor_pixels(true, 1.3);

    printf("    pixels of the floor: %u above water, %u under it, %u under a lid, %u "
           "where water is over the lid\n", dry, open, closed, over);
    assert_true(dry > 2000 && closed > 2000);
    assert_int_equal(open, 0);
    assert_int_equal(over, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_lid_holds_water_back_only_before_solids),
        cmocka_unit_test(a_lid_behind_a_solid_changes_nothing),
        cmocka_unit_test(water_over_the_floor_is_drawn_unless_a_lid_is_over_it),
    };
    return cmocka_run_group_tests_name("features/boat lids", tests, NULL, NULL);
}
