/* SPDX-License-Identifier: MIT */
/* Fuzzes saved worlds under a correct CRC: an accepted world is drawn, moved by three ticks
 * and drawn again. The first byte selects one of the worlds of tests/lib/snapshots.h; 255:
 * the rest is the whole file. Then follows any number of changes:
 *
 *     WHERE       a byte: 0: the file's head; 1: the world's head; 2..7: a part
 *     OFFSET      two bytes, in words of 4 from the beginning of the target
 *     HOW         a byte: 0..5: a hostile value; else 1 to 8 bytes that follow */
#include "fuzz.h"
#include "features/drops/drops.h"
#include "features/spray/spray.h"
#include "tests/lib/snapshots.h"
#include "world/pools.h"

typedef struct { const uint8_t *data; size_t size; } input;

static uint32_t take_bytes(input *in, int count)
{
    uint32_t value = 0;
    for (; count > 0; count--)
        value = value << 8 | fuzz_byte(&in->data, &in->size);
    return value;
}

/* Offset of the target WHERE in the file; the world's head for a part missing in the
 * scene. */
static size_t begin_of(const kept *k, uint32_t where)
{
    uint32_t parts[KEPT_PARTS];

    kept_places(k, parts);
    return where % 8 == 0 ? 0 : k->head + parts[where % 8 - 1];
}

static void change(const kept *k, uint8_t *file, input *in)
{
    static const int32_t hostile[] = { INT32_MIN, INT32_MAX, -1, 0, 0x40000000, 0xff };
    const size_t bytes = k->head + k->bytes, begin = begin_of(k, take_bytes(in, 1));
    const size_t at = begin + 4 * take_bytes(in, 2) % (bytes - begin);
    const uint32_t how = take_bytes(in, 1);
    if (how < 6 && at + 4 <= bytes)
        memcpy(file + at, &hostile[how], 4);
    for (size_t i = 0; how >= 6 && i < 1 + how % 8 && at + i < bytes; i++)
        file[at + i] = (uint8_t)take_bytes(in, 1);
}

static void begin(kept worlds[KEPT_SCENES])
{
    char path[4096];
    const char *folder = getenv("TMPDIR");
    snprintf(path, sizeof path, "%s/fuzz-keep-%d", folder ? folder : "/tmp", getpid());
    for (int i = 0; i < KEPT_SCENES; i++)
        kept_begin(&worlds[i], i, path);
    unlink(path);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static kept worlds[KEPT_SCENES];
    static bool begun;
    if (!begun)
        begin(worlds);
    begun = true;
    input in = { data, size };
    const uint8_t first = fuzz_byte(&in.data, &in.size);
    kept *k = &worlds[first % KEPT_SCENES];
    if (first == 255) {
        k->keep.name = fuzz_file(0, in.data, in.size);
    } else {
        const size_t bytes = k->head + k->bytes;
        uint8_t *file = (uint8_t *)fuzz_copy(k->file, bytes);
        while (in.size > 0)
            change(k, file, &in);
        kept_sign(k, file);
        k->keep.name = fuzz_file(0, file, bytes);
        free(file);
    }
    if (kept_take(k))
        kept_move(k);
    return 0;
}
