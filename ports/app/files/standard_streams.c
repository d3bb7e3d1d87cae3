/* SPDX-License-Identifier: MIT */
/* A program's standard streams at its start and at its end. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include "log.h"

void streams_begin(void)
{
    for (int fd = 0; fd <= STDERR_FILENO; fd++)
        if (fcntl(fd, F_GETFD) < 0 && open("/dev/null", fd ? O_RDONLY : O_WRONLY) != fd)
            _exit(EXIT_INPUT);
    signal(SIGXFSZ, SIG_IGN);
}

/* Flushes standard output.  After an earlier failed write, the flush of the rest gives the
 * reason; if nothing is left to flush, that of one byte more. */
int streams_finish(void)
{
    errno = 0;
    bool flushed = fflush(stdout) == 0;
    if (flushed && !ferror(stdout))
        return EXIT_DONE;
    if (flushed)
        flushed = fputc('\n', stdout) != EOF && fflush(stdout) == 0;
    return log_fail(EXIT_INPUT, "standard output: %s", strerror(errno ? errno : EIO));
}
