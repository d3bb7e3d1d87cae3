/* SPDX-License-Identifier: MIT */
/* Memory of the OBJ reader, in the caller's block: sets of names of a number counted
 * beforehand, and the layout of the block. */
#include "base/base.h"
#include "mesh/obj.h"

/* -- sets of names ------------------------------------------------------------------- */

/* Allocates a set: room for `max_names` names of `text_bytes` bytes in total, terminators
 * included.  A set is a hash table with open addressing, at most two thirds full.  The
 * hash begins with the digest of the file: nobody can choose names that collide. */
static void layout_names(tp_obj_names *names, tp_arena *arena, uint32_t max_names,
                         uint32_t text_bytes)
{
    names->most = max_names;
    names->room = text_bytes;
    names->mask = tp_hash_table_size(max_names) - 1;
    names->start = tp_arena_alloc(arena, max_names, sizeof *names->start);
    names->tag = tp_arena_alloc(arena, max_names, sizeof *names->tag);
    names->line = tp_arena_alloc(arena, max_names, sizeof *names->line);
    names->table = tp_arena_alloc(arena, (size_t)names->mask + 1, sizeof *names->table);
    names->text = tp_arena_alloc(arena, text_bytes, 1);
}

void tp_names_clear(tp_obj_names *names)
{
    names->count = names->used = 0;
    memset(names->table, 0, ((size_t)names->mask + 1) * sizeof *names->table);
}

static bool is_same_name(const tp_obj_names *names, uint32_t i, tp_word word, uint32_t tag)
{
    const char *const text = tp_names_text(names, i);
    const uint32_t next = i + 1 < names->count ? names->start[i + 1] : names->used;
    return names->tag[i] == tag && next - names->start[i] == word.bytes + 1
        && memcmp(text, word.text, word.bytes) == 0;
}

/* Returns the slot of the table with the name, or the free slot for the name. */
static uint32_t *find_slot(const tp_obj_names *names, tp_word word, uint32_t tag,
                           uint64_t seed)
{
    uint64_t hash = tp_mix(seed, tag);
    for (uint32_t i = 0; i < word.bytes; i++)
        hash = tp_mix(hash, (unsigned char)word.text[i]);
    uint32_t at = (uint32_t)hash & names->mask;
    while (names->table[at] != 0 && !is_same_name(names, names->table[at] - 1, word, tag))
        at = (at + 1) & names->mask;
    return &names->table[at];
}

uint32_t tp_names_find(const tp_obj_names *names, tp_word word, uint32_t tag,
                       uint64_t seed)
{
    const uint32_t number = *find_slot(names, word, tag, seed);
    return number != 0 ? number - 1 : TP_NO_NAME;
}

uint32_t tp_names_find_or_add(tp_obj_names *names, tp_word word, uint32_t tag,
                              uint32_t line, uint64_t seed)
{
    TP_ASSERT(names->used <= names->room && names->count <= names->most);
    uint32_t *const place = find_slot(names, word, tag, seed);
    if (*place != 0)
        return *place - 1;
    if (names->count == names->most || word.bytes >= names->room - names->used)
        return TP_NO_NAME;
    const uint32_t i = names->count++;
    names->start[i] = names->used;
    names->tag[i] = tag;
    names->line[i] = line;
    memcpy(names->text + names->used, word.text, word.bytes);
    names->text[names->used + word.bytes] = '\0';
    names->used += word.bytes + 1;
    *place = i + 1;
    return i;
}

/* -- layout of the block ------------------------------------------------------------- */

/* Layout of the caller's block.
 *
 *     materials, faces, vertices | what binding needs | positions ... table
 *     kept for the mesh            names, made          while loading, then: images
 *
 * Vertices end the part that is kept, because their number is known only after the whole
 * file is read.  The image names of the materials reuse the memory of the loading
 * tables. */

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
    store->mask      = tp_hash_table_size(total->corners) - 1;
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
    layout_names(&store->material_names, arena, materials, material_name_bytes(obj));
    layout_names(&store->library_names, arena, obj->name_most[TP_NAMES_LIBRARY],
                 obj->name_room[TP_NAMES_LIBRARY]);

    tp_arena later = *arena;
    layout_loading(store, total, arena);
    const uint32_t images = TP_MAPS * materials;        /* <= 2^13 of 2^8 bytes */
    layout_names(&store->image_names, &later, images,
                 images * IMAGE_NAME + TP_OBJ_LINE_BYTES);
    arena->failed = arena->failed || later.failed;
    if (later.used > arena->used)
        arena->used = later.used;
}
