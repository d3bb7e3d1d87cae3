/* SPDX-License-Identifier: MIT */
/* Materials: the statements that the MTL reader accepts, and the material after binding. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include "base/base.h"
#include "tests/lib/meshes.h"

#define ONE TP_FX_ONE
#define TRIANGLE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
#define ONE_MATERIAL "mtllib m.mtl\nusemtl wood\n" TRIANGLE "f 1 2 3\n"

/* The material of a mesh with a single material, defined by `mtl`. */
static tp_material material_of(obj_reader *r, const char *mtl)
{
    if (read_text(r, ONE_MATERIAL, mtl) != TP_OK)
        fail_msg("\"%s\": %s", mtl, tp_status_text(r->err.code));
    assert_int_equal(r->mesh.n_materials, 1);
    const tp_material material = r->mesh.materials[0];
    finish(r);
    return material;
}

static void colours_shininess_and_opacity_are_read(void **state)
{
    (void)state;
    obj_reader r;
    const tp_material m = material_of(&r,
        "newmtl wood\nKd 1 0.5 0\nKs 0.2\nNs 96.5\nd 0.25\nillum 2\nKa 1 1 1\n");
    assert_int_equal(m.diffuse, 0xff8000);
    assert_int_equal(m.specular, 0x333333);
    assert_int_equal(m.shininess, 96 * ONE + ONE / 2);
    assert_int_equal(m.opacity, ONE / 4);
    assert_int_equal(m.bump, ONE);
    assert_null(m.diffuse_map);
    assert_null(m.normal_map);
    assert_int_equal(m.texels, 0);
    assert_int_equal(r.obj.skipped, 2);
}

static void values_out_of_range_are_clamped(void **state)
{
    (void)state;
    obj_reader r;
    const tp_material m = material_of(&r,
        "newmtl wood\nKd 7 -1 1e9\nNs 1e30\nd -3\nbump -bm 99 x.png\n");
    assert_int_equal(m.diffuse, 0xff00ff);
    assert_int_equal(m.shininess, 1000 * ONE);
    assert_int_equal(m.opacity, 0);
    assert_int_equal(m.bump, 16 * ONE);
    assert_int_equal(r.warnings, 4);
    assert_int_equal(r.warned.code, TP_E_MTL_RANGE);
    assert_int_equal(r.warned.where, 2);
    assert_string_equal(r.warned.word, "Kd");
    assert_int_equal(r.obj.warnings, 0);        /* from binding; in the library: */
    assert_int_equal(material_of(&r, "newmtl wood\nNs 0\nKd 0 1 0.5\nd 1\n").shininess,
                     ONE);
    assert_int_equal(r.warnings, 0);
}

static void spectral_and_cie_colours_are_passed_over(void **state)
{
    (void)state;
    obj_reader r;
    const tp_material m =
        material_of(&r, "newmtl wood\nKd spectral oak.rfl 1\nKs xyz 1 1 1\n");
    assert_int_equal(m.diffuse, 0x808080);
    assert_int_equal(m.specular, 0);
    assert_int_equal(r.obj.skipped, 2);
    assert_int_equal(material_of(&r, "newmtl wood\nKd 1 # white\n").diffuse, 0xffffff);
}

static void opacity_goes_before_transparency(void **state)
{
    (void)state;
    obj_reader r;
    assert_int_equal(material_of(&r, "newmtl wood\nTr 0.25\n").opacity, ONE * 3 / 4);
    assert_int_equal(material_of(&r, "newmtl wood\nTr 1\nd 1\n").opacity, ONE);
    assert_int_equal(material_of(&r, "newmtl wood\nd 1\nTr 1\n").opacity, ONE);
    assert_int_equal(material_of(&r, "newmtl wood\nd -halo 0.5\n").opacity, ONE / 2);
}

static void keywords_are_read_in_any_case(void **state)
{
    (void)state;
    obj_reader r;
    const tp_material m =
        material_of(&r, "NEWMTL wood\nKD 0 1 0\nMAP_BUMP -BM 2 a.png\n");
    assert_int_equal(m.diffuse, 0x00ff00);
    assert_int_equal(m.bump, 2 * ONE);
}

