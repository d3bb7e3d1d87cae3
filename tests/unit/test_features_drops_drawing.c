/* SPDX-License-Identifier: MIT */
/* Drops in the picture, compared with a spheroid in double precision, for any
 * tiling.  The mesh has ten meridians and five parallels, all on the spheroid:
 * its outline lies inside the true outline by at most 8 % (1 - cos 18 cos 15
 * degrees), and flattened drops err by 3 % more: up to a radius of 9 px the error
 * is below a pixel.  Larger drops have twice as many lines and lie inside by 2
 * %. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/camera.h"
#include "features/drops/drops.h"
#include "tests/lib/tilings.h"

enum { WIDTH = 160, HEIGHT = 112 };

static uint64_t chance;
static uint32_t key[WIDTH * HEIGHT];
static const tp_assets none;
static const tp_config config = {
    .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_XRGB8888
};

/* Still water far below; the releasing sphere is behind the eye, which looks to -z. */
static tp_scene scene_of(int32_t count)
{
    tp_scene s = marks_still(50);

    s.drops.count = count;
    s.drops.interval = 0;
    s.drops.y = 50 * TP_FX_ONE;
    s.drops.z = 300 * TP_FX_ONE;
    return s;
}

static tp_drops *drops_of(tp_world *world)
{
    return (tp_drops *)(uintptr_t)tp_world_drops(world);
}

static void put(tp_world *world, tp_vec3 at, tp_fx radius, int32_t squash)
{
    tp_drops *d = drops_of(world);
    tp_drop *list = (tp_drop *)(uintptr_t)tp_drops_list(d);

    assert_true(d->count < d->capacity);
    list[d->count++] = (tp_drop){ .place = at, .last = at, .radius = radius,
                                  .squash = squash };
}

typedef struct {
    ref_camera camera;
    ref_vec    centre;
    double     wide, high;
} ball;

static ball ball_of(const tp_world *w, const tp_scene *s, tp_vec3 at, tp_fx radius,
                    int32_t squash)
{
    const double a = 1 + squash / 16384.0, r = radius / 65536.0;

    return (ball){
        .camera = ref_camera_make(w->eye, w->heading, w->pitch, s->camera.fov,
                                  s->camera.near, WIDTH, HEIGHT),
        .centre = ref_vec_make(at),
        .wide = r * pow(a, -1 / 3.0),
        .high = r * pow(a, 2 / 3.0),
    };
}

/* True if the ray through (u, v) px meets the drop: the spheroid is scaled to a unit
 * sphere. */
static bool meets(const ball *b, double u, double v)
{
    const ref_camera *c = &b->camera;
    const double x = (u - c->u0) / c->focal, y = (c->v0 - v) / c->focal;
    const ref_vec way = { (c->ahead.x + x * c->right.x + y * c->up.x) / b->wide,
                          (c->ahead.y + x * c->right.y + y * c->up.y) / b->high,
                          (c->ahead.z + x * c->right.z + y * c->up.z) / b->wide };
    ref_vec d = ref_sub(b->centre, c->eye);
    d = (ref_vec){ d.x / b->wide, d.y / b->high, d.z / b->wide };
    const double along = ref_dot(d, way);
    return along > 0 && along * along >= ref_dot(way, way) * (ref_dot(d, d) - 1);
}

/* Counts the rays that meet the drop, of the pixel's centre and eight points a pixel away:
 * 0..9. */
static int met(const ball *b, int x, int y)
{
    int count = meets(b, x + 0.5, y + 0.5);

    for (int i = 0; i < 8; i++)
        count += meets(b, x + 0.5 + cos(i * 0.785398), y + 0.5 + sin(i * 0.785398));
    return count;
}

