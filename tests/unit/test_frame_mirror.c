/* SPDX-License-Identifier: MIT */
/* The reflection and refraction maps of the water: reflected and submerged objects lie
 * where rays in double precision meet the objects, and nothing shows on the wrong side of
 * the level. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/mirror.h"
#include "features/reflection/reflection.h"
#include "features/underwater/underwater.h"
#include "frame/tools.h"
#include "tests/lib/tilings.h"
#include "tests/lib/measure.h"
#include "shade/shade.h"

enum { WIDTH = 320, HEIGHT = 240 };

static const tp_planar_map nothing = { .colour = NULL };

/* The maps of the last picture; without colours if there is no map. */
static const tp_planar_map *mirror_of(const tp_frame *frame)
{
    const tp_mirror *mirror = tp_frame_module_memory(frame, TP_MIRROR_ID);
    return mirror ? &mirror->map : &nothing;
}

static const tp_planar_map *sunken_of(const tp_frame *frame)
{
    const tp_clear_water *clear = tp_frame_module_memory(frame, TP_CLEAR_WATER_ID);
    return clear && clear->refraction_map ? clear->refraction_map : &nothing;
}

/* True if the map shows an object in more than half of a sample at a pixel's centre. */
static bool shows(const tp_planar_map *map, int x, int y)
{
    return map->colour
        && tp_planar_map_sample(map, tp_planar_map_position(map, 16 * x + 8),
                                tp_planar_map_position(map, 16 * y + 8)) >> 24 >= 128;
}

static uint64_t chance;
static test_boat boat;

static const tp_assets *assets_of_boat(void)
{
    static tp_assets assets;
    assets = (tp_assets){ .boat = &boat.mesh };
    return &assets;
}

/* A box of 2 x 1 x 4 m, `lift` m above still water, at a random position in front of the
 * camera. */
static tp_scene calm_scene(double lift)
{
    tp_scene s = scene_plain();

    for (int i = 0; i < 3; i++)
        s.wave[i].amplitude = 0;
    s.mirror.method = TP_MIRROR_STENCIL;
    s.water.clarity = 20 * TP_FX_ONE;
    s.sky.haze = 0;
    s.camera.y = chance_fx(&chance, 0.7, 9);
    s.camera.heading = chance_fx(&chance, -180, 180);
    s.camera.pitch = chance_fx(&chance, -30, 3);
    s.camera.fov = chance_fx(&chance, 30, 80);
    const double turn = s.camera.heading / 65536.0 / 180 * 3.14159265358979;
    const double away = chance_double(&chance, 4, 25), aside = away / 4;
    s.boat.x = s.camera.x + TP_FX(away * sin(turn)) + chance_fx(&chance, -aside, aside);
    s.boat.z = s.camera.z - TP_FX(away * cos(turn)) + chance_fx(&chance, -aside, aside);
    s.boat.heading = chance_fx(&chance, 0, 360);
    s.boat.lift = TP_FX(lift);
    return s;
}

static test_frame begun(const tp_scene *scene, uint32_t width, uint32_t height)
{
    const tp_config config = { .width = width,
                               .height = height,
                               .tile_height = height,
                               .format = TP_FORMAT_XRGB8888 };
    test_frame f = frame_of(scene, assets_of_boat(), &config);
    tp_world *world = scene_world(scene, assets_of_boat());

    tp_frame_begin(f.frame, world);
    assert_true(frame_guard_holds(f.block, f.bytes));
    free(world);
    return f;
}

static ref_camera camera_of(const tp_frame *frame, uint32_t width, uint32_t height)
{
    const tp_scene *s = frame->scene;
    return ref_camera_make(frame->projection.eye, tp_turn_of_degrees(s->camera.heading),
                         tp_turn_of_degrees(s->camera.pitch), s->camera.fov,
                         s->camera.near, width, height);
}

static ref_mirror_box box_of(const tp_frame *frame)
{
    const tp_pose *pose = &frame->drawn.boat;
    return (ref_mirror_box){ ref_vec_make(pose->place),
                             pose->heading * 6.283185307179586 / 4294967296.0,
                             { 1, 0.5, 2 } };
}

