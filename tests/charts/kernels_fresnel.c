/* SPDX-License-Identifier: MIT */
#include "tests/charts/kernels.h"

const kernel kernels_fresnel[] = {
    { NULL, NULL, NULL, NULL, 0, 0, 0 },
};
