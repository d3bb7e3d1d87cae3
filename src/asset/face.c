/* SPDX-License-Identifier: MIT */
/* The OBJ statement f: checks the corners, merges equal corners into one vertex,
 * and stores them.
 *
 * A long line may arrive in parts.  The first two corners are held back until a third
 * arrives: faces with fewer corners are only counted, and their indices are not checked.
 *
 * Positive indices count from the start of the file, from 1, and may point ahead.  They are
 * checked in the second pass, where the totals are known.  Negative indices count back from
 * the current statement. */
#include "asset/obj.h"
#include "asset/table.h"
#include "base/fail.h"

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
static int read_corner(tp_words *words, int32_t corner[3])
{
    corner[TEXCOORD] = corner[NORMAL] = 0;
    if (!tp_word_int(words, &corner[POSITION]))
        return -1;
    int form = 0;
    if (pass_slash(words)) {
        if (tp_word_int(words, &corner[TEXCOORD]))
            form |= HAS_TEXCOORD;
        if (pass_slash(words) && tp_word_int(words, &corner[NORMAL]))
            form |= HAS_NORMAL;
    }
    return words->at == words->end || tp_is_blank(*words->at) ? form : -1;
}

/* Converts an index of the file, from 1 or negative, to an index from 0. */
static tp_status resolve(const tp_obj *obj, int32_t index, uint32_t now, uint32_t total,
                         tp_status code, uint32_t *out, tp_error *err)
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
    tp_status status = resolve(obj, corner[POSITION], now->vertices, total->vertices,
                               TP_E_OBJ_VERTEX, &position, err);
    if (status == TP_OK && (form & HAS_TEXCOORD))
        status = resolve(obj, corner[TEXCOORD], now->texcoords, total->texcoords,
                         TP_E_OBJ_TEXCOORD, &texcoord, err);
    if (status == TP_OK && (form & HAS_NORMAL))
        status = resolve(obj, corner[NORMAL], now->normals, total->normals,
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

/* Called when a third corner arrives: counts the first two corners, and makes sure that the
 * face has a material. */
static tp_status commit_held_corners(tp_obj *obj, tp_error *err)
{
    tp_status status = TP_OK;
    if (obj->material == TP_NO_NAME && obj->stage == TP_STAGE_LOAD)
        status = tp_obj_use_default_material(obj, err);
    for (int i = 0; i < 2 && status == TP_OK; i++)
        status = commit_corner(obj, obj->face.held[i], err);
    return status;
}

static tp_status add_corner(tp_obj *obj, const int32_t corner[3], tp_error *err)
{
    tp_obj_face_state *const face = &obj->face;
    const uint32_t i = face->corners++;
    if (i < 2) {
        for (int k = 0; k < 3; k++)
            face->held[i][k] = corner[k];
        return TP_OK;
    }
    const tp_status status = i == 2 ? commit_held_corners(obj, err) : TP_OK;
    return status != TP_OK ? status : commit_corner(obj, corner, err);
}

static tp_status read_corners(tp_obj *obj, tp_words *words, tp_error *err)
{
    tp_obj_face_state *const face = &obj->face;
    while (!tp_words_at_end(words)) {
        tp_words start = *words;
        int32_t corner[3];
        const int form = read_corner(words, corner);
        if (form < 0) {
            const tp_word word = tp_word_next(&start);
            TP_FAIL(err, TP_E_OBJ_NUMBER, obj->lines.first, 0, 0);
            tp_error_set_word(err, word.text, word.bytes);
            return TP_E_OBJ_NUMBER;
        }
        if (face->corners > 0 && form != face->form)
            return TP_FAIL(err, TP_E_OBJ_MIXED, obj->lines.first, 0, 0);
        face->form = form;
        const tp_status status = add_corner(obj, corner, err);
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
