/* SPDX-License-Identifier: MIT */
/* The two passes of the OBJ reader, and its simple statements: v, vt, vn, s, g, o.
 * mesh/mesh.h describes the accepted format, mesh/obj.h the parts of the reader.  Source
 * of the format: the appendix on object files of the Advanced Visualizer manual
 * (Wavefront, version 3.0). */
#include "base/base.h"
#include "fixed/arithmetic.h"
#include "mesh/mesh.h"
#include "mesh/obj.h"

enum { MOST_GROUP = 1 << 30 };          /* fits below TP_NORMAL_KIND */

/* -- helpers of statements ----------------------------------------------------------- */

tp_status tp_obj_read_numbers(const tp_obj *obj, tp_words *words, tp_word keyword,
                              uint32_t need, uint32_t most, int64_t *numbers,
                              uint32_t *found, tp_error *err)
{
    uint32_t n = 0;
    for (; n < most && !tp_words_at_end(words); n++) {
        if (!tp_words_read_number(words, &numbers[n])) {
            const tp_word word = tp_word_next(words);
            TP_FAIL(err, TP_E_OBJ_NUMBER, obj->lines.first, 0, 0);
            tp_error_set_word(err, word.text, word.bytes);
            return TP_E_OBJ_NUMBER;
        }
    }
    *found = n;
    if (n >= need)
        return TP_OK;
    TP_FAIL(err, TP_E_OBJ_MISSING, obj->lines.first, need, n);
    tp_error_set_word(err, keyword.text, keyword.bytes);
    return TP_E_OBJ_MISSING;
}

tp_status tp_obj_check_room(const tp_obj *obj, uint32_t now, uint32_t total, uint32_t more,
                            tp_error *err)
{
    const bool scan = obj->stage == TP_STAGE_SCAN;
    if (more <= (scan ? TP_OBJ_COUNT : total) - now)
        return TP_OK;
    return TP_FAIL(err, scan ? TP_E_OBJ_COUNT : TP_E_OBJ_CHANGED, obj->lines.first,
                   TP_OBJ_COUNT, 0);
}

tp_status tp_obj_read_rest_as_name(const tp_obj *obj, tp_words *words, tp_word *name,
                                   tp_error *err)
{
    *name = tp_word_rest(words);
    if (!tp_word_holds_nul(*name))
        return TP_OK;
    return TP_FAIL(err, TP_E_OBJ_NAME, obj->lines.first, 0, 0);
}

tp_status tp_obj_fail_long_line(const tp_obj *obj, tp_error *err)
{
    return TP_FAIL(err, TP_E_OBJ_LINE, obj->lines.first, TP_OBJ_LINE_BYTES, 0);
}

void tp_obj_warn(tp_obj *obj, const tp_error *fault)
{
    if (obj->stage == TP_STAGE_SCAN)
        return;
    if (obj->warnings < TP_OBJ_WARNINGS)
        obj->warning[obj->warnings] = *fault;
    obj->warnings++;
}

/* -- v, vt, vn, s -------------------------------------------------------------------- */

static uint64_t magnitude(int64_t x)
{
    return (uint64_t)(x < 0 ? -x : x);
}

/* Reads `need` to `most` numbers; any later numbers (weights, colours) are ignored. */
static tp_status read_coordinates(tp_obj *obj, tp_words *words, const char *keyword,
                                  uint32_t need, uint32_t most, int64_t *numbers,
                                  tp_error *err)
{
    const tp_word word = { keyword, keyword[1] == '\0' ? 1 : 2 };
    uint32_t found;
    const tp_status status =
        tp_obj_read_numbers(obj, words, word, need, most, numbers, &found, err);
    for (uint32_t i = 0; status == TP_OK && i < found; i++)
        obj->now.digest = tp_mix(obj->now.digest, (uint64_t)numbers[i]);
    return status;
}

/* Converts to the mesh's units: |number| < 2^30, and differences fit 31 bits and a sign.  A
 * coarser unit truncates towards 0. */
static tp_fx to_units(const tp_obj *obj, int64_t x)
{
    return (tp_fx)(x / ((int64_t)1 << obj->log2_unit));
}

static tp_status read_position(tp_obj *obj, tp_words *words, tp_error *err)
{
    int64_t n[3];
    tp_status status = read_coordinates(obj, words, "v", 3, 3, n, err);
    if (status == TP_OK)
        status = tp_obj_check_room(obj, obj->now.vertices, obj->total.vertices, 1, err);
    if (status != TP_OK)
        return status;
    for (int i = 0; i < 3; i++) {
        const uint64_t units = magnitude(n[i]) >> 16;
        if (units >= TP_OBJ_RANGE)
            return TP_FAIL(err, TP_E_OBJ_RANGE, obj->lines.first, TP_OBJ_RANGE, 0);
        obj->now.position_bits |= (uint32_t)units;
    }
    if (obj->stage == TP_STAGE_LOAD)
        obj->store.positions[obj->now.vertices] = (tp_vec3){
            to_units(obj, n[0]), to_units(obj, n[1]), to_units(obj, n[2]) };
    obj->now.vertices++;
    return TP_OK;
}

