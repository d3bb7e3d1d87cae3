/* SPDX-License-Identifier: MIT */
/* Stencil values: the low bits of a sample's key identify the module of the sample.  Sky
 * and water have fixed values.  The others are dealt to the modules enabled when a frame
 * is laid out, in the order of the program's list.  Each module has one shader list. */
#ifndef TP_FRAME_MARKS_H
#define TP_FRAME_MARKS_H
#include "base/arena.h"
#include "frame/shaders.h"

#define TP_MARKS (1u << TP_MARK_BITS)

typedef struct {
    tp_shaders *list;           /* lists of sky, water, then the modules */
    uint8_t    *list_of;        /* list index of each stencil value */
    uint16_t    count;          /* number of values dealt */
    uint8_t     lists;          /* number of lists */
} tp_marks;

/* Deals the fixed values of sky and water. */
void tp_marks_init(tp_marks *marks);

/* Deals `wanted` values and one list, and returns the first value; 0: none is wanted, or
 * too few are left. */
uint32_t tp_marks_reserve_values(tp_marks *marks, uint32_t wanted);

/* Allocates the memory of the lists; all values are dealt. */
void tp_marks_layout(tp_marks *marks, tp_arena *arena);

/* Assigns list i, and the values from `first` on, to their owner. */
void tp_marks_assign_list(tp_marks *marks, uint32_t i, uint32_t first,
                          const struct tp_drawing *owner);

static inline tp_shaders *tp_marks_list(const tp_marks *marks, uint32_t mark)
{
    TP_ASSERT(mark < marks->count);
    return &marks->list[marks->list_of[mark]];
}
#endif
