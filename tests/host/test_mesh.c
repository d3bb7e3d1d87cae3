/* SPDX-License-Identifier: MIT */
/* Incomplete meshes: each missing thing is reported once with file and line, and the
 * mesh is drawn without it.  With --strict the same line refuses the scene, and nothing
 * stays half loaded. */
#define _XOPEN_SOURCE 700
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <sys/stat.h>
#include "tests/lib/png_files.h"

#define CORNERS "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
#define FACE    "f 1/1 2/2 3/3\n"
#define TEXTURED "newmtl oak\nKd 1 0 0\n\nmap_Kd "

static void write_text(const char *name, const char *text, size_t bytes)
{
    FILE *file = fopen(name, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, bytes, file), bytes);
    fclose(file);
}

/* Opens the scene of boat.obj; messages go to `said`.  On success the mesh stays open. */
static int open_mesh(asset_set *a, const char *scale, assets_options options)
{
    scene_file scene;
    FILE *file = fopen("case.ini", "w");
    assert_non_null(file);
    fprintf(file, "[boat]\nmesh = boat.obj\nscale = %s\n", scale);
    fclose(file);
    listen();
    int code = scene_file_open(&scene, "./case.ini");
    assert_int_equal(code, EXIT_DONE);
    code = assets_load(a, &scene, &options);
    scene_file_close(&scene);
    stop_listening();
    if (code)
        assert_null(a->blocks);
    return code;
}

/* Expects the message `without`, then "; " and the remedy. */
static void assert_drawn_without(const char *scale, const char *without, const char *remedy)
{
    char line[8192];
    asset_set a;
    if (open_mesh(&a, scale, (assets_options){ 0 }))
        fail_msg("refused: %s", said);
    snprintf(line, sizeof line, "%s; %s\n", without, remedy);
    assert_string_equal(said, line);
    assert_true(a.boat.n_faces > 0);
    assets_close(&a);
    assert_int_equal(open_mesh(&a, scale, (assets_options){ .quiet = true }), EXIT_DONE);
    assert_string_equal(said, "");
    assets_close(&a);
    assert_int_equal(open_mesh(&a, scale, (assets_options){ .strict = true }), EXIT_INPUT);
    snprintf(line, sizeof line, "%s\n", without);
    assert_string_equal(said, line);
}

static void assert_whole(void)
{
    asset_set a;
    if (open_mesh(&a, "1", (assets_options){ .strict = true }))
        fail_msg("refused: %s", said);
    assert_string_equal(said, "");
    assets_close(&a);
}

static void write_mesh(const char *obj, const char *mtl)
{
    write_text("boat.obj", obj, strlen(obj));
    if (mtl)
        write_text("oak.mtl", mtl, strlen(mtl));
    else
        remove("oak.mtl");
}

static void a_whole_mesh_passes_strict(void **state)
{
    (void)state;
    write_kind(&kinds[4], "kind.png");
    write_mesh("mtllib oak.mtl\n" CORNERS "usemtl oak\n" FACE, TEXTURED "kind.png\n");
    assert_whole();
}

static void pictures_of_other_kinds_are_left_out(void **state)
{
    (void)state;
    static const struct { const char *name, *start, *why; } others[] = {
        { "bad.jpg", "\xff\xd8\xff\xe0 and so on", "JPEG, expected PNG" },
        { "bad.TGA", "\1\2\3", "TGA, expected PNG" },
        { "bad.png", "BM and so on", "BMP, expected PNG" },
        { "bad.png", "text", "not a PNG" },
        { "bad.png", "\x89PNG", "not a good PNG: the file ends too early" },
    };
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        char mtl[200], want[200];
        snprintf(mtl, sizeof mtl, TEXTURED "%s\n", others[i].name);
        snprintf(want, sizeof want, "./oak.mtl:4: ./%s: %s", others[i].name, others[i].why);
        write_mesh("mtllib oak.mtl\n" CORNERS "usemtl oak\n" FACE, mtl);
        write_text(others[i].name, others[i].start, strlen(others[i].start));
        assert_drawn_without("1", want, "drawn without it");
        remove(others[i].name);
    }
}

