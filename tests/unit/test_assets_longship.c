/* SPDX-License-Identifier: MIT */
/* The longship mesh in assets/boats: closed, outward normals, textured, with the stated
 * size.  The test has an OBJ parser of its own, independent of the core's reader.  The
 * working folder is the top folder of the sources, or TP_ROOT names that folder. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <png.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/lib/asset_files.h"

enum { ROWS = 16384, FACES = 8192, MATERIALS = 32, NAME = 64 };

typedef struct {
    int at[3], map[3], normal[3];
    int material;
    bool hull;
} face;

typedef struct {
    int ats, maps, normals, faces, materials;
    double at[ROWS][3], map[ROWS][2], normal[ROWS][3];
    face face[FACES];
    char material[MATERIALS][NAME];
} longship_model;

static longship_model full, middle, low;

/* -- reading ------------------------------------------------------------------------- */

static int material_index(longship_model *m, const char *name)
{
    for (int i = 0; i < m->materials; i++) {
        if (strcmp(m->material[i], name) == 0)
            return i;
    }
    assert_true(m->materials < MATERIALS);
    strcpy(m->material[m->materials], name);
    return m->materials++;
}

/* Reads a face; all three corners must have position, texture coordinate and normal. */
static void read_face(longship_model *m, const char *line, int material, bool hull)
{
    assert_true(m->faces < FACES);
    face *f = &m->face[m->faces++];
    char more;
    int read = sscanf(line, "f %d/%d/%d %d/%d/%d %d/%d/%d %c", &f->at[0], &f->map[0],
                      &f->normal[0], &f->at[1], &f->map[1], &f->normal[1], &f->at[2],
                      &f->map[2], &f->normal[2], &more);
    if (read != 9)
        fail_msg("not a triangle with all its indices: %s", line);
    f->material = material;
    f->hull = hull;
}

static void read_line(longship_model *m, const char *line, int *material, bool *hull)
{
    char word[NAME];
    double *v = m->at[m->ats], *t = m->map[m->maps], *n = m->normal[m->normals];
    assert_true(m->ats < ROWS - 1 && m->maps < ROWS - 1 && m->normals < ROWS - 1);
    if (sscanf(line, "v %lf %lf %lf", &v[0], &v[1], &v[2]) == 3)
        m->ats++;
    else if (sscanf(line, "vt %lf %lf", &t[0], &t[1]) == 2)
        m->maps++;
    else if (sscanf(line, "vn %lf %lf %lf", &n[0], &n[1], &n[2]) == 3)
        m->normals++;
    else if (sscanf(line, "usemtl %63s", word) == 1)
        *material = material_index(m, word);
    else if (sscanf(line, "g %63s", word) == 1)
        *hull = strcmp(word, "hull") == 0;
    else if (line[0] == 'f')
        read_face(m, line, *material, *hull);
}

static void read_model(longship_model *m, const char *name)
{
    FILE *file = open_asset(name);
    char line[256];
    int material = -1;
    bool hull = false;
    while (fgets(line, sizeof line, file))
        read_line(m, line, &material, &hull);
    fclose(file);
}

static int read_models(void **state)
{
    (void)state;
    read_model(&full, "boats/longship.obj");
    read_model(&middle, "boats/longship-mid.obj");
    read_model(&low, "boats/longship-low.obj");
    return 0;
}

/* -- the meshes ---------------------------------------------------------------------- */

static void the_longship_has_1500_to_6000_triangles(void **state)
{
    (void)state;
    print_message("longship %d triangles, middle %d, low %d\n", full.faces, middle.faces,
                  low.faces);
    assert_in_range(full.faces, 1500, 6000);
}

static void the_middle_longship_has_1000_to_1500_triangles(void **state)
{
    (void)state;
    assert_in_range(middle.faces, 1000, 1500);
}

static void the_small_longship_has_at_most_300_triangles(void **state)
{
    (void)state;
    assert_in_range(low.faces, 100, 300);
}

static void check_indices(const longship_model *m)
{
    for (int i = 0; i < m->faces; i++) {
        const face *f = &m->face[i];
        assert_true(f->material >= 0);
        for (int k = 0; k < 3; k++) {
            assert_in_range(f->at[k], 1, m->ats);
            assert_in_range(f->map[k], 1, m->maps);
            assert_in_range(f->normal[k], 1, m->normals);
        }
    }
}

