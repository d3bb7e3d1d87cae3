/* SPDX-License-Identifier: MIT */
/* Each stage of shading alone against the formula in double precision.  Errors are in
 * levels of 255; every product and mix of colours is cut, not rounded, so a stage may
 * lose a level for each. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/shading.h"
#include "asset/mesh.h"
#include "runs.h"

#define Q14 16384.0
#define Q12 4096.0

static uint64_t chance;

/* 640 x 480 at 60 degrees and the like: a focal length of 200 to 1000 pixels. */
static tp_shade any_shade(void)
{
    const tp_rotation turn =
        tp_rotation_of((tp_turn)random_next(&chance),
                       (tp_turn)chance_int(&chance, -400000000, 400000000), 0);
    const tp_dir3 light = tp_normalise(chance_int(&chance, -1000, 1000),
                                       chance_int(&chance, 20, 1000),
                                       chance_int(&chance, -1000, 1000));
    tp_shade s = {
        .u0 = 320 * 16, .v0 = 240 * 16,
        .focal = chance_int(&chance, 200, 1000) * 16,
        .world = { turn.x, turn.y, turn.z, light.x >> 16, light.y >> 16, light.z >> 16 },
        .zi_log = 15 * 256 + 14 * 256,
        .water_colour = (uint32_t)random_next(&chance) & 0xffffff,
        .light_colour = (uint32_t)random_next(&chance) & 0xffffff,
        .ambient = chance_int(&chance, 0, 256),
        .mirror = chance_int(&chance, 0, 256),
        .haze_scale = (uint32_t)random_next(&chance) >> chance_int(&chance, 0, 31),
    };
    s.mesh = s.world;
    tp_shade_tables(&s);
    tp_shade_sky(&s, (uint32_t)random_next(&chance) & 0xffffff,
                 (uint32_t)random_next(&chance) & 0xffffff);
    return s;
}

static ref_dir dir_of(tp_dir3 d)
{
    return (ref_dir){ d.x / 1073741824.0, d.y / 1073741824.0, d.z / 1073741824.0 };
}

static ref_dir light_of(const tp_view_axes *a)
{
    return (ref_dir){ a->lx / Q14, a->ly / Q14, a->lz / Q14 };
}

/* From the pixel's centre to the eye. */
static ref_dir view_at(const tp_shade *s, const tp_view_axes *axes, int32_t x, int32_t y)
{
    const ref_dir right = dir_of(axes->right), up = dir_of(axes->up),
                  back = dir_of(axes->back);
    const double u = 16 * x + 8 - s->u0, v = s->v0 - 16 * y - 8, f = s->focal;

    return ref_unit((ref_dir){ f * back.x - u * right.x - v * up.x,
                               f * back.y - u * right.y - v * up.y,
                               f * back.z - u * right.z - v * up.z });
}

static double sx_of(const test_run *r, int i)
{
    return (int16_t)(r->n[i] >> 16) / Q12;
}

static double sz_of(const test_run *r, int i)
{
    return (int16_t)(r->n[i] & 0xffff) / Q12;
}

/* -- view and sky -------------------------------------------------------------------- */

/* A chord over n pixels of a circle of radius f lies (n/f)^2 / 8 below it in the middle. */
static double chord(const tp_shade *s, double pixels)
{
    const double angle = pixels / (s->focal / 16.0);
    return angle * angle / 8;
}

static void the_view_points_to_the_eye(void **state)
{
    (void)state;
    measure off = { .what = "view", .unit = "of 1/16384" };

    for (int n = 0; n < 2000; n++) {
        const tp_shade s = any_shade();
        test_run r;
        run_any(&r, 0, &chance);
        tp_stage_view(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = view_at(&s, &s.world, r.run.x + i, r.run.y);
            const ref_dir l = light_of(&s.world);
            /* Two ends cut to Q1.14, the step between them too: three units.  The light's
             * product adds up three cuts of 1. */
            const double most = chord(&s, 16) + 3 / Q14, most_l = most * 1.8 + 2 / Q14;
            const double e = fmax(fmax(fabs(r.run.vx[i] / Q14 - v.x),
                                       fabs(r.run.vy[i] / Q14 - v.y)),
                                  fabs(r.run.vz[i] / Q14 - v.z));
            assert_true(e <= most);
            assert_true(fabs(r.run.lv[i] / Q14 - ref_dir_dot(v, l)) <= most_l);
            measure_add(&off, e * Q14, r.run.x + i, r.run.y, s.focal);
        }
    }
    measure_print(&off);
}