static void missing_files_are_left_out(void **state)
{
    (void)state;
    write_mesh("mtllib oak.mtl\n" CORNERS "usemtl oak\n" FACE, TEXTURED "no\\such.png\n");
    assert_drawn_without("1", "./oak.mtl:4: ./no/such.png: No such file or directory",
                         "drawn without it");
    write_mesh("\nmtllib oak.mtl\n" CORNERS "usemtl oak\n" FACE, NULL);
    assert_drawn_without("1", "./boat.obj:2: ./oak.mtl: No such file or directory",
                         "its materials are drawn in grey");
    assert_int_equal(mkdir("oak.mtl", 0700), 0);
    assert_drawn_without("1", "./boat.obj:2: ./oak.mtl: No such file or directory",
                         "its materials are drawn in grey");
    assert_int_equal(rmdir("oak.mtl"), 0);
}

static void a_missing_picture_leaves_the_plain_colour(void **state)
{
    (void)state;
    asset_set a;
    write_mesh("mtllib oak.mtl\n" CORNERS "usemtl oak\n" FACE, TEXTURED "none.png\n");
    assert_int_equal(open_mesh(&a, "1", (assets_options){ 0 }), EXIT_DONE);
    assert_int_equal(a.boat.materials[0].diffuse, 0xff0000);
    assert_null(a.boat.materials[0].diffuse_map);
    assets_close(&a);
}

static void materials_that_no_library_defines_are_grey(void **state)
{
    (void)state;
    write_mesh("mtllib oak.mtl\n" CORNERS "usemtl oak\n" FACE "usemtl elm\n" FACE
               "usemtl oak\n" FACE "usemtl elm\n" FACE, "newmtl oak\n");
    assert_drawn_without("1", "./boat.obj:10: material elm is not defined",
                         "drawn in grey");
}

static void bad_lines_of_a_library_are_left_out(void **state)
{
    (void)state;
    static const char obj[] = "mtllib oak.mtl\n" CORNERS "usemtl oak\n" FACE;
    write_mesh(obj, "Ns 5\nnewmtl oak\n");
    assert_drawn_without("1", "./oak.mtl:1: Ns before any newmtl", "the line is left out");
    write_mesh(obj, "newmtl oak\nKd red\n");
    assert_drawn_without("1", "./oak.mtl:2: expected a number, found red",
                         "the line is left out");
    write_mesh(obj, "newmtl oak\nNs 2000\n");
    assert_drawn_without("1", "./oak.mtl:2: Ns is outside 0..1000", "the nearest is taken");
}

static void faces_and_texture_coordinates_without_sense_are_counted(void **state)
{
    (void)state;
    write_mesh(CORNERS FACE "f 1 2\n", NULL);
    assert_drawn_without("1", "./boat.obj: 1 face of fewer than 3 corners", "left out");
    write_mesh(CORNERS FACE "f 1 2\nf\n", NULL);
    assert_drawn_without("1", "./boat.obj: 2 faces of fewer than 3 corners", "left out");
    write_mesh(CORNERS "vt 3443870976 -1e9\n" FACE, NULL);
    assert_drawn_without("1", "./boat.obj: 2 texture coordinates beyond +-16384",
                         "taken as 0");
}

/* A model in millimetres, 25 m long, with the right scale and without. */
static void a_mesh_too_large_for_its_scale_is_told_one_that_fits(void **state)
{
    (void)state;
    asset_set a;
    write_mesh("v 0 0 0\nv 25000 0 0\nv 0 0 -1\nf 1 2 3\n", NULL);
    assert_int_equal(open_mesh(&a, "0.001", (assets_options){ .strict = true }), EXIT_DONE);
    assert_int_equal(a.boat.log2_unit, 1);
    assets_close(&a);
    assert_drawn_without("1", "./boat.obj: reaches 25000 m from its origin at boat.scale 1,"
                         " expected 4000 at the most: boat.scale = 0.15999 fits",
                         "farther vertices are moved to this distance");
    assert_int_equal(open_mesh(&a, "0.15999", (assets_options){ .strict = true }),
                     EXIT_DONE);
    assets_close(&a);
    write_mesh("v 0 0 0\nv 0 -4194303.9 0\nv 0 0 1\nf 1 2 3\n", NULL);
    assert_int_equal(open_mesh(&a, "0.001", (assets_options){ .strict = true }),
                     EXIT_INPUT);
    assert_string_equal(said, "./boat.obj: reaches 4223 m from its origin at boat.scale"
                        " 0.001, expected 4000 at the most: no boat.scale fits\n");
    write_mesh("v 4194304 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n", NULL);
    assert_int_equal(open_mesh(&a, "0.001", (assets_options){ 0 }), EXIT_INPUT);
    assert_string_equal(said, "./boat.obj:1: coordinate beyond +-4194304\n");
}

