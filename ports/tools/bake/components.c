/* SPDX-License-Identifier: MIT */
/* The table of components, made from the lists of tidepool/modules.h: a component added
 * or removed there needs no change here. */
#include "components.h"
#include <inttypes.h>
#include <stdatomic.h>
#include <stddef.h>
#include <string.h>
#include "world/module.h"

/* -- the rows ------------------------------------------------------------------------ */

const component components[] = {
#define X(x) { #x, COMPONENT_STAGE },
    TP_STAGE_LIST(X)
#undef X
#define X(x) { #x, COMPONENT_WATER },
        TP_WATER_LIST(X)
#undef X
#define X(x) { #x, COMPONENT_DRAW },
            TP_DRAW_LIST(X)
#undef X
#define X(x) { #x, COMPONENT_METHOD },
                TP_METHOD_LIST(X)
#undef X
#define MODULE(x) { #x, COMPONENT_MODULE }, { #x, COMPONENT_DRAWING }, TP_STAGES_OF_##x(X)
#define UNSEEN(x) { #x, COMPONENT_MODULE },
#define X(x) { #x, COMPONENT_MODULE_STAGE },
    TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef X
#undef UNSEEN
#undef MODULE
};

const size_t component_count = sizeof components / sizeof *components;
_Static_assert(sizeof components / sizeof *components <= COMPONENTS_MOST,
               "a set holds all pieces");

/* The code of a component: a stage, a pointer in a program with its offset there, or a
 * use. */
typedef struct {
    tp_stage    stage, watched;
    const void *part;
    size_t      offset;
    tp_use      use;
    tp_lack     lack;
} meaning;

/* -- watched stages ------------------------------------------------------------------ */

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

void components_forget(void)
{
    for (size_t i = 0; i < RAN_COUNT; i++)
        atomic_store(&ran[i], false);
}

/* The array `ran` holds stages in the order of the rows. */
bool components_have_run(size_t i)
{
    size_t at = 0;
    for (size_t k = 0; k < i; k++)
        at += component_is_stage(k);
    return component_is_stage(i) && atomic_load(&ran[at]);
}

/* -- a list -------------------------------------------------------------------------- */

/* Sets a program's member at its offset; all pointers to parts have the same size. */
static void put(tp_program *program, const meaning *m, tp_stage stage)
{
    char *at = (char *)program + m->offset;
    if (stage)
        memcpy(at, &stage, sizeof stage);
    else
        memcpy(at, &m->part, sizeof m->part);
}

static void make(component_list *to, const component_set *of,
                 const component_terms *terms, bool watch)
{
    tp_use   *use = NULL, *end = to->use;
    tp_stage *stage = to->stage;

    memset(to, 0, sizeof *to);
    for (size_t i = 0; i < component_count; i++) {
        const meaning *m = &meanings[i];
        const bool in = of->has[i];
        const tp_stage by = !in ? NULL : watch ? m->watched : m->stage;
        if (components[i].kind == COMPONENT_MODULE)
            use = in ? end++ : NULL;
        if (components[i].kind == COMPONENT_MODULE && in)
            *use = (tp_use){ .module = m->use.module };
        else if (components[i].kind == COMPONENT_DRAWING && use)
            *use = (tp_use){ use->module, in ? m->use.drawing : NULL, stage, NULL };
        else if (components[i].kind == COMPONENT_MODULE_STAGE)
            *stage++ = by;
        else if (components[i].kind < COMPONENT_MODULE && in)
            put(&to->program, m, by);
    }
    to->program.modules = to->use;
    to->program.check = terms->checks ? tp_scene_check : NULL;
    to->program.steering = terms->steers ? &tp_world_steering : NULL;
    to->program.store[terms->format] = tp_program_all.store[terms->format];
    if (terms->streams && to->program.method.triangles)
        to->program.method.triangles = &tp_method_streamed;
    if (terms->streams && to->program.method.walk)
        to->program.method.walk = &tp_method_streamed_walk;
    if (terms->few && to->program.water.swells)
        to->program.water.swells = &tp_water_few_swells;
}

void components_list(component_list *to, const component_set *of,
                     const component_terms *terms)
{
    make(to, of, terms, false);
}

void components_list_traced(component_list *to, const component_set *of,
                            const component_terms *terms)
{
    make(to, of, terms, true);
}

