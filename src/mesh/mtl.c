/* SPDX-License-Identifier: MIT */
/* The MTL reader: colours, shininess, opacity and texture names of the materials used by
 * the OBJ.  Other materials are skipped, and so is a second definition of a material.
 *
 * A statement returns its fault, and the fault becomes a warning.  The material keeps its
 * default; a number out of range is clamped to the nearest valid number. */
#include "base/base.h"
#include "mesh/obj.h"

/* Values of obj->material while an MTL is read: before any newmtl; in a material not
 * used. */
#define NONE_YET   (UINT32_MAX - 1)
#define NOT_WANTED UINT32_MAX

static tp_material *material(tp_obj *obj) { return &obj->store.materials[obj->material]; }
static struct tp_obj_made *current_material_data(tp_obj *obj)
{
    return &obj->store.made[obj->material];
}

/* Counts a statement that the reader does not know or use. */
static tp_status count_skipped_statement(tp_obj *obj)
{
    obj->skipped++;
    return TP_OK;
}

static tp_status begin_material(tp_obj *obj, tp_word keyword, tp_words *words,
                                tp_error *err)
{
    (void)keyword;
    tp_word name;
    const tp_status status = tp_obj_read_rest_as_name(obj, words, &name, err);
    if (status != TP_OK) {
        obj->material = NOT_WANTED;
        return status;
    }
    obj->material = tp_names_find(&obj->store.material_names, name, 0, obj->total.digest);
    if (obj->material == TP_NO_NAME || name.bytes == 0
        || current_material_data(obj)->defined) {
        obj->material = NOT_WANTED;
        return count_skipped_statement(obj);
    }
    current_material_data(obj)->defined = true;
    return TP_OK;
}

/* -- numbers ------------------------------------------------------------------------- */

static uint32_t unit_to_byte(tp_fx x)
{
    return (uint32_t)(x * 255 + TP_FX_ONE / 2) >> 16;
}

static bool is_ok_or_clamped(tp_status status)
{
    return status == TP_OK || status == TP_E_MTL_RANGE;
}

/* Clamps x to low..high.  Returns TP_E_MTL_RANGE if x was outside. */
static tp_status clamp_number(const tp_obj *obj, tp_word keyword, int64_t x, int32_t low,
                              int32_t high, tp_fx *clamped, tp_error *err)
{
    const int64_t bottom = (int64_t)low * TP_FX_ONE, top = (int64_t)high * TP_FX_ONE;
    *clamped = (tp_fx)(x < bottom ? bottom : x > top ? top : x);
    if (*clamped == x)
        return TP_OK;
    TP_FAIL(err, TP_E_MTL_RANGE, obj->lines.first, low, high);
    tp_error_set_word(err, keyword.text, keyword.bytes);
    return TP_E_MTL_RANGE;
}

/* Every reader of a statement gets the keyword, and the words after the keyword.  The
 * functions for numbers need the keyword for error reports only. */

/* Reads the single number of a statement. */
static tp_status read_number(const tp_obj *obj, tp_word keyword, tp_words *words,
                             int32_t low, int32_t high, tp_fx *x, tp_error *err)
{
    int64_t n;
    uint32_t found;
    const tp_status status =
        tp_obj_read_numbers(obj, words, keyword, 1, 1, &n, &found, err);
    return status != TP_OK ? status : clamp_number(obj, keyword, n, low, high, x, err);
}

/* Reads r g b, or one number for all three.  Spectral curves and CIE colours are
 * skipped. */
static tp_status read_colour(tp_obj *obj, tp_word keyword, tp_words *words,
                             uint32_t *colour, tp_error *err)
{
    tp_words ahead = *words;
    const tp_word first = tp_word_next(&ahead);
    if (tp_word_is(first, "spectral") || tp_word_is(first, "xyz"))
        return count_skipped_statement(obj);
    const uint32_t need = tp_words_at_end(&ahead) ? 1 : 3;
    int64_t rgb[3];
    uint32_t found, packed = 0;
    tp_status status =
        tp_obj_read_numbers(obj, words, keyword, need, need, rgb, &found, err);
    if (status != TP_OK)
        return status;
    for (uint32_t i = 0; i < 3; i++) {
        tp_fx part;
        const int64_t x = need == 1 ? rgb[0] : rgb[i];
        if (clamp_number(obj, keyword, x, 0, 1, &part, err) != TP_OK)
            status = TP_E_MTL_RANGE;
        packed = packed << 8 | unit_to_byte(part);
    }
    *colour = packed;
    return status;
}

