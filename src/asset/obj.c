/* SPDX-License-Identifier: MIT */
/* The OBJ reader's passes and its plain statements: tidepool/asset.h says what is read,
 * asset/obj.h how the parts fit.  Source of the format: the appendix on object files of
 * the Advanced Visualizer manual (Wavefront, version 3.0). */
#include "asset/obj.h"
#include "asset/mesh.h"
#include "asset/table.h"
#include "base/base.h"

enum { MOST_GROUP = 1 << 30 };          /* what fits below TP_NORMAL_KIND */

/* -- the statements' tools ------------------------------------------------------- */

tp_status tp_obj_numbers(const tp_obj *obj, tp_words *words, tp_word keyword,
                         uint32_t need, uint32_t most, tp_fx *numbers, uint32_t *found,
                         tp_error *err)
{
    uint32_t n = 0;
    for (; n < most && !tp_words_end(words); n++) {
        if (!tp_word_fx(words, &numbers[n])) {
            const tp_word word = tp_word_next(words);
            TP_FAIL(err, TP_E_OBJ_NUMBER, obj->lines.first, 0, 0);
            tp_error_word(err, word.text, word.bytes);
            return TP_E_OBJ_NUMBER;
        }
    }
    *found = n;
    if (n >= need)
        return TP_OK;
    TP_FAIL(err, TP_E_OBJ_MISSING, obj->lines.first, need, n);
    tp_error_word(err, keyword.text, keyword.bytes);
    return TP_E_OBJ_MISSING;
}

tp_status tp_obj_room(const tp_obj *obj, uint32_t now, uint32_t total, uint32_t more,
                      tp_error *err)
{
    const bool scan = obj->stage == TP_STAGE_SCAN;
    if (more <= (scan ? TP_OBJ_COUNT : total) - now)
        return TP_OK;
    return TP_FAIL(err, scan ? TP_E_OBJ_COUNT : TP_E_OBJ_CHANGED, obj->lines.first,
                   TP_OBJ_COUNT, 0);
}

tp_status tp_obj_name(const tp_obj *obj, tp_words *words, tp_word *name, tp_error *err)
{
    *name = tp_word_rest(words);
    if (name->bytes <= TP_OBJ_NAME_BYTES && !tp_word_holds_nul(*name))
        return TP_OK;
    return TP_FAIL(err, TP_E_OBJ_NAME, obj->lines.first, TP_OBJ_NAME_BYTES, 0);
}

/* -- v, vt, vn, s ------------------------------------------------------------------ */

/* Up to three numbers within the range; what follows them (weights, colours) is not
 * looked at.  |number| < 2^30, so that differences fit 31 bits and a sign. */
static tp_status read_coordinates(tp_obj *obj, tp_words *words, const char *keyword,
                                  uint32_t need, uint32_t most, tp_fx *numbers,
                                  tp_error *err)
{
    const tp_word word = { keyword, keyword[1] == '\0' ? 1 : 2 };
    uint32_t found;
    const tp_status status =
        tp_obj_numbers(obj, words, word, need, most, numbers, &found, err);
    if (status != TP_OK)
        return status;
    for (uint32_t i = 0; i < found; i++) {
        const tp_fx limit = TP_OBJ_RANGE * TP_FX_ONE;
        if (numbers[i] <= -limit || numbers[i] >= limit)
            return TP_FAIL(err, TP_E_OBJ_RANGE, obj->lines.first, TP_OBJ_RANGE, 0);
        obj->now.digest = tp_mix(obj->now.digest, (uint32_t)numbers[i]);
    }
    return TP_OK;
}

static tp_status read_position(tp_obj *obj, tp_words *words, tp_error *err)
{
    tp_fx n[3];
    tp_status status = read_coordinates(obj, words, "v", 3, 3, n, err);
    if (status == TP_OK)
        status = tp_obj_room(obj, obj->now.vertices, obj->total.vertices, 1, err);
    if (status != TP_OK)
        return status;
    if (obj->stage == TP_STAGE_LOAD)
        obj->store.positions[obj->now.vertices] = (tp_vec3){ n[0], n[1], n[2] };
    obj->now.vertices++;
    return TP_OK;
}

