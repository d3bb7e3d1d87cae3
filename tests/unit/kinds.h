/* SPDX-License-Identifier: MIT */
/* Kind of object behind a stencil value.  Each frame assigns its own stencil values. */
#ifndef TP_TESTS_KINDS_H
#define TP_TESTS_KINDS_H
#include "frame/frame.h"

typedef enum {
    MARKS_SKY, MARKS_WATER, MARKS_BOAT, MARKS_LAND, MARKS_DROP, MARKS_TANK, MARKS_SIDE,
    MARKS_SPRAY
} marks_kind;

/* Returns the kind from the owner of the stencil value's shader list. */
static inline marks_kind marks_kind_of(const tp_frame *frame, uint32_t mark)
{
    if (mark < TP_MARK_SOLID)
        return mark == TP_MARK_SKY ? MARKS_SKY : MARKS_WATER;
    const tp_drawing *owner = mark < frame->parts.marks.count
                            ? tp_frame_list(frame, mark)->owner : NULL;
    return owner == &tp_spray_drawing ? MARKS_SPRAY
         : owner == &tp_tank_drawing ? MARKS_TANK
         : owner == &tp_glass_drawing ? MARKS_SIDE
         : owner == &tp_land_drawing ? MARKS_LAND
         : owner == &tp_drops_drawing ? MARKS_DROP : MARKS_BOAT;
}

/* Stores the kind of each stencil value of the frame. */
static inline void marks_list_kinds(const tp_frame *frame, uint8_t kind[TP_MARKS])
{
    for (uint32_t mark = 0; mark < TP_MARKS; mark++)
        kind[mark] = (uint8_t)marks_kind_of(frame, mark);
}
#endif
