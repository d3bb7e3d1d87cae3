/* SPDX-License-Identifier: MIT */
/* Faults in an MTL are no errors: each line that cannot be used gives a warning. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/meshes.h"

#define ONE TP_FX_ONE
#define ONE_MATERIAL "mtllib m.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"

/* Asserts the text of a warning as the program prints it. */
static void assert_warning(const char *mtl, uint32_t line, const char *want)
{
    obj_reader r;
    char text[200];
    assert_int_equal(read_text(&r, ONE_MATERIAL, mtl), TP_OK);
    assert_int_equal(r.warnings, 1);
    assert_int_equal(r.warned.where, line);
    tp_error_text(&r.warned, text, sizeof text);
    assert_string_equal(text, want);
    finish(&r);
}

static void each_number_out_of_range_is_named_with_its_range(void **state)
{
    (void)state;
    assert_warning("newmtl wood\nNs 1024\n", 2, "Ns is outside 0..1000");
    assert_warning("newmtl wood\n\nNs -1\n", 3, "Ns is outside 0..1000");
    assert_warning("newmtl wood\nKs 0 0 1.1\n", 2, "Ks is outside 0..1");
    assert_warning("newmtl wood\nTr 2\n", 2, "Tr is outside 0..1");
    assert_warning("newmtl wood\nd 1.01\n", 2, "d is outside 0..1");
    assert_warning("newmtl wood\nbump -bm -17 x.png\n", 2, "bump is outside -16..16");
}

static void more_warnings_than_are_kept_are_counted(void **state)
{
    (void)state;
    char mtl[1000] = "newmtl wood\n";
    for (int i = 0; i < TP_OBJ_WARNINGS + 7; i++)
        strcat(mtl, "Ns x\n");
    obj_reader r;
    assert_int_equal(read_text(&r, ONE_MATERIAL, mtl), TP_OK);
    assert_int_equal(r.warnings, TP_OBJ_WARNINGS + 7);
    finish(&r);
}

static void a_line_that_cannot_be_read_is_left_out_and_warned_of(void **state)
{
    (void)state;
    static const struct {
        const char *mtl;
        tp_status code;
        uint32_t where;
        const char *word;
    } warned[] = {
        { "Kd 1 0 0\nnewmtl wood\n", TP_E_MTL_ORDER, 1, "Kd" },
        { "# Kd\n\nmap_Kd x.png\nnewmtl wood\n", TP_E_MTL_ORDER, 3, "map_Kd" },
        { "newmtl wood\nKd red\n", TP_E_OBJ_NUMBER, 2, "red" },
        { "newmtl wood\nKd\n", TP_E_OBJ_MISSING, 2, "Kd" },
        { "newmtl wood\nKd 1 0\n", TP_E_OBJ_MISSING, 2, "Kd" },
        { "newmtl wood\r\nNs\r\n", TP_E_OBJ_MISSING, 2, "Ns" },
        { "newmtl wood\rd 1,0\r", TP_E_OBJ_NUMBER, 2, "1,0" },
        { "newmtl wood\nTr x", TP_E_OBJ_NUMBER, 2, "x" },
    };
    for (size_t i = 0; i < sizeof warned / sizeof *warned; i++) {
        obj_reader r;
        assert_int_equal(read_text(&r, ONE_MATERIAL, warned[i].mtl), TP_OK);
        const tp_material m = r.mesh.materials[0];
        assert_int_equal(r.warnings, 1);
        assert_int_equal(r.warned.code, warned[i].code);
        assert_int_equal(r.warned.where, warned[i].where);
        assert_string_equal(r.warned.word, warned[i].word);
        assert_int_equal(m.diffuse, 0x808080);
        assert_int_equal(m.shininess, 32 * ONE);
        assert_int_equal(m.opacity, ONE);
        assert_int_equal(r.obj.images, 0);
        finish(&r);
    }
}

/* The preceding material must not receive the properties of a material with an unreadable
 * name. */
static void a_name_that_cannot_be_read_hides_its_material(void **state)
{
    (void)state;
    static char mtl[6000] = "newmtl wood\nKd 0 1 0\nnewmtl ";
    memset(mtl + strlen(mtl), 'n', 5000);
    strcat(mtl, "\nKd 1 0 0\nNs 5\n");
    obj_reader r;
    assert_int_equal(read_text(&r, ONE_MATERIAL, mtl), TP_OK);
    assert_int_equal(r.mesh.materials[0].diffuse, 0x00ff00);
    assert_int_equal(r.warned.code, TP_E_OBJ_LINE);
    assert_int_equal(r.warned.where, 3);
    finish(&r);
    static const char nul[] = "newmtl wood\nKd 0 1 0\nnewmtl a\0b\nKd 1 0 0\n";
    assert_int_equal(read_bytes(&r, ONE_MATERIAL, strlen(ONE_MATERIAL), nul,
                                sizeof nul - 1, 9), TP_OK);
    assert_int_equal(r.mesh.materials[0].diffuse, 0x00ff00);
    assert_int_equal(r.warned.code, TP_E_OBJ_NAME);
    finish(&r);
}

/* The path of a texture may be as long as the line allows. */
static void names_of_pictures_may_fill_a_line(void **state)
{
    (void)state;
    static char mtl[TP_OBJ_LINE_BYTES + 100] = "newmtl wood\nmap_Kd ";
    const size_t start = strlen(mtl), length = TP_OBJ_LINE_BYTES - strlen("map_Kd ");
    memset(mtl + start, 'p', length);
    obj_reader r;
    assert_int_equal(read_text(&r, ONE_MATERIAL, mtl), TP_OK);
    assert_int_equal(r.warnings, 0);
    assert_int_equal(strlen(tp_obj_image(&r.obj, 0)), length);
    assert_int_equal(tp_obj_image_line(&r.obj, 0), 2);
    finish(&r);
    mtl[start + length] = 'p';
    assert_int_equal(read_text(&r, ONE_MATERIAL, mtl), TP_OK);
    assert_int_equal(r.warned.code, TP_E_OBJ_LINE);
    assert_int_equal(r.obj.images, 0);
    finish(&r);
}

/* Two materials share room for 4 names of 256 bytes and one name of any length. */
static void names_of_pictures_beyond_their_room_are_left_out(void **state)
{
    (void)state;
    static char mtl[12000] = "newmtl wood\nmap_Kd ";
    memset(mtl + strlen(mtl), 'p', 4000);
    strcat(mtl, "\nbump ");
    memset(mtl + strlen(mtl), 'q', 4000);
    obj_reader r;
    assert_int_equal(read_text(&r, ONE_MATERIAL, mtl), TP_OK);
    assert_int_equal(r.obj.images, 1);
    assert_int_equal(r.warned.code, TP_E_MTL_IMAGES);
    assert_int_equal(r.warned.where, 3);
    assert_int_equal(r.warned.a, 4 * 256 + TP_OBJ_LINE_BYTES);
    finish(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_number_out_of_range_is_named_with_its_range),
        cmocka_unit_test(more_warnings_than_are_kept_are_counted),
        cmocka_unit_test(a_line_that_cannot_be_read_is_left_out_and_warned_of),
        cmocka_unit_test(a_name_that_cannot_be_read_hides_its_material),
        cmocka_unit_test(names_of_pictures_may_fill_a_line),
        cmocka_unit_test(names_of_pictures_beyond_their_room_are_left_out),
    };
    return cmocka_run_group_tests_name("mesh/mtl_faults", tests, NULL, NULL);
}
