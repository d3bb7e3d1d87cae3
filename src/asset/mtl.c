/* SPDX-License-Identifier: MIT */
/* The MTL reader: colours, shininess, opacity and the pictures of the materials that the
 * OBJ uses.  Others are passed over, and so is what a second definition says. */
#include "asset/obj.h"
#include "base/base.h"

/* obj->material while an MTL is read: before any newmtl; in one that is not used. */
#define NONE_YET   (UINT32_MAX - 1)
#define NOT_WANTED UINT32_MAX

static tp_material *material(tp_obj *obj) { return &obj->store.materials[obj->material]; }
static struct tp_obj_made *made(tp_obj *obj) { return &obj->store.made[obj->material]; }

static tp_status pass_over(tp_obj *obj)
{
    obj->skipped++;
    return TP_OK;
}

static tp_status begin_material(tp_obj *obj, tp_word keyword, tp_words *words,
                                tp_error *err)
{
    (void)keyword;
    tp_word name;
    const tp_status status = tp_obj_name(obj, words, &name, err);
    if (status != TP_OK)
        return status;
    obj->material = tp_names_find(&obj->store.material_names, name, 0, obj->total.digest);
    if (obj->material == TP_NO_NAME || name.bytes == 0 || made(obj)->defined) {
        obj->material = NOT_WANTED;
        return pass_over(obj);
    }
    made(obj)->defined = true;
    return TP_OK;
}

/* -- numbers ------------------------------------------------------------------------- */

static uint32_t level(tp_fx x)
{
    return (uint32_t)(tp_clamp(x, 0, TP_FX_ONE) * 255 + TP_FX_ONE / 2) >> 16;
}

/* r g b, or one number for all.  Spectral curves and CIE colours are not read. */
static tp_status read_colour(tp_obj *obj, tp_word keyword, tp_words *words,
                             uint32_t *colour, tp_error *err)
{
    tp_words ahead = *words;
    const tp_word first = tp_word_next(&ahead);
    if (tp_word_is(first, "spectral") || tp_word_is(first, "xyz"))
        return pass_over(obj);
    const uint32_t need = tp_words_end(&ahead) ? 1 : 3;
    tp_fx rgb[3];
    uint32_t found;
    const tp_status status =
        tp_obj_numbers(obj, words, keyword, need, need, rgb, &found, err);
    if (status != TP_OK)
        return status;
    if (need == 1)
        rgb[1] = rgb[2] = rgb[0];
    *colour = level(rgb[0]) << 16 | level(rgb[1]) << 8 | level(rgb[2]);
    return TP_OK;
}

static tp_status read_diffuse(tp_obj *obj, tp_word keyword, tp_words *words,
                              tp_error *err)
{
    made(obj)->has_diffuse = true;
    return read_colour(obj, keyword, words, &material(obj)->diffuse, err);
}

static tp_status read_specular(tp_obj *obj, tp_word keyword, tp_words *words,
                               tp_error *err)
{
    return read_colour(obj, keyword, words, &material(obj)->specular, err);
}

static tp_status read_shininess(tp_obj *obj, tp_word keyword, tp_words *words,
                                tp_error *err)
{
    tp_fx n;
    uint32_t found;
    const tp_status status = tp_obj_numbers(obj, words, keyword, 1, 1, &n, &found, err);
    if (status == TP_OK)
        material(obj)->shininess = tp_clamp(n, TP_FX_ONE, 1000 * TP_FX_ONE);
    return status;
}

/* d x, or d -halo x, whose dependence on the view is not drawn. */
static tp_status read_opacity(tp_obj *obj, tp_word keyword, tp_words *words,
                              tp_error *err)
{
    tp_words ahead = *words;
    if (tp_word_is_any_case(tp_word_next(&ahead), "-halo"))
        *words = ahead;
    tp_fx n;
    uint32_t found;
    const tp_status status = tp_obj_numbers(obj, words, keyword, 1, 1, &n, &found, err);
    if (status != TP_OK)
        return status;
    material(obj)->opacity = tp_clamp(n, 0, TP_FX_ONE);
    made(obj)->has_opacity = true;
    return TP_OK;
}

static tp_status read_transparency(tp_obj *obj, tp_word keyword, tp_words *words,
                                   tp_error *err)
{
    tp_fx n;
    uint32_t found;
    const tp_status status = tp_obj_numbers(obj, words, keyword, 1, 1, &n, &found, err);
    if (status == TP_OK && !made(obj)->has_opacity)
        material(obj)->opacity = TP_FX_ONE - tp_clamp(n, 0, TP_FX_ONE);
    return status;
}

/* -- maps ---------------------------------------------------------------------------- */

/* Options of a map and the words that follow each; -o, -s and -t have one to three
 * numbers. */
static const struct { const char *name; uint8_t words; bool numbers; } options[] = {
    { "-blendu", 1, false },     { "-blendv", 1, false }, { "-boost", 1, false },
    { "-bm", 1, false },         { "-cc", 1, false },     { "-clamp", 1, false },
    { "-colorspace", 1, false }, { "-imfchan", 1, false },{ "-mm", 2, false },
    { "-o", 3, true },           { "-s", 3, true },       { "-t", 3, true },
    { "-texres", 1, false },     { "-type", 1, false },
};

