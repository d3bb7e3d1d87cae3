/* SPDX-License-Identifier: MIT */
/* How the caller's block is laid out.
 *
 *     materials, faces, vertices | what binding needs | positions ... table
 *     kept for the mesh            names, made          while loading, then: images
 *
 * Vertices end the part that is kept, since how many differ is known only when all are
 * read.  The images that the materials name take the place of the tables of loading. */
#include "asset/obj.h"
#include "asset/table.h"

static void carve_loading(tp_obj_store *store, const tp_obj_counts *total,
                          tp_arena *arena)
{
    store->positions = tp_arena_take(arena, total->vertices, sizeof *store->positions);
    store->texcoords = tp_arena_take(arena, total->texcoords, sizeof *store->texcoords);
    store->normals   = tp_arena_take(arena, total->normals, sizeof *store->normals);
    store->corners   = tp_arena_take(arena, total->corners, sizeof *store->corners);
    store->polygons  = tp_arena_take(arena, total->polygons, sizeof *store->polygons);
    store->slots     = tp_arena_take(arena, total->smooth, sizeof *store->slots);
    store->mask      = tp_table_size(total->corners) - 1;
    store->table     = tp_arena_take(arena, (size_t)store->mask + 1,
                                     sizeof *store->table);
}

void tp_obj_carve(tp_obj *obj, tp_arena *arena)
{
    tp_obj_store *const store = &obj->store;
    const tp_obj_counts *const total = &obj->total;
    const uint32_t *const most = obj->name_most, *const room = obj->name_room;
    const uint32_t materials = most[TP_NAMES_MATERIAL];

    store->materials = tp_arena_take(arena, materials, sizeof *store->materials);
    store->faces     = tp_arena_take(arena, total->triangles, sizeof *store->faces);
    store->vertices  = tp_arena_take(arena, total->corners, sizeof *store->vertices);
    store->made      = tp_arena_take(arena, materials, sizeof *store->made);
    tp_names_carve(&store->material_names, arena, materials, room[TP_NAMES_MATERIAL]);
    tp_names_carve(&store->library_names, arena, most[TP_NAMES_LIBRARY],
                   room[TP_NAMES_LIBRARY]);

    tp_arena later = *arena;
    carve_loading(store, total, arena);
    const uint32_t images = TP_MAPS * materials;        /* <= 2^21 of 2^8 bytes */
    tp_names_carve(&store->image_names, &later, images, images * (TP_OBJ_NAME_BYTES + 1));
    arena->failed = arena->failed || later.failed;
    if (later.used > arena->used)
        arena->used = later.used;
}