/* The file's second coordinate grows upwards, ours downwards. */
static tp_status read_texcoord(tp_obj *obj, tp_words *words, tp_error *err)
{
    tp_fx n[2] = { 0, 0 };
    tp_status status = read_coordinates(obj, words, "vt", 1, 2, n, err);
    if (status == TP_OK)
        status = tp_obj_room(obj, obj->now.texcoords, obj->total.texcoords, 1, err);
    if (status != TP_OK)
        return status;
    if (obj->stage == TP_STAGE_LOAD)
        obj->store.texcoords[obj->now.texcoords] =
            (struct tp_obj_texcoord){ n[0], TP_FX_ONE - n[1] };
    obj->now.texcoords++;
    return TP_OK;
}

static tp_status read_normal(tp_obj *obj, tp_words *words, tp_error *err)
{
    tp_fx n[3];
    tp_status status = read_coordinates(obj, words, "vn", 3, 3, n, err);
    if (status == TP_OK)
        status = tp_obj_room(obj, obj->now.normals, obj->total.normals, 1, err);
    if (status != TP_OK)
        return status;
    if (obj->stage == TP_STAGE_LOAD)
        obj->store.normals[obj->now.normals] =
            tp_dir_pack(tp_normalise(n[0], n[1], n[2]));
    obj->now.normals++;
    return TP_OK;
}

/* s N, s off: the smoothing group of the faces that follow. */
static tp_status read_smoothing(tp_obj *obj, tp_words *words, tp_error *err)
{
    const tp_word word = tp_word_next(words);
    tp_words digits = { word.text, word.text + word.bytes };
    int32_t group = 0;
    const bool number = tp_word_int(&digits, &group) && digits.at == digits.end;
    if ((number || tp_word_is(word, "off")) && group >= 0 && group < MOST_GROUP) {
        obj->group = (uint32_t)group;
        return TP_OK;
    }
    TP_FAIL(err, TP_E_OBJ_NUMBER, obj->lines.first, 0, 0);
    tp_error_word(err, word.text, word.bytes);
    return TP_E_OBJ_NUMBER;
}

/* g, o: names of parts, which nothing here asks for. */
static tp_status pass_over(tp_obj *obj, tp_words *words, tp_error *err)
{
    (void)obj, (void)words, (void)err;
    return TP_OK;
}

static tp_status statement(tp_obj *obj, tp_words *line, tp_error *err)
{
    static const struct { const char *name; tp_obj_statement *run; } statements[] = {
        { "v", read_position },   { "f", tp_obj_face },   { "vt", read_texcoord },
        { "vn", read_normal },    { "s", read_smoothing },{ "g", pass_over },
        { "o", pass_over },       { "usemtl", tp_obj_usemtl },
        { "mtllib", tp_obj_mtllib },
    };
    const tp_word word = tp_word_next(line);
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++) {
        if (tp_word_is(word, statements[i].name))
            return statements[i].run(obj, line, err);
    }
    obj->skipped++;
    return TP_OK;
}

/* -- lines ------------------------------------------------------------------------- */

tp_status tp_obj_settle(tp_obj *obj, tp_status status)
{
    if (status != TP_OK)
        obj->stage = TP_STAGE_FAILED;
    return status;
}

tp_status tp_obj_lines_feed(tp_obj *obj, const void *text, size_t bytes,
                            tp_obj_statement *run, tp_error *err)
{
    if (bytes == 0)
        return TP_OK;
    const char *at = text, *const end = at + bytes;
    tp_words line;
    while (tp_lines_next(&obj->lines, &at, end, &line)) {
        if (obj->lines.used > TP_OBJ_LINE_BYTES)
            return tp_obj_settle(obj, TP_FAIL(err, TP_E_OBJ_LINE, obj->lines.first,
                                              TP_OBJ_LINE_BYTES, 0));
        const tp_status status = run(obj, &line, err);
        if (status != TP_OK)
            return tp_obj_settle(obj, status);
    }
    return TP_OK;
}

