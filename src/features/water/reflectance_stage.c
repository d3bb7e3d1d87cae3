/* SPDX-License-Identifier: MIT */
/* Span stages of the reflected sky on water, weighted by Fresnel.  The plain gradient
 * needs only the height of the reflected view and takes one stage.  Other skies may give
 * light above white [F8]. */
#include "shade/env.h"
#include "shade/reflected.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

/* Returns the weight of a reflected ray by its height, 128..256.  A ray downwards meets
 * other water, half as bright as the horizon: the weight fades to a half within 7 degrees
 * below level. */
TP_ALWAYS_INLINE uint32_t horizon_fade(int32_t up)
{
    return (uint32_t)tp_clamp(256 + 4 * (up >> 6), 128, 256);
}

TP_ALWAYS_INLINE uint32_t reflected_share(const tp_shade *shade, int32_t nv, int32_t up)
{
    uint32_t share = shade->fresnel[nv >> 6] * (uint32_t)shade->mirror >> 8;
    return share * horizon_fade(up) >> 8;
}

/* Returns reflected_share in 1/65536: light of many whites multiplies the rounding
 * error. */
TP_ALWAYS_INLINE uint32_t fine_reflected_share(const tp_shade *shade, int32_t nv,
                                               int32_t up)
{
    uint32_t share = shade->fresnel[nv >> 6] * (uint32_t)shade->mirror;
    return share * horizon_fade(up) >> 8;
}

void tp_stage_mirror(const tp_shade *restrict shade, tp_run *restrict run)
{
    const int32_t count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t sky = tp_env_gradient(shade, run->up[i]);
        run->colour[i] = tp_colour_mix(run->colour[i], sky,
                                       reflected_share(shade, run->nv[i], run->up[i]));
    }
}

/* Unpacks the slopes as sampled, so later stages read the slopes of smooth and of rippled
 * water from the same arrays. */
void tp_stage_slopes(const tp_shade *restrict shade, tp_run *restrict run)
{
    const int32_t count = run->count;

    (void)shade;
    for (int32_t i = 0; i < count; i++) {
        run->sx[i] = (int16_t)tp_slope_x(run, i, 0);
        run->sz[i] = (int16_t)tp_slope_z(run, i, 0);
    }
}

void tp_stage_reflect_gradient(const tp_shade *restrict shade, tp_run *restrict run)
{
    const int32_t count = run->count;

    for (int32_t i = 0; i < count; i++) {
        tp_ray to = tp_reflected_compute(run, i);
        run->mirror[i] = tp_env_gradient(shade, to.y);
    }
}

/* Mixes light above white.  The share is multiplied first: light above white times a
 * small share may be below white. */
TP_ALWAYS_INLINE uint32_t bright_mix(uint32_t a, uint32_t light, uint32_t share,
                                     uint32_t gain)
{
    uint32_t part = share * gain >> 8, left = 65536 - share, sum = 0;

    for (int k = 0; k < 24; k += 8) {
        uint32_t c = ((a >> k & 0xff) * left + (light >> k & 0xff) * part) >> 16;
        sum |= (c < 255 ? c : 255) << k;
    }
    return sum;
}

TP_ALWAYS_INLINE void fresnel(const tp_shade *restrict shade, tp_run *restrict run,
                              int hdr)
{
    const int32_t count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t light = run->mirror[i], colour = run->colour[i], bright = 0;
        int32_t  nv = run->nv[i], up = run->up[i];
        if (hdr && (TP_WIDE || light >> 24))
            bright = bright_mix(colour, light, fine_reflected_share(shade, nv, up),
                                tp_light_gain(shade, light));
        uint32_t mixed = tp_colour_mix(colour, light, reflected_share(shade, nv, up));
        run->colour[i] = hdr && light >> 24 ? bright : mixed;
    }
}

#define FRESNEL_STAGE(name, hdr) \
    void tp_stage_##name(const tp_shade *restrict shade, tp_run *restrict run) \
    { fresnel(shade, run, hdr); }
FRESNEL_STAGE(fresnel, 0)
FRESNEL_STAGE(fresnel_hdr, 1)

const tp_stage tp_reflectance_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_reflectance(X)
#undef X
};
