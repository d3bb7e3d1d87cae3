/* SPDX-License-Identifier: MIT */
/* Fuzzes lists of frames' CRCs as read by --expect. Each line of an accepted list is a
 * hash, a comment or blank, and its printed form reads back the same. */
#include "fuzz.h"
#include "app/files/hashes.h"

#define BLANKS     " \t\r\v\f"
#define HASH_BYTES "framec0123456789abcdefABCDEF" BLANKS    /* no sign, no "0x" */

/* True if the line is four words of hash bytes up to the line's end. */
static bool is_hash(const char *line)
{
    unsigned words = 0;
    if (line[strspn(line, HASH_BYTES)] != '\n' && line[strspn(line, HASH_BYTES)])
        return false;
    for (line += strspn(line, BLANKS); *line && *line != '\n';
         line += strspn(line, BLANKS)) {
        line += strcspn(line, BLANKS "\n");
        words++;
    }
    return words == 4;
}

static size_t count_lines(const char *text)
{
    size_t count = 0;
    for (const char *line = text; *line; line += *line == '\n') {
        const bool blank = strspn(line, " \t") >= strcspn(line, "\r\n");
        REQUIRE(blank || *line == '#' || is_hash(line));
        count += !blank && *line != '#';
        line += strcspn(line, "\n");
    }
    return count;
}

static void write_all(const hashes *h, FILE *to)
{
    for (size_t i = 0; i < h->count; i++)
        hash_print(to, h->list[i].frame, h->list[i].crc);
    fclose(to);
}

static void read_back(const hashes *h)
{
    char *text;
    size_t bytes;
    hashes again;
    write_all(h, open_memstream(&text, &bytes));
    REQUIRE(hashes_read(&again, fuzz_file(1, text, bytes)) == EXIT_DONE);
    REQUIRE(again.count == h->count);
    for (size_t i = 0; i < h->count; i++)
        REQUIRE(again.list[i].frame == h->list[i].frame
                && again.list[i].crc == h->list[i].crc);
    hashes_free(&again);
    free(text);
}

/* Each frame has one CRC in the whole list. */
static void look_up(const hashes *h)
{
    for (size_t i = 0; i < h->count; i++) {
        REQUIRE(hashes_check(h, h->list[i].frame, h->list[i].crc) == EXIT_DONE);
        REQUIRE(hashes_check(h, h->list[i].frame, ~h->list[i].crc) == EXIT_CHECK);
    }
    REQUIRE(hashes_check(h, UINT32_MAX, 0) == EXIT_CHECK);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    hashes h;
    const char *path = fuzz_file(0, data, size);
    if (hashes_read(&h, path)) {
        fuzz_refused(path, fuzz_lines(data, size));
        hashes_free(&h);
        return 0;
    }
    char *text = fuzz_text(data, size);
    REQUIRE(size == 0 || !memchr(data, 0, size));
    REQUIRE(count_lines(text) == h.count);
    read_back(&h);
    look_up(&h);
    hashes_free(&h);
    free(text);
    return 0;
}
