/* SPDX-License-Identifier: MIT */
/* Listings under version control: one line for each case, "CASE: VALUES".  A test computes
 * the values of each case and compares.  The option --write lists all cases anew; the
 * commit message must give the reason for the change. */
#ifndef TP_TESTS_LIB_LISTING_H
#define TP_TESTS_LIB_LISTING_H
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum { LISTING_CASE = 128, LISTING_VALUES = 1920, LISTING_MOST = 400,
       LISTING_LINE = LISTING_CASE + 2 + LISTING_VALUES };

typedef struct {
    const char *path;
    char     line[LISTING_MOST][LISTING_LINE];
    uint32_t count;
    bool     write;
} listing;

static inline void listing_read(listing *l, const char *path, int argc, char **argv)
{
    FILE *file = fopen(path, "r");

    l->path = path;
    l->count = 0;
    l->write = argc == 2 && strcmp(argv[1], "--write") == 0;
    while (file && l->count < LISTING_MOST
           && fgets(l->line[l->count], LISTING_LINE, file)) {
        l->line[l->count][strcspn(l->line[l->count], "\n")] = '\0';
        l->count++;
    }
    if (file)
        fclose(file);
}

static inline void listing_write(const listing *l)
{
    FILE *file = l->write ? fopen(l->path, "w") : NULL;

    for (uint32_t i = 0; file && i < l->count; i++)
        fprintf(file, "%s\n", l->line[i]);
    if (file)
        fclose(file);
}

/* Copies the case name of line i. */
static inline void listing_case(const listing *l, uint32_t i, char to[LISTING_CASE])
{
    snprintf(to, LISTING_CASE, "%.*s", (int)strcspn(l->line[i], ":"), l->line[i]);
}

/* True if line i is "OF: VALUES".  Otherwise prints the first word that differs, or stores
 * the new line when writing. */
static inline bool listing_holds(listing *l, uint32_t i, const char *of,
                                 const char *values)
{
    char now[LISTING_LINE];
    char *listed = l->line[i];
    size_t at = 0;

    snprintf(now, sizeof now, "%s: %s", of, values);
    while (listed[at] && listed[at] == now[at])
        at++;
    if (listed[at] == now[at])
        return true;
    while (at > 0 && listed[at - 1] != ' ')
        at--;
    printf("%s:%u: %s: listed %.60s, is %.60s\n", l->path, (unsigned)i + 1, of,
           listed + at, now + at);
    if (l->write)
        memcpy(listed, now, sizeof now);
    return l->write;
}
#endif