tp_status tp_obj_lines_end(tp_obj *obj, tp_obj_statement *run, tp_error *err)
{
    tp_words line;
    return tp_lines_last(&obj->lines, &line) ? run(obj, &line, err) : TP_OK;
}

/* -- the passes -------------------------------------------------------------------- */

static void begin_pass(tp_obj *obj, uint32_t stage)
{
    obj->stage = stage;
    obj->skipped = obj->dropped = 0;
    obj->libraries = obj->images = 0;
    obj->now = (tp_obj_counts){ .digest = 1 };
    obj->material = TP_NO_NAME;
    obj->group = 0;
    tp_lines_begin(&obj->lines);
}

void tp_obj_scan(tp_obj *obj)
{
    begin_pass(obj, TP_STAGE_SCAN);
    obj->bytes = 0;
    obj->total = (tp_obj_counts){ 0 };
    obj->libraries_read = 0;
    obj->name_most[TP_NAMES_LIBRARY] = obj->name_room[TP_NAMES_LIBRARY] = 0;
    obj->name_most[TP_NAMES_MATERIAL] = obj->name_room[TP_NAMES_MATERIAL] = 1;  /* "" */
    obj->work.seen[0] = 0;
}

tp_status tp_obj_feed(tp_obj *obj, const void *text, size_t bytes, tp_error *err)
{
    if (obj->stage != TP_STAGE_SCAN && obj->stage != TP_STAGE_LOAD)
        return tp_obj_settle(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    obj->now.bytes += (uint32_t)bytes;
    return tp_obj_lines_feed(obj, text, bytes, statement, err);
}

tp_status tp_obj_scanned(tp_obj *obj, tp_error *err)
{
    if (obj->stage != TP_STAGE_SCAN)
        return tp_obj_settle(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    const tp_status status = tp_obj_lines_end(obj, statement, err);
    if (status != TP_OK)
        return tp_obj_settle(obj, status);
    if (obj->now.polygons == 0)
        return tp_obj_settle(obj, TP_FAIL(err, TP_E_OBJ_EMPTY, obj->lines.next, 0, 0));
    obj->total = obj->now;
    tp_arena count = tp_arena_over(NULL, 0);
    tp_obj_carve(obj, &count);
    if (count.failed)
        return tp_obj_settle(obj, TP_FAIL(err, TP_E_NOSPACE, 0, INT32_MAX, 0));
    obj->bytes = count.used;
    obj->stage = TP_STAGE_SCANNED;
    return TP_OK;
}

size_t tp_obj_bytes(const tp_obj *obj)
{
    return obj->bytes;
}

void tp_obj_load(tp_obj *obj, void *mem)
{
    if (obj->stage != TP_STAGE_SCANNED || mem == NULL) {
        obj->stage = TP_STAGE_FAILED;
        return;
    }
    begin_pass(obj, TP_STAGE_LOAD);
    tp_arena arena = tp_arena_over(mem, obj->bytes);
    tp_obj_carve(obj, &arena);
    TP_ASSERT(!arena.failed);
    tp_names_clear(&obj->store.library_names);
    tp_names_clear(&obj->store.material_names);
    memset(obj->store.table, 0, ((size_t)obj->store.mask + 1) * sizeof *obj->store.table);
    obj->store.n_vertices = obj->store.n_faces = obj->store.n_slots = 0;
}

tp_status tp_obj_loaded(tp_obj *obj, tp_error *err)
{
    if (obj->stage != TP_STAGE_LOAD)
        return tp_obj_settle(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    tp_status status = tp_obj_lines_end(obj, statement, err);
    if (status == TP_OK && memcmp(&obj->now, &obj->total, sizeof obj->now) != 0)
        status = TP_FAIL(err, TP_E_OBJ_CHANGED, obj->lines.next, 0, 0);
    if (status == TP_OK)
        status = tp_obj_shape(obj, err);
    if (status != TP_OK)
        return tp_obj_settle(obj, status);
    tp_names_clear(&obj->store.image_names);    /* now that its place is free */
    obj->libraries = obj->store.library_names.count;
    obj->stage = TP_STAGE_LOADED;
    return TP_OK;
}