/* -- outlines ------------------------------------------------------------------------- */

typedef bool covers(const ref_camera *c, const ref_mirror_box *box, double u, double v);

/* True if drawing and reference agree.  The reflection may extend behind the box, where no
 * water shows the reflection. */
static bool agrees(covers *is_there, const ref_camera *c, const ref_mirror_box *box,
                   double u, double v, bool drawn)
{
    return is_there(c, box, u, v) == drawn
        || (is_there == ref_mirrors && ref_hides(c, box, u, v));
}

/* Distance from the pixel's centre at which the reference first agrees with the drawing,
 * px. */
static double distance_to(covers *is_there, const ref_camera *c, const ref_mirror_box *box,
                          double u, double v, bool drawn)
{
    if (agrees(is_there, c, box, u, v, drawn))
        return 0;
    for (double r = 0.05; r < 4; r += 0.05)
        for (int i = 0; i < 64; i++) {
            const double a = i * 0.0981747704;
            if (agrees(is_there, c, box, u + r * cos(a), v + r * sin(a), drawn))
                return r;
        }
    return 4;
}

#define FAR 1.5                 /* px */

/* Returns the number of pixels that show the object; counts those farther than FAR from
 * the reference in *far, and the others in *off. */
static int compare(const tp_frame *frame, const tp_planar_map *map, covers *is_there,
                   measure *off, int *far)
{
    const ref_camera c = camera_of(frame, WIDTH, HEIGHT);
    const ref_mirror_box box = box_of(frame);
    int count = 0;

    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const bool drawn = shows(map, x, y);
            const double d = distance_to(is_there, &c, &box, x + 0.5, y + 0.5, drawn);
            count += drawn;
            *far += d > FAR;
            if (d <= FAR)
                measure_add(off, d, x, y, count);
        }
    return count;
}

/* Half-resolution pixels put an edge within one pixel, and a corner, where one texel counts
 * one of two edges, within FAR, for a box that rises above the level by more than the
 * reflection's depth below the level.  In one of 80 runs a texel of four pixels stands alone
 * at the side of the sunken box. */
static void outlines_lie_near_a_double_ray(void **state)
{
    (void)state;
    measure mirrored = { .what = "mirrored", .unit = "pixels" };
    measure sunken = { .what = "sunken", .unit = "pixels" };
    int seen[2] = { 0, 0 }, far[2] = { 0, 0 };

    for (int n = 0; n < 40; n++) {
        const tp_scene s = calm_scene(n % 4 ? chance_double(&chance, -0.2, 0.45)
                                            : chance_double(&chance, 0.6, 3));
        test_frame f = begun(&s, WIDTH, HEIGHT);
        seen[0] += compare(f.frame, mirror_of(f.frame), ref_mirrors, &mirrored,
                           &far[0]) > 0;
        seen[1] += compare(f.frame, sunken_of(f.frame), ref_sinks, &sunken,
                           &far[1]) > 0;
        frame_free(&f);
    }
    measure_print(&mirrored);
    measure_print(&sunken);
    printf("    seen %d and %d times of 40\n", seen[0], seen[1]);
    assert_true(seen[0] >= 20 && seen[1] >= 15);
    assert_true(mirrored.worst < FAR && sunken.worst < FAR);
    assert_true(far[0] == 0 && far[1] <= 8);
}

/* The number of pixels where picture and double rays differ, behind the box left out. */
static int count_wrong(const tp_frame *frame)
{
    const ref_camera c = camera_of(frame, WIDTH, HEIGHT);
    const ref_mirror_box box = box_of(frame);
    int wrong = 0;

    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            wrong += !agrees(ref_mirrors, &c, &box, x + 0.5, y + 0.5,
                             shows(mirror_of(frame), x, y));
    return wrong;
}

/* At full size a map pixel's centre is the picture's, so the map's edge is the exact edge to
 * the rasterizer's 16th of a pixel. */
