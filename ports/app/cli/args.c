/* SPDX-License-Identifier: MIT */
/* Reads command lines by the table of options. */
#include "args.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/did_you_mean.h"
#include "app/files/log.h"
#include "args_rows.h"

#define FIRST_SCENE "three-swells"      /* scene of view without a name */
#define HELP_COLUMNS 60                 /* width of a line of names, without punctuation */

/* Prints the names of the rarely used options, without their help. */
static void print_rare(unsigned command)
{
    const char *before = "  also ";
    size_t column = 0;
    for (size_t i = 0; i < args_row_count; i++) {
        const option_row *row = &args_rows[i];
        char text[32];
        if (!(row->commands & RARE) || !(row->commands & command))
            continue;
        const int bytes = snprintf(text, sizeof text, "%s%s%s", row->name,
                                   row->value ? " " : "", row->value ? row->value : "");
        if (column + (size_t)bytes + strlen(before) > HELP_COLUMNS) {
            before = ",\n       ";
            column = 0;
        }
        printf("%s%s", before, text);
        column += (size_t)bytes + strlen(before);
        before = ", ";
    }
    if (column)
        puts(": see `man tidepool`");
}

void args_print(unsigned command)
{
    for (size_t i = 0; i < args_row_count; i++) {
        const option_row *row = &args_rows[i];
        char left[32];
        if (!(row->commands & command) || row->commands & RARE)
            continue;
        snprintf(left, sizeof left, "%s %s", row->name, row->value ? row->value : "");
        printf("  %-18s %s\n", left, row->help);
    }
    print_rare(command);
}

static int refuse(const options *o, const char *what)
{
    return log_fail(EXIT_USAGE, "tidepool %s: %s; see `tidepool %s --help`", o->command,
                    what, o->command);
}

static int refuse_option(const options *o, unsigned command, const char *name)
{
    char what[160];
    const char *meant = NULL;
    did_you_mean best = did_you_mean_make(name + strspn(name, "-"));
    for (size_t i = 0; i < args_row_count; i++) {
        const char *row = args_rows[i].name;
        const unsigned distance = best.distance;
        if (args_rows[i].commands & command)
            did_you_mean_offer(&best, row + strspn(row, "-"));
        if (best.distance < distance)
            meant = row;
    }
    snprintf(what, sizeof what, meant ? "no option %.60s; did you mean %s?"
                                      : "no option %.60s", name, meant);
    return refuse(o, what);
}

static const option_row *find_option_row(unsigned command, const char *word, size_t length)
{
    for (const option_row *row = args_rows; row < args_rows + args_row_count; row++)
        if ((row->commands & command) && strlen(row->name) == length
            && memcmp(row->name, word, length) == 0)
            return row;
    return NULL;
}

/* Reads "--name value" or "--name=value".  Advances *i if the value is a separate word. */
static int read_option(options *o, unsigned command, int argc, char **argv, int *i)
{
    const char *word = argv[*i], *equals = strchr(word, '=');
    const size_t length = equals ? (size_t)(equals - word) : strlen(word);
    char what[160];
    const bool is_help = strcmp(word, "-h") == 0;
    const option_row *row = is_help ? find_option_row(command, "--help", strlen("--help"))
                                    : find_option_row(command, word, length);
    if (!row || (!row->value && equals))
        return refuse_option(o, command, word);
    const char *value = equals ? equals + 1 : row->value ? argv[++*i] : "";
    if (row->value && *i >= argc) {
        snprintf(what, sizeof what, "%s needs a value", row->name);
        return refuse(o, what);
    }
    const char *expected = row->read(o, value);
    if (!expected)
        return EXIT_DONE;
    snprintf(what, sizeof what, "%s %.40s: expected %s", row->name, *value ? value : "''",
             expected);
    return refuse(o, what);
}

/* Checks for missing arguments and for options that exclude each other. */
static int check(const options *o, unsigned command)
{
    const bool all = !o->help;
    if (o->rungs && o->peers)
        return refuse(o, "--rungs and --peers exclude each other");
    if (o->list + o->collect + o->resume > 1)
        return refuse(o, "--list, --collect and --resume exclude each other");
    if (o->play && o->tape)
        return refuse(o, "--play and --tape exclude each other");
    if (o->play && o->resume)
        return refuse(o, "--play and --resume exclude each other");
    if (!o->scene && all && (command & (FOR_RENDER | FOR_SHOW | FOR_BAKE | FOR_PLAN)))
        return refuse(o, "SCENE is missing");
    if (!o->scene && all && (command & FOR_COMPLETION))
        return refuse(o, "SHELL is missing: bash, zsh or fish");
    if (!o->out && all && (command & FOR_BAKE))
        return refuse(o, "-o FILE.c is missing");
    if (o->hold && !o->counted)
        return refuse(o, "--hold needs --frames");
    if (all && (command & FOR_CHECK) && !o->scene == !o->vectors)
        return refuse(o, o->scene ? "SCENE and --vectors exclude each other"
                                  : "SCENE or --vectors DIR is missing");
    if (o->write && o->vectors)
        return refuse(o, "--write and --vectors exclude each other");
    if (!all || !(command & MANY))
        return EXIT_DONE;
    const uint32_t least = o->list ? 0 : command & FOR_JOIN || o->collect ? 2 : 1;
    if (o->n_names < least)
        return refuse(o, least == 1 ? "DIR is missing" : command & FOR_JOIN
                      ? "needs FILM.y4m and PART.y4m" : "needs FILE and DIR");
    if (command & FOR_CHARTS && !o->collect && o->n_names > least)
        return refuse(o, "too many names");
    return EXIT_DONE;
}

static int read_name(options *o, unsigned command, const char *word)
{
    char what[160];
    if (!*word)
        return refuse(o, "a name is empty");
    if (command & MANY) {
        o->names[o->n_names++] = word;
        return EXIT_DONE;
    }
    if (o->scene || (command & (FOR_SCENES | FOR_BENCH | FOR_MANUAL | FOR_VERSION))) {
        snprintf(what, sizeof what, "too many names: %.60s", word);
        return refuse(o, what);
    }
    o->scene = word;
    return EXIT_DONE;
}

/* Words after "--" are names.  "-" is a name too, where a command takes several names: it
 * means standard input or output. */
int args_read(options *o, unsigned command, int argc, char **argv)
{
    bool names = false;
    const bool board = command == FOR_BAKE;
    *o = (options){ .command = argv[0], .width = board ? 320 : 640,
                    .height = board ? 240 : 480, .every = 1, .work = -1,
                    .format = board ? TP_FORMAT_RGB565 : TP_FORMAT_XRGB8888 };
    o->settings = calloc(2 * (size_t)argc, sizeof *o->settings);
    if (!o->settings)
        return log_fail_memory(2 * (size_t)argc * sizeof *o->settings);
    o->names = o->settings + argc;
    for (int i = 1; i < argc; i++) {
        int code = EXIT_DONE;
        const bool dash = argv[i][0] == '-' && (argv[i][1] || !(command & MANY));
        if (!names && strcmp(argv[i], "--") == 0)
            names = true;
        else if (dash && !names)
            code = read_option(o, command, argc, argv, &i);
        else
            code = read_name(o, command, argv[i]);
        if (code)
            return code;
    }
    if (command & FOR_VIEW && !o->scene)
        o->scene = FIRST_SCENE;
    return check(o, command);
}
