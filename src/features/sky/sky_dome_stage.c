/* SPDX-License-Identifier: MIT */
/* Stages of the dome: look-up along the view ray where the sky is visible, and along the
 * reflected ray on water. */
#include "features/sky/sky_stage.h"
#include "shade/reflected.h"
#include "tidepool/modules.h"

TP_ALWAYS_INLINE void shade_sky(const tp_shade *shade, tp_run *run, int hdr)
{
    TP_ASSERT(shade->env.dome != NULL);
    const int32_t count = run->count;

    tp_view_run(shade, &shade->world, run);
    for (int32_t i = 0; i < count; i++) {
        uint32_t light = tp_env_dome(shade, 0, -run->vx[i], -run->vy[i], -run->vz[i]);
        run->colour[i] = tp_sky_colour(shade, light, hdr);
    }
}

void tp_stage_sky_dome(const tp_shade *shade, tp_run *run)
{
    shade_sky(shade, run, 0);
}

void tp_stage_sky_dome_hdr(const tp_shade *shade, tp_run *run)
{
    shade_sky(shade, run, 1);
}

TP_ALWAYS_INLINE void dome_wide(const tp_dome *restrict dome,
                                const uint32_t *restrict square,
                                const int16_t *restrict up,
                                const uint32_t *restrict glow, int32_t count,
                                uint32_t *restrict out)
{
    for (int32_t i = 0; i < count; i++)
        out[i] = tp_dome_colour(dome, square[i], up[i] > 0 ? up[i] : 0, glow[i]);
}

/* Shades the reflection in three loops.  The glow needs a logarithm, which is not
 * vectorized, so its loop is separate. */
TP_ALWAYS_INLINE void reflect_wide(const tp_shade *restrict shade, tp_run *restrict run)
{
    const tp_dome *dome = shade->env.dome;
    const int32_t count = run->count;
    uint32_t square[TP_RUN], glow[TP_RUN];

    for (int32_t i = 0; i < count; i++) {
        tp_ray to = tp_reflected_compute(run, i);
        square[i] = tp_light_chord_square(shade, to.x, to.y, to.z);
    }
    for (int32_t i = 0; i < count; i++)
        glow[i] = tp_dome_lookup_glow(dome, shade->env.least, square[i]);
    dome_wide(dome, square, run->up, glow, count, run->mirror);
}

void tp_stage_reflect_dome(const tp_shade *restrict shade, tp_run *restrict run)
{
    TP_ASSERT(shade->env.dome != NULL);
    const int32_t count = run->count;

    if (TP_WIDE) {
        reflect_wide(shade, run);
        return;
    }
    for (int32_t i = 0; i < count; i++) {
        tp_ray to = tp_reflected_compute(run, i);
        run->mirror[i] = tp_env_dome(shade, shade->env.least, to.x, to.y, to.z);
    }
}

const tp_stage tp_sky_dome_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_sky_dome(X)
#undef X
};