static void the_sky_turns_from_horizon_to_zenith(void **state)
{
    (void)state;
    measure off = { .what = "sky", .unit = "levels" };

    for (int n = 0; n < 2000; n++) {
        const tp_shade s = any_shade();
        test_run r;
        run_any(&r, 0, &chance);
        tp_stage_sky(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = view_at(&s, &s.world, r.run.x + i, r.run.y);
            const double e = ref_off(r.run.colour[i],
                                     ref_sky(s.sky[0], s.sky[TP_SKY], -v.y));
            /* The gradient rises by 2 at the horizon, times 255 levels: an entry of 1/256
             * is up to 2 of them, and so is what the chord over 64 pixels is short. */
            assert_true(e <= 2 * 255 * (1 / 256.0 + chord(&s, 64) + 3 / Q14) + 2);
            measure_add(&off, e, r.run.x + i, r.run.y, s.focal);
        }
    }
    measure_print(&off);
}

/* -- light on water ------------------------------------------------------------------ */

typedef void stage(const tp_shade *shade, tp_run *run);

/* Up to a slope of 2 in all, where the root's table ends. */
static void compare_diffuse(stage *diffuse, measure *off, double most)
{
    for (int n = 0; n < 2000; n++) {
        const tp_shade s = any_shade();
        test_run r;
        run_any(&r, 5700, &chance);
        const tp_run before = r.run;
        tp_stage_view(&s, &r.run);
        diffuse(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir normal = ref_normal(sx_of(&r, i), sz_of(&r, i));
            const double ambient = s.ambient / 256.0;
            const double nl = fmax(0, ref_dir_dot(normal, light_of(&s.world)));
            const double e = ref_off(r.run.colour[i],
                                     ref_scale(ref_colour_of(before.colour[i]),
                                               ambient + (1 - ambient) * fmin(nl, 1)));
            assert_true(e <= most);
            measure_add(off, e, (int32_t)r.n[i], s.ambient, s.world.ly);
        }
    }
    measure_print(off);
}

/* The share in 256ths is cut (a level), the product too (a level); the root's nearest
 * entry of 1/128 is off by 0.2 % (half a level). */
static void diffuse_follows_lambert(void **state)
{
    (void)state;
    measure off = { .what = "diffuse", .unit = "levels" };
    compare_diffuse(tp_stage_diffuse, &off, 2.6);
}

/* Two cuts of a level; the root is interpolated. */
static void light_follows_lambert(void **state)
{
    (void)state;
    measure off = { .what = "light", .unit = "levels" };
    compare_diffuse(tp_stage_light, &off, 2.1);
}

/* Waves and ripples may be as steep as their 16 bits.  No colour comes out brighter than
 * it went in: a share above 1 would carry one channel into the next. */
static void no_slope_makes_water_brighter_than_itself(void **state)
{
    (void)state;
    static stage *const stages[] = { tp_stage_diffuse, tp_stage_light,
                                     tp_stage_diffuse_rippled, tp_stage_light_rippled };

    for (int n = 0; n < 4000; n++) {
        const tp_shade s = any_shade();
        test_run r;
        run_any(&r, 32000, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            r.run.sx[i] = (int16_t)chance_int(&chance, -32000, 32000);
            r.run.sz[i] = (int16_t)chance_int(&chance, -32000, 32000);
        }
        tp_stage_view(&s, &r.run);
        const tp_run before = r.run;
        stages[n % 4](&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_colour was = ref_colour_of(before.colour[i]);
            const ref_colour is = ref_colour_of(r.run.colour[i]);
            for (int k = 0; k < 3; k++)
                assert_true(is.c[k] <= was.c[k]
                            && is.c[k] >= floor(was.c[k] * s.ambient / 256.0));
            if (n % 2) {
                assert_in_range(r.run.nv[i], 0, 16384);
                assert_true(r.run.up[i] >= -16384 && r.run.up[i] <= 16384);
            }
        }
    }
}

