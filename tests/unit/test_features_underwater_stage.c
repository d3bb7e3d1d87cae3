/* SPDX-License-Identifier: MIT */
/* The stages that look into the water, each compared with rays and Beer's law in double
 * precision.  Errors are in levels of 255.  Three kinds of samples do not count: rays with
 * two faces within 2 cm and 2 % of their length, rays turned out of the water again by a
 * steep ripple, and samples nearer than the near plane or within 1 mm of the glass's rim. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/water_ray.h"
#include "features/underwater/underwater.h"
#include "world/world.h"
#include "shade/refracted_ray.h"
#include "tests/lib/shading.h"

enum { RUNS = 1500 };

static uint64_t chance;

typedef struct {
    measure most;
    double  square;
} span_error;

static void error_add(span_error *e, uint32_t got, ref_colour want, int n, int i)
{
    const double off = ref_colour_difference(got, want);
    measure_add(&e->most, off, n, i, (int64_t)got);
    e->square += off * off;
}

static void error_check(const span_error *e, double most)
{
    const double rms = sqrt(e->square / (double)e->most.inputs);

    measure_print(&e->most);
    printf("    %-18s rms %.3f\n", e->most.what, rms);
    assert_true(e->most.inputs > 5000);
    assert_true(rms <= 1.5);
    assert_true(e->most.worst <= most);
}

/* -- a box of water and an eye --------------------------------------------------------- */

typedef struct {
    tp_shade shade;
    ref_water_box  box;
    ref_vec  eye;
    double   clear;
    uint32_t tint;
} scene;

static tp_underwater water;         /* data of all scenes: tests use one scene at a time */
static tp_clear_water clear;

static void set_optics(tp_shade *s)
{
    tp_underwater *in = &water;
    const double eta = 1 / 1.333, ly = s->world.ly / Q14;
    const double steep = sqrt(1 - (1 - ly * ly) * eta * eta);

    for (int k = 0; k < 3; k++) {
        in->eta[k] = (int32_t)lround(eta * Q14);
        in->eta2[k] = (int32_t)lround(eta * eta * Q14);
    }
    in->sun_x = (int32_t)lround(s->world.lx * eta * ly / steep);
    in->sun_y = s->world.ly;
    in->sun_z = (int32_t)lround(s->world.lz * eta * ly / steep);
    in->right[0] = (int64_t)s->world.right.x * 4096 / s->focal;
    in->right[1] = (int64_t)s->world.right.y * 4096 / s->focal;
    in->right[2] = (int64_t)s->world.right.z * 4096 / s->focal;
    in->up[0] = (int64_t)s->world.up.x * 4096 / s->focal;
    in->up[1] = (int64_t)s->world.up.y * 4096 / s->focal;
    in->up[2] = (int64_t)s->world.up.z * 4096 / s->focal;
    in->zi_near = TP_FX(0.1);
}

/* A scene with the eye within 4 m of the box's middle, at a height in [low, high]. */
static scene scene_inside(double low, double high)
{
    scene s = { .shade = shade_any(&chance), .clear = chance_double(&chance, 0.5, 20) };
    tp_underwater *in = &water;
    const double w = chance_double(&chance, 0.5, 6), d = chance_double(&chance, 0.5, 6);

    *in = (tp_underwater){ .walled = false, .upward_rays = &tp_draw_upward_rays };
    s.shade.underwater = in;
    s.box = (ref_water_box){ -w, w, -d, d, chance_double(&chance, 0.2, 4) };
    s.eye = (ref_vec){ chance_double(&chance, -w, w), chance_double(&chance, low, high),
                       chance_double(&chance, -d, d) };
    s.tint = (uint32_t)random_next(&chance) & 0xffffff;
    s.shade.eye = (tp_vec3){ (tp_fx)(s.eye.x * 65536), (tp_fx)(s.eye.y * 65536),
                             (tp_fx)(s.eye.z * 65536) };
    set_optics(&s.shade);
    in->walled = in->floored = true;
    in->x0 = (tp_fx)(s.box.x0 * 65536);
    in->x1 = (tp_fx)(s.box.x1 * 65536);
    in->z0 = (tp_fx)(s.box.z0 * 65536);
    in->z1 = (tp_fx)(s.box.z1 * 65536);
    in->floor_plane =
        (tp_floor_plane){ .depth = (tp_fx)(s.box.depth * 65536), .nl = in->sun_y };
    in->wall.colour = (uint32_t)random_next(&chance) & 0xffffff;
    in->floor.colour = (uint32_t)random_next(&chance) & 0xffffff;
    in->deep = (uint32_t)random_next(&chance) & 0xffffff;
    tp_absorb_init(&in->absorb, s.tint, (tp_fx)(s.clear * 65536));
    return s;
}

