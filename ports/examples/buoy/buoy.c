/* SPDX-License-Identifier: MIT */
/* The buoy's motion: a damped spring pulls it to the water's height, and it leans with the
 * water's slope. */
#include "buoy.h"
#include "view/surface.h"
#include "world/module.h"

#define STIFFNESS 8             /* rise per tick: + 1 / 8 of the way to the water */
#define DAMPING   4             /* and - 1 / 4 of itself */
#define FOLLOW    8             /* lean per tick: 1 / 8 of the way to the slope */
#define LEAN_MOST TP_FX(0.75)
#define HEIGHT_MOST (100 * TP_FX_ONE)

bool tp_buoy_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->own[BUOY_ON] != 0;
}

static size_t bytes(const tp_module_conditions *conditions)
{
    (void)conditions;
    return sizeof(buoy_state);
}

/* Returns the pose at rest on the water: at its height, perpendicular to its surface. */
static buoy_pose sample_pose(const tp_surface *water, const tp_scene *scene)
{
    const tp_surface_point at = tp_surface_sample(water, scene->own[BUOY_X],
                                             scene->own[BUOY_Z], NULL);

    return (buoy_pose){
        .height = tp_clamp(at.position.y, -HEIGHT_MOST, HEIGHT_MOST),
        .lean_x = tp_clamp(-at.slope_x, -LEAN_MOST, LEAN_MOST),
        .lean_z = tp_clamp(-at.slope_z, -LEAN_MOST, LEAN_MOST),
    };
}

/* Places the buoy on the water once; later changes of parameters keep its pose. */
static void settle(void *mine, const tp_program *program, tp_world *world,
                   const tp_scene *scene)
{
    const tp_surface water = tp_world_surface(program, world);
    buoy_state *buoy = mine;

    if (!buoy->afloat)
        buoy->now = buoy->last = sample_pose(&water, scene);
    buoy->afloat = 1;
}

static void step(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *input)
{
    const tp_surface water = tp_world_surface(program, world);
    const buoy_pose  to = sample_pose(&water, scene);
    buoy_state *buoy = mine;

    (void)input;
    buoy->last = buoy->now;
    buoy->rise += (to.height - buoy->now.height) / STIFFNESS - buoy->rise / DAMPING;
    buoy->now.height += buoy->rise;
    buoy->now.lean_x += (to.lean_x - buoy->now.lean_x) / FOLLOW;
    buoy->now.lean_z += (to.lean_z - buoy->now.lean_z) / FOLLOW;
}

static bool is_pose(const buoy_pose *pose)
{
    return tp_abs(pose->height) <= 2 * HEIGHT_MOST && tp_abs(pose->lean_x) <= LEAN_MOST
        && tp_abs(pose->lean_z) <= LEAN_MOST;
}

static bool is_valid(const void *mine, const void *fresh, const tp_world *world)
{
    (void)world;
    const buoy_state *buoy = mine;

    (void)fresh, (void)world;
    return is_pose(&buoy->now) && is_pose(&buoy->last)
        && tp_abs(buoy->rise) <= HEIGHT_MOST && buoy->afloat == 1;
}

const tp_module tp_buoy_module = {
    .name = "buoy", .id = BUOY_ID, .is = TP_MODULE_SOLID, .enabled = tp_buoy_enabled,
    .bytes = bytes, .settle = settle, .step = step, .is_valid = is_valid,
};
