/* SPDX-License-Identifier: MIT */
/* Cover beyond the window: of open water, by the slope of the drawn water; by the depth. */
#ifndef TP_FEATURES_FOAM_FOAM_COVER_H
#define TP_FEATURES_FOAM_FOAM_COVER_H
#include "features/foam/foam.h"
#include "shade/slope.h"

#define TP_FOAM_FAR_MOST 216    /* of 255: largest cover beyond the window */
#define TP_FOAM_STEEP    1700   /* largest square of the slope, 6.6 means, Q8 */

/* Returns the square of a slope, Q24, over the mean square of the waves, Q8. */
TP_ALWAYS_INLINE uint32_t tp_foam_relative_square(const tp_shade_foam *f, uint32_t square)
{
    const uint64_t q = (uint64_t)square * f->per_square >> 24;
    return q < TP_FOAM_STEEP ? (uint32_t)q : TP_FOAM_STEEP;
}

/* Returns the cover 0..255: old foam but on the waves' fronts, and fresh foam by q b, where
 * q is the square of the slope over its mean and b the part that rises on the waves' way:
 * foam lies on the waves' backs.  Waves that the grid leaves out add a random slope of
 * variance v, on backs and fronts: q b + 2 q v + v^2.  The mean of the sum over the sea is
 * 0.75 for one wave and 1 for many, however many of them the grid leaves out.  The product
 * is below 45200 x 89760 < 2^32. */
TP_ALWAYS_INLINE uint32_t tp_foam_open_cover(const tp_shade_foam *f, uint32_t far_fresh,
                                             uint32_t far_old, const tp_run *run,
                                             int32_t i, uint32_t v)
{
    const int32_t x = tp_slope_x(run, i, 0), z = tp_slope_z(run, i, 0);
    const int32_t rise = x * f->way_x + z * f->way_z;
    const int32_t up = TP_WIDE && rise < 0 ? 0 : rise / 16384;

    if (!TP_WIDE && rise < 0 && v == 0)     /* as the sum below */
        return 0;
    const uint32_t q = tp_foam_relative_square(f, tp_slope_square(x, z));
    const uint32_t b =
        TP_WIDE || up > 0 ? tp_foam_relative_square(f, (uint32_t)(up * up)) : 0;
    const uint32_t fresh = ((b * q + v * (2 * q + v)) >> 8) * far_fresh >> 16;
    const uint32_t cover = rise < 0 ? fresh : fresh + far_old;

    return cover < TP_FOAM_FAR_MOST ? cover : TP_FOAM_FAR_MOST;
}

/* foam_drawing.c. Sets a straight beach, see tp_water_foam_coast. */
void tp_foam_set_shore(tp_shade_foam *f, const tp_scene *scene);

/* The cover of TP_FOAM_BEACH. */
tp_foam_floor_cover tp_foam_shore_cover;

/* Returns the variance of slopes of the waves that the grid leaves out at a sample's depth,
 * over the mean square, Q8. */
uint32_t tp_foam_filtered_variance(const tp_shade *shade, const tp_shade_foam *f,
                                   uint32_t key);

/* Returns the cover 0..255 beyond the window at sample i of a run; v as above. */
uint32_t tp_foam_far_cover(const tp_shade_foam *f, const tp_run *run, int32_t i, uint32_t v);

#define TP_FOAM_FAINT 10        /* less cover towards the edge and beyond shows no lace */

/* Returns the lighting 128..256 of foam: ambient and direct light on the water's slope,
 * raised by half of the difference to white, because bubbles scatter light.  Slopes above
 * 2 (63 degrees) count as 2. */
TP_ALWAYS_INLINE uint32_t tp_foam_light_share(const tp_shade *shade, int32_t sx, int32_t sz)
{
    uint32_t q = tp_slope_square(sx, sz);
    int32_t ny = (int32_t)tp_steep_table[(q < TP_SLOPE_END ? q : TP_SLOPE_END - 1) >> 17];
    int32_t nl = shade->world.ly - ((sx * shade->world.lx + sz * shade->world.lz) >> 12);

    nl = tp_clamp(nl * (ny >> 2) >> 12, 0, 16384);
    return (uint32_t)(256 + tp_lit_share(shade->ambient, nl)) / 2;
}

#endif