/* Applies Beer's law over a distance in m. */
static ref_colour through(const scene *s, ref_colour c, ref_colour body, double metres)
{
    for (int k = 0; k < 3; k++) {
        const double tint = ((s->tint >> (16 - 8 * k) & 0xff) + 0.5) / 256;
        c.c[k] = body.c[k] + (c.c[k] - body.c[k]) * pow(tint, metres / s->clear);
    }
    return c;
}

static ref_colour lit_face(const scene *s, ref_face face, ref_vec way)
{
    const tp_underwater *in = s->shade.underwater;
    const double ambient = s->shade.ambient / 256.0;
    const double sun = face == REF_FLOOR ? in->sun_y
                     : face == REF_WALL_X ? (way.x > 0 ? -in->sun_x : in->sun_x)
                                          : (way.z > 0 ? -in->sun_z : in->sun_z);
    const double light = ambient + (1 - ambient) * ref_clamp(sun / Q14, 0, 1);
    return ref_scale(
        ref_colour_unpack(face == REF_FLOOR ? in->floor.colour : in->wall.colour), light);
}

/* Colour of a ray in the water; false if too near to an edge for a sure result. */
static bool look(const scene *s, ref_vec from, ref_vec way, ref_colour body, ref_colour *c)
{
    const ref_hit h = ref_in_box(&s->box, from, way);

    if (h.next - h.way < 0.02 + 0.02 * h.way || h.face == REF_SURFACE)
        return false;
    *c = through(s, lit_face(s, h.face, way), body, h.way);
    return true;
}

/* Colour of a ray up through the surface: the sky, and the reflected water. */
static bool look_up(const scene *s, ref_vec at, ref_vec way, ref_vec n, ref_colour body,
                    ref_colour *c)
{
    const double ci = ref_dot(way, n), sine2 = 1.333 * 1.333 * (1 - ci * ci);
    const ref_vec back = ref_along(way, n, -2 * ci);
    ref_colour mirrored;

    if (ci < 0.02 || back.y > -0.02 || fabs(sine2 - 1) < 0.02
        || !look(s, at, back, body, &mirrored))
        return false;
    if (sine2 >= 1) {
        *c = mirrored;
        return true;
    }
    const double ct = sqrt(1 - sine2);
    const double up = 1.333 * way.y + (ct - 1.333 * ci) * n.y;
    const double sky = ref_clamp(floor(up * 256), 0, 256) / 256;
    *c = ref_mix(ref_colour_unpack(s->shade.sky[(int)(sky * 256)]), mirrored,
                 ref_fresnel(ct));
    return true;
}

static ref_vec view_way(const scene *s, const tp_run *run, int i)
{
    const ref_dir v = shade_view(&s->shade, &s->shade.world, run->x + i, run->y);
    return (ref_vec){ -v.x, -v.y, -v.z };
}

/* Sets the sample's key for a distance of `metres` along its ray; returns the actual
 * position, which differs because keys have 24 bits. */
static ref_vec place_sample(const scene *s, test_run *r, int i, double metres)
{
    const ref_vec way = view_way(s, &r->run, i);
    const ref_dir back = shade_dir(s->shade.world.back);
    const double cosine = -(way.x * back.x + way.y * back.y + way.z * back.z);
    const double near = s->shade.underwater->zi_near / 65536.0;
    const double zi = near / (metres * cosine);

    r->key[i] = (uint32_t)fmin(zi * 4294967296.0, 4294967000.0) & ~0xffu;
    return ref_along(s->eye, way, near / ((r->key[i] + 128.0) / 4294967296.0) / cosine);
}

static ref_vec normal_of(const test_run *r, int i)
{
    const ref_dir n = ref_normal(run_sx(r, i), run_sz(r, i));
    return (ref_vec){ n.x, n.y, n.z };
}

/* -- from above ------------------------------------------------------------------------ */