static void a_larger_map_lies_nearer_to_double_rays(void **state)
{
    (void)state;
    int wrong[3] = { 0, 0, 0 };

    for (int n = 0; n < 24; n++) {
        tp_scene s = calm_scene(chance_double(&chance, 0, 0.45));
        s.water.clarity = 0;
        for (int size = 0; size < 3; size++) {
            s.mirror.size = size;
            test_frame f = begun(&s, WIDTH, HEIGHT);
            wrong[size] += count_wrong(f.frame);
            frame_free(&f);
        }
    }
    printf("    pixels off: full %d, half %d, quarter %d\n", wrong[TP_MIRROR_FULL],
           wrong[TP_MIRROR_HALF], wrong[TP_MIRROR_QUARTER]);
    assert_true(wrong[TP_MIRROR_QUARTER] > 200);
    assert_true(wrong[TP_MIRROR_HALF] < wrong[TP_MIRROR_QUARTER]);
    assert_true(10 * wrong[TP_MIRROR_FULL] < wrong[TP_MIRROR_HALF]);
}

/* Returns the largest difference of a channel; the pixels that differ at all are added to
 * *count. */
static int difference(const uint32_t *a, const uint32_t *b, uint32_t *count)
{
    int most = 0;

    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        *count += a[i] != b[i];
        for (int shift = 0; shift < 24; shift += 8) {
            const int off = abs((int)(a[i] >> shift & 255) - (int)(b[i] >> shift & 255));
            most = off > most ? off : most;
        }
    }
    return most;
}

/* Draws the scene at tick 0. */
static void draw(const tp_scene *scene, uint32_t *picture)
{
    const tp_config config = { .width = WIDTH, .height = HEIGHT };
    test_frame f = frame_of(scene, assets_of_boat(), &config);
    tp_world *world = scene_world(scene, assets_of_boat());

    frame_draw_picture(&f, world, picture);
    free(world);
    frame_free(&f);
}

/* Without smooth outlines the colours are off by half a level of red, 255 / 62, and their
 * rounding; the mirror shows no more and no less. */
static void packed_colours_are_off_by_half_a_level(void **state)
{
    (void)state;
    static uint32_t picture[2][WIDTH * HEIGHT];
    uint32_t differ = 0;

    for (int n = 0; n < 24; n++) {
        tp_scene s = calm_scene(chance_double(&chance, 0, 0.45));
        s.boat.edges = TP_EDGES_PLAIN;
        s.mirror.size = n % 3;
        draw(&s, picture[0]);
        s.mirror.colours = TP_MIRROR_RGB565;
        draw(&s, picture[1]);
        assert_true(difference(picture[0], picture[1], &differ) <= 6);
    }
    assert_true(differ > 1000);
}

static void odd_sizes_have_their_mirror_in_place(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        const uint32_t w = 33 + 2 * random_below(&chance, 60);
        const uint32_t h = 33 + 2 * random_below(&chance, 60);
        tp_scene s = calm_scene(0.2);
        s.mirror.size = n % 3;
        test_frame f = begun(&s, w, h);
        const ref_camera c = camera_of(f.frame, w, h);
        const ref_mirror_box box = box_of(f.frame);
        for (uint32_t i = 0; i < w * h; i++) {
            const int x = (int)(i % w), y = (int)(i / w);
            const tp_planar_map *map = mirror_of(f.frame);
            assert_true(distance_to(ref_mirrors, &c, &box, x + 0.5, y + 0.5,
                                    shows(map, x, y))
                        <= (s.mirror.size == TP_MIRROR_QUARTER ? 2 * FAR : 1));
        }
        frame_free(&f);
    }
}

/* -- the level ------------------------------------------------------------------------ */

static void what_lies_below_the_level_is_not_mirrored(void **state)
{
    (void)state;
    for (int n = 0; n < 20; n++) {
        tp_scene s = calm_scene(n % 2 ? -1 : -3);
        test_frame f = begun(&s, WIDTH, HEIGHT);
        assert_null(mirror_of(f.frame)->colour);
        frame_free(&f);
        s = calm_scene(n % 2 ? 0.51 : 3);
        f = begun(&s, WIDTH, HEIGHT);
        assert_null(sunken_of(f.frame)->colour);
        frame_free(&f);
    }
}

