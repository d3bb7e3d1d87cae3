/* SPDX-License-Identifier: MIT */
/* Runs jobs, several at a time.  Each job is a process group of its own: when the sweep is
 * interrupted, the job ends with all its children.  The output of a job becomes a file
 * after the job has succeeded.
 *
 * Signals that end a program are blocked while jobs run, and are handled one at a time.
 * After a signal the jobs are terminated and their unfinished files removed; the signal
 * then takes its usual effect.  A job that survives SIGTERM for PATIENCE_S seconds, or
 * until a second signal, is killed. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "app/files/timing.h"
#include "charts.h"
#include "charts_hold.h"

#define PATIENCE_S 3

typedef struct {
    chart_jobs *jobs;
    chart_hold  hold;
    progress    shown;
    const char *what;           /* noun for messages, as "jobs" */
} job_sweep;

/* -- signals ------------------------------------------------------------------------- */

/* Blocks the signals.  Ignored signals stay ignored.  SIGCHLD is blocked too: otherwise a
 * child that ends between waitpid and sigtimedwait would be missed. */
void charts_hold(chart_hold *h)
{
    static const int deadly[] = { SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGUSR1,
                                  SIGUSR2, SIGXCPU };
    struct sigaction now;
    sigemptyset(&h->held);
    sigaddset(&h->held, SIGCHLD);
    for (size_t i = 0; i < sizeof deadly / sizeof *deadly; i++)
        if (sigaction(deadly[i], NULL, &now) == 0 && now.sa_handler != SIG_IGN)
            sigaddset(&h->held, deadly[i]);
    sigprocmask(SIG_BLOCK, &h->held, &h->before);
}

void charts_release(const chart_hold *h)
{
    sigprocmask(SIG_SETMASK, &h->before, NULL);
}

/* -- one job ------------------------------------------------------------------------- */

static char *partial_rows_path(const chart_job *job)
{
    return job->rows ? path_join(".", job->rows, ".part") : NULL;
}

static const char *job_title(const chart_job *job)
{
    return job->title ? job->title : job->command;
}

/* Runs the job in the child process; never returns. */
static void become(const chart_job *job, const char *part, const chart_hold *hold)
{
    const int nothing = open("/dev/null", O_RDONLY), said = fileno(job->said);
    const int rows = part ? open(part, O_WRONLY | O_CREAT | O_TRUNC, 0666) : said;
    setpgid(0, 0);
    sigprocmask(SIG_UNBLOCK, &hold->held, NULL);
    if (nothing >= 0 && rows >= 0 && dup2(nothing, 0) == 0 && dup2(rows, 1) == 1
        && dup2(said, 2) == 2)
        execl("/bin/sh", "sh", "-c", job->command, (char *)NULL);
    dprintf(said, "%s: %s\n", part ? part : "/bin/sh", strerror(errno));
    _exit(127);
}

static bool begin_job(chart_job *job, const chart_hold *hold)
{
    char *part = partial_rows_path(job);
    job->said = tmpfile();
    job->pid = job->said && (part || !job->rows) ? fork() : -1;
    if (job->pid == 0)
        become(job, part, hold);
    if (job->pid > 0)
        setpgid(job->pid, job->pid);
    const int error = errno;
    free(part);
    if (job->pid > 0)
        return true;
    job->failed = true;
    log_line("tidepool charts: cannot start %s: %s", job_title(job), strerror(error));
    return false;
}

static void show_said(FILE *said)
{
    char line[512];
    rewind(said);
    while (fgets(line, sizeof line, said)) {
        line[strcspn(line, "\n")] = 0;
        log_line("    | %s", line);
    }
}

static void end_job(chart_job *job, int status, bool stopped)
{
    char *part = partial_rows_path(job);
    const bool well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    job->pid = 0;
    job->done = well && (!part || rename(part, job->rows) == 0);
    job->failed = !job->done;
    if (part && !job->done)
        unlink(part);
    if (job->failed && !stopped) {
        if (well)
            log_line("%s: %s", job->rows, strerror(errno));
        else
            log_line("tidepool charts: %s %d: %s", WIFSIGNALED(status) ? "signal" : "exit",
                WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status),
                job_title(job));
        show_said(job->said);
    }
    fclose(job->said);
    job->said = NULL;
    free(part);
}

/* -- all jobs ------------------------------------------------------------------------ */

static chart_job *next_job(const chart_jobs *jobs, bool timed)
{
    for (size_t i = 0; i < jobs->count; i++) {
        chart_job *job = &jobs->of[i];
        if (job->timed == timed && !job->done && !job->failed && !job->pid)
            return job;
    }
    return NULL;
}

static chart_job *find_job(const chart_jobs *jobs, pid_t pid)
{
    for (size_t i = 0; i < jobs->count; i++)
        if (jobs->of[i].pid == pid)
            return &jobs->of[i];
    return NULL;
}

static void kill_all(const chart_jobs *jobs, int number)
{
    for (size_t i = 0; i < jobs->count; i++)
        if (jobs->of[i].pid > 0)
            kill(-jobs->of[i].pid, number);
}

static uint32_t count_ended(const chart_jobs *jobs)
{
    uint32_t count = 0;
    for (size_t i = 0; i < jobs->count; i++)
        count += jobs->of[i].done || jobs->of[i].failed;
    return count;
}

/* Waits until a child ends.  Returns its process id; 0: no child is left. */
static pid_t wait_for_child(job_sweep *s, int *status)
{
    const struct timespec patience = { PATIENCE_S, 0 };
    for (;;) {
        const int stopped = s->jobs->stopped;
        const pid_t pid = waitpid(-1, status, WNOHANG);
        if (pid)
            return pid > 0 ? pid : 0;
        const int came = sigtimedwait(&s->hold.held, NULL, stopped ? &patience : NULL);
        if (came == SIGCHLD || (came < 0 && errno != EAGAIN))
            continue;
        kill_all(s->jobs, stopped ? SIGKILL : SIGTERM);
        s->jobs->stopped = stopped ? stopped : came;
    }
}

static void run_some(job_sweep *s, bool timed, unsigned most)
{
    chart_jobs *jobs = s->jobs;
    unsigned running = 0;
    for (;;) {
        chart_job *job;
        int status;
        while (!jobs->stopped && running < most && (job = next_job(jobs, timed)) != NULL)
            running += begin_job(job, &s->hold);
        if (!running)
            return;
        progress_jobs(&s->shown, count_ended(jobs), (uint32_t)jobs->count, s->what);
        const pid_t pid = wait_for_child(s, &status);
        if (!pid)
            return;
        job = find_job(jobs, pid);
        if (job) {
            if (jobs->stopped)
                kill(-pid, SIGKILL);    /* children of the job that still run */
            end_job(job, status, jobs->stopped);
            running--;
        }
    }
}

int chart_jobs_run(chart_jobs *jobs, unsigned most, const char *what)
{
    job_sweep s = { .jobs = jobs, .shown = progress_begin(), .what = what };
    size_t done = 0;
    charts_hold(&s.hold);
    run_some(&s, false, most);
    run_some(&s, true, 1);
    log_progress("");
    charts_release(&s.hold);
    for (size_t i = 0; i < jobs->count; i++)
        done += jobs->of[i].done;
    if (jobs->stopped)
        log_line("tidepool charts: stopped after %zu of %zu %s; --resume continues", done,
                 jobs->count, what);
    return done == jobs->count ? EXIT_DONE : EXIT_CHECK;
}

void chart_jobs_stop(const chart_jobs *jobs)
{
    if (jobs->stopped)
        raise(jobs->stopped);
}
