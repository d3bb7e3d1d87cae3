/* SPDX-License-Identifier: MIT */
/* List of all kernels, by chart. */
#include "tests/charts/kernels.h"

const kernel *const kernel_lists[] = {
    kernels_sine, kernels_roots, kernels_normalise, kernels_gerstner, kernels_normals,
    kernels_dispersion, kernels_fresnel, NULL,
};
