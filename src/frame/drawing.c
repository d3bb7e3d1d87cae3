/* SPDX-License-Identifier: MIT */
/* The modules of a picture: loops over the program's list; see the header. */
#include "frame/frame.h"

void tp_frame_layout_modules(const tp_kit *kit, tp_frame_parts *parts, tp_arena *arena,
                             tp_want want)
{
    const size_t begin = arena->used;
    size_t count = 0, looks = 0;

    for (const tp_use *u = kit->modules; u && u->module; u++)
        count++;
    parts->module = count ? tp_arena_take(arena, count, sizeof *parts->module) : NULL;
    for (size_t i = 0; i < count; i++) {
        const tp_use *u = &kit->modules[i];
        const bool on = u->drawing && tp_module_ask(u->module, &want);
        const size_t used = arena->used;
        void *mine = on && u->drawing->layout ? u->drawing->layout(arena, &want) : NULL;
        looks += on && u->drawing->look ? arena->used - used : 0;
        if (parts->module)      /* its place stands for the memory that it does not want */
            parts->module[i] = on && !u->drawing->layout ? &parts->module[i] : mine;
    }
    parts->look_bytes = (uint32_t)looks;
    parts->module_bytes = (uint32_t)(arena->used - begin - looks);
}

/* A module that was off at init has no memory, and is not drawn if it is on now. */
void tp_frame_enable_modules(tp_frame *frame)
{
    tp_want want = tp_frame_want(frame->kit, &frame->parts, frame->scene, &frame->assets,
                                 &frame->config);
    void *const *mine = frame->parts.module;
    uint32_t bit = 1;

    frame->modules_on = 0;
    for (const tp_use *u = frame->kit->modules; u && u->module; u++, mine++, bit <<= 1)
        if (*mine && tp_module_ask(u->module, &want))
            frame->modules_on |= bit;
}

#define EACH_ON(u, mine, frame) \
    void *const *mine = (frame)->parts.module; \
    uint32_t bit = 1; \
    for (const tp_use *u = (frame)->kit->modules; u && u->module; u++, mine++, bit <<= 1) \
        if ((frame)->modules_on & bit)

void tp_frame_init_modules(tp_frame *frame)
{
    void *const *mine = frame->parts.module;

    for (const tp_use *u = frame->kit->modules; u && u->module; u++, mine++)
        if (*mine && u->drawing->init)
            u->drawing->init(frame, *mine);
}

void tp_frame_begin_modules(tp_frame *frame)
{
    EACH_ON(u, mine, frame)
        if (u->drawing->begin)
            u->drawing->begin(frame, *mine);
}

void tp_frame_look_modules(tp_frame *frame)
{
    EACH_ON(u, mine, frame)
        if (u->drawing->look)
            u->drawing->look(frame, *mine);
}

void tp_frame_add_modules(const tp_frame *frame, tp_shaders *list)
{
    EACH_ON(u, mine, frame)
        if (u->drawing->stages)
            u->drawing->stages(frame, *mine, u->stage, list);
}

/* One module has samples of its own at present, so there is one list for them. */
void tp_frame_list_modules(tp_frame *frame)
{
    tp_shaders_clear(&frame->over);
    EACH_ON(u, mine, frame) {
        if (!u->drawing->first)
            continue;
        tp_shaders_add(&frame->over, TP_AT_COLOUR,
                       u->drawing->first(frame, *mine, u->stage), *mine);
        tp_frame_add_air(frame, &frame->over);
        tp_frame_add_modules(frame, &frame->over);
    }
}

void tp_frame_place_modules(tp_frame *frame)
{
    EACH_ON(u, mine, frame)
        if (u->drawing->place)
            u->drawing->place(frame, *mine);
}

void tp_frame_draw_modules(const tp_frame *frame, const tp_samples *samples)
{
    EACH_ON(u, mine, frame)
        if (u->drawing->over)
            u->drawing->over(frame, *mine, samples, TP_MARK_OVER);
}

bool tp_frame_has_module(const tp_frame *frame, uint32_t is)
{
    bool has = false;

    EACH_ON(u, mine, frame)
        has |= mine && (u->module->is & is) != 0;
    return has;
}

void *tp_frame_part(const tp_frame *frame, uint32_t id)
{
    EACH_ON(u, mine, frame)
        if (u->module->id == id)
            return *mine;
    return NULL;
}
