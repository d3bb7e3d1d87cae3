/* SPDX-License-Identifier: MIT */
/* Marks: the low bits of a sample's key tell which module drew the sample.  Sky and water
 * have fixed marks; the others are dealt to the modules that are on when a frame is laid
 * out, in the order of the program's list.  Each of them has a shader list. */
#ifndef TP_FRAME_MARKS_H
#define TP_FRAME_MARKS_H
#include "base/arena.h"
#include "frame/shaders.h"

#define TP_MARKS (1u << TP_MARK_BITS)

typedef struct {
    tp_shaders *list;           /* of the sky, of the water, then of the modules */
    uint8_t    *list_of;        /* the list of each mark */
    uint16_t    count;          /* marks that are dealt, */
    uint8_t     lists;          /* and lists */
} tp_marks;

/* Deals the fixed marks of sky and water. */
void tp_marks_init(tp_marks *marks);

/* Deals `wanted` marks, with one list, and returns the first; 0: none is wanted, or too few
 * are left. */
uint32_t tp_marks_deal(tp_marks *marks, uint32_t wanted);

/* Takes the memory of the lists; all marks are dealt. */
void tp_marks_layout(tp_marks *marks, tp_arena *arena);

/* Gives list i to its owner, the marks from `first` on. */
void tp_marks_give(tp_marks *marks, uint32_t i, uint32_t first,
                   const struct tp_drawing *owner);

static inline tp_shaders *tp_marks_list(const tp_marks *marks, uint32_t mark)
{
    TP_ASSERT(mark < marks->count);
    return &marks->list[marks->list_of[mark]];
}
#endif
