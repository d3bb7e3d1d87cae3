/* SPDX-License-Identifier: MIT */
/* tidepool-scene(5): the file of a scene and all parameters by groups.  Of groups that
 * differ only in their number (wave0 to wave15) only the first is printed. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include "argument_types.h"
#include "interact/old_names.h"
#include "manual.h"
#include "roff.h"

static void print_file(void)
{
    roff_macro(".SH DESCRIPTION");
    roff_text("A scene is a text of sections and lines. A parameter without a line has its"
              " default; an empty file is a scene. If a parameter has two lines, the last"
              " counts. Comments begin with ; or #, lines have up to 4351 bytes. Names of"
              " files are relative to the scene's own folder. An error in the file is"
              " reported with its line, and the scene is refused.");
    roff_macro(".PP");
    roff_text("A mesh is an OBJ file with its MTL files and PNG pictures. Missing pictures,"
              " pictures of another format, undefined materials, unreadable lines of an"
              " MTL and faces of fewer than three corners are left out, each with a"
              " warning; ");
    roff_bold("--strict");
    roff_text(" turns the warnings into errors.");
    roff_macro(".PP");
    roff_text("Some parameters had another name. The old name is read until version "
              OLD_NAMES_END ", with a warning; ");
    roff_bold("tidepool check SCENE --write");
    roff_text(" rewrites old names in a file and keeps all else.");
    roff_macro(".PP");
    roff_text("On a command line ");
    roff_bold("--set section.name=value");
    roff_text(" overrides the file.");
    roff_macro(".SH EXAMPLE");
    roff_macro(".EX");
    roff_macro("[scene]\ntitle = Evening\n[wave0]\namplitude = 0.6 ; m\nlength = 12\n"
               "[light]\ncolour = #ffd0a0");
    roff_macro(".EE");
}

/* Splits "wave12.length": returns the length of "wave"; *number = 12, or -1 without a
 * number; *rest = ".length". */
static size_t split(const char *name, long *number, const char **rest)
{
    const size_t letters = strcspn(name, "0123456789."), dot = strcspn(name, ".");
    *number = -1;
    if (letters < dot)
        sscanf(name + letters, "%ld", number);
    *rest = name + dot;
    return letters;
}

/* True if two parameters are the same except for the number of their group. */
static bool alike(const tp_param *a, const tp_param *b)
{
    long m, n;
    const char *x, *y;
    const size_t bytes = split(a->name, &m, &x);
    return bytes == split(b->name, &n, &y) && memcmp(a->name, b->name, bytes) == 0
        && m >= 0 && n >= 0 && strcmp(x, y) == 0 && strcmp(a->unit, b->unit) == 0
        && strcmp(a->help, b->help) == 0 && a->kind == b->kind && a->low == b->low
        && a->high == b->high && a->normal == b->normal;
}

static bool share_group(const tp_param *a, const tp_param *b)
{
    const size_t bytes = strcspn(a->name, ".") + 1;
    return strncmp(a->name, b->name, bytes) == 0;
}

/* Returns the number of rows of a group, from `first` on. */
static uint32_t group_size(const tp_param *first, const tp_param *end)
{
    uint32_t size = 0;
    while (first + size < end && share_group(first, first + size))
        size++;
    return size;
}

/* Returns the number of equal groups from `first` on, `first` included; their numbers
 * differ. */
static uint32_t repeats(const tp_param *first, uint32_t size, const tp_param *end)
{
    uint32_t count = 1;
    for (; first + (count + 1) * size <= end; count++)
        for (uint32_t i = 0; i < size; i++)
            if (!alike(&first[i], &first[count * size + i]))
                return count;
    return count;
}

/* Prints "0..16 m; 0", and the meaning. */
static void print_param(const tp_param *param, bool numbered)
{
    tp_scene scene;
    char range[96], value[TP_NAME_BYTES + 16], name[64];
    long number;
    const char *rest;
    const int letters = (int)split(param->name, &number, &rest);
    if (numbered)
        snprintf(name, sizeof name, "%.*sN%s", letters, param->name, rest);
    else
        snprintf(name, sizeof name, "%s", param->name);
    tp_scene_level(&scene);
    tp_param_text(&scene, param, value, sizeof value);
    argument_type_describe_range(param, range, sizeof range);
    roff_macro(".TP");
    roff_bold(name);
    roff_text("  ");
    roff_text(range);
    if (*param->unit && !argument_type_choices(param)) {
        roff_text(" ");
        roff_text(param->unit);
    }
    if (*value) {
        roff_text("; ");
        roff_text(value);
    }
    roff_end();
    roff_text(param->help);
}

static void print_groups(void)
{
    uint32_t count;
    const tp_param *at = tp_params(&count), *end = at + count;
    roff_macro(".SH PARAMETERS");
    roff_text("Each parameter with its range, unit and default.");
    while (at < end) {
        const uint32_t size = group_size(at, end), times = repeats(at, size, end);
        const int first = (int)strcspn(at->name, ".");
        const tp_param *last = at + (times - 1) * size;
        if (times > 1)
            roff_macro(".SS %.*s to %.*s", first, at->name, (int)strcspn(last->name, "."),
                       last->name);
        else
            roff_macro(".SS %.*s", first, at->name);
        for (uint32_t i = 0; i < size; i++)
            print_param(&at[i], times > 1);
        at += times * size;
    }
}

void manual_scene(void)
{
    manual_head("TIDEPOOL-SCENE", 5, "File Formats",
                "tidepool-scene - the file of a scene, and its parameters");
    print_file();
    print_groups();
    roff_macro(".SH SEE ALSO");
    roff_bold("tidepool");
    roff_text("(1)");
    roff_end();
}