/* Diffuse colour of a material with a map in `mtl`, with or without the texture. */
static uint32_t colour_with(const char *mtl, bool picture)
{
    static const tp_texture texture = { .levels = 1 };
    const tp_texture *const list[1] = { picture ? &texture : NULL };
    obj_reader r;
    assert_int_equal(read_text(&r, ONE_MATERIAL, mtl), TP_OK);
    assert_int_equal(tp_obj_finish(&r.obj, list, &r.mesh, &r.err), TP_OK);
    const uint32_t colour = r.mesh.materials[0].diffuse;
    finish(&r);
    return colour;
}

static void a_map_without_kd_is_shown_as_it_is(void **state)
{
    (void)state;
    obj_reader r;
    assert_int_equal(colour_with("newmtl wood\nmap_Kd a.png\n", true), 0xffffff);
    assert_int_equal(colour_with("newmtl wood\nmap_Kd a.png\nKd 0 0 1\n", true), 0x0000ff);
    assert_int_equal(colour_with("newmtl wood\nKd x\nmap_Kd a.png\n", true), 0xffffff);
    assert_int_equal(material_of(&r, "newmtl wood\n").diffuse, 0x808080);
}

static void a_material_whose_picture_is_missing_keeps_its_plain_colour(void **state)
{
    (void)state;
    assert_int_equal(colour_with("newmtl wood\nmap_Kd a.png\n", false), 0x808080);
    assert_int_equal(colour_with("newmtl wood\nmap_Kd a.png\nKd 0 0 1\n", false),
                     0x0000ff);
}

static void options_of_maps_are_passed_over(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "map_Kd oak planks 2.png",
        "map_Kd   oak planks 2.png \t",
        "map_Kd -clamp on oak planks 2.png",
        "map_kd -s 1 1 1 -o 0.5 0 0 -t 1 oak planks 2.png",
        "map_KD -s 2 oak planks 2.png",
        "map_Kd -mm 0 1 -blendu off -blendv on -cc on -boost 2 oak planks 2.png",
        "map_Kd -texres 256 -imfchan r -bm 1 -type sphere oak planks 2.png",
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char mtl[200] = "newmtl wood\n";
        strcat(mtl, lines[i]);
        obj_reader r;
        assert_int_equal(read_text(&r, ONE_MATERIAL, mtl), TP_OK);
        assert_int_equal(r.obj.images, 1);
        assert_string_equal(tp_obj_image(&r.obj, 0), "oak planks 2.png");
        finish(&r);
    }
}

static void a_file_may_be_called_like_a_number_or_an_option(void **state)
{
    (void)state;
    obj_reader r;
    assert_int_equal(read_text(&r, ONE_MATERIAL,
                               "newmtl wood\nmap_Kd -s 1 1 12\nbump -x 1.png\n"), TP_OK);
    assert_string_equal(tp_obj_image(&r.obj, 0), "12");
    assert_string_equal(tp_obj_image(&r.obj, 1), "-x 1.png");
    finish(&r);
}

static void each_bump_keyword_names_the_normal_map(void **state)
{
    (void)state;
    static const char *const words[] = { "map_Bump", "map_bump", "bump", "norm" };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char mtl[200] = "newmtl wood\n";
        strcat(strcat(mtl, words[i]), " -bm 0.5 dents.png\nnorm other.png\n");
        obj_reader r;
        assert_int_equal(read_text(&r, ONE_MATERIAL, mtl), TP_OK);
        assert_int_equal(r.obj.images, 1);      /* the first definition counts */
        assert_string_equal(tp_obj_image(&r.obj, 0), "dents.png");
        assert_int_equal(r.mesh.materials[0].bump, ONE / 2);
        assert_int_equal(r.obj.skipped, 1);
        finish(&r);
    }
}