/* Area of random drops with radii in this range of pixels, relative to the true area. */
static double area_of_drops(double least, double most)
{
    double area = 0, true_area = 0;

    for (int n = 0; n < 120; n++) {
        tp_scene scene = scene_of(4);
        scene.camera.heading = chance_fx(&chance, -180, 180);
        scene.camera.pitch = chance_fx(&chance, -50, 50);
        tp_world *world = scene_world(&scene, &none);
        const int32_t squash = chance_int(&chance, -8192, 8192);
        const double depth = chance_scale(&chance, 1, 40) / 65536.0;
        const double pixels = chance_double(&chance, least, most);
        ball b = ball_of(world, &scene, world->eye, TP_FX_ONE, squash);
        const double u = chance_double(&chance, -60, 60) / b.camera.focal * depth;
        const double v = chance_double(&chance, -40, 40) / b.camera.focal * depth;
        const ref_camera *c = &b.camera;
        const tp_vec3 at = {
            (tp_fx)lround(65536 * (c->eye.x + depth * c->ahead.x + u * c->right.x
                                   + v * c->up.x)),
            (tp_fx)lround(65536 * (c->eye.y + depth * c->ahead.y + u * c->right.y
                                   + v * c->up.y)),
            (tp_fx)lround(65536 * (c->eye.z + depth * c->ahead.z + u * c->right.z
                                   + v * c->up.z)),
        };
        const tp_fx radius = (tp_fx)lround(pixels / c->focal * depth * 65536);
        drops_of(world)->sphere.y = drops_of(world)->last_sphere.y = -50 * TP_FX_ONE;
        put(world, at, radius, squash);
        b = ball_of(world, &scene, at, radius, squash);
        marks_draw(&scene, &none, world, config, key, NULL);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                const bool drawn = TP_MARK(key[y * WIDTH + x]) == MARKS_DROP;
                const int count = met(&b, x, y);
                assert_true(drawn ? count > 0 : count < 9);
                area += drawn;
                true_area += meets(&b, x + 0.5, y + 0.5);
            }
        }
        free(world);
    }
    print_message("    %g to %g pixels: area %.3f of the spheroids'\n", least, most,
                  area / true_area);
    return area / true_area;
}

static void a_drop_covers_the_pixels_of_its_spheroid(void **state)
{
    (void)state;
    const double small = area_of_drops(1, 7), large = area_of_drops(12, 18);

    assert_true(small > 0.85 && small < 1.01);
    assert_true(large > 0.95 && large < 1.01);
}

/* Normals point outward: the middle of the picture faces the viewer. */
static void the_near_side_is_seen(void **state)
{
    (void)state;
    tp_scene scene = scene_of(1);
    tp_world *world = scene_world(&scene, &none);
    const tp_vec3 at = { 0, 50 * TP_FX_ONE, -10 * TP_FX_ONE };
    test_frame f = frame_of(&scene, &none, &config);
    tp_tile tile;

    put(world, at, TP_FX_ONE, 0);
    tp_frame_begin(f.frame, world);
    assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
    const uint32_t *plane = (const uint32_t *)(const void *)f.scratch;
    const size_t middle = HEIGHT / 2 * WIDTH + WIDTH / 2;
    const tp_packed_dir n = plane[3 * WIDTH * HEIGHT + middle];
    assert_int_equal(marks_kind_of(f.frame, TP_MARK(plane[middle])), MARKS_DROP);
    const double x = tp_dir_x(n), y = tp_dir_y(n), z = tp_dir_z(n);
    assert_true(z > 0.9 * sqrt(x * x + y * y + z * z));
    frame_free(&f);
    free(world);
}

static void what_is_behind_the_eye_is_not_drawn(void **state)
{
    (void)state;
    tp_scene scene = scene_of(40);
    tp_world *world = scene_world(&scene, &none);

    for (int n = 0; n < 40; n++)
        put(world, (tp_vec3){ chance_fx(&chance, -9, 9), chance_fx(&chance, 41, 59),
                              chance_fx(&chance, 1.1, 30) }, TP_FX_ONE, 0);
    marks_draw(&scene, &none, world, config, key, NULL);
    assert_int_equal(marks_count(key, WIDTH * HEIGHT, MARKS_DROP), 0);
    free(world);
}

