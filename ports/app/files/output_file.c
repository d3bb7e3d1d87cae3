/* SPDX-License-Identifier: MIT */
/* Streams over descriptors that remember their first error.  stdio loses an error in an
 * intermediate flush, and a full disk would be reported as an I/O error. */
#define _GNU_SOURCE             /* for fopencookie, realpath */
#include "output_file.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "log.h"
#include "path.h"

#define BUFFER_BYTES 65536

struct output_stream {
    int  fd, error;
    char buffer[BUFFER_BYTES];
};

/* -- streams ------------------------------------------------------------------------- */

/* Writes to the descriptor; after an error writes nothing more. */
static ssize_t put(void *cookie, const char *data, size_t bytes)
{
    output_stream *end = cookie;
    if (!end->error)
        end->error = atomic_file_put(end->fd, data, bytes);
    return end->error ? 0 : (ssize_t)bytes;
}

/* Opens a stream that leaves the descriptor open when closed; returns 0 or an errno. */
static int open_stream(output_file *out, int fd)
{
    out->end = malloc(sizeof *out->end);
    if (!out->end)
        return ENOMEM;
    out->end->fd = fd;
    out->end->error = 0;
    errno = ENOMEM;
    out->file = fopencookie(out->end, "wb", (cookie_io_functions_t){ .write = put });
    if (!out->file)
        return errno;
    setvbuf(out->file, out->end->buffer, _IOFBF, BUFFER_BYTES);
    return 0;
}

/* Flushes and closes the stream; returns 0 or the first error. */
static int close_stream(output_file *out)
{
    int error = 0;
    if (out->file && fclose(out->file) != 0)
        error = errno;
    if (out->end && out->end->error)
        error = out->end->error;
    free(out->end);
    out->file = NULL;
    out->end = NULL;
    return error;
}

/* -- files --------------------------------------------------------------------------- */

static int output_file_descriptor(const output_file *out)
{
    return out->target ? out->temporary.fd : out->end ? out->end->fd : -1;
}

/* Closes the descriptor, except of temporary files, which close their own, and standard
 * output. */
static int close_descriptor(const output_file *out, int fd)
{
    return out->target || fd < 0 || fd == STDOUT_FILENO || close(fd) == 0 ? 0 : errno;
}

static void forget(output_file *out)
{
    free(out->target);
    *out = (output_file){ .name = out->name, .temporary = { -1, -1 } };
}

void output_file_discard(output_file *out)
{
    const int fd = output_file_descriptor(out);
    (void)close_stream(out);
    (void)close_descriptor(out, fd);
    if (out->target)
        atomic_file_discard(&out->temporary);
    forget(out);
}

static int refuse(output_file *out, int error)
{
    output_file_discard(out);
    return log_fail(EXIT_INPUT, "%s: %s", out->name, strerror(error));
}

int output_file_fail(output_file *out, int error)
{
    return refuse(out, out->end && out->end->error ? out->end->error : error);
}

int output_file_adopt(output_file *out, int fd, const char *name)
{
    *out = (output_file){ .name = name, .temporary = { -1, -1 } };
    const int error = fd < 0 ? errno : open_stream(out, fd);
    if (!error)
        return EXIT_DONE;
    if (fd != STDOUT_FILENO && fd >= 0)
        close(fd);
    free(out->end);
    out->end = NULL;
    return refuse(out, error);
}

/* Opens the temporary file.  old: the file to be replaced, or NULL; the new file gets its
 * mode.  If the name is a link, the link's target is replaced, not the link. */
static int open_temporary(output_file *out, const struct stat *old)
{
    out->target = old ? realpath(out->name, NULL)
                      : path_copy(out->name, strlen(out->name));
    int error = out->target ? atomic_file_open(&out->temporary, out->target, "") : errno;
    if (!error && old)          /* some file systems have no modes: no error */
        (void)fchmod(out->temporary.fd, old->st_mode & 0777);
    if (!error)
        error = open_stream(out, out->temporary.fd);
    return error ? refuse(out, error) : EXIT_DONE;
}

int output_file_open(output_file *out, const char *name)
{
    struct stat info;
    *out = (output_file){ .name = name, .temporary = { -1, -1 } };
    if (strcmp(name, "-") == 0) {
        fflush(stdout);
        return output_file_adopt(out, STDOUT_FILENO, "standard output");
    }
    const bool exists = stat(name, &info) == 0;
    if (exists && !S_ISREG(info.st_mode))
        return output_file_adopt(
            out, open(name, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666), name);
    return open_temporary(out, exists ? &info : NULL);
}

int output_file_close(output_file *out)
{
    const int fd = output_file_descriptor(out);
    int error = close_stream(out);
    const int end = close_descriptor(out, fd);
    error = error ? error : end;
    if (!error && out->target)
        error = atomic_file_commit(&out->temporary, out->target);
    if (error)
        return refuse(out, error);
    forget(out);
    return EXIT_DONE;
}
