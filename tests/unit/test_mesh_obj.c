/* SPDX-License-Identifier: MIT */
/* Statements accepted by the OBJ reader, and the errors for refused statements. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "base/base.h"
#include "tests/lib/meshes.h"

#define ONE TP_FX_ONE

static void assert_position(const obj_reader *r, uint32_t vertex, tp_fx x, tp_fx y, tp_fx z)
{
    assert_true(vertex < r->mesh.n_vertices);
    const tp_vec3 p = r->mesh.vertices[vertex].position;
    assert_int_equal(p.x, x);
    assert_int_equal(p.y, y);
    assert_int_equal(p.z, z);
}

/* -- valid files -------------------------------------------------------------------- */

static void a_triangle_is_read(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, OBJ_TRIANGLE "f 1 2 3\n");
    assert_int_equal(r.mesh.n_vertices, 3);
    assert_int_equal(r.mesh.n_faces, 1);
    assert_int_equal(r.mesh.n_materials, 1);
    for (uint32_t i = 0; i < 3; i++)
        assert_int_equal(r.mesh.faces[0].vertex[i], i);
    assert_position(&r, 1, ONE, 0, 0);
    assert_position(&r, 2, 0, ONE, 0);
    assert_int_equal(r.mesh.low.x, 0);
    assert_int_equal(r.mesh.high.x, ONE);
    assert_int_equal(r.mesh.high.z, 0);
    finish(&r);
}

static void numbers_of_every_form_are_exact(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, "v -1.5e1 +.25 1.\nv 12500e-4 1E+2 -0.0\nv 0.0000152587890625 "
               "1e-30 16383.9999\nf 1 2 3");
    assert_position(&r, 0, -15 * ONE, ONE / 4, ONE);
    assert_position(&r, 1, ONE + ONE / 4, 100 * ONE, 0);
    assert_position(&r, 2, 1, 0, 16384 * ONE - 7);
    finish(&r);
}

static void weights_and_colours_after_a_vertex_are_ignored(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, "v 1 2 3 1.0\nv 0 0 0 0.5 0.25 1\nv 1 0 0 # corner\nf 1 2 3 # face\n");
    assert_position(&r, 0, ONE, 2 * ONE, 3 * ONE);
    assert_position(&r, 2, ONE, 0, 0);
    finish(&r);
}

static void texture_coordinates_grow_downwards(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, OBJ_TRIANGLE "vt 0.25 0.25\nvt 1 1 0\nvt 0.5\nf 1/1 2/2 3/3\n");
    assert_int_equal(r.mesh.vertices[0].s, ONE / 4);
    assert_int_equal(r.mesh.vertices[0].t, ONE * 3 / 4);
    assert_int_equal(r.mesh.vertices[1].t, 0);
    assert_int_equal(r.mesh.vertices[2].s, ONE / 2);
    assert_int_equal(r.mesh.vertices[2].t, ONE);
    finish(&r);
}

static void all_four_forms_of_a_corner_are_read(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, OBJ_TRIANGLE "vt 0 0\nvn 0 0 1\n"
               "f 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\n");
    assert_int_equal(r.mesh.n_faces, 4);
    assert_int_equal(r.mesh.n_vertices, 12);
    finish(&r);
}

static void corners_alike_are_one_vertex(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 2\n"
               "f 1//1 2//1 3//1\nf 1//1 3//1 4//1\nf 4//1 3//1 2//2\n");
    assert_int_equal(r.mesh.n_faces, 3);
    assert_int_equal(r.mesh.n_vertices, 5);     /* vertex 4 and corner 2 with normal 2 */
    finish(&r);
}

static void negative_indices_count_back_from_where_they_stand(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, OBJ_TRIANGLE "f -3 -2 -1\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf -3 -2 -1\n");
    assert_int_equal(r.mesh.n_faces, 2);
    assert_position(&r, r.mesh.faces[0].vertex[0], 0, 0, 0);
    assert_position(&r, r.mesh.faces[1].vertex[0], 5 * ONE, 0, 0);
    finish(&r);
}

static void a_face_may_name_vertices_that_follow(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, "f 1 2 3\n" OBJ_TRIANGLE);
    assert_int_equal(r.mesh.n_faces, 1);
    finish(&r);
}