/* N.V and the mirrored view's height, of eyes above the water. */
static void light_hands_on_view_and_mirror(void **state)
{
    (void)state;
    measure nv_off = { .what = "N.V", .unit = "of 1/16384" };
    measure up_off = { .what = "mirrored height", .unit = "of 1/16384" };

    for (int n = 0; n < 2000; n++) {
        const tp_shade s = any_shade();
        test_run r;
        run_any(&r, 5700, &chance);
        tp_stage_view(&s, &r.run);
        tp_stage_light(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = { r.run.vx[i] / Q14, r.run.vy[i] / Q14, r.run.vz[i] / Q14 };
            const ref_dir normal = ref_normal(sx_of(&r, i), sz_of(&r, i));
            const double nv = ref_clamp(ref_dir_dot(normal, v), 0, 1);
            const double up = ref_clamp(2 * nv * normal.y - v.y, -1, 1);
            /* The root is cut in its table and between its entries, 2 units, times a sum
             * of up to 2.2 that is cut by one too; the product by one more: 7 units.  The
             * height is twice nv ny, with the root's 2 again and two more cuts: 20. */
            assert_true(fabs(r.run.nv[i] / Q14 - nv) <= 7 / Q14);
            assert_true(fabs(r.run.up[i] / Q14 - up) <= 20 / Q14);
            measure_add(&nv_off, (r.run.nv[i] / Q14 - nv) * Q14, (int32_t)r.n[i], 0, 0);
            measure_add(&up_off, (r.run.up[i] / Q14 - up) * Q14, (int32_t)r.n[i], 0, 0);
        }
    }
    measure_print(&nv_off);
    measure_print(&up_off);
}

/* The lobe lies between those of a slightly lesser and a slightly larger R.V: the table
 * has 1024 entries; R.V is 2 N.L N.V - L.V, of which N.L and N.V are right to 7 units of
 * 1/16384: 30 in all. */
static void glints_follow_the_phong_lobe(void **state)
{
    (void)state;
    int lit = 0;

    for (int n = 0; n < 2000; n++) {
        tp_shade s = any_shade();
        const double strength = chance_double(&chance, 0, 4);
        const int shininess = chance_int(&chance, 1, n % 2 ? 1000 : 30);
        tp_shade_shine(&s, shininess * TP_FX_ONE, (tp_fx)(strength * 65536));
        test_run r;
        run_any(&r, 2000, &chance);
        tp_stage_view(&s, &r.run);
        tp_stage_light(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_dir v = { r.run.vx[i] / Q14, r.run.vy[i] / Q14, r.run.vz[i] / Q14 };
            const ref_dir normal = ref_normal(sx_of(&r, i), sz_of(&r, i));
            const double nv = ref_clamp(ref_dir_dot(normal, v), 0, 1);
            const double nl = ref_clamp(ref_dir_dot(normal, light_of(&s.world)), 0, 1);
            const double rv = 2 * nl * nv - r.run.lv[i] / Q14;
            if (fabs(rv) < 30 / Q14 || nl < 10 / Q14)
                continue;
            const double low =
                pow(ref_clamp(rv - 1 / 1024.0 - 30 / Q14, 0, 1), shininess);
            const double high = pow(ref_clamp(rv + 30 / Q14, 0, 1), shininess);
            assert_true(r.run.glint[i] >= low * strength * 256 - 2);
            assert_true(r.run.glint[i] <= high * strength * 256 + 2);
            lit += r.run.glint[i] > 0;
        }
    }
    assert_true(lit > 1000);
}

