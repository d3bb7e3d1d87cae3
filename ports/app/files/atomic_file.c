/* SPDX-License-Identifier: MIT */
/* Temporary files, and the signal handler that removes them.
 *
 * The names are in a static table, readable from a signal handler.  A thread that adds or
 * removes an entry holds the mutex and blocks all signals.  A handler on another thread
 * waits until the entry is complete, so no file can be created after the clean-up. */
#define _DEFAULT_SOURCE         /* for NSIG, getrandom */
#define _POSIX_C_SOURCE 200809L
#include "atomic_file.h"
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <time.h>
#include <unistd.h>

#define SLOTS      32           /* files at a time: jobs, film, pictures, session */
#define NAME_BYTES 4096
#define TRIES      100          /* attempts to find an unused name */
#define WAITS      100          /* waits of 10 ms: gives up on a hanging disk */

enum { FREE, MAKING, HELD };

static struct {
    atomic_int state;
    pid_t      owner;           /* process; a forked child keeps its parent's files */
    char       name[NAME_BYTES];
} slots[SLOTS];

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static int held;                /* number of entries in use */

/* -- signals ------------------------------------------------------------------------- */

static void settle(atomic_int *state)
{
    const struct timespec wait = { 0, 10000000 };
    for (int i = 0; i < WAITS && atomic_load(state) == MAKING; i++)
        nanosleep(&wait, NULL);
}

/* Removes all files of the process.  Safe in a signal handler. */
static void remove_all(void)
{
    const pid_t self = getpid();
    for (int i = 0; i < SLOTS; i++) {
        settle(&slots[i].state);
        if (atomic_load(&slots[i].state) == HELD && slots[i].owner == self)
            unlink(slots[i].name);
    }
}

static void on_signal(int number)
{
    const struct sigaction plain = { .sa_handler = SIG_DFL };
    remove_all();
    sigaction(number, &plain, NULL);
    raise(number);
}

/* True if the default action of a signal ends the process; other signals stop, continue or
 * do nothing. */
static bool is_deadly(int number)
{
    static const int harmless[] = { SIGKILL, SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU, SIGCONT,
                                    SIGCHLD, SIGURG, SIGWINCH };
    for (size_t i = 0; i < sizeof harmless / sizeof *harmless; i++)
        if (number == harmless[i])
            return false;
    return true;
}

/* Replaces the handler `from` by `to` for each deadly signal that has the handler
 * `from`. */
static void exchange(void (*from)(int), void (*to)(int))
{
    struct sigaction now, then = { .sa_handler = to };
    sigfillset(&then.sa_mask);
    for (int number = 1; number < NSIG; number++)
        if (is_deadly(number) && sigaction(number, NULL, &now) == 0
            && !(now.sa_flags & SA_SIGINFO) && now.sa_handler == from)
            sigaction(number, &then, NULL);
}

/* -- the table ----------------------------------------------------------------------- */

static void enter(sigset_t *before)
{
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, before);
    pthread_mutex_lock(&mutex);
}

static void leave(const sigset_t *before)
{
    pthread_mutex_unlock(&mutex);
    pthread_sigmask(SIG_SETMASK, before, NULL);
}

static int free_slot(void)
{
    int i = 0;
    while (i < SLOTS && atomic_load(&slots[i].state) != FREE)
        i++;
    return i < SLOTS ? i : -1;
}

static void hold(int slot)
{
    static bool registered;
    if (!registered)
        registered = atexit(remove_all) == 0;
    exchange(SIG_DFL, on_signal);
    held++;
    slots[slot].owner = getpid();
    atomic_store(&slots[slot].state, HELD);
}

static void release(int slot)
{
    atomic_store(&slots[slot].state, FREE);
    if (--held == 0)
        exchange(on_signal, SIG_DFL);
}

/* -- names --------------------------------------------------------------------------- */

static uint64_t random_number(void)
{
    uint64_t number;
    struct timespec now;
    if (getrandom(&number, sizeof number, GRND_NONBLOCK) == sizeof number)
        return number;
    clock_gettime(CLOCK_MONOTONIC, &now);       /* the number need not be random: names are
                                                 * tried until one is free */
    return ((uint64_t)getpid() << 32 ^ (uint64_t)now.tv_nsec) * 0x9e3779b97f4a7c15;
}

