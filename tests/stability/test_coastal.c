/* SPDX-License-Identifier: MIT */
/* Limits of waves over a floor: the waterline, cliffs, too strong wind, a mesh too
 * coarse for the waves, crossing rays.  The test prints the measured values of
 * [B7]-[B15].
 *
 *     TP_SOAK=1       twenty times as many coastal waters */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/finite_depth.h"
#include "tests/lib/coastal_water.h"

#define PI   3.14159265358979323846
#define SIDE 129                /* pixels of a map */

static uint64_t chance;

static int times(int usual)
{
    return getenv("TP_SOAK") != NULL ? 20 * usual : usual;
}

static coastal_water one_wave(double length, double amplitude, double steepness,
                              double heading)
{
    coastal_water o = { .count = 1, .config = coastal_usual() };
    o.wave[0] = coastal_wave(amplitude, length, steepness, heading);
    return o;
}

static tp_floor floor_of(double depth, double slope, double up)
{
    return (tp_floor){ .depth = (tp_fx)lround(depth * 65536),
                       .slope = (tp_fx)lround(slope * 65536),
                       .heading = (tp_fx)lround(up * 65536) };
}

/* -- the shallow limit --------------------------------------------------------------- */

typedef struct { double up, along; } extent;

/* Largest displacements over all phases at the origin, m; `whole`: with breaking. */
static extent extent_of(const coastal_water *o, bool whole)
{
    extent e = { 0, 0 };

    for (uint32_t n = 0; n < 64; n++) {
        const tp_turn phases[TP_WAVES] = { n << 26 };
        const tp_vec3 p =
            whole ? tp_coastal_displace_point(o->coastal, phases, 0, 0).position
                  : tp_coastal_displace_no_overhang(o->coastal, phases, 0, 0).position;
        e.up = fmax(e.up, abs(p.y) * LSB);
        e.along = fmax(e.along, hypot(p.x, p.z) * LSB);
    }
    return e;
}

/* The steepness is at the limit of [A11].  No height above 0.39 h, no displacement above
 * 0.95 / k. */
static void heights_go_to_0_with_the_depth(void **state)
{
    (void)state;
    printf("# level floors: height / depth, and way, m, of waves 2, 20 and 200 m long\n");
    for (int e = 3; e >= -16; e--) {
        const double h = ldexp(1, e);
        printf("# h = %-10.6g", h);
        for (double length = 2; length <= 200; length *= 10) {
            coastal_water o = one_wave(length, length / 20, 0.95, 90);
            o.config.floor = floor_of(h, 0, 0);
            coastal_build(&o);
            const extent s = extent_of(&o, false);
            const double k = ref_depth_number(2 * PI / length, fmax(h, 1 / 16.0));
            printf("   %.3f %9.5f", s.up / h, s.along);
            assert_true(s.up <= 0.39 * h + LSB);
            assert_true(s.along <= 0.951 / k + 2 * LSB);
            assert_true(h >= 1 / 16.0 || s.along <= 0.951 / k * h * 16 + 2 * LSB);
            coastal_end(&o);
        }
        printf("\n");
    }
}

/* -- shores -------------------------------------------------------------------------- */

/* Largest step of the surface over steps of 1/64 m towards the shore, from 30 m before to 2
 * m behind the shore, in m. */
static double jump_to_shore(const coastal_water *o, double shore, double z)
{
    const double d = 1 / 64.0;
    double most = 0;

    for (uint32_t n = 0; n < 8; n++) {
        const tp_turn phases[TP_WAVES] = { n << 29 };
        const double from = shore - 30;
        tp_vec3 last = { 0, 0, 0 };
        for (int k = 0; k * d < 32; k++) {
            const tp_fx x = (tp_fx)lround((from + k * d) * 65536);
            const tp_coastal_point p = tp_coastal_displace_no_overhang(
                o->coastal, phases, x, (tp_fx)(z * 65536));
            const tp_vec3 step = tp_vec3_sub(p.position, last);
            assert_true(p.depth > 0 || p.position.y == 0);
            assert_true(abs(p.position.y) <= tp_coastal_max_height(o->coastal));
            if (k > 0)
                most = fmax(most, hypot(hypot(step.x, step.y), step.z) * LSB);
            last = p.position;
        }
    }
    return most;
}

