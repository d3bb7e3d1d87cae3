/* SPDX-License-Identifier: MIT */
/* tidepool charts: a sweep of jobs makes tables, pictures and a page.  Jobs are
 * independent: the same list runs on one machine or on many.  Their output, merged in any
 * order, gives the same bytes. */
#define _POSIX_C_SOURCE 200809L
#include "charts.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "app/cli/args.h"
#include "app/cli/command_help.h"
#include "app/cli/commands.h"
#include "app/files/log.h"
#include "app/files/path.h"

/* -- requirements -------------------------------------------------------------------- */

static int check_place(const options *o)
{
    if (o->from || access(CHARTS_FOLDER "/style.gp", R_OK) == 0)
        return EXIT_DONE;
    return log_fail(EXIT_INPUT, "tidepool charts: " CHARTS_FOLDER " not found: run it in"
                                " the project's folder");
}

static int build_tools(const options *o)
{
    char make[128];
    snprintf(make, sizeof make, "env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS make -s -j%u"
             " --no-print-directory charts-tools >&2", (unsigned)o->jobs);
    if (!o->from && system(make))
        return log_fail(EXIT_INPUT, "tidepool charts: its measuring tools cannot be built");
    return EXIT_DONE;
}

/* Makes a folder and its parents, and checks that files can be written there. */
static int make_folder(const char *dir)
{
    char *path = path_copy(dir, strlen(dir));
    if (!path)
        return log_fail_memory(strlen(dir));
    for (char *c = path + 1; *c; c++)
        if (*c == '/') {
            *c = 0;
            mkdir(path, 0777);
            *c = '/';
        }
    const bool made = mkdir(path, 0777) == 0 || errno == EEXIST;
    char *inside = path_join(dir, ".", "");
    const bool fits = made && inside && access(inside, W_OK) == 0;
    const int error = errno;
    free(inside);
    free(path);
    return fits ? EXIT_DONE : log_fail(EXIT_INPUT, "%s: %s", dir, strerror(error));
}

/* -- a sweep ------------------------------------------------------------------------- */

static int list_jobs(const charts *c, const options *o)
{
    chart_jobs jobs;
    const int code = chart_jobs_make(&jobs, c, o->small);
    for (size_t i = 0; i < jobs.count && !code; i++)
        puts(jobs.of[i].command);
    chart_jobs_free(&jobs);
    return code;
}

/* Marks the charts of a failed job: they are not written. */
static void spoil(charts *c, const chart_job *job)
{
    for (size_t i = 0; i < c->count; i++)
        c->of[i].failed |= job->mine[i];
}

static int read_job(chart_cells *all, charts *c, const chart_job *job)
{
    int code = EXIT_DONE;
    FILE *file = job->done ? fopen(job->rows, "r") : NULL;
    if (job->done && !file)
        code = log_fail(EXIT_INPUT, "%s: %s", job->rows, strerror(errno));
    const size_t before = all->count;
    if (file)
        code = cells_read(all, c, file, job->command, job->mine, job->timed);
    if (file && !code && all->count == before)
        code = log_fail(EXIT_INPUT, "%s: no rows", job->command);
    if (file)
        fclose(file);
    if (code || !job->done)
        spoil(c, job);
    return code;
}

/* Runs all jobs and reads their rows.  After a failure the other jobs still run; the exit
 * code is the first failure's. */
static int run_jobs(chart_cells *all, charts *c, chart_jobs *jobs, const options *o)
{
    chart_jobs_keep(jobs, o->resume);
    int code = chart_jobs_run(jobs, o->jobs, "jobs");
    chart_jobs_stop(jobs);
    for (size_t i = 0; i < jobs->count; i++) {
        const int bad = read_job(all, c, &jobs->of[i]);
        code = code ? code : bad;
    }
    return code;
}

static int collect(chart_cells *all, const charts *c, const options *o)
{
    int code = EXIT_DONE;
    for (uint32_t i = 0; i + 1 < o->n_names && !code; i++) {
        const bool is_stdin = strcmp(o->names[i], "-") == 0;
        const char *name = is_stdin ? "standard input" : o->names[i];
        FILE *file = is_stdin ? stdin : fopen(name, "r");
        if (!file)
            return log_fail(EXIT_INPUT, "%s: %s", name, strerror(errno));
        code = cells_read(all, c, file, name, NULL, false);
        if (!is_stdin)
            fclose(file);
    }
    return code;
}

static int write_charts(const charts *c, const chart_cells *all, const options *o,
                        bool *written)
{
    const char *dir = o->names[o->n_names - 1];
    int code = EXIT_DONE;
    for (size_t i = 0; i < c->count && !code; i++) {
        const chart *of = &c->of[i];
        if (!of->asked || of->failed)
            continue;
        code = chart_write(of, all, dir, !o->small, &written[i]);
        if (!code && !written[i] && !o->small)
            log_line("chart %s: no rows, no table", of->name);
    }
    if (!code && !o->small)
        code = charts_draw(c, written, dir, o->jobs);
    const int page = charts_page(c, dir);
    return code ? code : page;
}

static int prepare(const charts *c, chart_jobs *jobs, const options *o)
{
    int code = make_folder(o->names[o->n_names - 1]);
    if (code || o->collect)
        return code;
    code = build_tools(o);
    if (!code)
        code = make_folder(CHARTS_ROWS);
    return code ? code : chart_jobs_make(jobs, c, o->small);
}

static int sweep(charts *c, const options *o)
{
    chart_cells all = { 0 };
    chart_jobs jobs = { 0 };
    bool *written = calloc(c->count, sizeof *written);
    int code = written ? prepare(c, &jobs, o) : log_fail_memory(c->count);
    if (!code) {
        code = o->collect ? collect(&all, c, o) : run_jobs(&all, c, &jobs, o);
        int end = code && o->collect ? code : cells_sort(&all);
        if (!end)
            end = write_charts(c, &all, o, written);
        code = code ? code : end;
    }
    cells_free(&all);
    chart_jobs_free(&jobs);
    free(written);
    return code;
}

static int run(options *o)
{
    charts c;
    int code = check_place(o);
    if (code)
        return code;
    if (!o->jobs) {
        const long here = sysconf(_SC_NPROCESSORS_ONLN);
        o->jobs = here > 0 ? (uint32_t)here : 1;
    }
    code = charts_read(&c, o->from ? o->from : CHARTS_FOLDER, o->only);
    if (!code)
        code = o->list ? list_jobs(&c, o) : sweep(&c, o);
    charts_free(&c);
    return code;
}

int charts_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_CHARTS, argc, argv);
    if (!code && o.help)
        command_help_print(FOR_CHARTS);
    else if (!code)
        code = run(&o);
    const int end = streams_finish();
    free(o.settings);
    return code ? code : end;
}
