/* SPDX-License-Identifier: MIT */
/* Fuzzes tables as read by `check --vectors`. The first byte selects the model of the
 * table. An accepted table reads back the same, then the model runs on the table. */
#include "fuzz.h"
#include "tools/check/check.h"
#include "app/cli/commands.h"

#define X(name) #name,
static const char *const models[] = { CHECK_MODELS(X) };
#undef X

enum { MODELS = sizeof models / sizeof *models };

/* -- the table --------------------------------------------------------------------- */

static void write_all(const csv *t, FILE *to)
{
    for (unsigned i = 0; i < t->n_notes; i++)
        fprintf(to, "# %s\r\n", t->notes[i]);
    for (unsigned row = 0; row <= t->n_rows; row++)
        for (unsigned i = 0; i < t->n_columns; i++)
            fprintf(to, "%s%s", t->fields[row * t->n_columns + i],
                    i + 1 < t->n_columns ? "," : "\r\n");
    fclose(to);
}

static void compare(const csv *a, const csv *b)
{
    REQUIRE(a->n_notes == b->n_notes && a->n_columns == b->n_columns
            && a->n_rows == b->n_rows);
    for (unsigned i = 0; i < a->n_notes; i++)
        REQUIRE(strcmp(a->notes[i], b->notes[i]) == 0);
    for (unsigned i = 0; i < (a->n_rows + 1) * a->n_columns; i++)
        REQUIRE(strcmp(a->fields[i], b->fields[i]) == 0);
}

/* True if the model may run for minutes: a table may ask for a million steps of a pool of
 * 512x512 cells, row by row. */
static bool takes_long(const csv *t)
{
    static const struct { const char *column; double most; } limits[] = {
        { "N", 64 }, { "M", 64 }, { "n", 400 }, { "step", 400 },
    };
    for (size_t k = 0; k < sizeof limits / sizeof *limits; k++)
        for (unsigned i = 0; i < t->n_columns; i++)
            for (unsigned row = 0; row < t->n_rows; row++)
                if (strcmp(t->fields[i], limits[k].column) == 0
                    && (row > 4 || strtod(csv_field(t, row, i), NULL) > limits[k].most))
                    return true;
    return false;
}

/* Reads the table. Returns false if the table was rejected with a message, or if the model
 * would take long. */
static bool read_table(const char *path, unsigned lines)
{
    csv table, again;
    char *text;
    size_t bytes;
    if (csv_read(&table, path)) {
        fuzz_refused(path, lines + 1);      /* a missing line may be the next one */
        REQUIRE(!table.text && !table.notes && !table.fields);
        return false;
    }
    REQUIRE(table.n_rows > 0 && table.n_columns > 0);
    write_all(&table, open_memstream(&text, &bytes));
    REQUIRE(csv_read(&again, fuzz_file(1, text, bytes)) == EXIT_DONE);
    compare(&table, &again);
    const bool quick = !takes_long(&again);
    csv_free(&again);
    csv_free(&table);
    free(text);
    return quick;
}

/* -- its model --------------------------------------------------------------------- */

/* Makes the file the only table of the folder, by a link; *table is the link's path. */
static void link_table(const char *model, const char *path, char *table, size_t bytes)
{
    static char last[4200];
    if (last[0])
        unlink(last);
    snprintf(table, bytes, "%s/%s.csv", fuzz_folder(), model);
    snprintf(last, sizeof last, "%s", table);
    REQUIRE(symlink(path, table) == 0);
}

static void check_with(const char *model, const char *path, unsigned lines)
{
    char table[4200], *words[] = { "check", "--vectors", (char *)fuzz_folder(), NULL };
    link_table(model, path, table, sizeof table);
    const int code = check_command(3, words);
    REQUIRE(code == EXIT_DONE || code == EXIT_CHECK || code == EXIT_INPUT);
    if (code)
        fuzz_refused(table, lines);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const unsigned model = fuzz_byte(&data, &size);
    const unsigned lines = fuzz_lines(data, size);
    const char *path = fuzz_file(0, data, size);
    if (read_table(path, lines) && model >= 'a' && model < 'a' + MODELS)
        check_with(models[model - 'a'], path, lines);
    return 0;
}
