/* SPDX-License-Identifier: MIT */
/* Damaged files: for any bytes the reader returns a valid mesh or an error with its line,
 * and the same result for any split of the bytes. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "mesh/mesh.h"
#include "tests/lib/meshes.h"

static const char obj_text[] =
    "# a little of everything\r\n"
    "mtllib all.mtl\n"
    "o thing\n"
    "v 0 0 0\n"
    "v 1.5 0 -2e-1 1.0\n"
    "v 1.5 1 0 0.1 0.2 0.3\n"
    "v 0.5 0.5 .125\n"
    "v 0 1 0\n"
    "vt 0 0\nvt 1 0 0\nvt 1 1\n"
    "vn 0 0 1\nvn 0 0.6 0.8\n"
    "usemtl Oak wood\n"
    "s 1\n"
    "f 1 2 3 \\\n 4 5\n"
    "s off\n"
    "f 1/1 2/2 3/3\n"
    "\n"
    "usemtl Sail\n"
    "f -5//1 -4//2 -3//1\n"
    "f 1/1/1 2/2/2 5/3/2\n"
    "curv 1 2\n";

static const char mtl_text[] =
    "newmtl Oak wood\n"
    "Kd 0.5 0.25 0.125\nKs 0.1 0.1 0.1\nNs 60\nd 0.75\n"
    "map_Kd -s 1 1 1 -o 0 0 oak planks.png\n"
    "map_Bump -bm 0.5 -clamp on oak normal.png\n"
    "\n"
    "newmtl Sail\r\n"
    "Kd 1 1 1\nTr 0.1\nillum 2\nnorm sail.png";

#define TRIANGLE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

enum { OBJ_BYTES = sizeof obj_text - 1, MTL_BYTES = sizeof mtl_text - 1 };

static void assert_unit(tp_packed_dir n)
{
    const int32_t x = tp_dir_x(n), y = tp_dir_y(n), z = tp_dir_z(n);
    assert_in_range(x * x + y * y + z * z, 509 * 509, 513 * 513);
}

static void assert_sound(const obj_reader *r)
{
    const tp_mesh *const mesh = &r->mesh;
    assert_true(mesh->n_faces > 0 && mesh->n_vertices >= 3 && mesh->n_materials > 0);
    for (uint32_t i = 0; i < mesh->n_faces; i++) {
        const tp_mesh_face *const face = &mesh->faces[i];
        for (int k = 0; k < 3; k++)
            assert_true(face->vertex[k] < mesh->n_vertices);
        assert_true(face->material < mesh->n_materials);
        assert_unit(face->tangent);
    }
    for (uint32_t i = 0; i < mesh->n_vertices; i++) {
        const tp_vec3 p = mesh->vertices[i].position;
        assert_true(mesh->low.x <= p.x && p.x <= mesh->high.x);
        assert_true(mesh->low.y <= p.y && p.y <= mesh->high.y);
        assert_true(mesh->low.z <= p.z && p.z <= mesh->high.z);
        assert_unit(mesh->vertices[i].normal);
    }
    assert_true(tp_obj_finished_mesh_bytes(&r->obj) <= tp_obj_memory_bytes(&r->obj));
    assert_true((const char *)(mesh->vertices + mesh->n_vertices)
                == (const char *)r->mem + tp_obj_finished_mesh_bytes(&r->obj));
}

/* Asserts that two readings of the same bytes have equal results. */
static void assert_alike(const obj_reader *a, const obj_reader *b)
{
    const tp_mesh *const m = &a->mesh, *const n = &b->mesh;
    assert_int_equal(m->n_vertices, n->n_vertices);
    assert_int_equal(m->n_faces, n->n_faces);
    assert_memory_equal(m->vertices, n->vertices, m->n_vertices * sizeof *m->vertices);
    assert_memory_equal(m->faces, n->faces, m->n_faces * sizeof *m->faces);
    for (uint32_t i = 0; i < m->n_materials; i++) {
        assert_int_equal(m->materials[i].diffuse, n->materials[i].diffuse);
        assert_int_equal(m->materials[i].opacity, n->materials[i].opacity);
        assert_int_equal(m->materials[i].bump, n->materials[i].bump);
    }
    assert_int_equal(a->obj.images, b->obj.images);
    assert_int_equal(a->obj.skipped, b->obj.skipped);
    assert_int_equal(a->obj.short_faces, b->obj.short_faces);
    assert_int_equal(a->obj.far_texcoords, b->obj.far_texcoords);
    assert_int_equal(a->warnings, b->warnings);
}

