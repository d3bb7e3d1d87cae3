/* SPDX-License-Identifier: MIT */
/* Quick light at half the rate: light and mirror of even columns and of the run's first,
 * then glints of every column by its own slope, as those are what an eye follows.  One of
 * two bodies of the same bits. */
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
    BODY(even)(shade, run, TP_ENV_GRADIENT);
}

void tp_stage_quick_dome_even(const tp_shade *shade, tp_run *run)
{
    BODY(even)(shade, run, TP_ENV_DOME);
}

void tp_stage_quick_cube_even(const tp_shade *shade, tp_run *run)
{
    BODY(even)(shade, run, TP_ENV_CUBE);
}

void tp_stage_quick_glint_phong(const tp_shade *shade, tp_run *run)
{
    BODY(glint)(shade, run, TP_LOBE_PHONG);
}

void tp_stage_quick_glint_blinn(const tp_shade *shade, tp_run *run)
{
    BODY(glint)(shade, run, TP_LOBE_BLINN);
}
