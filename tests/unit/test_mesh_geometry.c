/* SPDX-License-Identifier: MIT */
/* Normals, tangents and packed directions of a mesh from a file. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include "mesh/obj.h"
#include "mesh/mesh.h"
#include "tests/lib/meshes.h"

/* Asserts a direction: a unit vector in 10 bits per component errs by half a step in
 * each. */
static void assert_dir(tp_packed_dir n, double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z);
    const double off_x = tp_dir_x(n) - x / length * 511;
    const double off_y = tp_dir_y(n) - y / length * 511;
    const double off_z = tp_dir_z(n) - z / length * 511;
    if (fabs(off_x) > 0.501 || fabs(off_y) > 0.501 || fabs(off_z) > 0.501)
        fail_msg("%d %d %d for %f %f %f", (int)tp_dir_x(n), (int)tp_dir_y(n),
                 (int)tp_dir_z(n), x / length, y / length, z / length);
}

static void accept(obj_reader *r, const char *text)
{
    assert_int_equal(read_text(r, text, NULL), TP_OK);
}

static void assert_normal(const obj_reader *r, uint32_t face, uint32_t corner, double x,
                          double y, double z)
{
    assert_dir(r->mesh.vertices[r->mesh.faces[face].vertex[corner]].normal, x, y, z);
}

/* -- packing ------------------------------------------------------------------------ */

static void a_packed_direction_is_within_half_a_step(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    for (int i = 0; i < 20000; i++) {
        const double x = (int32_t)next_random(&random), y = (int32_t)next_random(&random);
        const double z = (int32_t)next_random(&random);
        const double length = sqrt(x * x + y * y + z * z);
        const tp_dir3 d = { (tp_q30)(x / length * TP_Q30_ONE),
                            (tp_q30)(y / length * TP_Q30_ONE),
                            (tp_q30)(z / length * TP_Q30_ONE) };
        assert_dir(tp_dir_pack(d), x, y, z);
        assert_int_equal(tp_dir_pack(d) >> 30, 0);
    }
    const tp_packed_dir axes = tp_dir_pack((tp_dir3){ TP_Q30_ONE, -TP_Q30_ONE, 0 });
    assert_int_equal(tp_dir_x(axes), 511);
    assert_int_equal(tp_dir_y(axes), -511);
    assert_int_equal(tp_dir_z(axes | 3u << 30), 0);
}

/* -- normals ------------------------------------------------------------------------ */

/* Two squares that meet at a right angle along the z axis: a floor and a wall. */
#define CORNER "v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nv 0 1 0\nv 0 1 1\n"
#define FLOOR "f 1 2 3 4\n"
#define WALL  "f 1 5 6 2\n"

static void normals_of_the_file_are_made_unit(void **state)
{
    (void)state;
    obj_reader r;
    accept(&r, CORNER "vn 0 0.001 0\nvn 300 400 0\nvn -1 2 -3\n"
               "s 1\nf 1//1 2//2 3//3\n");
    assert_normal(&r, 0, 0, 0, 1, 0);
    assert_normal(&r, 0, 1, 3, 4, 0);
    assert_normal(&r, 0, 2, -1, 2, -3);
    finish(&r);
}

static void without_smoothing_faces_are_flat(void **state)
{
    (void)state;
    static const char *const files[] = { CORNER FLOOR WALL, CORNER "s off\n" FLOOR WALL,
                                         CORNER "s 1\ns 0\n" FLOOR WALL };
    for (size_t i = 0; i < 3; i++) {
        obj_reader r;
        accept(&r, files[i]);
        assert_int_equal(r.mesh.n_vertices, 8);
        for (uint32_t k = 0; k < 12; k++)
            assert_normal(&r, k / 3, k % 3, k >= 6, k < 6, 0);
        finish(&r);
    }
}

static void a_smoothing_group_shares_normals(void **state)
{
    (void)state;
    obj_reader r;
    accept(&r, CORNER "s 1\n" FLOOR WALL);
    assert_int_equal(r.mesh.n_vertices, 6);
    assert_normal(&r, 0, 0, 1, 1, 0);           /* vertex 1, on the edge */
    assert_normal(&r, 0, 1, 1, 1, 0);           /* vertex 2 */
    assert_normal(&r, 0, 2, 0, 1, 0);           /* vertex 3 */
    assert_normal(&r, 2, 1, 1, 0, 0);           /* vertex 5 */
    finish(&r);
}

static void two_smoothing_groups_do_not(void **state)
{
    (void)state;
    obj_reader r;
    accept(&r, CORNER "s 1\n" FLOOR "s 2\n" WALL);
    assert_int_equal(r.mesh.n_vertices, 8);
    for (uint32_t k = 0; k < 12; k++)
        assert_normal(&r, k / 3, k % 3, k >= 6, k < 6, 0);
    finish(&r);
}

