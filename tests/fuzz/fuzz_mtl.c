/* SPDX-License-Identifier: MIT */
/* Fuzzes MTL files, read as the two libraries of a small OBJ. The first byte sets the size
 * of the pieces in which the rest is fed. Nothing in an MTL is an error, and each warning
 * has its line. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "mesh/mesh.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define REQUIRE(x) ((x) ? (void)0 : abort())

static const char obj_text[] =
    "mtllib a.mtl b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
    "usemtl a\nf 1/1 2/2 3/3\nusemtl oak wood\nf 1 2 3\nusemtl c\nf 1 3 2\n";

static void *load(tp_obj *obj)
{
    tp_obj_begin_count(obj);
    REQUIRE(tp_obj_feed(obj, obj_text, sizeof obj_text - 1, NULL) == TP_OK);
    REQUIRE(tp_obj_end_count(obj, NULL) == TP_OK);
    void *const mem = malloc(tp_obj_memory_bytes(obj));
    REQUIRE(mem != NULL);
    memset(mem, 0xA5, tp_obj_memory_bytes(obj));
    tp_obj_begin_load(obj, mem);
    REQUIRE(tp_obj_feed(obj, obj_text, sizeof obj_text - 1, NULL) == TP_OK);
    REQUIRE(tp_obj_end_load(obj, NULL) == TP_OK);
    return mem;
}

static tp_status read_library(tp_obj *obj, uint32_t library, const uint8_t *text,
                              size_t bytes, size_t piece, tp_error *err)
{
    tp_status status = TP_OK;
    tp_mtl_begin(obj, library);
    for (size_t i = 0; i < bytes && status == TP_OK; i += piece) {
        const size_t n = bytes - i < piece ? bytes - i : piece;
        void *const copy = malloc(n);
        memcpy(copy, text + i, n);
        status = tp_mtl_feed(obj, copy, n, err);
        free(copy);
    }
    return status != TP_OK ? status : tp_mtl_end(obj, err);
}

static void check_warnings(const tp_obj *obj)
{
    for (uint32_t i = 0; i < obj->warnings && i < TP_OBJ_WARNINGS; i++) {
        const tp_error *const warning = &obj->warning[i];
        REQUIRE(warning->code != TP_OK && warning->where > 0);
        REQUIRE(memchr(warning->word, 0, sizeof warning->word) != NULL);
    }
}

static void check(const tp_obj *obj, const tp_mesh *mesh)
{
    REQUIRE(mesh->n_materials == 3 && obj->images <= 6);
    for (uint32_t i = 0; i < obj->images; i++) {
        REQUIRE(strlen(tp_obj_image(obj, i)) < TP_OBJ_LINE_BYTES);
        REQUIRE(tp_obj_image_library(obj, i) < obj->libraries);
        REQUIRE(tp_obj_image_line(obj, i) > 0);
    }
    for (uint32_t i = 0; i < 3; i++) {
        const tp_material *const m = &mesh->materials[i];
        REQUIRE(m->diffuse <= 0xffffff && m->specular <= 0xffffff);
        REQUIRE(m->opacity >= 0 && m->opacity <= TP_FX_ONE);
        REQUIRE(m->shininess >= TP_FX_ONE && m->shininess <= 1000 * TP_FX_ONE);
        REQUIRE(m->bump >= -16 * TP_FX_ONE && m->bump <= 16 * TP_FX_ONE);
        REQUIRE(m->diffuse_map == NULL || m->texels >= 0);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static tp_obj obj;
    static const tp_texture texture = { .log2_w = 9, .log2_h = 7, .levels = 10 };
    static const tp_texture *const textures[] = { &texture, NULL, &texture, NULL,
                                                  &texture, &texture };
    if (size == 0)
        return 0;
    const size_t piece = data[0] < 64 ? data[0] + 1u : 1u << 20, half = size / 2;
    void *const mem = load(&obj);
    REQUIRE(read_library(&obj, 0, data + 1, half, piece, NULL) == TP_OK);
    check_warnings(&obj);
    REQUIRE(read_library(&obj, 1, data + 1 + half, size - 1 - half, piece, NULL) == TP_OK);
    check_warnings(&obj);
    tp_mesh mesh;
    REQUIRE(tp_obj_finish(&obj, textures, &mesh, NULL) == TP_OK);
    check_warnings(&obj);
    check(&obj, &mesh);
    free(mem);
    return 0;
}
