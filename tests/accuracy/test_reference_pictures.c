/* SPDX-License-Identifier: MIT */
/* Checks textures on the reference's water against closed forms: layers with filter, tones
 * and drift, the distortion, ripples, and pools. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "world/pools.h"
#include "tests/lib/reference_scenes.h"

enum { TICKS = 90 };

static uint64_t seed;

static tp_scene_map any_map(void)
{
    return (tp_scene_map){ .size = chance_scale(&seed, 0.5, 40),
                           .drift_x = chance_fx(&seed, -2, 2),
                           .drift_z = chance_fx(&seed, -2, 2) };
}

static tp_scene scene_pictured(bool linear)
{
    tp_scene s = scene_level();

    s.camera.pitch = -50 * TP_FX_ONE;
    s.camera.heading = chance_fx(&seed, -180, 180);
    s.camera.x = chance_fx(&seed, -50, 50);
    s.camera.z = chance_fx(&seed, -50, 50);
    s.light.ambient = TP_FX_ONE;
    s.water.reflection = 0;
    s.water.colour = 0xc0ff80;
    s.water.filter = linear ? TP_FILTER_LINEAR : TP_FILTER_NEAREST;
    for (int i = 0; i < TP_LAYERS; i++)
        s.layer[i] = (tp_scene_layer){ .map = any_map(), .saturation = TP_FX_ONE,
                                       .colour = 0xffffff };
    return s;
}

/* Point where a look meets level water, m. */
static void meet(const view_of_ref *v, sight_angles to, double at[2])
{
    const double far = v->world->eye.y / 65536.0 / tan(-to.elevation);

    at[0] = v->world->eye.x / 65536.0 + far * sin(to.azimuth);
    at[1] = v->world->eye.z / 65536.0 - far * cos(to.azimuth);
}

/* Texture place in repeats: the texture has drifted since tick 0. */
static void place_in(const tp_scene_map *map, const double at[2], double place[2])
{
    const double seconds = TICKS / (double)TP_TICKS_PER_SECOND;

    place[0] = (at[0] * 65536 - map->drift_x * seconds) / map->size;
    place[1] = (at[1] * 65536 - map->drift_z * seconds) / map->size;
}

static double texel_of(const noise_picture *p, const double place[2], bool linear, int k)
{
    return linear ? tents_of(p, place[0], place[1], k)
                  : texel_at(p, place[0], place[1], k);
}

/* Adds a difference unless the expected value is NAN. */
static void add(measure *off, double got, double want, int n, int k)
{
    if (!isnan(want))
        measure_add(off, got - want, n, k, 0);
}

/* The first layer is multiplied by the water's colour; the other layers are added, up to
 * white. */
static void layers_lie_and_drift_as_their_maps_say(void **state)
{
    (void)state;
    for (int linear = 0; linear < 2; linear++) {
        measure off = { .what = linear ? "linear layers" : "nearest layers",
                        .unit = "of 255" };
        for (int n = 0; n < 600; n++) {
            static noise_picture p[TP_LAYERS];
            view_of_ref v = { .scene = scene_pictured(linear) };
            const int layers = 1 + n % TP_LAYERS;
            double at[2], place[2];
            for (int i = 0; i < layers; i++)
                v.assets.layer[i] = noise_of(&p[i], &seed);
            view_open_at(&v, 64, 48, TICKS);
            const sight_angles to = sight_any(&v, &seed, -PI / 2, -0.2);
            const ref_seen seen = sight_look(&v, to);
            meet(&v, to, at);
            for (int k = 0; k < 3; k++) {
                double sum = 0;
                for (int i = 0; i < layers; i++) {
                    place_in(&v.scene.layer[i].map, at, place);
                    const double c = texel_of(&p[i], place, linear, k);
                    sum = i ? fmin(255, sum + c)
                            : c * channel(v.scene.water.colour, k) / 255;
                }
                add(&off, seen.colour.c[k], sum, n, k);
            }
            view_close(&v);
        }
        measure_print(&off);
        assert_true(off.inputs > 1700);
        assert_true(off.worst < 1e-8);
    }
}

