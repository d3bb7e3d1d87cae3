/* SPDX-License-Identifier: MIT */
/* OBJ files with the oddities of real files: faces without area, polygons and lines of any
 * length, positions in millimetres, missing texture coordinates, very long names. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "tests/lib/meshes.h"

#define ONE TP_FX_ONE

/* -- faces ------------------------------------------------------------------------ */

static void faces_of_fewer_than_three_corners_are_left_out_and_counted(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, OBJ_TRIANGLE "v 9 9 9\nf\nf 4\nf 1 2\nf 1 2 3\nf 1 4 # 3\nf 3/ 4/\n");
    assert_int_equal(r.mesh.n_faces, 1);
    assert_int_equal(r.obj.short_faces, 5);
    assert_int_equal(r.obj.dropped, 0);
    assert_int_equal(r.mesh.n_vertices, 3);     /* vertex 4 belongs to no drawn face */
    assert_int_equal(r.mesh.high.x, ONE);
    finish(&r);
}

static void what_a_short_face_names_is_not_looked_at(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, OBJ_TRIANGLE "usemtl a\nf 1 99\nf 0 -7\nf 1/5 2/5\nf 1 2 3\n");
    assert_int_equal(r.obj.short_faces, 3);
    finish(&r);
    accept_text(&r, OBJ_TRIANGLE "f 1 2\nusemtl a\nf 1 2 3\n");
    assert_int_equal(r.mesh.n_materials, 1);    /* no material without a name */
    finish(&r);
}

/* A face with a row of corners above and a row below; the line reaches the maximum
 * length. */
static char *make_long_face(uint32_t corners, const char *blank, const char *end)
{
    char *const text = malloc(corners * 40 + 100);
    size_t n = 0;
    for (uint32_t i = 0; i < corners; i++) {
        const uint32_t at = i < corners / 2 ? i : corners - 1 - i;
        n += (size_t)sprintf(text + n, "v %g %d 0\n", at / 16., i < corners / 2 ? 0 : 1);
    }
    n += (size_t)sprintf(text + n, "f");
    for (uint32_t i = 1; i <= corners; i++)
        n += (size_t)sprintf(text + n, "%s%u", blank, (unsigned)i);
    sprintf(text + n, "%s", end);
    return text;
}

static void polygons_of_any_number_of_corners_are_cut(void **state)
{
    (void)state;
    static const uint32_t corners[] = { 256, 258, 272, 1000, 3000, 10000 };
    static const char *const blanks[] = { " ", "  ", " \\\n", "\t", " ", "    " };
    static const char *const ends[] = { "\n", "", " # 1 2 3\n", "\r\n", "\\\n", " \n" };
    for (int i = 0; i < 6; i++) {
        char *const text = make_long_face(corners[i], blanks[i], ends[i]);
        for (size_t piece = i < 4 ? 1 : 1000; piece < 2000000; piece *= 37) {
            obj_reader r;
            assert_int_equal(read_bytes(&r, text, strlen(text), NULL, 0, piece), TP_OK);
            assert_int_equal(r.mesh.n_faces, corners[i] - 2);
            assert_int_equal(r.mesh.n_vertices, corners[i]);
            assert_int_equal(r.obj.dropped, 0);
            finish(&r);
        }
        free(text);
    }
}

static void a_comment_ends_a_long_face_for_good(void **state)
{
    (void)state;
    static char text[40000] = OBJ_TRIANGLE "f 1 2 3 #";
    for (int i = 0; i < 9000; i++)
        strcpy(text + strlen(OBJ_TRIANGLE) + 9 + 3 * i, " 99");
    obj_reader r;
    for (size_t piece = 1; piece < 100000; piece *= 50) {
        assert_int_equal(read_bytes(&r, text, strlen(text), NULL, 0, piece), TP_OK);
        assert_int_equal(r.mesh.n_faces, 1);
        finish(&r);
    }
}

