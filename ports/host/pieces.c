/* SPDX-License-Identifier: MIT */
/* The table of pieces, made from the lists of tidepool/modules.h: a piece added or removed
 * there needs no change here. */
#include "pieces.h"
#include "scene/world_parts.h"
#include <inttypes.h>
#include <stdatomic.h>
#include <stddef.h>
#include <string.h>

/* -- the rows ------------------------------------------------------------------------- */

const piece pieces[] = {
#define X(x) { #x, PIECE_STAGE },
    TP_STAGE_LIST(X)
#undef X
#define X(x) { #x, PIECE_WATER },
    TP_WATER_LIST(X)
#undef X
#define X(x) { #x, PIECE_DRAW },
    TP_DRAW_LIST(X)
#undef X
#define X(x) { #x, PIECE_METHOD },
    TP_METHOD_LIST(X)
#undef X
#define MODULE(x) { #x, PIECE_MODULE }, { #x, PIECE_DRAWING }, TP_STAGES_OF_##x(X)
#define UNSEEN(x) { #x, PIECE_MODULE },
#define X(x) { #x, PIECE_MODULE_STAGE },
    TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef X
#undef UNSEEN
#undef MODULE
};

const size_t piece_count = sizeof pieces / sizeof *pieces;
_Static_assert(sizeof pieces / sizeof *pieces <= PIECES_MOST, "a set holds all pieces");

/* The code of a piece: a stage, a pointer in a program with its offset there, or a use. */
typedef struct {
    tp_stage    stage, watched;
    const void *part;
    size_t      offset;
    tp_use      use;
    tp_lack     lack;
} meaning;

/* -- watched stages ------------------------------------------------------------------- */

/* Indices of stages in the order of the rows above; stages of parts are counted but not
 * used. */
enum {
#define X(x) RAN_##x,
#define MODULE(x) TP_STAGES_OF_##x(X)
#define UNSEEN(x)
    TP_STAGE_LIST(X)
    TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef UNSEEN
#undef MODULE
#undef X
    RAN_COUNT
};

static atomic_bool ran[RAN_COUNT];

