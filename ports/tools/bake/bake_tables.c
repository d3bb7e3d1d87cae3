/* SPDX-License-Identifier: MIT */
#include "bake_tables.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "frame/frame.h"

enum { MOMENTS = 24, EVERY = 40 };      /* ticks between moments: 16 s in all */

static const struct {
    const char *name, *type;
    uint32_t    numbers, size, bytes;   /* bytes of an entry: here; on 32 bits */
} kinds[TP_TABLE_COUNT] = {
#define BYTES_uint32_t   4
#define BYTES_int32_t    4
#define BYTES_tp_entry16 2
#define BYTES_tp_entry8  1
#define X(name, numbers, type) { #name, #type, numbers, sizeof(type), BYTES_##type },
    TP_TABLE_LIST(X)
#undef X
};

/* -- making -------------------------------------------------------------------------- */

/* Keeps a table: its numbers, then its entries.  Returns false without memory. */
static bool keep(bake_tables *to, int id, tp_table table, size_t bytes)
{
    const size_t numbers = kinds[id].numbers * sizeof(int32_t);
    char *memory = malloc(numbers + bytes);

    if (!memory)
        return false;
    memcpy(memory, table.made_of, numbers);
    memcpy(memory + numbers, table.entries, bytes);
    to->tables.table[id] = (tp_table){ memory + numbers, (const int32_t *)(void *)memory };
    to->bytes[id] = bytes;
    return true;
}

static void drop(bake_tables *t, int id)
{
    free((void *)(uintptr_t)t->tables.table[id].made_of);
    t->tables.table[id] = (tp_table){ NULL, NULL };
    t->bytes[id] = 0;
}

/* Returns the table of the grid's rows in memory of the caller, who frees entries. */
static tp_table rows_table(const tp_frame *frame, int32_t numbers[TP_ROWS_NUMBERS],
                           size_t *bytes)
{
    const tp_grid *grid = frame->buffers.grid;
    const uint32_t words = TP_FRAME_ROWS_WORDS(grid ? grid->rows : 0);
    int32_t *entries = calloc(words, sizeof *entries);
    uint32_t count = 0;

    if (entries)
        tp_frame_pack_rows(frame, numbers, entries, &count);
    *bytes = count * sizeof *entries;
    if (count > 0)
        return (tp_table){ entries, numbers };
    free(entries);
    return (tp_table){ NULL, numbers };
}

/* Keeps the tables of the first moment, and drops those that a later moment changes. */
static bool add_moment(bake_tables *to, const tp_frame *frame, uint32_t moment, bool acts)
{
    bool kept = true;

    for (int id = 0; id < TP_TABLE_COUNT; id++) {
        const bool rows = id == TP_TABLE_rows, seen = rows || id == TP_TABLE_light;
        int32_t numbers[TP_ROWS_NUMBERS];
        size_t bytes;
        const tp_table table = rows ? rows_table(frame, numbers, &bytes)
                             : tp_frame_own_table(frame, (tp_table_id)id, &bytes);
        const tp_table *first = &to->tables.table[id];
        if (moment == 0 && table.entries && !(acts && seen))
            kept &= keep(to, id, table, bytes);
        else if (first->entries && (rows || table.entries)
                 && (!table.entries
                     || memcmp(first->made_of, table.made_of,
                               kinds[id].numbers * sizeof(int32_t)) != 0))
            drop(to, id);
        if (rows)
            free((void *)(uintptr_t)table.entries);
    }
    return kept;
}

static bool run(bake_tables *to, tp_frame *frame, tp_world *world, const tp_scene *scene,
                bool acts)
{
    for (uint32_t moment = 0; moment < MOMENTS; moment++) {
        for (uint32_t n = 0; moment && n < EVERY; n++)
            tp_world_step(&tp_program_all, world, scene, NULL);
        tp_frame_begin(frame, world);
        if (!add_moment(to, frame, moment, acts))
            return false;
    }
    return true;
}

