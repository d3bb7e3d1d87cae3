/* SPDX-License-Identifier: MIT */
/* Applies the exposure.  The last stage of every shader list does the tone mapping.  If
 * no list has a later stage, the table for storing pixels does it instead. */
#include "features/exposure/exposure.h"
#include "frame/frame.h"
#include "frame/renderers.h"

static tp_fx drawn_exposure(const tp_frame *frame)
{
    const tp_fx exposure = frame->drawn.exposure;

    return frame->scene->quality.exposure == TP_RUNG_FAST ? tp_exposure_coarse(exposure)
                                                          : exposure;
}

const struct tp_draw_tone_rgb565 tp_draw_tone_rgb565 = { tp_store_rgb565_tone_mapped };

const struct tp_draw_tone_rgb565be tp_draw_tone_rgb565be = { tp_store_rgb565be_tone_mapped };

/* Returns the function that maps and stores pixels of the frame's format; NULL: none. */
static tp_tone_mapped_store *choose_store(const tp_frame *frame)
{
    const tp_draws *draw = &frame->program->draw;

    return frame->config.format == TP_FORMAT_RGB565 && draw->tone_rgb565
               ? draw->tone_rgb565->store
         : frame->config.format == TP_FORMAT_RGB565BE && draw->tone_rgb565be
               ? draw->tone_rgb565be->store : NULL;
}

static void make_tones(const tp_frame *frame, const void *from, void *entries)
{
    tp_tones *to = entries;

    (void)from;
    tp_exposure_make_tone_curve(to->tone, drawn_exposure(frame));
    for (uint32_t i = 0; i < 256; i++)
        tp_rgb565_tone_map_set(&to->tone_map, i, to->tone[i]);
}

const struct tp_draw_tones tp_draw_tones = { { make_tones } };

/* Sets the tone tables, and chooses the method.  Panes of glass and overlays must be drawn
 * over tone-mapped colours: both exclude the pixel table. */
static void begin_tone_mapping(tp_frame *frame, void *mine)
{
    tp_exposure *e = mine;
    const int32_t exposure = drawn_exposure(frame);

    TP_ASSERT(exposure > 0);
    if (exposure == TP_FX_ONE)
        return;
    e->tones = tp_frame_table(frame, TP_TABLE_tones, e->own, &exposure,
                              TP_TABLE_MAKER(frame->program->draw.tones), NULL);
    if (frame->config.overlay.draw || tp_frame_has_module(frame, TP_MODULE_PANES))
        return;
    frame->store_tone_mapped = choose_store(frame);
    frame->tone_map = frame->store_tone_mapped ? &e->tones->tone_map : NULL;
}

static void add_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    if (drawn_exposure(frame) != TP_FX_ONE && !frame->tone_map)
        tp_shaders_add(list, TP_AT_TONE, stage[0], mine);
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_exposure_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->hdr.exposure == TP_EXPOSURE_AUTO
           || conditions->scene->hdr.exposure_factor != TP_FX_ONE;
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    tp_exposure *e = tp_arena_alloc(arena, 1, sizeof *e);
    tp_own_table *own =
        tp_table_layout(arena, conditions->assets, TP_TABLE_tones, sizeof(tp_tones));

    if (e)
        e->own = own;
    return e;
}

const tp_module tp_exposure_module = {
    .name = "exposure", .id = TP_EXPOSURE_ID, .trait = TP_TRAIT_expose,
    .enabled = tp_exposure_enabled,
};

const tp_drawing tp_exposure_drawing = {
    .layout = layout, .begin = begin_tone_mapping, .stages = add_stage,
};
