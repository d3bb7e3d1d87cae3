/* SPDX-License-Identifier: MIT */
/* Two processes: the parent opens the screen and waits, the child draws.  Whatever ends
 * the child, even SIGKILL, the parent restores screen and console and ends in the same
 * way.  If the parent is killed, the kernel signals the child (PR_SET_PDEATHSIG), and
 * the child restores instead.
 *
 * The parent passes its signals on.  A child still running some seconds after a signal,
 * because the device blocks it, is killed. */
#define _GNU_SOURCE             /* for sigtimedwait */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include "app/files/log.h"
#include "fullscreen.h"

#define PATIENCE_S 3            /* s to wait for a signalled child */
#define WRITING_S  10           /* s if the child may be writing to disk */
#define SIDE_LOW   16u          /* least side of a picture in the core, px */

static const screen_port *const ports[] = {
    &screen_fb,
#ifdef TP_HAVE_KMS
    &screen_kms,
#endif
};

const screen_port *show_port(const char *name)
{
    for (size_t i = 0; i < sizeof ports / sizeof *ports; i++)
        if (strcmp(ports[i]->name, name) == 0)
            return ports[i];
    return NULL;
}

/* -- the child ----------------------------------------------------------------------- */

typedef struct {
    const show *what;
    screen     *on;
    console     tty;
    pid_t       parent, child;
    snapshot_store kept;
    uint32_t    frame;              /* first frame */
} watch;

/* Restores screen and console.  If another terminal is active, its screen is left
 * unchanged. */
static void give_back(watch *w)
{
    const screen_port *port = w->what->port;
    if (port->away && !console_front(&w->tty))
        (void)port->away(w->on);
    port->close(w->on);
    console_restore(&w->tty);
    console_close(&w->tty);
}

/* Ends by the signal with the default action.  No core dump: the parent's would tell
 * nothing. */
static void die_by_signal(int signal)
{
    sigset_t set;
    struct sigaction plain = { .sa_handler = SIG_DFL };
    const struct rlimit none = { 0, 0 };
    setrlimit(RLIMIT_CORE, &none);
    sigaction(signal, &plain, NULL);
    sigemptyset(&set);
    sigaddset(&set, signal);
    raise(signal);
    sigprocmask(SIG_UNBLOCK, &set, NULL);
}

static void child_run(watch *w, const sigset_t *before)
{
    const watch found = *w;
    sigset_t own;
    int signal = 0;
    sigprocmask(SIG_SETMASK, before, NULL);
    loop_signals(&own);
    sigprocmask(SIG_BLOCK, &own, NULL);
    prctl(PR_SET_PDEATHSIG, SIGHUP);
    int code = getppid() == w->parent ? EXIT_DONE : EXIT_INPUT;
    if (!code)
        code = loop_run(w->what, w->on, &w->tty, &w->kept, w->frame, &signal);
    if (fflush(stdout) && !code)
        code = log_fail(EXIT_INPUT, "standard output: %s", strerror(errno));
    if (getppid() != w->parent) {
        *w = found;
        give_back(w);
    }
    if (signal)
        die_by_signal(signal);
    _exit(code);
}

/* -- the parent ---------------------------------------------------------------------- */

/* Signals passed on to the child: requests to end, and faults sent from outside.  A
 * fault of the parent itself kills the parent, and the child then restores the screen. */
static const int handed_on[] = { SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGSEGV, SIGABRT, SIGBUS,
                                 SIGFPE, SIGILL };

static void watched_signals(sigset_t *set)
{
    sigemptyset(set);
    for (size_t i = 0; i < sizeof handed_on / sizeof *handed_on; i++)
        sigaddset(set, handed_on[i]);
    sigaddset(set, SIGCHLD);
}

/* Waits for the child's end.  Returns its exit code; *by: the signal that ended it, or,
 * if it had to be killed, the signal it was sent before; 0 if none. */
static int wait_child(const watch *w, const sigset_t *set, int *by)
{
    const struct timespec patience = { w->what->keep ? WRITING_S : PATIENCE_S, 0 };
    int status, asked = 0;
    bool killed = false;
    while (waitpid(w->child, &status, WNOHANG) == 0) {
        const int signal = sigtimedwait(set, NULL, asked ? &patience : NULL);
        killed = killed || (signal < 0 && errno == EAGAIN);
        if (killed)
            kill(w->child, SIGKILL);
        if (signal <= 0 || signal == SIGCHLD)
            continue;
        kill(w->child, signal);
        kill(w->child, SIGCONT);
        asked = signal;
    }
    *by = killed ? asked : WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : EXIT_INPUT;
}

static int watch_run(watch *w)
{
    sigset_t set, before;
    fflush(stdout);
    watched_signals(&set);
    sigprocmask(SIG_BLOCK, &set, &before);
    signal(SIGTSTP, SIG_IGN);           /* stopped, it would block the console */
    signal(SIGTTIN, SIG_IGN);
    signal(SIGTTOU, SIG_IGN);
    w->parent = getpid();
    w->child = fork();
    if (w->child == 0)
        child_run(w, &before);
    const int error = errno;
    int by = 0;
    const int code = w->child < 0 ? EXIT_INPUT : wait_child(w, &set, &by);
    give_back(w);
    if (w->child < 0)
        return log_fail(EXIT_INPUT, "tidepool: cannot start a process: %s",
                        strerror(error));
    if (by)
        die_by_signal(by);
    sigprocmask(SIG_SETMASK, &before, NULL);
    return code;
}

/* -- start --------------------------------------------------------------------------- */

static int check_size(const show *what, const screen *on, const char *device)
{
    uint32_t width, height;
    what->port->size(on, &width, &height);
    if (width >= SIDE_LOW && height >= SIDE_LOW)
        return EXIT_DONE;
    return log_fail(EXIT_DISPLAY, "%s: %ux%u pixels; a scene needs at least %ux%u", device,
                width, height, SIDE_LOW, SIDE_LOW);
}

static int take_kept(watch *w)
{
    const show *what = w->what;
    snapshot_progress at;
    w->kept = snapshot_begin(what->keep, what->scene, what->assets);
    w->kept.remake = what->remake;
    w->kept.user = what->user;
    if (!snapshot_read(&w->kept, what->world, what->world_bytes, &at))
        return EXIT_DONE;
    w->frame = at.frame;
    if (what->counted && w->frame > what->last)
        return log_fail(EXIT_INPUT, "%s: already at frame %u, past %u", what->keep,
                        w->frame, what->last);
    log_line("%s: continues at frame %u", what->keep, w->frame);
    return EXIT_DONE;
}

static int open_both(watch *w)
{
    const show *what = w->what;
    const char *device = what->device ? what->device : what->port->device;
    int code = what->port->open(&w->on, device, what->width, what->height);
    if (code)
        return code;
    code = check_size(what, w->on, device);
    if (!code)
        code = console_open(&w->tty);
    if (code)
        what->port->close(w->on);
    return code;
}

int show_run(const show *what)
{
    watch w = { .what = what };
    int code = take_kept(&w);
    if (!code)
        code = open_both(&w);
    return code ? code : watch_run(&w);
}
