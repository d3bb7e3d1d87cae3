/* SPDX-License-Identifier: MIT */
#include "flash.h"
#include <stdlib.h>
#include <string.h>
#include "bake_assets.h"
#include "bake_program.h"

/* -- code ---------------------------------------------------------------------------- */

/* The bytes that a program links if it has one of some pieces, "base" in every program. */
static const struct {
    uint32_t bytes;
    const char *pieces;
} parts[] = {
#include "code_sizes.inc"
};

/* True if a list of words has a word. */
static bool has_word(const char *list, const char *word)
{
    const size_t length = strlen(word);

    for (const char *at = list; (at = strstr(at, word)); at += length)
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == 0))
            return true;
    return false;
}

size_t flash_code_bytes(const component_set *of, const component_terms *terms)
{
    size_t sum = 0;

    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
        bool in = strcmp(parts[k].pieces, "base") == 0;
        for (size_t i = 0; i < component_count && !in; i++) {
            char symbol[64];
            if (!of->has[i])
                continue;
            component_symbol(i, terms, symbol, sizeof symbol);
            in = has_word(parts[k].pieces, symbol);
        }
        sum += in ? parts[k].bytes : 0;
    }
    return sum;
}

/* -- tables of the scene ------------------------------------------------------------- */

/* Bytes of structs on a machine of 32 bits, where pointers take 4. */
enum {
    POINTER = 4,
    TEXTURE = TP_TEXTURE_LEVELS * POINTER + 4,
    GREY = 8 + POINTER,
    MATERIAL = 6 * 4 + 2 * POINTER,
    MESH = 6 * POINTER + 2 * 12 + 4,
    SCENE = offsetof(tp_scene, pictures) + POINTER,
    CONFIG = 5 * 4 + 2 * POINTER + 3 * POINTER + 4,
    ASSETS = sizeof(tp_assets) / sizeof(void *) * POINTER,
    TABLES = 2 * TP_TABLE_COUNT * POINTER,
    PROGRAM = sizeof(tp_program) / sizeof(void *) * POINTER,
    USE = sizeof(tp_use) / sizeof(void *) * POINTER,
};

static size_t assets_bytes(const bake *b, const tp_assets *names)
{
    size_t sum = SCENE + ASSETS;

    for (uint32_t i = 0; i < b->n_pictures; i++)
        sum += TEXTURE + bake_texture_bytes(b->pictures[i].texture);
    for (int i = 0; i < BAKE_GREYS; i++)
        if (bake_nth_grey(names, i))
            sum += GREY + (bake_grey_bytes(bake_nth_grey(names, i)) + 3) / 4 * 4;
    if (names->boat)
        sum += MESH + bake_mesh_bytes(names->boat) + names->boat->n_materials * MATERIAL;
    return sum;
}

/* Returns the bytes of a list's own tables: of modules, and of the stages of each. */
static size_t list_bytes(const component_set *of)
{
    size_t sum = CONFIG + POINTER + PROGRAM + USE;

    for (size_t i = 0; i < component_count; i++) {
        size_t stages = 0;
        if (components[i].kind == COMPONENT_MODULE && of->has[i])
            sum += USE;
        if (components[i].kind != COMPONENT_DRAWING || !of->has[i])
            continue;
        for (size_t k = i + 1; k < component_count
                               && components[k].kind == COMPONENT_MODULE_STAGE; k++)
            stages++;
        sum += (stages ? stages : 1) * POINTER;
    }
    return sum;
}

/* -- the estimate -------------------------------------------------------------------- */

/* Returns the options by which bake would find the list, but for small pictures: the lists of
 * 96 columns were those of 320 in 30 steps of the shipped scenes. */
static options options_for_search(const options *o)
{
    enum { COLUMNS = 96, ROWS_LEAST = 16 };
    options small = *o;

    small.format = TP_FORMAT_RGB565;
    small.no_input = true;
    small.with = small.without = NULL;
    if (o->width > COLUMNS) {
        small.width = COLUMNS;
        small.height = o->height * COLUMNS / o->width;
        small.height = small.height < ROWS_LEAST ? ROWS_LEAST : small.height;
    }
    return small;
}

int flash_estimate(size_t *bytes, const loaded_scene *s, const options *o,
                   component_search_worlds *worlds)
{
    const options small = options_for_search(o);
    const tp_assets *all = &s->assets.names;
    tp_assets names = *all;
    void *memory[TP_BAKED_LAYERS] = { NULL };
    tp_texture made[TP_BAKED_LAYERS];
    bake b = { .name = "" };
    bake_program program = { .scene = s->file.scene };
    int code = bake_prepare(&names, &s->file.scene, o, memory, made);

    code = code ? code : bake_find_program(&program, &small, &s->file.scene, all, &names,
                                            worlds);
    code = code ? code : bake_list_pictures(&b, &names);
    if (!code)
        *bytes = flash_code_bytes(&program.found.in, &program.request.terms)
               + list_bytes(&program.found.in) + assets_bytes(&b, &names)
               + (names.tables ? TABLES + bake_tables_bytes(&program.tables) : 0);
    bake_close_program(&program);
    free(b.pictures);
    for (int i = 0; i < TP_BAKED_LAYERS; i++)
        free(memory[i]);
    return code;
}
