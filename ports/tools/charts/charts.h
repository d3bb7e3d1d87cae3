/* SPDX-License-Identifier: MIT */
/* Charts: tables filled by jobs, one row per cell, and pictures of the tables. */
#ifndef TP_TOOLS_CHARTS_CHARTS_H
#define TP_TOOLS_CHARTS_CHARTS_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/types.h>
#include "app/files/string_list.h"

#define CHARTS_FOLDER "tests/charts"
#define CHARTS_ROWS   "build/charts/rows"       /* folder of finished jobs, one file each */

enum { CHART_JOB, CHART_LARGE, CHART_TIME, CHART_KINDS };

/* The contents of NAME.ini, explained in charts_ini.c. */
typedef struct {
    char *name, *path, *title;
    string_list keys, values, times, units, pareto, group, sparse;
    string_list commands[CHART_KINDS];
    bool  asked;                /* selected by --only, or --only is absent */
    bool  failed;               /* a job of the chart failed: nothing is written */
} chart;

typedef struct {
    const char *folder;         /* folder of the INI files; owned by the caller */
    chart      *of;             /* charts in order of name */
    size_t      count;
} charts;

/* Reads all charts of a folder.  only: comma-separated names of charts, or NULL = all. */
int    charts_read(charts *c, const char *folder, const char *only);
void   charts_free(charts *c);
chart *charts_find(const charts *c, const char *name);

/* Returns "folder/NAME.suffix", which the caller frees; NULL: no memory. */
char *chart_path(const char *folder, const chart *of, const char *suffix);

/* -- cells: charts_rows.c, charts_table.c -------------------------------------------- */

typedef struct {
    const chart *chart;
    char        *keys, *value;  /* keys as in the row, separated by ';' */
    unsigned     column;        /* index of the column: values, then times */
    const char  *from;          /* name of the source of the row; owned by the caller */
    unsigned     line;
} chart_cell;

typedef struct {
    chart_cell  *of;
    size_t count, room;
} chart_cells;

/* Reads rows CHART,KEYS,COLUMN,VALUE.  mine, if not NULL: true for each chart that may have
 * rows here.  timed, used with `mine`: true = rows of times, false = rows of values. */
int  cells_read(chart_cells *all, const charts *c, FILE *file, const char *name,
                const bool *mine, bool timed);
int  cells_sort(chart_cells *all);        /* EXIT_INPUT: a cell has two values */
void cells_free(chart_cells *all);

/* Writes sorted cells to DIR/NAME.csv, and to DIR/NAME.time.csv if there are times.
 * *written: true if there was a row.  whole: prints a message about missing cells. */
int  chart_write(const chart *of, const chart_cells *all, const char *dir, bool whole,
                 bool *written);

/* Compares; returns -1, 0 or 1.  Numbers sort by value, and before words.  Numbers inside
 * of words also sort by value. */
int  charts_natural_order(const char *a, const char *b, const char *separators);

/* -- jobs: charts_jobs.c, charts_run.c ----------------------------------------------- */

typedef struct {
    char *command;              /* command line of a shell */
    const char *title;          /* name in messages; NULL: the command */
    char *rows;                 /* file of the job's standard output, or NULL */
    bool *mine;                 /* for each chart: true if the chart lists the job */
    bool  timed;                /* the job runs alone */
    bool  done, failed;
    FILE *said;                 /* the job's stderr, while the job runs */
    pid_t pid;
} chart_job;

typedef struct {
    chart_job *of;
    size_t     count;
    int        stopped;         /* signal that stopped the run; 0: none */
} chart_jobs;

/* Makes the jobs of the selected charts.  small: without large jobs and times. */
int  chart_jobs_make(chart_jobs *jobs, const charts *c, bool small);
void chart_jobs_free(chart_jobs *jobs);

/* resume: keeps the stored rows that are newer than the tools that made them, and deletes
 * the others.  Otherwise deletes all stored rows. */
void chart_jobs_keep(chart_jobs *jobs, bool resume);

/* Adds a job; false: no memory. */
bool chart_jobs_add(chart_jobs *jobs, char *command, char *rows);

/* Runs all unfinished jobs, at most `most` at a time.  Returns EXIT_CHECK after messages if
 * some failed.  After a signal the caller cleans up and calls chart_jobs_stop, which then
 * does not return. */
int  chart_jobs_run(chart_jobs *jobs, unsigned most, const char *what);
void chart_jobs_stop(const chart_jobs *jobs);

/* -- pictures and the page: charts_draw.c, charts_page.c ----------------------------- */

int charts_draw(const charts *c, const bool *written, const char *dir, unsigned most);
int charts_page(const charts *c, const char *dir);
#endif
