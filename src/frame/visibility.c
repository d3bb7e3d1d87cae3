/* SPDX-License-Identifier: MIT */
/* By which method a frame's water is drawn: the plan's, where that holds for this camera
 * and this sea.  Decided from them alone, without memory of the frame before. */
#include "frame/frame.h"

void tp_frame_choose_visibility(tp_frame *frame)
{
    frame->rungs = tp_rungs_of(frame->scene, &frame->assets, frame->config.width,
                               frame->config.height);
    frame->visibility = TP_VISIBILITY_TRIANGLES;
}

void tp_frame_draw_surface(const tp_frame *frame, tp_samples *tile)
{
    tp_frame_draw_water(frame, tile);
}
