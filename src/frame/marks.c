/* SPDX-License-Identifier: MIT */
/* Stencil values and the memory of shader lists; see marks.h. */
#include "frame/marks.h"
#include "base/base.h"
#include "raster/raster.h"

enum { LISTS = TP_LIST_WATER + 1 };     /* lists of sky and water */

void tp_marks_init(tp_marks *marks)
{
    *marks = (tp_marks){ .count = TP_MARK_SOLID, .lists = LISTS };
}

uint32_t tp_marks_reserve_values(tp_marks *marks, uint32_t wanted)
{
    const uint32_t first = marks->count;

    if (wanted == 0 || wanted > TP_MARKS - first)
        return 0;
    marks->count = (uint16_t)(first + wanted);
    marks->lists++;
    return first;
}

/* Returns the index of list i's first stage in the shared memory of all lists; only the
 * water's list is long. */
static uint32_t list_offset(uint32_t i)
{
    return i * TP_SHADERS_OTHER
         + (i > TP_LIST_WATER ? TP_SHADERS_WATER - TP_SHADERS_OTHER : 0);
}

void tp_marks_layout(tp_marks *marks, tp_arena *arena)
{
    const uint32_t room = list_offset(marks->lists);
    tp_shader *shader;
    uint8_t   *place;

    marks->list = tp_arena_alloc(arena, marks->lists, sizeof *marks->list);
    shader = tp_arena_alloc(arena, room, sizeof *shader);
    place = tp_arena_alloc(arena, room + marks->count, sizeof *place);
    if (!marks->list)
        return;
    marks->list_of = place + room;
    for (uint32_t i = 0; i < marks->lists; i++)
        tp_shaders_init(&marks->list[i],
                        i < LISTS ? (tp_list_kind)i : TP_LIST_THINGS,
                        shader + list_offset(i), place + list_offset(i),
                        list_offset(i + 1) - list_offset(i));
    tp_marks_assign_list(marks, TP_LIST_SKY, TP_MARK_SKY, NULL);
    tp_marks_assign_list(marks, TP_LIST_WATER, TP_MARK_WATER, NULL);
}

void tp_marks_assign_list(tp_marks *marks, uint32_t i, uint32_t first,
                          const struct tp_drawing *owner)
{
    TP_ASSERT(i < marks->lists && first < marks->count);
    memset(marks->list_of + first, (int)i, marks->count - first);
    marks->list[i].first = (uint8_t)first;
    marks->list[i].owner = owner;
}
