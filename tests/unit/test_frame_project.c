/* SPDX-License-Identifier: MIT */
/* Projection of world points into the picture and back, for cameras with any roll. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include "features/drops/drops.h"
#include "frame/frame.h"
#include "tests/lib/worlds.h"

static uint64_t chance;
static const tp_assets none;

static double metres(tp_fx x)
{
    return x / 65536.0;
}

static double axis(const tp_dir3 *d, const double p[3])
{
    return (d->x * p[0] + d->y * p[1] + d->z * p[2]) / TP_Q30_ONE;
}

typedef struct {
    double x, y, depth;
} seen_point;

static seen_point seen_at(const tp_world *w, const tp_scene *s, uint32_t width,
                          uint32_t height, tp_vec3 place)
{
    const tp_camera c = tp_world_camera(w);
    const double p[3] = { metres(place.x) - metres(c.eye.x),
                          metres(place.y) - metres(c.eye.y),
                          metres(place.z) - metres(c.eye.z) };
    const double focal =
        height / 2.0 / tan(metres(s->camera.fov) * 3.14159265358979 / 360);
    const double depth = -axis(&c.turn.z, p);
    return (seen_point){ width / 2.0 + focal * axis(&c.turn.x, p) / depth,
                         height / 2.0 - focal * axis(&c.turn.y, p) / depth, depth };
}

static void place_camera_any(tp_world *w, double low, double high)
{
    tp_world_set_camera(w,
                        (tp_vec3){ chance_fx(&chance, -9, 9),
                                   chance_fx(&chance, low, high),
                                   chance_fx(&chance, -9, 9) },
                        (tp_turn)random_next(&chance),
                        (tp_turn)(int32_t)chance_int(&chance, -0x30000000, 0x04000000),
                        (tp_turn)random_next(&chance));
}

static test_frame frame_any(const tp_scene *scene, uint32_t *width, uint32_t *height)
{
    *width = (uint32_t)chance_int(&chance, 16, 800);
    *height = (uint32_t)chance_int(&chance, 16, 600);
    const tp_config config = { .width = *width,
                                     .height = *height,
                                     .tile_height = 16 };
    return frame_of(scene, &none, &config);
}

static tp_scene scene_of(uint32_t parts)
{
    tp_scene s = scene_with(&chance, parts);
    s.boat.mesh[0] = '\0';
    s.floor.depth = parts & 1 ? TP_FX(60) : 0;
    s.floor.slope = 0;
    s.camera.fov = chance_fx(&chance, 20, 100);
    return s;
}

/* Any point, from 16 km away to directly before the camera. */
static void a_place_is_where_a_pinhole_sees_it(void **state)
{
    (void)state;
    double worst = 0, far = 0;
    int found = 0, hidden = 0;
    const int count = random_rounds(60, 30);
    for (int n = 0; n < count; n++) {
        const tp_scene scene = scene_of(0);
        tp_world *w = scene_world(&scene, NULL);
        uint32_t width, height;
        test_frame f = frame_any(&scene, &width, &height);
        place_camera_any(w, -50, 50);
        tp_frame_begin(f.frame, w);
        for (int i = 0; i < 200; i++) {
            const double reach = pow(2, chance_double(&chance, -1, 14));
            const tp_vec3 at = { tp_fx_add_sat(w->eye.x, chance_fx(&chance, -reach, reach)),
                                 tp_fx_add_sat(w->eye.y, chance_fx(&chance, -reach, reach)),
                                 tp_fx_add_sat(w->eye.z,
                                            chance_fx(&chance, -reach, reach)) };
            const seen_point want = seen_at(w, &scene, width, height, at);
            tp_fx x, y, depth;
            if (!tp_frame_project(f.frame, at, &x, &y, &depth)) {
                assert_true(want.depth < metres(scene.camera.near) + 2e-5);
                hidden++;
                continue;
            }
            assert_true(want.depth > metres(scene.camera.near) - 2e-5);
            far = fmax(far, fabs(metres(depth) - want.depth));
            if (fabs(want.x) > 32000 || fabs(want.y) > 32000)
                continue;
            found++;
            worst = fmax(worst, fmax(fabs(metres(x) - want.x), fabs(metres(y) - want.y))
                                    / (1 + hypot(want.x, want.y) / 4096));
        }
        frame_free(&f);
        free(w);
    }
    printf("    %d places: %.5f px off (more far outside), %.2f mm; %d hidden\n", found,
           worst, 1000 * far, hidden);
    assert_true(found > 50 * count && hidden > 50 * count);
    assert_true(worst < 0.01);
    assert_true(far < 0.0001);
}

