/* SPDX-License-Identifier: MIT */
/* Lets an application push the water between ticks; tp_input.push does so within a tick. */
#include "base/base.h"
#include "geom/waters.h"
#include "scene/world_parts.h"
#include "scene/pools.h"
#include "scene/program.h"

#define RING_MOST   (4 * TP_FX_ONE)  /* largest height of a ring, m */
#define RADIUS_MOST (16 * TP_FX_ONE) /* m, a quarter of the longest ring */

/* The pool lies on the field, so a push inside both moves the pool only. */
static bool push_pools(const tp_world *world, tp_fx x, tp_fx z, tp_fx radius,
                       tp_fx height)
{
    tp_pool *const pool = tp_world_mutable_pool(world), *const field =
                                                            tp_world_mutable_field(world);

    return (pool && tp_pool_add_splash(pool, x, z, radius, height))
           || (field && tp_pool_add_splash(field, x, z, radius, height));
}

static bool is_far(tp_fx x)
{
    return x < -TP_DROP_FAR || x > TP_DROP_FAR;
}

/* Converts the push to a ring.  A splash of width sigma makes the same waves as a drop
 * impact of length 4 sigma [D5].  A ring starts with a crest, whether the push goes up or
 * down. */
static bool push_open_water(const tp_program *program, tp_world *world,
                            const tp_scene *scene, tp_fx x, tp_fx z, tp_fx radius,
                            tp_fx height)
{
    const tp_impact impact = {
        .x = x,
        .z = z,
        .time = (int64_t)(world->tick * TP_FX_ONE),
        .amplitude = (tp_fx)tp_clamp_abs(height < 0 ? -(int64_t)height : height, RING_MOST),
        .length = 4 * tp_clamp(radius, 0, RADIUS_MOST),
    };
    const tp_surface surface = tp_world_surface(program, world);

    if (!program->water.rings || scene->drops.into != TP_DROPS_RINGS || is_far(x)
        || is_far(z))
        return false;
    return tp_modules_handle_impact(program, world, scene, &impact,
                                    tp_surface_sample(&surface, x, z, NULL).position.y);
}

bool tp_world_push(const tp_program *program, tp_world *world, const tp_scene *scene,
                   tp_fx x, tp_fx z, tp_fx radius, tp_fx height)
{
    TP_ASSERT(scene != NULL && world != NULL && world->layout.bytes > 0);
    if (height == 0)
        return false;
    program = tp_program_or_linked(program);
    return push_pools(world, x, z, radius, height)
           || push_open_water(program, world, scene, x, z, radius, height);
}
