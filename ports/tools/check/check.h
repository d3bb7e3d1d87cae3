/* SPDX-License-Identifier: MIT */
/* tidepool check: compares the fixed-point models with tables of known values.
 *
 * A model describes one file: columns, parameter lines, quantities with their budgets, and
 * a function that evaluates the rows.  A new file needs a description in a check_*.c and a
 * line in the list below. */
#ifndef TP_TOOLS_CHECK_CHECK_H
#define TP_TOOLS_CHECK_CHECK_H
#include <stdbool.h>
#include <stddef.h>
#include "app/files/csv.h"
#include "app/files/log.h"
#include "tidepool/fixed.h"

#define CHECK_MODELS(X) \
    X(automaton_int) X(automaton_mode) X(automaton_settle_table) X(breaking) \
    X(breaking_criteria) X(buoyancy) X(dispersion) X(drop_bounce) X(droplet_waves) \
    X(exposure) X(fr_orbit) X(fresnel) X(fresnel_rough) X(gerstner_single) \
    X(gerstner_sum) X(lobe) X(reflect_refract) X(sharp_sine) X(shoaling_phase) X(sine) \
    X(sum_of_sines) X(time_scale) X(wind_phase)

enum { CHECK_QUANTITIES = 9, CHECK_NOTES = 3, CHECK_LINES = 16 };

typedef enum {
    CHECK_NUMBER,
    CHECK_WHOLE,                /* integer */
    CHECK_WORD,                 /* one of `words`, "a|b|c"; value: its index, from 0 */
    CHECK_TEXT                  /* text, read by check_text */
} check_kind;

/* A column, or a number in a parameter line; numbers outside low..high are refused. */
typedef struct {
    const char *name;
    double      low, high;
    check_kind  kind;
    const char *words;
} check_field;

/* A parameter line: each '%' in `text` stands for a number. */
typedef struct {
    const char        *text;
    const check_field *numbers;
    unsigned           count;       /* number of '%' */
    bool               list;        /* false: one line; true: up to CHECK_LINES lines, the
                                     * first number in each is the line's index, from 0 */
} check_note;

typedef struct {
    const char *name, *unit;
    double      budget;         /* largest allowed error, in `unit` */
} check_quantity;

typedef struct check_run check_run;

typedef struct {
    const check_field *columns;
    unsigned           n_columns;
    check_note         notes[CHECK_NOTES];
    check_quantity     quantities[CHECK_QUANTITIES];
    /* Exactly one is set.  each: called once per row, v = values in the model's order.
     * run: called once for all rows; returns EXIT_INPUT after printing the reason. */
    void             (*each)(check_run *run, unsigned row, const double *v);
    int              (*run)(check_run *run);
} check_model;

/* An array and its length, as two initialisers. */
#define CHECK_ALL(array) (array), sizeof (array) / sizeof *(array)

typedef struct {
    unsigned rows, worst_row;
    double   worst, squares;
} check_tally;

struct check_run {
    const check_model *model;
    csv          table;
    const char  *label;                     /* name of the file without folder */
    unsigned     place[32];                 /* of the model's columns in the file */
    double      *rows;                      /* values of all rows, in the model's order */
    unsigned     n_lines[CHECK_NOTES];      /* lines found; line_at: line numbers */
    unsigned     line_at[CHECK_NOTES][CHECK_LINES];
    double       lines[CHECK_NOTES][CHECK_LINES][12];
    check_tally  tally[CHECK_QUANTITIES];
};

#define X(name) extern const check_model check_##name;
CHECK_MODELS(X)
#undef X

/* Returns the values of a row, in the model's order. */
const double *check_row(const check_run *run, unsigned row);
const char   *check_text(const check_run *run, unsigned row, unsigned column);

/* Adds the error of a quantity in a row, in the quantity's unit; the sign does not
 * matter. */
void check_add(check_run *run, unsigned quantity, unsigned row, double error);

/* Prints "file:line: ..." for a row and returns EXIT_INPUT. */
int check_refuse(const check_run *run, unsigned row, const char *format, ...)
    LOG_PRINTF(3, 4);

/* The same for the i-th parameter line of a kind. */
int check_refuse_line(const check_run *run, unsigned note, unsigned i, const char *format,
                      ...) LOG_PRINTF(4, 5);

/* Shows the progress on a terminal; for models that take seconds. */
void check_progress(const check_run *run, unsigned row);

/* -- ranges shared by several tables ------------------------------------------------- */

/* Tables hold doubles: a value of 1 may appear as 1.0000000000000002. */
#define CHECK_ONE     (1 + 1e-9)
#define CHECK_UNIT(n) { .name = n, .low = -CHECK_ONE, .high = CHECK_ONE }
#define CHECK_ANY(n)  { .name = n, .low = -1e9, .high = 1e9 }

/* Time, s, up to four months.  At the end a double still has the fastest wave's omega t to
 * 5e-7 rad. */
#define CHECK_TIME(n) { .name = n, .high = 1e7 }

/* Depth, m: from the least positive 16.16 to the deepest floor of a scene. */
#define CHECK_DEPTH(n) { .name = n, .low = 1 / 65536.0, .high = 8000 }

/* k, omega, speeds and Ks of waves with the lengths of a tp_wave, 0.25..2000 m, over the
 * depths above: from k = 2 pi / 2000 to k = 1284 over the least depth, 1305 by Fenton's
 * formula. */
#define CHECK_WAVES(n) { .name = n, .low = 0.003, .high = 1310 }

/* -- conversions from doubles to the core's formats and back ------------------------- */

#define CHECK_PI 3.14159265358979323846

tp_fx   check_fx(double x);                 /* rounds to nearest */
tp_q30  check_q30(double x);
tp_turn check_turn(double radians);         /* any number of turns */

double check_metres(tp_fx x);               /* from any 16.16, not only m */
double check_radians(tp_turn angle);        /* -pi..pi */
double check_wrapped(double radians);       /* reduced to -pi..pi */
double check_angle(tp_dir3 got, const double want[3]);  /* angle between both, degrees */
double check_percent(double got, double want);  /* excess of got over want, % */

/* -- rounding of table values to 16.16 ----------------------------------------------- */

#define CHECK_HALF (1 / 131072.0)           /* half of the last bit of 16.16 */

/* Rounding error of x in 16.16: absolute, and relative to x, 0 for x <= 0. */
double check_rounding(double x);
double check_share(double x);

/* Returns the part of an error beyond `lost` >= 0, the error explained by rounding. */
double check_excess(double error, double lost);
#endif
