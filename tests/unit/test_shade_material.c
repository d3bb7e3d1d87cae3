/* SPDX-License-Identifier: MIT */
/* Packed normals; Phong shading on meshes, with and without a normal map, in double
 * precision.  Errors are in levels of 255. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/boat/boat.h"
#include "mesh/mesh.h"
#include "shade/material.h"
#include "tests/lib/shading.h"

static uint64_t chance;

static uint32_t any_normal(void)
{
    return tp_dir_pack(tp_normalise(chance_int(&chance, -99, 99),
                                    chance_int(&chance, -99, 99),
                                    chance_int(&chance, -99, 99)));
}

static ref_dir unpack_dir(tp_packed_dir n)
{
    return ref_unit((ref_dir){ tp_dir_x(n), tp_dir_y(n), tp_dir_z(n) });
}

/* True where the light grazes the surface: there the lobe begins or ends abruptly. */
static bool grazes(const tp_shade *s, ref_dir normal, double slack)
{
    return fabs(ref_dir_dot(normal, shade_light(&s->world))) < slack;
}

/* Phong with a lobe at R.V plus `slack`. */
static ref_colour phong(const tp_shade *s, ref_colour diffuse, uint32_t specular,
                        int shininess, ref_dir normal, const tp_run *run, int i,
                        double slack)
{
    const ref_dir v = { run->vx[i] / Q14, run->vy[i] / Q14, run->vz[i] / Q14 };
    const double nl = ref_clamp(ref_dir_dot(normal, shade_light(&s->world)), 0, 1);
    const double rv = 2 * nl * ref_dir_dot(normal, v) - run->lv[i] / Q14;
    const double ambient = s->ambient / 256.0;
    const double lobe = nl > 0 ? pow(ref_clamp(rv + slack, 0, 1), shininess) : 0;

    return ref_add(ref_scale(diffuse, ambient + (1 - ambient) * nl),
                   ref_scale(ref_times(ref_colour_unpack(specular),
                                       ref_colour_unpack(s->light_colour)), lobe));
}

/* The gloss table has 256 entries with linear interpolation.  Colours lose a level at the
 * diffuse share, its product, the specular product and the lobe's product, and the lobe is
 * a 256th short at its peak. */
static void assert_between(uint32_t got, ref_colour low, ref_colour high, measure *off)
{
    const ref_colour g = ref_colour_unpack(got);

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
        tp_shade s = shade_any(&chance);
        uint8_t gloss[TP_GLOSS];
        const int shininess = chance_int(&chance, 1, 200);
        const tp_solid solid = solid_any(gloss, &chance);
        test_run r;
        tp_shade_gloss(gloss, shininess * TP_FX_ONE);
        run_any(&r, 0, &chance);
        const tp_boat_shading shading = { NULL, &solid, s.world };
        r.run.mine = &shading;
        for (int i = 0; i < TP_RUN; i++)
            r.n[i] = any_normal();
        tp_stage_solid(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++) {
            const ref_colour d = ref_colour_unpack(solid.diffuse);
            const ref_dir normal = unpack_dir(r.n[i]);
            if (grazes(&s, normal, 16 / Q14))
                continue;
            assert_between(r.run.colour[i],
                           phong(&s, d, solid.specular, shininess, normal, &r.run, i,
                                 -0.5 / 255 - 16 / Q14),
                           phong(&s, d, solid.specular, shininess, normal, &r.run, i,
                                 0.5 / 255 + 16 / Q14), &off);
        }
    }
    measure_print(&off);
}

/* One texel of a normal map and a face's tangent: N tilts along T and B.  B points to the
 * texture's top and is -(N x T) where the texture is mirrored. */
static void normal_maps_bend_solids(void **state)
{
    (void)state;
    measure off = { .what = "solid, bent", .unit = "levels" };

    for (int n = 0; n < 1500; n++) {
        tp_shade s = shade_any(&chance);
        uint8_t gloss[TP_GLOSS];
        uint32_t texel[1] = { (uint32_t)random_next(&chance) | 0x80 }, level[1];
        tp_texture map;
        tp_mesh_face face = { .vertex = { 0, 1, 2 } };
        const tp_mesh mesh = { .faces = &face, .n_faces = 1 };
        tp_solid solid = solid_any(gloss, &chance);
        test_run r;
        const double hand = n % 2 ? -1 : 1;
        assert_int_equal(
            tp_texture_init(&map, texel, 1, 1, level, tp_texture_bytes(1, 1), NULL),
            TP_OK);
        tp_shade_gloss(gloss, 8 * TP_FX_ONE);
        solid.normal_map = &map;
        solid.bump = chance_int(&chance, 0, 512);
        run_any(&r, 0, &chance);
        const tp_boat_shading shading = { &mesh, &solid, s.world };
        r.run.mine = &shading;
        const uint32_t packed = any_normal(), other = any_normal();
        const ref_dir nn = unpack_dir(packed), o = unpack_dir(other);
        const double along = ref_dir_dot(nn, o);
        if (fabs(along) > 0.8)
            continue;           /* T would be short after the projection square to N */
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
        /* nx and ny are truncated to whole 128ths; T has 10 bits per component, N and B are
         * 1/511 short: the sum is the normal's error, and R.V errs by four times as
         * much. */
        const double e =
            (1.5 + 0.006 * hypot(nx, ny)) / sqrt(ref_dir_dot(v, v)) + 2 / 511.0;
        for (int i = 0; i < TP_RUN && !grazes(&s, bent, e); i++) {
            const ref_colour d = ref_colour_unpack(solid.diffuse);
            const ref_colour low = phong(&s, d, solid.specular, 8, bent, &r.run, i,
                                         -4 * e - 1 / 255.0);
            const ref_colour high =
                phong(&s, d, solid.specular, 8, bent, &r.run, i, 4 * e);
            const ref_colour g = ref_colour_unpack(r.run.colour[i]);
            for (int k = 0; k < 3; k++) {
                const double beyond = fmax(low.c[k] - g.c[k], g.c[k] - high.c[k]);
                measure_add(&off, fmax(beyond, 0), n, i, k);
                assert_true(beyond <= 255 * e + 5);
            }
        }
    }
    measure_print(&off);
}

/* A packed normal unpacks to the bits of tp_vec_q14_unit: words of small components, of
 * either sign and in every order, and a sample of all 2^30. */
static void packed_normals_unpack_to_bits_of_unit(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 1u << 20; i++) {
        const uint32_t x = i & 7, y = i >> 3 & 7, z = i >> 6 & 7;
        const uint32_t near_0 = ((x - 4) & 1023) | ((y - 4) & 1023) << 10
                                | ((z - 4) & 1023) << 20;
        const tp_packed_dir n = i < 512 ? near_0 : (i * 2654435761u) & 0x3fffffff;
        const tp_vec_q14 got = tp_vec_q14_unpack(n);
        const tp_vec_q14 want = tp_vec_q14_unit(tp_dir_x(n), tp_dir_y(n), tp_dir_z(n));
        assert_int_equal(got.x, want.x);
        assert_int_equal(got.y, want.y);
        assert_int_equal(got.z, want.z);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(packed_normals_unpack_to_bits_of_unit),
        cmocka_unit_test(solids_follow_phong),
        cmocka_unit_test(normal_maps_bend_solids),
    };
    return cmocka_run_group_tests_name("shade/material", tests, NULL, NULL);
}