static void glints_add_the_light_and_hold_at_white(void **state)
{
    (void)state;
    measure off = { .what = "glint", .unit = "levels" };

    for (int n = 0; n < 1000; n++) {
        const tp_shade s = any_shade();
        test_run r;
        run_any(&r, 0, &chance);
        for (int i = 0; i < TP_RUN; i++)
            r.run.glint[i] =
                (uint16_t)(random_below(&chance, 2) ? random_below(&chance, 1025) : 0);
        const tp_run before = r.run;
        tp_stage_glint(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const double share = fmin(1, before.glint[i] / 256.0);
            const double e =
                ref_off(r.run.colour[i],
                        ref_add(ref_colour_of(before.colour[i]),
                                ref_scale(ref_colour_of(s.light_colour), share)));
            assert_true(e < 1);         /* one product cut */
            measure_add(&off, e, before.glint[i], 0, 0);
        }
    }
    measure_print(&off);
}

/* Fresnel's share is in 255ths by 1/256 of N.V, whose curve falls by up to 6 (at grazing
 * views): 6 levels of 255 an entry; the sky's entry is 1/256, 2 levels of it; four
 * products are cut. */
static void mirrors_show_the_sky_by_fresnel(void **state)
{
    (void)state;
    measure off = { .what = "mirror", .unit = "levels" };

    for (int n = 0; n < 1000; n++) {
        const tp_shade s = any_shade();
        test_run r;
        run_any(&r, 0, &chance);
        for (int i = 0; i < TP_RUN; i++) {
            r.run.nv[i] = (int16_t)chance_int(&chance, 0, 16384);
            r.run.up[i] = (int16_t)chance_int(&chance, -16384, 16384);
        }
        const tp_run before = r.run;
        tp_stage_mirror(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const double up = before.up[i] / Q14;
            const double above = ref_clamp(1 + 4 * up, 0.5, 1);
            const double share = ref_fresnel(before.nv[i] / Q14) * s.mirror / 256 * above;
            const double e = ref_off(
                r.run.colour[i], ref_mix(ref_colour_of(before.colour[i]),
                                         ref_sky(s.sky[0], s.sky[TP_SKY], up), share));
            assert_true(e <= 6 + 2 + 4);
            measure_add(&off, e, before.nv[i], before.up[i], s.mirror);
        }
    }
    measure_print(&off);
}

static void fresnel_has_the_known_ends(void **state)
{
    (void)state;
    const tp_shade s = any_shade();
    measure off = { .what = "fresnel table", .unit = "of 1/256" };

    for (int i = 0; i <= 256; i++) {
        const double e = s.fresnel[i] - 256 * ref_fresnel(i / 256.0);
        assert_true(fabs(e) <= 1);      /* 255 stands for 1 */
        measure_add(&off, e, i, 0, 0);
    }
    measure_print(&off);
    assert_int_equal(s.fresnel[0], 255);
    assert_int_equal(s.fresnel[256], 5);        /* 0.0204 */
}

/* Share z^2 / (z^2 + h^2) by 32 h / z in whole entries: near 18 of them, where it is
 * steepest, an entry is 0.02 or 5 levels; 255 of 256 at the most; a product cut. */
static void haze_goes_into_the_horizon(void **state)
{
    (void)state;
    measure off = { .what = "haze", .unit = "levels" };

    for (int n = 0; n < 2000; n++) {
        tp_shade s = any_shade();
        test_run r;
        run_any(&r, 0, &chance);
        const double zi_near = 0.25 * 255 / 256 * 65536;
        const int32_t half = chance_int(&chance, 1, 32000);     /* metres */
        s.haze_scale = (uint32_t)(half * 65536.0 * 64 / zi_near);
        const tp_run before = r.run;
        tp_stage_haze(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const double z = zi_near / 65536 / (r.key[i] / 4294967296.0);
            const double share = z * z / (z * z + (double)half * half);
            const double e = ref_off(r.run.colour[i],
                                     ref_mix(ref_colour_of(before.colour[i]),
                                             ref_colour_of(s.sky[0]), share));
            assert_true(e <= 5 + 1 + 1);
            measure_add(&off, e, r.key[i], half, 0);
        }
    }
    measure_print(&off);
}

/* -- solids -------------------------------------------------------------------------- */

static tp_solid any_solid(const uint8_t gloss[TP_GLOSS])
{
    return (tp_solid){ .diffuse = (uint32_t)random_next(&chance) & 0xffffff,
                       .specular = (uint32_t)random_next(&chance) & 0xffffff,
                       .bump = 256, .gloss = gloss };
}

