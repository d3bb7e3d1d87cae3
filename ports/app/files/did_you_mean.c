/* SPDX-License-Identifier: MIT */
/* Finds the nearest known name by the Levenshtein distance: the least number of insertions,
 * deletions and changes of letters from one word to the other (Wagner and Fischer 1974,
 * with one row stored). */
#include "did_you_mean.h"
#include <string.h>

#define LETTERS 64          /* longer words are not compared */

static unsigned least(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

static unsigned distance(const char *a, const char *b)
{
    const size_t n = strlen(b);
    unsigned row[LETTERS + 1];
    for (unsigned j = 0; j <= n; j++)
        row[j] = j;
    for (size_t i = 0; a[i]; i++) {
        unsigned diagonal = row[0];
        row[0] = (unsigned)i + 1;
        for (size_t j = 0; j < n; j++) {
            const unsigned change = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = least(change, 1 + least(row[j], row[j + 1]));
        }
    }
    return row[n];
}

/* Allows at most a third of the letters plus 1 to differ: more is no typing error. */
did_you_mean did_you_mean_make(const char *wanted)
{
    return (did_you_mean){ wanted, NULL, (unsigned)(strlen(wanted) / 3) + 2 };
}

void did_you_mean_offer(did_you_mean *best, const char *name)
{
    if (strlen(best->wanted) > LETTERS || strlen(name) > LETTERS)
        return;
    const unsigned d = distance(best->wanted, name);
    if (d < best->distance) {
        best->distance = d;
        best->name = name;
    }
}