static void an_error_in_a_long_face_is_located_alike_in_all_pieces(void **state)
{
    (void)state;
    static const struct { const char *end; tp_status code; } ends[] = {
        { " 0\n", TP_E_OBJ_ZERO }, { " 9999\n", TP_E_OBJ_VERTEX },
        { " 1/1\n", TP_E_OBJ_MIXED }, { " x\n", TP_E_OBJ_NUMBER },
    };
    for (int i = 0; i < 4; i++) {
        char *const text = make_long_face(3000, " ", ends[i].end);
        for (size_t piece = 1; piece < 100000; piece *= 50) {
            obj_reader r;
            assert_int_equal(read_bytes(&r, text, strlen(text), NULL, 0, piece),
                             ends[i].code);
            assert_int_equal(r.err.where, 3001);
            finish(&r);
        }
        free(text);
    }
}

/* A corner of 4100 digits, and skipped words: names of parts, unknown statements. */
static void words_longer_than_a_part_are_refused_only_where_they_count(void **state)
{
    (void)state;
    static char text[20000];
    static const struct { const char *start; char fill; tp_status code; } lines[] = {
        { "f 1 2 3 ", '0', TP_E_OBJ_LINE }, { "f 1 2 3 #", '0', TP_OK },
        { "g ", 'x', TP_OK }, { "o ", 'x', TP_OK }, { "l ", '1', TP_OK },
        { "", 'x', TP_OK }, { "vt ", '0', TP_E_OBJ_LINE }, { "vt 0 ", ' ', TP_E_OBJ_LINE },
        { "s ", '1', TP_E_OBJ_LINE }, { "usemtl ", 'n', TP_E_OBJ_LINE },
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        const size_t n = (size_t)sprintf(text, OBJ_TRIANGLE "f 1 2 3\n%s", lines[i].start);
        memset(text + n, lines[i].fill, 4100);
        strcpy(text + n + 4100, "\nf 3 2 1\n");
        for (size_t piece = 1; piece < 100000; piece *= 50) {
            obj_reader r;
            assert_int_equal(read_bytes(&r, text, strlen(text), NULL, 0, piece),
                             lines[i].code);
            if (lines[i].code == TP_OK)
                assert_true(r.mesh.n_faces >= 2 && r.obj.skipped <= 1);
            else
                assert_int_equal(r.err.where, 5);
            finish(&r);
        }
    }
}

/* -- numbers ---------------------------------------------------------------------- */

/* The unit is the smallest power of two such that 16384 units reach the farthest
 * position. */
static void positions_beyond_16384_units_are_stored_coarser(void **state)
{
    (void)state;
    static const struct { const char *far; uint32_t log2; tp_fx x; } cases[] = {
        { "16383.99999", 0, 16384 * ONE - 1 },  { "16384", 1, 8192 * ONE },
        { "-32767.99999", 1, -(16384 * ONE - 1) },
        { "32768.5", 2, 8192 * ONE + ONE / 8 }, { "-100000", 3, -12500 * ONE },
        { "4194303.99999", 8, 16384 * ONE - 1 },
        { "-4194303.99999", 8, -(16384 * ONE - 1) },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[200];
        sprintf(text, OBJ_TRIANGLE "v %s 256 0\nf 4 2 3\n", cases[i].far);
        obj_reader r;
        accept_text(&r, text);
        assert_int_equal(r.mesh.log2_unit, cases[i].log2);
        assert_int_equal(r.mesh.vertices[0].position.x, cases[i].x);
        assert_int_equal(r.mesh.vertices[0].position.y, 256 * ONE >> cases[i].log2);
        assert_int_equal(r.mesh.vertices[1].position.x, ONE >> cases[i].log2);
        finish(&r);
    }
}