/* Returns the number of the set's modules before a component. */
static uint32_t count_earlier_modules(const component_set *of, size_t i)
{
    uint32_t above = 0;
    for (size_t k = 0; k < i; k++)
        above += components[k].kind == COMPONENT_MODULE && of->has[k];
    return above;
}

bool component_is_active(size_t i, const component_set *of, const component_terms *terms,
                         const tp_scene *scene, const tp_assets *assets)
{
    component_set others = *of;
    component_list list;
    tp_lack lacks[2] = { meanings[i].lack };

    others.has[i] = false;
    lacks[0].above = count_earlier_modules(&others, i);
    components_list(&list, &others, terms);
    list.program.lacks = lacks;
    list.program.refuse = tp_lacks_check;
    return tp_program_check_all(&list.program, scene, assets, NULL) == TP_E_PROGRAM;
}

/* -- names --------------------------------------------------------------------------- */

bool components_add_named(component_set *to, const char *name, size_t length)
{
    bool found = false, within = false;

    for (size_t i = 0; i < component_count; i++) {
        const bool same = strlen(components[i].name) == length
                          && memcmp(components[i].name, name, length) == 0;
        const bool inner = components[i].kind > COMPONENT_MODULE;
        if (!inner)
            within = same && components[i].kind == COMPONENT_MODULE;
        if (same || (inner && within))
            to->has[i] = found = true;
    }
    return found;
}

static bool is_named(size_t i, component_kind kind, const char *name)
{
    return components[i].kind == kind && strcmp(components[i].name, name) == 0;
}

void components_add_models(component_set *set)
{
    static const struct { const char *module, *model; } needs[] = {
        { "drops", "rings" }, { "main_pool", "pools" }, { "field", "pools" },
        { "coastal", "coastal" }, { "coastal", "swells" },
        { "hull", "samples" }, { "drops", "samples" }, { "underwater", "samples" },
        { "caustics", "samples" }, { "spray", "samples" },
    };

    for (size_t n = 0; n < sizeof needs / sizeof *needs; n++) {
        bool asked = false;
        for (size_t i = 0; i < component_count; i++)
            asked |= set->has[i] && is_named(i, COMPONENT_MODULE, needs[n].module);
        for (size_t i = 0; i < component_count && asked; i++)
            set->has[i] |= is_named(i, COMPONENT_WATER, needs[n].model);
    }
}

bool component_is_in_world(size_t i)
{
    return components[i].kind == COMPONENT_WATER || components[i].kind == COMPONENT_MODULE;
}

bool component_moves(size_t i)
{
    const tp_module *module = meanings[i].use.module;

    return components[i].kind == COMPONENT_WATER
           || (components[i].kind == COMPONENT_MODULE
               && (module->bytes || module->init || module->settle || module->step));
}

component_set components_without(const component_set *out)
{
    component_set all = { .has = { false } };
    for (size_t i = 0; i < component_count; i++)
        all.has[i] = !out->has[i];
    return all;
}

const char *component_kind_name(size_t i)
{
    static const char *const word[] = {
        [COMPONENT_STAGE] = "stage", [COMPONENT_WATER] = "water", [COMPONENT_DRAW] = "draw",
        [COMPONENT_METHOD] = "method", [COMPONENT_MODULE] = "module",
        [COMPONENT_DRAWING] = "drawing", [COMPONENT_MODULE_STAGE] = "stage",
    };
    return word[components[i].kind];
}

/* -- as text ------------------------------------------------------------------------- */

static const char *piece_symbol(size_t i, const component_terms *terms)
{
    const char *name = components[i].name;
    if (is_named(i, COMPONENT_METHOD, "triangles") && terms->streams)
        return "streamed";
    if (is_named(i, COMPONENT_METHOD, "walk") && terms->streams)
        return "streamed_walk";
    if (is_named(i, COMPONENT_WATER, "swells") && terms->few)
        return terms->world && !terms->steers ? "baked_swells" : "few_swells";
    return name;
}

void component_symbol(size_t i, const component_terms *terms, char *symbol, size_t bytes)
{
    const component_kind kind = components[i].kind;
    if (kind == COMPONENT_MODULE || kind == COMPONENT_DRAWING)
        snprintf(symbol, bytes, "tp_%s_%s", components[i].name, component_kind_name(i));
    else
        snprintf(symbol, bytes, "tp_%s_%s", component_kind_name(i), piece_symbol(i, terms));
}