int bake_tables_make(bake_tables *to, const tp_scene *scene, const tp_assets *assets,
                     const tp_config *config, bool acts)
{
    tp_config c = *config;
    tp_frame *frame;
    tp_error err = { 0 };

    *to = (bake_tables){ .bytes = { 0 } };
    c.program = &tp_program_all;
    c.assets = assets;
    const size_t bytes = tp_frame_bytes(&c, scene);
    const size_t world_bytes = tp_world_bytes(&tp_program_all, scene, assets);
    void *block = malloc(bytes + 1);
    tp_world *world = malloc(world_bytes + 1);
    int code = EXIT_DONE;
    if (!block || !world)
        code = log_fail_memory(bytes + world_bytes);
    else if (tp_frame_init(&frame, &c, scene, block, bytes, &err) != TP_OK
             || tp_world_init(&tp_program_all, world, world_bytes, scene, assets, &err)
                    != TP_OK)
        code = log_fail_error("tidepool bake", &err);
    else if (!run(to, frame, world, scene, acts))
        code = log_fail_memory(bytes);
    free(block);
    free(world);
    return code;
}

void bake_tables_free(bake_tables *t)
{
    for (int id = 0; id < TP_TABLE_COUNT; id++)
        drop(t, id);
}

/* -- as text ------------------------------------------------------------------------- */

static uint32_t nth_entry(const bake_tables *t, int id, size_t i)
{
    const unsigned char *at = t->tables.table[id].entries;
    uint32_t word = 0;

    if (kinds[id].size == 4)
        memcpy(&word, at + 4 * i, 4);
    else if (kinds[id].size == 2)
        word = (uint32_t)((const uint16_t *)(const void *)at)[i];
    else
        word = at[i];
    return word;
}

static size_t entry_count(const bake_tables *t, int id)
{
    return t->bytes[id] / kinds[id].size;
}

static void write_table(FILE *out, const char *name, const bake_tables *t, int id)
{
    const int32_t *made_of = t->tables.table[id].made_of;

    fprintf(out, "\nstatic const int32_t %s_%s_of[%" PRIu32 "] = {", name, kinds[id].name,
            kinds[id].numbers);
    for (uint32_t i = 0; i < kinds[id].numbers; i++)
        fprintf(out, "%s%" PRId32 ",", i % 6 ? " " : "\n    ", made_of[i]);
    fprintf(out, "\n};\nstatic const %s %s_%s[%zu] = {", kinds[id].type, name,
            kinds[id].name, entry_count(t, id));
    for (size_t i = 0; i < entry_count(t, id); i++)
        fprintf(out, id == TP_TABLE_rows ? "%s%" PRId32 "," : "%s0x%" PRIx32 ",",
                i % 8 ? "" : "\n    ", nth_entry(t, id, i));
    fprintf(out, "\n};\n");
}

void bake_tables_write(FILE *out, const char *name, const bake_tables *t)
{
    for (int id = 0; id < TP_TABLE_COUNT; id++)
        if (t->tables.table[id].entries)
            write_table(out, name, t, id);
    fprintf(out, "static const tp_tables %s_tables = { {", name);
    for (int id = 0; id < TP_TABLE_COUNT; id++)
        if (t->tables.table[id].entries)
            fprintf(out, "\n    [TP_TABLE_%s] = { %s_%s, %s_%s_of },", kinds[id].name, name,
                    kinds[id].name, name, kinds[id].name);
    fprintf(out, "\n} };\n");
}

size_t bake_tables_bytes(const bake_tables *t)
{
    size_t sum = 0;

    for (int id = 0; id < TP_TABLE_COUNT; id++)
        if (t->tables.table[id].entries)
            sum += kinds[id].numbers * sizeof(int32_t)
                 + (entry_count(t, id) * kinds[id].bytes + 3) / 4 * 4;
    return sum;
}
