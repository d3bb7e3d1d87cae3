/* SPDX-License-Identifier: MIT */
/* Reads the tables of tests/vectors: numbers separated by commas, below '#' lines and
 * a line of column names. Waves are written as "# wave 0: L=7.2 k=0.86 ... Q=0.69
 * (units)". */
#ifndef TP_TESTS_LIB_VECTORS_H
#define TP_TESTS_LIB_VECTORS_H
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/lib/measure.h"
#include "waves/deep_water.h"

/* -- rows of numbers ----------------------------------------------------------------- */

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

/* -- tables with waves --------------------------------------------------------------- */

#define ROW_COLUMNS 24
#define TURN        6.28318530717958647692

/* A wave of the models in double precision; the angular frequency is omega = sqrt(g k). */
typedef struct {
    double k, omega, dx, dz, phase, amplitude, q;
} row_wave;

typedef struct {
    FILE    *file;
    row_wave wave[TP_WAVES];
    int      waves, columns;
    double   at[ROW_COLUMNS];   /* values of the current row */
    int      rows;              /* rows read until now */
} vector_table;

static inline double row_letter(const char *line, const char *name)
{
    const char *const at = strstr(line, name);
    assert_non_null(at);
    return strtod(at + strlen(name), NULL);
}

static inline vector_table rows_of(const char *name)
{
    char path[64];
    snprintf(path, sizeof path, "tests/vectors/%s.csv", name);
    const vector_table r = { .file = fopen(path, "r") };
    assert_non_null(r.file);
    return r;
}

/* Reads the next row.  Returns false after the last row and closes the file. */
static inline bool rows_next(vector_table *r)
{
    char line[1024];

    while (fgets(line, sizeof line, r->file)) {
        if (strncmp(line, "# wave ", 7) == 0)
            r->wave[r->waves++] = (row_wave){
                row_letter(line, " k="), row_letter(line, " omega="),
                row_letter(line, " Dx="), row_letter(line, " Dz="),
                row_letter(line, " phase="), row_letter(line, " A="),
                row_letter(line, " Q="),
            };
        if (strchr("#abcdefghijklmnopqrstuvwxyzL", line[0]))
            continue;
        char *at = line;
        for (r->columns = 0; *at && r->columns < ROW_COLUMNS; at += *at == ',')
            r->at[r->columns++] = strtod(at, &at);
        r->rows++;
        return true;
    }
    fclose(r->file);
    return false;
}

static inline tp_fx row_fx(double x)
{
    return (tp_fx)lround(x * 65536);
}

static inline tp_turn row_turn(double radians)
{
    const double turns = radians / TURN;
    return (tp_turn)(uint64_t)llround((turns - floor(turns)) * 4294967296.0);
}

static inline tp_wave_exact row_exact(const row_wave *w)
{
    return (tp_wave_exact){
        .turns = (uint64_t)llround(w->k / TURN * 4294967296.0),
        .dx = (tp_q30)lround(w->dx * TP_Q30_ONE),
        .dz = (tp_q30)lround(w->dz * TP_Q30_ONE),
        .amplitude = row_fx(w->amplitude),
        .steepness = (tp_q30)lround(w->q * w->k * w->amplitude * TP_Q30_ONE),
    };
}

/* Deep water of the table's waves, with the table's Q times q, where q is 0 or 1. */
static inline void rows_sea(const vector_table *r, double q, tp_deep_water *deep)
{
    *deep = (tp_deep_water){ .count = 0 };
    for (int i = 0; i < r->waves; i++) {
        tp_wave_exact exact = row_exact(&r->wave[i]);
        exact.steepness = (tp_q30)(exact.steepness * q);
        tp_deep_water_append_wave(deep, &exact);
    }
    assert_int_equal(deep->count, r->waves);
    assert_false(deep->clamped);
    assert_false(deep->capped);
}

static inline void rows_phases(const vector_table *r, double t, tp_turn phases[TP_WAVES])
{
    for (int i = 0; i < r->waves; i++)
        phases[i] = row_turn(r->wave[i].phase - r->wave[i].omega * t);
}

/* Angle between a point's normal and a unit vector, in degrees. */
static inline double row_angle(const tp_surface_point *p, const double n[3])
{
    const double x = -p->slope_x / 65536.0, z = -p->slope_z / 65536.0;
    const double cx = n[2] - z * n[1], cy = z * n[0] - x * n[2], cz = x * n[1] - n[0];
    return atan2(sqrt(cx * cx + cy * cy + cz * cz), x * n[0] + n[1] + z * n[2])
         * 360 / TURN;
}

static inline double row_error(tp_fx got, double want)
{
    return got / 65536.0 - want;
}
#endif