/* Horizontal displacement in 1/16 m of water comes to rest within 1/16 m of depth [B13]:
 * there the surface is stretched by 16 slope times the displacement; elsewhere 2.5 is
 * enough. */
static void walk(double slope, double length, double heading, double stretch[2])
{
    coastal_water o = one_wave(length, length / 30, 0.5, heading);
    coastal_water edge = o;
    o.config.floor = floor_of(8, slope, 90);
    edge.config.floor = floor_of(1 / 16.0, slope, 90);
    coastal_build(&o);
    coastal_build(&edge);
    const double along = extent_of(&edge, false).along;
    const double z = chance_double(&chance, -20, 20);
    const double jump = 64 * jump_to_shore(&o, 8 / slope, z);
    stretch[0] = fmax(stretch[0], jump);
    stretch[1] = fmax(stretch[1], 2.5 + 16 * slope * along * (1 + slope));
    assert_true(jump <= 2.5 + 16 * slope * along * (1 + slope));
    coastal_end(&o);
    coastal_end(&edge);
}

static void the_surface_ends_at_the_shore_without_a_jump(void **state)
{
    (void)state;
    static const double slopes[] = { 0.01, 0.03, 0.1, 0.3, 1 };
    static const double headings[] = { 90, 40, 0, 270 };

    printf("# surface between places 15.6 mm apart, as so many times that (bound), waves "
           "of 5 to 100 m\n# slope   to the shore  at 50 degrees       along it"
           "           away\n");
    for (int i = 0; i < 5; i++) {
        printf("# %5.2f", slopes[i]);
        for (int n = 0; n < 4; n++) {
            double stretch[2] = { 0, 0 };
            walk(slopes[i], 5, headings[n], stretch);
            walk(slopes[i], 22, headings[n], stretch);
            walk(slopes[i], 100, headings[n], stretch);
            printf("   %5.2f (%5.2f)", stretch[0], stretch[1]);
        }
        printf("\n");
    }
}

/* Orbits lie along the rising floor [B11]: across their tilt orbits are no higher than over
 * a level floor, but along the tilt orbits climb with all of their displacement. */
static void on_slopes_water_climbs_no_more_than_the_floor(void **state)
{
    (void)state;
    double climbs = 0, whole = 0;

    for (int n = 0; n < times(300); n++) {
        const double length = chance_scale(&chance, 2, 200) * LSB;
        const double h = chance_scale(&chance, 0.01, 8) * LSB;
        const double slope = chance_double(&chance, 0, 1);
        const bool ahead = n % 2;
        coastal_water o = one_wave(length, length / 25, chance_double(&chance, 0, 0.95),
                                   ahead ? 90 : 270);
        o.config.floor = floor_of(h, slope, 90);
        coastal_build(&o);
        const extent s = extent_of(&o, false), w = extent_of(&o, true);
        const double tilted = ahead ? slope * s.along : 0;
        assert_true(s.up <= 0.39 * h * (1 + slope) + tilted + 3 * LSB);
        climbs = fmax(climbs, s.up / h);
        whole = fmax(whole, w.up / h);
        coastal_end(&o);
    }
    printf("# slopes up to 1: water up to %.2f depths high, with what breaks %.2f\n",
           climbs, whole);
}

/* -- maps ---------------------------------------------------------------------------- */

static uint16_t sample[SIDE * SIDE];
static const tp_grey picture = { SIDE, SIDE, sample };

/* Draws soft hills and hollows. */
static void draw_hills(void)
{
    static double height[SIDE * SIDE];

    for (int i = 0; i < SIDE * SIDE; i++)
        height[i] = 0.3;
    for (int n = 0; n < 8; n++) {
        const double col = chance_double(&chance, 0, SIDE);
        const double row = chance_double(&chance, 0, SIDE);
        const double wide = chance_double(&chance, SIDE / 20.0, SIDE / 5.0);
        const double high = chance_double(&chance, -0.3, 0.7);
        for (int i = 0; i < SIDE * SIDE; i++)
            height[i] += high * exp(-(pow(i % SIDE - col, 2) + pow(i / SIDE - row, 2))
                                    / (2 * wide * wide));
    }
    for (int i = 0; i < SIDE * SIDE; i++)
        sample[i] = (uint16_t)lround(fmin(1, fmax(0, height[i])) * 65535);
}