/* Writes "    .water = { .swells = &tp_water_swells }," or nothing. */
static void write_kind(FILE *out, const component_set *of, const component_terms *terms,
                       component_kind kind)
{
    const char *before = " ";
    for (size_t i = 0, n = 0; i < component_count; i++) {
        char symbol[64];
        if (components[i].kind != kind || !of->has[i])
            continue;
        if (n++ == 0)
            fprintf(out, "    .%s = {", component_kind_name(i));
        component_symbol(i, terms, symbol, sizeof symbol);
        fprintf(out, "%s\n        .%s = %s%s", n > 1 ? "," : "", components[i].name,
                kind == COMPONENT_STAGE ? "" : "&", symbol);
        before = "\n    },\n";
    }
    if (*before == '\n')
        fputs(before, out);
}

/* Writes the tables of stages.  A table has an entry for each stage of the module, 0 for a
 * missing stage. */
static void write_tables(FILE *out, const char *name, const component_set *of)
{
    for (size_t i = 0; i < component_count; i++) {
        if (components[i].kind != COMPONENT_DRAWING || !of->has[i])
            continue;
        fprintf(out, "static const tp_stage %s_%s_stages[] = {\n", name,
                components[i].name);
        size_t k = i + 1;
        for (; k < component_count && components[k].kind == COMPONENT_MODULE_STAGE; k++)
            if (of->has[k])
                fprintf(out, "    tp_stage_%s,\n", components[k].name);
            else
                fprintf(out, "    0,\n");
        fprintf(out, "%s};\n", k == i + 1 ? "    0\n" : "");
    }
}

static void write_uses(FILE *out, const char *name, const component_set *of)
{
    fprintf(out, "static const tp_use %s_modules[] = {\n", name);
    for (size_t i = 0; i < component_count; i++) {
        if (components[i].kind != COMPONENT_MODULE || !of->has[i])
            continue;
        const char *module = components[i].name;
        if (i + 1 < component_count && components[i + 1].kind == COMPONENT_DRAWING
            && of->has[i + 1])
            fprintf(out, "    { &tp_%s_module, &tp_%s_drawing, %s_%s_stages, 0 },\n",
                    module, module, name, module);
        else
            fprintf(out, "    { &tp_%s_module, 0, 0, 0 },\n", module);
    }
    fprintf(out, "    { 0, 0, 0, 0 }\n};\n");
}

/* Writes the list of missing modules; false: no module is missing, and no list is
 * written. */
static bool write_lacks(FILE *out, const char *name, const component_set *of,
                        const component_set *lacks)
{
    uint32_t written = 0;
    for (size_t i = 0; i < component_count; i++)
        if (components[i].kind == COMPONENT_MODULE && lacks->has[i]) {
            if (written++ == 0)
                fprintf(out, "static const tp_lack %s_lacks[] = {\n", name);
            fprintf(out, "    { \"%s\", tp_%s_enabled, %" PRIu32 " },\n",
                    components[i].name, components[i].name, count_earlier_modules(of, i));
        }
    if (written > 0)
        fprintf(out, "    { 0, 0, 0 }\n};\n");
    return written > 0;
}

void components_write(FILE *out, const char *name, const component_set *of,
                      const component_set *lacks, const component_terms *terms)
{
    static const char *const word[] = {
#define X(name, word, bits, text)                                                        \
    [TP_FORMAT_##name] = "[TP_FORMAT_" #name "] = tp_store_" #word,
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
    if (terms->steers)
        fprintf(out, "    .steering = &tp_world_steering,\n");
    for (int kind = COMPONENT_STAGE; kind < COMPONENT_MODULE; kind++)
        write_kind(out, of, terms, (component_kind)kind);
    if (refuses)
        fprintf(out, "    .refuse = tp_lacks_check,\n    .lacks = %s_lacks,\n", name);
    if (terms->world)
        fprintf(out, "    .world = &%s_world,\n", name);
    fprintf(out, "    .store = { %s },\n    .modules = %s_modules\n};\n",
            word[terms->format], name);
}
