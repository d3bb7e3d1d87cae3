/* SPDX-License-Identifier: MIT */
/* Lists of frames' CRCs: "frame 0000 crc32 xxxxxxxx", one line a frame. */
#ifndef HOST_HASHES_H
#define HOST_HASHES_H
#include <stdint.h>
#include <stdio.h>

typedef struct {
    const char *name;                           /* of its file */
    struct hash { uint32_t frame, crc; unsigned line; } *list;  /* by rising frames */
    size_t count;
} hashes;

void hash_print(FILE *file, uint32_t frame, uint32_t crc);

/* Lines that are blank or begin with # are skipped, anything else that is no hash is
 * refused with its line; so is a frame that has two CRCs. */
int  hashes_read(hashes *h, const char *name);
int  hashes_check(const hashes *h, uint32_t frame, uint32_t crc);   /* EXIT_CHECK */
void hashes_free(hashes *h);
#endif
