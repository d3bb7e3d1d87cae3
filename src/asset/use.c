/* SPDX-License-Identifier: MIT */
/* The OBJ statements with names: usemtl and mtllib.
 *
 * The scan has no memory for names and counts an upper bound.  2 KB hold recent names; a
 * name found there is not counted again, any other name is counted.  The count is exact for
 * files with up to about 200 names of common length, and never too low.  At most
 * TP_OBJ_MATERIALS materials count: further materials found by the load are grey. */
#include "asset/obj.h"
#include "asset/table.h"
#include "base/base.h"
#include "base/fail.h"

enum { MOST_LIBRARIES = 1 << 20, MOST_ROOM = 1 << 28, SHORT_NAME = 255 };

/* obj->seen holds records of kind + 1, length, bytes; a 0 ends the list. */
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

static void mix_name(tp_obj *obj, tp_word name)
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
    i = tp_names_add(names, name, 0, obj->lines.first, obj->total.digest);
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
    if (tp_obj_read_name(obj, words, &name, &fault) != TP_OK) {
        tp_obj_warn(obj, &fault);
        return TP_OK;
    }
    mix_name(obj, name);
    return use_material(obj, name, err);
}

tp_status tp_obj_use_default_material(tp_obj *obj, tp_error *err)
{
    return use_material(obj, nameless, err);
}

/* -- libraries ----------------------------------------------------------------------- */

static tp_status use_library(tp_obj *obj, tp_word name, tp_error *err)
{
    mix_name(obj, name);
    if (obj->stage == TP_STAGE_SCAN)
        return count_name(obj, TP_NAMES_LIBRARY, name, err);
    if (tp_names_add(&obj->store.library_names, name, 0, obj->lines.first,
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
        if (tp_obj_read_name(obj, &one, &name, &fault) != TP_OK) {
            tp_obj_warn(obj, &fault);
            continue;
        }
        const tp_status status = name.bytes > 0 ? use_library(obj, name, err) : TP_OK;
        if (status != TP_OK || name.bytes == 0)
            return status;
    }
}
