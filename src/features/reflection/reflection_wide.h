/* SPDX-License-Identifier: MIT */
/*
 * Finds where 16 columns sample the planar map, for vectorizing compilers, with the bits of
 * reflection_stage.c's loop: a part of that file.  One loop finds the places of all columns;
 * the few that meet the map are sampled one after another.  Vector units have products of 64
 * bits, but neither clamps nor signed shifts of them: products are cut to words, which hold
 * the results.
 */
#ifndef TP_FEATURES_REFLECTION_REFLECTION_WIDE_H
#define TP_FEATURES_REFLECTION_REFLECTION_WIDE_H

/* u, v: position in the map; meets: not 0 if the place can lie in the map. */
typedef struct {
    int32_t u[16], v[16], meets[16];
} map_places;

/* As tp_mirror_depth_ratio, from the reciprocal of the water's inverse depth. */
TP_ALWAYS_INLINE int32_t wide_depth_ratio(uint32_t object_zi, uint32_t recip, int32_t shift)
{
    const int64_t ratio = (int64_t)((uint64_t)object_zi * recip >> (uint64_t)(46 - shift));
    return (int32_t)(ratio < 131071 ? ratio : 131071);
}

/* As pixel_displacement; the displacement by slopes in two parts of the factors. */
TP_ALWAYS_INLINE int32_t wide_displacement(int32_t by_x, int32_t sx, int32_t by_z,
                                           int32_t sz, int32_t share, int32_t by_h,
                                           int32_t h)
{
    const int32_t slope = (by_x >> 12) * sx + (by_z >> 12) * sz
                        + (((by_x & 4095) * sx + (by_z & 4095) * sz) >> 12);
    const int64_t sum = (int64_t)slope * share + (int64_t)by_h * h;
    return tp_clamp((int32_t)((uint64_t)sum >> 16), -(1 << 15), 1 << 15);
}

/* Fills the places of `count` columns from x on, in the block of factors a.  height: the
 * map's, below 2^32. */
TP_ALWAYS_INLINE void find_map_places(const tp_mirror *look, uint32_t height, int32_t y,
                                      tp_mirror_push a, tp_mirror_push step, int32_t x,
                                      int32_t count,
                                      const uint32_t *restrict key,
                                      const int16_t *restrict sxs,
                                      const int16_t *restrict szs,
                                      map_places *restrict to)
{
    const tp_planar_map map = look->map;
    const tp_mirrored_zi *restrict column = look->zi;
    const int32_t last = map.x1 - map.x0 - 1, bend = look->bend;

    for (int32_t i = 0; i < count; i++) {
        const int32_t k = (x & 15) + i, sx = sxs[i], sz = szs[i];
        const int32_t at = tp_clamp(((x + i) >> map.halvings) - map.x0, 0, last);
        const uint32_t near = column[at].near, far = column[at].far;
        const uint32_t water = tp_key_zi(key[i]);
        const int32_t  shift = tp_clz_in_steps(water);
        const uint32_t recip = (uint32_t)tp_recip_rough(water << shift);
        const int32_t  first = wide_depth_ratio(near, recip, shift);
        const int32_t  second = wide_depth_ratio(far, recip, shift);
        const bool     behind = first > TP_MIRROR_BESIDE;
        const uint32_t zi = behind ? far : near;
        const int32_t  ratio = behind ? second : first;
        const int32_t  share = tp_clamp(65536 - ratio, 0, 65536) * bend >> 8;
        const int64_t  eye = (int64_t)((uint64_t)zi * height >> 27);
        const int32_t  dy = interpolate_in_block(a.dy, step.dy, k);
        const int32_t  fall = (int32_t)((uint64_t)((int64_t)dy * ratio) >> 16);
        const int32_t  high = (int32_t)(eye < 1 << 30 ? eye : 1 << 30) + fall;
        const int32_t  h = tp_clamp(high, -(1 << 20), 1 << 20);
        const int32_t  du = wide_displacement(
            interpolate_in_block(a.xu, step.xu, k), sx,
            interpolate_in_block(a.zu, step.zu, k), sz, share,
            interpolate_in_block(a.hu, step.hu, k), h);
        const int32_t  dv = wide_displacement(
            interpolate_in_block(a.xv, step.xv, k), sx,
            interpolate_in_block(a.zv, step.zv, k), sz, share,
            interpolate_in_block(a.hv, step.hv, k), h);
        const int32_t  u = tp_planar_map_position(&map, 16 * (x + i) + 8 + du);
        const int32_t  v = tp_planar_map_position(&map, 16 * y + 8 + dv);
        const int32_t  i0 = (u - 16) >> 5, j0 = (v - 16) >> 5;
        to->u[i] = u;
        to->v[i] = v;
        to->meets[i] = (ratio <= (behind ? 65536 : TP_MIRROR_BESIDE)) & (i0 >= map.x0 - 1)
                     & (i0 < map.x1) & (j0 >= map.y0 - 1) & (j0 < map.y1);
    }
}

static void mirror_columns_wide(const tp_mirror *look, tp_run *run,
                                const tp_mirror_push *a,
                                const tp_mirror_push *step, int32_t i, int32_t count)
{
    map_places places;
    int32_t any = 0;

    find_map_places(look, (uint32_t)look->height, run->y, *a, *step, run->x + i, count,
                    run->key + i, run->sx + i, run->sz + i, &places);
    for (int32_t k = 0; k < count; k++)
        any |= places.meets[k];
    for (int32_t k = 0; any && k < count; k++) {
        if (!places.meets[k])
            continue;
        uint32_t top = tp_planar_map_sample(&look->map, places.u[k], places.v[k]);
        if (top)
            run->mirror[i + k] = tp_colour_composite(run->mirror[i + k], top);
    }
}
#endif
