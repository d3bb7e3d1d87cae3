/* SPDX-License-Identifier: MIT */
/* The OBJ statements that name other things: usemtl and mtllib name materials and
 * libraries, f names the vertices of a face. */
#include "base/base.h"
#include "mesh/obj.h"

/* -- usemtl and mtllib --------------------------------------------------------------- */

/* The scan has no memory for names and counts an upper bound.  2 KB hold recent names; a
 * name found there is not counted again, any other name is counted.  The count is exact
 * for files with up to about 200 names of common length, and never too low.  At most
 * TP_OBJ_MATERIALS materials count: further materials found by the load are grey.  Faces
 * before any usemtl use the material "". */

enum { MOST_LIBRARIES = 1 << 20, MOST_ROOM = 1 << 28, SHORT_NAME = 255 };

/* True if the name was seen before among names of its kind, libraries or materials.
 * Otherwise adds the name to the recent names if there is room.  obj->seen holds records of
 * kind + 1, length, bytes; a 0 ends the list. */
static bool was_seen_or_remember(tp_obj *obj, unsigned kind, tp_word name)
{
    char *at = obj->seen, *const end = at + sizeof obj->seen;
    if (name.bytes > SHORT_NAME)
        return false;
    for (; *at != 0; at += 2 + (unsigned char)at[1]) {
        if (at[0] == (char)(kind + 1) && (unsigned char)at[1] == name.bytes
            && memcmp(at + 2, name.text, name.bytes) == 0)
            return true;
    }
    if ((size_t)(end - at) > 2 + name.bytes) {
        at[0] = (char)(kind + 1);
        at[1] = (char)name.bytes;
        memcpy(at + 2, name.text, name.bytes);
        at[2 + name.bytes] = 0;
    }
    return false;
}

/* Counts a name in the scan. */
static tp_status count_name(tp_obj *obj, unsigned kind, tp_word name, tp_error *err)
{
    uint32_t *const most = &obj->name_most[kind], *const room = &obj->name_room[kind];
    if (was_seen_or_remember(obj, kind, name))
        return TP_OK;
    if (kind == TP_NAMES_LIBRARY && (*most == MOST_LIBRARIES || *room >= MOST_ROOM))
        return TP_FAIL(err, TP_E_OBJ_COUNT, obj->lines.first, MOST_LIBRARIES, 0);
    if (kind == TP_NAMES_MATERIAL && name.bytes > obj->name_longest)
        obj->name_longest = name.bytes;
    if (kind == TP_NAMES_LIBRARY || *most < TP_OBJ_MATERIALS)
        ++*most;
    if (*room < MOST_ROOM)                  /* 2^12 names of 2^12 bytes need less */
        *room += name.bytes + 1;
    return TP_OK;
}

static void mix_name_into_digest(tp_obj *obj, tp_word name)
{
    for (uint32_t i = 0; i < name.bytes; i++)
        obj->now.digest = tp_mix(obj->now.digest, (unsigned char)name.text[i]);
}

/* -- materials ----------------------------------------------------------------------- */

static const tp_word nameless = { "", 0 };

/* True if the set has room for the name.  The last place is reserved for the nameless
 * material until the nameless material is added. */
static bool has_room_for_name(const tp_obj *obj, tp_word name)
{
    const tp_obj_names *const names = &obj->store.material_names;
    return name.bytes == 0 || names->count + 1 < names->most
        || tp_names_find(names, nameless, 0, obj->total.digest) != TP_NO_NAME;
}

/* Returns the number of the material; adds the material if needed.  Returns TP_NO_NAME if
 * there is no room. */
static uint32_t find_or_add_material(tp_obj *obj, tp_word name)
{
    tp_obj_names *const names = &obj->store.material_names;
    uint32_t i = tp_names_find(names, name, 0, obj->total.digest);
    if (i != TP_NO_NAME || !has_room_for_name(obj, name))
        return i;
    i = tp_names_find_or_add(names, name, 0, obj->lines.first, obj->total.digest);
    if (i == TP_NO_NAME)
        return TP_NO_NAME;
    obj->store.made[i] = (struct tp_obj_made){ .map = { TP_NO_NAME, TP_NO_NAME } };
    obj->store.materials[i] = (tp_material){
        .diffuse = 0x808080, .shininess = 32 * TP_FX_ONE, .opacity = TP_FX_ONE,
        .bump = TP_FX_ONE };
    return i;
}

