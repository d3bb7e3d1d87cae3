/* SPDX-License-Identifier: MIT */
/* What kind of thing a mark stands for: each frame deals its own marks. */
#ifndef TP_TESTS_KINDS_H
#define TP_TESTS_KINDS_H
#include "features/boat/boat.h"
#include "features/drops/drops.h"
#include "features/land/land.h"
#include "features/spray/spray.h"
#include "features/tank/tank.h"
#include "frame/frame.h"

typedef enum {
    MARKS_SKY, MARKS_WATER, MARKS_BOAT, MARKS_LAND, MARKS_DROP, MARKS_TANK, MARKS_SIDE,
    MARKS_SPRAY
} marks_kind;

static inline marks_kind marks_kind_of(const tp_frame *frame, uint32_t mark)
{
    if (mark < TP_MARK_SOLID)
        return mark == TP_MARK_SKY ? MARKS_SKY : MARKS_WATER;
    if (mark == tp_frame_mark(frame, TP_SPRAY_ID))
        return MARKS_SPRAY;
    if (mark == tp_frame_mark(frame, TP_TANK_ID))
        return MARKS_TANK;
    if (mark == tp_frame_mark(frame, TP_GLASS_ID))
        return MARKS_SIDE;
    return mark == tp_frame_mark(frame, TP_LAND_ID) ? MARKS_LAND
         : mark == tp_frame_mark(frame, TP_DROPS_ID) ? MARKS_DROP : MARKS_BOAT;
}

/* The kind of each mark of the frame. */
static inline void marks_list_kinds(const tp_frame *frame, uint8_t kind[TP_MARKS])
{
    for (uint32_t mark = 0; mark < TP_MARKS; mark++)
        kind[mark] = (uint8_t)marks_kind_of(frame, mark);
}
#endif
