/* SPDX-License-Identifier: MIT */
/* Functions shared by all render views. */
#include "frame/frame.h"

tp_fx tp_sight_level(const tp_frame *frame)
{
    return tp_frame_anchor(frame).level;
}

bool tp_sight_is_above_level(const tp_frame *frame, tp_fx level)
{
    return !frame->under && frame->lens.eye.y > level;
}

/* Mipmap levels refer to the picture's focal length.  A view of a shorter focal length
 * puts more texels into a pixel, as a larger distance would. */
void tp_sight_look(tp_frame *frame, const tp_lens *lens)
{
    TP_ASSERT(lens->focal > 0 && lens->zi_near > 0);
    tp_shade *shade = &frame->shade;

    shade->u0 = lens->u0;
    shade->v0 = lens->v0;
    shade->focal = lens->focal >> 12;
    shade->per_focal = (uint32_t)(((uint64_t)1 << 32) / (uint32_t)shade->focal);
    shade->zi_log = tp_log2_q8((uint32_t)lens->zi_near) + 15 * 256
                  + tp_log2_q8((uint32_t)frame->lens.focal)
                  - tp_log2_q8((uint32_t)lens->focal);
    shade->world.right = lens->turn.x;
    shade->world.up = lens->turn.y;
    shade->world.back = lens->turn.z;
    shade->eye = lens->eye;
}

void tp_sight_begin(tp_frame *frame, const tp_sight *sight)
{
    tp_sight_look(frame, sight->lens);
}

tp_grid_box tp_sight_place(tp_frame *frame, tp_sight *sight)
{
    tp_grid_box box = TP_BOX_NONE;

    tp_frame_place_modules(frame, sight, &box);
    return box;
}

void tp_sight_draw(const tp_frame *frame, const tp_sight *sight, tp_samples *tile)
{
    tp_frame_draw_modules(frame, sight, tile);
}
