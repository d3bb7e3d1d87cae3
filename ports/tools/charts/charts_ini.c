/* SPDX-License-Identifier: MIT */
/* The format of NAME.ini, the description of a chart:
 *
 *     [chart]
 *     title  = Sine: instructions against error
 *     keys   = method                     first columns of the table
 *     values = m4 x86 error_max used      next columns
 *     units  = m4:instructions            units of values, for readers
 *     pareto = m4 error_max               adds a column `front`: 1 if no row is better in
 *                                         one value and as good in the other; lower is
 *                                         better
 *     group  = scene                      makes one front for each value of these keys
 *     sparse = used                       values that rows may lack without a message
 *     job    = COMMAND                    prints rows; {scene}: one job per shipped scene
 *     large  = COMMAND                    as job, but not in the small sweep
 *     times  = ms                         columns of NAME.time.csv
 *     time   = COMMAND                    prints rows of times; runs alone
 *
 * Lists and commands may continue in another line with the same name. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/did_you_mean.h"
#include "app/files/ini_read.h"
#include "app/files/log.h"
#include "app/files/path.h"
#include "charts.h"

static const struct {
    const char *name;
    size_t      at;             /* offset of a `string_list` in chart */
    bool        whole;          /* true: a line is one word */
} lists[] = {
    { "keys", offsetof(chart, keys), false },
    { "values", offsetof(chart, values), false },
    { "times", offsetof(chart, times), false },
    { "units", offsetof(chart, units), false },
    { "pareto", offsetof(chart, pareto), false },
    { "group", offsetof(chart, group), false },
    { "sparse", offsetof(chart, sparse), false },
    { "job", offsetof(chart, commands[CHART_JOB]), true },
    { "large", offsetof(chart, commands[CHART_LARGE]), true },
    { "time", offsetof(chart, commands[CHART_TIME]), true },
};

#define LISTS (sizeof lists / sizeof *lists)

static string_list *chart_word_list(chart *c, size_t i)
{
    return (string_list *)(void *)((char *)c + lists[i].at);
}

static bool refuse_name(const chart *c, uint32_t line, const char *name)
{
    did_you_mean best = did_you_mean_make(name);
    did_you_mean_offer(&best, "title");
    for (size_t i = 0; i < LISTS; i++)
        did_you_mean_offer(&best, lists[i].name);
    if (best.name)
        log_line("%s:%u: nothing is called %s; did you mean %s?", c->path, (unsigned)line,
                 name, best.name);
    else
        log_line("%s:%u: nothing is called %s", c->path, (unsigned)line, name);
    return false;
}

static bool take(void *user, uint32_t line, const char *section, const char *name,
                 const char *value)
{
    chart *c = user;
    if (strcmp(section, "chart") != 0) {
        log_line("%s:%u: [%s]; expected [chart]", c->path, (unsigned)line, section);
        return false;
    }
    if (!*value || (strcmp(name, "title") == 0 && c->title)) {
        log_line("%s:%u: %s: %s", c->path, (unsigned)line, name,
                 *value ? "twice" : "empty");
        return false;
    }
    bool held = true, known = strcmp(name, "title") == 0;
    if (known)
        held = (c->title = path_copy(value, strlen(value))) != NULL;
    for (size_t i = 0; i < LISTS && !known; i++)
        if (strcmp(name, lists[i].name) == 0) {
            known = true;
            held = lists[i].whole
                       ? string_list_add(chart_word_list(c, i), value, strlen(value))
                       : string_list_split(chart_word_list(c, i), value, " \t");
        }
    if (!held)
        log_fail_memory(strlen(value));
    return held && (known || refuse_name(c, line, name));
}

/* -- consistency --------------------------------------------------------------------- */

static int wrong(const chart *c, const char *what, const char *word)
{
    return log_fail(EXIT_INPUT, "%s: %s%s", c->path, what, word);
}

/* Checks that no two columns share a name, that no column is called `front`, and that the
 * names can stand in a table: a line that begins with # would be read as a note. */
static int check_columns(const chart *c)
{
    const string_list *const all[] = { &c->keys, &c->values, &c->times };
    for (int a = 0; a < 3; a++)
        for (size_t i = 0; i < all[a]->count; i++) {
            const char *name = all[a]->of[i];
            int found = strcmp(name, "front") == 0;
            for (int b = 0; b < 3; b++)
                for (size_t k = 0; k < all[b]->count; k++)
                    found += strcmp(all[b]->of[k], name) == 0;
            if (found > 1)
                return wrong(c, "two columns are called ", name);
            if (strpbrk(name, ",;\"") || name[0] == '#')
                return wrong(c, "a column cannot be called ", name);
        }
    return EXIT_DONE;
}

