/* SPDX-License-Identifier: MIT */
/* Water of the chart "normals", shared by kernels and their checks: the waves of
 * three-swells with steepnesses that add up to 0.7, over places of the world spread around
 * the origin. */
#ifndef TP_TESTS_CHARTS_NORMALS_H
#define TP_TESTS_CHARTS_NORMALS_H
#include "tests/charts/kernels.h"

enum { NORMALS_WAVES = 3, NORMALS_TICK = 1234 };

#define NORMALS_GRAVITY TP_FX(9.81)
#define NORMALS_CELL    TP_FX(0.25)     /* m: the shortest wave is 28 cells long */

extern const tp_wave normals_wave[NORMALS_WAVES];

static inline tp_fx normals_x(uint32_t i)
{
    return kernel_spread(i, KERNEL_STEP, TP_FX(200));
}

static inline tp_fx normals_z(uint32_t i)
{
    return kernel_spread(i, KERNEL_CROSS, TP_FX(200));
}
#endif