#define X(x) \
    static void watched_##x(const struct tp_shade *shade, struct tp_run *run) \
    { \
        atomic_store_explicit(&ran[RAN_##x], true, memory_order_relaxed); \
        tp_stage_##x(shade, run); \
    }
#define MODULE(x) TP_STAGES_OF_##x(X)
#define UNSEEN(x)
TP_STAGE_LIST(X)
TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef UNSEEN
#undef MODULE
#undef X

static const meaning meanings[] = {
#define X(x) { .stage = tp_stage_##x, .watched = watched_##x, \
               .offset = offsetof(tp_program, stage.x) },
    TP_STAGE_LIST(X)
#undef X
#define X(x) { .part = &tp_water_##x, .offset = offsetof(tp_program, water.x) },
    TP_WATER_LIST(X)
#undef X
#define X(x) { .part = &tp_draw_##x, .offset = offsetof(tp_program, draw.x) },
    TP_DRAW_LIST(X)
#undef X
#define X(x) { .part = &tp_method_##x, .offset = offsetof(tp_program, method.x) },
    TP_METHOD_LIST(X)
#undef X
#define MODULE(x) \
    { .use = TP_USE(x), .lack = TP_LACK(x, 0) }, { .use = TP_USE(x) }, TP_STAGES_OF_##x(X)
#define UNSEEN(x) { .use = TP_USE_UNSEEN(x), .lack = TP_LACK(x, 0) },
#define X(x) { .stage = tp_stage_##x, .watched = watched_##x },
    TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef X
#undef UNSEEN
#undef MODULE
};

void pieces_forget(void)
{
    for (size_t i = 0; i < RAN_COUNT; i++)
        atomic_store(&ran[i], false);
}

/* The array `ran` holds stages in the order of the rows. */
bool pieces_ran(size_t i)
{
    size_t at = 0;
    for (size_t k = 0; k < i; k++)
        at += piece_is_stage(k);
    return piece_is_stage(i) && atomic_load(&ran[at]);
}

/* -- a list --------------------------------------------------------------------------- */

/* Sets a program's member at its offset; all pointers to parts have the same size. */
static void put(tp_program *program, const meaning *m, tp_stage stage)
{
    char *at = (char *)program + m->offset;
    if (stage)
        memcpy(at, &stage, sizeof stage);
    else
        memcpy(at, &m->part, sizeof m->part);
}

static void make(piece_list *to, const piece_set *of, const piece_terms *terms, bool watch)
{
    tp_use   *use = NULL, *end = to->use;
    tp_stage *stage = to->stage;

    memset(to, 0, sizeof *to);
    for (size_t i = 0; i < piece_count; i++) {
        const meaning *m = &meanings[i];
        const bool in = of->has[i];
        const tp_stage by = !in ? NULL : watch ? m->watched : m->stage;
        if (pieces[i].kind == PIECE_MODULE)
            use = in ? end++ : NULL;
        if (pieces[i].kind == PIECE_MODULE && in)
            *use = (tp_use){ .module = m->use.module };
        else if (pieces[i].kind == PIECE_DRAWING && use)
            *use = (tp_use){ use->module, in ? m->use.drawing : NULL, stage, NULL };
        else if (pieces[i].kind == PIECE_MODULE_STAGE)
            *stage++ = by;
        else if (pieces[i].kind < PIECE_MODULE && in)
            put(&to->program, m, by);
    }
    to->program.modules = to->use;
    to->program.check = terms->checks ? tp_scene_check : NULL;
    to->program.store[terms->format] = tp_program_all.store[terms->format];
    if (terms->streams && to->program.method.triangles)
        to->program.method.triangles = &tp_method_streamed;
    if (terms->few && to->program.water.swells)
        to->program.water.swells = &tp_water_few_swells;
}

void pieces_list(piece_list *to, const piece_set *of, const piece_terms *terms)
{
    make(to, of, terms, false);
}

void pieces_watch(piece_list *to, const piece_set *of, const piece_terms *terms)
{
    make(to, of, terms, true);
}

/* Returns the number of the set's modules before a piece. */
static uint32_t count_earlier_modules(const piece_set *of, size_t i)
{
    uint32_t above = 0;
    for (size_t k = 0; k < i; k++)
        above += pieces[k].kind == PIECE_MODULE && of->has[k];
    return above;
}

bool piece_is_active(size_t i, const piece_set *of, const piece_terms *terms,
                     const tp_scene *scene, const tp_assets *assets)
{
    piece_set others = *of;
    piece_list list;
    tp_lack lacks[2] = { meanings[i].lack };

    others.has[i] = false;
    lacks[0].above = count_earlier_modules(&others, i);
    pieces_list(&list, &others, terms);
    list.program.lacks = lacks;
    list.program.refuse = tp_lacks_check;
    return tp_program_check_all(&list.program, scene, assets, NULL) == TP_E_PROGRAM;
}

/* -- names ---------------------------------------------------------------------------- */

bool pieces_named(piece_set *to, const char *name, size_t length)
{
    bool found = false, within = false;

    for (size_t i = 0; i < piece_count; i++) {
        const bool same = strlen(pieces[i].name) == length
                       && memcmp(pieces[i].name, name, length) == 0;
        const bool inner = pieces[i].kind > PIECE_MODULE;
        if (!inner)
            within = same && pieces[i].kind == PIECE_MODULE;
        if (same || (inner && within))
            to->has[i] = found = true;
    }
    return found;
}

static bool is_named(size_t i, piece_kind kind, const char *name)
{
    return pieces[i].kind == kind && strcmp(pieces[i].name, name) == 0;
}

void pieces_add_models(piece_set *set)
{
    static const struct { const char *module, *model; } needs[] = {
        { "drops", "rings" }, { "main_pool", "pools" }, { "field", "pools" },
        { "coastal", "ocean" }, { "coastal", "swells" },
    };

    for (size_t n = 0; n < sizeof needs / sizeof *needs; n++) {
        bool asked = false;
        for (size_t i = 0; i < piece_count; i++)
            asked |= set->has[i] && is_named(i, PIECE_MODULE, needs[n].module);
        for (size_t i = 0; i < piece_count && asked; i++)
            set->has[i] |= is_named(i, PIECE_WATER, needs[n].model);
    }
}

bool piece_moves(size_t i)
{
    return pieces[i].kind == PIECE_WATER || pieces[i].kind == PIECE_MODULE;
}

const char *piece_word(size_t i)
{
    static const char *const word[] = {
        [PIECE_STAGE] = "stage", [PIECE_WATER] = "water", [PIECE_DRAW] = "draw",
        [PIECE_METHOD] = "method", [PIECE_MODULE] = "module",
        [PIECE_DRAWING] = "drawing", [PIECE_MODULE_STAGE] = "stage",
    };
    return word[pieces[i].kind];
}

/* -- as text -------------------------------------------------------------------------- */

static const char *piece_symbol(size_t i, const piece_terms *terms)
{
    const char *name = pieces[i].name;
    if (pieces[i].kind == PIECE_METHOD && terms->streams && !strcmp(name, "triangles"))
        return "streamed";
    if (pieces[i].kind == PIECE_WATER && terms->few && !strcmp(name, "swells"))
        return "few_swells";
    return name;
}

/* Writes "    .water = { .swells = &tp_water_swells }," or nothing. */
static void write_kind(FILE *out, const piece_set *of, const piece_terms *terms,
                       piece_kind kind)
{
    const char *before = " ";
    for (size_t i = 0, n = 0; i < piece_count; i++) {
        if (pieces[i].kind != kind || !of->has[i])
            continue;
        if (n++ == 0)
            fprintf(out, "    .%s = {", piece_word(i));
        fprintf(out, "%s\n        .%s = %stp_%s_%s", n > 1 ? "," : "", pieces[i].name,
                kind == PIECE_STAGE ? "" : "&", piece_word(i), piece_symbol(i, terms));
        before = "\n    },\n";
    }
    if (*before == '\n')
        fputs(before, out);
}

/* Writes the tables of stages.  A table has an entry for each stage of the module, 0 for a
 * missing stage. */
static void write_tables(FILE *out, const char *name, const piece_set *of)
{
    for (size_t i = 0; i < piece_count; i++) {
        if (pieces[i].kind != PIECE_DRAWING || !of->has[i])
            continue;
        fprintf(out, "static const tp_stage %s_%s_stages[] = {\n", name, pieces[i].name);
        size_t k = i + 1;
        for (; k < piece_count && pieces[k].kind == PIECE_MODULE_STAGE; k++)
            if (of->has[k])
                fprintf(out, "    tp_stage_%s,\n", pieces[k].name);
            else
                fprintf(out, "    0,\n");
        fprintf(out, "%s};\n", k == i + 1 ? "    0\n" : "");
    }
}

static void write_uses(FILE *out, const char *name, const piece_set *of)
{
    fprintf(out, "static const tp_use %s_modules[] = {\n", name);
    for (size_t i = 0; i < piece_count; i++) {
        if (pieces[i].kind != PIECE_MODULE || !of->has[i])
            continue;
        const char *module = pieces[i].name;
        if (i + 1 < piece_count && pieces[i + 1].kind == PIECE_DRAWING && of->has[i + 1])
            fprintf(out, "    { &tp_%s_module, &tp_%s_drawing, %s_%s_stages, 0 },\n", module,
                    module, name, module);
        else
            fprintf(out, "    { &tp_%s_module, 0, 0, 0 },\n", module);
    }
    fprintf(out, "    { 0, 0, 0, 0 }\n};\n");
}

/* Writes the list of missing modules; false: no module is missing, and no list is
 * written. */
static bool write_lacks(FILE *out, const char *name, const piece_set *of,
                        const piece_set *lacks)
{
    uint32_t written = 0;
    for (size_t i = 0; i < piece_count; i++)
        if (pieces[i].kind == PIECE_MODULE && lacks->has[i]) {
            if (written++ == 0)
                fprintf(out, "static const tp_lack %s_lacks[] = {\n", name);
            fprintf(out, "    { \"%s\", tp_%s_enabled, %" PRIu32 " },\n", pieces[i].name,
                    pieces[i].name, count_earlier_modules(of, i));
        }
    if (written > 0)
        fprintf(out, "    { 0, 0, 0 }\n};\n");
    return written > 0;
}

void pieces_write(FILE *out, const char *name, const piece_set *of, const piece_set *lacks,
                  const piece_terms *terms)
{
    static const char *const word[] = {
#define X(name, word, bits, text) [TP_FORMAT_##name] = "[TP_FORMAT_" #name "] = tp_store_" #word,
        TP_FORMAT_LIST(X)
#undef X
    };

    fputc('\n', out);
    write_tables(out, name, of);
    write_uses(out, name, of);
    const bool refuses = write_lacks(out, name, of, lacks);
    fprintf(out, "extern const tp_program %s_program;\nconst tp_program %s_program = {\n",
            name, name);
    if (terms->checks)
        fprintf(out, "    .check = tp_scene_check,\n");
    for (int kind = PIECE_STAGE; kind < PIECE_MODULE; kind++)
        write_kind(out, of, terms, (piece_kind)kind);
    if (refuses)
        fprintf(out, "    .refuse = tp_lacks_check,\n    .lacks = %s_lacks,\n", name);
    fprintf(out, "    .store = { %s },\n    .modules = %s_modules\n};\n",
            word[terms->format], name);
}
