/* SPDX-License-Identifier: MIT */
/* Object reflections over the reflected sky, compared with geometry in double precision.
 * The textures are ramps; red and green give the sampled position, so an error of one level
 * is half a pixel, or an eighth of a texel of the cube map. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/reflection/reflection.h"
#include "world/world.h"
#include "shade/shade.h"
#include "tests/lib/shading.h"

enum { SIDE = 240 };

static uint64_t chance;
static uint32_t ramp[SIDE * SIDE];
static tp_mirrored_zi zi[SIDE];
static uint32_t faces[TP_OBJECT_CUBE_FACES * TP_OBJECT_CUBE_SIDE * TP_OBJECT_CUBE_SIDE];

typedef struct {
    double worst, squares, small_squares;
    int    count, large;        /* large: off by more than 3 */
} level_error;

static void add(level_error *e, double off)
{
    e->worst = fmax(e->worst, fabs(off));
    e->count++;
    e->large += fabs(off) > 3;
    e->small_squares += fabs(off) > 3 ? 0 : off * off;
    e->squares += off * off;
}

static void print(const char *what, const level_error *e)
{
    printf("    %-20s %7d inputs, worst %.2f, rms %.3f of 255\n", what, e->count,
           e->worst, sqrt(e->squares / e->count));
    assert_true(e->count > 3000);
}

/* -- the planar reflection ------------------------------------------------------------- */

/* Ray of the pixel position (u, v), with length 1 along the camera's axis. */
static ref_dir ray_at(const tp_shade *s, double u, double v)
{
    const ref_dir r = shade_dir(s->world.right), up = shade_dir(s->world.up),
                  back = shade_dir(s->world.back);
    const double f = s->focal / 16.0, x = (u - s->u0 / 16.0) / f,
                 y = (s->v0 / 16.0 - v) / f;

    return (ref_dir){ x * r.x + y * up.x - back.x, x * r.y + y * up.y - back.y,
                      x * r.z + y * up.z - back.z };
}

/* Screen position of an image: water at depth z with these slopes, h above the level,
 * reflects the point that level water reflects to depth zm along the same ray. */
static void image_at(const tp_shade *s, ref_dir d, double z, double zm, double sx,
                     double sz, double h, double *u, double *v)
{
    const ref_dir r = shade_dir(s->world.right), up = shade_dir(s->world.up),
                  back = shade_dir(s->world.back);
    const ref_dir n = ref_unit((ref_dir){ -sx, 1, -sz });
    const double dn = ref_dir_dot(d, n), way = zm - z, f = s->focal / 16.0;
    const ref_dir e = { d.x - 2 * dn * n.x, -(d.y - 2 * dn * n.y), d.z - 2 * dn * n.z };
    const ref_dir m = { z * d.x + way * e.x, z * d.y + way * e.y - 2 * h,
                        z * d.z + way * e.z };
    const double ahead = -ref_dir_dot(m, back);

    *u = s->u0 / 16.0 + f * ref_dir_dot(m, r) / ahead;
    *v = s->v0 / 16.0 - f * ref_dir_dot(m, up) / ahead;
}

/* Image position to first order in slopes and height, by finite differences. */
static void moved_to(const tp_shade *s, double x, double y, double z, double zm,
                     const double by[3], double *u, double *v)
{
    const double e = 1e-6;
    const ref_dir d = ray_at(s, x, y);
    double u0, v0;

    image_at(s, d, z, zm, 0, 0, 0, &u0, &v0);
    *u = x;
    *v = y;
    for (int i = 0; i < 3; i++) {
        double a, b;
        image_at(s, d, z, zm, i == 0 ? e : 0, i == 1 ? e : 0, i == 2 ? e : 0, &a, &b);
        *u += (a - u0) / e * by[i];
        *v += (b - v0) / e * by[i];
    }
}

/* Data that the stages read for the last shade. */
static tp_mirror mirror;
static tp_object_cube around;

