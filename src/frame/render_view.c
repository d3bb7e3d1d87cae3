/* SPDX-License-Identifier: MIT */
/* Functions shared by all render views. */
#include "frame/frame.h"

tp_fx tp_view_anchor_level(const tp_frame *frame)
{
    return tp_frame_anchor(frame).level;
}

bool tp_view_is_above_level(const tp_frame *frame, tp_fx level)
{
    return !frame->under && frame->projection.eye.y > level;
}

/* Mipmap levels refer to the picture's focal length.  A view of a shorter focal length
 * puts more texels into a pixel, as a larger distance would. */
void tp_view_set_shade(tp_frame *frame, const tp_projection *projection)
{
    TP_ASSERT(projection->focal > 0 && projection->zi_near > 0);
    tp_shade *shade = &frame->shade;

    shade->u0 = projection->u0;
    shade->v0 = projection->v0;
    shade->focal = projection->focal >> 12;
    shade->per_focal = (uint32_t)(((uint64_t)1 << 32) / (uint32_t)shade->focal);
    shade->zi_log = tp_log2_q8((uint32_t)projection->zi_near) + 15 * 256
                    + tp_log2_q8((uint32_t)frame->projection.focal)
                    - tp_log2_q8((uint32_t)projection->focal);
    shade->world.right = projection->turn.x;
    shade->world.up = projection->turn.y;
    shade->world.back = projection->turn.z;
    shade->eye = projection->eye;
}

void tp_view_begin(tp_frame *frame, const tp_view *view)
{
    tp_view_set_shade(frame, view->projection);
}

tp_grid_box tp_view_project_solids(tp_frame *frame, tp_view *view)
{
    tp_grid_box box = TP_BOX_NONE;

    tp_frame_place_modules(frame, view, &box);
    return box;
}

void tp_view_draw_solids(const tp_frame *frame, const tp_view *view, tp_gbuffer *tile)
{
    tp_frame_draw_modules(frame, view, tile);
}
