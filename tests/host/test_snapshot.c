/* SPDX-License-Identifier: MIT */
/* Hand-made kept worlds with a correct CRC: each is refused, or can be stepped and
 * drawn.  The sanitizers check the latter; this test runs under them. */
#define _POSIX_C_SOURCE 200809L
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <fcntl.h>
#include <unistd.h>
#include "features/drops/drops.h"
#include "features/foam/foam.h"
#include "features/spray/spray.h"
#include "tests/lib/snapshots.h"
#include "world/pools.h"

static char path[] = "/tmp/tidepool-keep-XXXXXX";
static kept worlds[KEPT_SCENES];
static int nothing, messages;       /* descriptors: /dev/null, and the original stderr */

/* -- changed files ----------------------------------------------------------------- */

/* Writes the correct CRC, then tries the file.  Its messages are hidden, later ones of
 * sanitizers are shown. */
static bool goes_on(const kept *k, uint8_t *file)
{
    const size_t bytes = k->head + k->bytes;
    FILE *to = fopen(path, "wb");
    kept_sign(k, file);
    assert_non_null(to);
    assert_int_equal(fwrite(file, 1, bytes, to), bytes);
    assert_int_equal(fclose(to), 0);
    fflush(stderr);
    dup2(nothing, STDERR_FILENO);
    const bool taken = kept_take(k);
    dup2(messages, STDERR_FILENO);
    if (taken)
        kept_move(k);
    return taken;
}

/* Replaces bytes of the world at `at`.  True if the file is accepted. */
static bool goes_on_with(kept *k, size_t at, const void *value, size_t size)
{
    uint8_t before[8];
    uint8_t *const to = k->file + k->head + at;
    memcpy(before, to, size);
    memcpy(to, value, size);
    const bool taken = goes_on(k, k->file);
    memcpy(to, before, size);
    return taken;
}

static void assert_refused(kept *k, size_t at, const void *value, size_t size,
                           const char *what)
{
    if (memcmp(k->file + k->head + at, value, size) != 0
        && goes_on_with(k, at, value, size))
        fail_msg("%s at %zu is taken", what, at);
}

/* -- parts of the world ------------------------------------------------------------- */

static void unchanged_worlds_go_on(void **state)
{
    (void)state;
    for (int i = 0; i < KEPT_SCENES; i++)
        assert_true(goes_on_with(&worlds[i], 0, worlds[i].file + worlds[i].head, 8));
}

static void places_of_parts_are_the_scenes(void **state)
{
    (void)state;
    const size_t first = offsetof(tp_world, layout);
    for (int i = 0; i < KEPT_SCENES; i++) {
        for (size_t at = first; at < first + sizeof(tp_world_layout); at += 4) {
            uint32_t was;
            memcpy(&was, worlds[i].file + worlds[i].head + at, 4);
            const uint32_t hostile[] = { 0, was - 8, was + 8, INT32_MAX, 1u << 31,
                                         UINT32_MAX };
            for (int n = 0; n < 6; n++)
                assert_refused(&worlds[i], at, &hostile[n], 4, "a place");
        }
    }
}

static void truth_values_are_the_scenes(void **state)
{
    (void)state;
    const size_t at[] = { offsetof(tp_world, deep.clamped), offsetof(tp_world, deep.capped),
                          offsetof(tp_world, deep.sharpened),
                          offsetof(tp_world, deep.crossed) };
    for (int i = 0; i < 4; i++)
        for (int value = 2; value < 256; value += i ? 23 : 1)
            assert_refused(&worlds[0], at[i], &(uint8_t){ (uint8_t)value }, 1, "a bool");
}

