/* SPDX-License-Identifier: MIT */
#include "string_list.h"
#include <stdlib.h>
#include <string.h>
#include "path.h"

bool string_list_add(string_list *list, const char *text, size_t bytes)
{
    char **more = realloc(list->of, (list->count + 1) * sizeof *more);
    if (more)
        list->of = more;
    char *copy = more ? path_copy(text, bytes) : NULL;
    if (copy)
        list->of[list->count++] = copy;
    return copy;
}

bool string_list_split(string_list *list, const char *text, const char *separators)
{
    for (;;) {
        text += strspn(text, separators);
        const size_t bytes = strcspn(text, separators);
        if (!bytes)
            return true;
        if (!string_list_add(list, text, bytes))
            return false;
        text += bytes;
    }
}

int string_list_find(const string_list *list, const char *text)
{
    for (size_t i = 0; i < list->count; i++)
        if (strcmp(list->of[i], text) == 0)
            return (int)i;
    return -1;
}

void string_list_free(string_list *list)
{
    for (size_t i = 0; i < list->count; i++)
        free(list->of[i]);
    free(list->of);
    *list = (string_list){ 0 };
}