static uint32_t any_normal(void)
{
    return tp_dir_pack(tp_normalise(chance_int(&chance, -99, 99),
                                    chance_int(&chance, -99, 99),
                                    chance_int(&chance, -99, 99)));
}

static ref_dir unpacked(tp_packed_dir n)
{
    return ref_unit((ref_dir){ tp_dir_x(n), tp_dir_y(n), tp_dir_z(n) });
}

/* Where the light just grazes, the lobe begins or ends at once. */
static bool grazes(const tp_shade *s, ref_dir normal, double slack)
{
    return fabs(ref_dir_dot(normal, light_of(&s->mesh))) < slack;
}

/* Phong with the lobe at R.V less or more than it is. */
static ref_colour phong(const tp_shade *s, ref_colour diffuse, uint32_t specular,
                        int shininess, ref_dir normal, const tp_run *run, int i,
                        double slack)
{
    const ref_dir v = { run->vx[i] / Q14, run->vy[i] / Q14, run->vz[i] / Q14 };
    const double nl = ref_clamp(ref_dir_dot(normal, light_of(&s->mesh)), 0, 1);
    const double rv = 2 * nl * ref_dir_dot(normal, v) - run->lv[i] / Q14;
    const double ambient = s->ambient / 256.0;
    const double lobe = nl > 0 ? pow(ref_clamp(rv + slack, 0, 1), shininess) : 0;

    return ref_add(ref_scale(diffuse, ambient + (1 - ambient) * nl),
                   ref_scale(ref_times(ref_colour_of(specular),
                                       ref_colour_of(s->light_colour)), lobe));
}

/* The gloss has 256 entries; colours lose a level at the diffuse's share, its product, the
 * specular's product and the lobe's, and the lobe is a 256th short at its peak. */
static void assert_between(uint32_t got, ref_colour low, ref_colour high, measure *off)
{
    const ref_colour g = ref_colour_of(got);

    for (int k = 0; k < 3; k++) {
        measure_add(off, fmax(fmax(low.c[k] - g.c[k], g.c[k] - high.c[k]), 0), got, k, 0);
        assert_true(g.c[k] >= low.c[k] - 5 && g.c[k] <= high.c[k] + 5);
    }
}

static void solids_follow_phong(void **state)
{
    (void)state;
    measure off = { .what = "solid", .unit = "levels" };

    for (int n = 0; n < 1500; n++) {
        tp_shade s = any_shade();
        uint8_t gloss[TP_GLOSS];
        const int shininess = chance_int(&chance, 1, 200);
        const tp_solid solid = any_solid(gloss);
        test_run r;
        tp_shade_gloss(gloss, shininess * TP_FX_ONE);
        s.solid = &solid;
        run_any(&r, 0, &chance);
        for (int i = 0; i < TP_RUN; i++)
            r.n[i] = any_normal();
        tp_stage_solid(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_colour d = ref_colour_of(solid.diffuse);
            const ref_dir normal = unpacked(r.n[i]);
            if (grazes(&s, normal, 16 / Q14))
                continue;
            assert_between(r.run.colour[i],
                           phong(&s, d, solid.specular, shininess, normal, &r.run, i,
                                 -1 / 255.0 - 16 / Q14),
                           phong(&s, d, solid.specular, shininess, normal, &r.run, i,
                                 16 / Q14), &off);
        }
    }
    measure_print(&off);
}

/* One texel of a normal map and a face's tangent: N bends along T and B, which points to
 * the picture's top and is -(N x T) where the picture is mirrored. */