static void an_eye_under_water_sees_neither(void **state)
{
    (void)state;
    tp_scene s = calm_scene(0);

    s.camera.y = TP_FX(-0.5);
    test_frame f = begun(&s, WIDTH, HEIGHT);
    assert_null(mirror_of(f.frame)->colour);
    assert_null(sunken_of(f.frame)->colour);
    frame_free(&f);
}

/* A box far down has the deep water's colour, a box at the level does not. */
static void depth_takes_the_colour_of_what_is_sunken(void **state)
{
    (void)state;
    uint32_t off[2] = { 0, 0 };

    for (int deep = 0; deep < 2; deep++) {
        tp_scene s = calm_scene(deep ? -30 : -0.6);
        s.camera.x = s.boat.x;
        s.camera.y = 4 * TP_FX_ONE;
        s.camera.z = s.boat.z + 3 * TP_FX_ONE;
        s.camera.heading = 0;
        s.camera.pitch = -75 * TP_FX_ONE;
        s.water.clarity = TP_FX_ONE / 2;
        test_frame f = begun(&s, WIDTH, HEIGHT);
        const tp_planar_map *map = sunken_of(f.frame);
        assert_non_null(map->colour);
        const int32_t count = (map->x1 - map->x0) * (map->y1 - map->y0);
        for (int32_t i = 0; i < count; i++)
            if (map->colour[i])
                off[deep] += (map->colour[i] & 0xffffff) != (uint32_t)s.water.deep_colour;
        frame_free(&f);
    }
    printf("    texels unlike the deep water: %u near, %u far down\n", off[0], off[1]);
    assert_true(off[0] > 100 && off[1] == 0);
}

/* -- at the foot of an object --------------------------------------------------------- */

/* True for a pixel of water directly below a pixel of the box, surrounded by pixels that
 * reflect the box. */
static bool at_the_foot(const ref_camera *c, const ref_mirror_box *box, const uint32_t *key,
                        int x, int y)
{
    const uint32_t *here = key + y * WIDTH + x;

    if (x == 0 || x == WIDTH - 1 || y == HEIGHT - 1 || TP_MARK(here[0]) != MARKS_WATER
        || TP_MARK(here[-WIDTH]) < MARKS_BOAT)
        return false;
    for (int k = 0; k < 9; k++)
        if (!ref_mirrors(c, box, x + 0.5 + 2 * (k % 3 - 1), y + 0.5 + k / 3))
            return false;
    return true;
}

/* Half-resolution pixels on both sides of the level are mixed there: empty pixels are
 * light.  In a steep view downwards a pixel covers more of an object's height, so a few
 * pixels in a thousand remain; at most 13 in 160 runs. */
static void no_sky_shows_between_an_object_and_its_mirror(void **state)
{
    (void)state;
    static uint32_t key[WIDTH * HEIGHT];
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_height = HEIGHT,
                               .format = TP_FORMAT_XRGB8888 };
    int feet = 0, light = 0;

    for (int n = 0; n < 40; n++) {
        const tp_scene s = calm_scene(chance_double(&chance, -0.3, 0.3));
        tp_world *world = scene_world(&s, assets_of_boat());
        test_frame f = begun(&s, WIDTH, HEIGHT);
        const tp_planar_map *map = mirror_of(f.frame);
        const ref_camera c = camera_of(f.frame, WIDTH, HEIGHT);
        const ref_mirror_box box = box_of(f.frame);
        marks_draw(&s, assets_of_boat(), world, config, key, NULL);
        for (int i = WIDTH; i < WIDTH * HEIGHT; i++) {
            const int x = i % WIDTH, y = i / WIDTH;
            if (!map->colour || !at_the_foot(&c, &box, key, x, y))
                continue;
            feet++;
            light += tp_planar_map_sample(map, tp_planar_map_position(map, 16 * x + 8),
                                          tp_planar_map_position(map, 16 * y + 8))
                     >> 24 < 250;
        }
        frame_free(&f);
        free(world);
    }
    printf("    %d pixels at the foot, through %d of which sky shows\n", feet, light);
    assert_true(feet > 400 && 50 * light <= feet);
}

