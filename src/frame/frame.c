/* SPDX-License-Identifier: MIT */
/*
 * A frame from its config to its init: checks them, and finds all that baked_frame.c makes
 * the frame of.
 */
#include "base/base.h"
#include "frame/frame.h"
#include "frame/renderers.h"
#include "frame/tools.h"
#include "pixel/pixel.h"
#include "quality/plan.h"
#include "world/module.h"
#include "world/pools.h"

/* -- what follows from the scene ------------------------------------------------------ */

bool tp_frame_has_coast(const tp_program *program, const tp_scene *scene)
{
    const tp_module_conditions conditions =
        tp_world_module_conditions(program, scene, NULL);

    return tp_has_floor(scene)
           && tp_modules_is_any_active(program->modules, &conditions, TP_MODULE_COASTAL);
}

bool tp_frame_asks_samples(const tp_program *program, tp_module_conditions conditions)
{
    return !program->water.samples
           && tp_modules_is_any_active(program->modules, &conditions, TP_MODULE_SAMPLES);
}

/* -- check and init ------------------------------------------------------------------ */

#define TILE_ROWS 16 /* default of a config without a tile height */

/* Fills in the tile's size; a tile is no larger than the picture. */
static void set_tile_size(tp_config *c)
{
    if (c->tile_width == 0 || c->tile_width > c->width)
        c->tile_width = c->width;
    if (c->tile_height == 0)
        c->tile_height = TILE_ROWS;
    if (c->tile_height > c->height)
        c->tile_height = c->height;
}

/* Returns the config with defaults filled in.  NULL becomes a picture without pixels,
 * rejected by check(). */
static tp_config config_with_defaults(const tp_config *config, const tp_scene *scene)
{
    tp_config c = { .width = 0 };

    if (config != NULL)
        c = *config;
    set_tile_size(&c);
    c.program = tp_program_or_linked(c.program);
    if (scene != NULL)
        c.assets = tp_assets_or_scene_default(scene, c.assets);
    return c;
}

/* Checks the stages and the pixel store needed by each picture. */
static tp_status check_program(const tp_program *program, tp_format format, tp_error *err)
{
    if (!program->stage.plain)
        return tp_program_fail_lacking("plain", err);
    return program->store[format] ? TP_OK
                                  : tp_program_fail_lacking(tp_format_name(format), err);
}

static tp_status check(const tp_config *c, tp_error *err)
{
    if (c->width < TP_PICTURE_SIDE_MIN || c->width > TP_PICTURE_SIDE_MAX
        || c->height < TP_PICTURE_SIDE_MIN || c->height > TP_PICTURE_SIDE_MAX)
        return TP_FAIL(err, TP_E_SIZE, 0, c->width, c->height);
    if (c->tile_width % 16 != 0 && c->tile_width < c->width)
        return TP_FAIL(err, TP_E_TILE, 0, c->tile_width, c->tile_height);
    if ((unsigned)c->format >= TP_FORMAT_COUNT)
        return TP_FAIL(err, TP_E_ARG, 0, 0, 0);
    return TP_OK;
}

tp_status tp_config_check(const tp_config *config, tp_config *filled, tp_error *err)
{
    tp_config c = { .width = 0 };

    if (config != NULL)
        c = *config;
    set_tile_size(&c);
    if (filled)
        *filled = c;
    return check(&c, err);
}

/* Checks the config and the scene together. */
static tp_status check_both(const tp_config *c, const tp_scene *scene, tp_error *err)
{
    const tp_status status = check(c, err);

    return status == TP_OK ? tp_program_check_all(c->program, scene, c->assets, err)
                           : status;
}

/* -- scratch of a tile --------------------------------------------------------------- */

/* True if the scene names water at half the rows, and the program has it. */
static bool has_half_lines(const tp_config *c, const tp_scene *scene)
{
    return scene->quality.lines == TP_RUNG_FAST && c->program->draw.half_lines;
}

/* True if the scene names packed rows, the program has them and the pictures are rgb565. */
static bool has_packed_rows(const tp_config *c, const tp_scene *scene)
{
    const bool packed = c->format == TP_FORMAT_RGB565 || c->format == TP_FORMAT_RGB565BE;

    return packed && scene->quality.blending == TP_RUNG_FAST
           && c->program->draw.packed_rows;
}