static void places_far_outside_are_held(void **state)
{
    (void)state;
    tp_scene scene = scene_of(0);
    scene.camera.fov = 20 * TP_FX_ONE;
    tp_world *w = scene_world(&scene, NULL);
    const tp_config config = { .width = 4096, .height = 4096, .tile_height = 1 };
    test_frame f = frame_of(&scene, &none, &config);
    tp_fx x, y, depth;

    tp_world_set_camera(w, (tp_vec3){ 0, 0, 0 }, 0, 0, 0);
    tp_frame_begin(f.frame, w);
    assert_true(tp_frame_project(
        f.frame, (tp_vec3){ TP_FX_MIN, TP_FX_MAX, -scene.camera.near }, &x, &y, &depth));
    assert_int_equal(depth, scene.camera.near);
    assert_true(x == TP_FX_MIN + 2048 * TP_FX_ONE || x == TP_FX_MIN);
    assert_true(y == TP_FX_MIN + 2048 * TP_FX_ONE || y == TP_FX_MIN || y < -TP_FX(30000));
    assert_false(tp_frame_project(f.frame, (tp_vec3){ 0, 0, 1 - scene.camera.near }, &x,
                                  &y, &depth));
    frame_free(&f);
    free(w);
}

/* With pools, rings, coastal water and between ticks; also from below. */
static void a_picked_place_projects_to_its_pixel(void **state)
{
    (void)state;
    double worst = 0;
    int found = 0;
    const int count = random_rounds(96, 32);
    for (int n = 0; n < count; n++) {
        const tp_scene scene = scene_of((uint32_t)n % 32 & ~2u);
        tp_world *w = scene_world(&scene, NULL);
        uint32_t width, height;
        test_frame f = frame_any(&scene, &width, &height);
        for (int i = 0; i < 40; i++)
            tp_world_step(&tp_program_all, w, &scene, NULL);
        w->lag = chance_int(&chance, 0, TP_FX_ONE);
        place_camera_any(w, n % 8 ? 3 : -9, n % 8 ? 12 : -3);
        tp_frame_begin(f.frame, w);
        for (int i = 0; i < 20; i++) {
            const tp_fx px = tp_pixel_middle(chance_int(&chance, 0, (int32_t)width - 1));
            const tp_fx py = tp_pixel_middle(chance_int(&chance, 0, (int32_t)height - 1));
            tp_fx x, y, depth;
            tp_vec3 at;
            if (!tp_frame_pick(f.frame, px, py, &at))
                continue;
            assert_true(tp_frame_project(f.frame, at, &x, &y, &depth));
            worst = fmax(worst, fmax(abs(x - px), abs(y - py)) / 65536);
            found++;
        }
        frame_free(&f);
        free(w);
    }
    printf("    %d picks: at the most %.4f px off\n", found, worst);
    assert_true(found > 4 * count);
    assert_true(worst < 0.5);
}

/* -- drawn pixels --------------------------------------------------------------------- */

typedef struct {
    int water, other, wrong, far;
} agreement;

/* Compares picks with a drawn tile: kinds and depths agree except within a pixel of an
 * edge.  The mesh ends 62 m from the origin. */