/* -- in the picture ------------------------------------------------------------------- */

static bool differ(uint32_t a, uint32_t b)
{
    for (int shift = 0; shift < 24; shift += 8)
        if (abs((int)(a >> shift & 0xff) - (int)(b >> shift & 0xff)) > 3)
            return true;
    return false;
}

/* Changes by the reflection, beyond the rounding of two ways of mixing, are over water
 * nearer than the boat, as far from the flat reflection as slopes and crests displace the
 * image. */
static void the_mirror_under_waves_stays_under_the_boat(void **state)
{
    (void)state;
    static uint32_t key[WIDTH * HEIGHT], with[WIDTH * HEIGHT], without[WIDTH * HEIGHT];
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_height = HEIGHT,
                               .format = TP_FORMAT_XRGB8888 };
    int changed = 0;

    for (int n = 0; n < 20; n++) {
        tp_scene s = calm_scene(0.1);
        s.water.clarity = 0;
        s.water.reflection = TP_FX_ONE;
        s.wave[0].amplitude = TP_FX(0.06);
        s.wave[0].length = 6 * TP_FX_ONE;
        tp_world *world = scene_world(&s, assets_of_boat());
        test_frame f = begun(&s, WIDTH, HEIGHT);
        const tp_planar_map map = *mirror_of(f.frame);
        const double focal = f.frame->projection.focal / 65536.0;
        const int most = (int)(2 * 0.07 * focal) + 12;
        marks_draw(&s, assets_of_boat(), world, config, key, with);
        s.mirror.method = TP_MIRROR_NONE;
        marks_draw(&s, assets_of_boat(), world, config, NULL, without);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            if (!map.colour || !differ(with[i], without[i]))
                continue;
            const int x = i % WIDTH, y = i / WIDTH;
            changed++;
            assert_int_equal(TP_MARK(key[i]), MARKS_WATER);
            assert_true(x >= 2 * map.x0 - most && x < 2 * map.x1 + most);
            assert_true(y >= 2 * map.y0 - most && y < 2 * map.y1 + most);
        }
        frame_free(&f);
        free(world);
    }
    printf("    %d pixels mirror the boat\n", changed);
    assert_true(changed > 1000);
}

/* True if pixel i is water at the foot of the box: right below a pixel of the box, at the
 * box's depth (a crest before the box is nearer), where the image of the water's height lies
 * within the picture.  Water h above the level has its image 2 h higher. */
static bool is_foot(const tp_frame *frame, const uint32_t *key, int i)
{
    if (TP_MARK(key[i]) != MARKS_WATER || TP_MARK(key[i - WIDTH]) < MARKS_BOAT)
        return false;
    const tp_projection *p = &frame->projection;
    const double focal = p->focal / 65536.0, v = i / WIDTH + 0.5 - p->v0 / 16.0;
    const double z = (double)tp_depth_from_zi(p->zi_near, TP_ZI(key[i])) / 65536;
    const double box = (double)tp_depth_from_zi(p->zi_near, TP_ZI(key[i - WIDTH])) / 65536;
    const double level = tp_frame_objects_anchor(frame).level / 65536.0;
    const double above = p->eye.y / 65536.0 - v * z / focal - level;

    return fabs(z - box) < box / 10
        && i / WIDTH + 2 * above * focal / box < HEIGHT - 1;
}

/* A trough exposes the box's sides below the level, and the reflection shows these
 * sides. */
