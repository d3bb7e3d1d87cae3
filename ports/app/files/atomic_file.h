/* SPDX-License-Identifier: MIT */
/* Replacing a file as a whole.  The new contents go to a temporary file in the target's
 * folder; the temporary file is then renamed to the target.  Readers find the old file or
 * the new file, never a mixture.  Temporary names are unique: two programs that save the
 * same file both succeed, and the last rename wins.
 *
 * A temporary file never outlives its use.  The file is removed when writing fails, when
 * the program exits, and by every catchable signal that ends the program; the signal then
 * takes its default action.  Signals that already have a handler are not touched. */
#ifndef TP_APP_FILES_ATOMIC_FILE_H
#define TP_APP_FILES_ATOMIC_FILE_H
#include <stdbool.h>
#include <stddef.h>

typedef struct {
    int fd;                 /* descriptor of the temporary file, for writing; -1: closed */
    int slot;               /* private: index in the table; -1: no file */
} atomic_file;

/* Creates an empty temporary file beside `target`; its name ends in `suffix`.  Each
 * function returns 0 or an errno; after an error no temporary file is left. */
int  atomic_file_open(atomic_file *f, const char *target, const char *suffix);

/* Closes the temporary file and renames it to the target. */
int  atomic_file_commit(atomic_file *f, const char *target);

void atomic_file_discard(atomic_file *f);       /* does nothing after commit or discard */
const char *atomic_file_name(const atomic_file *f);

/* Writes a file of two parts in one call and syncs it: after a power cut the disk has the
 * old file or the new file.  False: errno has the reason. */
bool atomic_file_write(const char *target, const void *head, size_t head_bytes,
                       const void *body, size_t body_bytes);

/* Writes all bytes to a descriptor.  Returns 0 or an errno. */
int  atomic_file_put(int fd, const void *data, size_t bytes);
#endif