static void larger_faces_weigh_more(void **state)
{
    (void)state;
    obj_reader r; /* the wall has three times the height */
    accept(&r, "v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nv 0 3 0\nv 0 3 1\ns 7\n" FLOOR WALL);
    assert_normal(&r, 0, 1, 3, 1, 0);
    finish(&r);
}

static void a_texture_seam_does_not_break_smoothness(void **state)
{
    (void)state;
    obj_reader r;
    accept(&r, CORNER "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\ns 1\n"
               "f 1/1 2/2 3/3 4/4\nf 1/2 5/3 6/4 2/1\n");
    assert_int_equal(r.mesh.n_vertices, 8);
    assert_normal(&r, 0, 0, 1, 1, 0);
    assert_normal(&r, 2, 0, 1, 1, 0);
    finish(&r);
}

static void tiny_and_vast_meshes_get_their_normals(void **state)
{
    (void)state;
    obj_reader r;                                   /* one unit of 16.16 wide */
    accept(&r, "v 0 0 0\nv 0 0 0.0000152587890625\nv 0.0000152587890625 0 0\n"
               "s 1\nf 1 2 3\n");
    assert_normal(&r, 0, 0, 0, 1, 0);
    finish(&r);
    accept(&r, "v -16383 -16383 -16383\nv 16383 -16383 -16383\nv 16383 16383 16383\n"
               "v -16383 16383 16383\ns 1\nf 1 2 3 4\nf 1 2 3 4\nf 1 2 3\n");
    assert_int_equal(r.mesh.n_faces, 5);
    for (uint32_t k = 0; k < 15; k++)
        assert_normal(&r, k / 3, k % 3, 0, -1, 1);
    finish(&r);
}

/* A sphere of 40 x 20 quads in one smoothing group: computed normals point away from the
 * centre. */
static void a_smooth_sphere_is_round(void **state)
{
    (void)state;
    static char text[200000];
    size_t n = 0;
    const double turn = 3.14159265358979 / 20;
    for (int i = 1; i < 20; i++)
        for (int k = 0; k < 40; k++)
            n += (size_t)sprintf(text + n, "v %.6f %.6f %.6f\n",
                                 2 * sin(i * turn) * cos(k * turn), 2 * cos(i * turn),
                                 -2 * sin(i * turn) * sin(k * turn));
    n += (size_t)sprintf(text + n, "s 1\n");
    for (int i = 0; i < 18; i++)
        for (int k = 0; k < 40; k++) {
            const int a = i * 40 + k + 1, b = i * 40 + (k + 1) % 40 + 1;
            n += (size_t)sprintf(text + n, "f %d %d %d %d\n", a, a + 40, b + 40, b);
        }
    obj_reader r;
    accept(&r, text);
    assert_int_equal(r.mesh.n_vertices, 760);
    double worst = 1;
    for (uint32_t i = 0; i < r.mesh.n_vertices; i++) {
        const tp_mesh_vertex *const v = &r.mesh.vertices[i];
        const double x = tp_dir_x(v->normal), y = tp_dir_y(v->normal);
        const double z = tp_dir_z(v->normal), length = sqrt(x * x + y * y + z * z);
        const double along = x * v->position.x + y * v->position.y + z * v->position.z;
        if (abs((int)v->position.y) < 3 * 65536 / 2)        /* without the rims */
            worst = fmin(worst, along / (length * 2 * 65536));
    }
    assert_true(worst > cos(0.5 * 3.14159265358979 / 180)); /* a flat quad errs by 6 deg */
    finish(&r);
}

/* -- tangents ------------------------------------------------------------------------ */

typedef struct { double x, y, z; } vec;

/* Tangent in double precision: T = (e dt_f - f dt_e) / (ds_e dt_f - ds_f dt_e). */
static vec tangent_of(const vec p[3], const double s[3], const double t[3])
{
    const double dse = s[1] - s[0], dsf = s[2] - s[0];
    const double dte = t[1] - t[0], dtf = t[2] - t[0];
    const double d = dse * dtf - dsf * dte;
    return (vec){ ((p[1].x - p[0].x) * dtf - (p[2].x - p[0].x) * dte) / d,
                  ((p[1].y - p[0].y) * dtf - (p[2].y - p[0].y) * dte) / d,
                  ((p[1].z - p[0].z) * dtf - (p[2].z - p[0].z) * dte) / d };
}

static void random_tangents_agree_with_double(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    for (int i = 0; i < 500; i++) {
        char text[1000];
        size_t n = 0;
        vec p[3];
        double s[3], t[3];
        for (int k = 0; k < 3; k++) {
            p[k] = (vec){ (int)(next_random(&random) % 2001) - 1000,
                          (int)(next_random(&random) % 2001) - 1000,
                          (int)(next_random(&random) % 2001) - 1000 };
            s[k] = (int)(next_random(&random) % 99) - 50;
            t[k] = (int)(next_random(&random) % 99) - 50;
            n += (size_t)sprintf(text + n, "v %g %g %g\nvt %g %g\n", p[k].x, p[k].y,
                                 p[k].z, s[k], t[k]);
        }
        sprintf(text + n, "f 1/1 2/2 3/3\n");
        const double turn = (s[1] - s[0]) * (t[2] - t[0]) - (s[2] - s[0]) * (t[1] - t[0]);
        if (turn == 0)
            continue;
        obj_reader r;
        accept(&r, text);
        const vec want = tangent_of(p, s, t);
        const tp_packed_dir tangent = r.mesh.faces[0].tangent;
        assert_dir(tangent, want.x, want.y, want.z);
        assert_int_equal((tangent & TP_TANGENT_MIRRORED) != 0, turn < 0);
        assert_int_equal(tangent >> 31, 0);
        finish(&r);
    }
}