/* A texture on a square has the same texels per metre in every unit. */
static void texels_are_those_of_the_stored_unit(void **state)
{
    (void)state;
    for (uint32_t log2 = 0; log2 <= 6; log2 += 3) {
        char text[300];
        const int side = 16000 << log2;
        sprintf(text, "mtllib m\nusemtl a\nv 0 0 0\nv %d 0 0\nv 0 %d 0\nvt 0 0\nvt 1 0\n"
                "vt 0 1\nf 1/1 2/2 3/3\n", side, side);
        obj_reader r;
        assert_int_equal(read_text(&r, text, "newmtl a\nmap_Kd x\n"), TP_OK);
        const tp_texture texture = { .log2_w = 12, .log2_h = 12, .levels = 13 };
        const tp_texture *const list[1] = { &texture };
        assert_int_equal(tp_obj_finish(&r.obj, list, &r.mesh, &r.err), TP_OK);
        assert_int_equal(r.mesh.log2_unit, log2);
        assert_in_range(r.mesh.materials[0].texels, 4096 * ONE / 16000 - 2,
                        4096 * ONE / 16000 + 2);
        finish(&r);
    }
}

static void texture_coordinates_beyond_16384_are_0_and_counted(void **state)
{
    (void)state;
    obj_reader r;
    accept_text(&r, OBJ_TRIANGLE
                "vt 3443870976.000000 0.25 0.0\nvt 16383.5 -16384\nvt -1e30 1e30\n"
                "f 1/1 2/2 3/3\n");
    assert_int_equal(r.obj.far_texcoords, 4);
    assert_int_equal(r.mesh.vertices[0].s, 0);
    assert_int_equal(r.mesh.vertices[0].t, ONE * 3 / 4);
    assert_int_equal(r.mesh.vertices[1].s, 16383 * ONE + ONE / 2);
    assert_int_equal(r.mesh.vertices[1].t, ONE);
    assert_int_equal(r.mesh.vertices[2].t, ONE);
    finish(&r);
}

static void normals_of_any_length_point_the_same_way(void **state)
{
    (void)state;
    static const char *const files[] = { "vn 0.003 -0.004 0", "vn 3 -4 0",
                                         "vn 30000 -40000 0", "vn 3e13 -4e13 0" };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char text[200];
        sprintf(text, OBJ_TRIANGLE "%s\nf 1//1 2//1 3//1\n", files[i]);
        obj_reader r;
        accept_text(&r, text);
        const tp_packed_dir n = r.mesh.vertices[0].normal;
        assert_in_range(n & 1023, 306, 308);
        assert_in_range(1024 - (n >> 10 & 1023), 408, 410);
        finish(&r);
    }
}

/* -- materials -------------------------------------------------------------------- */

/* A file of `lines` usemtl lines with `names` different names, a face after each line. */
static char *make_materials(uint32_t lines, uint32_t names, size_t *bytes)
{
    char *const text = malloc(lines * 40 + 100);
    size_t n = (size_t)sprintf(text, OBJ_TRIANGLE);
    for (uint32_t i = 0; i < lines; i++)
        n += (size_t)sprintf(text + n, "usemtl paint %u\nf 1 2 3\n", (unsigned)(i % names));
    *bytes = n;
    return text;
}

/* Memory for the names of a file: bytes beyond the same file with a single name. */
static size_t bytes_of_names(uint32_t lines, uint32_t names)
{
    size_t bytes, all, bare;
    obj_reader r;
    char *const text = make_materials(lines, names, &bytes);
    assert_int_equal(scan_text(&r, text, bytes, 1 << 20), TP_OK);
    all = tp_obj_memory_bytes(&r.obj);
    free(text);
    char *const same = make_materials(lines, 1, &bytes);
    assert_int_equal(scan_text(&r, same, bytes, 1 << 20), TP_OK);
    bare = tp_obj_memory_bytes(&r.obj);
    free(same);
    return all - bare;
}

static void memory_grows_with_different_materials_up_to_a_bound(void **state)
{
    (void)state;
    assert_true(bytes_of_names(200000, 2) < 1000);
    assert_true(bytes_of_names(200000, 100) < 80000);
    assert_true(bytes_of_names(200000, 1000) < 1000000);
    assert_true(bytes_of_names(200000, 200000) < 1000000);
}

