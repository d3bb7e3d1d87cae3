/* SPDX-License-Identifier: MIT */
/* tidepool check: tables of known values against the fixed-point models.
 *
 * A model describes one file: its columns, its parameter lines, the quantities that are
 * compared with their budgets, and a function that works through the rows.  A new file is
 * a description in one of the check_*.c and a line of the list below. */
#ifndef HOST_CHECK_H
#define HOST_CHECK_H
#include <stdbool.h>
#include <stddef.h>
#include "csv.h"
#include "say.h"
#include "tidepool/fixed.h"

#define CHECK_MODELS(X) \
    X(automaton_int) X(automaton_mode) X(automaton_settle_table) X(breaking) \
    X(breaking_criteria) X(buoyancy) X(dispersion) X(drop_bounce) X(droplet_waves) \
    X(exposure) X(fr_orbit) X(fresnel) X(gerstner_single) X(gerstner_sum) \
    X(reflect_refract) X(sharp_sine) X(shoaling_phase) X(sine) X(sum_of_sines) \
    X(time_scale) X(wind_phase)

enum { CHECK_QUANTITIES = 9, CHECK_NOTES = 3, CHECK_LINES = 16 };

typedef enum {
    CHECK_NUMBER,
    CHECK_WHOLE,                /* a number without fraction */
    CHECK_WORD,                 /* one of `words`, "a|b|c"; its value: which, from 0 */
    CHECK_TEXT                  /* read by check_text */
} check_kind;

/* A column, or a number of a parameter line; numbers outside low..high are refused. */
typedef struct {
    const char *name;
    double      low, high;
    check_kind  kind;
    const char *words;
} check_field;

/* A parameter line: each '%' of `text` stands for a number. */
typedef struct {
    const char        *text;
    const check_field *numbers;
    unsigned           count;       /* of them */
    bool               list;        /* up to CHECK_LINES such lines, not one: their first
                                     * number counts them from 0 */
} check_note;

typedef struct {
    const char *name, *unit;
    double      budget;         /* the largest error allowed, in `unit` */
} check_quantity;

typedef struct check_run check_run;

typedef struct {
    const check_field *columns;
    unsigned           n_columns;
    check_note         notes[CHECK_NOTES];
    check_quantity     quantities[CHECK_QUANTITIES];
    /* One of both: for every row by itself, `v` its values in the model's order; or for
     * all rows (EXIT_INPUT: said why). */
    void             (*each)(check_run *run, unsigned row, const double *v);
    int              (*run)(check_run *run);
} check_model;

/* The array and its length. */
#define CHECK_ALL(array) (array), sizeof (array) / sizeof *(array)

typedef struct {
    unsigned rows, worst_row;
    double   worst, squares;
} check_tally;

struct check_run {
    const check_model *model;
    csv          table;
    const char  *label;                     /* the file's name without folder */
    unsigned     place[32];                 /* of the model's columns in the file */
    double      *rows;                      /* their values, in the model's order */
    unsigned     n_lines[CHECK_NOTES];      /* parameter lines found, and where */
    unsigned     line_at[CHECK_NOTES][CHECK_LINES];
    double       lines[CHECK_NOTES][CHECK_LINES][12];
    check_tally  tally[CHECK_QUANTITIES];
};

#define X(name) extern const check_model check_##name;
CHECK_MODELS(X)
#undef X

/* The values of a row, in the model's order. */
const double *check_row(const check_run *run, unsigned row);
const char   *check_text(const check_run *run, unsigned row, unsigned column);

/* The error of a quantity in a row, in the quantity's unit; either sign. */
void check_add(check_run *run, unsigned quantity, unsigned row, double error);

/* "file:line: ..." of a row; EXIT_INPUT. */
int check_refuse(const check_run *run, unsigned row, const char *format, ...)
    HOST_PRINTF(3, 4);

/* The same of the i-th parameter line of a kind. */
int check_refuse_line(const check_run *run, unsigned note, unsigned i, const char *format,
                      ...) HOST_PRINTF(4, 5);

/* For models that take seconds: how far it is, on a terminal. */
void check_progress(const check_run *run, unsigned row);

/* -- ranges that several tables share ---------------------------------------------- */

/* Tables hold doubles, so what is 1 may stand there as 1.0000000000000002. */
#define CHECK_ONE     (1 + 1e-9)
#define CHECK_UNIT(n) { .name = n, .low = -CHECK_ONE, .high = CHECK_ONE }
#define CHECK_ANY(n)  { .name = n, .low = -1e9, .high = 1e9 }

/* s, four months: a double has the fastest wave's omega t there to 5e-7 rad. */
#define CHECK_TIME(n) { .name = n, .high = 1e7 }

/* m: from the least depth that 16.16 names to the deepest floor of a scene. */
#define CHECK_DEPTH(n) { .name = n, .low = 1 / 65536.0, .high = 8000 }

/* k, omega, speeds and Ks of a tp_wave's lengths, 0.25..2000 m, over these depths: from
 * k = 2 pi / 2000 to 1284 over the least depth, 1305 by Fenton's formula. */
#define CHECK_WAVES(n) { .name = n, .low = 0.003, .high = 1310 }

/* -- from doubles to the core's numbers and back ----------------------------------- */

#define CHECK_PI 3.14159265358979323846

tp_fx   check_fx(double x);                 /* nearest */
tp_q30  check_q30(double x);
tp_turn check_turn(double radians);         /* any size */

double check_metres(tp_fx x);               /* of any 16.16 */
double check_radians(tp_turn angle);        /* -pi..pi */
double check_wrapped(double radians);       /* -pi..pi */
double check_angle(tp_dir3 got, const double want[3]);  /* between both, degrees */
double check_percent(double got, double want);  /* of want, that got is more */

/* -- tables' numbers that 16.16 does not hold --------------------------------------- */

#define CHECK_HALF (1 / 131072.0)           /* half of the last bit */

/* How far x moves when it is rounded; as a share of x, 0 where x <= 0. */
double check_rounding(double x);
double check_share(double x);

/* The part of an error beyond what such roundings explain, `lost` >= 0. */
double check_beyond(double error, double lost);
#endif
