/* SPDX-License-Identifier: MIT */
/* Lists of words that grow. */
#ifndef HOST_WORDS_H
#define HOST_WORDS_H
#include <stdbool.h>
#include <stddef.h>

typedef struct {
    char **of;
    size_t count;
} words;

/* False: no memory, and the list is as it was. */
bool words_add(words *list, const char *text, size_t bytes);

/* Adds what lies between separators, which is never empty. */
bool words_cut(words *list, const char *text, const char *separators);

/* Where a word is, from 0; -1: it is not there. */
int  words_find(const words *list, const char *text);
void words_free(words *list);
#endif