/* Returns the rows of samples that a tile may need beyond its own. */
static uint32_t count_extra_rows(const tp_config *c, const tp_scene *scene)
{
    return has_half_lines(c, scene)
               ? c->program->draw.half_lines->extra_rows(c->tile_height, c->height) : 0;
}

/* Returns the bytes of a tile's window of a streamed grid. */
static size_t window_bytes(const tp_program *program, const tp_scene *scene)
{
    return tp_frame_is_grid_streamed(program)
               ? tp_grid_window_bytes(tp_fan_most_cols(tp_fan_budget(scene)),
                                      tp_frame_has_coast(program, scene)) : 0;
}

/* Returns the bytes of lines that a scratch keeps: of walked water if the scene draws it,
 * else of the grid. */
static uint32_t kept_bytes(const tp_program *program, const tp_scene *scene,
                           const tp_config *config)
{
    const struct tp_water_renderer *by = tp_frame_asks_walk(program, scene)
                                             ? program->method.walk
                                             : program->method.triangles;

    if (!config->kept_bytes || !program->draw.kept_lines || !by || !by->most_kept_bytes)
        return 0;
    const size_t most = by->most_kept_bytes(scene, config);
    return config->kept_bytes < most ? (config->kept_bytes + 7) & ~7u : (uint32_t)most;
}

/* Returns the planes of a tile's samples: four, and four more for outlines.  The answer
 * does not depend on the assets, which a caller may not have named yet. */
static uint32_t count_planes(const tp_program *program, const tp_scene *scene)
{
    if (!tp_has_outlines(scene))
        return 4;
    for (const tp_use *u = program->modules; u && u->module; u++)
        if (u->module->is & TP_MODULE_OUTLINES)
            return 8;
    return 4;
}

/* Scratch size: kept lines, the planes of the G-buffer, then the pixels unless they are
 * drawn elsewhere.  Before pixels exist, the renderer's columns and the window of a
 * streamed grid use the same place. */
static size_t scratch_size(const tp_config *config, const tp_scene *scene, bool direct)
{
    const tp_config c = config_with_defaults(config, scene);

    if (check(&c, NULL) != TP_OK || tp_program_check_scene(c.program, scene, NULL) != TP_OK)
        return 0;
    const size_t pixels = tp_format_row_bytes(c.format, (int)c.tile_width) * c.tile_height;
    const uint32_t planes = count_planes(c.program, scene);
    const size_t method = tp_renderer_tile_bytes(c.program, scene, &c)
                          + window_bytes(c.program, scene);
    const size_t samples = (size_t)c.tile_width
                         * (c.tile_height + count_extra_rows(&c, scene));
    return kept_bytes(c.program, scene, &c) + planes * samples * sizeof(uint32_t)
           + (pixels > method && !direct ? pixels : method);
}

size_t tp_frame_scratch_bytes(const tp_config *config, const tp_scene *scene)
{
    return scratch_size(config, scene, false);
}

size_t tp_frame_direct_scratch_bytes(const tp_config *config, const tp_scene *scene)
{
    return scratch_size(config, scene, true);
}

/* -- find and init ------------------------------------------------------------------- */

/* Finds the modules that are on, and deals stencil values to those that draw samples. */
static void find_modules(tp_found_frame *to, tp_module_conditions conditions)
{
    tp_baked_frame *f = &to->frame;
    uint64_t bit = 1;
    tp_marks marks;

    tp_marks_init(&marks);
    for (const tp_use *u = to->config.program->modules; u && u->module; u++, bit <<= 1) {
        const bool on = tp_module_ask_condition(u->module, &conditions);
        const bool draws = on && u->drawing, marked = draws && u->drawing->marks;
        const uint32_t first = marked ? tp_marks_reserve_stencil_values(
                                            &marks, u->drawing->marks(&conditions)) : 0;
        TP_ASSERT(f->modules < TP_MODULES);
        to->stencil[f->modules++] = (uint8_t)first;
        f->enabled |= on ? bit : 0;
        f->unmarked = (uint8_t)(f->unmarked + (marked && !first));
        if (!draws || (marked && !first))
            continue;
        f->laid |= bit;
        f->outlined = u->drawing->outlining ? f->modules : f->outlined;
    }
    f->stencil_values = marks.count;
    f->lists = marks.lists;
}

