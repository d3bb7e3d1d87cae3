/* SPDX-License-Identifier: MIT */
/* tidepool check --vectors: reads the files of a folder, checks each against the
 * description of its model, and prints the table of errors.  The models are in the
 * other check_*.c. */
#define _POSIX_C_SOURCE 200809L
#include "check.h"
#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/cli/args.h"
#include "app/cli/command_help.h"
#include "app/cli/commands.h"
#include "app/files/did_you_mean.h"
#include "app/files/path.h"
#include "check_scene.h"

static const struct {
    const char        *file;
    const check_model *model;
} models[] = {
#define X(name) { #name ".csv", &check_##name },
    CHECK_MODELS(X)
#undef X
};

#define MODELS (sizeof models / sizeof *models)

/* -- functions for models ------------------------------------------------------------ */

const double *check_row(const check_run *run, unsigned row)
{
    return run->rows + (size_t)row * run->model->n_columns;
}

const char *check_text(const check_run *run, unsigned row, unsigned column)
{
    return csv_field(&run->table, row, run->place[column]);
}

void check_add(check_run *run, unsigned quantity, unsigned row, double error)
{
    check_tally *tally = &run->tally[quantity];
    if (tally->rows == 0 || !(fabs(error) <= tally->worst)) {   /* true for NaN too */
        tally->worst = fabs(error);
        tally->worst_row = row;
    }
    tally->rows++;
    tally->squares += error * error;
}

static int refuse_line(const check_run *run, unsigned line, const char *format,
                       va_list list)
{
    char text[256];
    vsnprintf(text, sizeof text, format, list);
    return log_fail(EXIT_INPUT, "%s:%u: %s", run->table.name, line, text);
}

int check_refuse(const check_run *run, unsigned row, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    const int code = refuse_line(run, csv_row_line(&run->table, row), format, list);
    va_end(list);
    return code;
}

int check_refuse_line(const check_run *run, unsigned note, unsigned i, const char *format,
                      ...)
{
    va_list list;
    va_start(list, format);
    const int code = refuse_line(run, run->line_at[note][i], format, list);
    va_end(list);
    return code;
}

void check_progress(const check_run *run, unsigned row)
{
    char text[80];
    snprintf(text, sizeof text, "%.40s: row %u of %u", run->label, row + 1,
             run->table.n_rows);
    log_progress(text);
}

/* -- values -------------------------------------------------------------------------- */

static int refuse_range(const check_run *run, unsigned line, const check_field *field,
                        double value)
{
    return log_fail(EXIT_INPUT, "%s:%u: %s = %.9g is outside %.9g..%.9g%s", run->table.name,
                line, field->name, value, field->low, field->high,
                field->kind == CHECK_WHOLE ? ", or not a whole number" : "");
}

static bool in_range(const check_field *field, double value)
{
    return value >= field->low && value <= field->high
           && (field->kind != CHECK_WHOLE || value == floor(value));
}

/* Returns the index of `word` in "a|b|c", or -1. */
static int word_index(const char *words, const char *word)
{
    const size_t length = strlen(word);
    for (int place = 0; words; place++) {
        const size_t each = strcspn(words, "|");
        if (each == length && memcmp(words, word, length) == 0)
            return place;
        words = words[each] ? words + each + 1 : NULL;
    }
    return -1;
}

static int read_value(const check_run *run, unsigned row, unsigned column, double *value)
{
    const check_field *field = &run->model->columns[column];
    const char *text = check_text(run, row, column);
    const unsigned line = csv_row_line(&run->table, row);
    *value = 0;
    if (field->kind == CHECK_TEXT)
        return EXIT_DONE;
    if (field->kind == CHECK_WORD) {
        *value = word_index(field->words, text);
        return *value >= 0 ? EXIT_DONE
               : log_fail(EXIT_INPUT, "%s:%u: %s = '%.40s' is none of %s", run->table.name,
                      line, field->name, text, field->words);
    }
    const char *end = csv_number(text, value);
    if (!end || *end)
        return log_fail(EXIT_INPUT, "%s:%u: %s: expected a number, found '%.40s'",
                        run->table.name, line, field->name, text);
    return in_range(field, *value) ? EXIT_DONE : refuse_range(run, line, field, *value);
}