/* halvings: of the map. */
static tp_shade any_mirror(int halvings, double zm, double height)
{
    tp_shade s = shade_any(&chance);

    for (int i = 0; i < SIDE; i++)
        zi[i].near = zi[i].far = (uint32_t)(2147483648.0 / zm);
    mirror.map = (tp_planar_map){ ramp, 0, 0, SIDE, SIDE, halvings };
    s.per_focal = (uint32_t)(4294967296.0 / s.focal);
    mirror.bend = chance_int(&chance, 0, 512);
    mirror.height = (int64_t)lround(height * 4096);
    mirror.zi = zi;
    return s;
}

/* `level`: one depth for the run, and gentle slopes, equal in two columns: what a block of
 * pixels shares. */
static void compare_run(const tp_shade *s, tp_stage mirrored, bool level, double zm,
                        double height, level_error *off)
{
    test_run r;
    const double far = chance_double(&chance, 0.3, 0.95);

    run_any(&r, 600, &chance);
    r.run.x = TP_RUN * chance_int(&chance, 0, 6);
    for (int i = 0; i < TP_RUN; i++) {
        const double depth = zm * (level ? far : chance_double(&chance, 0.3, 1.05));
        r.key[i] = (uint32_t)(2147483648.0 / depth) << 1 | 0xff;
        const uint32_t n = r.n[level ? i & ~1 : i];
        r.run.sx[i] = (int16_t)((int16_t)(n >> 16) / (level ? 4 : 1));
        r.run.sz[i] = (int16_t)((int16_t)n / (level ? 4 : 1));
        r.run.mirror[i] = 0;
    }
    r.run.mine = &mirror;
    mirrored(s, &r.run);
    for (int i = 0; i < TP_RUN; i++) {
        const double x = r.run.x + i + 0.5, y = r.run.y + 0.5;
        const double z = 2147483648.0 / ((r.key[i] | 0xff) >> 1);
        const double bend = z < zm ? mirror.bend / 256.0 : 0;
        const double by[3] = { r.run.sx[i] / Q12 * bend, r.run.sz[i] / Q12 * bend,
                               height + z * ray_at(s, x, y).y };
        double u, v;
        moved_to(s, x, y, z, zm, by, &u, &v);
        u = u / (1 << mirror.map.halvings) - 0.5;
        v = v / (1 << mirror.map.halvings) - 0.5;
        if (level && r.run.mirror[i] == 0)      /* out of reach of the map */
            continue;
        if (u < 1 || v < 1 || u > SIDE - 2 || v > SIDE - 2)
            continue;
        add(off, (r.run.mirror[i] >> 16 & 0xff) - u);
        add(off, (r.run.mirror[i] >> 8 & 0xff) - v);
    }
}

static void the_look_is_bent_as_the_ray_is(void **state)
{
    (void)state;
    static const char *const name[3] = { "bent, full", "bent, half", "bent, quarter" };
    level_error off[3] = { { 0 } };

    for (int n = 0; n < 6000; n++) {
        const double zm = chance_double(&chance, 4, 300);
        const double height = zm * chance_double(&chance, 0.02, 0.5);
        const tp_shade s = any_mirror(n % 3, zm, height);
        compare_run(&s, tp_stage_mirrored, false, zm, height, &off[n % 3]);
    }
    for (int i = 0; i < 3; i++) {
        print(name[i], &off[i]);
        assert_true(off[i].worst <= (i == 0 ? 1.2 : 0.8));
        assert_true(sqrt(off[i].squares / off[i].count) <= 0.35);
    }
}

/* Runs of one depth: the factors of a block's middle stand for its 16 columns; in the widest
 * views few columns differ much from their middle. */
