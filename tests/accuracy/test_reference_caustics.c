/* SPDX-License-Identifier: MIT */
/* Checks the reference's caustics against closed forms in a plane: a wave along an axis
 * under a sun in the wave's own plane, where light follows from angles in one
 * dimension. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/reference_scenes.h"
#include "tools/reference/caustics.h"

static uint64_t seed;

/* -- light in a plane ---------------------------------------------------------------- */

enum { PARTS = 600, SCENES = 20 };

/* The plane of wave and sun: u along the wave's heading. */
typedef struct {
    const ref_surface *sea;     /* shape of the surface, or NULL: a sine */
    double amplitude, k, phase; /* of the sine; m, rad/m, rad */
    double x, z;                /* heading as a unit vector */
    double sun;                 /* angle of the sun's ray from straight down towards +u */
    double low, high;           /* the water, m of u */
    double depth;               /* of the point that is lit, m */
} slice;

static double slice_height(const slice *p, double u)
{
    double rest[2] = { u * p->x, u * p->z };

    return p->sea ? ref_surface_height(p->sea, u * p->x, u * p->z, rest, 1e-13)
                  : p->amplitude * sin(p->k * u + p->phase);
}

/* Place at depth where the light from u arrives, less the way under still water. The ray
 * keeps its angle to the normal by Snell's law; the surface is tilted by its slope. */
static double slice_place(const slice *p, double u)
{
    const double d = 1e-5, high = slice_height(p, u);
    const double tilt = atan((slice_height(p, u + d) - slice_height(p, u - d)) / (2 * d));
    const double bent = tilt + asin(sin(p->sun - tilt) / WATER);

    return u + (p->depth + high) * tan(bent)
         - p->depth * tan(asin(sin(p->sun) / WATER));
}

/* Light at u per width at the place: the width across the sun's rays over the width at
 * depth. */
static double slice_gain(const slice *p, double u)
{
    const double d = 1e-4, sun = tan(p->sun);
    const double in = 2 * d + sun * (slice_height(p, u + d) - slice_height(p, u - d));

    return fmax(0, in) / fabs(slice_place(p, u + d) - slice_place(p, u - d));
}

/* Adds the light of all u whose light arrives at `at`: roots are bracketed by PARTS equal
 * steps, then halved. Returns their number. */
static int slice_add(const slice *p, double at, double *light)
{
    int roots = 0;
    double a = p->low, fa = slice_place(p, a) - at;

    for (int n = 1; n <= PARTS; n++) {
        double b = p->low + (p->high - p->low) * n / PARTS;
        const double fb = slice_place(p, b) - at, next = b;
        for (int i = 0; i < 50 && (fa < 0) != (fb < 0); i++) {
            const double middle = (a + b) / 2;
            if ((slice_place(p, middle) - at < 0) == (fa < 0))
                a = middle;
            else
                b = middle;
        }
        if ((fa < 0) != (fb < 0)) {
            *light += slice_gain(p, a);
            roots++;
        }
        a = next;
        fa = fb;
    }
    return roots;
}

/* Light between two walls, each of which is a mirror. */
static int slice_mirrored(const slice *p, double at, double *light)
{
    const double side = p->high - p->low;
    const double in = fabs(remainder(at - p->low, 2 * side));

    *light = 0;
    return slice_add(p, p->low + in, light) + 10 * slice_add(p, p->low - in, light)
         + 100 * slice_add(p, p->high + (side - in), light);
}

/* Range of the light within two cells of the reference's grid, whose light is the mean of
 * a cell; a hundredth more for extremes between the nine samples. Returns false if a fold
 * ends within that range: light is infinite there. */
static bool slice_range(const slice *p, double at, double cell, bool walled,
                        double range[2])
{
    int roots = -1;

    range[0] = HUGE_VAL;
    range[1] = 0;
    for (int n = -4; n <= 4; n++) {
        double light = 0;
        const double place = at + n * cell / 2;
        const int here = walled ? slice_mirrored(p, place, &light)
                                : slice_add(p, place, &light);
        if (roots >= 0 && here != roots)
            return false;
        roots = here;
        range[0] = fmin(range[0], 0.99 * light - 1e-3);
        range[1] = fmax(range[1], 1.01 * light + 1e-3);
    }
    return true;
}

/* -- scenes -------------------------------------------------------------------------- */

#define SIDE 4.0                /* of the tank, m */