static int read_rows(check_run *run)
{
    const unsigned columns = run->model->n_columns;
    const size_t count = (size_t)run->table.n_rows * columns;
    run->rows = calloc(count, sizeof *run->rows);
    if (!run->rows)
        return log_fail_memory(count * sizeof *run->rows);
    for (size_t i = 0; i < count; i++) {
        const int code = read_value(run, (unsigned)(i / columns), (unsigned)(i % columns),
                                    run->rows + i);
        if (code)
            return code;
    }
    return EXIT_DONE;
}

/* -- parameter lines ----------------------------------------------------------------- */

/* True if the line has the form of the note; `value` gets the numbers in place of each
 * '%'. */
static bool matches(const check_note *note, const char *line, double *value)
{
    for (const char *form = note->text; *form; form++) {
        if (*form == '%') {
            line = csv_number(line, value++);
            if (!line)
                return false;
        } else if (*line++ != *form) {
            return false;
        }
    }
    return *line == 0;
}

static int keep_line(check_run *run, unsigned n, unsigned line, const double *value)
{
    const check_note *note = &run->model->notes[n];
    const unsigned found = run->n_lines[n];
    for (unsigned i = 0; i < note->count; i++)
        if (!in_range(&note->numbers[i], value[i]))
            return refuse_range(run, line, &note->numbers[i], value[i]);
    if (found == (note->list ? CHECK_LINES : 1))
        return log_fail(EXIT_INPUT, "%s:%u: too many parameter lines of this kind",
                        run->table.name, line);
    if (note->list && value[0] != found)
        return log_fail(EXIT_INPUT, "%s:%u: number %g; expected %u", run->table.name, line,
                    value[0], found);
    memcpy(run->lines[n][found], value, note->count * sizeof *value);
    run->line_at[n][found] = line;
    run->n_lines[n]++;
    return EXIT_DONE;
}

static int read_note(check_run *run, unsigned i)
{
    const unsigned line = csv_note_line(i);
    double value[12];
    for (unsigned n = 0; n < CHECK_NOTES && run->model->notes[n].text; n++)
        if (matches(&run->model->notes[n], run->table.notes[i], value))
            return keep_line(run, n, line, value);
    return log_fail(EXIT_INPUT, "%s:%u: unknown parameter line '%.60s'", run->table.name,
                    line, run->table.notes[i]);
}

static int read_notes(check_run *run)
{
    for (unsigned i = 0; i < run->table.n_notes; i++) {
        const int code = read_note(run, i);
        if (code)
            return code;
    }
    for (unsigned n = 0; n < CHECK_NOTES && run->model->notes[n].text; n++)
        if (run->n_lines[n] == 0)
            return log_fail(EXIT_INPUT, "%s:1: no parameter line '# %.60s'",
                            run->table.name, run->model->notes[n].text);
    return EXIT_DONE;
}

/* -- columns ------------------------------------------------------------------------- */

static int refuse_column(const check_run *run, const char *name)
{
    did_you_mean best = did_you_mean_make(name);
    for (unsigned i = 0; i < run->model->n_columns; i++)
        did_you_mean_offer(&best, run->model->columns[i].name);
    return log_fail(EXIT_INPUT,
                    best.name ? "%s:%u: unknown column '%.40s'; did you mean %s?"
                              : "%s:%u: unknown column '%.40s'",
                    run->table.name, csv_columns_line(&run->table), name, best.name);
}

static int place_column(check_run *run, bool *found, unsigned at)
{
    const char *name = run->table.fields[at];
    for (unsigned i = 0; i < run->model->n_columns; i++) {
        if (strcmp(run->model->columns[i].name, name) != 0)
            continue;
        if (found[i])
            return log_fail(EXIT_INPUT, "%s:%u: column '%s' twice", run->table.name,
                            csv_columns_line(&run->table), name);
        found[i] = true;
        run->place[i] = at;
        return EXIT_DONE;
    }
    return refuse_column(run, name);
}

static int place_columns(check_run *run)
{
    bool found[sizeof run->place / sizeof *run->place] = { false };
    for (unsigned at = 0; at < run->table.n_columns; at++) {
        const int code = place_column(run, found, at);
        if (code)
            return code;
    }
    for (unsigned i = 0; i < run->model->n_columns; i++)
        if (!found[i])
            return log_fail(EXIT_INPUT, "%s:%u: no column '%s'", run->table.name,
                            csv_columns_line(&run->table), run->model->columns[i].name);
    return EXIT_DONE;
}

/* -- the table ----------------------------------------------------------------------- */

