/* SPDX-License-Identifier: MIT */
/* Reads the rows that jobs print, in any order:
 *
 *     CHART,KEYS,COLUMN,VALUE         KEYS of two columns: sine;8
 *
 * A row is one cell of a chart's table.  After sorting, the cells of each table row are
 * contiguous, whatever the order of the input. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/csv.h"
#include "app/files/did_you_mean.h"
#include "app/files/log.h"
#include "charts.h"

enum { ROW_CHART, ROW_KEYS, ROW_COLUMN, ROW_VALUE, ROW_FIELDS };

typedef struct {
    const charts *charts;
    const char   *name;
    unsigned      line;
    const bool   *mine;
    bool          timed;
} row_place;

static int wrong(const row_place *at, const char *what, const char *word)
{
    return log_fail(EXIT_INPUT, "%s:%u: %s%s", at->name, at->line, what, word);
}

static int wrong_name(const row_place *at, const char *what, const char *word,
                      did_you_mean best)
{
    if (best.name)
        return log_fail(EXIT_INPUT, "%s:%u: no %s %s; did you mean %s?", at->name, at->line,
                    what, word, best.name);
    return log_fail(EXIT_INPUT, "%s:%u: no %s %s", at->name, at->line, what, word);
}

static int find_chart(const row_place *at, const char *word, const chart **of)
{
    const charts *c = at->charts;
    did_you_mean best = did_you_mean_make(word);
    *of = charts_find(c, word);
    for (size_t i = 0; i < c->count; i++)
        did_you_mean_offer(&best, c->of[i].name);
    if (!*of)
        return wrong_name(at, "chart", word, best);
    if (at->mine && !at->mine[*of - c->of])
        return wrong(at, "the job does not belong to chart ", word);
    return EXIT_DONE;
}

static int find_column(const row_place *at, const chart *of, const char *word,
                       unsigned *column)
{
    const int value = string_list_find(&of->values, word),
              time = string_list_find(&of->times, word);
    did_you_mean best = did_you_mean_make(word);
    for (size_t i = 0; i < of->values.count; i++)
        did_you_mean_offer(&best, of->values.of[i]);
    for (size_t i = 0; i < of->times.count; i++)
        did_you_mean_offer(&best, of->times.of[i]);
    if (value < 0 && time < 0)
        return wrong_name(at, "column", word, best);
    if (at->mine && at->timed != (time >= 0))
        return wrong(at, at->timed ? "a `time` job prints only times: "
                                   : "only a `time` job prints times: ", word);
    *column = (unsigned)(value >= 0 ? value : time + (int)of->values.count);
    return EXIT_DONE;
}

static int check_keys(const row_place *at, const chart *of, const char *keys)
{
    size_t count = 0, empty = 0;
    for (const char *c = keys;; c++) {
        const size_t bytes = strcspn(c, ";");
        count++;
        empty += bytes == 0;
        c += bytes;
        if (!*c)
            break;
    }
    if (count == of->keys.count && !empty)
        return EXIT_DONE;
    return log_fail(EXIT_INPUT, "%s:%u: %s for keys; chart %s has %zu", at->name, at->line,
                *keys ? keys : "nothing", of->name, of->keys.count);
}

/* Splits the row in place; false: not four fields, or a field is empty or quoted. */
static bool cut_row(char *text, char *field[ROW_FIELDS])
{
    unsigned count = 0;
    if (strpbrk(text, "\"\r"))
        return false;
    for (char *c = text; count < ROW_FIELDS; count++) {
        field[count] = c;
        c += strcspn(c, ",");
        if (c == field[count])
            return false;
        if (!*c)
            return count == ROW_FIELDS - 1;
        *c++ = 0;
    }
    return false;
}

static int add_cell(chart_cells *all, chart_cell one)
{
    if (all->count == all->room) {
        const size_t room = all->room ? 2 * all->room : 256;
        chart_cell *more = realloc(all->of, room * sizeof *more);
        if (!more)
            return log_fail_memory(room * sizeof *more);
        all->of = more;
        all->room = room;
    }
    one.keys = strdup(one.keys);
    one.value = strdup(one.value);
    all->of[all->count++] = one;
    return one.keys && one.value ? EXIT_DONE : log_fail_memory(sizeof one);
}

static int read_row(chart_cells *all, const row_place *at, char *text)
{
    char *field[ROW_FIELDS];
    const chart *of;
    unsigned column = 0;
    char shown[48];
    snprintf(shown, sizeof shown, "%s", text);
    if (!cut_row(text, field))
        return wrong(at, "expected CHART,KEYS,COLUMN,VALUE, found ", shown);
    int code = find_chart(at, field[ROW_CHART], &of);
    if (!code)
        code = check_keys(at, of, field[ROW_KEYS]);
    if (!code)
        code = find_column(at, of, field[ROW_COLUMN], &column);
    if (!code && of->asked)
        code = add_cell(all, (chart_cell){ of, field[ROW_KEYS], field[ROW_VALUE], column,
                                           at->name, at->line });
    return code;
}

