/* SPDX-License-Identifier: MIT */
/* Air between the eye and surfaces: colours fade to the horizon's colour.
 *
 * The share is z^2 / (z^2 + h^2): 1/2 at the distance h and 0 near the eye.  The rule is
 * the project's own.  It is smooth in 1/z, the depth of the G-buffer, so a short table is
 * enough.
 *
 * The horizon of a dome or a cube varies with direction.  The stage looks the horizon up
 * at every 16th column and interpolates linearly. */
#include "features/sky/sky.h"
#include "shade/env.h"

const tp_entry8 tp_haze_table[TP_HAZE + 1] = {
#include "features/sky/haze_table.inc"
};

TP_ALWAYS_INLINE uint32_t haze_share(uint32_t scale, uint32_t key)
{
    uint32_t entry = (uint32_t)((uint64_t)(key >> 1) * scale >> 32);
    return tp_haze_table[entry < TP_HAZE ? entry : TP_HAZE];
}

void tp_stage_haze(const tp_shade *restrict shade, tp_run *restrict run)
{
    const tp_haze *mine = run->mine;
    const uint32_t horizon = shade->sky[0], scale = mine->scale;
    const int32_t  count = run->count;

    for (int32_t i = 0; i < count; i++) {
        uint32_t share = haze_share(scale, run->key[i]);
        if (TP_WIDE || share > 0)
            run->colour[i] = tp_colour_mix(run->colour[i], horizon, share);
    }
}

/* Returns the horizon's colour in column x.  A cube is read at the mipmap level of the
 * sky view. */
TP_ALWAYS_INLINE uint32_t sample_horizon(const tp_shade *shade, tp_env_kind kind, int32_t x,
                                         int32_t y)
{
    tp_ray  ray = tp_vector_to_eye(shade, &shade->world, x, y);
    tp_dir3 d = tp_normalise(-ray.x, 0, -ray.z);
    int     level = tp_env_mip_level(shade, kind, 0);
    uint32_t light =
        tp_env_sample_kind(shade, kind, level, d.x >> 16, d.y >> 16, d.z >> 16);

    return tp_light_colour_clamped(shade, light);
}

/* Fades columns [k, k + count) of the 16 columns between the horizon's colours a and b. */
TP_ALWAYS_INLINE void haze_columns(uint32_t a, uint32_t b, uint32_t scale, int32_t k,
                                   int32_t count, const uint32_t *restrict key,
                                   uint32_t *restrict colour)
{
    for (int32_t i = 0; i < count; i++) {
        uint32_t horizon = tp_colour_mix(a, b, (uint32_t)(k + i) * 16);
        colour[i] = tp_colour_mix(colour[i], horizon, haze_share(scale, key[i]));
    }
}

/* Returns the first sample of [i, stop) that has haze, or `stop`. */
TP_ALWAYS_INLINE int32_t find_hazy(const tp_run *run, uint32_t scale, int32_t i,
                                   int32_t stop)
{
    while (i < stop && haze_share(scale, run->key[i]) == 0)
        i++;
    return i;
}

/* Samples without haze keep their colours: blocks without haze need no horizon. */
TP_ALWAYS_INLINE void haze_run(const tp_shade *restrict shade, tp_run *restrict run,
                               tp_env_kind kind)
{
    const tp_haze *mine = run->mine;
    const uint32_t scale = mine->scale;
    int32_t  known = -1;        /* column of the horizon's colour b */
    uint32_t b = 0;

    for (int32_t i = 0; i < run->count; ) {
        int32_t stop = tp_block_end(run, i), first = find_hazy(run, scale, i, stop);
        if (first < stop) {
            int32_t  x = (run->x + first) & ~15;
            uint32_t a = x == known ? b : sample_horizon(shade, kind, x, run->y);
            known = x + 16;
            b = sample_horizon(shade, kind, known, run->y);
            haze_columns(a, b, scale, run->x + first - x, stop - first,
                         run->key + first, run->colour + first);
        }
        i = stop;
    }
}

void tp_stage_haze_dome(const tp_shade *restrict shade, tp_run *restrict run)
{
    haze_run(shade, run, TP_ENV_DOME);
}

void tp_stage_haze_cube(const tp_shade *restrict shade, tp_run *restrict run)
{
    haze_run(shade, run, TP_ENV_CUBE);
}

const tp_stage tp_haze_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_haze(X)
#undef X
};
