/* SPDX-License-Identifier: MIT */
/*
 * A frame from its config to its init: check and layout.  The frame is one block of memory,
 * laid out at init as the scene demands.  Nothing is allocated later.
 */
#include "base/base.h"
#include "frame/frame.h"
#include "frame/renderers.h"
#include "frame/tools.h"
#include "pixel/pixel.h"
#include "quality/plan.h"
#include "world/module.h"
#include "world/pools.h"

/* -- layout of the block ------------------------------------------------------------- */

/* Lays out the memory of the possible water renderers. */
static void layout_renderers(tp_frame_buffers *p, tp_arena *arena,
                             const tp_program *program, const tp_scene *scene,
                             const tp_config *config)
{
    for (int v = TP_VISIBILITY_TRIANGLES; v <= TP_VISIBILITY_WALK; v++) {
        const struct tp_water_renderer *method =
            tp_frame_renderer(program, (tp_visibility)v);
        if (p->rung_mask.visibility >> v & 1 && method)
            method->layout(p, arena, program, scene, config);
    }
}

bool tp_frame_is_coastal(const tp_program *program, const tp_scene *scene)
{
    const tp_module_conditions conditions =
        tp_world_module_conditions(program, scene, NULL);
    return tp_modules_is_any_active(program->modules, &conditions, TP_MODULE_COASTAL);
}

bool tp_frame_has_coast(const tp_program *program, const tp_scene *scene)
{
    return tp_has_floor(scene) && tp_frame_is_coastal(program, scene);
}

bool tp_frame_is_grid_streamed(const tp_program *program)
{
    return program->method.triangles && program->method.triangles->most_kept_bytes;
}

/* Returns the bytes of lines that a scratch keeps: of walked water if the scene draws it,
 * else of the grid. */
static uint32_t kept_bytes(const tp_program *program, const tp_scene *scene,
                           const tp_config *config)
{
    const bool walks =
        scene->quality.visibility == TP_VISIBILITY_WALK && program->method.walk;
    const struct tp_water_renderer *by =
        walks ? program->method.walk : program->method.triangles;

    if (!config->kept_bytes || !program->draw.kept_lines || !by || !by->most_kept_bytes)
        return 0;
    const size_t most = by->most_kept_bytes(scene, config);
    return config->kept_bytes < most ? (config->kept_bytes + 7) & ~7u : (uint32_t)most;
}

/* Returns the conditions that decide if a module is on, for a frame. */
tp_module_conditions tp_frame_module_conditions(const tp_program *program,
                                                const tp_frame_buffers *buffers,
                                                const tp_scene *scene,
                                                const tp_assets *assets,
                                                const tp_config *config)
{
    return (tp_module_conditions){
        .scene = scene,
        .assets = assets,
        .water = &program->water,
        .width = config->width,
        .height = config->height,
        .shadings = buffers->rung_mask.shading,
        .streams = tp_frame_is_grid_streamed(program),
    };
}

tp_plan_input tp_frame_plan_input(const tp_program *program, const tp_scene *scene,
                                  const tp_assets *assets, const tp_config *config)
{
    return (tp_plan_input){ program->modules, scene, assets, config->width,
                            config->height };
}

/* Allocates the frame's block, the frame itself first.  Called with a counting arena, then
 * with the block.  Returns sizes in `ram`. */
