/* SPDX-License-Identifier: MIT */
/* The numbers of a frame for the fast view into the water. */
#include "features/underwater/underwater.h"
#include "shade/refracted_ray.h"

/* Returns the path, m, after which each channel has less than 1/128 of its light. */
static tp_fx opaque_path(const tp_absorb *absorb)
{
    uint32_t least = absorb->halvings[0];

    for (int k = 1; k < 3; k++)
        least = absorb->halvings[k] < least ? absorb->halvings[k] : least;
    const uint64_t path = ((uint64_t)7 << 32) / (least > 0 ? least : 1);
    return path < TP_UNDERWATER_FAR ? (tp_fx)path : TP_UNDERWATER_FAR;
}

/* Returns the floor that all places have; N.L included. */
static tp_floor_plane common_floor(const tp_underwater *in)
{
    tp_floor_plane floor = in->floor_plane;

    if (in->coastal) {
        floor = tp_underwater_sample_floor(in, (tp_vec3){ 0, 0, 0 });
        floor.nl = tp_underwater_floor_light_cosine(in, floor.rise_x, floor.rise_z);
    }
    return floor;
}

void tp_fast_refraction_begin(const tp_shade *shade, tp_fast_refraction *fast)
{
    const tp_underwater *in = shade->underwater;

    fast->plane = !in->coastal || tp_coastal_floor_is_plane(in->coastal);
    if (fast->plane)
        fast->floor = common_floor(in);
    fast->opaque = opaque_path(&in->absorb);
    fast->lit =
        (uint32_t)tp_lit_share(shade->ambient, tp_clamp(shade->world.ly, 0, 16384));
}
