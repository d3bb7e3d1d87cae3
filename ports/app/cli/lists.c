/* SPDX-License-Identifier: MIT */
/* tidepool scenes and tidepool params: lists the scenes and the parameters. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "app/scene/loaded_scene.h"
#include "args.h"
#include "argument_types.h"
#include "command_help.h"
#include "commands.h"

/* -- scenes -------------------------------------------------------------------------- */

static int list_scenes(const char *folder)
{
    size_t count;
    int code = EXIT_DONE, width = 0;
    char **names = path_scene_names(folder, &count);
    for (size_t i = 0; i < count; i++)
        width = (int)strlen(names[i]) > width ? (int)strlen(names[i]) : width;
    for (size_t i = 0; i < count; i++) {
        scene_file file;
        const int bad = scene_file_open(&file, names[i]);
        if (bad)
            code = bad;
        else
            printf("%-*s  %s\n", width, names[i], file.scene.description);
        scene_file_close(&file);
    }
    path_free_names(names, count);
    return code;
}

int scenes_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_SCENES, argc, argv);
    if (!code && o.help) {
        command_help_print(FOR_SCENES);
    } else if (!code) {
        char *folder = path_of_scenes();
        code = folder ? list_scenes(folder)
                      : log_fail(EXIT_INPUT, "tidepool: no shipped scenes were found beside"
                             " the program");
        free(folder);
    }
    free(o.settings);
    const int end = streams_finish();
    return code ? code : end;
}

/* -- params -------------------------------------------------------------------------- */

enum { NAME, VALUE, UNIT, RANGE, COLUMNS };

#define CELL_BYTES (TP_NAME_BYTES + 16)

typedef char param_row_cells[COLUMNS][CELL_BYTES];

static void fill(param_row_cells row, const tp_scene *scene, const tp_param *param)
{
    snprintf(row[NAME], CELL_BYTES, "%s", param->name);
    tp_param_text(scene, param, row[VALUE], CELL_BYTES);
    snprintf(row[UNIT], CELL_BYTES, "%s",
             param->kind == TP_PARAM_CHOICE ? "" : param->unit);
    argument_type_describe_range(param, row[RANGE], CELL_BYTES);
}

static void print_row(param_row_cells row, const int width[COLUMNS], const char *help)
{
    for (int i = 0; i < COLUMNS; i++)
        printf("%-*s  ", width[i], row[i]);
    puts(help);
}

static bool is_listed(const tp_param *param, const char *only)
{
    return !only || strncmp(param->name, only, strlen(only)) == 0;
}

/* True if both names have the same group, as "wave0.". */
static bool share_group(const tp_param *a, const tp_param *b)
{
    const size_t n = strcspn(a->name, ".") + 1;
    return strncmp(a->name, b->name, n) == 0;
}

/* Sets each column's width to the widest of the listed rows; returns the number of rows. */
static uint32_t measure(const tp_scene *scene, const char *only, int width[COLUMNS])
{
    uint32_t count, listed = 0;
    const tp_param *params = tp_params(&count);
    for (uint32_t i = 0; i < count; i++) {
        param_row_cells row;
        if (!is_listed(&params[i], only))
            continue;
        listed++;
        fill(row, scene, &params[i]);
        for (int k = 0; k < COLUMNS; k++)
            width[k] = (int)strlen(row[k]) > width[k] ? (int)strlen(row[k]) : width[k];
    }
    return listed;
}

/* Prints the table, with an empty line between groups. */
static int print_table(const tp_scene *scene, const char *value_title, const char *only)
{
    uint32_t count;
    const tp_param *params = tp_params(&count), *last = NULL;
    param_row_cells row = { "name", "", "unit", "range" };
    int width[COLUMNS] = { 4, (int)strlen(value_title), 4, 5 };
    if (measure(scene, only, width) == 0)
        return log_fail(EXIT_USAGE, "tidepool params: no name begins with %s", only);
    strcpy(row[VALUE], value_title);
    print_row(row, width, "meaning");
    for (uint32_t i = 0; i < count; i++) {
        if (!is_listed(&params[i], only))
            continue;
        if (!last || !share_group(last, &params[i]))
            puts("");
        last = &params[i];
        fill(row, scene, last);
        print_row(row, width, last->help);
    }
    return EXIT_DONE;
}

static int print_defaults(const options *o)
{
    tp_scene scene;
    tp_scene_level(&scene);
    return print_table(&scene, "default", o->only);
}

static int print_scene(const options *o)
{
    scene_file file;
    tp_deep_water deep;
    int code = loaded_scene_read(&file, o);
    if (!code) {
        tp_deep_water_init(&deep, file.scene.wave, TP_WAVES, file.scene.water.gravity);
        code = print_table(&file.scene, "value", o->only);
        loaded_scene_report_clamps(&file, &deep);
    }
    scene_file_close(&file);
    return code;
}

int params_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_PARAMS, argc, argv);
    if (!code && o.help) {
        command_help_print(FOR_PARAMS);
    } else if (!code && !o.scene && o.n_settings) {
        code = log_fail(EXIT_USAGE, "tidepool params: --set needs a scene");
    } else if (!code && !o.scene) {
        code = print_defaults(&o);
    } else if (!code) {
        code = print_scene(&o);
    }
    free(o.settings);
    const int end = streams_finish();
    return code ? code : end;
}