static tp_frame *allocate_frame(const tp_program *program, tp_frame_buffers *buffers,
                                tp_ram_use *ram, tp_arena *arena, const tp_scene *scene,
                                tp_assets *assets, const tp_config *config)
{
    tp_frame *frame = tp_arena_alloc(arena, 1, sizeof *frame);
    const size_t fixed = arena->used;

    *buffers = (tp_frame_buffers){
        .rung_mask = tp_frame_rung_mask(scene),
        .renderer_bytes = (uint32_t)tp_renderer_tile_bytes(program, scene, config),
    };
    layout_renderers(buffers, arena, program, scene, config);
    const tp_plan_input in = tp_frame_plan_input(program, scene, assets, config);
    if (program->draw.culling)
        program->draw.culling->layout(buffers, arena, &in);
    const size_t placed = arena->used;
    const tp_module_conditions conditions =
        tp_frame_module_conditions(program, buffers, scene, assets, config);
    tp_frame_layout_modules(program, buffers, arena, conditions);
    const size_t modules = arena->used;
    buffers->gradient = tp_table_layout(arena, assets, TP_TABLE_gradient,
                                        (TP_SKY + 1) * sizeof(uint32_t));
    *ram = (tp_ram_use){
        .frame = arena->used,
        .vertices = placed - fixed,
        .tables = buffers->module_bytes + arena->used - modules,
        .mirror = buffers->map_bytes,
    };
    return frame;
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

static tp_assets assets_or_empty(const tp_assets *assets)
{
    return assets != NULL ? *assets : (tp_assets){ .boat = NULL };
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

size_t tp_frame_bytes(const tp_config *config, const tp_scene *scene)
{
    const tp_config c = config_with_defaults(config, scene);
    tp_arena arena = tp_arena_init(NULL, 0);
    tp_assets known = assets_or_empty(c.assets);
    tp_frame_buffers buffers;
    tp_ram_use ram;

    if (check_both(&c, scene, NULL) != TP_OK)
        return 0;
    allocate_frame(c.program, &buffers, &ram, &arena, scene, &known, &c);
    return ram.frame;
}

/* Returns the code for water at half the rows, if the scene names it. */
static const struct tp_draw_half_lines *find_half_lines(const tp_config *c,
                                                        const tp_scene *scene)
{
    return scene->quality.lines == TP_RUNG_FAST ? c->program->draw.half_lines : NULL;
}

/* Returns the code for packed rows, if the scene names them and the pictures are rgb565. */
static const struct tp_draw_packed_rows *find_packed_rows(const tp_config *c,
                                                          const tp_scene *scene)
{
    const bool packed = c->format == TP_FORMAT_RGB565 || c->format == TP_FORMAT_RGB565BE;

    return packed && scene->quality.blending == TP_RUNG_FAST
               ? c->program->draw.packed_rows : NULL;
}

/* Returns the rows of samples that a tile may need beyond its own. */
static uint32_t count_extra_rows(const tp_config *c, const tp_scene *scene)
{
    const struct tp_draw_half_lines *half = find_half_lines(c, scene);
    return half ? half->extra_rows(c->tile_height, c->height) : 0;
}

/* Returns the bytes of a tile's window of a streamed grid. */
static size_t window_bytes(const tp_program *program, const tp_scene *scene)
{
    return tp_frame_is_grid_streamed(program)
               ? tp_grid_window_bytes(tp_fan_most_cols(tp_fan_budget(scene)),
                                      tp_frame_has_coast(program, scene)) : 0;
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

/* Lays out the frame in its block and fills the members; tables are filled later. */
static tp_frame *make(tp_arena *arena, const tp_config *c, const tp_scene *scene)
{
    tp_assets known = assets_or_empty(c->assets);
    tp_frame_buffers buffers;
    tp_ram_use ram;
    tp_frame *frame = allocate_frame(c->program, &buffers, &ram, arena, scene, &known, c);

    TP_ASSERT(arena->used == ram.frame && !arena->failed);
    memset(frame, 0, sizeof *frame);
    frame->program = c->program;
    frame->scene = scene;
    frame->assets = known;
    frame->config = *c;
    frame->across = (c->width + c->tile_width - 1) / c->tile_width;
    frame->down = (c->height + c->tile_height - 1) / c->tile_height;
    frame->buffers = buffers;
    frame->half_lines = find_half_lines(c, scene);
    frame->packed_rows = find_packed_rows(c, scene);
    frame->extra_rows = count_extra_rows(c, scene);
    frame->kept_bytes = kept_bytes(c->program, scene, c);
    frame->ram = ram;
    frame->ram.scratch = scratch_size(c, scene, false);
    return frame;
}

tp_status tp_frame_init(tp_frame **out, const tp_config *config, const tp_scene *scene,
                        void *memory, size_t bytes, tp_error *err)
{
    const tp_config c = config_with_defaults(config, scene);
    tp_status status = tp_pointer_check(out, "frame", err);

    if (status == TP_OK)
        status = check_both(&c, scene, err);
    if (status == TP_OK)
        status = check_program(c.program, c.format, err);
    if (status == TP_OK)
        status = tp_pointer_check_aligned(memory, 8, "memory", err);
    if (status != TP_OK)
        return status;
    const size_t needed = tp_frame_bytes(&c, scene);
    if (bytes < needed)
        return TP_FAIL(err, TP_E_NOSPACE, 0, needed, bytes);
    tp_arena arena = tp_arena_init(memory, bytes);
    tp_frame *frame = make(&arena, &c, scene);
    tp_frame_choose_rungs(frame);
    tp_frame_init_modules(frame);
    *out = frame;
    return TP_OK;
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
