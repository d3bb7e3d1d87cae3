/* SPDX-License-Identifier: MIT */
/* Printing, reading and comparing frames' CRCs. */
#include "hashes.h"
#include <errno.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include "say.h"

void hash_print(FILE *file, uint32_t frame, uint32_t crc)
{
    fprintf(file, "frame %04" PRIu32 " crc32 %08" PRIx32 "\n", frame, crc);
}

static bool add(hashes *h, struct hash hash)
{
    if ((h->count & (h->count - 1)) == 0) {     /* at 0, 1, 2, 4, 8 ...: double */
        const size_t room = h->count ? 2 * h->count : 1;
        struct hash *more = realloc(h->list, room * sizeof *more);
        if (!more)
            return false;
        h->list = more;
    }
    h->list[h->count++] = hash;
    return true;
}

static int read_lines(hashes *h, FILE *file)
{
    char line[1024];
    for (unsigned number = 1; fgets(line, sizeof line, file); number++) {
        struct hash hash;
        char rest;
        line[strcspn(line, "\r\n")] = 0;
        if (line[strspn(line, " \t")] == 0 || line[0] == '#')
            continue;
        if (sscanf(line, "frame %9" SCNu32 " crc32 %8" SCNx32 " %c", &hash.frame,
                   &hash.crc, &rest) != 2)
            return fail(EXIT_INPUT, "%s:%u: expected 'frame 0000 crc32 xxxxxxxx', found"
                        " '%.40s'", h->name, number, line);
        if (!add(h, hash))
            return fail_memory(h->count * sizeof hash);
    }
    if (ferror(file))
        return fail(EXIT_INPUT, "%s: %s", h->name, strerror(errno));
    return EXIT_DONE;
}

int hashes_read(hashes *h, const char *name)
{
    *h = (hashes){ .name = name };
    FILE *file = fopen(name, "r");
    if (!file)
        return fail(EXIT_INPUT, "%s: %s (named by --expect)", name, strerror(errno));
    const int code = read_lines(h, file);
    fclose(file);
    return code;
}

/* The list's own order is nearly always that of the frames asked for, so the place of
 * a frame is mostly found at once when the list starts with it. */
static const struct hash *find(const hashes *h, uint32_t frame)
{
    const size_t guess = h->count ? frame - h->list[0].frame : 0;
    if (guess < h->count && h->list[guess].frame == frame)
        return &h->list[guess];
    for (size_t i = 0; i < h->count; i++)
        if (h->list[i].frame == frame)
            return &h->list[i];
    return NULL;
}

int hashes_check(const hashes *h, uint32_t frame, uint32_t crc)
{
    const struct hash *known = find(h, frame);
    if (!known)
        return fail(EXIT_CHECK, "%s: frame %04" PRIu32 " is not in the list; got %08"
                    PRIx32, h->name, frame, crc);
    if (known->crc != crc)
        return fail(EXIT_CHECK, "%s: frame %04" PRIu32 " differs: expected %08" PRIx32
                    ", got %08" PRIx32, h->name, frame, known->crc, crc);
    return EXIT_DONE;
}

void hashes_free(hashes *h)
{
    free(h->list);
    *h = (hashes){ 0 };
}
