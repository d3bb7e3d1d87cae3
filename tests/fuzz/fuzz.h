/* SPDX-License-Identifier: MIT */
/* Shared by the fuzz targets: a check that all builds keep, files in memory, and the format
 * of error messages. Messages go to stderr; tests/fuzz/run.sh lets libFuzzer close stderr.
 * Include this header first. */
#ifndef TP_TESTS_FUZZ_H
#define TP_TESTS_FUZZ_H
#define _GNU_SOURCE             /* memfd_create */
#include <sanitizer/common_interface_defs.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>
#include "app/files/log.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define REQUIRE(x) ((x) ? (void)0 : fuzz_stop(#x, __FILE__, __LINE__))

/* Prints the failure where the sanitizers print: stderr may be closed. */
static inline void fuzz_stop(const char *what, const char *file, int line)
{
    char text[512];
    snprintf(text, sizeof text, "%s:%d: does not hold: %s", file, line, what);
    __sanitizer_report_error_summary(text);
    abort();
}

/* -- input ------------------------------------------------------------------------- */

/* Removes and returns the first byte; 0 if there is none. */
static inline uint8_t fuzz_byte(const uint8_t **data, size_t *size)
{
    const uint8_t byte = *size ? **data : 0;
    *data += *size > 0;
    *size -= *size > 0;
    return byte;
}

/* Removes and returns the part before a line "%%", and removes that line; returns all if
 * there is no such line. */
static inline const uint8_t *fuzz_part(const uint8_t **data, size_t *size, size_t *bytes)
{
    const uint8_t *part = *data;
    for (size_t i = 0; i + 3 <= *size; i++)
        if ((i == 0 || part[i - 1] == '\n') && memcmp(part + i, "%%\n", 3) == 0) {
            *bytes = i;
            *data += i + 3;
            *size -= i + 3;
            return part;
        }
    *bytes = *size;
    *data += *size;
    *size = 0;
    return part;
}

/* Heap block of exactly these bytes, so that ASan detects a read beyond the end. */
static inline char *fuzz_copy(const uint8_t *data, size_t size)
{
    char *copy = malloc(size ? size : 1);
    REQUIRE(copy != NULL);
    memcpy(copy, data, size);
    return copy;
}

/* Heap block with these bytes and a terminating 0. */
static inline char *fuzz_text(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1);
    REQUIRE(text != NULL);
    memcpy(text, data, size);
    text[size] = 0;
    return text;
}

/* Ends the line and returns the next line, or NULL. */
static inline char *fuzz_line(char *line)
{
    char *end = line + strcspn(line, "\n");
    if (!*end)
        return NULL;
    *end = 0;
    return end + 1;
}

/* -- files in memory --------------------------------------------------------------- */

enum { FUZZ_FILES = 3 };

/* Path of file `i`, with these bytes from now on. The path is equal in all runs. */
static inline const char *fuzz_file(int i, const void *data, size_t size)
{
    static struct { char path[32]; int fd; } files[FUZZ_FILES];
    if (!files[i].path[0]) {
        files[i].fd = memfd_create("fuzz", 0);
        REQUIRE(files[i].fd >= 0);
        snprintf(files[i].path, sizeof files[i].path, "/proc/self/fd/%d", files[i].fd);
    }
    REQUIRE(ftruncate(files[i].fd, 0) == 0);
    REQUIRE(pwrite(files[i].fd, data, size, 0) == (ssize_t)size);
    return files[i].path;
}

/* Present contents of a file; *size: number of bytes. The caller frees the result. */
static inline uint8_t *fuzz_contents(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    REQUIRE(file != NULL && fseek(file, 0, SEEK_END) == 0);
    *size = (size_t)ftell(file);
    rewind(file);
    uint8_t *bytes = malloc(*size + 1);
    REQUIRE(bytes != NULL && fread(bytes, 1, *size, file) == *size);
    fclose(file);
    return bytes;
}

/* A folder in $TMPDIR for this process only. */
static inline const char *fuzz_folder(void)
{
    static char folder[4096];
    if (!folder[0]) {
        const char *where = getenv("TMPDIR");
        snprintf(folder, sizeof folder, "%s/fuzz-XXXXXX", where ? where : "/tmp");
        REQUIRE(mkdtemp(folder) != NULL);
    }
    return folder;
}

/* -- error messages ---------------------------------------------------------------- */

/* Number of lines; the last line may lack its end. */
static inline unsigned fuzz_lines(const uint8_t *data, size_t size)
{
    unsigned lines = size > 0 && data[size - 1] != '\n';
    for (size_t i = 0; i < size; i++)
        lines += data[i] == '\n';
    return lines;
}

/* True if a message is "PLACE: sentence" or "PLACE:LINE: sentence", LINE 1..lines, without
 * control characters: they might control a terminal. */
static inline bool fuzz_says(const char *message, const char *place, unsigned lines)
{
    const size_t n = strlen(place);
    unsigned line = 0;
    if (strncmp(message, place, n) != 0 || message[n] != ':')
        return false;
    message += n + 1;
    const bool lined = *message >= '0' && *message <= '9';
    for (; *message >= '0' && *message <= '9'; message++)
        line = line * 10 + (unsigned)(*message - '0');
    if (lined && (*message++ != ':' || line < 1 || line > lines))
        return false;
    for (const char *c = message; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7f)
            return false;
    return message[0] == ' ' && message[1] && message[1] != ' ';
}

/* Requires an error message from the last call. */
static inline void fuzz_refused(const char *place, unsigned lines)
{
    static unsigned before;
    unsigned count;
    const char *last = log_last(&count);
    REQUIRE(count != before && fuzz_says(last, place, lines));
    before = count;
}
#endif
