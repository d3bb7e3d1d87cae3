/* SPDX-License-Identifier: MIT */
/* Charts: tables that jobs fill, a row a cell, and pictures of them. */
#ifndef HOST_CHARTS_H
#define HOST_CHARTS_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/types.h>
#include "words.h"

#define CHARTS_FOLDER "tests/charts"
#define CHARTS_ROWS   "build/charts/rows"       /* of jobs that are done, a file each */

enum { CHART_JOB, CHART_LARGE, CHART_TIME, CHART_KINDS };

/* What NAME.ini says; see charts_ini.c. */
typedef struct {
    char *name, *path, *title;
    words keys, values, times, units, pareto, group, sparse;
    words commands[CHART_KINDS];
    bool  asked;                /* for by --only, or by nothing */
    bool  failed;               /* a job of it, and nothing is written */
} chart;

typedef struct {
    const char *folder;         /* of the INIs; the caller's */
    chart      *of;             /* by name */
    size_t      count;
} charts;

/* All that the folder describes; `only`: names parted by commas, or NULL. */
int    charts_read(charts *c, const char *folder, const char *only);
void   charts_free(charts *c);
chart *charts_find(const charts *c, const char *name);

/* "folder/NAME.suffix", to free; NULL: no memory. */
char *chart_path(const char *folder, const chart *of, const char *suffix);

/* -- cells: charts_rows.c, charts_table.c ------------------------------------------ */

typedef struct {
    const chart *chart;
    char        *keys, *value;  /* keys as in the row, parted by ';' */
    unsigned     column;        /* of values, then of times */
    const char  *from;          /* where the row was read; the caller's */
    unsigned     line;
} cell;

typedef struct {
    cell  *of;
    size_t count, room;
} cells;

/* Reads rows CHART,KEYS,COLUMN,VALUE; `mine`, if not NULL, says for each chart whether it
 * may have rows here, and `timed` then which columns. */
int  cells_read(cells *all, const charts *c, FILE *file, const char *name,
                const bool *mine, bool timed);
int  cells_sort(cells *all);        /* EXIT_INPUT: two values for one cell */
void cells_free(cells *all);

/* Writes DIR/NAME.csv, and DIR/NAME.time.csv if there are times, of sorted cells.
 * *written: whether there was a row.  `whole`: cells that are missing are told of. */
int  chart_write(const chart *of, const cells *all, const char *dir, bool whole,
                 bool *written);

/* -1, 0 or 1: numbers by size, before words, in which numbers count by size too. */
int  natural_order(const char *a, const char *b, const char *separators);

/* -- jobs: charts_jobs.c, charts_run.c ---------------------------------------------- */

typedef struct {
    char *command;              /* for a shell */
    const char *title;          /* what people are told of; NULL: the command */
    char *rows;                 /* its standard output's file in the end, or NULL */
    bool *mine;                 /* of each chart: whether it lists this job */
    bool  timed;                /* runs alone */
    bool  done, failed;
    FILE *said;                 /* its stderr, while it runs */
    pid_t pid;
} chart_job;

typedef struct {
    chart_job *of;
    size_t     count;
    int        stopped;         /* by which signal; 0: by none */
} chart_jobs;

/* Of the charts asked for: all, or without large ones and times. */
int  chart_jobs_make(chart_jobs *jobs, const charts *c, bool small);
void chart_jobs_free(chart_jobs *jobs);

/* Throws rows away that were kept, or takes those that are no older than what made
 * them, by `resume`. */
void chart_jobs_keep(chart_jobs *jobs, bool resume);

/* Adds one; false: no memory. */
bool chart_jobs_add(chart_jobs *jobs, char *command, char *rows);

/* Runs what is not done, `most` at a time.  EXIT_CHECK: some failed, and said so.  After
 * a signal that stopped it the caller tidies up and calls stop, which does not return
 * then. */
int  chart_jobs_run(chart_jobs *jobs, unsigned most, const char *what);
void chart_jobs_stop(const chart_jobs *jobs);

/* -- pictures and the page: charts_draw.c, charts_page.c ---------------------------- */

int charts_draw(const charts *c, const bool *written, const char *dir, unsigned most);
int charts_page(const charts *c, const char *dir);
#endif
