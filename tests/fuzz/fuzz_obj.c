/* SPDX-License-Identifier: MIT */
/* Fuzzes OBJ files. The first byte sets the size of the pieces in which the rest is fed;
 * each piece is a heap block of its own. An accepted mesh must be consistent. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "mesh/mesh.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define REQUIRE(x) ((x) ? (void)0 : abort())

static tp_status feed(tp_obj *obj, const uint8_t *text, size_t bytes, size_t piece,
                      tp_error *err)
{
    tp_status status = TP_OK;
    for (size_t i = 0; i < bytes && status == TP_OK; i += piece) {
        const size_t n = bytes - i < piece ? bytes - i : piece;
        void *const copy = malloc(n);
        memcpy(copy, text + i, n);
        status = tp_obj_feed(obj, copy, n, err);
        free(copy);
    }
    return status;
}

static bool is_between(tp_vec3 low, tp_vec3 p, tp_vec3 high)
{
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y
        && low.z <= p.z && p.z <= high.z;
}

static void check_warnings(const tp_obj *obj)
{
    for (uint32_t i = 0; i < obj->warnings && i < TP_OBJ_WARNINGS; i++)
        REQUIRE(obj->warning[i].code != TP_OK && obj->warning[i].where > 0);
}

static void check(const tp_obj *obj, const tp_mesh *mesh)
{
    const tp_vec3 most = { 1 << 30, 1 << 30, 1 << 30 };
    const tp_vec3 least = { -most.x, -most.y, -most.z };
    REQUIRE(mesh->n_faces > 0 && mesh->n_vertices > 0 && mesh->n_materials > 0);
    REQUIRE(mesh->log2_unit <= TP_MESH_MAX_LOG2_UNIT);
    REQUIRE(mesh->n_materials <= TP_OBJ_MATERIALS);
    REQUIRE(is_between(least, mesh->low, most) && is_between(least, mesh->high, most));
    REQUIRE(tp_obj_finished_mesh_bytes(obj) <= tp_obj_memory_bytes(obj));
    for (uint32_t i = 0; i < mesh->n_faces; i++) {
        for (int k = 0; k < 3; k++)
            REQUIRE(mesh->faces[i].vertex[k] < mesh->n_vertices);
        REQUIRE(mesh->faces[i].material < mesh->n_materials);
    }
    for (uint32_t i = 0; i < mesh->n_vertices; i++)
        REQUIRE(is_between(mesh->low, mesh->vertices[i].position, mesh->high));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static tp_obj obj;
    if (size == 0)
        return 0;
    const size_t piece = data[0] < 64 ? data[0] + 1u : 1u << 20;
    const uint8_t *const text = data + 1;
    tp_error err = { .code = TP_OK };
    tp_obj_begin_count(&obj);
    tp_status status = feed(&obj, text, size - 1, piece, &err);
    if (status == TP_OK)
        status = tp_obj_end_count(&obj, &err);
    void *mem = NULL;
    if (status == TP_OK) {
        mem = malloc(tp_obj_memory_bytes(&obj));
        REQUIRE(mem != NULL);
        memset(mem, 0xA5, tp_obj_memory_bytes(&obj));
        tp_obj_begin_load(&obj, mem);
        status = feed(&obj, text, size - 1, piece, &err);
    }
    if (status == TP_OK)
        status = tp_obj_end_load(&obj, &err);
    if (status == TP_OK)
        check_warnings(&obj);
    tp_mesh mesh;
    if (status == TP_OK)
        status = tp_obj_finish(&obj, NULL, &mesh, &err);
    if (status == TP_OK)
        check(&obj, &mesh);
    else
        REQUIRE(err.code == status && err.where > 0 && status != TP_E_OBJ_CHANGED
                && status != TP_E_ARG && status != TP_E_NOSPACE);
    free(mem);
    return 0;
}