static void assert_same_error(const tp_error *a, const tp_error *b)
{
    assert_int_equal(a->where, b->where);
    assert_int_equal(a->a, b->a);
    assert_int_equal(a->b, b->b);
    assert_string_equal(a->word, b->word);
    assert_int_equal(a->line, b->line);         /* the same check failed */
}

typedef enum { GOOD, WARNED, BAD, OUTCOMES } outcome;

/* Reads both texts whole and in pieces and asserts equal results; returns the outcome. */
static outcome read_both_ways(const char *obj, size_t bytes, const char *mtl,
                              size_t mtl_bytes, size_t piece)
{
    obj_reader whole, pieces;
    const tp_status status = read_bytes(&whole, obj, bytes, mtl, mtl_bytes, 1u << 20);
    assert_int_equal(read_bytes(&pieces, obj, bytes, mtl, mtl_bytes, piece), status);
    if (status == TP_OK) {
        assert_sound(&whole);
        assert_alike(&whole, &pieces);
        if (whole.warnings > 0) {
            assert_true(whole.warned.where >= 1 && whole.warned.where <= 40);
            assert_same_error(&whole.warned, &pieces.warned);
        }
    } else {
        assert_int_equal(whole.err.code, status);
        assert_true(whole.err.where >= 1 && whole.err.where <= 40);
        assert_same_error(&whole.err, &pieces.err);
    }
    finish(&whole);
    finish(&pieces);
    return status != TP_OK ? BAD : whole.warnings > 0 ? WARNED : GOOD;
}

static void the_file_is_good_as_it_stands(void **state)
{
    (void)state;
    static const size_t piece[] = { 1, 2, 3, 7, 64, 4096 };
    for (size_t i = 0; i < sizeof piece / sizeof *piece; i++)
        assert_int_equal(read_both_ways(obj_text, OBJ_BYTES, mtl_text, MTL_BYTES,
                                        piece[i]), GOOD);
    obj_reader r;
    assert_int_equal(read_text(&r, obj_text, mtl_text), TP_OK);
    assert_int_equal(r.mesh.n_faces, 6);
    assert_int_equal(r.mesh.n_materials, 2);
    assert_int_equal(r.obj.images, 3);
    finish(&r);
}

static void an_obj_cut_off_at_any_byte_is_good_or_located(void **state)
{
    (void)state;
    int count[OUTCOMES] = { 0 };
    for (size_t n = 0; n <= OBJ_BYTES; n++)
        count[read_both_ways(obj_text, n, mtl_text, MTL_BYTES, n % 3 == 0 ? 1 : 7)]++;
    assert_true(count[GOOD] > 20 && count[BAD] > 200);  /* most lack the line's rest */
}

static void an_mtl_cut_off_at_any_byte_is_good_or_warned_of(void **state)
{
    (void)state;
    int count[OUTCOMES] = { 0 };
    for (size_t n = 0; n <= MTL_BYTES; n++)
        count[read_both_ways(obj_text, OBJ_BYTES, mtl_text, n, 1 + n % 9)]++;
    assert_true(count[GOOD] > 30 && count[WARNED] > 100 && count[BAD] == 0);
}

static void any_bit_of_an_obj_may_flip(void **state)
{
    (void)state;
    char text[OBJ_BYTES];
    memcpy(text, obj_text, OBJ_BYTES);
    for (size_t bit = 0; bit < 8 * OBJ_BYTES; bit++) {
        text[bit / 8] = (char)(text[bit / 8] ^ 1 << bit % 8);
        read_both_ways(text, OBJ_BYTES, mtl_text, MTL_BYTES, 7);
        text[bit / 8] = obj_text[bit / 8];
    }
}

