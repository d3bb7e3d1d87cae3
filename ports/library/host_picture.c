/* SPDX-License-Identifier: MIT */
/* Pictures and PNG files.  A file is replaced atomically: a temporary file beside it is
 * renamed.  The program's own code for this (output_file.h) catches signals, which belong
 * to the caller here. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "app/files/log.h"
#include "host.h"

#define TRIES 1000 /* names tried until one is free */

const tp_host_picture *tp_host_draw(tp_host *host)
{
    frame_renderer *c = &host->loaded.renderer;
    if (!c->frame)
        return NULL;
    frame_renderer_draw(c, host->loaded.world);
    host->picture =
        (tp_host_picture){ c->picture.format, c->picture.width, c->picture.height,
                           c->picture.row_bytes, c->picture.rows };
    return &host->picture;
}

/* -- PNG ----------------------------------------------------------------------------- */

/* The int functions below return 0 or an errno, except open_beside.  close_file also
 * passes on an earlier `error`. */
static int close_file(FILE *file, int error)
{
    errno = 0;
    const int closed = fclose(file) == 0 ? 0 : errno ? errno : EIO;
    return error ? error : closed;
}

static int write_png(const picture *p, const char *path)
{
    FILE *file = fopen(path, "wb");
    return file ? close_file(file, picture_put_png(p, file)) : errno;
}

/* Opens a new file beside `path`; writes its name to `temporary`.  Returns -1 on
 * failure, with errno. */
static int open_beside(const char *path, char *temporary, size_t bytes)
{
    int fd = -1;
    errno = EEXIST;
    for (unsigned n = 0; n < TRIES && fd < 0 && errno == EEXIST; n++) {
        snprintf(temporary, bytes, "%s.%ld-%u", path, (long)getpid(), n);
        fd = open(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    return fd;
}

/* Renames the new file, with the old file's permissions. */
static int take_name(const char *temporary, const char *path)
{
    struct stat there;
    if (stat(path, &there) == 0 && chmod(temporary, there.st_mode & 07777))
        return errno;
    return rename(temporary, path) ? errno : 0;
}

static int replace(const picture *p, const char *path, char *temporary, size_t bytes)
{
    const int fd = open_beside(path, temporary, bytes);
    if (fd < 0)
        return errno;
    FILE *file = fdopen(fd, "wb");
    if (!file)
        close(fd);
    int error = file ? close_file(file, picture_put_png(p, file)) : ENOMEM;
    if (!error)
        error = take_name(temporary, path);
    if (error)
        unlink(temporary);
    return error;
}

/* Saves a picture.  A device or a link is written directly. */
static int save(const picture *p, const char *path)
{
    struct stat there;
    if (lstat(path, &there) == 0 && !S_ISREG(there.st_mode))
        return write_png(p, path);
    const size_t bytes = strlen(path) + 40;
    char *temporary = malloc(bytes);
    const int error = temporary ? replace(p, path, temporary, bytes) : ENOMEM;
    free(temporary);
    return error;
}

bool tp_host_save_png(tp_host *host, const char *path, tp_host_error *err)
{
    host_call call;
    host_call_begin(&call, err);
    const int error =
        tp_host_draw(host) ? save(&host->loaded.renderer.picture, path) : ENOMEM;
    if (error)
        log_line("%s: %s", path, strerror(error));
    host_call_end();
    return !error;
}
