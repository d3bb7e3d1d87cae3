/* SPDX-License-Identifier: MIT */
/* Running jobs, several at a time.  Each is a group of processes of its own, so that it
 * ends with all its children when the sweep is interrupted.  What it prints becomes a
 * file when it has ended well. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "charts.h"
#include "path.h"
#include "say.h"
#include "timing.h"

static const int deadly[] = { SIGINT, SIGTERM, SIGHUP };
#define DEADLY (sizeof deadly / sizeof *deadly)

static volatile sig_atomic_t stopped;   /* by which signal; the handler has to find it */

static void stop(int signal_number)
{
    stopped = signal_number;
}

/* Signals that are ignored stay so.  Without SA_RESTART: a wait ends when one comes. */
static void watch(struct sigaction before[DEADLY])
{
    struct sigaction ours = { .sa_handler = stop };
    sigemptyset(&ours.sa_mask);
    stopped = 0;
    for (size_t i = 0; i < DEADLY; i++)
        if (sigaction(deadly[i], NULL, &before[i]) == 0
            && before[i].sa_handler == SIG_DFL)
            sigaction(deadly[i], &ours, NULL);
}

static void unwatch(const struct sigaction before[DEADLY])
{
    for (size_t i = 0; i < DEADLY; i++)
        sigaction(deadly[i], &before[i], NULL);
}

/* -- one job ------------------------------------------------------------------------ */

static char *part_of(const chart_job *job)
{
    return job->rows ? path_join(".", job->rows, ".part") : NULL;
}

static const char *title_of(const chart_job *job)
{
    return job->title ? job->title : job->command;
}

/* In the child: never returns. */
static void become(const chart_job *job, const char *part)
{
    const int nothing = open("/dev/null", O_RDONLY), said = fileno(job->said);
    const int rows = part ? open(part, O_WRONLY | O_CREAT | O_TRUNC, 0666) : said;
    setpgid(0, 0);
    if (nothing >= 0 && rows >= 0 && dup2(nothing, 0) == 0 && dup2(rows, 1) == 1
        && dup2(said, 2) == 2)
        execl("/bin/sh", "sh", "-c", job->command, (char *)NULL);
    dprintf(said, "%s: %s\n", part ? part : "/bin/sh", strerror(errno));
    _exit(127);
}

static bool begin_job(chart_job *job)
{
    char *part = part_of(job);
    job->said = tmpfile();
    job->pid = job->said && (part || !job->rows) ? fork() : -1;
    if (job->pid == 0)
        become(job, part);
    if (job->pid > 0)
        setpgid(job->pid, job->pid);
    const int error = errno;
    free(part);
    if (job->pid > 0)
        return true;
    job->failed = true;
    say("tidepool charts: cannot start %s: %s", title_of(job), strerror(error));
    return false;
}

static void show_said(FILE *said)
{
    char line[512];
    rewind(said);
    while (fgets(line, sizeof line, said)) {
        line[strcspn(line, "\n")] = 0;
        say("    | %s", line);
    }
}

static void end_job(chart_job *job, int status)
{
    char *part = part_of(job);
    const bool well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    job->pid = 0;
    job->done = well && (!part || rename(part, job->rows) == 0);
    job->failed = !job->done;
    if (part && !job->done)
        unlink(part);
    if (job->failed && !stopped) {
        if (well)
            say("%s: %s", job->rows, strerror(errno));
        else
            say("tidepool charts: %s %d: %s", WIFSIGNALED(status) ? "signal" : "exit",
                WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status),
                title_of(job));
        show_said(job->said);
    }
    fclose(job->said);
    job->said = NULL;
    free(part);
}

/* -- all of them -------------------------------------------------------------------- */

static chart_job *next_job(const chart_jobs *jobs, bool timed)
{
    for (size_t i = 0; i < jobs->count; i++) {
        chart_job *job = &jobs->of[i];
        if (job->timed == timed && !job->done && !job->failed && !job->pid)
            return job;
    }
    return NULL;
}

static chart_job *job_of(const chart_jobs *jobs, pid_t pid)
{
    for (size_t i = 0; i < jobs->count; i++)
        if (jobs->of[i].pid == pid)
            return &jobs->of[i];
    return NULL;
}

static void kill_all(const chart_jobs *jobs)
{
    for (size_t i = 0; i < jobs->count; i++)
        if (jobs->of[i].pid > 0)
            kill(-jobs->of[i].pid, SIGTERM);
}

static uint32_t count_ended(const chart_jobs *jobs)
{
    uint32_t count = 0;
    for (size_t i = 0; i < jobs->count; i++)
        count += jobs->of[i].done || jobs->of[i].failed;
    return count;
}

static void run_some(const chart_jobs *jobs, bool timed, unsigned most, const char *what,
                     progress *p)
{
    unsigned running = 0;
    for (;;) {
        chart_job *job;
        int status;
        while (!stopped && running < most && (job = next_job(jobs, timed)) != NULL)
            running += begin_job(job);
        if (!running)
            return;
        progress_jobs(p, count_ended(jobs), (uint32_t)jobs->count, what);
        if (stopped)
            kill_all(jobs);
        const pid_t pid = waitpid(-1, &status, 0);
        job = pid > 0 ? job_of(jobs, pid) : NULL;
        if (job) {
            end_job(job, status);
            running--;
        } else if (pid < 0 && errno == ECHILD) {
            return;
        }
    }
}

int chart_jobs_run(chart_jobs *jobs, unsigned most, const char *what)
{
    struct sigaction before[DEADLY];
    progress p = progress_begin();
    size_t done = 0;
    watch(before);
    run_some(jobs, false, most, what, &p);
    run_some(jobs, true, 1, what, &p);
    say_progress("");
    unwatch(before);
    for (size_t i = 0; i < jobs->count; i++)
        done += jobs->of[i].done;
    if (stopped) {
        say("tidepool charts: stopped after %zu of %zu %s; --resume goes on", done,
            jobs->count, what);
        raise(stopped);
    }
    return done == jobs->count ? EXIT_DONE : EXIT_CHECK;
}