static void blocks_bend_as_their_middle(void **state)
{
    (void)state;
    level_error off = { 0 };

    for (int n = 0; n < 4000; n++) {
        const double zm = chance_double(&chance, 4, 300);
        const double height = zm * chance_double(&chance, 0.02, 0.5);
        const tp_shade s = any_mirror(1, zm, height);
        compare_run(&s, tp_stage_mirrored_fast, true, zm, height, &off);
    }
    print("by blocks", &off);
    printf("    more than 3 off: %d, rms of the others %.3f\n", off.large,
           sqrt(off.small_squares / off.count));
    assert_true(off.large <= off.count / 400);          /* 0.11 % measured */
    assert_true(sqrt(off.small_squares / off.count) <= 0.6);
}

/* Fast lists get the same objects as exact ones, in the blocks that they name. */
static void fast_lists_get_the_objects_of_exact_ones(void **state)
{
    (void)state;
    uint32_t found = 0;

    for (int n = 0; n < 2000; n++) {
        const double zm = chance_double(&chance, 4, 300);
        const tp_shade s = any_mirror(n % 3, zm, zm * chance_double(&chance, 0.02, 0.5));
        test_run r;
        run_any(&r, 600, &chance);
        r.run.x = TP_RUN * chance_int(&chance, 0, 6);
        for (int i = 0; i < TP_RUN; i++)
            r.key[i] = (uint32_t)(2147483648.0 / (zm * chance_double(&chance, 0.3, 1.05))) << 1;
        r.run.mine = &mirror;
        tp_run fast = r.run;
        for (int i = 0; i < TP_RUN; i++) {
            fast.slope[i] = r.n[i];
            r.run.mirror[i] = 0;
        }
        for (int i = 0; i < TP_RUN; i++) {
            r.run.sx[i] = (int16_t)(r.n[i] >> 16);
            r.run.sz[i] = (int16_t)r.n[i];
        }
        tp_stage_mirrored_fast(&s, &r.run);
        tp_stage_quick_objects(&s, &fast);
        for (int i = 0; i < r.run.count; i++) {
            const bool named = fast.objects >> tp_block_number(&fast, i) & 1;
            assert_int_equal(named ? fast.mirror[i] & 0xffffff : 0, r.run.mirror[i]);
            found += named;
        }
    }
    assert_true(found > 1000);
}

/* Draws the same run by two stages; returns the number of samples that the first changed. */
static uint32_t compare_stages(const tp_shade *s, const tp_planar_map map[2], tp_stage plain,
                               tp_stage packed, bool alone)
{
    test_run r;
    uint32_t changed = 0;

    run_any(&r, 600, &chance);
    r.run.x = TP_RUN * chance_int(&chance, 0, 6);
    for (int i = 0; i < TP_RUN; i++) {
        r.key[i] = (uint32_t)(2147483648.0 / chance_double(&chance, 3, 12)) << 1;
        r.run.sx[i] = (int16_t)(r.n[i] >> 16);
        r.run.sz[i] = (int16_t)r.n[i];
        r.run.mirror[i] = 0x123456;
        if (alone)                              /* takes the place of sx, sz */
            r.run.slope[i] = r.n[i];
    }
    tp_run run[2] = { r.run, r.run };
    for (int k = 0; k < 2; k++) {
        mirror.map = map[k];
        run[k].mine = &mirror;
        (k ? packed : plain)(s, &run[k]);
    }
    for (int i = 0; i < r.run.count; i++) {
        const bool named = !alone || run[0].objects >> tp_block_number(&run[0], i) & 1;
        if (named)
            assert_int_equal(run[0].mirror[i], run[1].mirror[i]);
        changed += named && (run[0].mirror[i] & 0xffffff) != 0x123456;
    }
    if (alone)
        assert_int_equal(run[0].objects, run[1].objects);
    return changed;
}

