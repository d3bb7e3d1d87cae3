/* SPDX-License-Identifier: MIT */
/* Lists of words that grow. */
#ifndef TP_APP_FILES_STRING_LIST_H
#define TP_APP_FILES_STRING_LIST_H
#include <stdbool.h>
#include <stddef.h>

typedef struct {
    char **of;
    size_t count;
} string_list;

/* Adds a word.  False: no memory, with the list unchanged. */
bool string_list_add(string_list *list, const char *text, size_t bytes);

/* Adds the words between separators; empty words are skipped. */
bool string_list_split(string_list *list, const char *text, const char *separators);

/* Returns the index of a word, from 0; -1: not found. */
int  string_list_find(const string_list *list, const char *text);
void string_list_free(string_list *list);
#endif
