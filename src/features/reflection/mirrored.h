/* SPDX-License-Identifier: MIT */
/* Code shared by both reflections of objects: adding their stage. */
#ifndef TP_MIRRORED_H
#define TP_MIRRORED_H
#include "frame/frame.h"
#include "tidepool/modules.h"

/* Adds the stage of reflected objects.  Water without a reflected sky does not reflect
 * objects either. */
static inline void tp_add_mirrored(const tp_frame *frame, const void *mine,
                                   const tp_stage *stage, tp_shaders *list)
{
    (void)frame;
    if (tp_shaders_has(list, TP_AT_REFLECT))
        tp_shaders_add(list, TP_AT_OBJECTS, stage[0], mine);
}
#endif