/* Tones of a layer: saturation about the grey, clamped to 0..1; the values above the clamp
 * threshold spread over 0..1; then the layer's own colour. */
static void a_layer_is_toned(void **state)
{
    measure off = { .what = "tones", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 600; n++) {
        view_of_ref v = { .scene = scene_pictured(false) };
        tp_scene_layer *layer = &v.scene.layer[0];
        const int32_t texel = chance_int(&seed, 0, 0xffffff);
        plain_picture p;
        layer->saturation = chance_fx(&seed, 0, 3);
        layer->clamp = chance_fx(&seed, 0, 0.9);
        layer->colour = chance_int(&seed, 0, 0xffffff);
        v.assets.layer[0] = plain_of(&p, (uint32_t)texel);
        view_open(&v, 64, 48);
        const ref_seen seen = sight_look(&v, sight_any(&v, &seed, -PI / 2, -0.2));
        const double grey = (77 * channel(texel, 0) + 150 * channel(texel, 1)
                             + 29 * channel(texel, 2)) / 256;
        const double low = 255 * (layer->clamp / 65536.0);
        for (int k = 0; k < 3; k++) {
            const double vivid = between(grey, channel(texel, k),
                                         layer->saturation / 65536.0);
            const double left = fmax(low, fmin(255, vivid)) - low;
            add(&off, seen.colour.c[k], left / (255 - low) * channel(layer->colour, k)
                                        / 255 * channel(v.scene.water.colour, k), n, k);
        }
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-10);
}

/* The distortion map's red moves a layer to the east, green to the south, by at most the
 * strength. The distortion map is bilinear with each of the water's filters. */
static void a_distortion_moves_the_layers(void **state)
{
    measure off = { .what = "distortion", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 600; n++) {
        static noise_picture bend, p;
        view_of_ref v = { .scene = scene_pictured(n % 2) };
        double at[2], place[2];
        v.scene.distortion.map = any_map();
        v.scene.distortion.strength = chance_fx(&seed, 0.05, 3);
        v.assets.distortion = noise_of(&bend, &seed);
        v.assets.layer[0] = noise_of(&p, &seed);
        view_open_at(&v, 64, 48, TICKS);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, -0.2);
        const ref_seen seen = sight_look(&v, to);
        meet(&v, to, at);
        place_in(&v.scene.distortion.map, at, place);
        for (int k = 0; k < 2; k++)
            at[k] += (texel_of(&bend, place, true, k) / 128 - 1)
                   * v.scene.distortion.strength / 65536.0;
        place_in(&v.scene.layer[0].map, at, place);
        for (int k = 0; k < 3; k++)
            add(&off, seen.colour.c[k], texel_of(&p, place, n % 2, k)
                                        * channel(v.scene.water.colour, k) / 255, n, k);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-8);
}

/* A normal map tilts the surface by the texel's slope at each place: the Fresnel share of a
 * ramp follows the tilt. */
static void ripples_lie_as_their_map_says(void **state)
{
    measure off = { .what = "ripples", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < 600; n++) {
        static noise_picture p;
        view_of_ref v = { .scene = scene_pictured(false) };
        double at[2], place[2], t[3];
        v.scene.ripple.map = any_map();
        v.scene.ripple.bump = chance_fx(&seed, 0.1, 1);
        v.scene.light.ambient = 0;
        v.scene.light.elevation = chance_fx(&seed, 40, 90);
        v.assets.ripple = noise_of(&p, &seed);
        view_open_at(&v, 64, 48, TICKS);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, -0.2);
        const ref_seen seen = sight_look(&v, to);
        meet(&v, to, at);
        place_in(&v.scene.ripple.map, at, place);
        for (int k = 0; k < 3; k++)
            t[k] = texel_of(&p, place, true, k) / 128 - 1;
        const double bump = v.scene.ripple.bump / 65536.0, up = fmax(0.125, t[2]);
        const double slant = hypot(t[0], t[1]) * bump;
        const sight_angles normal = { atan2(t[0], t[1]), atan2(up, slant) };
        for (int k = 0; k < 3; k++)
            add(&off, seen.colour.c[k],
                channel(v.scene.water.colour, k)
                * fmax(0, sight_cos(normal, sight_light(&v))), n, k);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-8);
}

