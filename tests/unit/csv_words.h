/* SPDX-License-Identifier: MIT */
/* Reads rows of the models' test vectors with a word as last column; see csv_rows.h. */
#ifndef TP_TESTS_CSV_WORDS_H
#define TP_TESTS_CSV_WORDS_H
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Reads the next row's numbers and the word behind the numbers.  Returns the count of
 * numbers, 0 at the end of the file. */
static inline int csv_row_word(FILE *file, double *number, int most, char word[16])
{
    char line[2048];
    int n = 0;

    do {
        if (fgets(line, sizeof line, file) == NULL)
            return 0;
    } while (!isdigit((unsigned char)line[0]) && line[0] != '-');
    for (char *at = strtok(line, ",\r\n"); at != NULL; at = strtok(NULL, ",\r\n")) {
        if (isalpha((unsigned char)at[0]))
            snprintf(word, 16, "%s", at);
        else if (n < most)
            number[n++] = strtod(at, NULL);
    }
    return n;
}
#endif