static void compare_tile(const test_frame *f, const tp_tile *tile, agreement *a)
{
    static uint8_t kind[3][800];
    static tp_fx depth[3][800];

    for (uint32_t y = tile->y0 + 1; y + 1 < tile->y1; y += 3) {
        for (uint32_t k = 0; k < 3; k++) {
            tp_frame_sample_row(f->frame, f->scratch, tile, y - 1 + k, depth[k], kind[k]);
        }
        for (uint32_t x = 1; x + 1 < tile->x1 - tile->x0; x += 3) {
            bool water = true, any = false;
            tp_fx low = TP_FX_MAX, high = 0, px, py, far;
            for (uint32_t k = 0; k < 9; k++) {
                const bool wet = kind[k / 3][x - 1 + k % 3] == TP_SAMPLE_WATER;
                const tp_fx d = depth[k / 3][x - 1 + k % 3];
                assert_true((d == TP_FX_MAX)
                            == (kind[k / 3][x - 1 + k % 3] == TP_SAMPLE_SKY));
                water = water && wet;
                any = any || wet;
                low = d < low ? d : low;
                high = d > high ? d : high;
            }
            tp_vec3 at;
            const bool picked =
                tp_frame_pick(f->frame, tp_pixel_middle((int32_t)(tile->x0 + x)),
                              tp_pixel_middle((int32_t)y), &at);
            if (picked && hypot(metres(at.x), metres(at.z)) > 60)
                continue;
            a->water += water;
            a->other += !any;
            a->wrong += picked ? !any : water;
            if (!picked || !water || !tp_frame_project(f->frame, at, &px, &py, &far))
                continue;
            a->far += far < low - low / 100 || far > high + high / 100;
        }
    }
}

static void picks_agree_with_the_samples_of_tiles(void **state)
{
    (void)state;
    agreement a = { 0 };
    const int count = random_rounds(16, 4);
    for (int n = 0; n < count; n++) {
        static const uint32_t parts[] = { 0, 16, 4, 1 }; /* swells, rings, pool, coast */
        tp_scene scene = scene_of(parts[n % 4]);
        scene.grid.vertices = 65536;
        scene.quality.visibility = TP_VISIBILITY_TRIANGLES;
        scene.drops.target = TP_DROPS_RINGS;
        scene.drops.rings = 40;
        scene.drops.radius = TP_FX(0.01); /* too small to be visible in the air */
        tp_world *w = scene_world(&scene, NULL);
        const tp_config config = {
            .width = 320, .height = 200, .tile_width = n & 1 ? 160 : 0, .tile_height = 50
        };
        test_frame f = frame_of(&scene, &none, &config);
        tp_tile tile;

        for (int i = 0; i < 30; i++)
            tp_world_step(&tp_program_all, w, &scene, NULL);
        tp_world_set_camera(
            w, (tp_vec3){ 0, chance_fx(&chance, 3, 8), 0 }, (tp_turn)random_next(&chance),
            (tp_turn)(int32_t)chance_int(&chance, -0x18000000, -0x04000000),
            (tp_turn)random_next(&chance));
        tp_frame_begin(f.frame, w);
        for (uint32_t i = 0; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++)
            compare_tile(&f, &tile, &a);
        frame_free(&f);
        free(w);
    }
    printf(
        "    %d pixels within water, %d without any, %d picked otherwise, %d not within"
        " 1 %% of the depths around\n",
        a.water, a.other, a.wrong, a.far);
    assert_true(a.water > 3000 * count && a.other > 300 * count);
    assert_true(a.wrong < (a.water + a.other) / 1000);
    assert_true(a.far < a.water / 1000);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_place_is_where_a_pinhole_sees_it),
        cmocka_unit_test(places_far_outside_are_held),
        cmocka_unit_test(a_picked_place_projects_to_its_pixel),
        cmocka_unit_test(picks_agree_with_the_samples_of_tiles),
    };
    return cmocka_run_group_tests_name("frame/project", tests, NULL, NULL);
}