static void find_rungs(tp_baked_frame *to, const tp_config *c, const tp_scene *scene,
                       tp_rungs named)
{
    to->visibility = (uint8_t)named.visibility;
    to->shading = (uint8_t)named.shading;
    to->rate = (uint8_t)named.rate;
    to->half_lines = has_half_lines(c, scene);
    to->packed_rows = has_packed_rows(c, scene);
    to->extra_rows = (uint16_t)count_extra_rows(c, scene);
}

/* Finds all of a checked config and scene. */
static void find(tp_found_frame *to, const tp_scene *scene)
{
    const tp_config *c = &to->config;
    const tp_program *program = c->program;
    tp_baked_frame *f = &to->frame;

    *f = (tp_baked_frame){ .config = c, .scene = scene, .assets = &to->assets,
                           .stencil = to->stencil };
    const tp_rungs named = tp_frame_named_rungs(scene);
    const tp_frame_buffers buffers = { .rung_mask = tp_frame_rung_mask(named) };
    find_rungs(f, c, scene, named);
    const tp_module_conditions conditions =
        tp_frame_module_conditions(program, &buffers, scene, &to->assets, c);
    find_modules(to, conditions);
    f->across = (uint16_t)((c->width + c->tile_width - 1) / c->tile_width);
    f->down = (uint16_t)((c->height + c->tile_height - 1) / c->tile_height);
    f->scratch_bytes = (uint32_t)scratch_size(c, scene, false);
    f->renderer_bytes = (uint32_t)tp_renderer_tile_bytes(program, scene, c);
    f->kept_bytes = kept_bytes(program, scene, c);
    f->coast = tp_frame_has_coast(program, scene);
    f->needs_samples = tp_frame_asks_samples(program, conditions);
}

tp_status tp_frame_find(tp_found_frame *to, const tp_config *config, const tp_scene *scene,
                        tp_error *err)
{
    to->config = config_with_defaults(config, scene);
    const tp_status status = check_both(&to->config, scene, err);

    if (status != TP_OK)
        return status;
    to->assets = to->config.assets ? *to->config.assets : (tp_assets){ .boat = NULL };
    find(to, scene);
    return TP_OK;
}

size_t tp_frame_bytes(const tp_config *config, const tp_scene *scene)
{
    tp_found_frame found;

    return tp_frame_find(&found, config, scene, NULL) == TP_OK
               ? tp_baked_frame_bytes(&found.frame) : 0;
}

/* Finds again what a change of the scene's numbers changes. */
static void read_scene(tp_frame *frame)
{
    const tp_program *program = frame->program;

    tp_frame_enable_modules(frame);
    tp_frame_choose_rungs(frame);
    if (!program->water.samples)
        frame->needs_samples = tp_frame_asks_samples(
            program, tp_frame_module_conditions(program, &frame->buffers, frame->scene,
                                                &frame->assets, &frame->config));
}

tp_status tp_frame_init(tp_frame **out, const tp_config *config, const tp_scene *scene,
                        void *memory, size_t bytes, tp_error *err)
{
    tp_found_frame found;
    tp_status status = tp_pointer_check(out, "frame", err);

    if (status == TP_OK)
        status = tp_frame_find(&found, config, scene, err);
    if (status == TP_OK)
        status = check_program(found.config.program, found.config.format, err);
    if (status == TP_OK)
        status = tp_baked_frame_init(out, &found.frame, memory, bytes, err);
    if (status == TP_OK)
        (*out)->read_scene = read_scene;
    return status;
}

uint32_t tp_frame_tiles(const tp_frame *frame)
{
    TP_ASSERT(frame != NULL && frame->across > 0 && frame->down > 0);
    return frame->across * frame->down;
}

tp_draw_stats tp_frame_stats(const tp_frame *frame)
{
    return frame->stats;
}

const char *tp_frame_lacks(const tp_frame *frame)
{
    const uint32_t who = frame->lacking;

    static const char *const others[] = { "grid_rows", "cells", "samples", "sky" };

    if (who >= TP_LACKING_ROWS)
        return others[who - TP_LACKING_ROWS];
    return who ? frame->program->modules[who - 1].module->name : NULL;
}

tp_ram_use tp_frame_ram(const tp_frame *frame)
{
    return frame->ram;
}
