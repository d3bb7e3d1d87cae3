/* SPDX-License-Identifier: MIT */
/* Lists of frames' CRCs: "frame 0000 crc32 xxxxxxxx", one line per frame. */
#ifndef TP_APP_FILES_HASHES_H
#define TP_APP_FILES_HASHES_H
#include <stdint.h>
#include <stdio.h>

typedef struct {
    const char *name;                           /* name of the file */
    struct hash { uint32_t frame, crc; unsigned line; } *list;  /* in order of frames */
    size_t count;
} hashes;

void hash_print(FILE *file, uint32_t frame, uint32_t crc);

/* Reads a list.  Blank lines and lines that begin with # are skipped.  Any other line that
 * is no hash is refused with its number, and so is a frame with two different CRCs. */
int  hashes_read(hashes *h, const char *name);
int  hashes_check(const hashes *h, uint32_t frame, uint32_t crc);   /* EXIT_CHECK */
void hashes_free(hashes *h);
#endif
