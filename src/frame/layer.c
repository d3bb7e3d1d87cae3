/* SPDX-License-Identifier: MIT */
/* Sampling numbers of the water's drifting textures. */
#include "frame/frame.h"

/* Returns the drift in metres after `time`, ticks x 65536; 16.16, wrapping. */
static uint32_t drift_distance(tp_fx metres_per_second, int64_t time)
{
    int64_t step = (int64_t)metres_per_second * ((int64_t)1 << 32) / TP_TICKS_PER_SECOND;
    uint64_t part = (uint64_t)(step >> 16) * (uint32_t)(time & 0xffff);
    return (uint32_t)(((uint64_t)step * (uint64_t)(time >> 16) + part) >> 32);
}

/* Mipmap level at 1 m, Q8: log2 of texels a metre over pixels a metre at 1 m.  For
 * level ground half of log2 of the eye's height is subtracted for the slant (see
 * tp_mip_level_choose). */
int32_t tp_frame_lod(const tp_frame *frame, tp_fx texels_per_metre, bool level_ground)
{
    TP_ASSERT(frame->projection.focal > 0);
    int32_t lod = tp_log2_q8((uint32_t)(texels_per_metre > 0 ? texels_per_metre : 1))
                  - tp_log2_q8((uint32_t)frame->projection.focal);
    tp_fx height = tp_abs(frame->projection.eye.y);

    if (height < TP_FX_ONE)
        height = TP_FX_ONE;
    return level_ground ? lod - (tp_log2_q8((uint32_t)height) - 16 * 256) / 2 : lod;
}

uint32_t tp_frame_repeats_per_metre(tp_fx size)
{
    TP_ASSERT(size > 0);
    return (uint32_t)((((uint64_t)1 << 32) + (uint32_t)size / 2) / (uint32_t)size);
}

/* Texels per metre of the longer side.  4096 texels on 0.1 m exceed 16.16 and saturate. */
static tp_fx texels_a_metre(const tp_texture *texture, tp_fx size)
{
    TP_ASSERT(texture->levels > 0 && texture->levels <= TP_TEXTURE_LEVELS);
    return tp_fx_div(TP_FX_ONE << (texture->levels - 1), size);
}

tp_layer tp_frame_layer(const tp_frame *frame, const tp_texture *texture,
                        const tp_scene_map *map)
{
    const int64_t time = frame->drawn.time;
    tp_layer layer = { .texture = texture };

    if (!texture)
        return layer;
    layer.per_metre = tp_frame_repeats_per_metre(map->size);
    layer.drift_s = 0u - drift_distance(map->drift_x, time) * layer.per_metre;
    layer.drift_t = 0u - drift_distance(map->drift_z, time) * layer.per_metre;
    layer.lod = tp_frame_lod(frame, texels_a_metre(texture, map->size), true);
    return layer;
}