static void any_bit_of_an_mtl_may_flip(void **state)
{
    (void)state;
    char text[MTL_BYTES];
    memcpy(text, mtl_text, MTL_BYTES);
    for (size_t bit = 0; bit < 8 * MTL_BYTES; bit++) {
        text[bit / 8] = (char)(text[bit / 8] ^ 1 << bit % 8);
        assert_true(read_both_ways(obj_text, OBJ_BYTES, text, MTL_BYTES, 7) != BAD);
        text[bit / 8] = mtl_text[bit / 8];
    }
}

static void nul_bytes_anywhere_are_survived(void **state)
{
    (void)state;
    char text[OBJ_BYTES];
    for (size_t i = 0; i < OBJ_BYTES; i++) {
        memcpy(text, obj_text, OBJ_BYTES);
        memset(text + i, 0, i % 5 + 1 > OBJ_BYTES - i ? OBJ_BYTES - i : i % 5 + 1);
        read_both_ways(text, OBJ_BYTES, mtl_text, MTL_BYTES, 4096);
    }
}

/* Lines of the format, at random mixed with fragments and extreme numbers. */
static size_t random_file(char *text, size_t room, uint64_t *random)
{
    static const char *const lines[] = {
        "v 1 2 3\n", "v 5 0 1\n", "v 0 7 1\r\n", "f 1 2 3\n", "f -1 -2 -3\n",
        "f 1 2 3 -1\n", "s 3\n", "s off\n", "vt .5 .5\n", "vn 0 1 0\n",
        "f 1/1/1 2/1/1 3/-1/-1\n", "usemtl a\n", "mtllib a.mtl b.mtl\n", "f 3//1 \\\n" };
    static const char *const scraps[] = {
        "v", "vt", "vn", "f", "s", "usemtl", "mtllib", "g", "\n", "\r", "\\\n", "\t", "/",
        "//", "-1", "1", "2", "3", "0", "-2147483648", "4294967296", "1e9", "1e-9", ".5",
        "-16383.9", "x y", "#", "off", "f 1 2\n", "vt 9e9", "20000" };
    size_t n = (size_t)sprintf(text, TRIANGLE "vt 0 0\nvn 0 0 1\nf 1 2 3\n");
    for (;;) {
        const uint32_t i = next_random(random);
        const char *const word = next_random(random) % 64 == 0
            ? scraps[i % (sizeof scraps / sizeof *scraps)]
            : lines[i % (sizeof lines / sizeof *lines)];
        if (n + strlen(word) + 2 > room || next_random(random) % 64 == 0)
            return n;
        n += (size_t)sprintf(text + n, "%s ", word);
    }
}

static void random_words_are_good_or_located(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    int good = 0;
    for (int i = 0; i < 4000; i++) {
        char text[1500];
        const size_t n = random_file(text, sizeof text, &random);
        obj_reader whole, pieces;
        const tp_status status = read_bytes(&whole, text, n, NULL, 0, 4096);
        const size_t piece = 1 + next_random(&random) % 9;
        assert_int_equal(read_bytes(&pieces, text, n, NULL, 0, piece), status);
        if (status == TP_OK)
            assert_sound(&whole);
        else
            assert_same_error(&whole.err, &pieces.err);
        good += status == TP_OK;
        finish(&whole);
        finish(&pieces);
    }
    assert_in_range(good, 500, 3500);   /* both outcomes occurred many times */
}

/* -- a file that changes between the two passes ----------------------------------- */

static tp_status read_two(const char *first, size_t first_bytes, const char *second,
                          size_t second_bytes)
{
    obj_reader r;
    tp_status status = scan_text(&r, first, first_bytes, 4096);
    if (status == TP_OK)
        status = load_text(&r, second, second_bytes, 4096);
    else
        status = TP_E_ARG;
    finish(&r);
    return status;
}

