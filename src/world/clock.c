/* SPDX-License-Identifier: MIT */
/*
 * The time of a frame: the slow-motion clock, [D6] of the models, and the state of the
 * world between its last two ticks.
 *
 * Each frame moves the scale towards its target by the share 1 - exp(-1/24) of the
 * remaining distance.  The scale has 40 fraction bits, so small steps are not lost.  A
 * remaining distance below 2 LSB of Q16.16 is covered in a single step.
 *
 * A camera on the boat's deck keeps its place on the deck and heaves, turns, pitches and
 * rolls with the boat.
 */
#include <stdbool.h>
#include "base/base.h"
#include "fixed/arithmetic.h"
#include "world/module.h"
#include "world/world.h"

/* -- the clock ----------------------------------------------------------------------- */

#define ONE_Q40   ((int64_t)1 << 40)
#define SLIDE_Q32 ((int64_t)175279947)      /* 1 - exp(-dt / tau), dt / tau = 1/24 */
#define SNAP_Q40  ((int64_t)2 << 24)        /* 2 LSB of 16.16 */

static int64_t fx_to_q40(tp_fx x)
{
    return (int64_t)x * (1 << 24);
}

static tp_fx clamp_scale(tp_fx scale)
{
    return tp_clamp(scale, TP_CLOCK_SLOWEST, TP_CLOCK_FASTEST);
}

void tp_clock_init(tp_clock *clock, tp_fx scale)
{
    *clock = (tp_clock){ .scale_q40 = fx_to_q40(clamp_scale(scale)),
                         .target = clamp_scale(scale) };
}

void tp_clock_set_target(tp_clock *clock, tp_fx target)
{
    clock->target = clamp_scale(target);
}

void tp_clock_shift_target(tp_clock *clock, int32_t halvings)
{
    tp_fx target = clock->target;

    for (; halvings > 0 && target > TP_CLOCK_SLOWEST; halvings--)
        target /= 2;
    for (; halvings < 0 && target < TP_CLOCK_FASTEST; halvings++)
        target *= 2;
    tp_clock_set_target(clock, target);
}

bool tp_clock_is_valid(const tp_clock *clock)
{
    return clock->scale_q40 >= fx_to_q40(TP_CLOCK_SLOWEST)
        && clock->scale_q40 <= fx_to_q40(TP_CLOCK_FASTEST)
        && clock->fraction_q40 >= 0 && clock->fraction_q40 < ONE_Q40
        && clock->target == clamp_scale(clock->target) && clock->zero == 0;
}

/* The distance from the scale to its target is below 2^42 in Q40, and SLIDE_Q32 is below
 * 2^28.  The distance is shifted to Q28 first, so the product stays below 2^58. */
void tp_clock_advance(tp_clock *clock)
{
    TP_ASSERT(clock->scale_q40 > 0 && clock->fraction_q40 >= 0
              && clock->fraction_q40 < ONE_Q40);
    int64_t way = fx_to_q40(clock->target) - clock->scale_q40;

    if (way < SNAP_Q40 && way > -SNAP_Q40)
        clock->scale_q40 += way;
    else
        clock->scale_q40 += (((way + (1 << 11)) >> 12) * SLIDE_Q32 + (1 << 19)) >> 20;
    clock->fraction_q40 += clock->scale_q40;
    clock->ticks += (uint64_t)(clock->fraction_q40 >> 40);
    clock->fraction_q40 &= ONE_Q40 - 1;
}

tp_fx tp_clock_scale(const tp_clock *clock)
{
    return (tp_fx)((clock->scale_q40 + (1 << 23)) >> 24);
}

uint64_t tp_clock_ticks(const tp_clock *clock)
{
    return clock->ticks;
}

tp_fx tp_clock_fraction(const tp_clock *clock)
{
    return (tp_fx)(clock->fraction_q40 >> 24);
}

/* -- between two ticks --------------------------------------------------------------- */

