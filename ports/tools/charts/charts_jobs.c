/* SPDX-License-Identifier: MIT */
/* Makes the list of jobs of a sweep.  A command runs once, however many charts list the
 * command.  The name of the file with its rows follows from the command, so an interrupted
 * sweep can continue. */
#define _POSIX_C_SOURCE 200809L
#include <glob.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "charts.h"

/* The name is FNV-1a of 64 bits: among thousands of commands two names collide once in
 * 10^12 sweeps. */
static char *rows_name(const char *command)
{
    uint64_t hash = 0xcbf29ce484222325u;
    char name[32];
    for (const char *c = command; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 0x100000001b3u;
    snprintf(name, sizeof name, "%08x%08x", (unsigned)(hash >> 32),
             (unsigned)(hash & 0xffffffffu));
    return path_join(CHARTS_ROWS, name, ".rows");
}

bool chart_jobs_add(chart_jobs *jobs, char *command, char *rows)
{
    chart_job *more = command ? realloc(jobs->of, (jobs->count + 1) * sizeof *more) : NULL;
    if (more)
        jobs->of = more;
    if (more && command) {
        more[jobs->count++] = (chart_job){ .command = command, .rows = rows };
        return true;
    }
    free(command);
    free(rows);
    return false;
}

static chart_job *find_job(const chart_jobs *jobs, const char *command)
{
    for (size_t i = 0; i < jobs->count; i++)
        if (strcmp(jobs->of[i].command, command) == 0)
            return &jobs->of[i];
    return NULL;
}

/* Adds a command of a chart.  The list takes ownership of `command`. */
static bool add_command(chart_jobs *jobs, const charts *c, size_t chart_at, bool timed,
                        char *command)
{
    chart_job *job = command ? find_job(jobs, command) : NULL;
    if (job) {
        free(command);
    } else {
        if (!chart_jobs_add(jobs, command, command ? rows_name(command) : NULL))
            return false;
        job = &jobs->of[jobs->count - 1];
        job->timed = timed;
        job->mine = calloc(c->count, sizeof *job->mine);
    }
    if (!job->mine || !job->rows)
        return false;
    job->mine[chart_at] = true;
    return true;
}

/* Returns the command with every {scene} replaced. */
static char *expand(const char *command, const char *scene)
{
    static const char mark[] = "{scene}";
    size_t count = 0;
    for (const char *c = command; (c = strstr(c, mark)) != NULL; c += strlen(mark))
        count++;
    char *text = malloc(strlen(command) + count * strlen(scene) + 1), *to = text;
    while (text && *command) {
        const char *found = strstr(command, mark);
        const size_t bytes = found ? (size_t)(found - command) : strlen(command);
        memcpy(to, command, bytes);
        to += bytes;
        command += bytes;
        if (found) {
            memcpy(to, scene, strlen(scene));
            to += strlen(scene);
            command += strlen(mark);
        }
    }
    if (text)
        *to = 0;
    return text;
}

static bool add_kind(chart_jobs *jobs, const charts *c, size_t chart_at, int kind,
                     const string_list *scenes)
{
    const string_list *list = &c->of[chart_at].commands[kind];
    const bool timed = kind == CHART_TIME;
    for (size_t i = 0; i < list->count; i++) {
        const bool many = strstr(list->of[i], "{scene}") != NULL;
        for (size_t k = 0; k < (many ? scenes->count : 1); k++)
            if (!add_command(jobs, c, chart_at, timed,
                             expand(list->of[i], many ? scenes->of[k] : "")))
                return false;
    }
    return true;
}

int chart_jobs_make(chart_jobs *jobs, const charts *c, bool small)
{
    string_list scenes = { 0 };
    bool held = true;
    char *folder = path_of_scenes();
    if (folder)
        scenes.of = path_scene_names(folder, &scenes.count);
    free(folder);
    *jobs = (chart_jobs){ 0 };
    for (size_t i = 0; i < c->count; i++)
        for (int kind = 0; kind < CHART_KINDS && held; kind++)
            if (c->of[i].asked && (kind == CHART_JOB || !small))
                held = add_kind(jobs, c, i, kind, &scenes);
    string_list_free(&scenes);
    return held ? EXIT_DONE : log_fail_memory(jobs->count * sizeof *jobs->of);
}

void chart_jobs_free(chart_jobs *jobs)
{
    for (size_t i = 0; i < jobs->count; i++) {
        free(jobs->of[i].command);
        free(jobs->of[i].rows);
        free(jobs->of[i].mine);
    }
    free(jobs->of);
    *jobs = (chart_jobs){ 0 };
}

/* -- stored rows --------------------------------------------------------------------- */

static struct timespec later(struct timespec a, struct timespec b)
{
    const bool is_b = b.tv_sec != a.tv_sec ? b.tv_sec > a.tv_sec : b.tv_nsec > a.tv_nsec;
    return is_b ? b : a;
}

/* Returns the modification time of the newest measuring tool. */
static struct timespec tools_made(void)
{
    static const char *const patterns[] = {
        "build/host/tidepool", "build/host/*.so", "build/host/tests/charts/*",
        "build/charts*/*.elf", "tests/charts/*.sh",
    };
    struct timespec made = { 0 };
    for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++) {
        glob_t found;
        struct stat info;
        if (glob(patterns[i], 0, NULL, &found) != 0)
            continue;
        for (size_t k = 0; k < found.gl_pathc; k++)
            if (stat(found.gl_pathv[k], &info) == 0)
                made = later(made, info.st_mtim);
        globfree(&found);
    }
    return made;
}

void chart_jobs_keep(chart_jobs *jobs, bool resume)
{
    const struct timespec made = tools_made();
    size_t taken = 0, old = 0;
    for (size_t i = 0; i < jobs->count; i++) {
        struct stat info;
        if (stat(jobs->of[i].rows, &info) != 0)
            continue;
        const struct timespec newest = later(info.st_mtim, made);
        jobs->of[i].done = resume && newest.tv_sec == info.st_mtim.tv_sec
                         && newest.tv_nsec == info.st_mtim.tv_nsec;
        taken += jobs->of[i].done;
        old += resume && !jobs->of[i].done;
        if (!jobs->of[i].done)
            unlink(jobs->of[i].rows);
    }
    if (resume)
        log_line("tidepool charts: %zu of %zu jobs are done", taken, jobs->count);
    if (old)
        log_line("tidepool charts: %zu jobs of older tools run again", old);
}
