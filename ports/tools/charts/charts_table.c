/* SPDX-License-Identifier: MIT */
/* Makes tables from sorted cells: one row for all cells with the same keys, with a column
 * that marks the Pareto front. */
#include <stdlib.h>
#include <string.h>
#include "app/files/csv.h"
#include "app/files/log.h"
#include "app/files/output_file.h"
#include "charts.h"

#define TOLD 3      /* printed missing cells per chart, before "and N cells more" */

/* One table: the values of a chart, or its times. */
typedef struct {
    const chart *of;
    const string_list *columns;
    unsigned     first;         /* index of the first column in the chart */
    size_t       rows;
    const char **keys;          /* keys of each row */
    const char **value;         /* value of each row and column; NULL: missing */
    bool        *front;
} table;

static bool is_table_cell(const table *t, const chart_cell *one)
{
    return one->chart == t->of && one->column >= t->first
        && one->column < t->first + t->columns->count;
}

static void table_free(table *t)
{
    free(t->keys);
    free(t->value);
    free(t->front);
}

static int table_fill(table *t, const chart_cells *all)
{
    const size_t columns = t->columns->count;
    const char *last = NULL;
    size_t most = 0;
    for (size_t i = 0; i < all->count; i++)
        most += is_table_cell(t, &all->of[i]);
    t->keys = calloc(most + 1, sizeof *t->keys);
    t->value = calloc(most * columns + 1, sizeof *t->value);
    t->front = calloc(most + 1, sizeof *t->front);
    if (!t->keys || !t->value || !t->front)
        return log_fail_memory(most * columns * sizeof *t->value);
    for (size_t i = 0; i < all->count; i++) {
        const chart_cell *one = &all->of[i];
        if (!is_table_cell(t, one))
            continue;
        if (!last || strcmp(last, one->keys) != 0)
            t->keys[t->rows++] = last = one->keys;
        t->value[(t->rows - 1) * columns + one->column - t->first] = one->value;
    }
    return EXIT_DONE;
}

/* -- the Pareto front ---------------------------------------------------------------- */

/* Returns the key with index `number`; *bytes: its length. */
static const char *nth_key(const char *keys, int number, size_t *bytes)
{
    for (; number > 0; number--)
        keys += strcspn(keys, ";") + 1;
    *bytes = strcspn(keys, ";");
    return keys;
}

static bool same_group(const table *t, size_t a, size_t b)
{
    for (size_t i = 0; i < t->of->group.count; i++) {
        const int number = string_list_find(&t->of->keys, t->of->group.of[i]);
        size_t n, m;
        const char *x = nth_key(t->keys[a], number, &n);
        const char *y = nth_key(t->keys[b], number, &m);
        if (n != m || memcmp(x, y, n) != 0)
            return false;
    }
    return true;
}

/* Marks the rows on the front: 1 if no other row of the group is better.  A row without
 * both values is not on the front and dominates no other row. */
static void mark_front(table *t, const double (*at)[2], const bool *whole)
{
    for (size_t i = 0; i < t->rows; i++) {
        t->front[i] = whole[i];
        for (size_t k = 0; k < t->rows && t->front[i]; k++)
            t->front[i] = !whole[k] || !same_group(t, i, k)
                        || at[k][0] > at[i][0] || at[k][1] > at[i][1]
                        || (at[k][0] >= at[i][0] && at[k][1] >= at[i][1]);
    }
}

static int read_front(const table *t, double (*at)[2], bool *whole)
{
    for (size_t i = 0; i < t->rows; i++) {
        whole[i] = true;
        for (int p = 0; p < 2; p++) {
            const char *name = t->of->pareto.of[p];
            const int column = string_list_find(t->columns, name);
            const char *text = t->value[i * t->columns->count + (size_t)column];
            const char *end = text ? csv_number(text, &at[i][p]) : NULL;
            if (text && (!end || *end))
                return log_fail(EXIT_INPUT,
                                "chart %s: %s of %s is %s; a front takes numbers",
                                t->of->name, name, t->keys[i], text);
            whole[i] = whole[i] && text;
        }
    }
    return EXIT_DONE;
}

static int find_front(table *t)
{
    double (*at)[2] = calloc(t->rows + 1, sizeof *at);
    bool *whole = calloc(t->rows + 1, sizeof *whole);
    int code = at && whole ? read_front(t, at, whole)
                           : log_fail_memory(t->rows * sizeof *at);
    if (!code)
        mark_front(t, (const double (*)[2])at, whole);
    free(at);
    free(whole);
    return code;
}

/* -- writing ------------------------------------------------------------------------- */

static void tell_missing(const table *t)
{
    const size_t columns = t->columns->count;
    size_t missing = 0;
    for (size_t i = 0; i < t->rows * columns; i++)
        if (!t->value[i]
            && string_list_find(&t->of->sparse, t->columns->of[i % columns]) < 0
            && missing++ < TOLD)
            log_line("chart %s: %s has no %s", t->of->name, t->keys[i / columns],
                     t->columns->of[i % columns]);
    if (missing > TOLD)
        log_line("chart %s: and %zu more cells", t->of->name, missing - TOLD);
}

static void print_rows(const table *t, bool front, FILE *file)
{
    const size_t columns = t->columns->count;
    for (size_t i = 0; i < t->of->keys.count; i++)
        fprintf(file, "%s%s", i ? "," : "", t->of->keys.of[i]);
    for (size_t i = 0; i < columns; i++)
        fprintf(file, ",%s", t->columns->of[i]);
    fputs(front ? ",front\n" : "\n", file);
    for (size_t row = 0; row < t->rows; row++) {
        for (const char *c = t->keys[row]; *c; c++)
            putc(*c == ';' ? ',' : *c, file);
        for (size_t i = 0; i < columns; i++) {
            const char *text = t->value[row * columns + i];
            fprintf(file, ",%s", text ? text : "");
        }
        fputs(front ? t->front[row] ? ",1\n" : ",0\n" : "\n", file);
    }
}

static int write_table(const table *t, bool front, const char *dir, const char *suffix)
{
    output_file out;
    char *name = chart_path(dir, t->of, suffix);
    if (!name)
        return log_fail_memory(strlen(dir));
    int code = output_file_open(&out, name);
    if (!code) {
        print_rows(t, front, out.file);
        code = output_file_close(&out);
    }
    free(name);
    return code;
}

int chart_write(const chart *of, const chart_cells *all, const char *dir, bool whole,
                bool *written)
{
    table values = { .of = of, .columns = &of->values };
    table times = { .of = of, .columns = &of->times,
                    .first = (unsigned)of->values.count };
    const bool front = of->pareto.count > 0;
    int code = table_fill(&values, all);
    if (!code)
        code = table_fill(&times, all);
    if (!code && front)
        code = find_front(&values);
    *written = !code && values.rows > 0;
    if (*written && whole)
        tell_missing(&values);
    if (*written)
        code = write_table(&values, front, dir, ".csv");
    if (!code && times.rows)
        code = write_table(&times, false, dir, ".time.csv");
    table_free(&values);
    table_free(&times);
    return code;
}
