/* SPDX-License-Identifier: MIT */
/* Fuzzes a sweep's files, separated by lines "%%": the description of a chart, rows as read
 * by --collect, and the frame of the page. Rows give the same table in any order, and the
 * table can be read back. */
#include "fuzz.h"
#include "tools/charts/charts.h"
#include "app/files/csv.h"

static void write_file(const char *path, const void *data, size_t size)
{
    FILE *file = fopen(path, "wb");
    REQUIRE(file != NULL && fwrite(data, 1, size, file) == size);
    REQUIRE(fclose(file) == 0);
}

static const char *in_folder(const char *name)
{
    static char path[4][4200];
    static unsigned next;
    char *text = path[next++ % 4];
    snprintf(text, sizeof path[0], "%s/%s", fuzz_folder(), name);
    return text;
}

static void require_chart(const charts *c)
{
    REQUIRE(c->count == 1 && c->of[0].title && c->of[0].asked);
    REQUIRE(c->of[0].keys.count > 0 && c->of[0].values.count > 0);
    REQUIRE(c->of[0].pareto.count == 0 || c->of[0].pareto.count == 2);
    REQUIRE(!c->of[0].times.count == !c->of[0].commands[CHART_TIME].count);
}

/* -- rows -------------------------------------------------------------------------- */

static int read_rows(chart_cells *all, const charts *c, const char *path)
{
    FILE *file = fopen(path, "r");
    REQUIRE(file != NULL);
    *all = (chart_cells){ 0 };
    const int code = cells_read(all, c, file, path, NULL, false);
    fclose(file);
    return code;
}

/* Requires a total order of all keys: of two keys one is first, and three keys have no
 * cycle. */
static void require_natural_order(const chart_cells *all)
{
    const size_t n = all->count < 12 ? all->count : 12;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) {
            const char *a = all->of[i].keys, *b = all->of[k].keys;
            const int order = charts_natural_order(a, b, ";");
            REQUIRE(order == -charts_natural_order(b, a, ";"));
            for (size_t m = 0; m < n && order <= 0; m++)
                if (charts_natural_order(b, all->of[m].keys, ";") <= 0)
                    REQUIRE(charts_natural_order(a, all->of[m].keys, ";") <= 0);
        }
}

/* The lines in reverse order, each with its end. */
static char *turned(const uint8_t *rows, size_t size, size_t *bytes)
{
    char *text = malloc(size + 2), *to = text;
    size_t end = size;
    REQUIRE(text != NULL);
    while (end > 0) {
        size_t begin = end - 1;
        while (begin > 0 && rows[begin - 1] != '\n')
            begin--;
        const size_t n = end - begin - (rows[end - 1] == '\n');
        memcpy(to, rows + begin, n);
        to += n;
        *to++ = '\n';
        end = begin;
    }
    *bytes = (size_t)(to - text);
    return text;
}

/* Contents of the table; the caller frees them. NULL: the rows were rejected, or there are
 * none. */
static uint8_t *table_of(const charts *c, chart_cells *all, size_t *bytes)
{
    const char *path = in_folder("a.csv");
    bool written = false;
    unlink(path);
    if (cells_sort(all) || chart_write(c->of, all, fuzz_folder(), true, &written)
        || !written)
        return NULL;
    return fuzz_contents(path, bytes);
}

static void require_table(const charts *c)
{
    csv table;
    const chart *of = c->of;
    REQUIRE(csv_read(&table, in_folder("a.csv")) == EXIT_DONE);
    REQUIRE(table.n_notes == 0 && table.n_columns == of->keys.count + of->values.count
                                                     + (of->pareto.count > 0));
    for (unsigned i = 0; i < of->keys.count; i++)
        REQUIRE(strcmp(table.fields[i], of->keys.of[i]) == 0);
    csv_free(&table);
}

static void collect(const charts *c, const uint8_t *rows, size_t size)
{
    chart_cells all, other;
    size_t bytes, again_bytes, turned_bytes;
    const char *path = fuzz_file(0, rows, size);
    if (read_rows(&all, c, path)) {
        fuzz_refused(path, fuzz_lines(rows, size));
        cells_free(&all);
        return;
    }
    require_natural_order(&all);
    uint8_t *table = table_of(c, &all, &bytes);
    char *text = turned(rows, size, &turned_bytes);
    REQUIRE(read_rows(&other, c, fuzz_file(1, text, turned_bytes)) == EXIT_DONE);
    uint8_t *again = table_of(c, &other, &again_bytes);
    REQUIRE(!table == !again);
    if (table) {
        REQUIRE(bytes == again_bytes && memcmp(table, again, bytes) == 0);
        require_table(c);
    }
    free(table);
    free(again);
    free(text);
    cells_free(&all);
    cells_free(&other);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t bytes, row_bytes;
    const uint8_t *text = fuzz_part(&data, &size, &bytes);
    const uint8_t *rows = fuzz_part(&data, &size, &row_bytes);
    const char *path = in_folder("a.ini");
    charts c;
    write_file(path, text, bytes);
    write_file(in_folder("page.md"), data, size);
    if (charts_read(&c, fuzz_folder(), NULL)) {
        fuzz_refused(path, fuzz_lines(text, bytes));
    } else {
        require_chart(&c);
        collect(&c, rows, row_bytes);
        REQUIRE(charts_page(&c, fuzz_folder()) == EXIT_DONE);
    }
    charts_free(&c);
    REQUIRE(!c.of && !c.count);
    return 0;
}