static void line_ends_of_every_kind_are_read(void **state)
{
    (void)state;
    static const char *const ends[] = { "\n", "\r\n", "\r", "\n\n", " \t \r\n" };
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        char text[200];
        const char *const e = ends[i];
        snprintf(text, sizeof text, "%s# c%sv 0 0 0%sv 1 0 0%s\tv 0 1 0%sf 1 2 3",
                 e, e, e, e, e);
        obj_reader r;
        accept_text(&r, text);
        assert_int_equal(r.mesh.n_faces, 1);
        assert_int_equal(r.obj.skipped, 0);
        finish(&r);
    }
}

static void a_backslash_joins_lines(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, "v 0 0\\\n 0\nv 1 0 0\r\nv 0 \\\r\n\\\r\n1 0\nf 1\\\n\\\n 2 3\\\n");
    assert_position(&r, 2, 0, ONE, 0);
    assert_int_equal(r.mesh.n_faces, 1);
    finish(&r);
}

static void comments_do_not_join_and_may_have_any_length(void **state)
{
    (void)state;
    char text[9000];
    memset(text, '-', sizeof text);
    memcpy(text, "# ", 2);
    strcpy(text + 8000, "\n  # art \\\n" OBJ_TRIANGLE "f 1 2 3\n");
    obj_reader r;
    accept_text(&r, text);
    assert_int_equal(r.mesh.n_faces, 1);
    finish(&r);
}

static void unknown_statements_are_counted_and_groups_are_not(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r,
                "o boat\ng hull left\n" OBJ_TRIANGLE "vp 1 2\nl 1 2\np 1\nshadow_obj x\n"
                "g\nf 1 2 3\nusemap off\n");
    assert_int_equal(r.obj.skipped, 5);
    finish(&r);
}

static void names_may_hold_spaces(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, "mtllib my boat.mtl\nmtllib a.mtl my sails.MTL  spare parts \n"
               "mtllib my boat.mtl\n" OBJ_TRIANGLE
               "usemtl  Oak #2 (dark) \nf 1 2 3\nusemtl Oak\nf 1 3 2\n"
               "usemtl Oak #2 (dark)\nf 2 1 3\n");
    assert_int_equal(r.obj.libraries, 4);
    assert_string_equal(tp_obj_library(&r.obj, 0), "my boat.mtl");
    assert_string_equal(tp_obj_library(&r.obj, 1), "a.mtl");
    assert_string_equal(tp_obj_library(&r.obj, 2), "my sails.MTL");
    assert_string_equal(tp_obj_library(&r.obj, 3), "spare parts");
    assert_int_equal(r.mesh.n_materials, 2);
    assert_int_equal(r.mesh.faces[0].material, 0);
    assert_int_equal(r.mesh.faces[1].material, 1);
    assert_int_equal(r.mesh.faces[2].material, 0);
    finish(&r);
}

static void many_names_are_numbered_in_order(void **state)
{
    (void)state;
    enum { NAMES = 3000 };
    char *const text = malloc(200 + NAMES * 60);
    size_t n = (size_t)sprintf(text, OBJ_TRIANGLE);
    for (int i = 0; i < 2 * NAMES; i++)
        n += (size_t)sprintf(text + n, "usemtl paint no %d\nf 1 2 3\n", i % NAMES);
    obj_reader r;
    accept_text(&r, text);
    assert_int_equal(r.mesh.n_materials, NAMES);
    for (uint32_t i = 0; i < 2 * NAMES; i++)
        assert_int_equal(r.mesh.faces[i].material, i % NAMES);
    finish(&r);
    free(text);
}

static void a_polygon_of_256_corners_is_cut(void **state)
{
    (void)state;
    char text[10000];
    size_t n = 0;
    for (int i = 0; i < 128; i++)               /* two convex chains */
        n += (size_t)sprintf(text + n, "v %d %d 0\n", i, i * (i - 127));
    for (int i = 0; i < 128; i++)
        n += (size_t)sprintf(text + n, "v %d %d 0\n", 127 - i, 10 + i * (127 - i));
    n += (size_t)sprintf(text + n, "f");
    for (int i = 0; i < 256; i++)
        n += (size_t)sprintf(text + n, " %d", i + 1);
    obj_reader r;
    accept_text(&r, text);
    assert_int_equal(r.mesh.n_faces, 254);
    assert_int_equal(r.obj.dropped, 0);
    finish(&r);
}

static void triangles_without_area_are_left_out_and_counted(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, OBJ_TRIANGLE "v 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\nf 1 2 4 3\n");
    assert_int_equal(r.mesh.n_faces, 3);        /* the quad has a straight corner */
    assert_int_equal(r.obj.dropped, 2);
    finish(&r);
}