static void of_very_many_warnings_the_first_are_said(void **state)
{
    (void)state;
    char mtl[4000] = "newmtl oak\n";
    int lines = 0;
    asset_set a;
    for (int i = 0; i < 100; i++)
        strcat(mtl, "Ns x\n");
    write_mesh("mtllib oak.mtl\n" CORNERS "usemtl oak\n" FACE "f 1\n", mtl);
    assert_int_equal(open_mesh(&a, "1", (assets_options){ 0 }), EXIT_DONE);
    for (const char *c = said; *c; c++)
        lines += *c == '\n';
    assert_int_equal(lines, 17);
    assert_non_null(strstr(said, "\n./boat.obj: and 85 more\n"));
    assets_close(&a);
}

/* An error in the OBJ is an error with and without --strict. */
static void an_obj_that_cannot_be_read_is_refused(void **state)
{
    (void)state;
    asset_set a;
    write_mesh(CORNERS "f 1 2 9\n", NULL);
    assert_int_equal(open_mesh(&a, "1", (assets_options){ 0 }), EXIT_INPUT);
    assert_string_equal(said, "./boat.obj:7: face uses vertex 9 of 3\n");
    remove("boat.obj");
    assert_int_equal(open_mesh(&a, "1", (assets_options){ 0 }), EXIT_INPUT);
    assert_string_equal(said, "./case.ini:2: boat.mesh: ./boat.obj: No such file or"
                        " directory\n");
}

/* Opens the scene at a rung of quality.mesh; returns the number of the mesh's faces. */
static uint32_t count_faces_at(const char *mesh, const char *rung)
{
    char setting[64];
    scene_file scene;
    asset_set a;
    snprintf(setting, sizeof setting, "boat.mesh=%s", mesh);
    assert_int_equal(scene_file_open(&scene, "./case.ini"), EXIT_DONE);
    assert_int_equal(scene_file_set(&scene, setting), EXIT_DONE);
    snprintf(setting, sizeof setting, "quality.mesh=%s", rung);
    assert_int_equal(scene_file_set(&scene, setting), EXIT_DONE);
    assert_int_equal(assets_open(&a, &scene), EXIT_DONE);
    const uint32_t count = a.boat.n_faces;
    assets_close(&a);
    scene_file_close(&scene);
    return count;
}

static void the_rung_of_the_mesh_chooses_the_file_beside_it(void **state)
{
    (void)state;
    const char *const two = CORNERS FACE FACE, *const one = CORNERS FACE;
    write_mesh(CORNERS FACE FACE FACE, NULL);
    write_text("boat-mid.obj", two, strlen(two));
    assert_int_equal(count_faces_at("boat.obj", "auto"), 3);
    assert_int_equal(count_faces_at("boat.obj", "full"), 3);
    assert_int_equal(count_faces_at("boat.obj", "middle"), 2);
    assert_int_equal(count_faces_at("boat.obj", "low"), 3);     /* there is none */
    write_text("boat-low.obj", one, strlen(one));
    assert_int_equal(count_faces_at("boat.obj", "low"), 1);
    assert_int_equal(count_faces_at("boat-low.obj", "middle"), 1);
    remove("boat-mid.obj");
    remove("boat-low.obj");
}

static int leave_meshes(void **state)
{
    remove("boat.obj");
    remove("oak.mtl");
    return leave(state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_whole_mesh_passes_strict),
        cmocka_unit_test(pictures_of_other_kinds_are_left_out),
        cmocka_unit_test(missing_files_are_left_out),
        cmocka_unit_test(a_missing_picture_leaves_the_plain_colour),
        cmocka_unit_test(materials_that_no_library_defines_are_grey),
        cmocka_unit_test(bad_lines_of_a_library_are_left_out),
        cmocka_unit_test(faces_and_texture_coordinates_without_sense_are_counted),
        cmocka_unit_test(a_mesh_too_large_for_its_scale_is_told_one_that_fits),
        cmocka_unit_test(of_very_many_warnings_the_first_are_said),
        cmocka_unit_test(an_obj_that_cannot_be_read_is_refused),
        cmocka_unit_test(the_rung_of_the_mesh_chooses_the_file_beside_it),
    };
    return cmocka_run_group_tests_name("mesh", tests, enter, leave_meshes);
}
