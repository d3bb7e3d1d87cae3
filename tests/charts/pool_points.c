/* SPDX-License-Identifier: MIT */
/* Writes the list of pool_points.h as C:
 *
 *     pool_points >FILE
 *
 * The grid, then the pools of shipped scenes outside the grid. Boards cannot read scenes,
 * so the list is compiled in. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/path.h"
#include "app/scene/scene_file.h"
#include "tests/charts/pool_points.h"

#define FOLDER "assets/scenes"

enum { POINTS = 512, KEYS_BYTES = 48 };

static const uint32_t sizes[] = { 32, 64, 128, 256 };
static const tp_fx    rates[] = { TP_FX(0.1), TP_FX(0.25), TP_FX(0.35), TP_FX(0.484) };
static char     known[POINTS][KEYS_BYTES];
static unsigned n_known;

/* Prints each point once, with the engine's settings for the point. */
static void print_point(int32_t cells, uint32_t cols, uint32_t rows, uint32_t m,
                        tp_fx courant)
{
    char side[24], keys[KEYS_BYTES];

    snprintf(side, sizeof side, cols == rows ? "%u" : "%ux%u", (unsigned)cols,
             (unsigned)rows);
    snprintf(keys, sizeof keys, "%d;%s;%u;%.4g", 8 << cells, side, (unsigned)m,
             courant / 65536.0);
    for (unsigned i = 0; i < n_known; i++)
        if (strcmp(known[i], keys) == 0)
            return;
    if (n_known == POINTS) {
        fprintf(stderr, "pool_points: a longer list than there is room for\n");
        exit(EXIT_FAILURE);
    }
    strcpy(known[n_known++], keys);
    printf("    { (tp_cells)%d, %u, %u, %u, %d, \"%s\" },\n", cells, (unsigned)cols,
           (unsigned)rows, (unsigned)m, (int)courant, keys);
}

static void print_grid(void)
{
    for (int cells = TP_CELLS_8; cells <= TP_CELLS_32; cells++)
        for (size_t size = 0; size < sizeof sizes / sizeof *sizes; size++)
            for (uint32_t m = 4; m <= 10; m += 2)
                for (size_t rate = 0; rate < sizeof rates / sizeof *rates; rate++)
                    print_point(cells, sizes[size], sizes[size], m, rates[rate]);
}

static void print_pool(const tp_scene_pool *pool)
{
    if (pool->cols > 0)
        print_point(pool->cell_bits, (uint32_t)pool->cols, (uint32_t)pool->rows,
                    (uint32_t)pool->damping, pool->courant);
}

static bool print_scene(const char *name)
{
    char *const path = path_join(FOLDER, name, ".ini");
    scene_file file;
    const bool good = path && !scene_file_open(&file, path);

    if (good) {
        print_pool(&file.scene.pool);
        print_pool(&file.scene.field);
        scene_file_close(&file);
    }
    free(path);
    return good;
}

int main(void)
{
    size_t count;
    char **names = path_scene_names(FOLDER, &count);
    bool good = count > 0;

    printf("#include \"tests/charts/pool_points.h\"\n"
           "const pool_point pool_points[] = {\n");
    print_grid();
    for (size_t i = 0; i < count; i++)
        good &= print_scene(names[i]);
    printf("    { 0 }\n};\n");
    path_free_names(names, count);
    if (!good)
        fprintf(stderr, "pool_points: %s: a scene cannot be read\n", FOLDER);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
