/* SPDX-License-Identifier: MIT */
/*
 * Makes a frame of all that is known about it, a tp_baked_frame: lays out its block and
 * fills its members.  The block is one piece of memory; nothing is allocated later.  It holds
 * pointers, so its layout is computed on the machine that draws; nothing else is.
 */
#include "base/base.h"
#include "frame/frame.h"
#include "frame/renderers.h"
#include "frame/tools.h"
#include "world/module.h"

/* The sizes in a tile's scratch are the same on every machine. */
_Static_assert(sizeof(tp_row_column) == 24 && sizeof(tp_line_sample) == 16
                   && sizeof(tp_grid_vertex) == 16 && sizeof(tp_vec3) == 12,
               "a tile's scratch has no padding and no pointer");

/* -- layout of the block ------------------------------------------------------------- */

bool tp_frame_is_grid_streamed(const tp_program *program)
{
    return program->method.triangles && program->method.triangles->most_kept_bytes;
}

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

static tp_rungs known_rungs(const tp_baked_frame *known)
{
    return (tp_rungs){ (tp_visibility)known->visibility, (tp_shading)known->shading,
                       (tp_rate)known->rate };
}

/* Lays out the memory of the water renderers that may draw: triangles, and the named one. */
static void allocate_renderers(tp_frame_buffers *b, tp_arena *arena,
                               const tp_baked_frame *known)
{
    const tp_program *program = known->config->program;

    for (int v = TP_VISIBILITY_TRIANGLES; v <= known->visibility; v++) {
        const struct tp_water_renderer *renderer =
            b->rung_mask.visibility >> v & 1 ? tp_frame_renderer(program, (tp_visibility)v)
                                             : NULL;
        if (renderer)
            renderer->layout(b, arena, program, known->scene, known->config);
    }
    if (program->draw.culling)
        program->draw.culling->layout(
            b, arena,
            &(tp_plan_input){ program->modules, known->scene, known->assets,
                              known->config->width, known->config->height });
}

/* Lays out the memory of all modules that are on, and all shader lists. */
static void allocate_modules(tp_frame_buffers *b, tp_arena *arena,
                             const tp_baked_frame *known)
{
    const tp_program *program = known->config->program;
    const size_t begin = arena->used;
    const tp_use *u = program->modules;
    uint64_t enabled = known->enabled, laid = known->laid;
    tp_module_conditions conditions = tp_frame_module_conditions(
        program, b, known->scene, known->assets, known->config);

    b->module = tp_arena_alloc(arena, known->modules, sizeof *b->module);
    b->mark = tp_arena_alloc(arena, known->modules, sizeof *b->mark);
    for (uint32_t i = 0; i < known->modules; i++, u++, enabled >>= 1, laid >>= 1) {
        const size_t used = arena->used;
        conditions.above |= enabled & 1 ? u->module->is : 0;
        void *mine = laid & 1 && u->drawing->layout
                         ? u->drawing->layout(arena, &conditions) : NULL;
        if (laid & 1 && u->drawing->draw_map)
            b->map_bytes += (uint32_t)(arena->used - used);
        if (!b->module)
            continue;
        b->module[i] = mine;
        b->mark[i] = known->stencil[i];
    }
    b->marks.count = known->stencil_values;
    b->marks.lists = known->lists;
    tp_marks_layout(&b->marks, arena, program->modules, known->stencil, known->modules);
    b->module_bytes = (uint32_t)(arena->used - begin) - b->map_bytes;
}

/* Allocates the frame's block, the frame itself first.  Called with a counting arena, then
 * with the block; *b and *ram are zeroed. */
static void allocate_block(tp_frame_buffers *b, tp_ram_use *ram, tp_arena *arena,
                           const tp_baked_frame *known)
{
    tp_arena_alloc(arena, 1, sizeof(tp_frame));
    const size_t fixed = arena->used;

    b->rung_mask = tp_frame_rung_mask(known_rungs(known));
    b->coast = known->coast;
    allocate_renderers(b, arena, known);
    const size_t placed = arena->used;
    allocate_modules(b, arena, known);
    const size_t modules = arena->used;
    b->gradient = tp_table_layout(arena, known->assets, TP_TABLE_gradient,
                                  (TP_SKY + 1) * sizeof(uint32_t));
    ram->frame = arena->used;
    ram->vertices = placed - fixed;
    ram->tables = b->module_bytes + arena->used - modules;
    ram->mirror = b->map_bytes;
}

size_t tp_baked_frame_bytes(const tp_baked_frame *known)
{
    tp_arena arena = tp_arena_init(NULL, 0);
    tp_frame_buffers buffers = { .renderer_bytes = 0 };
    tp_ram_use ram;

    allocate_block(&buffers, &ram, &arena, known);
    return ram.frame;
}

/* -- init ---------------------------------------------------------------------------- */

/* Fills the members that drawing does not change. */
static void fill(tp_frame *frame, const tp_baked_frame *known)
{
    const tp_program *program = known->config->program;

    frame->program = program;
    frame->scene = known->scene;
    frame->assets = *known->assets;
    frame->config = *known->config;
    frame->across = known->across;
    frame->down = known->down;
    frame->ram.scratch = known->scratch_bytes;
    frame->buffers.renderer_bytes = known->renderer_bytes;
    frame->kept_bytes = known->kept_bytes;
    frame->buffers.lacks = known->unmarked;
    frame->buffers.laid = known->laid;
    frame->rungs = known_rungs(known);
    frame->half_lines = known->half_lines ? program->draw.half_lines : NULL;
    frame->extra_rows = known->extra_rows;
    frame->packed_rows = known->packed_rows ? program->draw.packed_rows : NULL;
    frame->outlined = known->outlined;
    frame->needs_samples = known->needs_samples;
}

tp_status tp_baked_frame_init(tp_frame **out, const tp_baked_frame *known, void *memory,
                              size_t bytes, tp_error *err)
{
    tp_status status = tp_pointer_check(out, "frame", err);

    if (status == TP_OK)
        status = tp_pointer_check_aligned(memory, 8, "memory", err);
    if (status != TP_OK)
        return status;
    const size_t needed = tp_baked_frame_bytes(known);
    if (bytes < needed)
        return TP_FAIL(err, TP_E_NOSPACE, 0, needed, bytes);
    tp_arena arena = tp_arena_init(memory, bytes);
    tp_frame *frame = memset(memory, 0, sizeof *frame);
    allocate_block(&frame->buffers, &frame->ram, &arena, known);
    TP_ASSERT(arena.used == needed && !arena.failed);
    fill(frame, known);
    tp_frame_init_modules(frame);
    *out = frame;
    return TP_OK;
}

const struct tp_frame_maker tp_frame_maker = { tp_baked_frame_bytes, tp_baked_frame_init };
