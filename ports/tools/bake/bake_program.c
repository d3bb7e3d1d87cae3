/* SPDX-License-Identifier: MIT */
#include "bake_program.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "pixel/pixel.h"

#include "app/files/did_you_mean.h"
#include "app/files/log.h"

/* -- the options --------------------------------------------------------------------- */

bool bake_has_program(const options *o)
{
    return o->sized || o->formatted;
}

int bake_check_options(const options *o)
{
    const char *of = o->with ? "--with" : o->without ? "--without" : o->no_input
                   ? "--no-input" : o->kept ? "--kept" : o->stream ? "--stream" : o->band ? "--band"
                   : o->strip ? "--strip" : NULL;
    if (!of || bake_has_program(o))
        return EXIT_DONE;
    return log_fail(EXIT_USAGE, "tidepool bake: %s is an option of the program: add --size"
                " or --format", of);
}

static int refuse_piece(const char *option, const char *name, size_t length)
{
    char word[64];
    snprintf(word, sizeof word, "%.*s", (int)(length < 60 ? length : 60), name);
    did_you_mean best = did_you_mean_make(word);
    for (size_t i = 0; i < component_count; i++)
        did_you_mean_offer(&best, components[i].name);
    if (!best.name)
        return log_fail(EXIT_USAGE, "tidepool bake: %s %s: no such module", option, word);
    return log_fail(EXIT_USAGE, "tidepool bake: %s %s: no such module; did you mean %s?",
                    option, word, best.name);
}

/* Reads a list of components, as "drops,boat". */
static int read_pieces(component_set *to, const char *option, const char *list)
{
    for (const char *c = list; c && *c; ) {
        const size_t length = strcspn(c, ",");
        if (!components_add_named(to, c, length))
            return refuse_piece(option, c, length);
        c += length + (c[length] == ',');
    }
    return EXIT_DONE;
}

static int check_pieces(const component_search_request *request)
{
    for (size_t i = 0; i < component_count; i++)
        if (request->with.has[i] && request->without.has[i])
            return log_fail(EXIT_USAGE, "tidepool bake: %s is in both --with and --without",
                        components[i].name);
    return EXIT_DONE;
}

/* -- the list ------------------------------------------------------------------------ */

static bool worlds_begin_same(const tp_scene *scene, const tp_assets *a, const tp_assets *b)
{
    const size_t bytes = tp_world_bytes(&tp_program_all, scene, a);
    tp_world *one = calloc(1, bytes + 1), *other = calloc(1, bytes + 1);
    const bool same =
        one && other && tp_world_bytes(&tp_program_all, scene, b) == bytes
        && tp_world_init(&tp_program_all, one, bytes, scene, a, NULL) == TP_OK
        && tp_world_init(&tp_program_all, other, bytes, scene, b, NULL) == TP_OK
        && memcmp(one, other, bytes) == 0;

    free(one);
    free(other);
    return same;
}

/* Returns the assets with baked layers, without the textures from which the layers are
 * made.  A meter reads the first layer: the world's layers stay. */
static tp_assets prepared_alone(const tp_scene *scene, const tp_assets *names)
{
    tp_assets lean = *names;
    for (int i = 0; i < TP_LAYERS; i++)
        if (lean.baked_layer[i])
            lean.layer[i] = NULL;
    if (lean.baked_offset)
        lean.distortion = NULL;
    if (lean.baked_slope)
        lean.ripple = NULL;
    if (!worlds_begin_same(scene, names, &lean))
        memcpy(lean.layer, names->layer, sizeof lean.layer);
    return lean;
}

/* Searches with the reduced assets, and uses them if they suffice. */
static int search_lean(bake_program *p, tp_assets *baked, const tp_tables *tables)
{
    tp_assets lean = prepared_alone(&p->scene, baked);

    lean.tables = tables;
    p->request.lean = &lean;
    const int code = component_search_run(&p->found, &p->request);
    p->request.lean = NULL;
    if (!code && p->found.lean)
        *baked = lean;
    return code;
}

/* Searches with baked tables first.  Scenes that may change make their own. */
static int search(bake_program *p, tp_assets *baked)
{
    const component_search_request *request = &p->request;

    if (request->terms.checks)
        return search_lean(p, baked, NULL);
    int code = bake_tables_make(&p->tables, &p->scene, baked, &request->config,
                                request->acts);
    if (!code)
        code = search_lean(p, baked, &p->tables.tables);
    if (code || p->found.lean)
        return code;
    bake_tables_free(&p->tables);
    return search_lean(p, baked, NULL);
}

