/* SPDX-License-Identifier: MIT */
/* Long file names and the short texts that stand for them: see long_name.h. */
#define _POSIX_C_SOURCE 200809L
#include "long_name.h"
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "tidepool/scene.h"

#define END_BYTES 100           /* bytes of the long name's end that are shown */

typedef struct long_name long_name;
struct long_name {
    long_name *next;
    char       text[TP_NAME_BYTES];
    char      *whole;
};

static long_name *all;
static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;

static const long_name *find_text(const char *text)
{
    const long_name *name = all;
    while (name && strcmp(name->text, text) != 0)
        name = name->next;
    return name;
}

static const long_name *find_whole(const char *whole)
{
    const long_name *name = all;
    while (name && strcmp(name->whole, whole) != 0)
        name = name->next;
    return name;
}

const char *long_name_whole(const char *text)
{
    pthread_mutex_lock(&mutex);
    const long_name *name = find_text(text);
    pthread_mutex_unlock(&mutex);
    return name ? name->whole : text;
}

/* Returns the last folders of a path, up to END_BYTES, or the last letters of a name
 * without folders. */
static const char *name_tail(const char *whole)
{
    const char *end = whole + strlen(whole) - END_BYTES;
    const char *slash = strchr(end, '/');
    if (slash && slash[1])
        return slash;
    while ((*end & 0xc0) == 0x80)                       /* inside a UTF-8 sequence */
        end++;
    return end;
}

/* Makes the short text; a number distinguishes names with the same end. */
static void put_text(long_name *name)
{
    const char *end = name_tail(name->whole);
    snprintf(name->text, sizeof name->text, "...%s", end);
    for (unsigned n = 2; find_text(name->text); n++)
        snprintf(name->text, sizeof name->text, "...%u...%s", n, end);
}

/* Adds a name and takes ownership of `whole`, which may be NULL. */
static const long_name *add(char *whole)
{
    const long_name *there = whole ? find_whole(whole) : NULL;
    long_name *made = whole && !there ? malloc(sizeof *made) : NULL;
    if (!made) {
        free(whole);
        return there;
    }
    *made = (long_name){ .next = all, .whole = whole };
    put_text(made);
    all = made;
    return made;
}

const char *long_name_shorten(const char *name, size_t bytes)
{
    char *whole = path_copy(name, bytes);
    pthread_mutex_lock(&mutex);
    const long_name *made = add(whole);
    pthread_mutex_unlock(&mutex);
    if (!made)
        log_fail_memory(bytes);
    return made ? made->text : NULL;
}