static void normal_maps_bend_solids(void **state)
{
    (void)state;
    measure off = { .what = "solid, bent", .unit = "levels" };

    for (int n = 0; n < 1500; n++) {
        tp_shade s = any_shade();
        uint8_t gloss[TP_GLOSS];
        uint32_t texel[1] = { (uint32_t)random_next(&chance) | 0x80 }, level[1];
        tp_texture map;
        tp_mesh_face face = { .vertex = { 0, 1, 2 } };
        const tp_mesh mesh = { .faces = &face, .n_faces = 1 };
        tp_solid solid = any_solid(gloss);
        test_run r;
        const double hand = n % 2 ? -1 : 1;
        assert_int_equal(tp_texture_init(&map, texel, 1, 1, level, NULL), TP_OK);
        tp_shade_gloss(gloss, 8 * TP_FX_ONE);
        solid.normal_map = &map;
        solid.bump = chance_int(&chance, 0, 512);
        s.solid = &solid;
        s.boat = &mesh;
        run_any(&r, 0, &chance);
        const uint32_t packed = any_normal(), other = any_normal();
        const ref_dir nn = unpacked(packed), o = unpacked(other);
        const double along = ref_dir_dot(nn, o);
        if (fabs(along) > 0.8)
            continue;           /* T, to be square to N, would be short */
        const ref_dir t = ref_unit((ref_dir){ o.x - along * nn.x, o.y - along * nn.y,
                                              o.z - along * nn.z });
        const ref_dir b = { nn.y * t.z - nn.z * t.y, nn.z * t.x - nn.x * t.z,
                            nn.x * t.y - nn.y * t.x };
        face.tangent = tp_dir_pack((tp_dir3){ (tp_q30)(t.x * 1073741823.0),
                                              (tp_q30)(t.y * 1073741823.0),
                                              (tp_q30)(t.z * 1073741823.0) })
                     | (hand < 0 ? TP_TANGENT_MIRRORED : 0);
        for (int i = 0; i < TP_RUN; i++) {
            r.n[i] = packed;
            r.t[i] = 0;
        }
        tp_stage_solid(&s, &r.run);
        const double bump = solid.bump / 256.0;
        const double nx = ((double)(texel[0] >> 16 & 0xff) - 128) * bump;
        const double ny = ((double)(texel[0] >> 8 & 0xff) - 128) * bump * hand;
        const double nz = fmax(32, (double)(texel[0] & 0xff) - 128);
        const ref_dir v = { nn.x * nz + t.x * nx + b.x * ny,
                            nn.y * nz + t.y * nx + b.y * ny,
                            nn.z * nz + t.z * nx + b.z * ny };
        const ref_dir bent = ref_unit(v);
        /* nx and ny are cut to whole 128ths; T has 10 bits a part, N and B are 1/511 short:
         * so far is the normal off, and R.V four times that. */
        const double e =
            (1.5 + 0.006 * hypot(nx, ny)) / sqrt(ref_dir_dot(v, v)) + 2 / 511.0;
        for (int i = 0; i < TP_RUN && !grazes(&s, bent, e); i++) {
            const ref_colour d = ref_colour_of(solid.diffuse);
            const ref_colour low = phong(&s, d, solid.specular, 8, bent, &r.run, i,
                                         -4 * e - 1 / 255.0);
            const ref_colour high =
                phong(&s, d, solid.specular, 8, bent, &r.run, i, 4 * e);
            const ref_colour g = ref_colour_of(r.run.colour[i]);
            for (int k = 0; k < 3; k++) {
                const double beyond = fmax(low.c[k] - g.c[k], g.c[k] - high.c[k]);
                measure_add(&off, fmax(beyond, 0), n, i, k);
                assert_true(beyond <= 255 * e + 5);
            }
        }
    }
    measure_print(&off);
}

/* -- cuts ---------------------------------------------------------------------------- */

