/* SPDX-License-Identifier: MIT */
/*
 * The water at a position, for an application between ticks: sample it and push it.
 *
 * A sample finds the surface point and its rest position, then evaluates the same rest
 * position one tick earlier for the velocity.  tp_input.push pushes within a tick.
 */
#include "base/base.h"
#include "view/wave_models.h"
#include "world/module.h"
#include "world/pools.h"

/* -- sampling ------------------------------------------------------------------------ */

/* Returns the height of all rings at `time`. */
static tp_fx sample_rings(const tp_surface *s, int64_t time, tp_fx x, tp_fx z)
{
    tp_ring_now now;
    tp_fx sum = 0;

    for (uint32_t i = 0; i < s->n_raised; i++)
        if (s->by->rings->at(&s->raised[i], time, &now))
            sum += s->by->rings->height_slope(&now, 1, x, z).height;
    return sum;
}

/* Returns the displaced surface point of a rest position. */
static tp_vec3 sample_wave_point(const tp_surface *s, const tp_fx rest[2])
{
    if (s->coastal)
        return s->by->coastal->smooth(s->coastal, s->phases, rest[0], rest[1]).position;
    if (s->by->swells)
        return tp_deep_water_displace_point(s->deep, s->phases, rest[0], rest[1]).position;
    return (tp_vec3){ rest[0], 0, rest[1] };
}

/* Returns the surface point of a rest position at `time`.  Phases and pool interpolation
 * come from `then`, set for the same time. */
static tp_vec3 sample_surface_point(const tp_surface *then, const tp_fx rest[2],
                                    int64_t time)
{
    tp_vec3 p = sample_wave_point(then, rest);
    tp_surface pools = *then;

    pools.rings = 0;
    p.y += tp_rings_pools_sample(&pools, p.x, p.z).height;
    if (then->rings)
        p.y += sample_rings(then, time, p.x, p.z);
    return p;
}

static tp_fx change_per_second(tp_fx now, tp_fx before)
{
    return tp_fx_saturate(((int64_t)now - before) * TP_TICKS_PER_SECOND);
}

tp_water tp_world_sample(const tp_program *program, const tp_world *world, tp_fx x,
                         tp_fx z)
{
    TP_ASSERT(world != NULL && world->layout.bytes > 0);
    program = tp_program_or_linked(program);
    const int64_t time = (int64_t)(world->tick * TP_FX_ONE);
    tp_surface surface = tp_world_surface(program, world);
    tp_fx rest[2] = { x, z };
    const tp_surface_point at = tp_surface_sample(&surface, x, z, rest);
    const tp_vec3 now = sample_surface_point(&surface, rest, time);
    tp_turn phases[TP_WAVES];

    tp_deep_water_phases(&world->deep, world->tick, TP_FX_ONE, phases);
    surface.phases = phases;
    surface.lag = TP_FX_ONE;
    const tp_vec3 before = sample_surface_point(&surface, rest, time - TP_FX_ONE);
    return (tp_water){
        at.position.y,
        at.slope_x,
        at.slope_z,
        { change_per_second(now.x, before.x), change_per_second(now.y, before.y),
          change_per_second(now.z, before.z) },
    };
}

/* -- pushing ------------------------------------------------------------------------- */

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

    if (!program->water.rings || scene->drops.target != TP_DROPS_RINGS || is_far(x)
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