/* Some exporters write values that were never set: 3443870976. */
static tp_fx texcoord_or_zero(tp_obj *obj, int64_t x)
{
    if (magnitude(x) < (uint64_t)TP_OBJ_REPEATS << 16)
        return (tp_fx)x;
    obj->far_texcoords++;
    return 0;
}

/* The second coordinate grows upwards in the file, downwards in the mesh. */
static tp_status read_texcoord(tp_obj *obj, tp_words *words, tp_error *err)
{
    int64_t n[2] = { 0, 0 };
    tp_status status = read_coordinates(obj, words, "vt", 1, 2, n, err);
    if (status == TP_OK)
        status = tp_obj_check_room(obj, obj->now.texcoords, obj->total.texcoords, 1, err);
    if (status != TP_OK)
        return status;
    const tp_fx s = texcoord_or_zero(obj, n[0]), t = texcoord_or_zero(obj, n[1]);
    if (obj->stage == TP_STAGE_LOAD)
        obj->store.texcoords[obj->now.texcoords] =
            (struct tp_obj_texcoord){ s, TP_FX_ONE - t };
    obj->now.texcoords++;
    return TP_OK;
}

/* Normalises a vector of any length. */
static tp_packed_dir pack_direction(const int64_t n[3])
{
    const uint64_t most = magnitude(n[0]) | magnitude(n[1]) | magnitude(n[2]);
    int64_t unit = 1;
    while (most / (uint64_t)unit >= (uint64_t)1 << 30)
        unit *= 2;
    return tp_dir_pack(tp_normalise((int32_t)(n[0] / unit), (int32_t)(n[1] / unit),
                                    (int32_t)(n[2] / unit)));
}

static tp_status read_normal(tp_obj *obj, tp_words *words, tp_error *err)
{
    int64_t n[3];
    tp_status status = read_coordinates(obj, words, "vn", 3, 3, n, err);
    if (status == TP_OK)
        status = tp_obj_check_room(obj, obj->now.normals, obj->total.normals, 1, err);
    if (status != TP_OK)
        return status;
    if (obj->stage == TP_STAGE_LOAD)
        obj->store.normals[obj->now.normals] = pack_direction(n);
    obj->now.normals++;
    return TP_OK;
}

/* s N, s off: sets the smoothing group of the following faces. */
static tp_status read_smoothing(tp_obj *obj, tp_words *words, tp_error *err)
{
    const tp_word word = tp_word_next(words);
    tp_words digits = { word.text, word.text + word.bytes };
    int32_t group = 0;
    const bool number =
        tp_words_read_int_prefix(&digits, &group) && digits.at == digits.end;
    if ((number || tp_word_is(word, "off")) && group >= 0 && group < MOST_GROUP) {
        obj->group = (uint32_t)group;
        return TP_OK;
    }
    TP_FAIL(err, TP_E_OBJ_NUMBER, obj->lines.first, 0, 0);
    tp_error_set_word(err, word.text, word.bytes);
    return TP_E_OBJ_NUMBER;
}

/* g, o: names of parts of the model, not used here. */
static tp_status ignore_statement(tp_obj *obj, tp_words *words, tp_error *err)
{
    (void)obj, (void)words, (void)err;
    return TP_OK;
}

static const struct {
    const char *name;
    tp_obj_statement *run;
    bool in_parts;              /* accepts lines of any length */
} statements[] = {
    { "v", read_position, false },       { "f", tp_obj_face, true },
    { "vt", read_texcoord, false },      { "vn", read_normal, false },
    { "s", read_smoothing, false },      { "g", ignore_statement, true },
    { "o", ignore_statement, true },            { "usemtl", tp_obj_usemtl, false },
    { "mtllib", tp_obj_mtllib, false },
};

enum { STATEMENTS = sizeof statements / sizeof *statements };

/* Returns the number of a statement, or STATEMENTS for unknown words. */
static uint32_t find_statement(tp_word word)
{
    uint32_t i = 0;
    while (i < STATEMENTS && !tp_word_is(word, statements[i].name))
        i++;
    return i;
}

static tp_status dispatch_statement(tp_obj *obj, tp_words *line, tp_error *err)
{
    if (!obj->lines.continues) {
        obj->statement = find_statement(tp_word_next(line));
        obj->skipped += obj->statement == STATEMENTS;
    }
    if (obj->statement == STATEMENTS)
        return TP_OK;
    if (obj->lines.goes_on && !statements[obj->statement].in_parts)
        return tp_obj_fail_long_line(obj, err);
    return statements[obj->statement].run(obj, line, err);
}

/* -- lines --------------------------------------------------------------------------- */

tp_status tp_obj_latch_failure(tp_obj *obj, tp_status status)
{
    if (status != TP_OK)
        obj->stage = TP_STAGE_FAILED;
    return status;
}

