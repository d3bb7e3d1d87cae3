/* SPDX-License-Identifier: MIT */
/* The material of static geometry (floor, walls): its colour at a distance, and its colour
 * in the light. */
#ifndef TP_SHADE_WALL_MATERIAL_H
#define TP_SHADE_WALL_MATERIAL_H
#include "shade/normal.h"
#include "shade/sampler.h"

TP_ALWAYS_INLINE tp_mip_level tp_wall_material_level(const tp_wall_material *material,
                                                     tp_fx far, bool ground)
{
    int32_t log_far = tp_log2_q8((uint32_t)far | 1) - 16 * 256;
    return tp_mip_level_select(
        material->texture,
        tp_mip_level_choose(material->lod, log_far, ground, material->texture->levels));
}

/* Colour of the material at (x, z) metres in its plane, seen from `far` metres away.
 * `ground`: true if the plane is level. */
TP_ALWAYS_INLINE uint32_t tp_wall_material_sample(const tp_wall_material *material, tp_fx x,
                                                  tp_fx z, tp_fx far, bool ground)
{
    if (!material->texture)
        return material->colour;
    tp_mip_level level = tp_wall_material_level(material, far, ground);
    uint32_t texel = tp_mip_level_sample_linear(&level, (uint32_t)x * material->per_metre,
                                                (uint32_t)z * material->per_metre);
    return tp_colour_times(texel, material->colour);
}

/* The channel at bit `shift` of tp_wall_material_sample, 0..255. */
TP_ALWAYS_INLINE uint32_t tp_wall_material_channel(const tp_wall_material *material,
                                                   tp_fx x, tp_fx z, tp_fx far,
                                                   bool ground, int shift)
{
    uint32_t colour = material->colour >> shift & 0xff;

    if (!material->texture)
        return colour;
    tp_mip_level level = tp_wall_material_level(material, far, ground);
    tp_four  f = tp_four_gather_centred(&level, (uint32_t)x * material->per_metre,
                                (uint32_t)z * material->per_metre);
    uint32_t above = tp_channel_mix(f.texel[0] >> shift & 0xff,
                                    f.texel[1] >> shift & 0xff, f.fs);
    uint32_t below = tp_channel_mix(f.texel[2] >> shift & 0xff,
                                    f.texel[3] >> shift & 0xff, f.fs);
    return tp_divide_by_255(tp_channel_mix(above, below, f.ft) * colour);
}

/* Returns a matt colour lit by sun and ambient light; `packed` is the surface normal. */
static inline uint32_t tp_wall_material_light(const tp_shade *shade, uint32_t colour,
                                              tp_packed_dir packed)
{
    const tp_view_axes *world = &shade->world;
    int32_t nl = tp_vec_q14_dot(tp_vec_q14_unpack(packed),
                                (tp_vec_q14){ world->lx, world->ly, world->lz });
    return tp_colour_scale(colour, (uint32_t)tp_lit_share(shade->ambient,
                                                          tp_clamp(nl, 0, 16384)));
}
#endif
