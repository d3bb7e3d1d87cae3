/* SPDX-License-Identifier: MIT */
/* Stands in for libFuzzer where no clang builds the target: runs each file of a folder, and
 * for so many milliseconds of processor time files with random changes.  TP_SEED repeats
 * the changes.
 *
 *     replay_TARGET FOLDER MILLISECONDS */
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "tests/lib/random.h"

#define SEEDS 512
#define MOST  (1u << 16)                /* bytes of an input */

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
__attribute__((weak)) size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most,
                                                     unsigned seed);
size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);

typedef struct {
    uint8_t *data;
    size_t   size;
} input;

static uint64_t chance;

/* Changes a byte, a run of bytes, or the length, in one to four places. */
size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most)
{
    for (uint32_t n = 1 + random_below(&chance, 4); n > 0; n--) {
        const size_t at = size ? random_below(&chance, (uint32_t)size) : 0;
        const size_t left = size - at;
        const size_t run = left ? 1 + random_below(&chance, (uint32_t)(left < 16 ? left : 16)) : 0;
        switch (random_below(&chance, 5)) {
        case 0:
            if (size)
                data[at] ^= (uint8_t)(1u << random_below(&chance, 8));
            break;
        case 1:
            if (size)
                data[at] = (uint8_t)random_next(&chance);
            break;
        case 2:                         /* leave out a run */
            memmove(data + at, data + at + run, left - run);
            size -= run;
            break;
        case 3:                         /* repeat a run */
            if (size + run <= most) {
                memmove(data + at + run, data + at, left);
                size += run;
            }
            break;
        default:                        /* copy a run to another place */
            if (run)
                memmove(data + random_below(&chance, (uint32_t)(size - run + 1)), data + at,
                        run);
        }
    }
    return size;
}

static void run_copy(const uint8_t *data, size_t size)
{
    uint8_t *copy = malloc(size ? size : 1);        /* its end is seen by ASan */

    if (!copy)
        abort();
    memcpy(copy, data, size);
    LLVMFuzzerTestOneInput(copy, size);
    free(copy);
}

static void run_changed(const input *from)
{
    static uint8_t block[MOST];

    memcpy(block, from->data, from->size);
    run_copy(block, LLVMFuzzerCustomMutator
                        ? LLVMFuzzerCustomMutator(block, from->size, MOST,
                                                  (unsigned)random_next(&chance))
                        : LLVMFuzzerMutate(block, from->size, MOST));
}

static input read_input(const char *folder, const char *name)
{
    char path[600];
    input in = { malloc(MOST), 0 };

    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "rb");
    if (!in.data || !file)
        abort();
    in.size = fread(in.data, 1, MOST, file);
    fclose(file);
    return in;
}

int main(int argc, char **argv)
{
    static input in[SEEDS];
    unsigned count = 0, changed = 0;

    if (argc != 3)
        return 2;
    DIR *folder = opendir(argv[1]);
    if (!folder)
        return 2;
    chance = random_seed();
    for (struct dirent *e; (e = readdir(folder)) != NULL && count < SEEDS;)
        if (e->d_name[0] != '.' && strcmp(e->d_name, "README.md") != 0)
            in[count++] = read_input(argv[1], e->d_name);
    closedir(folder);
    for (unsigned i = 0; i < count; i++)
        run_copy(in[i].data, in[i].size);
    const clock_t end = clock() + atoi(argv[2]) * (CLOCKS_PER_SEC / 1000);
    for (; count > 0 && clock() < end; changed++)
        run_changed(&in[random_below(&chance, count)]);
    for (unsigned i = 0; i < count; i++)
        free(in[i].data);
    printf("    runs: %u seeds, %u changed inputs\n", count, changed);
    return count > 0 && changed > 0 ? 0 : 1;
}