/* Is there another word after this one? */
static bool is_last_word(tp_words words)
{
    tp_word_next(&words);
    return tp_word_next(&words).bytes == 0;
}

/* Numbers that follow an option; the line's last word is the file, also if it looks like
 * a number. */
static void skip_numbers(tp_words *words, uint32_t most)
{
    tp_fx unused;
    while (most-- > 0 && !is_last_word(*words) && tp_word_fx(words, &unused))
        ;
}

/* Takes one option with what belongs to it; false: there is none, here is the name.
 * -bm sets *bump. */
static bool take_option(tp_words *words, tp_fx *bump)
{
    tp_words ahead = *words;
    const tp_word word = tp_word_next(&ahead);
    for (uint32_t i = 0; i < sizeof options / sizeof *options; i++) {
        if (!tp_word_is_any_case(word, options[i].name))
            continue;
        *words = ahead;
        if (tp_word_is_any_case(word, "-bm") && tp_word_fx(words, bump))
            return true;
        if (options[i].numbers)
            skip_numbers(words, options[i].words);
        for (uint32_t k = 0; !options[i].numbers && k < options[i].words; k++)
            tp_word_next(words);
        return true;
    }
    return false;
}

static tp_status read_map(tp_obj *obj, tp_words *words, unsigned map, tp_fx *bump,
                          tp_error *err)
{
    while (take_option(words, bump))
        ;
    tp_word name;
    const tp_status status = tp_obj_name(obj, words, &name, err);
    if (status != TP_OK)
        return status;
    if (name.bytes == 0 || made(obj)->map[map] != TP_NO_NAME)
        return pass_over(obj);
    tp_obj_names *const names = &obj->store.image_names;
    made(obj)->map[map] = tp_names_add(names, name, obj->library, obj->total.digest);
    TP_ASSERT(made(obj)->map[map] != TP_NO_NAME);   /* room for two of each material */
    obj->images = names->count;
    return TP_OK;
}

static tp_status read_diffuse_map(tp_obj *obj, tp_word keyword, tp_words *words,
                                  tp_error *err)
{
    (void)keyword;
    tp_fx unused;
    return read_map(obj, words, TP_MAP_DIFFUSE, &unused, err);
}

static tp_status read_bump_map(tp_obj *obj, tp_word keyword, tp_words *words,
                               tp_error *err)
{
    (void)keyword;
    const bool first = made(obj)->map[TP_MAP_BUMP] == TP_NO_NAME;
    tp_fx bump = TP_FX_ONE;
    const tp_status status = read_map(obj, words, TP_MAP_BUMP, &bump, err);
    if (first)
        material(obj)->bump = tp_clamp(bump, -16 * TP_FX_ONE, 16 * TP_FX_ONE);
    return status;
}

/* -- the file ------------------------------------------------------------------------ */

static tp_status statement(tp_obj *obj, tp_words *line, tp_error *err)
{
    static const struct {
        const char *name;
        tp_status (*run)(tp_obj *obj, tp_word keyword, tp_words *words, tp_error *err);
    } statements[] = {
        { "newmtl", begin_material },    { "kd", read_diffuse },
        { "ks", read_specular },         { "ns", read_shininess },
        { "d", read_opacity },           { "tr", read_transparency },
        { "map_kd", read_diffuse_map },  { "map_bump", read_bump_map },
        { "bump", read_bump_map },       { "norm", read_bump_map },
    };
    const tp_word word = tp_word_next(line);
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++) {
        if (!tp_word_is_any_case(word, statements[i].name))
            continue;
        if (i > 0 && obj->material == NONE_YET) {
            TP_FAIL(err, TP_E_MTL_ORDER, obj->lines.first, 0, 0);
            tp_error_word(err, word.text, word.bytes);
            return TP_E_MTL_ORDER;
        }
        if (i > 0 && obj->material == NOT_WANTED)
            break;
        return statements[i].run(obj, word, line, err);
    }
    return pass_over(obj);
}

void tp_mtl_begin(tp_obj *obj, uint32_t library)
{
    const bool may = obj->stage == TP_STAGE_LOADED && library < obj->libraries;
    obj->stage = may ? TP_STAGE_MTL : TP_STAGE_FAILED;
    obj->library = library;
    obj->material = NONE_YET;
    tp_lines_begin(&obj->lines);
}

tp_status tp_mtl_feed(tp_obj *obj, const void *text, size_t bytes, tp_error *err)
{
    if (obj->stage != TP_STAGE_MTL)
        return tp_obj_settle(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    return tp_obj_lines_feed(obj, text, bytes, statement, err);
}

tp_status tp_mtl_end(tp_obj *obj, tp_error *err)
{
    if (obj->stage != TP_STAGE_MTL)
        return tp_obj_settle(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    const tp_status status = tp_obj_lines_end(obj, statement, err);
    if (status != TP_OK)
        return tp_obj_settle(obj, status);
    obj->libraries_read++;
    obj->stage = TP_STAGE_LOADED;
    return TP_OK;
}
