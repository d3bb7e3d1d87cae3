/* SPDX-License-Identifier: MIT */
#include "program_links.h"
#include <stdio.h>
#include <string.h>
#include "pixel/pixel.h"

/* -- measured tables ----------------------------------------------------------------- */

/* Code and constants that a program links if it has one of some pieces, "base" in every
 * program. */
static const struct {
    uint32_t code, constants;
    const char *pieces;
} links[] = {
#include "code_sizes.inc"
};

/* Stack of a chain of calls; a program has the chain if it has a piece of each group.  In
 * every program the stack is that of the first line. */
static const struct {
    uint32_t bytes;
    const char *groups;         /* apart by '&' */
} chains[] = {
#include "stack_sizes.inc"
};

/* -- the pieces of a program --------------------------------------------------------- */

typedef struct {
    char name[COMPONENTS_MOST + 4][64];
    size_t count;
} symbols;

static void add_symbol(symbols *to, const char *name)
{
    snprintf(to->name[to->count++], sizeof *to->name, "%s", name);
}

static void list_symbols(symbols *to, const component_search_result *found,
                         const component_terms *terms)
{
    static const char *const store[] = {
#define X(name, word, bits, text) [TP_FORMAT_##name] = "tp_store_" #word,
        TP_FORMAT_LIST(X)
#undef X
    };

    to->count = 0;
    add_symbol(to, "base");
    add_symbol(to, store[terms->format]);
    if (terms->checks)
        add_symbol(to, "tp_scene_check");
    if (terms->steers)
        add_symbol(to, "tp_world_steering");
    if (!terms->world)
        add_symbol(to, "tp_world_init");
    for (size_t i = 0; i < component_count; i++)
        if (found->in.has[i])
            component_symbol(i, terms, to->name[to->count++], sizeof *to->name);
}

/* True if one of the words of a text is a symbol. */
static bool has_symbol(const symbols *all, const char *words, size_t bytes)
{
    for (size_t length; bytes; words += length, bytes -= length) {
        length = strcspn(words, " &");
        length = length < bytes ? length : bytes;
        for (size_t i = 0; i < all->count; i++)
            if (strncmp(all->name[i], words, length) == 0 && !all->name[i][length])
                return true;
        length += length < bytes;
    }
    return false;
}

/* True if each group of a chain has a symbol. */
static bool has_chain(const symbols *all, const char *groups)
{
    for (size_t bytes; *groups; groups += bytes + (groups[bytes] == '&')) {
        bytes = strcspn(groups, "&");
        if (!has_symbol(all, groups, bytes))
            return false;
    }
    return true;
}

void program_links_add(program_memory *m, const component_search_result *found,
                       const component_terms *terms)
{
    symbols named, *all = &named;

    list_symbols(all, found, terms);
    for (size_t i = 0; i < sizeof links / sizeof *links; i++)
        if (has_symbol(all, links[i].pieces, strlen(links[i].pieces))) {
            m->code += links[i].code;
            m->constants += links[i].constants;
        }
    for (size_t i = 0; i < sizeof chains / sizeof *chains; i++)
        if (chains[i].bytes > m->stack && has_chain(all, chains[i].groups))
            m->stack = chains[i].bytes;
}
