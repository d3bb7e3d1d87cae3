/* SPDX-License-Identifier: MIT */
/* Types of arguments: the meaning of placeholders in usage lines and in the table of
 * options.  FORMAT stands for one of a few words, FILE for a file, NAME=VALUE for a
 * parameter's setting. */
#ifndef HOST_TAKES_H
#define HOST_TAKES_H
#include <stdbool.h>
#include "tidepool/scene.h"
#include "words.h"

typedef enum {
    TAKES_ANY,                  /* number or free name: nothing to complete */
    TAKES_WORD,                 /* one of takes_words */
    TAKES_SCENE,                /* one of takes_words, or an INI file */
    TAKES_FILE,
    TAKES_FOLDER,
    TAKES_SETTING
} takes;

/* Returns the type of a placeholder.  Brackets, dots and further words are ignored:
 * "[SCENE] [OPTION]..." means SCENE. */
takes takes_find_kind(const char *word);

/* Adds the possible words; false: no memory. */
bool takes_words(words *list, const char *word);

/* Writes a parameter's values: "0..1", "nearest|linear", "a PNG file". */
void takes_range(const tp_param *param, char *text, size_t bytes);

/* Returns the values of a switch or choice, "off|on"; NULL: not a list. */
const char *takes_choice(const tp_param *param);
#endif