static void a_new_scan_forgets_everything(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, OBJ_TRIANGLE "usemtl a\nf 1 2 3\n");
    tp_obj_begin_count(&r.obj);
    assert_int_equal(tp_obj_feed(&r.obj, "f 1 2 x\n", 8, &r.err), TP_E_OBJ_NUMBER);
    tp_obj_begin_count(&r.obj);
    assert_int_equal(tp_obj_feed(&r.obj, OBJ_TRIANGLE "f 1 2 3", 31, &r.err), TP_OK);
    assert_int_equal(tp_obj_end_count(&r.obj, &r.err), TP_OK);
    finish(&r);
}

/* -- refused files ------------------------------------------------------------------ */

typedef struct {
    const char *text;
    tp_status   code;
    uint32_t    where;
    int32_t     a, b;
    const char *word;
} refusal;

static void bad_files_get_code_line_and_numbers(void **state)
{
    (void)state;
    static const refusal refused[] = {
        { "", TP_E_OBJ_EMPTY, 1, 0, 0, "" },
        { OBJ_TRIANGLE, TP_E_OBJ_EMPTY, 4, 0, 0, "" },
        { OBJ_TRIANGLE "f 1 1 2\n", TP_E_OBJ_EMPTY, 5, 0, 0, "" },
        { "v 0 0\n", TP_E_OBJ_MISSING, 1, 3, 2, "v" },
        { "v\n", TP_E_OBJ_MISSING, 1, 3, 0, "v" },
        { "v 0 0 # 0\n", TP_E_OBJ_MISSING, 1, 3, 2, "v" },
        { "vt\n", TP_E_OBJ_MISSING, 1, 1, 0, "vt" },
        { "vn 1 0\n", TP_E_OBJ_MISSING, 1, 3, 2, "vn" },
        { "v 0 zero 0\n", TP_E_OBJ_NUMBER, 1, 0, 0, "zero" },
        { "v 0 0,5 0\n", TP_E_OBJ_NUMBER, 1, 0, 0, "0,5" },
        { "v nan inf 0\n", TP_E_OBJ_NUMBER, 1, 0, 0, "nan" },
        { "v 0x10 0 0\n", TP_E_OBJ_NUMBER, 1, 0, 0, "0x10" },
        { "v 1e 0 0\n", TP_E_OBJ_NUMBER, 1, 0, 0, "1e" },
        { "\n#\nv 4194304 0 0\n", TP_E_OBJ_RANGE, 3, TP_OBJ_RANGE, 0, "" },
        { "v 0 -4194304 0\n", TP_E_OBJ_RANGE, 1, TP_OBJ_RANGE, 0, "" },
        { "v 0 0 1e999999999999999999999\n", TP_E_OBJ_RANGE, 1, TP_OBJ_RANGE, 0, "" },
        { OBJ_TRIANGLE "f 0 1 2\n", TP_E_OBJ_ZERO, 4, 0, 0, "" },
        { OBJ_TRIANGLE "f 1 -0 2\n", TP_E_OBJ_ZERO, 4, 0, 0, "" },
        { OBJ_TRIANGLE "f 1/0 2/0 3/0\n", TP_E_OBJ_ZERO, 4, 0, 0, "" },
        { OBJ_TRIANGLE "f 1 2 3\nf 1 2 9\nf 1 2 3", TP_E_OBJ_VERTEX, 5, 9, 3, "" },
        { "v 0 0 0\nf -1 -2 -1\n" OBJ_TRIANGLE, TP_E_OBJ_VERTEX, 2, -2, 1, "" },
        { OBJ_TRIANGLE "f 1 2 99999999999999999999\n", TP_E_OBJ_VERTEX, 4, INT32_MAX, 3,
          "" },
        { OBJ_TRIANGLE "f 1 2 -99999999999999999999\n", TP_E_OBJ_VERTEX, 4, -INT32_MAX, 3,
          "" },
        { OBJ_TRIANGLE "f 1 2 4294967297\n", TP_E_OBJ_VERTEX, 4, INT32_MAX, 3, "" },
        { OBJ_TRIANGLE "vt 0 0\nf 1/1 2/1 3/2\n", TP_E_OBJ_TEXCOORD, 5, 2, 1, "" },
        { OBJ_TRIANGLE "f 1//1 2//1 3//1\nvn 0 0 1\nf 1//2 2//1 3//1", TP_E_OBJ_NORMAL, 6,
          2, 1, "" },
        { OBJ_TRIANGLE "f 1 2\n", TP_E_OBJ_EMPTY, 5, 0, 0, "" },
        { OBJ_TRIANGLE "f 1 2x\n", TP_E_OBJ_NUMBER, 4, 0, 0, "2x" },
        { OBJ_TRIANGLE "f 1 2//1\n", TP_E_OBJ_MIXED, 4, 0, 0, "" },
        { OBJ_TRIANGLE "vt 0 0\nf 1/1 2 3/1\n", TP_E_OBJ_MIXED, 5, 0, 0, "" },
        { OBJ_TRIANGLE "vn 0 0 1\nf 1//1 2//1 3\n", TP_E_OBJ_MIXED, 5, 0, 0, "" },
        { OBJ_TRIANGLE "f 1 2 3x\n", TP_E_OBJ_NUMBER, 4, 0, 0, "3x" },
        { OBJ_TRIANGLE "f 1 2 /3\n", TP_E_OBJ_NUMBER, 4, 0, 0, "/3" },
        { OBJ_TRIANGLE "f 1 2 3/1/1/1\n", TP_E_OBJ_NUMBER, 4, 0, 0, "3/1/1/1" },
        { OBJ_TRIANGLE "f 1 2 3.5\n", TP_E_OBJ_NUMBER, 4, 0, 0, "3.5" },
        { "s smooth\n", TP_E_OBJ_NUMBER, 1, 0, 0, "smooth" },
        { "s -1\n", TP_E_OBJ_NUMBER, 1, 0, 0, "-1" },
        { "v 0 0 0\\\n\nv 0 0 \\\n\\\nx\n", TP_E_OBJ_NUMBER, 3, 0, 0, "x" },
    };
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        const refusal *const want = &refused[i];
        obj_reader r;
        const tp_status code = read_text(&r, want->text, NULL);
        if (code != want->code || r.err.where != want->where || r.err.a != want->a
            || r.err.b != want->b || strcmp(r.err.word, want->word) != 0)
            fail_msg("\"%s\": %s, line %u, %d, %d, \"%s\"", want->text,
                     tp_status_text(code), (unsigned)r.err.where, (int)r.err.a,
                     (int)r.err.b, r.err.word);
        finish(&r);
    }
}