static void troughs_mirror_what_they_bare(void **state)
{
    (void)state;
    static uint32_t key[WIDTH * HEIGHT], with[WIDTH * HEIGHT], without[WIDTH * HEIGHT];
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_height = HEIGHT,
                               .format = TP_FORMAT_XRGB8888 };
    int feet = 0, bare = 0;

    for (int n = 0; n < 40; n++) {
        tp_scene s = calm_scene(0);
        s.camera.y = TP_FX_ONE;             /* water seen steeply reflects too little */
        s.camera.pitch = 0;
        s.water.clarity = 0;
        s.water.reflection = TP_FX_ONE;
        s.mirror.distortion = 0;
        s.wave[0].amplitude = TP_FX(0.2);
        s.wave[0].length = 14 * TP_FX_ONE;
        tp_world *world = scene_world(&s, assets_of_boat());
        test_frame f = begun(&s, WIDTH, HEIGHT);
        marks_draw(&s, assets_of_boat(), world, config, key, with);
        s.mirror.method = TP_MIRROR_NONE;
        marks_draw(&s, assets_of_boat(), world, config, NULL, without);
        for (int i = WIDTH; i < WIDTH * HEIGHT; i++) {
            if (!is_foot(f.frame, key, i))
                continue;
            feet++;
            bare += !differ(with[i], without[i]);
        }
        frame_free(&f);
        free(world);
    }
    printf("    %d pixels at the foot, %d without a mirror\n", feet, bare);
    assert_true(feet > 400 && 100 * bare <= feet);     /* at worst one in 134, of 200 seeds */
}

/* The head of include/tidepool/frame.h states these sizes. */
static void mirrors_cost_the_bytes_that_are_told(void **state)
{
    (void)state;
    tp_scene s = scene_plain();
    static const struct {
        int32_t method, size, edges;
        size_t  bytes, packed;
    } of[] = {
        { TP_MIRROR_NONE, TP_MIRROR_FULL, TP_EDGES_PLAIN, 0, 0 },
        { TP_MIRROR_CUBE, TP_MIRROR_FULL, TP_EDGES_PLAIN, 24576, 24576 },
        { TP_MIRROR_STENCIL, TP_MIRROR_HALF, TP_EDGES_PLAIN, 88320, 49920 },
        { TP_MIRROR_STENCIL, TP_MIRROR_HALF, TP_EDGES_SMOOTH, 88320 + 10240, 49920 + 10240 },
        { TP_MIRROR_STENCIL, TP_MIRROR_QUARTER, TP_EDGES_PLAIN, 24960, 15360 },
        { TP_MIRROR_STENCIL, TP_MIRROR_QUARTER, TP_EDGES_SMOOTH, 24960 + 5120, 15360 + 5120 },
        { TP_MIRROR_STENCIL, TP_MIRROR_FULL, TP_EDGES_PLAIN, 330240, 176640 },
        { TP_MIRROR_STENCIL, TP_MIRROR_FULL, TP_EDGES_SMOOTH, 330240 + 20480, 176640 + 20480 },
    };

    for (size_t i = 0; i < 2 * sizeof of / sizeof of[0]; i++) {
        const bool packed = i % 2;
        s.mirror.method = of[i / 2].method;
        s.mirror.size = of[i / 2].size;
        s.mirror.colours = packed ? TP_MIRROR_RGB565 : TP_MIRROR_RGB888;
        s.boat.edges = of[i / 2].edges;
        test_frame f = begun(&s, 320, 240);
        const size_t got = tp_frame_ram(f.frame).mirror;
        const size_t want = packed ? of[i / 2].packed : of[i / 2].bytes;
        assert_true(got >= want && got <= want + (want ? 128 : 0));
        frame_free(&f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(outlines_lie_near_a_double_ray),
        cmocka_unit_test(packed_colours_are_off_by_half_a_level),
        cmocka_unit_test(odd_sizes_have_their_mirror_in_place),
        cmocka_unit_test(what_lies_below_the_level_is_not_mirrored),
        cmocka_unit_test(an_eye_under_water_sees_neither),
        cmocka_unit_test(depth_takes_the_colour_of_what_is_sunken),
        cmocka_unit_test(no_sky_shows_between_an_object_and_its_mirror),
        cmocka_unit_test(the_mirror_under_waves_stays_under_the_boat),
        cmocka_unit_test(troughs_mirror_what_they_bare),
        cmocka_unit_test(mirrors_cost_the_bytes_that_are_told),
        cmocka_unit_test(a_larger_map_lies_nearer_to_double_rays),
    };
    chance = random_seed();
    boat_make(&boat, &chance);
    boat.material[1].opacity = TP_FX_ONE;       /* no holes in the outline */
    return cmocka_run_group_tests_name("frame mirror", tests, NULL, NULL);
}
