/* SPDX-License-Identifier: MIT */
/* The modules of a picture: loops over the program's list; see drawing.h. */
#include "frame/frame.h"

/* Loops over the modules of the program by their set bits.  The loop ends after the
 * highest set bit: most pictures use few modules. */
#define EACH_OF(bits, i, use, program)                                                   \
    const tp_use *const use = (program)->modules;                                        \
    uint32_t i = 0;                                                                      \
    for (uint64_t left = (bits); left; left >>= 1, i++)                                  \
        if (left & 1)

#define EACH_ON(i, use, frame) EACH_OF((frame)->modules_on, i, use, (frame)->program)

/* -- enabled modules ----------------------------------------------------------------- */

/* True if a module that was off at init can be drawn: it needs neither memory nor stencil
 * values. */
static bool needs_no_memory(const tp_drawing *drawing)
{
    return drawing && !drawing->layout && !drawing->marks;
}

void tp_frame_enable_modules(tp_frame *frame)
{
    tp_module_conditions conditions = tp_frame_module_conditions(
        frame->program, &frame->buffers, frame->scene, &frame->assets, &frame->config);

    uint64_t laid = frame->buffers.laid, bit = 1, on = 0;
    frame->outlined = 0;
    const tp_use *use = frame->program->modules;
    for (uint32_t i = 0; use && use[i].module; i++, laid >>= 1, bit <<= 1)
        if ((laid & 1 || needs_no_memory(use[i].drawing))
            && tp_module_ask_condition(use[i].module, &conditions)) {
            on |= bit;
            if (use[i].drawing && use[i].drawing->outlining)
                frame->outlined = (uint8_t)(i + 1);
        }
    frame->modules_on = on;
}

void *tp_frame_module_memory(const tp_frame *frame, uint32_t id)
{
    EACH_ON(i, use, frame)
        if (use[i].module->id == id)
            return frame->buffers.module[i];
    return NULL;
}

const tp_stage *tp_frame_module_stages(const tp_frame *frame, uint32_t id)
{
    EACH_ON(i, use, frame)
        if (use[i].module->id == id)
            return use[i].stage;
    return NULL;
}

bool tp_frame_has_module(const tp_frame *frame, uint32_t kinds)
{
    EACH_ON(i, use, frame)
    if (use[i].module->is & kinds)
        return true;
    return false;
}

bool tp_frame_has_solids(const tp_frame *frame)
{
    EACH_OF(frame->modules_drawn, i, use, frame->program)
    if (use[i].drawing->draw)
        return true;
    return false;
}

/* -- hooks --------------------------------------------------------------------------- */

void tp_frame_init_modules(tp_frame *frame)
{
    EACH_OF(frame->buffers.laid, i, use, frame->program)
    if (use[i].drawing->init)
        use[i].drawing->init(frame, frame->buffers.module[i]);
}

void tp_frame_add_displacements(tp_frame *frame, tp_surface *surface)
{
    EACH_ON(i, use, frame)
        if (use[i].drawing->surface)
            use[i].drawing->surface(frame, frame->buffers.module[i], surface);
}

void tp_frame_begin_modules(tp_frame *frame)
{
    EACH_ON(i, use, frame) {
        const uint32_t dropped = frame->stats.dropped;
        if (use[i].drawing->begin)
            use[i].drawing->begin(frame, frame->buffers.module[i]);
        if (frame->stats.dropped > dropped && !frame->lacking)
            frame->lacking = (uint8_t)(i + 1);
    }
}

tp_view_anchor tp_frame_objects_anchor(const tp_frame *frame)
{
    tp_view_anchor anchor = { .level = 0 };

    EACH_ON(i, use, frame)
    if (use[i].drawing->anchor
        && use[i].drawing->anchor(frame, frame->buffers.module[i], &anchor))
        break;
    return anchor;
}

void tp_frame_draw_maps(tp_frame *frame)
{
    EACH_ON(i, use, frame)
    if (use[i].drawing->draw_map)
        use[i].drawing->draw_map(frame, frame->buffers.module[i]);
}

void tp_frame_add_stages(const tp_frame *frame, tp_shaders *list)
{
    EACH_ON(i, use, frame) {
        const uint32_t lacks = list->lacks;
        if (use[i].drawing->stages)
            use[i].drawing->stages(frame, frame->buffers.module[i], use[i].stage, list);
        if (list->lacks > lacks && !list->lacking)
            list->lacking = (uint8_t)(i + 1);
    }
}

void tp_frame_project_modules(tp_frame *frame, tp_view *view, tp_grid_box *box)
{
    EACH_ON(i, use, frame)
    if (use[i].drawing->project)
        use[i].drawing->project(frame, frame->buffers.module[i], view, box);
}

void tp_frame_draw_modules(const tp_frame *frame, const tp_view *view,
                           tp_gbuffer *samples)
{
    EACH_OF(frame->modules_drawn, i, use, frame->program)
    if (use[i].drawing->draw)
        use[i].drawing->draw(frame, frame->buffers.module[i], view, samples,
                             frame->buffers.mark[i]);
}

/* -- shader lists of the modules' own samples ---------------------------------------- */

uint32_t tp_marks_one(const tp_module_conditions *conditions)
{
    (void)conditions;
    return 1;
}

static uint64_t drawing_mask(const tp_frame *frame)
{
    uint64_t drawn = 0;

    EACH_ON(i, use, frame)
        if (use[i].drawing->draw)
            drawn |= (uint64_t)1 << i;
    return drawn;
}

/* Fills the modules' lists.  Samples without a colour stage would show uninitialised
 * memory: such a module is turned off. */
void tp_frame_fill_module_lists(tp_frame *frame)
{
    uint64_t lack = 0;

    EACH_ON(i, use, frame) {
        if (!use[i].drawing->marks)
            continue;
        tp_shaders *list = tp_marks_list(&frame->buffers.marks, frame->buffers.mark[i]);
        tp_shaders_clear(list);
        tp_frame_add_stages(frame, list);
        if (!tp_shaders_has(list, TP_AT_COLOUR)) {
            frame->stats.dropped++;
            if (!frame->lacking)
                frame->lacking = (uint8_t)(i + 1);
            lack |= (uint64_t)1 << i;
        }
    }
    frame->modules_on &= ~lack;
    frame->modules_drawn = drawing_mask(frame);
}