static void a_line_of_4096_bytes_is_read_and_of_4097_refused(void **state)
{
    (void)state;
    for (size_t piece = 1; piece <= 8192; piece *= 8) {
        for (int more = 0; more <= 1; more++) {
            char text[5000] = "v 0 0 0\nv 1 0 0\n";
            const size_t at = strlen(text), length = (size_t)(4096 + more);
            memset(text + at, '0', length);
            memcpy(text + at, "v 0 1 0.", 8);
            strcpy(text + at + length, "\r\nf 1 2 3\n");
            obj_reader r;
            const tp_status status = read_bytes(&r, text, strlen(text), NULL, 0, piece);
            assert_int_equal(status, more ? TP_E_OBJ_LINE : TP_OK);
            assert_true(!more || (r.err.where == 3 && r.err.a == 4096));
            finish(&r);
        }
    }
}

static void a_number_of_a_million_digits_is_a_located_error(void **state)
{
    (void)state;
    enum { DIGITS = 1000000 };
    char *const text = malloc(DIGITS + 100);
    strcpy(text, "v 0 0 0\nv ");
    memset(text + 10, '7', DIGITS);
    strcpy(text + 10 + DIGITS, " 0 0\n");
    for (size_t piece = 7; piece < 10000000; piece *= 1000) {
        obj_reader r;
        assert_int_equal(read_bytes(&r, text, strlen(text), NULL, 0, piece),
                         TP_E_OBJ_LINE);
        assert_int_equal(r.err.where, 2);
    }
    free(text);
}

static void more_than_2_to_the_24_of_one_kind_are_refused(void **state)
{
    (void)state;
    enum { LINES = 1 << 16 };
    char *const text = malloc(LINES * 5);
    for (size_t i = 0; i < LINES; i++)
        memcpy(text + i * 5, "vt 0\n", 5);
    obj_reader r;
    tp_obj_begin_count(&r.obj);
    for (uint32_t i = 0; i < TP_OBJ_COUNT / LINES; i++)
        assert_int_equal(tp_obj_feed(&r.obj, text, LINES * 5, &r.err), TP_OK);
    assert_int_equal(tp_obj_feed(&r.obj, text, LINES * 5, &r.err), TP_E_OBJ_COUNT);
    assert_int_equal(r.err.where, TP_OBJ_COUNT + 1);
    assert_int_equal(r.err.a, TP_OBJ_COUNT);
    free(text);
}