/* Wave along an axis, and the sun in its plane. */
static void add_wave(tp_scene *s, double amplitude)
{
    const int32_t heading = 90 * chance_int(&seed, 0, 3);

    s->wave[0].amplitude = (tp_fx)(65536 * amplitude);
    s->wave[0].length = chance_fx(&seed, 1, 3);
    s->wave[0].steepness = 0;
    s->wave[0].heading = heading * TP_FX_ONE;
    s->wave[0].phase = chance_int(&seed, 0, 359) * TP_FX_ONE;
    s->light.heading = (heading + 180 * chance_int(&seed, 0, 1)) % 360 * TP_FX_ONE;
    s->light.elevation = chance_fx(&seed, 30, 90);
    s->light.ambient = chance_fx(&seed, 0, 0.8);
    s->water.caustics = chance_fx(&seed, 0.3, 1.5);
    s->water.caustic_cells = 128;
}

/* Tank of water, with the eye a tenth of the depth under the level. */
static tp_scene scene_walled(double amplitude)
{
    tp_scene s = scene_clear_any(&seed);

    add_wave(&s, amplitude);
    s.tank.kind = TP_TANK_STONE;
    s.tank.depth = chance_fx(&seed, 1, 3);
    s.tank.rim = TP_FX_ONE / 4;
    s.tank.floor_colour = chance_int(&seed, 0, 0xffffff);
    s.pool.cols = s.pool.rows = 32;
    s.pool.cell = TP_FX(SIDE / 32);
    s.pool.cell_bits = TP_CELLS_16;
    s.pool.max_height = TP_FX_ONE;
    s.pool.x = chance_fx(&seed, -9, 9);
    s.pool.z = chance_fx(&seed, -9, 9);
    s.camera.x = s.pool.x + chance_fx(&seed, -1.5, 1.5);
    s.camera.z = s.pool.z + chance_fx(&seed, -1.5, 1.5);
    s.camera.y = -s.tank.depth / 10 - (tp_fx)(65536 * amplitude);
    s.camera.heading = chance_fx(&seed, -180, 180);
    s.camera.pitch = chance_fx(&seed, -89, -30);
    return s;
}

static slice slice_of(const view_of_ref *v, double depth)
{
    const tp_scene *s = &v->scene;
    const double heading = s->wave[0].heading / 65536.0 * PI / 180;
    const sight_angles light = sight_light(v);
    slice p = {
        .amplitude = s->wave[0].amplitude / 65536.0,
        .k = 2 * PI / (s->wave[0].length / 65536.0),
        .phase = s->wave[0].phase / 65536.0 * PI / 180,
        .x = round(sin(heading)), .z = round(-cos(heading)), .depth = depth,
        .sun = -atan(cos(light.azimuth - heading) / tan(light.elevation)),
    };
    const double middle = (s->pool.x * p.x + s->pool.z * p.z) / 65536;

    p.low = middle - SIDE / 2;
    p.high = middle + SIDE / 2;
    return p;
}

/* Map place of a point in the slice. */
static double slice_map(const slice *p, double x, double z, double depth)
{
    return x * p->x + z * p->z - depth * tan(asin(sin(p->sun) / WATER));
}

/* Points anywhere in the water of a tank, as on walls: at less depth light is less
 * focused. */
static void waves_focus_light_as_angles_say(void **state)
{
    measure off = { .what = "light outside its range", .unit = "of 1" };
    double least = 1, most = 1;

    (void)state;
    for (int n = 0; n < SCENES; n++) {
        view_of_ref v = { .scene = scene_walled(chance_double(&seed, 0.005, 0.06)) };
        view_open(&v, 64, 48);
        for (int i = 0; i < 30; i++) {
            const double x = v.scene.pool.x / 65536.0 + chance_double(&seed, -2, 2);
            const double z = v.scene.pool.z / 65536.0 + chance_double(&seed, -2, 2);
            const double depth = v.scene.tank.depth / 65536.0
                               * chance_double(&seed, 0.1, 1);
            const slice p = slice_of(&v, depth);
            double range[2];
            if (!slice_range(&p, slice_map(&p, x, z, depth), v.ref.caustics->cell, true,
                             range))
                continue;
            const double light = ref_caustics_light(v.ref.caustics,
                                                    (ref_vec){ x, -depth, z });
            measure_add(&off, fmax(0, fmax(range[0] - light, light - range[1])), n, i, 0);
            least = fmin(least, light);
            most = fmax(most, light);
        }
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.inputs > 22 * SCENES && least < 0.8 && most > 2);
    assert_true(off.worst < 1e-9);
}

