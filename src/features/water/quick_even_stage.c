/* SPDX-License-Identifier: MIT */
/* Fast light at half rate.  Light and reflection are computed for even columns and the
 * run's first column.  Glints are computed for every column by its own slope, because
 * glints are what an eye follows.  The file selects one of two implementations with
 * identical results. */
#include "features/water/quick_light.h"
#if TP_DSP
#include "features/water/quick_even_m4.h"
#define BODY(name) packed_##name
#else
#include "features/water/quick_even_plain.h"
#define BODY(name) plain_##name
#endif

void tp_stage_quick_gradient_even(const tp_shade *shade, tp_run *run)
{
    BODY(light_even)(shade, run, TP_ENV_GRADIENT);
}

void tp_stage_quick_dome_even(const tp_shade *shade, tp_run *run)
{
    BODY(light_even)(shade, run, TP_ENV_DOME);
}

void tp_stage_quick_cube_even(const tp_shade *shade, tp_run *run)
{
    BODY(light_even)(shade, run, TP_ENV_CUBE);
}

void tp_stage_quick_glint_phong(const tp_shade *shade, tp_run *run)
{
    BODY(glint)(shade, run, TP_LOBE_PHONG);
}

void tp_stage_quick_glint_blinn(const tp_shade *shade, tp_run *run)
{
    BODY(glint)(shade, run, TP_LOBE_BLINN);
}
