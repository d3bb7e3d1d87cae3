/* SPDX-License-Identifier: MIT */
/* Fuzzes films as read by `join`: one or two, separated by a line "%%". A film joined from
 * one part equals the part; in a film of two parts, the second part's frames follow the
 * first part's. */
#include "fuzz.h"
#include "app/cli/commands.h"

/* Joins films. Returns an exit code; the output file exists if the code is 0, and only
 * then. */
static int join(const char *out, const char *first, const char *second)
{
    char *words[] = { "join", (char *)out, (char *)first, (char *)second, NULL };
    unlink(out);
    const int code = join_command(second ? 4 : 3, words);
    REQUIRE(code == EXIT_DONE || code == EXIT_INPUT);
    REQUIRE((access(out, F_OK) == 0) == (code == EXIT_DONE));
    return code;
}

static void require_bytes(const char *out, const uint8_t *first, size_t bytes,
                          const uint8_t *second, size_t more)
{
    size_t size;
    uint8_t *film = fuzz_contents(out, &size);
    REQUIRE(size == bytes + more && memcmp(film, first, bytes) == 0);
    REQUIRE(more == 0 || memcmp(film + bytes, second, more) == 0);
    free(film);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char out[4200];
    size_t bytes, more;
    const uint8_t *first = fuzz_part(&data, &size, &bytes);
    const uint8_t *second = fuzz_part(&data, &size, &more);
    const char *a = fuzz_file(0, first, bytes), *b = fuzz_file(1, second, more);

    snprintf(out, sizeof out, "%s/out.y4m", fuzz_folder());
    if (join(out, a, NULL)) {
        fuzz_refused(a, 0);
        return 0;
    }
    require_bytes(out, first, bytes, NULL, 0);
    if (more == 0)
        return 0;
    if (join(out, a, b)) {
        fuzz_refused(b, 0);
        return 0;
    }
    const size_t head = (size_t)((const uint8_t *)memchr(second, '\n', more) - second) + 1;
    require_bytes(out, first, bytes, second + head, more - head);
    unlink(out);
    return 0;
}
