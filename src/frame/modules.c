/* SPDX-License-Identifier: MIT */
/* The modules of a picture: loops over the program's list; see drawing.h. */
#include "frame/frame.h"

void **tp_frame_layout_modules(const tp_kit *kit, tp_arena *arena, const tp_want *want)
{
    size_t count = 0;

    for (const tp_use *u = kit->modules; u && u->module; u++)
        count++;
    if (count == 0)
        return NULL;
    void **mine = tp_arena_take(arena, count, sizeof *mine);
    for (size_t i = 0; i < count; i++) {
        const tp_use *u = &kit->modules[i];
        const bool on = u->drawing && u->drawing->layout && u->module->enabled(want);
        void *of_one = on ? u->drawing->layout(arena, want) : NULL;
        if (mine)
            mine[i] = of_one;
    }
    return mine;
}

/* A module that was off at init has no memory and is not drawn. */
#define EACH_DRAWN(u, mine, frame) \
    void *const *mine = (frame)->parts.module; \
    for (const tp_use *u = (frame)->kit->modules; u && u->module; u++, mine++) \
        if (*mine)

void tp_frame_init_modules(tp_frame *frame)
{
    EACH_DRAWN(u, mine, frame)
        if (u->drawing->init)
            u->drawing->init(frame, *mine);
}

void tp_frame_begin_modules(tp_frame *frame)
{
    EACH_DRAWN(u, mine, frame)
        if (u->drawing->begin)
            u->drawing->begin(frame, *mine);
}

void tp_frame_add_modules(const tp_frame *frame, tp_shaders *water)
{
    EACH_DRAWN(u, mine, frame)
        if (u->drawing->water)
            u->drawing->water(frame, *mine, u->stage, water);
}

bool tp_frame_has_module(const tp_frame *frame, uint32_t is)
{
    bool has = false;

    EACH_DRAWN(u, mine, frame)
        has |= (u->module->is & is) != 0;
    return has;
}