static void what_is_behind_follows_snell_and_beer(void **state)
{
    (void)state;
    span_error off = { .most = { .what = "behind", .unit = "levels" } };

    for (int n = 0; n < RUNS; n++) {
        const scene s = scene_inside(0.3, 5);
        test_run r;
        double   far[TP_RUN];
        run_any(&r, n % 2 ? 1200 : 100, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_vec way = view_way(&s, &r.run, i);
            far[i] = way.y < -0.05 ? -s.eye.y / way.y : -1;
            place_sample(&s, &r, i, far[i] > 0 ? far[i] : 1);
        }
        tp_stage_view(&s.shade, &r.run);
        const tp_run before = r.run;
        r.run.mine = &clear;
        tp_stage_refract(&s.shade, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_vec way = view_way(&s, &r.run, i);
            const ref_vec at = far[i] > 0 ? place_sample(&s, &r, i, far[i]) : s.eye;
            const ref_vec in = ref_bent(way, normal_of(&r, i), 1.333);
            const ref_colour body = ref_mix(ref_colour_unpack(s.shade.underwater->deep),
                                            ref_colour_unpack(before.colour[i]), 0.25);
            ref_colour want;
            if (far[i] < 0 || in.y > -0.12 || ref_dot(way, normal_of(&r, i)) > -0.02
                || fabs(at.x) > s.box.x1 || fabs(at.z) > s.box.z1)
                continue;
            if (look(&s, (ref_vec){ at.x, fmin(at.y, -1e-6), at.z }, in, body, &want))
                error_add(&off, r.run.colour[i], want, n, i);
        }
    }
    error_check(&off, 3.5);
}

static void what_is_behind_glass_follows_snell_and_beer(void **state)
{
    (void)state;
    span_error off = { .most = { .what = "side", .unit = "levels" } };

    for (int n = 0; n < 2 * RUNS; n++) {
        scene s = scene_inside(-1, 2);
        test_run r;
        double   far[TP_RUN];
        s.eye.x = s.box.x1 + chance_double(&chance, 0.3, 4);
        s.shade.eye.x = (tp_fx)(s.eye.x * 65536);
        run_any(&r, 100, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_vec way = view_way(&s, &r.run, i);
            far[i] = way.x < -0.05 ? (s.box.x1 - s.eye.x) / way.x : -1;
            r.t[i] = 0;
            place_sample(&s, &r, i, far[i] > 0 ? far[i] : 1);
        }
        tp_stage_tank_side(&s.shade, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_vec way = view_way(&s, &r.run, i);
            const ref_vec at = far[i] > 0 ? place_sample(&s, &r, i, far[i]) : s.eye;
            const ref_vec in = ref_bent(way, (ref_vec){ 1, 0, 0 }, 1.333);
            ref_colour want;
            if (far[i] < 0 || at.y > 0 || at.y < 0.001 - s.box.depth
                || fabs(at.z) > s.box.z1)
                continue;
            if (look(&s, (ref_vec){ s.box.x1 - 1e-6, at.y, at.z }, in,
                     ref_colour_unpack(s.shade.underwater->deep), &want))
                error_add(&off, r.run.colour[i], want, n, i);
        }
    }
    error_check(&off, 3.5);
}

/* -- from below ------------------------------------------------------------------------ */

static void the_surface_from_below_follows_fresnel(void **state)
{
    (void)state;
    span_error off = { .most = { .what = "below", .unit = "levels" } };

    for (int n = 0; n < RUNS; n++) {
        scene s = scene_inside(-2, -0.05);
        test_run r;
        double   far[TP_RUN];
        s.box.depth += 2;
        water.floor_plane.depth += 2 * TP_FX_ONE;
        run_any(&r, n % 2 ? 1200 : 100, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_vec way = view_way(&s, &r.run, i);
            far[i] = way.y > 0.05 && -s.eye.y > 0.2 * way.y ? -s.eye.y / way.y : -1;
            place_sample(&s, &r, i, far[i] > 0 ? far[i] : 1);
        }
        tp_stage_view(&s.shade, &r.run);
        tp_stage_underside(&s.shade, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_vec way = view_way(&s, &r.run, i);
            const ref_vec at = far[i] > 0 ? place_sample(&s, &r, i, far[i]) : s.eye;
            const ref_colour body = ref_colour_unpack(s.shade.underwater->deep);
            ref_colour want;
            if (far[i] < 0 || fabs(at.x) > s.box.x1 || fabs(at.z) > s.box.z1)
                continue;
            if (look_up(&s, (ref_vec){ at.x, fmin(at.y, -1e-6), at.z }, way,
                        normal_of(&r, i), body, &want))
                error_add(&off, r.run.colour[i], through(&s, want, body, far[i]), n, i);
        }
    }
    error_check(&off, 8);     /* at the rim of Snell's window, one in 10^5 */
}

