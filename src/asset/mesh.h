/* SPDX-License-Identifier: MIT */
/* Access to a mesh for higher ranks, beyond its open struct: its unit, and unit vectors
 * packed in one word.
 *
 * 511 stands for 1.0: a component is off by at most 1/1022, or 0.06 degrees, less than a
 * step of an 8-bit normal map. */
#ifndef TP_ASSET_MESH_H
#define TP_ASSET_MESH_H
#include "tidepool/assets.h"

#define TP_DIR_ONE 511

/* Returns the metres of 1.0 in the mesh's positions.  A unit of the file is `scale` metres,
 * 0 to 100: below 2^15 in 16.16. */
static inline tp_fx tp_mesh_metres_per_unit(const tp_mesh *mesh, tp_fx scale)
{
    return (tp_fx)((uint32_t)scale << mesh->log2_unit);
}

static inline uint32_t tp_dir_pack_component(tp_q30 x)
{
    return (uint32_t)(((int64_t)x * TP_DIR_ONE + (1 << 29)) >> 30) & 1023;
}

/* Packs a direction; |component| <= 1. */
static inline tp_packed_dir tp_dir_pack(tp_dir3 d)
{
    return tp_dir_pack_component(d.x) | tp_dir_pack_component(d.y) << 10
           | tp_dir_pack_component(d.z) << 20;
}

/* Returns bits 0..9 as a signed number. */
static inline int32_t tp_dir_unpack_component(uint32_t part)
{
    return (int32_t)((part & 1023) ^ 512) - 512;
}

/* Components of a packed direction, -511..511. */
static inline int32_t tp_dir_x(tp_packed_dir n) { return tp_dir_unpack_component(n); }
static inline int32_t tp_dir_y(tp_packed_dir n) { return tp_dir_unpack_component(n >> 10); }
static inline int32_t tp_dir_z(tp_packed_dir n) { return tp_dir_unpack_component(n >> 20); }

#endif
