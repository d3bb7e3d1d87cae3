/* SPDX-License-Identifier: MIT */
/* What the program says to people: lines on stderr and its exit codes.  The host library's
 * callers get the lines as a text. */
#ifndef HOST_SAY_H
#define HOST_SAY_H
#include <stddef.h>
#include "tidepool/status.h"

/* name, code, a few words, a sentence for the manual.  Every command, script and program
 * of ports/ exits with these; who is ended by a signal ends by that signal. */
#define EXIT_LIST(X) \
    X(DONE,    0, "done", "All that was asked for was done.") \
    X(CHECK,   1, "a check failed", "A comparison that was asked for failed: of" \
      " --expect, of check, or a job of charts.") \
    X(USAGE,   2, "usage", "The command line is wrong; nothing was done.") \
    X(INPUT,   3, "bad input", "A file cannot be read, used or written, or there is too" \
      " little memory.") \
    X(DISPLAY, 4, "no display or device", "No window or screen can be opened, or" \
      " none that shows such a picture.") \
    X(LOST,    5, "display lost", "The display or screen went away while it was drawn" \
      " to.")

enum {
#define X(name, code, words, sentence) EXIT_##name = code,
    EXIT_LIST(X)
#undef X
    EXIT_CODES
};

#if defined(__GNUC__)
#define HOST_PRINTF(at, first) __attribute__((format(printf, at, first)))
#else
#define HOST_PRINTF(at, first)
#endif

/* A line on stderr.  A progress line that stands there is erased first. */
void say(const char *format, ...) HOST_PRINTF(1, 2);

/* The same; returns `code`, so that a function can end with `return fail(...)`. */
int fail(int code, const char *format, ...) HOST_PRINTF(2, 3);

/* "file:line: sentence", without the line where the error has none; EXIT_INPUT. */
int fail_at(const char *file, const tp_error *err);

/* From now on what this thread says goes, line by line, into `text` of so many bytes, which
 * begins empty, and not to stderr; what is longer is cut.  NULL: to stderr again. */
void say_into(char *text, size_t bytes);

/* From now on the check that refused something is named too, where the core made it:
 * say_check gives " [src/asset/obj.c:88]", or "" as long as nobody asked. */
void        say_verbose(void);
const char *say_check(const tp_error *err);

int fail_memory(size_t bytes);

/* First of all in a program.  A standard stream that is closed would lend its number to
 * the first file that is opened, which would then hold what is meant for people; what
 * stands there instead fails as a closed stream does.  So does, from then on, what is
 * written beyond the limit of a file's size. */
void begin_streams(void);

/* Ends what was printed on standard output: a full disk or a closed pipe is an error. */
int finish_stdout(void);

/* The last line that was said, for windows to show, and how many have been; "" and 0. */
const char *say_last(unsigned *count);

/* One line that is rewritten in place; "" erases it.  Nothing unless stderr is a
 * terminal that can. */
void say_progress(const char *text);
#endif