/* Makes the name folder/.tidepool-XXXXXXXXXXXX<suffix>.  False: the name is too long. */
static bool make_name(char name[NAME_BYTES], const char *target, const char *suffix)
{
    static const char letters[] = "0123456789abcdefghjkmnpqrstvwxyz";
    const char *slash = strrchr(target, '/');
    const int folder = slash ? (int)(slash - target) + 1 : 0;
    uint64_t number = random_number();
    char middle[13];
    for (int i = 0; i < 12; i++, number >>= 5)
        middle[i] = letters[number & 31];
    middle[12] = 0;
    return snprintf(name, NAME_BYTES, "%.*s.tidepool-%s%s", folder, target, middle,
                    suffix) < NAME_BYTES;
}

/* Creates the file.  Returns its descriptor, or -1. */
static int make_file(int slot, const char *target, const char *suffix)
{
    char *name = slots[slot].name;
    int fd = -1;
    errno = EEXIST;
    for (int i = 0; i < TRIES && fd < 0 && errno == EEXIST; i++) {
        if (!make_name(name, target, suffix))
            errno = ENAMETOOLONG;
        else
            fd = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    return fd;
}

/* -- one file ------------------------------------------------------------------------ */

int atomic_file_open(atomic_file *f, const char *target, const char *suffix)
{
    sigset_t before;
    int error = EMFILE;
    *f = (atomic_file){ -1, -1 };
    enter(&before);
    const int slot = free_slot();
    if (slot >= 0) {
        atomic_store(&slots[slot].state, MAKING);
        f->fd = make_file(slot, target, suffix);
        error = f->fd < 0 ? errno : 0;
        if (error)
            atomic_store(&slots[slot].state, FREE);
        else
            hold(f->slot = slot);
    }
    leave(&before);
    return error;
}

/* Renames or removes the file.  Signals are blocked: a handler finds a complete entry or
 * none. */
static int end(atomic_file *f, const char *target, int error)
{
    sigset_t before;
    enter(&before);
    if (!error && rename(slots[f->slot].name, target) != 0)
        error = errno;
    if (error)
        unlink(slots[f->slot].name);
    release(f->slot);
    leave(&before);
    f->slot = -1;
    return error;
}

int atomic_file_commit(atomic_file *f, const char *target)
{
    const int error = f->fd >= 0 && close(f->fd) != 0 ? errno : 0;
    f->fd = -1;
    return end(f, target, error);
}

void atomic_file_discard(atomic_file *f)
{
    if (f->fd >= 0)
        close(f->fd);
    f->fd = -1;
    if (f->slot >= 0)
        (void)end(f, "", ECANCELED);
}

const char *atomic_file_name(const atomic_file *f)
{
    return slots[f->slot].name;
}

/* -- a file in one call -------------------------------------------------------------- */

int atomic_file_put(int fd, const void *data, size_t bytes)
{
    const uint8_t *at = data;
    while (bytes > 0) {
        const ssize_t n = write(fd, at, bytes);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return n < 0 ? errno : ENOSPC;
        at += n;
        bytes -= (size_t)n;
    }
    return 0;
}

/* Syncs the folder of `target`: only then is the new name on the disk. */
static void sync_folder(const char *target)
{
    char folder[NAME_BYTES];
    const char *slash = strrchr(target, '/');
    const size_t length = slash ? (size_t)(slash - target) : 0;
    if (length >= sizeof folder)
        return;
    memcpy(folder, target, length);
    folder[length] = '\0';
    const int fd = open(length ? folder : slash ? "/" : ".", O_RDONLY | O_CLOEXEC);
    if (fd >= 0) {
        (void)fsync(fd);
        close(fd);
    }
}

bool atomic_file_write(const char *target, const void *head, size_t head_bytes,
                       const void *body, size_t body_bytes)
{
    atomic_file f;
    int error = atomic_file_open(&f, target, "");
    if (!error)
        error = atomic_file_put(f.fd, head, head_bytes);
    if (!error)
        error = atomic_file_put(f.fd, body, body_bytes);
    if (!error && fsync(f.fd) != 0)
        error = errno;
    if (!error)
        error = atomic_file_commit(&f, target);
    else
        atomic_file_discard(&f);
    if (!error)
        sync_folder(target);
    errno = error;
    return !error;
}