static void a_file_that_changed_is_refused(void **state)
{
    (void)state;
    static const char first[] = TRIANGLE "vt 0 0\nvn 0 0 1\nusemtl a\ns 1\nf 1 2 3\n";
    static const char *const second[] = {
        TRIANGLE "vt 0 0\nvn 0 0 1\nusemtl a\ns 1\nf 1 3 2\n",
        TRIANGLE "vt 0 0\nvn 0 0 1\nusemtl a\ns 2\nf 1 2 3\n",
        TRIANGLE "vt 0 0\nvn 0 0 1\nusemtl b\ns 1\nf 1 2 3\n",
        TRIANGLE "vt 0 0\nvn 0 0 2\nusemtl a\ns 1\nf 1 2 3\n",
        TRIANGLE "vt 0 0\nvn 0 0 1\nusemtl a\ns 1\nf 1 2 3\n ",
        TRIANGLE "vt 0 0\nvn 0 0 1\nusemtl a\ns 1\nf 1 2 3 1",
        TRIANGLE "vt 0 0\nvn 0 0 1\nusemtl a\ns 1\nf 1 2 3\nf 1 2 3\n",
        TRIANGLE TRIANGLE "vt 0 0\nvn 0 0 1\nusemtl a\ns 1\nf 1 2 3\n",
        TRIANGLE "vt 0 0\nvt 0 0\nvn 0 0 1\nusemtl a\ns 1\nf 1 2 3\n",
        TRIANGLE "vt 0 0\nvn 0 0 1\nvn 0 0 1\nusemtl a\ns 1\nf 1 2 3\n",
        TRIANGLE "usemtl a\nusemtl b\nusemtl c\nusemtl d\n",
        TRIANGLE "mtllib a very long name that nobody counted\n",
        TRIANGLE, "",
    };
    assert_int_equal(read_two(first, sizeof first - 1, first, sizeof first - 1), TP_OK);
    for (size_t i = 0; i < sizeof second / sizeof *second; i++)
        assert_int_equal(read_two(first, sizeof first - 1, second[i], strlen(second[i])),
                         TP_E_OBJ_CHANGED);
}

static void any_other_file_in_the_second_pass_is_refused(void **state)
{
    uint64_t random = *(const uint64_t *)*state;
    int tried = 0;
    for (int i = 0; i < 20000 && tried < 2000; i++) {
        char first[1500], second[1500];
        const size_t m = random_file(first, sizeof first, &random);
        size_t n = random_file(second, sizeof second, &random);
        if (i % 2 == 0 && m < sizeof second) {  /* the same file with another end */
            memmove(second + m / 2, second, n = n < m / 2 ? n : m / 2);
            memcpy(second, first, m / 2);
            n += m / 2;
        }
        if (n == m && memcmp(first, second, n) == 0)
            continue;
        const tp_status status = read_two(first, m, second, n);
        tried += status != TP_E_ARG;
        if (status == TP_OK)                    /* the same numbers in another notation */
            assert_int_equal(n, m);
    }
    assert_true(tried > 100);
}

static void only_a_scan_that_ended_well_asks_for_memory(void **state)
{
    (void)state;
    const char good[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", bad[] = "v 0 0 zero\n";
    obj_reader r;
    assert_int_equal(scan_text(&r, bad, strlen(bad), 4096), TP_E_OBJ_NUMBER);
    assert_int_equal(tp_obj_memory_bytes(&r.obj), 0);
    assert_int_equal(scan_text(&r, good, strlen(good), 4096), TP_OK);
    assert_true(tp_obj_memory_bytes(&r.obj) > 0);
    tp_obj_begin_count(&r.obj);
    assert_int_equal(tp_obj_memory_bytes(&r.obj), 0);
}

int main(void)
{
    static uint64_t seed;
    seed = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_file_is_good_as_it_stands),
        cmocka_unit_test(an_obj_cut_off_at_any_byte_is_good_or_located),
        cmocka_unit_test(an_mtl_cut_off_at_any_byte_is_good_or_warned_of),
        cmocka_unit_test(any_bit_of_an_obj_may_flip),
        cmocka_unit_test(any_bit_of_an_mtl_may_flip),
        cmocka_unit_test(nul_bytes_anywhere_are_survived),
        cmocka_unit_test_prestate(random_words_are_good_or_located, &seed),
        cmocka_unit_test(a_file_that_changed_is_refused),
        cmocka_unit_test(only_a_scan_that_ended_well_asks_for_memory),
        cmocka_unit_test_prestate(any_other_file_in_the_second_pass_is_refused, &seed),
    };
    return cmocka_run_group_tests_name("mesh/hostile", tests, NULL, NULL);
}