/* A white sky over black water: the rim of Snell's window is at asin(1 / 1.333) = 48.61
 * degrees. */
static void snells_window_ends_at_48_6_degrees(void **state)
{
    (void)state;
    scene s = scene_inside(-1, -1);
    double rim = 0;

    tp_shade_sky(shade_gradient, 0xffffff, 0xffffff);
    for (int k = 0; k < 9000; k++) {
        const double angle = k / 100.0 * 3.14159265358979 / 180;
        const tp_refracted_ray ray = { { 0, 0, 0 }, { (int32_t)lround(sin(angle) * Q14),
                               (int32_t)lround(cos(angle) * Q14), 0, 0 }, 0 };
        water.walled = water.floored = false;
        const uint32_t c =
            tp_underwater_shade_underside(&s.shade, &s.shade.underwater->floor_plane, &ray,
                                        (tp_ray){ 0, 16384, 0, 0 }, 0);
        if ((c & 0xff) > 8)
            rim = k / 100.0;
        else
            assert_true(k > 4800);
    }
    printf("    the last light comes at %.2f degrees\n", rim);
    assert_true(fabs(rim - 48.61) < 0.1);
}

/* A tank in a sea: between its walls rays see the same as in a tank alone, beyond them
 * nothing but water. */
static void an_island_is_seen_from_between_its_walls(void **state)
{
    (void)state;

    for (int n = 0; n < RUNS; n++) {
        const scene s = scene_inside(-1, -0.1);
        const tp_floor_plane *plane = &water.floor_plane;
        tp_refracted_ray ray = { s.shade.eye, { 9000, -9000, 10300, 0 }, 0 };
        const uint32_t inside = tp_underwater_trace(&s.shade, plane, &ray, 0x123456);

        water.walled = water.floored = false;
        assert_int_equal(tp_underwater_trace(&s.shade, plane, &ray, 0x123456), 0x123456);
        water.island = true;
        assert_int_equal(tp_underwater_trace(&s.shade, plane, &ray, 0x123456), inside);
        ray.at.x = water.x1 + 1;
        assert_int_equal(tp_underwater_trace(&s.shade, plane, &ray, 0x123456), 0x123456);
        ray.at = (tp_vec3){ s.shade.eye.x, s.shade.eye.y, water.z0 - 1 };
        assert_int_equal(tp_underwater_trace(&s.shade, plane, &ray, 0x123456), 0x123456);
    }
}

static void water_before_things_follows_beer(void **state)
{
    (void)state;
    span_error off = { .most = { .what = "absorb", .unit = "levels" } };

    for (int n = 0; n < RUNS; n++) {
        const scene s = scene_inside(-2, -0.1);
        test_run r;
        double   far[TP_RUN];
        run_any(&r, 100, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            far[i] = chance_double(&chance, 0.3, 20);
            place_sample(&s, &r, i, far[i]);
        }
        const tp_run before = r.run;
        tp_stage_absorb(&s.shade, &r.run);
        for (int i = 0; i < TP_RUN; i++)
            error_add(&off, r.run.colour[i],
                      through(&s, ref_colour_unpack(before.colour[i]),
                              ref_colour_unpack(s.shade.underwater->deep), far[i]), n, i);
    }
    error_check(&off, 1.2);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_island_is_seen_from_between_its_walls),
        cmocka_unit_test(what_is_behind_follows_snell_and_beer),
        cmocka_unit_test(what_is_behind_glass_follows_snell_and_beer),
        cmocka_unit_test(the_surface_from_below_follows_fresnel),
        cmocka_unit_test(snells_window_ends_at_48_6_degrees),
        cmocka_unit_test(water_before_things_follows_beer),
    };
    return cmocka_run_group_tests_name("features/underwater stage", tests, NULL, NULL);
}
