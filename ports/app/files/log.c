/* SPDX-License-Identifier: MIT */
/* Messages.  All messages to users pass through the functions here, so a progress line
 * never mixes with a message. */
#define _POSIX_C_SOURCE 200809L
#include "log.h"
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool     progress_shown, verbose;
static char     last[512];
static unsigned lines;

/* Buffer for the messages of the thread; text == NULL: stderr. */
static _Thread_local struct {
    char *text;
    size_t bytes, used;
} kept;

static bool can_rewrite(void)
{
    const char *term = getenv("TERM");
    return isatty(STDERR_FILENO) && term && strcmp(term, "dumb") != 0;
}

void log_progress(const char *text)
{
    if (!progress_shown && (!*text || !can_rewrite()))
        return;
    fprintf(stderr, "\r\033[K%s", text);
    fflush(stderr);
    progress_shown = *text != 0;
}

/* Replaces control characters: text quoted from a file may contain escape sequences that a
 * terminal would execute. */
static void clean(char *text)
{
    for (; *text; text++)
        if ((unsigned char)*text < ' ' || *text == 0x7f)
            *text = '?';
}

static void say_list(const char *format, va_list list) LOG_PRINTF(1, 0);
static void keep(const char *format, va_list list) LOG_PRINTF(1, 0);

static void keep(const char *format, va_list list)
{
    char *line = kept.text + kept.used;
    const size_t room = kept.bytes - kept.used;
    if (room < 3)
        return;
    const int bytes = vsnprintf(line + (kept.used > 0), room - 1, format, list);
    clean(line + (kept.used > 0));
    if (kept.used > 0)
        *line = '\n';
    if (bytes >= 0)
        kept.used += strlen(line);
}

void log_redirect(char *text, size_t bytes)
{
    kept.text = text;
    kept.bytes = bytes;
    kept.used = 0;
    if (text)
        *text = 0;
}

static void say_list(const char *format, va_list list)
{
    if (kept.text) {
        keep(format, list);
        return;
    }
    va_list again;
    va_copy(again, list);
    const int bytes = vsnprintf(last, sizeof last, format, again);
    va_end(again);
    char *whole = bytes >= (int)sizeof last ? malloc((size_t)bytes + 1) : NULL;
    if (whole)
        vsnprintf(whole, (size_t)bytes + 1, format, list);
    clean(last);
    lines++;
    log_progress("");
    if (whole)
        clean(whole);
    fprintf(stderr, "%s\n", whole ? whole : last);
    free(whole);
}

void log_line(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    say_list(format, list);
    va_end(list);
}

int log_fail(int code, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    say_list(format, list);
    va_end(list);
    return code;
}

const char *log_last(unsigned *count)
{
    *count = lines;
    return last;
}

void log_set_verbose(void)
{
    verbose = true;
}

const char *log_check_place(const tp_error *err)
{
    static char text[128];
    if (!verbose || !err->file)
        return "";
    snprintf(text, sizeof text, " [%s:%d]", err->file, err->line);
    return text;
}

int log_fail_error(const char *file, const tp_error *err)
{
    char text[256];
    tp_error_text(err, text, sizeof text);
    if (err->where)
        return log_fail(EXIT_INPUT, "%s:%u: %s%s", file, (unsigned)err->where, text,
                        log_check_place(err));
    return log_fail(EXIT_INPUT, "%s: %s%s", file, text, log_check_place(err));
}

int log_fail_memory(size_t bytes)
{
    return log_fail(EXIT_INPUT, "tidepool: out of memory: %zu bytes needed", bytes);
}
