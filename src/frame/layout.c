/* SPDX-License-Identifier: MIT */
/* Memory layout of a frame: one block, laid out at init as the scene demands.  Nothing is
 * allocated later. */
#include "frame/frame.h"
#include "geom/waters.h"
#include "scene/prices.h"

/* Lays out the memory of the plan's possible water renderers, and of the grid LOD. */
static void layout_renderers(tp_frame_buffers *p, tp_arena *arena,
                             const tp_program *program, const tp_scene *scene,
                             const tp_config *config)
{
    TP_ASSERT(scene->grid.cols >= 2 && scene->grid.rows >= 2);

    for (int v = TP_VISIBILITY_TRIANGLES; v <= TP_VISIBILITY_FLAT; v++) {
        const struct tp_water_renderer *method =
            tp_frame_renderer(program, (tp_visibility)v);
        if (p->rung_mask.visibility >> v & 1 && method)
            method->layout(p, arena, program, scene, config);
    }
    if (p->rung_mask.lod >> TP_LOD_ON & 1 && program->water.lod
        && program->method.triangles)
        program->water.lod->layout(p->grid, arena);
}

bool tp_frame_is_coastal(const tp_program *program, const tp_scene *scene)
{
    const tp_want want = tp_world_want(program, scene, NULL);
    return tp_modules_is_any_active(program->modules, &want, TP_MODULE_COASTAL);
}

/* True if grid vertices are streamed.  Vertices of coastal water depend on their
 * neighbours and are stored. */
bool tp_frame_is_grid_streamed(const tp_program *program, const tp_scene *scene)
{
    const struct tp_water_renderer *method = program->method.triangles;
    return method && method->streams && !tp_frame_is_coastal(program, scene);
}

/* Returns the conditions for asking modules. */
tp_want tp_frame_want(const tp_program *program, const tp_frame_buffers *buffers,
                      const tp_scene *scene, const tp_assets *assets,
                      const tp_config *config)
{
    return (tp_want){
        .scene = scene,
        .assets = assets,
        .water = &program->water,
        .width = config->width,
        .height = config->height,
        .shadings = buffers->rung_mask.shading,
    };
}

tp_plan_input tp_frame_plan_input(const tp_program *program, const tp_scene *scene,
                                  const tp_assets *assets, const tp_config *config)
{
    return (tp_plan_input){ program->modules, scene, assets, config->width,
                            config->height };
}

tp_frame *tp_frame_layout(const tp_program *program, tp_frame_buffers *buffers,
                          tp_ram_use *ram, tp_arena *arena, const tp_scene *scene,
                          tp_assets *assets, const tp_config *config)
{
    tp_frame *frame = tp_arena_alloc(arena, 1, sizeof *frame);
    const size_t fixed = arena->used;

    *buffers = (tp_frame_buffers){
        .rung_mask = tp_frame_rung_mask(program, scene, assets, config),
    };
    layout_renderers(buffers, arena, program, scene, config);
    const tp_plan_input in = tp_frame_plan_input(program, scene, assets, config);
    if (program->draw.rungs)
        program->draw.rungs->layout(buffers, arena, &in);
    const size_t placed = arena->used;
    const tp_want want = tp_frame_want(program, buffers, scene, assets, config);
    tp_frame_layout_modules(program, buffers, arena, want);
    *ram = (tp_ram_use){
        .frame = arena->used,
        .vertices = placed - fixed,
        .tables = buffers->module_bytes + sizeof frame->shade.sky,
        .mirror = buffers->map_bytes,
    };
    return frame;
}