static void materials_beyond_4096_are_grey_and_warned_of_once(void **state)
{
    (void)state;
    enum { NAMES = 5000 };
    size_t bytes;
    char *const text = make_materials(2 * NAMES, NAMES, &bytes);
    obj_reader r;
    assert_int_equal(read_bytes(&r, text, bytes, NULL, 0, 4096), TP_OK);
    assert_int_equal(r.mesh.n_materials, TP_OBJ_MATERIALS);
    assert_int_equal(r.warnings, 1);
    assert_int_equal(r.warned.code, TP_E_OBJ_MATERIALS);
    assert_int_equal(r.warned.where, 3 + 2 * (TP_OBJ_MATERIALS - 1) + 1);
    for (uint32_t i = 0; i < 2 * NAMES; i++)
        assert_int_equal(r.mesh.faces[i].material,
                         i % NAMES < TP_OBJ_MATERIALS - 1 ? i % NAMES
                                                          : TP_OBJ_MATERIALS - 1);
    assert_int_equal(r.mesh.materials[TP_OBJ_MATERIALS - 1].diffuse, 0x808080);
    finish(&r);
    free(text);
}

static void names_with_a_nul_are_passed_over_with_a_warning(void **state)
{
    (void)state;
    static const char text[] = "mtllib a\0b\nmtllib c\n" OBJ_TRIANGLE
                               "usemtl d\nusemtl e\0f\nf 1 2 3\n";
    obj_reader r;
    assert_int_equal(read_bytes(&r, text, sizeof text - 1, NULL, 0, 7), TP_OK);
    assert_int_equal(r.warnings, 2);
    assert_int_equal(r.warned.code, TP_E_OBJ_NAME);
    assert_int_equal(r.warned.where, 1);
    assert_int_equal(r.obj.libraries, 1);
    assert_int_equal(tp_obj_library_line(&r.obj, 0), 2);
    assert_int_equal(r.mesh.n_materials, 1);
    finish(&r);
}

static void names_may_fill_a_line(void **state)
{
    (void)state;
    static char text[3 * TP_OBJ_LINE_BYTES] = OBJ_TRIANGLE "usemtl ";
    memset(text + strlen(text), 'n', 4000);
    strcat(text, "\nf 1 2 3\nmtllib ");
    memset(text + strlen(text), 'l', 4000);
    obj_reader r;
    accept_text(&r, text);
    assert_int_equal(r.obj.libraries, 1);
    assert_int_equal(strlen(tp_obj_library(&r.obj, 0)), 4000);
    finish(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faces_of_fewer_than_three_corners_are_left_out_and_counted),
        cmocka_unit_test(what_a_short_face_names_is_not_looked_at),
        cmocka_unit_test(polygons_of_any_number_of_corners_are_cut),
        cmocka_unit_test(a_comment_ends_a_long_face_for_good),
        cmocka_unit_test(an_error_in_a_long_face_is_located_alike_in_all_pieces),
        cmocka_unit_test(words_longer_than_a_part_are_refused_only_where_they_count),
        cmocka_unit_test(positions_beyond_16384_units_are_stored_coarser),
        cmocka_unit_test(texels_are_those_of_the_stored_unit),
        cmocka_unit_test(texture_coordinates_beyond_16384_are_0_and_counted),
        cmocka_unit_test(normals_of_any_length_point_the_same_way),
        cmocka_unit_test(memory_grows_with_different_materials_up_to_a_bound),
        cmocka_unit_test(materials_beyond_4096_are_grey_and_warned_of_once),
        cmocka_unit_test(names_with_a_nul_are_passed_over_with_a_warning),
        cmocka_unit_test(names_may_fill_a_line),
    };
    return cmocka_run_group_tests_name("mesh/found", tests, NULL, NULL);
}
