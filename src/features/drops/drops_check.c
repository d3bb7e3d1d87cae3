/* SPDX-License-Identifier: MIT */
/* Checks drops from outside, such as those of a snapshot. */
#include "features/drops/drops.h"

static bool is_out_of_range(tp_fx x)
{
    return x < -TP_DROPS_SPHERE_FAR || x > TP_DROPS_SPHERE_FAR;
}

/* True if all members agree with `fresh`, except the members changed by steps. */
static bool is_same_config(const tp_drops *drops, const tp_drops *fresh)
{
    return drops->capacity == fresh->capacity
        && drops->ring_capacity == fresh->ring_capacity
        && drops->sphere.y == fresh->sphere.y
        && drops->sphere_radius == fresh->sphere_radius;
}

static bool is_releasing_sphere_valid(const tp_drops *drops)
{
    return !is_out_of_range(drops->sphere.x) && !is_out_of_range(drops->sphere.z)
        && !is_out_of_range(drops->last_sphere.x) && !is_out_of_range(drops->last_sphere.y)
        && !is_out_of_range(drops->last_sphere.z);
}

/* True if a drop can have raised the ring: within the drops' range, and not after
 * `tick`. */
static bool is_ring_valid(const tp_ring *ring, uint64_t tick)
{
    return tp_ring_is_valid(ring) && ring->start >= 0
        && (uint64_t)ring->start <= tick * TP_FX_ONE
        && ring->x >= -TP_DROP_FAR && ring->x <= TP_DROP_FAR
        && ring->z >= -TP_DROP_FAR && ring->z <= TP_DROP_FAR;
}

bool tp_drops_are_valid(const tp_drops *drops, const tp_drops *fresh, uint64_t tick)
{
    bool valid = is_same_config(drops, fresh) && is_releasing_sphere_valid(drops)
              && drops->count <= drops->capacity && drops->rings <= drops->ring_capacity;

    for (uint32_t i = 0; valid && i < drops->count; i++)
        valid = tp_drop_is_valid(&tp_drops_list(drops)[i]);
    for (uint32_t i = 0; valid && i < drops->rings; i++)
        valid = is_ring_valid(&tp_drops_rings(drops)[i], tick);
    return valid;
}