/* A map of rgb565 is sampled as a map of the colours that its pixels stand for. */
static void packed_maps_are_sampled_as_their_colours(void **state)
{
    (void)state;
    static uint16_t pixel[SIDE * SIDE];
    static uint32_t colour[SIDE * SIDE];
    uint32_t changed[3] = { 0, 0, 0 };

    for (int i = 0; i < SIDE * SIDE; i++) {
        pixel[i] = random_below(&chance, 3) ? (uint16_t)random_next(&chance) : 0;
        colour[i] = pixel[i] ? tp_pixel_read(TP_FORMAT_RGB565, pixel, i) | 0xff000000u : 0;
    }
    for (int n = 0; n < 1000; n++) {
        const tp_shade s = any_mirror(n % 3, 12, chance_double(&chance, 0.3, 6));
        const tp_planar_map map[2] = {
            { colour, 0, 0, SIDE, SIDE, n % 3 },
            { (const uint32_t *)(const void *)pixel, 0, 0, SIDE, SIDE, n % 3 },
        };
        changed[0] += compare_stages(&s, map, tp_stage_mirrored, tp_stage_mirrored_packed,
                                     false);
        changed[1] += compare_stages(&s, map, tp_stage_mirrored_fast,
                                     tp_stage_mirrored_packed_fast, false);
        changed[2] += compare_stages(&s, map, tp_stage_quick_objects,
                                     tp_stage_quick_packed_objects, true);
    }
    for (int k = 0; k < 3; k++)
        assert_true(changed[k] > 1000);
}

/* Water beyond the object, or no reflection map: the sky colour stays. */
static void water_behind_an_object_mirrors_none_of_it(void **state)
{
    (void)state;
    tp_shade s = any_mirror(1, 10, 1);
    test_run r;

    run_any(&r, 0, &chance);
    r.run.x = r.run.y = 0;
    for (int i = 0; i < TP_RUN; i++) {
        r.key[i] = (uint32_t)(2147483648.0 / 11.5) << 1 | 0xff;
        r.run.mirror[i] = 0x123456;
    }
    r.run.mine = &mirror;
    tp_stage_mirrored(&s, &r.run);
    tp_stage_mirrored_fast(&s, &r.run);
    for (int i = 0; i < TP_RUN; i++)
        assert_int_equal(r.run.mirror[i], 0x123456);
    tp_stage_quick_objects(&s, &r.run);
    assert_int_equal(r.run.objects, 0);
    mirror.map.colour = NULL;
    r.run.mine = &mirror;
    r.run.mirror[5] = 0x123456;
    tp_stage_mirrored(&s, &r.run);
    tp_stage_mirrored_fast(&s, &r.run);
    assert_int_equal(r.run.mirror[5], 0x123456);
}

/* -- the cube map --------------------------------------------------------------------- */

/* Face of the cube map and position (i, j) in texels, for a direction; as in
 * reflection.h. */
static int face_of(ref_dir w, double *i, double *j)
{
    const double ax = fabs(w.x), az = fabs(w.z);
    int    face = ax >= az ? w.x < 0 : 2 + (w.z < 0);
    double ahead = fmax(ax, az), up = w.y;
    double right = face == 0 ? w.z : face == 1 ? -w.z : face == 2 ? -w.x : w.x;

    if (w.y > ahead) {
        face = 4;
        right = w.x;
        up = w.z;
        ahead = w.y;
    }
    *i = (right / ahead + 1) * TP_OBJECT_CUBE_SIDE / 2 - 0.5;
    *j = (1 - up / ahead) * TP_OBJECT_CUBE_SIDE / 2 - 0.5;
    return face;
}

static tp_shade any_cube(void)
{
    tp_shade s = shade_any(&chance);
    const double a = chance_double(&chance, 0, 6.28);

    around = (tp_object_cube){
        faces, { chance_fx(&chance, -9, 9), chance_fx(&chance, 1, 9),
                 chance_fx(&chance, -9, 9) },
        { TP_FX(8 * cos(a)), TP_FX(2), TP_FX(8 * sin(a)) },
        (int32_t)lround(16384 * cos(a)), (int32_t)lround(16384 * sin(a)), TP_FX(0.25),
    };
    s.per_focal = (uint32_t)(4294967296.0 / s.focal);
    return s;
}