static void print_heading(void)
{
    printf("%-22s %-13s %4s %8s %7s %7s %-5s %s\n", "file", "quantity", "rows", "max err",
           "rms err", "budget", "unit", "verdict");
}

/* Prints a quantity.  True: the largest error is within the budget. */
static bool print_quantity(const check_run *run, const check_quantity *q,
                           const check_tally *tally)
{
    const bool good = tally->rows == 0 || tally->worst <= q->budget;
    const double rms = tally->rows ? sqrt(tally->squares / tally->rows) : 0;
    printf("%-22.*s %-13s %4u %8.3g %7.2g %7.3g %-5s %s\n",
           (int)strcspn(run->label, "."), run->label, q->name, tally->rows, tally->worst,
           rms, q->budget, q->unit, tally->rows == 0 ? "no rows" : good ? "ok" : "OVER");
    if (!good) {
        fflush(stdout);
        log_line("%s:%u: %s is off by %.3g %s; %.3g is allowed", run->table.name,
            csv_row_line(&run->table, tally->worst_row), q->name, tally->worst, q->unit,
            q->budget);
    }
    return good;
}

static int print_quantities(const check_run *run)
{
    int code = EXIT_DONE;
    log_progress("");
    for (unsigned i = 0; i < CHECK_QUANTITIES && run->model->quantities[i].name; i++)
        if (!print_quantity(run, &run->model->quantities[i], &run->tally[i]))
            code = EXIT_CHECK;
    return code;
}

/* -- files --------------------------------------------------------------------------- */

static const check_model *find_model(const char *folder, const char *file)
{
    did_you_mean best = did_you_mean_make(file);
    for (size_t i = 0; i < MODELS; i++) {
        if (strcmp(models[i].file, file) == 0)
            return models[i].model;
        did_you_mean_offer(&best, models[i].file);
    }
    if (best.name)
        log_line("%s/%s: no model has this name; did you mean %s?", folder, file,
                 best.name);
    else
        log_line("%s/%s: no model has this name", folder, file);
    return NULL;
}

static int run_model(check_run *run)
{
    if (run->model->run)
        return run->model->run(run);
    for (unsigned row = 0; row < run->table.n_rows; row++)
        run->model->each(run, row, check_row(run, row));
    return EXIT_DONE;
}

static int run_table(check_run *run)
{
    int code = place_columns(run);
    if (!code)
        code = read_notes(run);
    if (!code)
        code = read_rows(run);
    if (!code)
        code = run_model(run);
    return code ? code : print_quantities(run);
}

static int check_file(const char *folder, const char *file)
{
    check_run *run = calloc(1, sizeof *run);
    if (!run)
        return log_fail_memory(sizeof *run);
    int code = EXIT_INPUT;
    char *path = NULL;
    run->label = file;
    run->model = find_model(folder, file);
    if (run->model) {
        path = path_join(folder, file, "");
        code = path ? csv_read(&run->table, path) : log_fail_memory(strlen(folder));
        if (!code)
            code = run_table(run);
        csv_free(&run->table);
    }
    free(path);
    free(run->rows);
    free(run);
    return code;
}

static int is_csv(const struct dirent *entry)
{
    return entry->d_name[0] != '.' && path_ends(entry->d_name, ".csv");
}

static int by_bytes(const struct dirent **a, const struct dirent **b)
{
    return strcmp((*a)->d_name, (*b)->d_name);
}

/* Checks all files, also after a failure.  Returns the largest exit code. */
static int check_folder(const char *folder)
{
    struct dirent **files = NULL;
    const int count = scandir(folder, &files, is_csv, by_bytes);
    if (count < 0)
        return log_fail(EXIT_INPUT, "%s: %s (named by --vectors)", folder, strerror(errno));
    int worst = count ? EXIT_DONE : log_fail(EXIT_INPUT, "%s: no .csv file there", folder);
    if (count)
        print_heading();
    for (int i = 0; i < count; i++) {
        const int code = check_file(folder, files[i]->d_name);
        worst = code > worst ? code : worst;
        free(files[i]);
    }
    free(files);
    return worst;
}

int check_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_CHECK, argc, argv);
    if (!code && o.help) {
        command_help_print(FOR_CHECK);
    } else if (!code) {
        code = o.scene ? check_scene(&o) : check_folder(o.vectors);
    }
    free(o.settings);
    const int end = streams_finish();
    return code ? code : end;
}