/* Names so long that the reader remembers few of them; nearly every name is counted
 * anew. */
static void more_than_2_to_the_20_libraries_are_refused(void **state)
{
    (void)state;
    enum { LINES = 1 << 12, BYTES = 100, MOST = 1 << 20 };
    char *const text = malloc(LINES * BYTES + 1);
    obj_reader r;
    tp_obj_begin_count(&r.obj);
    tp_status status = TP_OK;
    for (uint32_t i = 0; i <= MOST && status == TP_OK; i += LINES) {
        for (uint32_t k = 0; k < LINES; k++)
            sprintf(text + k * BYTES, "mtllib %092x\n", (unsigned)(i + k));
        status = tp_obj_feed(&r.obj, text, LINES * BYTES, &r.err);
    }
    assert_int_equal(status, TP_E_OBJ_COUNT);
    assert_int_equal(r.err.a, MOST);
    assert_int_equal(r.err.where, MOST + 1);
    free(text);
}

static void calls_out_of_order_are_refused(void **state)
{
    (void)state;
    obj_reader r;
    tp_obj_begin_count(&r.obj);
    assert_int_equal(tp_obj_end_load(&r.obj, &r.err), TP_E_ARG);
    tp_obj_begin_count(&r.obj);
    tp_obj_begin_load(&r.obj, &r);
    assert_int_equal(tp_obj_feed(&r.obj, "#", 1, &r.err), TP_E_ARG);
    tp_obj_begin_count(&r.obj);
    assert_int_equal(tp_obj_finish(&r.obj, NULL, &r.mesh, NULL), TP_E_ARG);
    accept_text(&r, OBJ_TRIANGLE "f 1 2 3\n");
    tp_mtl_begin(&r.obj, 0);                    /* the file names no library */
    assert_int_equal(tp_mtl_feed(&r.obj, "#", 1, &r.err), TP_E_ARG);
    finish(&r);
    accept_text(&r, OBJ_TRIANGLE "f 1 2 3\n");
    assert_int_equal(tp_mtl_end(&r.obj, &r.err), TP_E_ARG);
    finish(&r);
    tp_obj_begin_count(&r.obj);
    assert_int_equal(tp_obj_feed(&r.obj, NULL, 0, &r.err), TP_OK);
    assert_int_equal(tp_obj_feed(&r.obj, OBJ_TRIANGLE "f 1 2 3\n", 32, &r.err), TP_OK);
    assert_int_equal(tp_obj_end_count(&r.obj, &r.err), TP_OK);
    assert_int_equal(tp_obj_end_count(&r.obj, &r.err), TP_E_ARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_triangle_is_read),
        cmocka_unit_test(numbers_of_every_form_are_exact),
        cmocka_unit_test(weights_and_colours_after_a_vertex_are_ignored),
        cmocka_unit_test(texture_coordinates_grow_downwards),
        cmocka_unit_test(all_four_forms_of_a_corner_are_read),
        cmocka_unit_test(corners_alike_are_one_vertex),
        cmocka_unit_test(negative_indices_count_back_from_where_they_stand),
        cmocka_unit_test(a_face_may_name_vertices_that_follow),
        cmocka_unit_test(line_ends_of_every_kind_are_read),
        cmocka_unit_test(a_backslash_joins_lines),
        cmocka_unit_test(comments_do_not_join_and_may_have_any_length),
        cmocka_unit_test(unknown_statements_are_counted_and_groups_are_not),
        cmocka_unit_test(names_may_hold_spaces),
        cmocka_unit_test(many_names_are_numbered_in_order),
        cmocka_unit_test(a_polygon_of_256_corners_is_cut),
        cmocka_unit_test(triangles_without_area_are_left_out_and_counted),
        cmocka_unit_test(a_new_scan_forgets_everything),
        cmocka_unit_test(bad_files_get_code_line_and_numbers),
        cmocka_unit_test(a_line_of_4096_bytes_is_read_and_of_4097_refused),
        cmocka_unit_test(a_number_of_a_million_digits_is_a_located_error),
        cmocka_unit_test(more_than_2_to_the_24_of_one_kind_are_refused),
        cmocka_unit_test(more_than_2_to_the_20_libraries_are_refused),
        cmocka_unit_test(calls_out_of_order_are_refused),
    };
    return cmocka_run_group_tests_name("mesh/obj", tests, NULL, NULL);
}