int cells_read(chart_cells *all, const charts *c, FILE *file, const char *name,
               const bool *mine, bool timed)
{
    row_place at = { c, name, 0, mine, timed };
    char *text = NULL;
    size_t room = 0;
    ssize_t bytes;
    int code = EXIT_DONE;
    errno = 0;
    while (!code && (bytes = getline(&text, &room, file)) >= 0) {
        at.line++;
        if (strlen(text) != (size_t)bytes)
            code = wrong(&at, "a zero byte", "");
        text[strcspn(text, "\n")] = 0;
        if (!code && *text)
            code = read_row(all, &at, text);
    }
    if (!code && !feof(file))               /* getline may have run out of memory */
        code = log_fail(EXIT_INPUT, "%s: %s", name, strerror(errno));
    free(text);
    return code;
}

void cells_free(chart_cells *all)
{
    for (size_t i = 0; i < all->count; i++) {
        free(all->of[i].keys);
        free(all->of[i].value);
    }
    free(all->of);
    *all = (chart_cells){ 0 };
}

/* -- order --------------------------------------------------------------------------- */

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static int by_size(double a, double b)
{
    return (a > b) - (a < b);
}

/* True if the whole word is a number, as "-0.5". */
static bool is_number(const char *text, size_t bytes, double *value)
{
    const char *end = csv_number(text, value);
    return end && (size_t)(end - text) == bytes;
}

/* Compares two words: digits inside of words as numbers, the rest by bytes. */
static int words_order(const char *a, size_t n, const char *b, size_t m)
{
    size_t i = 0, k = 0;
    while (i < n && k < m) {
        if (is_digit(a[i]) && is_digit(b[k])) {
            char *a_end, *b_end;
            const int order = by_size((double)strtoull(a + i, &a_end, 10),
                                      (double)strtoull(b + k, &b_end, 10));
            if (order)
                return order;
            i = (size_t)(a_end - a);
            k = (size_t)(b_end - b);
        } else if (a[i] != b[k]) {
            return (unsigned char)a[i] < (unsigned char)b[k] ? -1 : 1;
        } else {
            i++;
            k++;
        }
    }
    return (i < n) - (k < m);
}

int charts_natural_order(const char *a, const char *b, const char *separators)
{
    for (;;) {
        const size_t n = strcspn(a, separators), m = strcspn(b, separators);
        double x, y;
        const bool is_a = is_number(a, n, &x), is_b = is_number(b, m, &y);
        const int order = is_a && is_b ? by_size(x, y)
                        : is_a != is_b ? (is_a ? -1 : 1) : words_order(a, n, b, m);
        if (order || !a[n] || !b[m])
            return order ? order : (a[n] != 0) - (b[m] != 0);
        a += n + 1;
        b += m + 1;
    }
}

/* Compares keys.  Equal numbers written differently are different keys, ordered by
 * bytes. */
static int keys_order(const chart_cell *a, const chart_cell *b)
{
    const int order = charts_natural_order(a->keys, b->keys, ";");
    return order ? order : strcmp(a->keys, b->keys);
}

static int cells_order(const void *of_a, const void *of_b)
{
    const chart_cell *a = of_a, *b = of_b;
    if (a->chart != b->chart)
        return a->chart < b->chart ? -1 : 1;
    const int order = keys_order(a, b);
    if (order)
        return order;
    if (a->column != b->column)
        return a->column < b->column ? -1 : 1;
    return strcmp(a->value, b->value);
}

int cells_sort(chart_cells *all)
{
    if (all->count)
        qsort(all->of, all->count, sizeof *all->of, cells_order);
    for (size_t i = 1; i < all->count; i++) {
        const chart_cell *a = &all->of[i - 1], *b = &all->of[i];
        if (a->chart != b->chart || a->column != b->column || keys_order(a, b) != 0)
            continue;
        const string_list *values = &b->chart->values, *times = &b->chart->times;
        if (strcmp(a->value, b->value) != 0)
            return log_fail(EXIT_INPUT, "%s:%u: chart %s: %s of %s is %s; %s:%u has %s",
                            b->from, b->line, b->chart->name,
                            b->column < values->count
                                ? values->of[b->column]
                                : times->of[b->column - values->count],
                            b->keys, b->value, a->from, a->line, a->value);
    }
    return EXIT_DONE;
}