static tp_status read_diffuse_colour(tp_obj *obj, tp_word keyword, tp_words *words,
                                     tp_error *err)
{
    const tp_status status =
        read_colour(obj, keyword, words, &material(obj)->diffuse, err);
    if (is_ok_or_clamped(status))
        current_material_data(obj)->has_diffuse = true;
    return status;
}

static tp_status read_specular_colour(tp_obj *obj, tp_word keyword, tp_words *words,
                                      tp_error *err)
{
    return read_colour(obj, keyword, words, &material(obj)->specular, err);
}

/* 0..1000 in the file; a highlight needs at least 1. */
static tp_status read_shininess(tp_obj *obj, tp_word keyword, tp_words *words,
                                tp_error *err)
{
    tp_fx n = 0;
    const tp_status status = read_number(obj, keyword, words, 0, 1000, &n, err);
    if (is_ok_or_clamped(status))
        material(obj)->shininess = n > TP_FX_ONE ? n : TP_FX_ONE;
    return status;
}

/* Reads `d x`, or `d -halo x`; the dependence of a halo on the view is not drawn. */
static tp_status read_opacity(tp_obj *obj, tp_word keyword, tp_words *words,
                              tp_error *err)
{
    tp_words ahead = *words;
    if (tp_word_is_any_case(tp_word_next(&ahead), "-halo"))
        *words = ahead;
    tp_fx n = 0;
    const tp_status status = read_number(obj, keyword, words, 0, 1, &n, err);
    if (is_ok_or_clamped(status)) {
        material(obj)->opacity = n;
        current_material_data(obj)->has_opacity = true;
    }
    return status;
}

static tp_status read_transparency(tp_obj *obj, tp_word keyword, tp_words *words,
                                   tp_error *err)
{
    tp_fx n = 0;
    const tp_status status = read_number(obj, keyword, words, 0, 1, &n, err);
    if (is_ok_or_clamped(status) && !current_material_data(obj)->has_opacity)
        material(obj)->opacity = TP_FX_ONE - n;
    return status;
}

/* -- maps ---------------------------------------------------------------------------- */

/* Options of a map and the number of words after each; -o, -s and -t have one
 * to three numbers. */
static const struct { const char *name; uint8_t words; bool numbers; } options[] = {
    { "-blendu", 1, false },     { "-blendv", 1, false }, { "-boost", 1, false },
    { "-bm", 1, false },         { "-cc", 1, false },     { "-clamp", 1, false },
    { "-colorspace", 1, false }, { "-imfchan", 1, false },{ "-mm", 2, false },
    { "-o", 3, true },           { "-s", 3, true },       { "-t", 3, true },
    { "-texres", 1, false },     { "-type", 1, false },
};

/* True if no other word follows the next word. */
static bool is_last_word(tp_words words)
{
    tp_word_next(&words);
    return tp_word_next(&words).bytes == 0;
}

/* Skips numbers after an option.  The last word of the line is the file name, even if the
 * word looks like a number. */
static void skip_numbers(tp_words *words, uint32_t max_count)
{
    int64_t unused;
    while (max_count-- > 0 && !is_last_word(*words) && tp_words_read_number(words, &unused))
        ;
}

/* Takes one option with its arguments.  Returns false if the file name follows
 * instead.  -bm sets *bump. */
static bool take_option(tp_words *words, int64_t *bump)
{
    int64_t number;
    tp_words ahead = *words;
    const tp_word word = tp_word_next(&ahead);
    for (uint32_t i = 0; i < sizeof options / sizeof *options; i++) {
        if (!tp_word_is_any_case(word, options[i].name))
            continue;
        *words = ahead;
        if (tp_word_is_any_case(word, "-bm") && tp_words_read_number(words, &number)) {
            *bump = number;
            return true;
        }
        if (options[i].numbers)
            skip_numbers(words, options[i].words);
        for (uint32_t k = 0; !options[i].numbers && k < options[i].words; k++)
            tp_word_next(words);
        return true;
    }
    return false;
}