/* Handles a name beyond the limit: the faces get the nameless material, and the first case
 * is recorded as a warning. */
static tp_status use_fallback_material(tp_obj *obj, tp_error *err)
{
    if (obj->store.material_names.most < TP_OBJ_MATERIALS)
        return TP_FAIL(err, TP_E_OBJ_CHANGED, obj->lines.first, 0, 0);
    tp_error fault;
    TP_FAIL(&fault, TP_E_OBJ_MATERIALS, obj->lines.first, TP_OBJ_MATERIALS, 0);
    if (!obj->crowded)
        tp_obj_warn(obj, &fault);
    obj->crowded = true;
    obj->material = find_or_add_material(obj, nameless);
    return TP_OK;
}

static tp_status use_material(tp_obj *obj, tp_word name, tp_error *err)
{
    if (obj->stage == TP_STAGE_SCAN)
        return count_name(obj, TP_NAMES_MATERIAL, name, err);
    obj->material = find_or_add_material(obj, name);
    return obj->material == TP_NO_NAME ? use_fallback_material(obj, err) : TP_OK;
}

tp_status tp_obj_usemtl(tp_obj *obj, tp_words *words, tp_error *err)
{
    tp_word name;
    tp_error fault;
    if (tp_obj_read_rest_as_name(obj, words, &name, &fault) != TP_OK) {
        tp_obj_warn(obj, &fault);
        return TP_OK;
    }
    mix_name_into_digest(obj, name);
    return use_material(obj, name, err);
}

static tp_status obj_use_default_material(tp_obj *obj, tp_error *err)
{
    return use_material(obj, nameless, err);
}

/* -- libraries ----------------------------------------------------------------------- */

static tp_status record_library_name(tp_obj *obj, tp_word name, tp_error *err)
{
    mix_name_into_digest(obj, name);
    if (obj->stage == TP_STAGE_SCAN)
        return count_name(obj, TP_NAMES_LIBRARY, name, err);
    if (tp_names_find_or_add(&obj->store.library_names, name, 0, obj->lines.first,
                     obj->total.digest) != TP_NO_NAME)
        return TP_OK;
    return TP_FAIL(err, TP_E_OBJ_CHANGED, obj->lines.first, 0, 0);
}

static bool ends_in_mtl(tp_word word)
{
    if (word.bytes <= 4)
        return false;
    return tp_word_is_any_case((tp_word){ word.text + word.bytes - 4, 4 }, ".mtl");
}

/* Returns the first name of the rest: up to the first word that ends in ".mtl",
 * or the whole rest. */
static tp_words next_library_name(tp_words *words)
{
    const char *const start = words->at;
    tp_word word;
    do
        word = tp_word_next(words);
    while (word.bytes > 0 && !ends_in_mtl(word));
    return (tp_words){ start, words->at };
}

tp_status tp_obj_mtllib(tp_obj *obj, tp_words *words, tp_error *err)
{
    for (;;) {
        tp_words one = next_library_name(words);
        tp_word name;
        tp_error fault;
        if (tp_obj_read_rest_as_name(obj, &one, &name, &fault) != TP_OK) {
            tp_obj_warn(obj, &fault);
            continue;
        }
        const tp_status status =
            name.bytes > 0 ? record_library_name(obj, name, err) : TP_OK;
        if (status != TP_OK || name.bytes == 0)
            return status;
    }
}

/* -- f ------------------------------------------------------------------------------- */

/* Checks the corners of a face, merges equal corners into one vertex, and stores them.
 *
 * A long line may arrive in parts.  The first two corners are held back until a third
 * arrives: faces with fewer corners are only counted, and their indices are not checked.
 *
 * Positive indices count from the start of the file, from 1, and may point ahead.  They
 * are checked in the second pass, where the totals are known.  Negative indices count
 * back from the current statement. */

enum { HAS_TEXCOORD = 1, HAS_NORMAL = 2 };