static void images_are_listed_once_for_each_library(void **state)
{
    (void)state;
    static const char obj[] = "mtllib a.mtl b.mtl\n" TRIANGLE
        "usemtl one\nf 1 2 3\nusemtl two\nf 1 2 3\nusemtl three\nf 1 2 3\n";
    static const char first[] =
        "newmtl one\nmap_Kd x.png\nbump y.png\nnewmtl two\nmap_Kd x.png\n"
        "newmtl not used\nmap_Kd unseen.png\n";
    static const char second[] =
        "newmtl three\nmap_Kd x.png\nnewmtl one\nmap_Kd unseen.png\n";
    obj_reader r;
    assert_int_equal(scan_text(&r, obj, sizeof obj - 1, 5), TP_OK);
    assert_int_equal(load_text(&r, obj, sizeof obj - 1, 5), TP_OK);
    assert_int_equal(r.obj.libraries, 2);
    tp_mtl_begin(&r.obj, 1);
    assert_int_equal(tp_mtl_feed(&r.obj, second, 35, &r.err), TP_OK);
    assert_int_equal(tp_mtl_end(&r.obj, &r.err), TP_OK);
    tp_mtl_begin(&r.obj, 0);
    assert_int_equal(tp_mtl_feed(&r.obj, first, sizeof first - 1, &r.err), TP_OK);
    assert_int_equal(tp_mtl_end(&r.obj, &r.err), TP_OK);

    assert_int_equal(r.obj.images, 3);
    static const char *const names[] = { "x.png", "x.png", "y.png" };
    static const uint32_t libraries[] = { 1, 0, 0 };
    tp_texture textures[3];
    const tp_texture *list[3];
    for (uint32_t i = 0; i < 3; i++) {
        assert_string_equal(tp_obj_image(&r.obj, i), names[i]);
        assert_int_equal(tp_obj_image_library(&r.obj, i), libraries[i]);
        list[i] = &textures[i];
        textures[i] = (tp_texture){ .levels = 1 };
    }
    list[2] = NULL;                             /* a texture that is not available */
    assert_int_equal(tp_obj_finish(&r.obj, list, &r.mesh, &r.err), TP_OK);
    assert_ptr_equal(r.mesh.materials[0].diffuse_map, &textures[1]);
    assert_null(r.mesh.materials[0].normal_map);
    assert_ptr_equal(r.mesh.materials[1].diffuse_map, &textures[1]);
    assert_ptr_equal(r.mesh.materials[2].diffuse_map, &textures[0]);
    finish(&r);
}

static void faces_without_usemtl_are_grey(void **state)
{
    (void)state;
    obj_reader r;
    assert_int_equal(read_text(&r, "mtllib m.mtl\n" TRIANGLE "f 1 2 3\n"
                               "usemtl wood\nf 1 2 3\nusemtl\nf 1 2 3\n",
                               "newmtl wood\nKd 1 0 0\n"), TP_OK);
    assert_int_equal(r.mesh.n_materials, 2);
    assert_int_equal(r.mesh.materials[0].diffuse, 0x808080);
    assert_int_equal(r.mesh.materials[0].specular, 0);
    assert_int_equal(r.mesh.materials[0].opacity, ONE);
    assert_int_equal(r.mesh.materials[1].diffuse, 0xff0000);
    assert_int_equal(r.mesh.faces[2].material, 0);
    finish(&r);
}

static void an_undefined_material_is_grey_and_warned_of_once_all_libraries_are_read(
    void **state)
{
    (void)state;
    obj_reader r;
    assert_int_equal(read_text(&r, "mtllib m.mtl\n" TRIANGLE "f 1 2 3\nusemtl old oak\n"
                               "f 1 2 3\nusemtl wood\nf 1 2 3\nusemtl elm\nf 1 2 3\n"
                               "usemtl old oak\nf 1 2 3\n", "newmtl wood\n"), TP_OK);
    assert_int_equal(r.obj.warnings, 2);        /* one warning for each name */
    assert_int_equal(r.obj.warning[0].code, TP_E_MTL_NAME);
    assert_int_equal(r.obj.warning[0].where, 6);
    assert_string_equal(r.obj.warning[0].word, "old oak");
    assert_int_equal(r.obj.warning[1].where, 10);
    assert_string_equal(r.obj.warning[1].word, "elm");
    assert_int_equal(r.mesh.materials[r.mesh.faces[1].material].diffuse, 0x808080);
    finish(&r);
    assert_int_equal(read_text(&r, ONE_MATERIAL, NULL), TP_OK);     /* m.mtl is not read */
    assert_int_equal(r.mesh.materials[0].diffuse, 0x808080);
    assert_int_equal(r.warnings, 0);
    finish(&r);
    assert_int_equal(read_text(&r, TRIANGLE "usemtl wood\nf 1 2 3\n", ""), TP_OK);
    assert_int_equal(r.warnings, 0);
    finish(&r);
}

