/* SPDX-License-Identifier: MIT */
#include "tests/charts/kernels.h"

const kernel kernels_roots[] = {
    { NULL, NULL, NULL, NULL, 0, 0, 0 },
};