static void every_corner_names_what_the_file_holds(void **state)
{
    (void)state;
    check_indices(&full);
    check_indices(&middle);
    check_indices(&low);
}

/* Returns the number of hull faces with the edge from a to b. */
static int edges(const longship_model *m, int a, int b)
{
    int count = 0;
    for (int i = 0; i < m->faces; i++) {
        const face *f = &m->face[i];
        for (int k = 0; f->hull && k < 3; k++)
            count += f->at[k] == a && f->at[(k + 1) % 3] == b;
    }
    return count;
}

static void check_closed(const longship_model *m)
{
    int checked = 0;
    for (int i = 0; i < m->faces; i++) {
        const face *f = &m->face[i];
        for (int k = 0; f->hull && k < 3; k++, checked++) {
            int a = f->at[k], b = f->at[(k + 1) % 3];
            if (edges(m, a, b) != 1 || edges(m, b, a) != 1)
                fail_msg("the edge %d-%d has not two faces of opposite sense", a, b);
        }
    }
    assert_true(checked > 100);
}

static void the_hull_is_watertight(void **state)
{
    (void)state;
    check_closed(&full);
    check_closed(&middle);
    check_closed(&low);
}

/* Two corners at the same position could otherwise count as different corners and hide a
 * crack. */
static void no_position_is_written_twice(void **state)
{
    (void)state;
    for (int i = 0; i < full.ats; i++) {
        for (int j = 0; j < i; j++)
            assert_memory_not_equal(full.at[i], full.at[j], sizeof full.at[0]);
    }
}

static void face_cross(const longship_model *m, const face *f, double cross[3])
{
    const double *a = m->at[f->at[0] - 1], *b = m->at[f->at[1] - 1],
                 *c = m->at[f->at[2] - 1];
    for (int k = 0; k < 3; k++) {
        int p = (k + 1) % 3, q = (k + 2) % 3;
        cross[k] = (b[p] - a[p]) * (c[q] - a[q]) - (b[q] - a[q]) * (c[p] - a[p]);
    }
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Volume by the divergence theorem: negative if the hull were inside out. */
static double hull_volume(const longship_model *m)
{
    double sum = 0.0, cross[3];
    for (int i = 0; i < m->faces; i++) {
        face_cross(m, &m->face[i], cross);
        sum += m->face[i].hull ? dot(cross, m->at[m->face[i].at[0] - 1]) / 6.0 : 0.0;
    }
    return sum;
}

static void the_hull_holds_20_to_40_cubic_metres_right_side_out(void **state)
{
    (void)state;
    print_message("hull %.1f m3, low %.1f m3\n", hull_volume(&full), hull_volume(&low));
    assert_true(hull_volume(&full) > 20.0 && hull_volume(&full) < 40.0);
    assert_true(hull_volume(&middle) > 20.0 && hull_volume(&middle) < 40.0);
    assert_true(hull_volume(&low) > 20.0 && hull_volume(&low) < 40.0);
}

static void check_normals(const longship_model *m)
{
    for (int i = 0; i < m->normals; i++) {
        double length = sqrt(dot(m->normal[i], m->normal[i]));
        assert_true(length > .99 && length < 1.01);
    }
    for (int i = 0; i < m->faces; i++) {
        double cross[3];
        face_cross(m, &m->face[i], cross);
        assert_true(dot(cross, cross) > 0.0);
        for (int k = 0; k < 3; k++) {
            if (dot(cross, m->normal[m->face[i].normal[k] - 1]) <= 0.0)
                fail_msg("face %d: its corner %d looks inward", i, k);
        }
    }
}

static void normals_are_unit_and_look_outward(void **state)
{
    (void)state;
    check_normals(&full);
    check_normals(&middle);
    check_normals(&low);
}

static void bounds(const longship_model *m, bool hull_only, double from[3], double to[3])
{
    for (int k = 0; k < 3; k++) {
        from[k] = 1e9;
        to[k] = -1e9;
    }
    for (int i = 0; i < 3 * m->faces; i++) {
        const face *f = &m->face[i / 3];
        const double *at = m->at[f->at[i % 3] - 1];
        for (int k = 0; k < 3 && (f->hull || !hull_only); k++) {
            from[k] = fmin(from[k], at[k]);
            to[k] = fmax(to[k], at[k]);
        }
    }
}

static void check_size(const longship_model *m)
{
    double from[3], to[3];
    bounds(m, true, from, to);
    assert_true(to[0] - from[0] > 3.9 && to[0] - from[0] < 4.3);
    assert_true(fabs(to[0] + from[0]) < 1e-9 && fabs(to[2] + from[2]) < .2);
    assert_true(from[1] > -.8 && from[1] < -.5 && to[1] > 1.5 && to[1] < 2.5);
    bounds(m, false, from, to);
    print_message("%.2f x %.2f x %.2f m\n", to[0] - from[0], to[1] - from[1],
                  to[2] - from[2]);
    assert_true(to[2] - from[2] > 18.0 && to[2] - from[2] < 22.0);
    assert_true(from[1] > -1.5 && to[1] > 9.0 && to[1] < 11.0);
}

static void the_ship_is_20_metres_long_and_4_wide(void **state)
{
    (void)state;
    check_size(&full);
    check_size(&middle);
    check_size(&low);
}

/* -- materials ----------------------------------------------------------------------- */

static void put_word(const unsigned char *from, uint32_t *to)
{
    *to = (uint32_t)from[0] << 24 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 8
          | from[3];
}

/* Checks the side lengths in the picture's own header. */
static void check_png(const char *folder, const char *name)
{
    char path[256];
    unsigned char head[24];
    uint32_t w, h;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = open_asset(path);
    assert_int_equal(fread(head, 1, sizeof head, file), sizeof head);
    fclose(file);
    assert_int_equal(png_sig_cmp(head, 0, 8), 0);
    put_word(head + 16, &w);
    put_word(head + 20, &h);
    assert_true(w > 0 && w <= 256 && (w & (w - 1)) == 0);
    assert_true(h > 0 && h <= 256 && (h & (h - 1)) == 0);
}

enum { HAS_KD = 1, HAS_KS = 2, HAS_NS = 4, HAS_MAP = 8, HAS_BUMP = 16, HAS_ALL = 15 };

/* Sets bits for each material of `m` from the statements in longship.mtl. */
static void read_library(longship_model *m, int *has)
{
    FILE *file = open_asset("boats/longship.mtl");
    char line[256], word[NAME];
    int at = -1;
    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "newmtl %63s", word) == 1)
            at = material_index(m, word);
        else if (sscanf(line, "map_Kd %63s", word) == 1 && at >= 0)
            has[at] |= HAS_MAP;
        else if (sscanf(line, "map_Bump %63s", word) == 1 && at >= 0)
            has[at] |= HAS_BUMP;
        else if (at >= 0)
            has[at] |= line[0] != '\0' && strchr("KN", line[0]) ? line[0] == 'N' ? HAS_NS
                                                                  : line[1] == 'd'
                                                                      ? HAS_KD
                                                                      : HAS_KS
                                                                : 0;
        if (strncmp(line, "map_", 4) == 0)
            check_png("boats", word);
    }
    fclose(file);
}