static void materials_that_are_not_used_are_not_looked_into(void **state)
{
    (void)state;
    obj_reader r;
    material_of(&r, "newmtl stone\nKd granite\nmap_Kd x.png\nnewmtl wood\nKd 1 1 1\n");
    assert_int_equal(r.obj.images, 0);
    assert_int_equal(r.obj.skipped, 3);
}

/* Texel density of a square of `side` metres, two triangles, that shows s of a texture
 * across and t down; the texture has 2^log2_w x 2^log2_h texels. */
static tp_fx texels_of(const char *side, const char *s, const char *t, uint8_t log2_w,
                       uint8_t log2_h)
{
    char obj[400] = "mtllib m.mtl\nusemtl wood\nv 0 0 0\nv ";
    strcat(strcat(strcat(obj, side), " 0 0\nv "), side);
    strcat(strcat(strcat(strcat(obj, " 0 "), side), "\nv 0 0 "), side);
    strcat(strcat(strcat(obj, "\nvt 0 0\nvt "), s), " 0\nvt ");
    strcat(strcat(strcat(strcat(obj, s), " "), t), "\nvt 0 ");
    strcat(strcat(obj, t), "\nf 1/1 2/2 3/3 4/4\n");
    obj_reader r;
    assert_int_equal(read_text(&r, obj, "newmtl wood\nmap_Kd x.png\n"), TP_OK);
    const tp_texture texture = { .log2_w = log2_w, .log2_h = log2_h };
    const tp_texture *const list[1] = { &texture };
    assert_int_equal(tp_obj_finish(&r.obj, list, &r.mesh, &r.err), TP_OK);
    const tp_fx texels = r.mesh.materials[0].texels;
    finish(&r);
    return texels;
}

static void assert_near(tp_fx x, double want)
{
    const double off = fabs(x / 65536.0 - want);
    if (off > want * 0x1p-14 && off > 0x1p-16)
        fail_msg("%f, expected %f", x / 65536.0, want);
}

static void texels_per_metre_are_the_mean_over_the_faces(void **state)
{
    (void)state;
    assert_int_equal(texels_of("1", "1", "1", 8, 8), 256 * ONE);
    assert_int_equal(texels_of("4", "1", "1", 8, 8), 64 * ONE);
    assert_near(texels_of("1", "1", "1", 8, 7), sqrt(256 * 128));
    assert_near(texels_of("3", "0.5", "2", 9, 10), sqrt(512. * 1024) / 3);
    assert_near(texels_of("16000", "7", "5", 12, 0), sqrt(35 * 4096.) / 16000);
    assert_near(texels_of("0.01", "0.25", "0.25", 5, 5), 8 * 65536 / 655.);
    assert_near(texels_of("1000", "16383", "16383", 0, 0), 16.383);
    assert_int_equal(texels_of("0.001", "100", "100", 12, 12), TP_FX_MAX);
    assert_int_equal(texels_of("1", "0", "1", 8, 8), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colours_shininess_and_opacity_are_read),
        cmocka_unit_test(values_out_of_range_are_clamped),
        cmocka_unit_test(spectral_and_cie_colours_are_passed_over),
        cmocka_unit_test(opacity_goes_before_transparency),
        cmocka_unit_test(keywords_are_read_in_any_case),
        cmocka_unit_test(a_map_without_kd_is_shown_as_it_is),
        cmocka_unit_test(a_material_whose_picture_is_missing_keeps_its_plain_colour),
        cmocka_unit_test(options_of_maps_are_passed_over),
        cmocka_unit_test(a_file_may_be_called_like_a_number_or_an_option),
        cmocka_unit_test(each_bump_keyword_names_the_normal_map),
        cmocka_unit_test(images_are_listed_once_for_each_library),
        cmocka_unit_test(faces_without_usemtl_are_grey),
        cmocka_unit_test(
            an_undefined_material_is_grey_and_warned_of_once_all_libraries_are_read),
        cmocka_unit_test(materials_that_are_not_used_are_not_looked_into),
        cmocka_unit_test(texels_per_metre_are_the_mean_over_the_faces),
    };
    return cmocka_run_group_tests_name("mesh/mtl", tests, NULL, NULL);
}