/* Returns a part's offset in the world; 0: the world has no such part. */
static void counts_are_within_their_room(void **state)
{
    (void)state;
    kept *k = &worlds[0];
    const tp_world_layout *parts = &k->fresh->layout;
    const size_t foam = kept_place(k, tp_world_foam(k->fresh));
    const size_t drops = kept_place(k, tp_world_drops(k->fresh));
    const size_t spray = kept_place(k, tp_world_spray(k->fresh));
    const size_t pool = kept_place(k, tp_world_pool(k->fresh));
    const size_t field = kept_place(k, tp_world_field(k->fresh));
    const size_t at[] = {
        drops + offsetof(tp_drops, count), drops + offsetof(tp_drops, rings),
        drops + offsetof(tp_drops, capacity), drops + offsetof(tp_drops, ring_capacity),
        spray + offsetof(tp_spray, count), spray + offsetof(tp_spray, capacity),
        foam + offsetof(tp_foam, cells), foam + offsetof(tp_foam, scratch),
        parts->modules, parts->modules + 4,     /* id and length of the first chunk */
        pool + offsetof(tp_pool, cols), pool + offsetof(tp_pool, cells),
        field + offsetof(tp_pool, walls), field + offsetof(tp_pool, sponge),
        offsetof(tp_world, deep.count),
        offsetof(tp_world, aboard),
    };
    for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
        const int32_t hostile[] = { 1024, INT32_MAX, INT32_MIN, -1 };
        for (int n = 0; n < 4; n++)
            assert_refused(k, at[i], &hostile[n], 4, "a count");
    }
}

/* -- random changes ----------------------------------------------------------------- */

/* Hostile words from the start of each part, and of the world itself. */
static void any_word_is_refused_or_safe(void **state)
{
    (void)state;
    static const int32_t hostile[] = { INT32_MIN, INT32_MAX, -1, 0x40000000 };
    const int some = random_rounds(1, 2);       /* every other under the sanitizers */
    int taken = 0, tried = 0;
    for (int i = 0; i < KEPT_SCENES; i++) {
        kept *k = &worlds[i];
        uint32_t parts[KEPT_PARTS];
        kept_places(k, parts);
        for (int part = 0; part < 7; part++) {
            const size_t begin = parts[part];
            const size_t end = part == 0 ? offsetof(tp_world, deep) : begin + 160;
            if (part > 0 && begin == 0)
                continue;
            for (size_t at = begin; at < end && at + 4 <= k->bytes; at += 4, tried += 4)
                for (int n = (int)(at / 4) % some; n < 4; n += some)
                    taken += goes_on_with(k, at, &hostile[n], 4);
        }
    }
    print_message("%d of %d are safe, the others refused\n", taken, tried);
    assert_true(taken > 0 && taken < tried / 2);
}

/* Extreme and random bytes in the data behind a part's head. */
static void any_payload_is_refused_or_safe(void **state)
{
    (void)state;
    uint64_t chance = random_seed();
    for (int i = 0; i < KEPT_SCENES; i++) {
        kept *k = &worlds[i];
        uint8_t *file = malloc(k->head + k->bytes);
        for (int n = 0; n < random_rounds(120, 50); n++) {
            const size_t length = (size_t)chance_int(&chance, 1, n % 2 ? 8 : 4000);
            const size_t at = (size_t)chance_int(&chance, 0, (int32_t)k->bytes - 1);
            memcpy(file, k->file, k->head + k->bytes);
            for (size_t b = at; b < at + length && b < k->bytes; b++)
                file[k->head + b] = (uint8_t)(n % 3 == 0 ? 0x80 : n % 3 == 1 ? 0x7f
                                              : (int)random_next(&chance));
            goes_on(k, file);
        }
        free(file);
    }
}

/* -- set-up ------------------------------------------------------------------------ */

static int begin(void **state)
{
    (void)state;
    const int fd = mkstemp(path);
    nothing = open("/dev/null", O_WRONLY);
    messages = dup(STDERR_FILENO);
    if (fd < 0 || nothing < 0 || messages < 0)
        return -1;
    close(fd);
    for (int i = 0; i < KEPT_SCENES; i++)
        kept_begin(&worlds[i], i, path);
    return 0;
}

static int end(void **state)
{
    (void)state;
    for (int i = 0; i < KEPT_SCENES; i++)
        kept_end(&worlds[i]);
    return unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unchanged_worlds_go_on),
        cmocka_unit_test(places_of_parts_are_the_scenes),
        cmocka_unit_test(truth_values_are_the_scenes),
        cmocka_unit_test(counts_are_within_their_room),
        cmocka_unit_test(any_word_is_refused_or_safe),
        cmocka_unit_test(any_payload_is_refused_or_safe),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
