/* SPDX-License-Identifier: MIT */
/* Films of the preview.  ffmpeg reads Y4M from a pipe and writes to a temporary file, in a
 * process group of its own.  Ctrl+C in the terminal then ends only the preview; the preview
 * closes the pipe, and ffmpeg completes its file.
 *
 * The pipe holds a picture or two: if ffmpeg is slower than the preview, the preview
 * waits. */
#define _GNU_SOURCE             /* for pipe2, F_SETPIPE_SZ */
#include "recorder.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "app/files/log.h"

#define PIPE_BYTES (1 << 20)
#define NUMBERS    9999

extern char **environ;

struct recorder {
    film     film;
    uint32_t width, height, pictures;
    char     name[TP_NAME_BYTES + 32];
    atomic_file temporary;      /* the file that ffmpeg writes */
    pid_t    ffmpeg;            /* process of ffmpeg; 0: none, the film is Y4M */
    bool     over;              /* the film has ended, after a message */
};

/* -- names --------------------------------------------------------------------------- */

/* Chooses the first number used by neither kind of film. */
static void choose_number(const char *scene, char *stem, size_t bytes)
{
    for (int number = 1; number <= NUMBERS; number++) {
        char name[TP_NAME_BYTES + 64];
        snprintf(stem, bytes, "%.127s-%04d", scene, number);
        snprintf(name, sizeof name, "%s.mp4", stem);
        const bool taken = access(name, F_OK) == 0;
        snprintf(name, sizeof name, "%s.y4m", stem);
        if (!taken && access(name, F_OK) != 0)
            return;
    }
}

/* -- ffmpeg -------------------------------------------------------------------------- */

/* Starts ffmpeg.  Returns 0 or an errno; ENOENT: ffmpeg is not installed.  H.264 in 4:2:0
 * needs even sides: odd sides are padded. */
static int spawn(recorder *r, int from)
{
    static char pad[] = "pad=ceil(iw/2)*2:ceil(ih/2)*2";
    char *to = (char *)(uintptr_t)atomic_file_name(&r->temporary);
    char *argv[] = { "ffmpeg", "-v", "error", "-y", "-f", "yuv4mpegpipe", "-i", "-",
                     "-pix_fmt", "yuv420p", to, NULL, NULL, NULL };
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t plain;
    if ((r->width | r->height) & 1) {
        argv[10] = "-vf";
        argv[11] = pad;
        argv[12] = to;
    }
    sigemptyset(&plain);
    sigaddset(&plain, SIGPIPE);
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, from, STDIN_FILENO);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setsigdefault(&attributes, &plain);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    const int error = posix_spawnp(&r->ffmpeg, "ffmpeg", &actions, &attributes, argv,
                                   environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    r->ffmpeg = error ? 0 : r->ffmpeg;
    return error;
}

/* Waits for the end of ffmpeg.  False, after a message, if ffmpeg failed. */
static bool ffmpeg_ended_well(recorder *r)
{
    int status = 0;
    while (waitpid(r->ffmpeg, &status, 0) < 0 && errno == EINTR)
        continue;
    r->ffmpeg = 0;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return true;
    if (WIFSIGNALED(status))
        log_line("%s: ffmpeg was ended by signal %d after %u pictures; no film was written",
            r->name, WTERMSIG(status), (unsigned)r->pictures);
    else
        log_line("%s: ffmpeg ended with %d after %u pictures; no film was written", r->name,
            WEXITSTATUS(status), (unsigned)r->pictures);
    return false;
}

/* Begins a film with ffmpeg.  Returns 0 or an errno; ENOENT, without a message: ffmpeg is
 * not installed. */
static int begin_ffmpeg(recorder *r)
{
    int ends[2];
    int error = atomic_file_open(&r->temporary, r->name, ".mp4");
    if (error) {
        log_line("%s: %s", r->name, strerror(error));
        return EACCES;
    }
    error = pipe2(ends, O_CLOEXEC) ? errno : 0;
    if (!error) {
        error = spawn(r, ends[0]);
        close(ends[0]);
        (void)fcntl(ends[1], F_SETPIPE_SZ, PIPE_BYTES);
        if (error)
            close(ends[1]);
        else if (film_open_pipe(&r->film, ends[1], r->name, r->width, r->height))
            error = EPIPE;
    }
    if (error) {
        atomic_file_discard(&r->temporary);
        if (r->ffmpeg)
            (void)ffmpeg_ended_well(r);
        else if (error != ENOENT)
            log_line("%s: ffmpeg: %s", r->name, strerror(error));
    }
    return error;
}

/* -- the film ------------------------------------------------------------------------ */

recorder *recorder_begin(const char *scene, uint32_t width, uint32_t height)
{
    char stem[TP_NAME_BYTES + 16];
    recorder *r = calloc(1, sizeof *r);
    if (!r) {
        log_fail_memory(sizeof *r);
        return NULL;
    }
    r->width = width;
    r->height = height;
    choose_number(scene, stem, sizeof stem);
    snprintf(r->name, sizeof r->name, "%s.mp4", stem);
    int error = begin_ffmpeg(r);
    if (error == ENOENT) {
        snprintf(r->name, sizeof r->name, "%s.y4m", stem);
        error = film_open(&r->film, r->name, width, height, 1);
        const unsigned kilobytes = (unsigned)(r->film.bytes * TP_TICKS_PER_SECOND / 1000);
        if (!error)
            log_line("%s: recording uncompressed, %u.%u MB a second: no ffmpeg for MP4",
                     r->name, kilobytes / 1000, kilobytes / 100 % 10);
    } else if (!error) {
        log_line("%s: recording through ffmpeg", r->name);
    }
    if (!error)
        return r;
    free(r);
    return NULL;
}

static int finish(recorder *r)
{
    const bool piped = r->ffmpeg != 0;
    int code = film_close(&r->film);
    r->over = true;
    if (piped && !ffmpeg_ended_well(r))
        code = EXIT_INPUT;
    const int error = piped && !code ? atomic_file_commit(&r->temporary, r->name) : 0;
    if (error)
        code = log_fail(EXIT_INPUT, "%s: %s", r->name, strerror(error));
    if (piped && code)
        atomic_file_discard(&r->temporary);
    if (!code)
        log_line("%s: %u picture%s, %u.%02u s", r->name, (unsigned)r->pictures,
            r->pictures == 1 ? "" : "s",
            (unsigned)(r->pictures / TP_TICKS_PER_SECOND),
            (unsigned)(r->pictures % TP_TICKS_PER_SECOND * 100 / TP_TICKS_PER_SECOND));
    return code;
}

/* Stops recording after film_add has failed; film_add has printed the reason and closed
 * the pipe.  Waits for FFmpeg and removes the unfinished film. */
static void abandon_film(recorder *r)
{
    r->over = true;
    if (r->ffmpeg) {
        (void)ffmpeg_ended_well(r);
        atomic_file_discard(&r->temporary);
    }
}

bool recorder_add(recorder *r, const picture *p)
{
    if (r->over)
        return false;
    if (p->width != r->width || p->height != r->height) {
        log_line("%s: the size of the picture has changed, the film ends", r->name);
        (void)finish(r);
        return false;
    }
    if (film_add(&r->film, p)) {
        abandon_film(r);
        return false;
    }
    r->pictures++;
    return true;
}

int recorder_end(recorder *r)
{
    const int code = !r || r->over ? EXIT_DONE : finish(r);
    free(r);
    return code;
}

const char *recorder_name(const recorder *r)
{
    return r->name;
}

uint32_t recorder_pictures(const recorder *r)
{
    return r->pictures;
}
