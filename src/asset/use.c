/* SPDX-License-Identifier: MIT */
/* The OBJ statements that name things: usemtl and mtllib.
 *
 * The scan has no memory for the names, so it counts from above: names that it met lately
 * are kept in 2 KB and not counted again, any other is.  The count is exact for files
 * with up to about 200 names of common length, and never too low. */
#include "asset/obj.h"
#include "asset/table.h"
#include "base/base.h"

enum { MOST_NAMES = 1 << 20 };

/* work.seen holds records of kind + 1, length, bytes; a 0 ends them. */
static bool was_seen(tp_obj *obj, unsigned kind, tp_word name)
{
    char *at = obj->work.seen, *const end = at + sizeof obj->work.seen;
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

/* The name's number in its set when loading; in the scan it is only counted. */
static tp_status use_name(tp_obj *obj, unsigned kind, tp_obj_names *names, tp_word name,
                          uint32_t *number, tp_error *err)
{
    for (uint32_t i = 0; i < name.bytes; i++)
        obj->now.digest = tp_mix(obj->now.digest, (unsigned char)name.text[i]);
    if (obj->stage == TP_STAGE_LOAD) {
        *number = tp_names_add(names, name, 0, obj->total.digest);
        if (*number == TP_NO_NAME)
            return TP_FAIL(err, TP_E_OBJ_CHANGED, obj->lines.first, 0, 0);
        return TP_OK;
    }
    if (was_seen(obj, kind, name))
        return TP_OK;
    if (obj->name_most[kind] == MOST_NAMES)
        return TP_FAIL(err, TP_E_OBJ_COUNT, obj->lines.first, MOST_NAMES, 0);
    obj->name_most[kind]++;
    obj->name_room[kind] += name.bytes + 1;     /* <= 2^20 x 256 */
    return TP_OK;
}

static tp_status use_material(tp_obj *obj, tp_word name, tp_error *err)
{
    tp_obj_names *const names = &obj->store.material_names;
    const uint32_t before = names->count;
    const tp_status status =
        use_name(obj, TP_NAMES_MATERIAL, names, name, &obj->material, err);
    if (status != TP_OK || obj->stage == TP_STAGE_SCAN || obj->material < before)
        return status;
    obj->store.made[obj->material] = (struct tp_obj_made){
        .line = obj->lines.first, .map = { TP_NO_NAME, TP_NO_NAME } };
    obj->store.materials[obj->material] = (tp_material){
        .diffuse = 0x808080, .shininess = 32 * TP_FX_ONE, .opacity = TP_FX_ONE,
        .bump = TP_FX_ONE };
    return TP_OK;
}

tp_status tp_obj_usemtl(tp_obj *obj, tp_words *words, tp_error *err)
{
    tp_word name;
    const tp_status status = tp_obj_name(obj, words, &name, err);
    return status != TP_OK ? status : use_material(obj, name, err);
}

tp_status tp_obj_no_material(tp_obj *obj, tp_error *err)
{
    return use_material(obj, (tp_word){ "", 0 }, err);
}

static bool ends_in_mtl(tp_word word)
{
    if (word.bytes <= 4)
        return false;
    return tp_word_is_any_case((tp_word){ word.text + word.bytes - 4, 4 }, ".mtl");
}

/* The first name of what is left: up to the first word that ends in ".mtl", or all. */
static tp_words first_name(tp_words *words)
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
        tp_words one = first_name(words);
        tp_word name;
        uint32_t number;
        tp_status status = tp_obj_name(obj, &one, &name, err);
        if (status == TP_OK && name.bytes == 0)
            return TP_OK;
        if (status == TP_OK)
            status = use_name(obj, TP_NAMES_LIBRARY, &obj->store.library_names, name,
                              &number, err);
        if (status != TP_OK)
            return status;
    }
}