enum { POSITION, TEXCOORD, NORMAL };            /* order of the indices of a corner */

static bool pass_slash(tp_words *words)
{
    const bool slash = words->at < words->end && *words->at == '/';
    words->at += slash;
    return slash;
}

/* Reads v, v/vt, v//vn or v/vt/vn.  Returns the flags of the indices found, or -1
 * for any other form. */
static int read_corner_form(tp_words *words, int32_t indices[3])
{
    indices[TEXCOORD] = indices[NORMAL] = 0;
    if (!tp_words_read_int_prefix(words, &indices[POSITION]))
        return -1;
    int form = 0;
    if (pass_slash(words)) {
        if (tp_words_read_int_prefix(words, &indices[TEXCOORD]))
            form |= HAS_TEXCOORD;
        if (pass_slash(words) && tp_words_read_int_prefix(words, &indices[NORMAL]))
            form |= HAS_NORMAL;
    }
    return words->at == words->end || tp_is_blank(*words->at) ? form : -1;
}

/* Converts an index of the file, from 1 or negative, to an index from 0. */
static tp_status resolve_index(const tp_obj *obj, int32_t index, uint32_t now,
                               uint32_t total, tp_status code, uint32_t *out,
                               tp_error *err)
{
    if (index == 0)
        return TP_FAIL(err, TP_E_OBJ_ZERO, obj->lines.first, 0, 0);
    if (index < 0) {
        if ((uint32_t)-index > now)
            return TP_FAIL(err, code, obj->lines.first, index, now);
        *out = now - (uint32_t)-index;
        return TP_OK;
    }
    if (obj->stage == TP_STAGE_LOAD && (uint32_t)index > total)
        return TP_FAIL(err, code, obj->lines.first, index, total);
    *out = (uint32_t)index - 1;
    return TP_OK;
}

/* Returns the number of the vertex with these three indices; adds a vertex if needed. */
static uint32_t find_or_add_vertex(tp_obj *obj, uint32_t position, uint32_t texcoord,
                                   uint32_t normal)
{
    tp_obj_memory *const store = &obj->store;
    const uint64_t hash =
        tp_mix(tp_mix(tp_mix(obj->total.digest, position), texcoord), normal);
    uint32_t at = (uint32_t)hash & store->mask;
    for (; store->table[at] != 0; at = (at + 1) & store->mask) {
        const union tp_obj_vertex *vertex = &store->vertices[store->table[at] - 1];
        if (vertex->corner.position == position && vertex->corner.texcoord == texcoord
            && vertex->corner.normal == normal)
            return store->table[at] - 1;
    }
    TP_ASSERT(store->n_vertices < obj->total.corners);
    union tp_obj_vertex *const vertex = &store->vertices[store->n_vertices];
    vertex->corner.position = position;
    vertex->corner.texcoord = texcoord;
    vertex->corner.normal = normal;
    store->table[at] = ++store->n_vertices;
    return store->n_vertices - 1;
}

/* Returns the code of a normal that the file does not give: smoothing group
 * or flat polygon. */
static uint32_t computed_normal_code(const tp_obj *obj)
{
    return obj->group != 0 ? TP_NORMAL_GROUP | obj->group
                           : TP_NORMAL_FLAT | obj->now.polygons;
}

static tp_status commit_corner(tp_obj *obj, const int32_t corner[3], tp_error *err)
{
    const int form = obj->face.form;
    uint32_t position = 0, texcoord = TP_NO_TEXCOORD, normal = computed_normal_code(obj);
    const tp_obj_counts *const now = &obj->now, *const total = &obj->total;
    tp_status status = resolve_index(obj, corner[POSITION], now->vertices, total->vertices,
                               TP_E_OBJ_VERTEX, &position, err);
    if (status == TP_OK && (form & HAS_TEXCOORD))
        status = resolve_index(obj, corner[TEXCOORD], now->texcoords, total->texcoords,
                               TP_E_OBJ_TEXCOORD, &texcoord, err);
    if (status == TP_OK && (form & HAS_NORMAL))
        status = resolve_index(obj, corner[NORMAL], now->normals, total->normals,
                               TP_E_OBJ_NORMAL, &normal, err);
    if (status == TP_OK)
        status = tp_obj_check_room(obj, now->corners, total->corners, 1, err);
    if (status != TP_OK)
        return status;
    obj->now.digest = tp_mix(tp_mix(now->digest, position), texcoord);
    obj->now.digest = tp_mix(now->digest, normal);
    if (obj->stage == TP_STAGE_LOAD)
        obj->store.corners[now->corners] =
            find_or_add_vertex(obj, position, texcoord, normal);
    obj->now.corners++;
    return TP_OK;
}

