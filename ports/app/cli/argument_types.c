/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "argument_types.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/path.h"
#include "app/fullscreen/fullscreen.h"
#include "app/scene/machine.h"
#include "commands.h"
#include "pixel/pixel.h"
#include "tools/bench/bench_scene.h"
#include "world/text.h"

static bool add(string_list *list, const char *word)
{
    return string_list_add(list, word, strlen(word));
}

static bool add_formats(string_list *list)
{
    bool done = true;
    for (int i = 0; i < TP_FORMAT_COUNT; i++)
        done = done && add(list, tp_format_name((tp_format)i));
    return done;
}

static bool add_visibility(string_list *list)
{
    return string_list_split(list, tp_param_find("quality.visibility", 18)->unit, "|");
}

static bool add_machines(string_list *list)
{
    size_t count;
    bool done = true;
    const machine *of = machine_list(&count);
    for (size_t i = 0; i < count; i++)
        done = done && add(list, of[i].name);
    return done;
}

static bool add_works(string_list *list)
{
    bool done = true;
    for (int i = 0; i < BENCH_WORKS; i++)
        done = done && add(list, bench_work_name[i]);
    return done;
}

/* Adds the names in "fb or kms" that are built in. */
static bool add_ports(string_list *list)
{
    string_list all = { 0 };
    bool done = string_list_split(&all, SHOW_PORTS, " ");
    for (size_t i = 0; i < all.count; i++)
        if (show_port(all.of[i]))
            done = done && add(list, all.of[i]);
    string_list_free(&all);
    return done;
}

static bool add_shells(string_list *list)
{
    return string_list_split(list, "bash zsh fish", " ");
}

static bool add_commands(string_list *list)
{
    bool done = true;
    for (size_t i = 0; i < command_count; i++)
        done = done && add(list, commands[i].name);
    return done;
}

static bool add_scenes(string_list *list)
{
    size_t count = 0;
    bool done = true;
    char *folder = path_of_scenes();
    char **names = folder ? path_scene_names(folder, &count) : NULL;
    for (size_t i = 0; i < count; i++)
        done = done && add(list, names[i]);
    path_free_names(names, count);
    free(folder);
    return done;
}

/* Adds the groups of all parameters, as "wave0.", each once. */
static bool add_groups(string_list *list)
{
    uint32_t count;
    bool done = true;
    const tp_param *of = tp_params(&count);
    for (uint32_t i = 0; i < count && done; i++) {
        const size_t bytes = strcspn(of[i].name, ".") + 1;
        if (i == 0 || strncmp(of[i].name, of[i - 1].name, bytes) != 0)
            done = string_list_add(list, of[i].name, bytes);
    }
    return done;
}

static const struct {
    const char *word;
    argument_type       kind;
    bool      (*fill)(string_list *list);
} rows[] = {
    { "SCENE", ARGUMENT_SCENE, add_scenes },  { "FORMAT", ARGUMENT_WORD, add_formats },
    { "HOW", ARGUMENT_WORD, add_visibility }, { "MACHINE", ARGUMENT_WORD, add_machines },
    { "WORK", ARGUMENT_WORD, add_works },     { "PORT", ARGUMENT_WORD, add_ports },
    { "SHELL", ARGUMENT_WORD, add_shells },   { "COMMAND", ARGUMENT_WORD, add_commands },
    { "GROUP", ARGUMENT_WORD, add_groups },   { "NAME=VALUE", ARGUMENT_SETTING, NULL },
    { "FILE", ARGUMENT_FILE, NULL },          { "FILM.y4m", ARGUMENT_FILE, NULL },
    { "PATH", ARGUMENT_FILE, NULL },          { "DIR", ARGUMENT_FOLDER, NULL },
    { "FOLDER", ARGUMENT_FOLDER, NULL },
};

#define ROWS (sizeof rows / sizeof *rows)

/* Returns the row, or ROWS. */
static size_t find(const char *word)
{
    word += *word == '[';
    const size_t bytes = strcspn(word, "] ");
    for (size_t i = 0; i < ROWS; i++)
        if (strlen(rows[i].word) == bytes && memcmp(rows[i].word, word, bytes) == 0)
            return i;
    return ROWS;
}

argument_type argument_type_find(const char *word)
{
    const size_t i = find(word);
    return i < ROWS ? rows[i].kind : ARGUMENT_ANY;
}

bool argument_type_words(string_list *list, const char *word)
{
    const size_t i = find(word);
    return i == ROWS || !rows[i].fill || rows[i].fill(list);
}

const char *argument_type_choices(const tp_param *param)
{
    return param->kind == TP_PARAM_CHOICE ? param->unit
         : param->kind == TP_PARAM_BOOL ? "off|on" : NULL;
}

void argument_type_describe_range(const tp_param *param, char *text, size_t bytes)
{
    char low[32], high[32];
    switch (param->kind) {
    case TP_PARAM_FX:
    case TP_PARAM_INT:
        tp_param_number_text(param, param->low, low, sizeof low);
        tp_param_number_text(param, param->high, high, sizeof high);
        snprintf(text, bytes, "%s..%s", low, high);
        break;
    case TP_PARAM_BOOL:
    case TP_PARAM_CHOICE:  snprintf(text, bytes, "%s", argument_type_choices(param)); break;
    case TP_PARAM_COLOUR:  snprintf(text, bytes, "#rrggbb"); break;
    case TP_PARAM_MESH:    snprintf(text, bytes, "an OBJ file"); break;
    case TP_PARAM_TEXTURE:
    case TP_PARAM_GREY:    snprintf(text, bytes, "a PNG file"); break;
    case TP_PARAM_TEXT:    snprintf(text, bytes, "a text"); break;
    }
}