static void draw_noise(void)
{
    for (int i = 0; i < SIDE * SIDE; i++)
        sample[i] = (uint16_t)random_next(&chance);
}

/* Black to the west, white to the east: the whole height between two pixels. */
static void draw_cliff(void)
{
    for (int i = 0; i < SIDE * SIDE; i++)
        sample[i] = i % SIDE < SIDE / 2 ? 0 : 65535;
}

static tp_floor map_of(double low, double high)
{
    return (tp_floor){ .map = &picture, .map_size = TP_FX(300),
                       .map_low = (tp_fx)lround(low * 65536),
                       .map_high = (tp_fx)lround(high * 65536) };
}

/* A rise counts as 8 m per metre at most.  Where the cliff leaves the water, all motion in
 * 1/16 m of depth ends within 8 mm: a step, but within the bound of the displacement. */
static void at_a_cliff_the_surface_stays_within_its_reach(void **state)
{
    (void)state;
    printf("# cliff of one pixel, m: steepest rise, longest step for one of 15.6 mm\n");
    for (int n = 0; n < times(6); n++) {
        const double low = chance_double(&chance, -40, -2);
        const double high = n % 2 ? chance_double(&chance, 0.1, 40)
                                  : chance_double(&chance, low / 2, -0.2);
        coastal_water o = one_wave(chance_fx(&chance, 5, 60) * LSB, 0.5, 0.5,
                                   n % 3 ? 90 : chance_double(&chance, 0, 360));
        draw_cliff();
        o.config.floor = map_of(low, high);
        coastal_build(&o);
        double rise = 0;
        for (double x = -5; x < 5; x += 0.01)
            rise = fmax(rise, LSB
                        * tp_coastal_floor(o.coastal, (tp_fx)(x * 65536), 0).rise_x);
        const double jump = jump_to_shore(&o, 15, chance_double(&chance, -99, 99));
        printf("# %6.2f to %6.2f  %5.2f  %.1f mm\n", low, high, rise, 1000 * jump);
        assert_true(rise <= 8);
        assert_true(jump <= 2 * tp_coastal_max_displacement(o.coastal) * LSB);
        coastal_end(&o);
    }
}

/* -- crests -------------------------------------------------------------------------- */

typedef struct {
    int    places;
    int    against_deep;        /* the phase falls along the direction of deep water ... */
    int    against_own;         /* ... or along the direction of the particles */
} slope_run;

/* The phase's gradient by points 0.1 m apart; the particles' own direction by a particle a
 * quarter turn behind the trough. */
static void look_at(const coastal_water *o, const coastal_water *moving, double heading,
                    slope_run *r)
{
    const tp_fx x = chance_fx(&chance, -170, 170), z = chance_fx(&chance, -170, 170);
    const tp_fx d = TP_FX(0.1), least = TP_FX(0.5);

    if (tp_coastal_floor(o->coastal, x, z).depth < least
        || tp_coastal_floor(o->coastal, x + d, z).depth < least
        || tp_coastal_floor(o->coastal, x, z + d).depth < least)
        return;
    const double here = coastal_phase(o, x, z);
    const double on_x = coastal_turns_from(here, coastal_phase(o, x + d, z));
    const double on_z = coastal_turns_from(here, coastal_phase(o, x, z + d));
    const tp_turn phases[TP_WAVES] = {
        (tp_turn)(uint64_t)llround((1.25 - here) * 4294967296.0)
    };
    const tp_vec3 p =
        tp_coastal_displace_no_overhang(moving->coastal, phases, x, z).position;
    r->places++;
    r->against_deep += on_x * sin(heading) - on_z * cos(heading) < -1e-4;
    r->against_own += on_x * (p.x - x) + on_z * (p.z - z)
                      < -1e-4 * hypot(p.x - x, p.z - z);
}

