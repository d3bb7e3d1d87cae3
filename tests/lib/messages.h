/* SPDX-License-Identifier: MIT */
/* Takes the messages on stderr of a call. */
#ifndef TP_TESTS_LIB_MESSAGES_H
#define TP_TESTS_LIB_MESSAGES_H
#include <stdio.h>
#include <unistd.h>

typedef struct {
    FILE *file;
    int   stderr_before;
} messages;

static inline messages messages_begin(void)
{
    const messages m = { tmpfile(), dup(STDERR_FILENO) };
    assert_non_null(m.file);
    dup2(fileno(m.file), STDERR_FILENO);
    return m;
}

/* Restores stderr; `text` receives the messages, at most bytes - 1 of them. */
static inline void messages_end(messages *m, char *text, size_t bytes)
{
    dup2(m->stderr_before, STDERR_FILENO);
    close(m->stderr_before);
    rewind(m->file);
    text[fread(text, 1, bytes - 1, m->file)] = '\0';
    fclose(m->file);
}
#endif