static void compare_cube(const tp_shade *s, test_run *r, int k, level_error *off)
{
    const tp_object_cube *c = &around;
    const ref_dir d = ray_at(s, r->run.x + k + 0.5, r->run.y + 0.5);
    const double z = 0.25 * 2147483648.0 / ((r->key[k] | 0xff) >> 1);
    const double px = c->from.x / 65536.0 + z * d.x, py = c->from.y / 65536.0 + z * d.y,
                 pz = c->from.z / 65536.0 + z * d.z;
    const double nx = c->nx / Q14, nz = c->nz / Q14;
    const double a = (c->to.x / 65536.0 - px) * nx + (c->to.z / 65536.0 - pz) * nz;
    const double b = (r->run.rx[k] * nx + r->run.rz[k] * nz) / Q14;
    const ref_dir w = { px + r->run.rx[k] / Q14 * a / b, py + r->run.up[k] / Q14 * a / b,
                        pz + r->run.rz[k] / Q14 * a / b };
    double i, j;

    if (a < 0.5 || b < 0.05)
        return;
    const int face = face_of(w, &i, &j);
    if (i < 0.2 || j < 0.2 || i > TP_OBJECT_CUBE_SIDE - 1.2
        || j > TP_OBJECT_CUBE_SIDE - 1.2)
        return;
    const uint32_t got = r->run.mirror[k];
    assert_int_equal((got & 0xff) / 40, face);
    add(off, (got >> 16 & 0xff) - 8 * i);
    add(off, (got >> 8 & 0xff) - 8 * j);
}

static void the_cube_is_met_in_the_objects_plane(void **state)
{
    (void)state;
    level_error off = { 0 };

    for (int n = 0; n < 1500; n++) {
        const tp_shade s = any_cube();
        test_run r;
        run_any(&r, 0, &chance);
        for (int k = 0; k < TP_RUN; k++) {
            const tp_dir3 d = tp_normalise(chance_int(&chance, -999, 999),
                                           chance_int(&chance, 0, 999),
                                           chance_int(&chance, -999, 999));
            r.run.rx[k] = (int16_t)(d.x >> 16);
            r.run.up[k] = (int16_t)(d.y >> 16);
            r.run.rz[k] = (int16_t)(d.z >> 16);
            r.run.mirror[k] = 0;
            r.key[k] = (uint32_t)(2147483648.0 / chance_double(&chance, 8, 60)) << 1
                     | 0xff;
        }
        r.run.mine = &around;
        tp_stage_mirrored_object_cube(&s, &r.run);
        for (int k = 0; k < TP_RUN; k++)
            compare_cube(&s, &r, k, &off);
    }
    print("cube", &off);
    assert_true(off.worst <= 3 && sqrt(off.squares / off.count) <= 1);
}

static int make_ramps(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        ramp[i] = 0xff000000u | i % SIDE << 16 | i / SIDE << 8;
    for (uint32_t i = 0; i < TP_OBJECT_CUBE_FACES * 1024; i++)
        faces[i] = 0xff000000u | i % 32 * 8 << 16 | i / 32 % 32 * 8 << 8 | i / 1024 * 40;
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_look_is_bent_as_the_ray_is),
        cmocka_unit_test(blocks_bend_as_their_middle),
        cmocka_unit_test(fast_lists_get_the_objects_of_exact_ones),
        cmocka_unit_test(packed_maps_are_sampled_as_their_colours),
        cmocka_unit_test(water_behind_an_object_mirrors_none_of_it),
        cmocka_unit_test(the_cube_is_met_in_the_objects_plane),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("features/reflection", tests, make_ramps,
                                       NULL);
}
