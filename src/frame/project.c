/* SPDX-License-Identifier: MIT */
/* Conversion between world positions and picture positions. */
#include "frame/frame.h"

/* Component of a position relative to the eye along an axis of the view, m, Q30.
 * Differences below 2^32 times 2^30 fit 64 bits; three of them fit once 16 bits are cut. */
static int64_t view_axis_component(const tp_projection *projection, tp_vec3 place,
                                   tp_dir3 axis)
{
    const int64_t x = (int64_t)place.x - projection->eye.x;
    const int64_t y = (int64_t)place.y - projection->eye.y;
    const int64_t z = (int64_t)place.z - projection->eye.z;

    return (x * axis.x >> 16) + (y * axis.y >> 16) + (z * axis.z >> 16);
}

/* Returns focal x way / depth, px, 16.16, saturated.  Both lengths are halved until depth
 * fits 31 bits; if the product would still not fit, the point lies far outside. */
static tp_fx project_pixels(const tp_projection *projection, int64_t way, int64_t depth)
{
    int64_t most;

    for (; depth >> 31 > 0; depth >>= 1)
        way /= 2;
    most = INT64_MAX / 2 / projection->focal;
    if (way > most || way < -most)
        return way > 0 ? TP_FX_MAX : TP_FX_MIN;
    return tp_fx_saturate(tp_div_rounded(way * projection->focal, depth));
}

bool tp_frame_project(const tp_frame *frame, tp_vec3 place, tp_fx *x_px, tp_fx *y_px,
                      tp_fx *depth)
{
    TP_ASSERT(frame != NULL && frame->world != NULL);
    const tp_projection *projection = &frame->projection;
    const int64_t far = view_axis_component(projection, place, projection->ahead);

    if (far >> 14 < projection->near)
        return false;
    *x_px = tp_fx_saturate(
        (int64_t)frame->config.width * (TP_FX_ONE / 2)
        + project_pixels(
            projection, view_axis_component(projection, place, projection->turn.x), far));
    *y_px = tp_fx_saturate(
        (int64_t)frame->config.height * (TP_FX_ONE / 2)
        - project_pixels(
            projection, view_axis_component(projection, place, projection->turn.y), far));
    *depth = tp_fx_saturate((far + (1 << 13)) >> 14);
    return true;
}

bool tp_frame_pick(const tp_frame *frame, tp_fx x_px, tp_fx y_px, tp_vec3 *at)
{
    TP_ASSERT(frame != NULL && frame->world != NULL);
    return tp_world_pick(frame->program, frame->world, frame->scene, frame->config.width,
                         frame->config.height, x_px, y_px, at);
}