/* Drops from the near plane to the eye position. */
static void drops_around_the_eye_are_cut(void **state)
{
    (void)state;
    for (int n = 0; n < 60; n++) {
        tp_scene scene = scene_of(3);
        tp_world *world = scene_world(&scene, &none);
        put(world, (tp_vec3){ chance_fx(&chance, -1, 1), chance_fx(&chance, 49, 51),
                              chance_fx(&chance, -2, 1) },
            chance_scale(&chance, 0.002, 2), chance_int(&chance, -8192, 8192));
        marks_draw(&scene, &none, world, config, key, NULL);
        free(world);
    }
}

static tp_world *many(tp_scene *scene, int32_t count)
{
    *scene = scene_of(count);
    tp_world *world = scene_world(scene, &none);

    drops_of(world)->sphere.z = -6 * TP_FX_ONE;
    drops_of(world)->last_sphere.z = -7 * TP_FX_ONE;
    world->lag = chance_int(&chance, 0, 65535);
    put(world, (tp_vec3){ 0, 50 * TP_FX_ONE, -8 * TP_FX_ONE }, TP_FX(0.5), 0);   /* seen */
    for (int n = 1; n < count; n++)
        put(world, (tp_vec3){ chance_fx(&chance, -8, 8), chance_fx(&chance, 44, 56),
                              chance_fx(&chance, -15, 1) },
            chance_scale(&chance, 0.01, 0.5), chance_int(&chance, -8192, 8192));
    return world;
}

static void every_tiling_gives_the_same_bits(void **state)
{
    (void)state;
    static const uint32_t sizes[][2] = { { 0, 1 }, { 0, 7 }, { 16, 0 }, { 16, 16 },
                                         { 48, 31 } };

    for (int n = 0; n < 3; n++) {
        tp_scene scene;
        tp_world *world = many(&scene, 40);
        marks_assert_tiled(&scene, &none, world, config, sizes,
                           sizeof sizes / sizeof *sizes, key);
        assert_true(marks_count(key, WIDTH * HEIGHT, MARKS_DROP) > 50);
        free(world);
    }
}

static void a_thousand_drops_are_drawn(void **state)
{
    (void)state;
    tp_scene scene;
    tp_world *world = many(&scene, 1024);
    marks_draw(&scene, &none, world, config, key, NULL);
    assert_true(marks_count(key, WIDTH * HEIGHT, MARKS_DROP) > 1000);
    free(world);
}

/* An interpolation of one half draws the drop half way between its last two positions. */
static void a_drop_is_drawn_between_its_last_two_places(void **state)
{
    (void)state;
    tp_scene scene = scene_of(1);
    tp_world *world = scene_world(&scene, &none);
    const tp_vec3 here = { 0, 50 * TP_FX_ONE, -10 * TP_FX_ONE };
    static uint32_t want[WIDTH * HEIGHT], got[WIDTH * HEIGHT];

    put(world, here, TP_FX(0.5), 0);
    marks_draw(&scene, &none, world, config, NULL, want);
    tp_drop *drop = (tp_drop *)(uintptr_t)tp_drops_list(drops_of(world));
    drop->last.y = here.y + TP_FX_ONE;
    drop->place.y = here.y - TP_FX_ONE;
    world->lag = TP_FX_ONE / 2;
    marks_draw(&scene, &none, world, config, NULL, got);
    assert_memory_equal(got, want, sizeof want);
    free(world);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_drop_covers_the_pixels_of_its_spheroid),
        cmocka_unit_test(the_near_side_is_seen),
        cmocka_unit_test(what_is_behind_the_eye_is_not_drawn),
        cmocka_unit_test(drops_around_the_eye_are_cut),
        cmocka_unit_test(every_tiling_gives_the_same_bits),
        cmocka_unit_test(a_thousand_drops_are_drawn),
        cmocka_unit_test(a_drop_is_drawn_between_its_last_two_places),
    };
    return cmocka_run_group_tests_name("features/drops drawing", tests, NULL, NULL);
}