tp_status tp_obj_lines_feed(tp_obj *obj, const void *text, size_t bytes,
                            tp_obj_statement *run, tp_error *err)
{
    TP_ASSERT(text != NULL || bytes == 0);
    if (bytes == 0)
        return TP_OK;
    const char *at = text, *const end = at + bytes;
    tp_words line;
    while (tp_lines_next(&obj->lines, &at, end, &line)) {
        const tp_status status = run(obj, &line, err);
        if (status != TP_OK)
            return tp_obj_latch_failure(obj, status);
    }
    return TP_OK;
}

tp_status tp_obj_lines_end(tp_obj *obj, tp_obj_statement *run, tp_error *err)
{
    tp_words line;
    return tp_lines_last(&obj->lines, &line) ? run(obj, &line, err) : TP_OK;
}

/* -- the passes ---------------------------------------------------------------------- */

static void begin_pass(tp_obj *obj, uint32_t stage)
{
    obj->stage = stage;
    obj->skipped = obj->dropped = obj->short_faces = obj->far_texcoords = 0;
    obj->libraries = obj->images = obj->warnings = 0;
    obj->now = (tp_obj_counts){ .digest = 1 };
    obj->material = TP_NO_NAME;
    obj->group = 0;
    obj->crowded = false;
    tp_lines_begin(&obj->lines);
}

void tp_obj_begin_count(tp_obj *obj)
{
    begin_pass(obj, TP_STAGE_SCAN);
    obj->bytes = 0;
    obj->total = (tp_obj_counts){ 0 };
    obj->libraries_read = obj->name_longest = obj->log2_unit = 0;
    obj->name_most[TP_NAMES_LIBRARY] = obj->name_room[TP_NAMES_LIBRARY] = 0;
    obj->name_most[TP_NAMES_MATERIAL] = obj->name_room[TP_NAMES_MATERIAL] = 1;  /* for "" */
    obj->seen[0] = 0;
}

tp_status tp_obj_feed(tp_obj *obj, const void *text, size_t bytes, tp_error *err)
{
    if (obj->stage != TP_STAGE_SCAN && obj->stage != TP_STAGE_LOAD)
        return tp_obj_latch_failure(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    obj->now.bytes += (uint32_t)bytes;
    return tp_obj_lines_feed(obj, text, bytes, dispatch_statement, err);
}

tp_status tp_obj_end_count(tp_obj *obj, tp_error *err)
{
    if (obj->stage != TP_STAGE_SCAN)
        return tp_obj_latch_failure(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    const tp_status status = tp_obj_lines_end(obj, dispatch_statement, err);
    if (status != TP_OK)
        return tp_obj_latch_failure(obj, status);
    if (obj->now.polygons == 0)
        return tp_obj_latch_failure(obj,
                                    TP_FAIL(err, TP_E_OBJ_EMPTY, obj->lines.next, 0, 0));
    obj->total = obj->now;
    while (obj->total.position_bits >> obj->log2_unit >= 1 << 14)
        obj->log2_unit++;
    TP_ASSERT(obj->log2_unit <= TP_MESH_MAX_LOG2_UNIT);
    tp_arena count = tp_arena_init(NULL, 0);
    tp_obj_layout(obj, &count);
    if (count.failed)
        return tp_obj_latch_failure(obj, TP_FAIL(err, TP_E_NOSPACE, 0, INT32_MAX, 0));
    obj->bytes = count.used;
    obj->stage = TP_STAGE_SCANNED;
    return TP_OK;
}

size_t tp_obj_memory_bytes(const tp_obj *obj)
{
    return obj->bytes;
}

void tp_obj_begin_load(tp_obj *obj, void *mem)
{
    if (obj->stage != TP_STAGE_SCANNED || mem == NULL) {
        obj->stage = TP_STAGE_FAILED;
        return;
    }
    begin_pass(obj, TP_STAGE_LOAD);
    tp_arena arena = tp_arena_init(mem, obj->bytes);
    tp_obj_layout(obj, &arena);
    TP_ASSERT(!arena.failed);
    tp_names_clear(&obj->store.library_names);
    tp_names_clear(&obj->store.material_names);
    memset(obj->store.table, 0, ((size_t)obj->store.mask + 1) * sizeof *obj->store.table);
    obj->store.n_vertices = obj->store.n_faces = obj->store.n_slots = 0;
}

tp_status tp_obj_end_load(tp_obj *obj, tp_error *err)
{
    if (obj->stage != TP_STAGE_LOAD)
        return tp_obj_latch_failure(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    tp_status status = tp_obj_lines_end(obj, dispatch_statement, err);
    if (status == TP_OK && memcmp(&obj->now, &obj->total, sizeof obj->now) != 0)
        status = TP_FAIL(err, TP_E_OBJ_CHANGED, obj->lines.next, 0, 0);
    if (status == TP_OK)
        status = tp_obj_build_faces(obj, err);
    if (status != TP_OK)
        return tp_obj_latch_failure(obj, status);
    /* Image names reuse the memory of loading, which ends here; obj_layout.c defines the
     * layout. */
    tp_names_clear(&obj->store.image_names);
    obj->libraries = obj->store.library_names.count;
    obj->stage = TP_STAGE_LOADED;
    return TP_OK;
}
