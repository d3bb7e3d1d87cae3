/* SPDX-License-Identifier: MIT */
/* What the words of usage lines and of the table of options stand for: FORMAT is one of
 * a few words, FILE a file, NAME=VALUE a parameter's setting. */
#ifndef HOST_TAKES_H
#define HOST_TAKES_H
#include <stdbool.h>
#include "tidepool/scene.h"
#include "words.h"

typedef enum {
    TAKES_ANY,                  /* a number or a name: nothing can be offered */
    TAKES_WORD,                 /* one of takes_words */
    TAKES_SCENE,                /* one of them, or an INI file */
    TAKES_FILE,
    TAKES_FOLDER,
    TAKES_SETTING
} takes;

/* "[SCENE] [OPTION]..." is SCENE: brackets and dots are left off, and more words. */
takes takes_of(const char *word);

/* Adds what may stand for it; false: no memory. */
bool takes_words(words *list, const char *word);

/* A parameter's values, "0..1", "nearest|linear", "a PNG file". */
void takes_range(const tp_param *param, char *text, size_t bytes);

/* Those of a switch or a choice, "off|on"; NULL: they cannot be listed. */
const char *takes_choice(const tp_param *param);
#endif