/* Colour of the floor in this light, before the water absorbs a part. */
static double floor_of(const view_of_ref *v, double light, int k)
{
    const double ambient = v->scene.light.ambient / 65536.0;
    const double factor = 1 + v->scene.water.caustics / 65536.0 * (light - 1);
    const double sun = wet_cos(v, (sight_angles){ 0, PI / 2 }) * fmax(0, factor);

    return fmin(255, channel(v->scene.tank.floor_colour, k) * tint_of(&v->scene, k)
                     * (ambient + (1 - ambient) * sun));
}

/* Measures a look at the lit floor. */
static void measure_floor(measure *off, view_of_ref *v, int n)
{
    const sight_angles to = sight_any(v, &seed, -PI / 2, -0.3);
    const double depth = v->scene.tank.depth / 65536.0;
    const double way = (v->world->eye.y / 65536.0 + depth) / -sin(to.elevation);
    const double level = way * cos(to.elevation);
    const double x = v->world->eye.x / 65536.0 + level * sin(to.azimuth);
    const double z = v->world->eye.z / 65536.0 - level * cos(to.azimuth);
    const slice p = slice_of(v, depth);
    double range[2];

    if (fabs(x - v->scene.pool.x / 65536.0) >= SIDE / 2
        || fabs(z - v->scene.pool.z / 65536.0) >= SIDE / 2
        || !slice_range(&p, slice_map(&p, x, z, depth), v->ref.caustics->cell, true, range))
        return;
    const ref_seen seen = sight_look(v, to);
    for (int k = 0; k < 3; k++) {
        const double deep = channel(v->scene.water.deep_colour, k);
        const double a = beer_of(&v->scene, floor_of(v, range[0], k), deep, way, k);
        const double b = beer_of(&v->scene, floor_of(v, range[1], k), deep, way, k);
        measure_add(off, fmax(0, fmax(fmin(a, b) - seen.colour.c[k],
                                      seen.colour.c[k] - fmax(a, b))), n, k, 0);
    }
}

/* The floor as an eye under water sees it: the strength scales the contrast of the
 * sunlight, the ambient light stays. */
static void a_lit_floor_is_seen_under_water(void **state)
{
    measure off = { .what = "floor outside its range", .unit = "of 255" };

    (void)state;
    for (int n = 0; n < SCENES; n++) {
        view_of_ref v = { .scene = scene_walled(chance_double(&seed, 0.005, 0.04)) };
        view_open(&v, 64, 48);
        for (int i = 0; i < 5; i++)
            measure_floor(&off, &v, n);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.inputs > 5 * SCENES);
    assert_true(off.worst < 1e-8);
}

static tp_scene scene_floored(double amplitude)
{
    tp_scene s = scene_clear_any(&seed);

    add_wave(&s, amplitude);
    s.floor.depth = chance_fx(&seed, 1, 6);
    s.water.caustic_size = chance_fx(&seed, 5, 10);
    s.camera.x = chance_fx(&seed, -9, 9);
    s.camera.z = chance_fx(&seed, -9, 9);
    s.camera.pitch = 0;
    s.camera.heading = chance_fx(&seed, -180, 180);
    return s;
}

static void still_water_changes_no_light(void **state)
{
    measure off = { .what = "still water", .unit = "of 1" };

    (void)state;
    for (int n = 0; n < SCENES / 2; n++) {
        view_of_ref v = { .scene = n % 2 ? scene_walled(0) : scene_floored(0) };
        view_open(&v, 64, 48);
        for (int i = 0; i < 500; i++) {
            const double depth =
                (n % 2 ? v.scene.tank.depth : v.scene.floor.depth) / 65536.0;
            const ref_vec eye = v.ref.camera.eye;
            const ref_vec at = { eye.x + chance_double(&seed, -9, 9),
                                 -depth * chance_double(&seed, 0, 1),
                                 eye.z + chance_double(&seed, -9, 9) };
            measure_add(&off, ref_caustics_factor(v.ref.caustics, at) - 1, n, i, 0);
        }
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-9);
}

