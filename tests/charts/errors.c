/* SPDX-License-Identifier: MIT */
/* Prints the errors of the kernels' methods as rows of the sweep:
 *
 *     errors CHART */
#include <stdlib.h>
#include <string.h>
#include "tests/charts/errors.h"

static const struct {
    const char *chart;
    judge      *judge;
} judges[] = {
    { "sine", judge_sine }, { "roots", judge_roots }, { "normalise", judge_normalise },
    { "gerstner", judge_gerstner }, { "normals", judge_normals },
    { "dispersion", judge_dispersion }, { "fresnel", judge_fresnel },
};

static int32_t in[KERNEL_UNITS * KERNEL_WIDTH], out[KERNEL_UNITS * KERNEL_WIDTH];

static void judge_kernel(const kernel *k)
{
    for (size_t i = 0; i < sizeof judges / sizeof *judges; i++)
        if (strcmp(judges[i].chart, k->chart) == 0) {
            memset(out, 0, sizeof out);
            k->fill(in);
            k->run(in, out);
            printf("%s,%s,bytes,%u\n", k->chart, k->point, (unsigned)k->bytes);
            judges[i].judge(k, in, out);
        }
}

int main(int argc, char **argv)
{
    unsigned found = 0;

    for (const kernel *const *list = kernel_lists; argc == 2 && *list; list++)
        for (const kernel *k = *list; k->chart; k++)
            if (strcmp(k->chart, argv[1]) == 0) {
                judge_kernel(k);
                found++;
            }
    if (!found)
        fprintf(stderr, "usage: errors CHART\nno kernels of that chart\n");
    return found ? EXIT_SUCCESS : 2;
}
