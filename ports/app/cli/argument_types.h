/* SPDX-License-Identifier: MIT */
/* Types of arguments: the meaning of placeholders in usage lines and in the table of
 * options.  FORMAT stands for one of a few words, FILE for a file, NAME=VALUE for a
 * parameter's setting. */
#ifndef TP_APP_CLI_ARGUMENT_TYPES_H
#define TP_APP_CLI_ARGUMENT_TYPES_H
#include <stdbool.h>
#include "app/files/string_list.h"
#include "tidepool/scene.h"

typedef enum {
    ARGUMENT_ANY,                  /* number or free name: nothing to complete */
    ARGUMENT_WORD,                 /* one of argument_type_words */
    ARGUMENT_SCENE,                /* one of argument_type_words, or an INI file */
    ARGUMENT_FILE,
    ARGUMENT_FOLDER,
    ARGUMENT_SETTING
} argument_type;

/* Returns the type of a placeholder.  Brackets, dots and further words are ignored:
 * "[SCENE] [OPTION]..." means SCENE. */
argument_type argument_type_find(const char *word);

/* Adds the possible words; false: no memory. */
bool argument_type_words(string_list *list, const char *word);

/* Writes a parameter's values: "0..1", "nearest|linear", "a PNG file". */
void argument_type_describe_range(const tp_param *param, char *text, size_t bytes);

/* Returns the values of a switch or choice, "off|on"; NULL: not a list. */
const char *argument_type_choices(const tp_param *param);
#endif
