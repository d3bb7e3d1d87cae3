/* SPDX-License-Identifier: MIT */
/* Replacing a file as a whole: what is written goes to a temporary file in the target's
 * folder, which then takes the target's name.  Readers find the old file or the new one.
 * Temporary names are unique: two programs that save the same file both succeed, and the
 * last one to finish is found.
 *
 * A temporary file never outlives its use: it is removed when writing fails, when the
 * program exits and by every signal that ends it and can be caught; the signal then does
 * what it does by default.  Signals that have a handler already are left alone. */
#ifndef HOST_ATOMIC_FILE_H
#define HOST_ATOMIC_FILE_H
#include <stdbool.h>
#include <stddef.h>

typedef struct {
    int fd;                 /* of the temporary file, to write; -1: closed */
    int slot;               /* private part; -1: there is no such file */
} atomic_file;

/* Makes an empty temporary file beside `target`, its name ending in `suffix`.  Each
 * returns 0 or an errno; after an error nothing is left. */
int  atomic_file_open(atomic_file *f, const char *target, const char *suffix);

/* Closes the temporary file and gives it the target's name. */
int  atomic_file_commit(atomic_file *f, const char *target);

void atomic_file_discard(atomic_file *f);       /* does nothing to one that is gone */
const char *atomic_file_name(const atomic_file *f);

/* A file of two parts, in one call, and on the disk when it returns: after a power cut
 * the old file or the new one is there.  False: errno tells why. */
bool atomic_file_write(const char *target, const void *head, size_t head_bytes,
                       const void *body, size_t body_bytes);

/* All of it to a descriptor; 0 or an errno. */
int  atomic_file_put(int fd, const void *data, size_t bytes);
#endif