/* Returns the mean light of the tank's floor, by one point in each of side x side squares. */
static double mean_light(const ref_scene *s, double depth, int side)
{
    const ref_caustics *c = s->caustics;
    double sum = 0;

    for (int i = 0; i < side * side; i++) {
        const double a = (i % side + chance_double(&seed, 0, 1)) / side;
        const double b = ((double)(i / side) + chance_double(&seed, 0, 1)) / side;
        sum += ref_caustics_light(c, (ref_vec){ c->low[0] + SIDE * a, -depth,
                                                c->low[1] + SIDE * b });
    }
    return sum / side / side;
}

/* Walls mirror all light that meets them, so a tank with a wave and a splash neither gains
 * nor loses light of a sun overhead. The sum takes one point in each of 300 x 300 squares;
 * it converges slowly where lines of light are sharp, so a sum that is off is taken again
 * with 16 times as many. */
static void walls_keep_the_light_in_the_tank(void **state)
{
    enum { POINTS = 300 };
    measure off = { .what = "mean of the light", .unit = "of 1" };

    (void)state;
    for (int n = 0; n < SCENES / 4; n++) {
        view_of_ref v = { .scene = scene_walled(0.06) };
        const tp_input poke = { .push[0] = { TP_FX(0.2), v.scene.pool.x + TP_FX(1),
                                             v.scene.pool.z + chance_fx(&seed, -1, 1) } };
        v.scene.light.elevation = 90 * TP_FX_ONE;
        v.world = scene_world(&v.scene, &v.assets);
        tp_world_step(&tp_program_all, v.world, &v.scene, &poke);
        ref_scene_open(&v.ref, &v.scene, &v.assets, v.world, 64, 48, false);
        const double depth = v.scene.tank.depth / 65536.0;
        double light = mean_light(&v.ref, depth, POINTS);
        if (fabs(light - 1) >= 0.015)
            light = mean_light(&v.ref, depth, 4 * POINTS);
        measure_add(&off, light - 1, n, 0, 0);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(off.worst < 0.015);     /* 0.04 without the mirrors */
}

/* Caustics of a sea fill a square ahead of the eye, placed in whole cells of the engine's
 * map, and fade out within the outer eighth of its side. */
static void caustics_of_a_sea_end_with_their_square(void **state)
{
    measure off = { .what = "factor outside its range", .unit = "of 1" };
    int outside = 0;

    (void)state;
    for (int n = 0; n < 12; n++) {
        view_of_ref v = { .scene = scene_floored(chance_double(&seed, 0.01, 0.04)) };
        view_open(&v, 64, 48);
        const double side = v.scene.water.caustic_size / 65536.0, cell = side / 128;
        const double heading = radians(v.world->heading);
        const ref_vec middle = { v.world->eye.x / 65536.0 + 0.4 * side * sin(heading), 0,
                                 v.world->eye.z / 65536.0 - 0.4 * side * cos(heading) };
        for (int i = 0; i < 30; i++) {
            const double depth = v.scene.floor.depth / 65536.0;
            const double dx = chance_double(&seed, -side, side);
            const double dz = chance_double(&seed, -side, side);
            const double far = fmax(fabs(dx), fabs(dz)) / side;
            slice p = slice_of(&v, depth);
            p.sea = &v.ref.surface;
            p.low = middle.x * p.x + middle.z * p.z - side;
            p.high = p.low + 2 * side;
            const double still = tan(asin(sin(p.sun) / WATER)) * depth;
            const ref_vec at = { middle.x + dx + still * p.x, -depth,
                                 middle.z + dz + still * p.z };
            const double factor = ref_caustics_factor(v.ref.caustics, at);
            double range[2] = { 1, 1 };
            if (far < 0.5 + cell / side && far > 0.375 - cell / side)
                continue;
            outside += far > 0.5;
            if (far < 0.5 && !slice_range(&p, slice_map(&p, at.x, at.z, depth),
                                          v.ref.caustics->cell, false, range))
                continue;
            for (int k = 0; k < 2; k++)
                range[k] = fmax(0, 1 + v.scene.water.caustics / 65536.0 * (range[k] - 1));
            measure_add(&off, fmax(0, fmax(range[0] - factor, factor - range[1])), n, i, 0);
        }
        view_close(&v);
    }
    measure_print(&off);
    assert_true(outside > 30 && off.inputs > (uint64_t)outside + 15);
    assert_true(off.worst < 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(waves_focus_light_as_angles_say),
        cmocka_unit_test(a_lit_floor_is_seen_under_water),
        cmocka_unit_test(still_water_changes_no_light),
        cmocka_unit_test(walls_keep_the_light_in_the_tank),
        cmocka_unit_test(caustics_of_a_sea_end_with_their_square),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
