/* SPDX-License-Identifier: MIT */
/* Layout of the caller's block.
 *
 *     materials, faces, vertices | what binding needs | positions ... table
 *     kept for the mesh            names, made          while loading, then: images
 *
 * Vertices end the part that is kept, because their number is known only after the whole
 * file is read.  The image names of the materials reuse the memory of the loading
 * tables. */
#include "asset/obj.h"
#include "asset/cut.h"
#include "asset/table.h"

/* Bytes for image names: IMAGE_NAME for each possible image, plus one name of any length.
 * The names share these bytes: some names may be longer. */
enum { IMAGE_NAME = 256 };

static void layout_loading(tp_obj_memory *store, const tp_obj_counts *total,
                           tp_arena *arena)
{
    store->positions = tp_arena_alloc(arena, total->vertices, sizeof *store->positions);
    store->texcoords = tp_arena_alloc(arena, total->texcoords, sizeof *store->texcoords);
    store->normals   = tp_arena_alloc(arena, total->normals, sizeof *store->normals);
    store->corners   = tp_arena_alloc(arena, total->corners, sizeof *store->corners);
    store->polygons  = tp_arena_alloc(arena, total->polygons, sizeof *store->polygons);
    store->slots     = tp_arena_alloc(arena, total->smooth, sizeof *store->slots);
    store->mask      = tp_table_size(total->corners) - 1;
    store->table     = tp_arena_alloc(arena, (size_t)store->mask + 1,
                                     sizeof *store->table);
    store->cut       = tp_cut_layout(arena, total->largest);
}

/* Returns the bytes for material names.  The scan counts at most TP_OBJ_MATERIALS names,
 * but the bytes of all names. */
static uint32_t material_name_bytes(const tp_obj *obj)
{
    const uint32_t counted = obj->name_room[TP_NAMES_MATERIAL];
    const uint32_t most = obj->name_most[TP_NAMES_MATERIAL] * (obj->name_longest + 1);
    return counted < most ? counted : most;     /* <= 2^12 x 2^12 */
}

void tp_obj_layout(tp_obj *obj, tp_arena *arena)
{
    tp_obj_memory *const store = &obj->store;
    const tp_obj_counts *const total = &obj->total;
    const uint32_t materials = obj->name_most[TP_NAMES_MATERIAL];

    store->materials = tp_arena_alloc(arena, materials, sizeof *store->materials);
    store->faces     = tp_arena_alloc(arena, total->triangles, sizeof *store->faces);
    store->vertices  = tp_arena_alloc(arena, total->corners, sizeof *store->vertices);
    store->made      = tp_arena_alloc(arena, materials, sizeof *store->made);
    tp_names_layout(&store->material_names, arena, materials, material_name_bytes(obj));
    tp_names_layout(&store->library_names, arena, obj->name_most[TP_NAMES_LIBRARY],
                    obj->name_room[TP_NAMES_LIBRARY]);

    tp_arena later = *arena;
    layout_loading(store, total, arena);
    const uint32_t images = TP_MAPS * materials;        /* <= 2^13 of 2^8 bytes */
    tp_names_layout(&store->image_names, &later, images,
                    images * IMAGE_NAME + TP_OBJ_LINE_BYTES);
    arena->failed = arena->failed || later.failed;
    if (later.used > arena->used)
        arena->used = later.used;
}
