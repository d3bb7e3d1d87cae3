/* SPDX-License-Identifier: MIT */
/* The layout of a world's block; see the header. */
#include "scene/world_parts.h"
#include "base/base.h"
#include "geom/waters.h"

/* Returns the number of swells that the world needs memory for. */
static size_t count_swells(const tp_program *program, const tp_scene *scene)
{
    size_t count = 0;

    if (!program->water.swells || !program->water.swells->few)
        return program->water.swells ? TP_WAVES : 0;
    for (int i = 0; i < TP_WAVES; i++)
        count += scene->wave[i].amplitude > 0;
    return count;
}

tp_status tp_world_layout_measure(const tp_program *program, tp_world_layout *layout,
                           const tp_scene *scene, const tp_assets *assets, tp_error *err)
{
    tp_arena  arena = tp_arena_init(NULL, 0);
    tp_status status = tp_program_check_all(program, scene, assets, err);

    *layout = (tp_world_layout){ .version = TP_WORLD_VERSION };
    if (status != TP_OK)
        return status;
    tp_arena_alloc(&arena, 1,
                   offsetof(tp_world, deep.swell)
                       + count_swells(program, scene) * sizeof(tp_swell));
    status = tp_modules_check_and_measure(
        program, &arena, tp_world_want(program, scene, assets), &layout->modules, err);
    layout->bytes = status == TP_OK ? (uint32_t)arena.used : 0;
    return status;
}

const tp_coastal_water *tp_world_coastal(const tp_world *world)
{
    return tp_world_module_state(world, TP_COASTAL_ID);
}

tp_surface tp_world_surface(const tp_program *program, const tp_world *world)
{
    tp_surface surface = {
        .by = &program->water,
        .deep = &world->deep,
        .phases = world->phases,
    };

    tp_modules_add_surface(program, world, &surface);
    return surface;
}