static tp_status read_map(tp_obj *obj, tp_words *words, unsigned map, int64_t *bump,
                          tp_error *err)
{
    while (take_option(words, bump))
        ;
    tp_word name;
    const tp_status status = tp_obj_read_rest_as_name(obj, words, &name, err);
    if (status != TP_OK)
        return status;
    if (name.bytes == 0 || current_material_data(obj)->map[map] != TP_NO_NAME)
        return count_skipped_statement(obj);
    tp_obj_names *const names = &obj->store.image_names;
    const uint32_t image = tp_names_find_or_add(names, name, obj->library,
                                                obj->lines.first, obj->total.digest);
    if (image == TP_NO_NAME)
        return TP_FAIL(err, TP_E_MTL_IMAGES, obj->lines.first, names->room, 0);
    current_material_data(obj)->map[map] = image;
    obj->images = names->count;
    return TP_OK;
}

static tp_status read_diffuse_map(tp_obj *obj, tp_word keyword, tp_words *words,
                                  tp_error *err)
{
    (void)keyword;
    int64_t unused;
    return read_map(obj, words, TP_MAP_DIFFUSE, &unused, err);
}

static tp_status read_bump_map(tp_obj *obj, tp_word keyword, tp_words *words,
                               tp_error *err)
{
    const bool first = current_material_data(obj)->map[TP_MAP_BUMP] == TP_NO_NAME;
    int64_t bump = TP_FX_ONE;
    const tp_status status = read_map(obj, words, TP_MAP_BUMP, &bump, err);
    if (status != TP_OK || !first)
        return status;
    return clamp_number(obj, keyword, bump, -16, 16, &material(obj)->bump, err);
}

/* -- the file ------------------------------------------------------------------------ */

typedef tp_status run_statement(tp_obj *obj, tp_word keyword, tp_words *words,
                                tp_error *err);

static const struct { const char *name; run_statement *run; } statements[] = {
    { "newmtl", begin_material },    { "kd", read_diffuse_colour },
    { "ks", read_specular_colour },  { "ns", read_shininess },
    { "d", read_opacity },           { "tr", read_transparency },
    { "map_kd", read_diffuse_map },  { "map_bump", read_bump_map },
    { "bump", read_bump_map },       { "norm", read_bump_map },
};

enum { STATEMENTS = sizeof statements / sizeof *statements };

static tp_status dispatch_statement(tp_obj *obj, tp_words *line, tp_error *err)
{
    const tp_word word = tp_word_next(line);
    size_t i = 0;
    while (i < STATEMENTS && !tp_word_is_any_case(word, statements[i].name))
        i++;
    if (i == STATEMENTS || (i > 0 && obj->material == NOT_WANTED))
        return count_skipped_statement(obj);
    if (obj->lines.goes_on) {
        obj->material = i == 0 ? NOT_WANTED : obj->material;
        return tp_obj_fail_long_line(obj, err);
    }
    if (i == 0 || obj->material != NONE_YET)
        return statements[i].run(obj, word, line, err);
    TP_FAIL(err, TP_E_MTL_ORDER, obj->lines.first, 0, 0);
    tp_error_set_word(err, word.text, word.bytes);
    return TP_E_MTL_ORDER;
}

/* Runs a statement.  No fault stops the reading. */
static tp_status dispatch_statement_or_warn(tp_obj *obj, tp_words *line, tp_error *err)
{
    (void)err;
    tp_error fault;
    if (!obj->lines.continues && dispatch_statement(obj, line, &fault) != TP_OK)
        tp_obj_warn(obj, &fault);
    return TP_OK;
}

void tp_mtl_begin(tp_obj *obj, uint32_t library)
{
    const bool may = obj->stage == TP_STAGE_LOADED && library < obj->libraries;
    obj->stage = may ? TP_STAGE_MTL : TP_STAGE_FAILED;
    obj->library = library;
    obj->material = NONE_YET;
    obj->warnings = 0;
    tp_lines_begin(&obj->lines);
}

tp_status tp_mtl_feed(tp_obj *obj, const void *text, size_t bytes, tp_error *err)
{
    if (obj->stage != TP_STAGE_MTL)
        return tp_obj_latch_failure(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    return tp_obj_lines_feed(obj, text, bytes, dispatch_statement_or_warn, err);
}

tp_status tp_mtl_end(tp_obj *obj, tp_error *err)
{
    if (obj->stage != TP_STAGE_MTL)
        return tp_obj_latch_failure(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    const tp_status status = tp_obj_lines_end(obj, dispatch_statement_or_warn, err);
    if (status != TP_OK)
        return tp_obj_latch_failure(obj, status);
    obj->libraries_read++;
    obj->stage = TP_STAGE_LOADED;
    return TP_OK;
}