static slope_run crests_over(const tp_floor *floor, double length, double degrees)
{
    coastal_water o = one_wave(length, length / 40, 0, degrees), moving;
    slope_run r = { 0, 0, 0 };

    o.config.floor = *floor;
    moving = o;
    moving.wave[0].steepness = TP_FX(0.3);
    coastal_build(&o);
    coastal_build(&moving);
    for (int n = 0; n < 3000; n++)
        look_at(&o, &moving, degrees * PI / 180, &r);
    coastal_end(&o);
    coastal_end(&moving);
    return r;
}

static slope_run crests_over_maps(void (*draw)(void), double high, int maps)
{
    slope_run all = { 0, 0, 0 };

    for (int n = 0; n < times(maps); n++) {
        draw();
        const tp_floor floor = map_of(-12, high);
        const slope_run r = crests_over(&floor, chance_scale(&chance, 10, 60) * LSB,
                                        chance_double(&chance, 0, 360));
        all.places += r.places;
        all.against_deep += r.against_deep;
        all.against_own += r.against_own;
    }
    return all;
}

static void print_run(const char *what, const slope_run *r)
{
    printf("# %-24s %7d %14.3f %% %14.3f %%\n", what, r->places,
           100.0 * r->against_deep / r->places, 100.0 * r->against_own / r->places);
}

/* Over slopes never.  Behind hills rays turn far and cross; there the first arrival counts,
 * and where two arrivals meet the phase has an edge that a map's nodes blur. */
static void crests_run_backwards_over_no_slope_and_hardly_any_map(void **state)
{
    (void)state;
    slope_run slopes = { 0, 0, 0 };

    printf("# crests                     places  against the swell  their own way\n");
    for (int n = 0; n < times(20); n++) {
        const tp_floor floor = floor_of(chance_double(&chance, 1, 30),
                                        chance_scale(&chance, 0.001, 1) * LSB,
                                        chance_double(&chance, 0, 360));
        const slope_run r = crests_over(&floor, chance_scale(&chance, 5, 200) * LSB,
                                        chance_double(&chance, 0, 360));
        slopes.places += r.places;
        slopes.against_deep += r.against_deep;
        slopes.against_own += r.against_own;
    }
    const slope_run hills = crests_over_maps(draw_hills, -1, 6);
    const slope_run islands = crests_over_maps(draw_hills, 3, 6);
    const slope_run cliffs = crests_over_maps(draw_cliff, 3, 4);
    const slope_run noise = crests_over_maps(draw_noise, 3, 4);
    print_run("slopes", &slopes);
    print_run("hills under water", &hills);
    print_run("islands", &islands);
    print_run("cliffs", &cliffs);
    print_run("noise in every pixel", &noise);
    assert_true(slopes.against_deep == 0 && slopes.against_own == 0);
    assert_true(hills.against_own <= 0.005 * hills.places);
    assert_true(islands.against_own <= 0.01 * islands.places);
    assert_true(cliffs.against_own <= 0.01 * cliffs.places);
}

/* -- wind ---------------------------------------------------------------------------- */

/* Smallest step of the surface for a step of the rest position, relative: below 0 the crest
 * has a loop. */
static double least_step(const coastal_water *o, double length)
{
    const tp_fx d = (tp_fx)(length / 512 * 65536) + 1;
    double least = 9;

    for (uint32_t n = 0; n < 4; n++) {
        const tp_turn phases[TP_WAVES] = { (tp_turn)random_next(&chance) };
        tp_fx last = tp_coastal_displace_no_overhang(o->coastal, phases, 0, 0).position.x;
        for (int k = 1; k <= 1024; k++) {
            const tp_fx x =
                tp_coastal_displace_no_overhang(o->coastal, phases, k * d, 0).position.x;
            least = fmin(least, (double)(x - last) / d);
            last = x;
        }
    }
    return least;
}