static void check_materials(longship_model *m)
{
    int has[MATERIALS] = { 0 }, used = m->materials;
    read_library(m, has);
    for (int i = 0; i < used; i++) {
        const char *name = m->material[i];
        if (strcmp(name, "lid") == 0)       /* never visible */
            continue;
        if ((has[i] & HAS_ALL) != HAS_ALL)
            fail_msg("material %s lacks colour, highlight or picture", name);
        if (strcmp(name, "oak") == 0 || strcmp(name, "deck") == 0
            || strcmp(name, "sail") == 0)
            assert_true(has[i] & HAS_BUMP);
    }
}

static void materials_are_defined_and_their_pictures_exist(void **state)
{
    (void)state;
    check_materials(&full);
    check_materials(&middle);
    check_materials(&low);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_longship_has_1500_to_6000_triangles),
        cmocka_unit_test(the_middle_longship_has_1000_to_1500_triangles),
        cmocka_unit_test(the_small_longship_has_at_most_300_triangles),
        cmocka_unit_test(every_corner_names_what_the_file_holds),
        cmocka_unit_test(the_hull_is_watertight),
        cmocka_unit_test(no_position_is_written_twice),
        cmocka_unit_test(the_hull_holds_20_to_40_cubic_metres_right_side_out),
        cmocka_unit_test(normals_are_unit_and_look_outward),
        cmocka_unit_test(the_ship_is_20_metres_long_and_4_wide),
        cmocka_unit_test(materials_are_defined_and_their_pictures_exist),
    };
    return cmocka_run_group_tests_name("assets/longship", tests, read_models, NULL);
}