/* Called when a face's third corner arrives: commits the two corners held until then.  A
 * face in front of all usemtl statements gets the default material. */
static tp_status commit_first_two_corners(tp_obj *obj, tp_error *err)
{
    tp_status status = TP_OK;
    if (obj->material == TP_NO_NAME && obj->stage == TP_STAGE_LOAD)
        status = obj_use_default_material(obj, err);
    for (int i = 0; i < 2 && status == TP_OK; i++)
        status = commit_corner(obj, obj->face.held[i], err);
    return status;
}

static tp_status hold_or_commit_corner(tp_obj *obj, const int32_t corner[3], tp_error *err)
{
    tp_obj_face_state *const face = &obj->face;
    const uint32_t i = face->corners++;
    if (i < 2) {
        for (int k = 0; k < 3; k++)
            face->held[i][k] = corner[k];
        return TP_OK;
    }
    const tp_status status = i == 2 ? commit_first_two_corners(obj, err) : TP_OK;
    return status != TP_OK ? status : commit_corner(obj, corner, err);
}

static tp_status read_corners(tp_obj *obj, tp_words *words, tp_error *err)
{
    tp_obj_face_state *const face = &obj->face;
    while (!tp_words_at_end(words)) {
        tp_words start = *words;
        int32_t corner[3];
        const int form = read_corner_form(words, corner);
        if (form < 0) {
            const tp_word word = tp_word_next(&start);
            TP_FAIL(err, TP_E_OBJ_NUMBER, obj->lines.first, 0, 0);
            tp_error_set_word(err, word.text, word.bytes);
            return TP_E_OBJ_NUMBER;
        }
        if (face->corners > 0 && form != face->form)
            return TP_FAIL(err, TP_E_OBJ_MIXED, obj->lines.first, 0, 0);
        face->form = form;
        const tp_status status = hold_or_commit_corner(obj, corner, err);
        if (status != TP_OK)
            return status;
    }
    face->ended = words->at < words->end;
    return TP_OK;
}

/* Called after the last corner: checks the number of corners and stores the polygon. */
static tp_status end_face(tp_obj *obj, tp_error *err)
{
    tp_obj_counts *const now = &obj->now;
    const uint32_t n = obj->face.corners;
    if (n < 3) {
        obj->short_faces++;
        return TP_OK;
    }
    tp_status status =
        tp_obj_check_room(obj, now->triangles, obj->total.triangles, n - 2, err);
    if (status == TP_OK)
        status = tp_obj_check_room(obj, now->polygons, obj->total.polygons, 1, err);
    if (status != TP_OK)
        return status;
    if (obj->stage == TP_STAGE_LOAD)
        obj->store.polygons[now->polygons] =
            (struct tp_obj_polygon){ obj->material, n };
    now->polygons++;
    now->triangles += n - 2;
    now->largest = n > now->largest ? n : now->largest;
    now->smooth += !(obj->face.form & HAS_NORMAL) && obj->group != 0 ? n : 0;
    return TP_OK;
}

tp_status tp_obj_face(tp_obj *obj, tp_words *words, tp_error *err)
{
    if (!obj->lines.continues)
        obj->face = (tp_obj_face_state){ 0 };
    if (obj->face.ended)
        return obj->lines.goes_on ? TP_OK : end_face(obj, err);
    if (obj->lines.split && !tp_words_at_end(words))
        return tp_obj_fail_long_line(obj, err);
    const tp_status status = read_corners(obj, words, err);
    return status != TP_OK || obj->lines.goes_on ? status : end_face(obj, err);
}