/* Interpolates from b to a along the shorter arc. */
static tp_turn interpolate_turn(tp_turn last, tp_turn now, tp_fx lag)
{
    return now + (tp_turn)((int64_t)(int32_t)(last - now) * lag >> 16);
}

static tp_pose interpolate_pose(const tp_pose *last, const tp_pose *now, tp_fx lag)
{
    return (tp_pose){
        tp_position_interpolate(last->place, now->place, lag),
        interpolate_turn(last->heading, now->heading, lag),
        interpolate_turn(last->pitch, now->pitch, lag),
        interpolate_turn(last->roll, now->roll, lag),
    };
}

/* Transforms a camera from deck axes, the axes of the mesh, to world axes.  The camera is
 * at most 14 km from the boat; its position is clamped to 8000 m, the limit of any
 * camera. */
static tp_camera deck_to_world_camera(const tp_camera *deck, const tp_pose *boat)
{
    const tp_rotation turn =
        tp_rotation_from_angles(boat->heading, boat->pitch, boat->roll);
    const tp_vec3 offset = tp_rotate_back(&turn, deck->eye);
    const tp_fx most = 8000 * TP_FX_ONE;

    return (tp_camera){
        { (tp_fx)tp_clamp_abs((int64_t)boat->place.x + offset.x, most),
          (tp_fx)tp_clamp_abs((int64_t)boat->place.y + offset.y, most),
          (tp_fx)tp_clamp_abs((int64_t)boat->place.z + offset.z, most) },
        tp_rotation_mul(&deck->turn, &turn),
    };
}

/* Returns the camera in its own axes: the world's, or those of the deck. */
static tp_camera own_camera(const tp_world *world, tp_fx lag)
{
    TP_ASSERT(lag >= 0 && lag <= TP_FX_ONE);
    const tp_turn heading = interpolate_turn(world->last_heading, world->heading, lag);
    const tp_turn pitch = interpolate_turn(world->last_pitch, world->pitch, lag);
    const tp_turn roll = interpolate_turn(world->last_roll, world->roll, lag);

    return (tp_camera){ tp_position_interpolate(world->last_eye, world->eye, lag),
                        tp_rotation_from_angles(heading, pitch, roll) };
}

void tp_camera_carry(const tp_world *world, tp_fx lag, tp_camera *camera)
{
    const tp_pose boat = interpolate_pose(&world->last_boat, &world->boat, lag);

    if (world->aboard == TP_ABOARD_DECK)
        *camera = deck_to_world_camera(camera, &boat);
}

tp_camera tp_camera_interpolate(const tp_world *world, tp_fx lag)
{
    tp_camera camera = own_camera(world, lag);

    tp_camera_carry(world, lag, &camera);
    return camera;
}

tp_camera tp_world_camera(const tp_world *world)
{
    return tp_camera_interpolate(world, world->lag);
}

static tp_drawn interpolate(const tp_world *world, const tp_camera *camera)
{
    tp_fx    lag = world->lag;
    tp_drawn at = {
        .camera = *camera,
        .boat = interpolate_pose(&world->last_boat, &world->boat, lag),
        .light_heading = interpolate_turn(world->last_light_heading, world->light_heading,
                                      lag),
        .light_elevation = interpolate_turn(world->last_light_elevation,
                                        world->light_elevation, lag),
        .exposure = tp_interpolate(world->last_exposure, world->exposure, lag),
        .time = (int64_t)(world->tick * TP_FX_ONE) - lag,
    };

    tp_deep_water_phases(&world->deep, world->tick, lag, at.phases);
    return at;
}

tp_drawn tp_world_interpolate(const tp_world *world)
{
    const tp_camera camera = tp_world_camera(world);
    return interpolate(world, &camera);
}

tp_drawn tp_program_interpolate(const tp_program *program, const tp_world *world)
{
    tp_camera camera = own_camera(world, world->lag);

    for (const tp_use *u = program->modules; u && u->module; u++)
        if (u->module->carry)
            u->module->carry(world, world->lag, &camera);
    return interpolate(world, &camera);
}
