/* SPDX-License-Identifier: MIT */
/* Fault injection for programs that save files.  Loaded before a program (LD_PRELOAD),
 * makes a call of the C library fail.
 *
 * FAULT_CALL open, stream (fopencookie), write, fsync, close, rename or memory FAULT_AT
 * number of the failing call; a write at that number stores one byte, the next
 *               write fails
 * FAULT_LOG gets a line "hit" if the call was reached, and "leaked N" if the program
 * ends
 *               with N more open descriptors than at the start
 *
 * FAULT_MAIN count calls from main on; otherwise from faults_begin(), called by the
 * program */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void faults_begin(void);

static int armed, calls, hit, descriptors;

static int count_descriptors(void)
{
    int count = 0;
    DIR *folder = opendir("/proc/self/fd");
    while (folder && readdir(folder))
        count++;
    if (folder)
        closedir(folder);
    return count;
}

void faults_begin(void)
{
    descriptors = count_descriptors();
    armed = 1;
}

__attribute__((destructor)) static void end(void)
{
    const char *name = getenv("FAULT_LOG");
    armed = 0;
    const int leaked = count_descriptors() - descriptors;
    FILE *log = name ? fopen(name, "w") : NULL;
    if (!log)
        return;
    if (hit)
        fputs("hit\n", log);
    if (leaked > 0)
        fprintf(log, "leaked %d\n", leaked);
    fclose(log);
}

/* True if this call must fail; errno is then set. */
static int fails(const char *call, int error)
{
    const char *chosen = armed ? getenv("FAULT_CALL") : NULL;
    if (!chosen || strcmp(chosen, call) != 0)
        return 0;
    if (__atomic_add_fetch(&calls, 1, __ATOMIC_SEQ_CST) != atoi(getenv("FAULT_AT")))
        return 0;
    hit = 1;
    errno = error;
    return 1;
}

#define REAL(name) \
    __typeof__(&name) real; \
    *(void **)&real = dlsym(RTLD_NEXT, #name)

/* -- files ------------------------------------------------------------------------- */

int open(const char *path, int flags, ...)
{
    va_list list;
    va_start(list, flags);
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(list, mode_t) : 0;
    va_end(list);
    REAL(open);
    return fails("open", EMFILE) ? -1 : real(path, flags, mode);
}

FILE *fopen(const char *restrict path, const char *restrict mode)
{
    REAL(fopen);
    return fails("open", EMFILE) ? NULL : real(path, mode);
}

FILE *fopencookie(void *restrict cookie, const char *restrict mode,
                  cookie_io_functions_t functions)
{
    REAL(fopencookie);
    return fails("stream", ENOMEM) ? NULL : real(cookie, mode, functions);
}

ssize_t write(int fd, const void *data, size_t bytes)
{
    static int full;
    REAL(write);
    if (full) {
        errno = ENOSPC;
        return -1;
    }
    if (!fails("write", ENOSPC))
        return real(fd, data, bytes);
    full = 1;
    return real(fd, data, bytes ? 1 : 0);
}

int fsync(int fd)
{
    REAL(fsync);
    return fails("fsync", EIO) ? -1 : real(fd);
}

int close(int fd)
{
    REAL(close);
    const int code = real(fd);              /* a failed close closes the file too */
    return fails("close", EDQUOT) ? -1 : code;
}

int rename(const char *from, const char *to)
{
    REAL(rename);
    return fails("rename", EACCES) ? -1 : real(from, to);
}

/* -- memory ------------------------------------------------------------------------ */

extern void *__libc_malloc(size_t bytes);
extern void *__libc_calloc(size_t count, size_t bytes);
extern void *__libc_realloc(void *old, size_t bytes);

void *malloc(size_t bytes)
{
    return fails("memory", ENOMEM) ? NULL : __libc_malloc(bytes);
}

void *calloc(size_t count, size_t bytes)
{
    return fails("memory", ENOMEM) ? NULL : __libc_calloc(count, bytes);
}

void *realloc(void *old, size_t bytes)
{
    return fails("memory", ENOMEM) ? NULL : __libc_realloc(old, bytes);
}

/* -- counting from main ------------------------------------------------------------ */

static int (*real_main)(int, char **, char **);

static int begin_main(int argc, char **argv, char **environment)
{
    if (getenv("FAULT_MAIN"))
        faults_begin();
    return real_main(argc, argv, environment);
}

int __libc_start_main(int (*main)(int, char **, char **), int argc, char **argv,
                      void (*init)(void), void (*fini)(void), void (*loader)(void),
                      void *stack);

int __libc_start_main(int (*main)(int, char **, char **), int argc, char **argv,
                      void (*init)(void), void (*fini)(void), void (*loader)(void),
                      void *stack)
{
    REAL(__libc_start_main);
    real_main = main;
    return real(begin_main, argc, argv, init, fini, loader, stack);
}
