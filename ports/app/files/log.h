/* SPDX-License-Identifier: MIT */
/* Messages to users, one line each on stderr, and exit codes.  Callers of the host library
 * get the messages as text. */
#ifndef TP_APP_FILES_LOG_H
#define TP_APP_FILES_LOG_H
#include <stddef.h>
#include "tidepool/status.h"

/* Columns: name, code, a few words, a sentence for the manual.  All commands, scripts and
 * programs of ports/ use the same exit codes.  A program ended by a signal ends by that
 * signal. */
#define EXIT_LIST(X) \
    X(DONE,    0, "done", "Everything requested was done.") \
    X(CHECK,   1, "a check failed", "A requested check failed: --expect, check," \
      " or a job of charts.") \
    X(USAGE,   2, "usage", "The command line is wrong; nothing was done.") \
    X(INPUT,   3, "bad input", "A file cannot be read, used or written, or there is too" \
      " little memory.") \
    X(DISPLAY, 4, "no display or device", "No window or screen can be opened, or" \
      " none can show this picture.") \
    X(LOST,    5, "display lost", "The display or screen was lost while drawing.")

enum {
#define X(name, code, words, sentence) EXIT_##name = code,
    EXIT_LIST(X)
#undef X
    EXIT_CODES
};

#if defined(__GNUC__)
#define LOG_PRINTF(at, first) __attribute__((format(printf, at, first)))
#else
#define LOG_PRINTF(at, first)
#endif

/* Prints a line on stderr, after erasing a progress line. */
void log_line(const char *format, ...) LOG_PRINTF(1, 2);

/* Prints a line and returns `code`: a function can end with `return log_fail(...)`. */
int log_fail(int code, const char *format, ...) LOG_PRINTF(2, 3);

/* Prints "file:line: sentence", without a line number if the error has none; returns
 * EXIT_INPUT. */
int log_fail_error(const char *file, const tp_error *err);

/* Redirects the messages of the calling thread to `text`, line by line, instead of stderr.
 * text has `bytes` bytes and is emptied first; excess text is cut.  NULL: back to
 * stderr. */
void log_redirect(char *text, size_t bytes);

/* log_set_verbose turns on the names of failed checks.  log_check_place then returns
 * the place of the check, as " [src/mesh/obj.c:88]"; otherwise "". */
void        log_set_verbose(void);
const char *log_check_place(const tp_error *err);

int log_fail_memory(size_t bytes);

/* To call first in a program.  If a standard stream is closed, the next opened file would
 * get its descriptor and receive messages for users.  The function opens a descriptor in
 * its place that fails like a closed stream.  It also turns the signal for a file over the
 * size limit into an error of the write. */
void streams_begin(void);

/* Flushes standard output; a full disk or a closed pipe is an error. */
int streams_finish(void);

/* Returns the last message, to show in windows, and the number of messages; at first "" and
 * 0. */
const char *log_last(unsigned *count);

/* Rewrites the progress line in place; "" erases the line.  Does nothing if stderr is not a
 * terminal that can rewrite. */
void log_progress(const char *text);
#endif
