/* SPDX-License-Identifier: MIT */
/* Whole files or none, also when a signal ends the program. */
#define _XOPEN_SOURCE 700       /* realpath */
#include "output.h"
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "path.h"
#include "say.h"

/* The temporary files that exist now, "" where there is none: the handler has to find
 * them. */
static char pending[OUTPUTS][4096];

static void remove_pending(int signal_number)
{
    for (int i = 0; i < OUTPUTS; i++)
        if (pending[i][0])
            unlink(pending[i]);
    signal(signal_number, SIG_DFL);
    raise(signal_number);
}

/* Signals that somebody else already takes care of stay theirs.  By sigaction, since
 * signal() of strict POSIX would let a second signal through before the first is dealt
 * with, and `timeout` sends two. */
static void watch_signals(void)
{
    static const int deadly[] = { SIGINT, SIGTERM, SIGHUP };
    struct sigaction now, ours = { .sa_handler = remove_pending };

    sigfillset(&ours.sa_mask);
    for (size_t i = 0; i < sizeof deadly / sizeof *deadly; i++) {
        if (sigaction(deadly[i], NULL, &now) == 0 && now.sa_handler == SIG_DFL)
            sigaction(deadly[i], &ours, NULL);
    }
    signal(SIGPIPE, SIG_IGN);       /* a write to it then fails with EPIPE */
    signal(SIGXFSZ, SIG_IGN);       /* likewise EFBIG */
}

/* mkstemp makes files private; a result is as readable as any other file. */
static FILE *open_temporary(char *name)
{
    const int descriptor = mkstemp(name);
    if (descriptor < 0)
        return NULL;
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor, 0666 & ~mask);
    return fdopen(descriptor, "wb");
}

static int free_slot(void)
{
    int i = 0;
    while (i < OUTPUTS && pending[i][0])
        i++;
    return i;
}

static int refuse(output *out, int error)
{
    if (out->target && out->slot < OUTPUTS)
        pending[out->slot][0] = 0;
    free(out->target);
    *out = (output){ .name = out->name };
    return fail(EXIT_INPUT, "%s: %s", out->name, strerror(error));
}

int output_open(output *out, const char *name)
{
    struct stat info;
    *out = (output){ .name = name, .slot = free_slot() };
    watch_signals();
    if (strcmp(name, "-") == 0) {
        out->name = "standard output";
        out->file = stdout;
        return EXIT_DONE;
    }
    const bool exists = stat(name, &info) == 0;
    if (exists && !S_ISREG(info.st_mode)) {
        out->file = fopen(name, "wb");
        return out->file ? EXIT_DONE : refuse(out, errno);
    }
    out->target = exists ? realpath(name, NULL) : path_copy(name, strlen(name));
    char *temporary = out->target ? path_beside(out->target, ".tidepool-XXXXXX") : NULL;
    const int error = !temporary ? ENOMEM : out->slot == OUTPUTS ? EMFILE
                    : strlen(temporary) >= sizeof *pending ? ENAMETOOLONG : 0;
    if (error) {
        free(temporary);
        out->slot = OUTPUTS;
        return refuse(out, error);
    }
    strcpy(pending[out->slot], temporary);
    free(temporary);
    out->file = open_temporary(pending[out->slot]);
    return out->file ? EXIT_DONE : refuse(out, errno);
}

void output_discard(output *out)
{
    if (out->file && out->file != stdout)
        fclose(out->file);
    if (out->target && pending[out->slot][0])
        unlink(pending[out->slot]);
    if (out->target)
        pending[out->slot][0] = 0;
    free(out->target);
    *out = (output){ .name = out->name };
}

int output_failed(output *out, int error)
{
    output_discard(out);
    return fail(EXIT_INPUT, "%s: %s", out->name, strerror(error));
}

int output_close(output *out)
{
    FILE *file = out->file;
    errno = 0;
    const bool bad = ferror(file) || fflush(file);
    int error = bad ? (errno ? errno : EIO) : 0;
    if (file != stdout && fclose(file) && !error)
        error = errno;
    out->file = NULL;
    if (!error && out->target && rename(pending[out->slot], out->target))
        error = errno;
    if (error)
        return output_failed(out, error);
    if (out->target)
        pending[out->slot][0] = 0;
    output_discard(out);
    return EXIT_DONE;
}