/* N x T, negated if the sign bit is set, points to the texture's top: the direction of
 * growing vt. */
static void the_bitangent_points_to_the_pictures_top(void **state)
{
    (void)state;
    for (int mirrored = 0; mirrored <= 1; mirrored++) {
        char text[200];
        sprintf(text, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt %d 0\nvt 0 1\n"
                "f 1/1 2/2 3/3\n", mirrored ? -1 : 1);
        obj_reader r;
        accept(&r, text);
        const tp_packed_dir tangent = r.mesh.faces[0].tangent;
        const tp_packed_dir normal = r.mesh.vertices[0].normal;
        const int32_t sign = tangent & TP_TANGENT_MIRRORED ? -1 : 1;
        assert_dir(tangent, mirrored ? -1 : 1, 0, 0);
        assert_int_equal(sign * (tp_dir_z(normal) * tp_dir_x(tangent)
                                 - tp_dir_x(normal) * tp_dir_z(tangent)), 511 * 511);
        finish(&r);
    }
}

static void faces_without_a_picture_get_some_tangent(void **state)
{
    (void)state;
    static const char *const faces[] = {
        "f 1 2 3\n", "f 1 3 2\n", "f 1 2 4\n", "f 1 3 4\n", "f 2 3 4\n",
        "vt 1 1\nf 2/1 3/1 4/1\n" };
    for (size_t i = 0; i < sizeof faces / sizeof *faces; i++) {
        char text[200] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
        strcat(text, faces[i]);
        obj_reader r;
        accept(&r, text);
        const tp_packed_dir t = r.mesh.faces[0].tangent, n = r.mesh.vertices[0].normal;
        const int32_t dot = tp_dir_x(t) * tp_dir_x(n) + tp_dir_y(t) * tp_dir_y(n)
                          + tp_dir_z(t) * tp_dir_z(n);
        assert_in_range(dot + 511, 0, 1022);
        assert_in_range(tp_dir_x(t) * tp_dir_x(t) + tp_dir_y(t) * tp_dir_y(t)
                        + tp_dir_z(t) * tp_dir_z(t), 510 * 510, 512 * 512);
        finish(&r);
    }
}

/* -- area vectors ------------------------------------------------------------------ */

static void area_vectors_are_exact_at_the_ends_of_the_range(void **state)
{
    (void)state;
    enum { E = INT32_MAX - 1 };
    const int64_t square = (int64_t)E * E;
    const tp_area a = tp_area_cross((tp_vec3){ E, -E, E }, (tp_vec3){ E, E, -E });
    assert_true(a.x == 0 && a.y == 2 * square && a.z == 2 * square);
    const double length = sqrt(2.) * 2 * (double)square;
    const double off = (double)tp_area_length(tp_area_divide_pow2(a, 1)) * 2 / length - 1;
    assert_true(fabs(off) < 0x1p-29);
    assert_int_equal(tp_area_sum_shift(E, 1u << 24), 2 * 31 + 2 + 25 - 63);
    assert_int_equal(tp_area_sum_shift((1 << 21) - 1, (1 << 19) - 1), 0);
    const tp_area down = tp_area_divide_pow2((tp_area){ -7, 7, -8 }, 2);
    assert_true(down.x == -1 && down.y == 1 && down.z == -2);
}

int main(void)
{
    static uint64_t seed;
    seed = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(a_packed_direction_is_within_half_a_step, &seed),
        cmocka_unit_test(normals_of_the_file_are_made_unit),
        cmocka_unit_test(without_smoothing_faces_are_flat),
        cmocka_unit_test(a_smoothing_group_shares_normals),
        cmocka_unit_test(two_smoothing_groups_do_not),
        cmocka_unit_test(larger_faces_weigh_more),
        cmocka_unit_test(a_texture_seam_does_not_break_smoothness),
        cmocka_unit_test(tiny_and_vast_meshes_get_their_normals),
        cmocka_unit_test(a_smooth_sphere_is_round),
        cmocka_unit_test_prestate(random_tangents_agree_with_double, &seed),
        cmocka_unit_test(the_bitangent_points_to_the_pictures_top),
        cmocka_unit_test(faces_without_a_picture_get_some_tangent),
        cmocka_unit_test(area_vectors_are_exact_at_the_ends_of_the_range),
    };
    return cmocka_run_group_tests_name("mesh/geometry", tests, NULL, NULL);
}
