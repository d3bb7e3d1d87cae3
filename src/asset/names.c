/* SPDX-License-Identifier: MIT */
/* Sets of names: asset/names.h.  The set is a hash table with open addressing, at most
 * two thirds full.  The hash begins with the digest of the file: nobody can choose
 * names that collide. */
#include "asset/names.h"
#include "asset/table.h"
#include "base/base.h"

void tp_names_layout(tp_obj_names *names, tp_arena *arena, uint32_t most, uint32_t room)
{
    names->most = most;
    names->room = room;
    names->mask = tp_table_size(most) - 1;
    names->start = tp_arena_alloc(arena, most, sizeof *names->start);
    names->tag = tp_arena_alloc(arena, most, sizeof *names->tag);
    names->line = tp_arena_alloc(arena, most, sizeof *names->line);
    names->table = tp_arena_alloc(arena, (size_t)names->mask + 1, sizeof *names->table);
    names->text = tp_arena_alloc(arena, room, 1);
}

void tp_names_clear(tp_obj_names *names)
{
    names->count = names->used = 0;
    memset(names->table, 0, ((size_t)names->mask + 1) * sizeof *names->table);
}

static bool is_same_name(const tp_obj_names *names, uint32_t i, tp_word word, uint32_t tag)
{
    const char *const text = tp_names_text(names, i);
    const uint32_t next = i + 1 < names->count ? names->start[i + 1] : names->used;
    return names->tag[i] == tag && next - names->start[i] == word.bytes + 1
        && memcmp(text, word.text, word.bytes) == 0;
}

/* Returns the slot of the table with the name, or the free slot for the name. */
static uint32_t *find_slot(const tp_obj_names *names, tp_word word, uint32_t tag,
                           uint64_t seed)
{
    uint64_t hash = tp_mix(seed, tag);
    for (uint32_t i = 0; i < word.bytes; i++)
        hash = tp_mix(hash, (unsigned char)word.text[i]);
    uint32_t at = (uint32_t)hash & names->mask;
    while (names->table[at] != 0 && !is_same_name(names, names->table[at] - 1, word, tag))
        at = (at + 1) & names->mask;
    return &names->table[at];
}

uint32_t tp_names_find(const tp_obj_names *names, tp_word word, uint32_t tag,
                       uint64_t seed)
{
    const uint32_t number = *find_slot(names, word, tag, seed);
    return number != 0 ? number - 1 : TP_NO_NAME;
}

uint32_t tp_names_add(tp_obj_names *names, tp_word word, uint32_t tag, uint32_t line,
                      uint64_t seed)
{
    TP_ASSERT(names->used <= names->room && names->count <= names->most);
    uint32_t *const place = find_slot(names, word, tag, seed);
    if (*place != 0)
        return *place - 1;
    if (names->count == names->most || word.bytes >= names->room - names->used)
        return TP_NO_NAME;
    const uint32_t i = names->count++;
    names->start[i] = names->used;
    names->tag[i] = tag;
    names->line[i] = line;
    memcpy(names->text + names->used, word.text, word.bytes);
    names->text[names->used + word.bytes] = '\0';
    names->used += word.bytes + 1;
    *place = i + 1;
    return i;
}