static int check_names(const chart *c)
{
    for (size_t i = 0; i < c->pareto.count; i++)
        if (string_list_find(&c->values, c->pareto.of[i]) < 0)
            return wrong(c, "pareto: no value is called ", c->pareto.of[i]);
    for (size_t i = 0; i < c->group.count; i++)
        if (string_list_find(&c->keys, c->group.of[i]) < 0)
            return wrong(c, "group: no key is called ", c->group.of[i]);
    for (size_t i = 0; i < c->sparse.count; i++)
        if (string_list_find(&c->values, c->sparse.of[i]) < 0)
            return wrong(c, "sparse: no value is called ", c->sparse.of[i]);
    for (size_t i = 0; i < c->units.count; i++) {
        char name[64];
        const char *unit = c->units.of[i];
        const size_t bytes = strcspn(unit, ":");
        if (!unit[bytes] || !unit[bytes + 1] || bytes >= sizeof name)
            return wrong(c, "units: expected COLUMN:UNIT, found ", unit);
        memcpy(name, unit, bytes);
        name[bytes] = 0;
        if (string_list_find(&c->values, name) < 0 && string_list_find(&c->times, name) < 0)
            return wrong(c, "units: no value is called ", name);
    }
    return EXIT_DONE;
}

static int check(const chart *c)
{
    if (!c->title || !c->keys.count || !c->values.count)
        return wrong(c, "a chart needs title, keys and values", "");
    if (c->pareto.count != 0 && c->pareto.count != 2)
        return wrong(c, "pareto: expected two values", "");
    if (c->group.count && !c->pareto.count)
        return wrong(c, "group: needs pareto", "");
    if (!c->commands[CHART_JOB].count && !c->commands[CHART_LARGE].count)
        return wrong(c, "no job", "");
    if (!c->times.count != !c->commands[CHART_TIME].count)
        return wrong(c, "times (columns) and time (a command) go together", "");
    const int code = check_columns(c);
    return code ? code : check_names(c);
}

/* -- all charts ---------------------------------------------------------------------- */

char *chart_path(const char *folder, const chart *of, const char *suffix)
{
    return path_join(folder, of->name, suffix);
}

chart *charts_find(const charts *c, const char *name)
{
    for (size_t i = 0; i < c->count; i++)
        if (strcmp(c->of[i].name, name) == 0)
            return &c->of[i];
    return NULL;
}

static int refuse_chart(const charts *c, const char *name)
{
    did_you_mean best = did_you_mean_make(name);
    for (size_t i = 0; i < c->count; i++)
        did_you_mean_offer(&best, c->of[i].name);
    if (best.name)
        return log_fail(EXIT_USAGE, "tidepool charts: no chart %s; did you mean %s?", name,
                    best.name);
    return log_fail(EXIT_USAGE, "tidepool charts: no chart %s", name);
}

static int ask(charts *c, const char *only)
{
    string_list names = { 0 };
    int code = EXIT_DONE;
    if (only && !string_list_split(&names, only, ","))
        code = log_fail_memory(strlen(only));
    for (size_t i = 0; i < c->count; i++)
        c->of[i].asked = !only;
    for (size_t i = 0; i < names.count && !code; i++) {
        chart *of = charts_find(c, names.of[i]);
        if (of)
            of->asked = true;
        else
            code = refuse_chart(c, names.of[i]);
    }
    string_list_free(&names);
    return code;
}

int charts_read(charts *c, const char *folder, const char *only)
{
    size_t count;
    int code = EXIT_DONE;
    char **names = path_scene_names(folder, &count);
    *c = (charts){ .folder = folder, .of = calloc(count + 1, sizeof *c->of) };
    if (!c->of)
        code = log_fail_memory((count + 1) * sizeof *c->of);
    for (size_t i = 0; i < count && !code; i++) {
        chart *of = &c->of[c->count++];
        of->name = path_copy(names[i], strlen(names[i]));
        of->path = of->name ? chart_path(folder, of, ".ini") : NULL;
        code = of->path ? ini_read(of->path, take, of) : log_fail_memory(strlen(names[i]));
        if (!code)
            code = check(of);
    }
    path_free_names(names, count);
    if (!code && !count)
        code = log_fail(EXIT_INPUT, "%s: no chart in this folder", folder);
    return code ? code : ask(c, only);
}

void charts_free(charts *c)
{
    for (size_t i = 0; i < c->count; i++) {
        chart *of = &c->of[i];
        free(of->name);
        free(of->path);
        free(of->title);
        for (size_t k = 0; k < LISTS; k++)
            string_list_free(chart_word_list(of, k));
    }
    free(c->of);
    *c = (charts){ 0 };
}
