/* SPDX-License-Identifier: MIT */
/* Reads rows of the models' test vectors: numbers separated by commas, below a header and
 * comments. */
#ifndef TP_TESTS_CSV_ROWS_H
#define TP_TESTS_CSV_ROWS_H
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>

/* Reads the next row's numbers.  Returns their count, 0 at the end of the file. */
static inline int csv_row(FILE *file, double *number, int most)
{
    char line[2048];

    while (fgets(line, sizeof line, file) != NULL) {
        if (!isdigit((unsigned char)line[0]) && line[0] != '-')
            continue;
        int n = 0;
        for (char *at = line; n < most;) {
            char *end;
            number[n++] = strtod(at, &end);
            if (*end != ',')
                break;
            at = end + 1;
        }
        return n;
    }
    return 0;
}
#endif