/* Prints each component that the scene asks for and the program lacks, by name, once. */
static int tell_lacks(const component_search_result *found, bool strict)
{
    const char *last = "";

    for (size_t i = 0; i < component_count; i++) {
        if (!found->lacks.has[i] || !strcmp(components[i].name, last))
            continue;
        last = components[i].name;
        log_line("left out, but the scene uses it: %s %s", component_kind_name(i), last);
    }
    return strict && *last
               ? log_fail(EXIT_CHECK, "tidepool bake: the program would draw"
                                      " another picture than one with every module")
               : EXIT_DONE;
}

int bake_find_program(bake_program *p, const options *o, const tp_scene *scene,
                      const tp_assets *assets, tp_assets *baked,
                      component_search_worlds *worlds)
{
    component_search_request *request = &p->request;

    *p = (bake_program){ .scene = *scene };
    *request = (component_search_request){
        .scene = scene,
        .assets = assets,
        .baked = baked,
        .config = { .width = o->width,
                    .height = o->height,
                    .tile_width = o->strip,
                    .tile_height = o->band ? o->band : 16,
                    .format = o->format,
                    .kept_bytes = o->kept },
        /* With --with, scenes can switch on more at run time: scenes are checked, and the
         * program has room for waves beyond the scene's own. */
        .terms = { .format = o->format, .streams = o->stream, .few = !o->with,
                   .checks = o->with != NULL, .steers = !o->no_input },
        .acts = !o->no_input,
        .worlds = worlds,
    };
    int code = read_pieces(&request->with, "--with", o->with);
    if (!code)
        code = read_pieces(&request->without, "--without", o->without);
    components_add_models(&request->with);
    if (!code)
        code = check_pieces(request);
    if (code)
        return code;
    code = search(p, baked);
    return code ? code : tell_lacks(&p->found, o->strict);
}

void bake_close_program(bake_program *p)
{
    bake_tables_free(&p->tables);
}

/* -- the file ------------------------------------------------------------------------ */

/* Prints the components of a set under a heading; for an empty set prints nothing. */
static void put_set(FILE *out, const char *heading, const component_set *set)
{
    const char *before = "";
    size_t column = 0;

    for (size_t i = 0; i < component_count; i++) {
        if (!set->has[i] || components[i].kind == COMPONENT_DRAWING)
            continue;
        if (!*before)
            fprintf(out, "\n * %s:", heading);
        const bool begins = i == 0 || strcmp(component_kind_name(i), before) != 0;
        const size_t bytes = strlen(components[i].name) + 1;
        if (begins || column + bytes > 70) {
            fprintf(out, "\n *     %-6s", begins ? component_kind_name(i) : "");
            column = 0;
        }
        fprintf(out, " %s", components[i].name);
        before = component_kind_name(i);
        column += bytes;
    }
}

void bake_put_pieces(const bake_program *p, FILE *out)
{
    const tp_config *c = &p->request.config;

    fprintf(out,
            " *\n * %" PRIu32 "x%" PRIu32 " %s: %" PRIu32 " pictures are those of the"
            " whole list.",
            c->width, c->height, tp_format_name(c->format), p->found.pictures);
    put_set(out, "Modules of the program", &p->found.in);
    put_set(out, "Refused by name if the scene switches it on", &p->found.refused);
    fprintf(out, "\n");
}

void bake_put_program(const bake_program *p, FILE *out, const char *name, bool world)
{
    tp_config filled, *c = &filled;
    static const char *const format[] = {
#define X(name, word, bits, text) [TP_FORMAT_##name] = "TP_FORMAT_" #name,
        TP_FORMAT_LIST(X)
#undef X
    };

    component_terms terms = p->request.terms;
    tp_config_check(&p->request.config, c, NULL);
    terms.world = world;
    components_write(out, name, &p->found.in, &p->found.refused, &terms);
    fprintf(out,
            "\nextern const tp_config %s_config;\nconst tp_config %s_config = {\n"
            "    .width = %" PRIu32 ", .height = %" PRIu32 ", .tile_width = %" PRIu32
            ", .tile_height = %" PRIu32 ",\n    .format = %s, .program = &%s_program, "
            ".assets = &%s_assets,\n    .kept_bytes = %" PRIu32 "\n};\n",
            name, name, c->width, c->height, c->tile_width, c->tile_height,
            format[c->format], name, name, c->kept_bytes);
    fprintf(out,
            "\n/* The default program, unless another file defines it. */\n"
            "#ifdef __GNUC__\n__attribute__((weak))\n#endif\n"
            "const tp_program *const tp_program_linked = &%s_program;\n",
            name);
}