/* lambda r at its bound of 0.5 and far beyond, on waves of the largest steepness [B10]. */
static void no_wind_makes_loops(void **state)
{
    (void)state;
    static const double push[] = { 0, 0.3, 0.44, 0.5, 0.8, 3, 16 };
    static const double depth[] = { 0, 30, 8, 2 };

    printf("# lambda r  least step of the surface: deep, over 30, 8 and 2 m\n");
    for (int i = 0; i < 7; i++) {
        printf("# %8.2f", push[i]);
        for (int n = 0; n < 4; n++) {
            double least = 9;
            for (int k = 0; k < times(12); k++) {
                const double length = chance_scale(&chance, 5, 300) * LSB;
                const double amplitude = fmin(16, length / 18);
                coastal_water o = one_wave(length, amplitude, 1, 90);
                o.config.wind = (tp_fx)lround(push[i] / amplitude * 65536);
                o.config.wind_heading = TP_FX(90);
                o.config.floor = floor_of(depth[n], 0, 0);
                coastal_build(&o);
                least = fmin(least, least_step(&o, length));
                coastal_end(&o);
            }
            printf("  %7.4f", least);
            assert_true(least > 0.04);          /* 1 - 0.951, and roundings */
        }
        printf("\n");
    }
}

/* -- meshes that are too coarse ------------------------------------------------------ */

/* Largest height of grid points `cell` apart, and largest error between the points, where a
 * line joins two neighbours; relative to the wave's height. */
static extent alias_of(const coastal_water *o, double cell, double height)
{
    const tp_turn phases[TP_WAVES] = { (tp_turn)random_next(&chance) };
    extent e = { 0, 0 };

    for (int k = 0; k < 400; k++) {
        const tp_fx x[3] = { (tp_fx)(k * cell * 65536), (tp_fx)((k + 0.5) * cell * 65536),
                             (tp_fx)((k + 1) * cell * 65536) };
        double y[3];
        for (int i = 0; i < 3; i++)
            y[i] = tp_coastal_displace_no_overhang(o->coastal, phases, x[i], 0).position.y
                   * LSB / height;
        e.up = fmax(e.up, fabs(y[0]));
        e.along = fmax(e.along, fabs((y[0] + y[2]) / 2 - y[1]));
    }
    return e;
}

/* A line between two points of a sine has an error of 1 - cos(pi / points per wave). */
static void waves_shorter_than_two_cells_stay_within_their_height(void **state)
{
    (void)state;
    static const double points[] = { 16, 8, 4, 2, 1.5, 1, 0.6, 0.31 };

    printf("# points a wave  highest  missed between points  1 - cos(pi / points)\n");
    for (int i = 0; i < 8; i++) {
        const double length = chance_scale(&chance, 4, 40) * LSB;
        coastal_water o = one_wave(length, length / 40, 0, 90);
        o.config.floor = floor_of(20, 0, 0);
        coastal_build(&o);
        const double height = tp_coastal_max_height(o.coastal) * LSB;
        const double k = ref_depth_number(2 * PI / length, 20);
        const extent at = extent_of(&o, false);
        const extent e = alias_of(&o, 2 * PI / k / points[i], at.up);
        const double model = points[i] >= 1 ? 1 - cos(PI / points[i]) : 2;
        printf("# %13.2f  %7.4f  %21.4f  %20.4f\n", points[i], e.up, e.along, model);
        assert_true(e.up * at.up <= height);
        assert_true(e.up <= 1.005 && e.along <= model + 0.01);
        coastal_end(&o);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(heights_go_to_0_with_the_depth),
        cmocka_unit_test(the_surface_ends_at_the_shore_without_a_jump),
        cmocka_unit_test(on_slopes_water_climbs_no_more_than_the_floor),
        cmocka_unit_test(at_a_cliff_the_surface_stays_within_its_reach),
        cmocka_unit_test(crests_run_backwards_over_no_slope_and_hardly_any_map),
        cmocka_unit_test(no_wind_makes_loops),
        cmocka_unit_test(waves_shorter_than_two_cells_stay_within_their_height),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("stability of oceans", tests, NULL, NULL);
}
