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

/* Adds a word.  False: no memory, with the list unchanged. */
bool words_add(words *list, const char *text, size_t bytes);

/* Adds the words between separators; empty words are skipped. */
bool words_cut(words *list, const char *text, const char *separators);

/* Returns the index of a word, from 0; -1: not found. */
int  words_find(const words *list, const char *text);
void words_free(words *list);
#endif
