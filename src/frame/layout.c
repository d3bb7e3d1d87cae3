/* SPDX-License-Identifier: MIT */
/* Memory layout of a frame: one block, laid out at init as the scene demands.  Nothing is
 * allocated later. */
#include "frame/frame.h"
#include "geom/waters.h"
#include "scene/prices.h"

/* Lays out the memory of the plan's possible water renderers, and of the grid LOD. */
static void carve_water_renderers(tp_frame_parts *p, tp_arena *arena,
                                  const tp_program *program, const tp_scene *scene,
                                  const tp_config *config)
{
    TP_ASSERT(scene->grid.cols >= 2 && scene->grid.rows >= 2);

    for (int v = TP_VISIBILITY_TRIANGLES; v <= TP_VISIBILITY_FLAT; v++) {
        const struct tp_method *method = tp_frame_method(program, (tp_visibility)v);
        if (p->reach.visibility >> v & 1 && method)
            method->carve(p, arena, program, scene, config);
    }
    if (p->reach.lod >> TP_LOD_ON & 1 && program->water.lod && program->method.triangles)
        program->water.lod->carve(p->grid, arena);
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
    const struct tp_method *method = program->method.triangles;
    return method && method->streams && !tp_frame_is_coastal(program, scene);
}

/* Returns the conditions for asking modules. */
tp_want tp_frame_want(const tp_program *program, const tp_frame_parts *parts,
                      const tp_scene *scene, const tp_assets *assets,
                      const tp_config *config)
{
    return (tp_want){
        .scene = scene,
        .assets = assets,
        .water = &program->water,
        .width = config->width,
        .height = config->height,
        .shadings = parts->reach.shading,
    };
}

tp_plan_input tp_frame_plan_input(const tp_program *program, const tp_scene *scene,
                                  const tp_assets *assets, const tp_config *config)
{
    return (tp_plan_input){ program->modules, scene, assets, config->width,
                            config->height };
}

tp_frame *tp_frame_carve(const tp_program *program, tp_frame_parts *parts,
                         tp_ram_use *ram, tp_arena *arena, const tp_scene *scene,
                         tp_assets *assets, const tp_config *config)
{
    tp_frame *frame = tp_arena_alloc(arena, 1, sizeof *frame);
    const size_t fixed = arena->used;

    *parts = (tp_frame_parts){
        .reach = tp_frame_rung_mask(program, scene, assets, config),
    };
    carve_water_renderers(parts, arena, program, scene, config);
    const tp_plan_input in = tp_frame_plan_input(program, scene, assets, config);
    if (program->draw.rungs)
        program->draw.rungs->carve(parts, arena, &in);
    const size_t placed = arena->used;
    const tp_want want = tp_frame_want(program, parts, scene, assets, config);
    tp_frame_layout_modules(program, parts, arena, want);
    *ram = (tp_ram_use){
        .frame = arena->used,
        .vertices = placed - fixed,
        .tables = parts->module_bytes + sizeof frame->shade.sky,
        .mirror = parts->look_bytes,
    };
    return frame;
}
