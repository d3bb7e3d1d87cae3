/* SPDX-License-Identifier: MIT */
#include "tests/charts/stability.h"
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *chart;
    void      (*map)(void);
} maps[] = {
    { "stability-jacobian", stability_jacobian },
    { "stability-breaking", stability_breaking },
    { "stability-buoyancy", stability_buoyancy },
    { "stability-dispersion", stability_dispersion },
};

int main(int argc, char **argv)
{
    for (size_t i = 0; argc == 2 && i < sizeof maps / sizeof *maps; i++)
        if (strcmp(maps[i].chart, argv[1]) == 0) {
            maps[i].map();
            return EXIT_SUCCESS;
        }
    fprintf(stderr, "usage: stability CHART\n");
    return 2;
}
