/* SPDX-License-Identifier: MIT */
/* Prints, reads and compares the CRCs of frames. */
#define _POSIX_C_SOURCE 200809L
#include "hashes.h"
#include <errno.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include "log.h"

void hash_print(FILE *file, uint32_t frame, uint32_t crc)
{
    fprintf(file, "frame %04" PRIu32 " crc32 %08" PRIx32 "\n", frame, crc);
}

static bool add(hashes *h, struct hash hash)
{
    if ((h->count & (h->count - 1)) == 0) {     /* at 0, 1, 2, 4, 8 ...: double the room */
        const size_t room = h->count ? 2 * h->count : 1;
        struct hash *more = realloc(h->list, room * sizeof *more);
        if (!more)
            return false;
        h->list = more;
    }
    h->list[h->count++] = hash;
    return true;
}

/* Reads digits as sets of characters: numbers of sscanf may have signs and "0x". */
static bool read_hash(const char *line, struct hash *hash)
{
    char frame[10], crc[9];
    int end = 0;
    if (sscanf(line, "frame%*[ \t]%9[0-9]%*[ \t]crc32%*[ \t]%8[0-9a-fA-F] %n", frame, crc,
               &end) != 2 || line[end])
        return false;
    hash->frame = (uint32_t)strtoul(frame, NULL, 10);
    hash->crc = (uint32_t)strtoul(crc, NULL, 16);
    return true;
}

static int read_line(hashes *h, unsigned number, char *line, size_t bytes)
{
    struct hash hash = { .line = number };
    bytes -= bytes > 0 && line[bytes - 1] == '\n';
    bytes -= bytes > 0 && line[bytes - 1] == '\r';
    line[bytes] = 0;
    if (strlen(line) != bytes)
        return log_fail(EXIT_INPUT, "%s:%u: a zero byte", h->name, number);
    if (line[strspn(line, " \t")] == 0 || line[0] == '#')
        return EXIT_DONE;
    if (!read_hash(line, &hash))
        return log_fail(EXIT_INPUT, "%s:%u: expected 'frame 0000 crc32 xxxxxxxx', found"
                    " '%.40s'", h->name, number, line);
    return add(h, hash) ? EXIT_DONE : log_fail_memory(h->count * sizeof hash);
}

static int read_lines(hashes *h, FILE *file)
{
    char *line = NULL;
    size_t room = 0;
    int code = EXIT_DONE;
    ssize_t bytes;
    for (unsigned number = 1; !code && (bytes = getline(&line, &room, file)) >= 0;
         number++)
        code = read_line(h, number, line, (size_t)bytes);
    if (!code && !feof(file))               /* getline may have run out of memory */
        code = log_fail(EXIT_INPUT, "%s: %s", h->name, strerror(errno));
    free(line);
    return code;
}

/* Compares by frame, then by line in the file. */
static int by_frame(const void *of_a, const void *of_b)
{
    const struct hash *a = of_a, *b = of_b;
    return a->frame != b->frame ? (a->frame > b->frame) - (a->frame < b->frame)
                                : (a->line > b->line) - (a->line < b->line);
}

static int check_twice(const hashes *h)
{
    for (size_t i = 1; i < h->count; i++) {
        const struct hash *a = &h->list[i - 1], *b = &h->list[i];
        if (a->frame == b->frame && a->crc != b->crc)
            return log_fail(EXIT_INPUT, "%s:%u: frame %04" PRIu32 " has another CRC in line"
                        " %u", h->name, b->line, b->frame, a->line);
    }
    return EXIT_DONE;
}

int hashes_read(hashes *h, const char *name)
{
    *h = (hashes){ .name = name };
    FILE *file = fopen(name, "r");
    if (!file)
        return log_fail(EXIT_INPUT, "%s: %s (named by --expect)", name, strerror(errno));
    const int code = read_lines(h, file);
    fclose(file);
    if (h->count)
        qsort(h->list, h->count, sizeof *h->list, by_frame);
    return code ? code : check_twice(h);
}

/* Returns NULL if the frame is not in the list. */
static const struct hash *find(const hashes *h, uint32_t frame)
{
    size_t low = 0, high = h->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (h->list[middle].frame < frame)
            low = middle + 1;
        else
            high = middle;
    }
    return low < h->count && h->list[low].frame == frame ? &h->list[low] : NULL;
}

int hashes_check(const hashes *h, uint32_t frame, uint32_t crc)
{
    const struct hash *known = find(h, frame);
    if (!known)
        return log_fail(EXIT_CHECK, "%s: frame %04" PRIu32 " is not in the list; got %08"
                    PRIx32, h->name, frame, crc);
    if (known->crc != crc)
        return log_fail(EXIT_CHECK, "%s: frame %04" PRIu32 " differs: expected %08" PRIx32
                    ", got %08" PRIx32, h->name, frame, known->crc, crc);
    return EXIT_DONE;
}

void hashes_free(hashes *h)
{
    free(h->list);
    *h = (hashes){ 0 };
}