/* -- pools ------------------------------------------------------------------------- */

enum { CELLS = 32 };
#define CELL 0.5                /* m */

static double height_at(const view_of_ref *v, int col, int row)
{
    return tp_pool_height_lsb(tp_world_pool(v->world), (uint32_t)col, (uint32_t)row)
         * (v->scene.pool.max_height / 65536.0) / 32767;
}

/* Pool after a poke, seen from 6 m above and 5 m before its middle. */
static void open_poked(view_of_ref *v, bool bump)
{
    tp_scene *s = &v->scene;
    const tp_input poke = { .push[0] = { TP_FX(0.8), chance_fx(&seed, -3, 3),
                                         chance_fx(&seed, -3, 3) } };

    s->pool.cols = s->pool.rows = CELLS;
    s->pool.cell_bits = TP_CELLS_16;
    s->pool.cell = TP_FX(CELL);
    s->pool.max_height = TP_FX_ONE;
    s->water.pool_normal_strength = bump ? chance_fx(&seed, 0.5, 2) : 0;
    s->camera.heading = 0;
    s->camera.x = 0;
    s->camera.y = 6 * TP_FX_ONE;
    s->camera.z = 5 * TP_FX_ONE;
    v->world = scene_world(s, &v->assets);
    tp_world_step(&tp_program_all, v->world, s, &poke);
    while (v->world->tick < 12)
        tp_world_step(&tp_program_all, v->world, s, NULL);
    ref_scene_open(&v->ref, s, &v->assets, v->world, 64, 48, false);
}

/* At a cell's centre the slope is the difference of the neighbouring cells times the bump.
 * Without bump mapping the surface is also at the cell's height. */
static void pools_are_as_steep_as_their_cells(void **state)
{
    (void)state;
    for (int bump = 0; bump < 2; bump++) {
        measure off = { .what = bump ? "bent by a pool" : "a pool", .unit = "of 255" };
        double most = 0;
        for (int n = 0; n < 100; n++) {
            view_of_ref v = { .scene = scene_pictured(false) };
            v.scene.light.ambient = 0;
            v.scene.light.elevation = 50 * TP_FX_ONE;
            open_poked(&v, bump);
            const int col = chance_int(&seed, 12, 19), row = chance_int(&seed, 12, 19);
            const double by = bump ? v.scene.water.pool_normal_strength / 65536.0 : 1;
            const double x = (col + 0.5 - CELLS / 2) * CELL;
            const double z = (row + 0.5 - CELLS / 2) * CELL;
            const double high = bump ? 0 : height_at(&v, col, row);
            const double east = by * (height_at(&v, col + 1, row)
                                      - height_at(&v, col - 1, row)) / (2 * CELL);
            const double south = by * (height_at(&v, col, row + 1)
                                       - height_at(&v, col, row - 1)) / (2 * CELL);
            const sight_angles normal = { atan2(-east, south),
                                          atan2(1, hypot(east, south)) };
            const double cosine = fmax(0, sight_cos(normal, sight_light(&v)));
            const ref_seen seen = sight_look(&v, (sight_angles){ atan2(x, 5 - z),
                                                  -atan2(6 - high, hypot(x, 5 - z)) });
            most = fmax(most, hypot(east, south));
            for (int k = 0; k < 3; k++)
                add(&off, seen.colour.c[k], channel(v.scene.water.colour, k) * cosine, n,
                    k);
            view_close(&v);
        }
        measure_print(&off);
        printf("    slopes up to %.3f\n", most);
        assert_true(most > 0.05);
        assert_true(off.worst < 1e-7);      /* roots are within 1e-10 m */
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layers_lie_and_drift_as_their_maps_say),
        cmocka_unit_test(a_layer_is_toned),
        cmocka_unit_test(a_distortion_moves_the_layers),
        cmocka_unit_test(ripples_lie_as_their_map_says),
        cmocka_unit_test(pools_are_as_steep_as_their_cells),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