/* A row in pieces is the row as a whole: cut anywhere, as boats and tiles do. */
static void runs_may_be_cut_anywhere(void **state)
{
    (void)state;
    static stage *const stages[] = {
        tp_stage_view, tp_stage_sky, tp_stage_plain, tp_stage_diffuse, tp_stage_light,
        tp_stage_diffuse_rippled, tp_stage_light_rippled, tp_stage_mirror, tp_stage_glint,
        tp_stage_haze, tp_stage_solid
    };
    enum { STAGES = sizeof stages / sizeof stages[0] };

    for (int n = 0; n < 300 * STAGES; n++) {
        tp_shade s = any_shade();
        uint8_t gloss[TP_GLOSS];
        const tp_solid solid = any_solid(gloss);
        test_run r;
        run_any(&r, 5000, &chance);
        tp_shade_gloss(gloss, 20 * TP_FX_ONE);
        tp_shade_shine(&s, 20 * TP_FX_ONE, TP_FX_ONE);
        s.solid = &solid;
        tp_stage_view(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            r.run.sx[i] = (int16_t)chance_int(&chance, -5000, 5000);
            r.run.sz[i] = (int16_t)chance_int(&chance, -5000, 5000);
        }
        tp_stage_light(&s, &r.run);
        const tp_run before = r.run;
        stages[n % STAGES](&s, &r.run);
        for (int32_t from = 0; from < TP_RUN; ) {
            const int32_t end = chance_int(&chance, from + 1, TP_RUN);
            tp_run part = run_part(&before, from, end);
            const tp_run want = run_part(&r.run, from, end);
            const size_t count = (size_t)(end - from);
            stages[n % STAGES](&s, &part);
            assert_memory_equal(part.colour, want.colour, count * sizeof *part.colour);
            assert_memory_equal(part.vx, want.vx, count * sizeof *part.vx);
            assert_memory_equal(part.vy, want.vy, count * sizeof *part.vy);
            assert_memory_equal(part.vz, want.vz, count * sizeof *part.vz);
            assert_memory_equal(part.lv, want.lv, count * sizeof *part.lv);
            assert_memory_equal(part.nv, want.nv, count * sizeof *part.nv);
            assert_memory_equal(part.up, want.up, count * sizeof *part.up);
            assert_memory_equal(part.glint, want.glint, count * sizeof *part.glint);
            from = end;
        }
    }
}

/* -- colours ------------------------------------------------------------------------- */

static void colours_keep_their_ends(void **state)
{
    (void)state;
    for (uint32_t c = 0; c < 256; c++) {
        const uint32_t grey = c * 0x010101;
        assert_int_equal(tp_colour_scale(grey, 256), grey);
        assert_int_equal(tp_colour_scale(grey, 0), 0);
        assert_int_equal(tp_colour_mix(grey, 0x123456, 0), grey);
        assert_int_equal(tp_colour_mix(0x123456, grey, 256), grey);
        assert_int_equal(tp_colour_times(grey, 0xffffff), grey);
        assert_int_equal(tp_colour_times(grey, 0) & 0xffffff, 0);
        assert_int_equal(tp_colour_add(grey, 0), grey);
        assert_int_equal(tp_colour_add(grey, 0xffffff), 0xffffff);
        for (uint32_t share = 0; share <= 256; share++)
            assert_int_equal(tp_colour_mix(grey, grey, share), grey);
    }
}

static void logarithms_are_within_a_twelfth(void **state)
{
    (void)state;
    measure off = { .what = "log2", .unit = "of 1" };

    for (uint64_t n = 1; n < 1ull << 32; n += 1 + n / 3000) {
        const double e = tp_log2_q8((uint32_t)n) / 256.0 - log2((double)n);
        assert_true(e <= 0 && e >= -1 / 11.0);
        measure_add(&off, e, (int64_t)n, 0, 0);
    }
    measure_print(&off);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_view_points_to_the_eye),
        cmocka_unit_test(the_sky_turns_from_horizon_to_zenith),
        cmocka_unit_test(diffuse_follows_lambert),
        cmocka_unit_test(light_follows_lambert),
        cmocka_unit_test(no_slope_makes_water_brighter_than_itself),
        cmocka_unit_test(light_hands_on_view_and_mirror),
        cmocka_unit_test(glints_follow_the_phong_lobe),
        cmocka_unit_test(glints_add_the_light_and_hold_at_white),
        cmocka_unit_test(mirrors_show_the_sky_by_fresnel),
        cmocka_unit_test(fresnel_has_the_known_ends),
        cmocka_unit_test(haze_goes_into_the_horizon),
        cmocka_unit_test(solids_follow_phong),
        cmocka_unit_test(normal_maps_bend_solids),
        cmocka_unit_test(runs_may_be_cut_anywhere),
        cmocka_unit_test(colours_keep_their_ends),
        cmocka_unit_test(logarithms_are_within_a_twelfth),
    };
    return cmocka_run_group_tests_name("stages", tests, NULL, NULL);
}
