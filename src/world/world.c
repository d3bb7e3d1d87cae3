/* SPDX-License-Identifier: MIT */
/*
 * The world: the moving state of a scene, advanced tick by tick, and the layout of its
 * block.  The world does not depend on drawing.
 */
#include "base/base.h"
#include "view/wave_models.h"
#include "world/light.h"
#include "world/module.h"
#include "world/world.h"

/* -- layout of the block ------------------------------------------------------------- */

/* Returns the number of swells that the world needs memory for. */
static size_t count_swell_slots(const tp_program *program, const tp_scene *scene)
{
    size_t count = 0;

    if (!program->water.swells || !program->water.swells->few)
        return program->water.swells ? TP_WAVES : 0;
    for (int i = 0; i < TP_WAVES; i++)
        count += scene->wave[i].amplitude > 0;
    return count;
}

/* Computes the layout of a scene's world and the size of the block; layout->bytes is 0 if
 * the scene is refused.  If a pool is invalid, err->word is the parameter at fault. */
static tp_status world_layout_measure(const tp_program *program, tp_world_layout *layout,
                                      const tp_scene *scene, const tp_assets *assets,
                                      tp_error *err)
{
    tp_arena  arena = tp_arena_init(NULL, 0);
    tp_status status = tp_program_check_all(program, scene, assets, err);

    *layout = (tp_world_layout){ .version = TP_WORLD_VERSION };
    if (status != TP_OK)
        return status;
    tp_arena_alloc(&arena, 1,
                   offsetof(tp_world, deep.swell)
                       + count_swell_slots(program, scene) * sizeof(tp_swell));
    status = tp_modules_check_and_measure(
        program, &arena, tp_world_module_conditions(program, scene, assets),
        &layout->modules, err);
    layout->bytes = status == TP_OK ? (uint32_t)arena.used : 0;
    return status;
}

const tp_coastal_water *tp_world_coastal(const tp_world *world)
{
    return tp_coastal_state_tables(tp_world_module_state(world, TP_COASTAL_ID));
}

const tp_coastal_water *tp_coastal_state_tables(const void *state)
{
    _Static_assert(sizeof(tp_coastal_baked) <= 8 && sizeof(tp_coastal_water) > 8,
                   "lengths tell both states apart");
    const tp_coastal_baked *baked = state;

    return state && tp_module_state_bytes(state) == 8 ? baked->tables : state;
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

#define PITCH_MOST TP_DEG(89)
#define EYE_MOST   (8000 * TP_FX_ONE)

/* -- initial state ------------------------------------------------------------------- */

/* Initialises the deep water.  In a program without swells it stays all 0, and the world's
 * block ends before the swells. */
static void make_deep_water(const tp_program *program, tp_deep_water *deep,
                            const tp_scene *scene)
{
    if (program->water.swells)
        program->water.swells->init(deep, scene->wave, TP_WAVES, scene->water.gravity);
}

size_t tp_world_bytes(const tp_program *program, const tp_scene *scene,
                      const tp_assets *assets)
{
    tp_world_layout layout;
    program = tp_program_or_linked(program);
    return world_layout_measure(program, &layout, scene, assets, NULL) == TP_OK
               ? layout.bytes
               : 0;
}

static void save_last_camera(tp_world *world)
{
    world->last_eye = world->eye;
    world->last_heading = world->heading;
    world->last_pitch = world->pitch;
    world->last_roll = world->roll;
}

static void place_camera(tp_world *world, const tp_scene *scene)
{
    world->eye = (tp_vec3){ scene->camera.x, scene->camera.y, scene->camera.z };
    world->heading = tp_turn_of_degrees(scene->camera.heading);
    world->pitch = tp_turn_of_degrees(scene->camera.pitch);
    world->roll = 0;
    save_last_camera(world);
}

static void init_deep_water_and_phases(const tp_program *program, tp_world *world,
                                       const tp_scene *scene)
{
    make_deep_water(program, &world->deep, scene);
    tp_deep_water_phases(&world->deep, world->tick, 0, world->phases);
}

static tp_status copy_world(tp_world *world, size_t bytes, const tp_baked_world *baked,
                            tp_error *err)
{
    if (bytes < baked->bytes)
        return TP_FAIL(err, TP_E_NOSPACE, 0, baked->bytes, bytes);
    memcpy(world, baked->words, baked->bytes);
    return TP_OK;
}

/* True if the program can make the deep water of any scene. */
static bool can_make_deep_water(const tp_program *program)
{
    return !program->water.swells || program->water.swells->init;
}

tp_status tp_world_init(const tp_program *program, tp_world *world, size_t bytes,
                        const tp_scene *scene, const tp_assets *assets, tp_error *err)
{
    tp_world_layout layout;
    tp_status status = tp_pointer_check_aligned(world, 8, "world", err);

    program = tp_program_or_linked(program);

    if (status == TP_OK && TP_WORLD_IS_BAKED && program->world
        && program->world->scene == scene)
        return copy_world(world, bytes, program->world, err);
    if (status == TP_OK && !can_make_deep_water(program))
        status = tp_program_fail_lacking("swells", err);
    if (status == TP_OK)
        status = world_layout_measure(program, &layout, scene, assets, err);
    if (status != TP_OK)
        return status;
    if (bytes < layout.bytes)
        return TP_FAIL(err, TP_E_NOSPACE, 0, layout.bytes, bytes);
    memset(world, 0, layout.bytes);
    world->layout = layout;
    world->random = 1;
    place_camera(world, scene);
    tp_light_init(world, scene);
    tp_clock_init(&world->clock, scene->clock.scale);
    world->clock_scale = scene->clock.scale;
    init_deep_water_and_phases(program, world, scene);
    status = tp_modules_init(program, world,
                             tp_world_module_conditions(program, scene, assets), err);
    if (status != TP_OK)
        return status;
    tp_modules_place_floating(program, world, scene);
    return TP_OK;
}

/* Recomputes the deep water and the boat's pose after each change; both take
 * microseconds. */
bool tp_world_apply(const tp_program *program, tp_world *world, const tp_scene *scene,
                    const tp_assets *assets)
{
    TP_ASSERT(world != NULL && world->layout.bytes > 0);
    program = tp_program_or_linked(program);
    const tp_module_conditions conditions =
        tp_world_module_conditions(program, scene, assets);
    tp_world_layout layout;

    if (!can_make_deep_water(program)
        || world_layout_measure(program, &layout, scene, assets, NULL) != TP_OK
        || memcmp(&layout, &world->layout, sizeof layout) != 0
        || !tp_modules_fit(program, world, conditions))
        return false;
    init_deep_water_and_phases(program, world, scene);
    tp_light_apply_scene(world, scene);
    if (world->clock_scale != scene->clock.scale)
        tp_clock_set_target(&world->clock, scene->clock.scale);
    world->clock_scale = scene->clock.scale;
    if (!tp_modules_refresh(program, world, conditions))
        return false;
    tp_modules_place_floating(program, world, scene);
    return true;
}

/* -- the camera ---------------------------------------------------------------------- */

/* Adds a tilt to the signed pitch, clamped to +-89 degrees.  Without a tilt the pitch
 * stays, even if the scene set it beyond the limit. */
static tp_turn add_tilt_clamped(tp_turn pitch, int32_t tilt)
{
    if (tilt == 0)
        return pitch;
    return (tp_turn)(int32_t)tp_clamp_abs((int64_t)(int32_t)pitch + tilt, PITCH_MOST);
}

static tp_fx clamp_eye_coordinate(int64_t x)
{
    return (tp_fx)tp_clamp_abs(x, EYE_MOST);
}

/* Moves the camera. Rounding makes a walk forth and back end at its start. */
static void move_camera(tp_world *world, const tp_input *in)
{
    world->heading += (tp_turn)in->turn;
    world->pitch = add_tilt_clamped(world->pitch, in->tilt);

    const int64_t half = 1 << 29;
    int64_t s = tp_sin(world->heading), c = tp_cos(world->heading);
    world->eye.x = clamp_eye_coordinate(
        world->eye.x + ((in->forward * s + in->strafe * c + half) >> 30));
    world->eye.z = clamp_eye_coordinate(
        world->eye.z + ((in->strafe * s - in->forward * c + half) >> 30));
    world->eye.y = clamp_eye_coordinate((int64_t)world->eye.y + in->up);
}

/* True if the eye is within the limits of move_camera; any angles are valid. */
bool tp_camera_is_valid(const tp_world *world)
{
    const tp_vec3 *eye = &world->eye, *last = &world->last_eye;

    return eye->x == clamp_eye_coordinate(eye->x)
           && eye->y == clamp_eye_coordinate(eye->y)
           && eye->z == clamp_eye_coordinate(eye->z)
           && last->x == clamp_eye_coordinate(last->x)
           && last->y == clamp_eye_coordinate(last->y)
           && last->z == clamp_eye_coordinate(last->z);
}

void tp_world_move_camera(tp_world *world, const tp_input *input)
{
    TP_ASSERT(world != NULL && input != NULL);
    move_camera(world, input);
    save_last_camera(world);                 /* no tick to interpolate from */
}

void tp_world_set_camera(tp_world *world, tp_vec3 eye, tp_turn heading, tp_turn pitch,
                         tp_turn roll)
{
    TP_ASSERT(world != NULL && world->layout.bytes > 0);
    world->eye = (tp_vec3){ clamp_eye_coordinate(eye.x), clamp_eye_coordinate(eye.y),
                            clamp_eye_coordinate(eye.z) };
    world->heading = heading;
    world->pitch = pitch;
    world->roll = roll;
    save_last_camera(world);
    if (world->aboard)
        world->aboard = TP_ABOARD_LEFT;
}

void tp_world_reset_camera(tp_world *world, const tp_scene *scene)
{
    TP_ASSERT(world != NULL && world->layout.bytes > 0 && scene != NULL);
    place_camera(world, scene);
    if (world->aboard)
        world->aboard = TP_ABOARD_DECK;
}

static void steer(tp_world *world, const tp_input *input)
{
    move_camera(world, input);
    tp_clock_shift_target(&world->clock, input->slowdown);
}

const struct tp_steering tp_world_steering = { steer };

/* True if an input moves the camera or the clock. */
static bool steers(const tp_input *in)
{
    return in->forward | in->strafe | in->up | in->turn | in->tilt | in->slowdown;
}

/* -- a tick -------------------------------------------------------------------------- */

/* Advances by one tick. Each module sees the water of the last tick; pools move last. */
const char *tp_world_step(const tp_program *program, tp_world *world,
                          const tp_scene *scene, const tp_input *input)
{
    TP_ASSERT(scene != NULL && world != NULL && world->layout.bytes > 0);

    program = tp_program_or_linked(program);
    world->tick++;
    save_last_camera(world);
    if (input && program->steering)
        program->steering->steer(world, input);
    tp_deep_water_phases(&world->deep, world->tick, 0, world->phases);
    tp_light_step(world, scene, input);
    tp_modules_step(program, world, scene, input);
    return input && !program->steering && steers(input) ? "steering" : NULL;
}

/* Returns the number of ticks needed to draw at the clock's time. */
static uint64_t ticks_needed_for_clock_time(const tp_clock *clock)
{
    return tp_clock_ticks(clock) + (tp_clock_fraction(clock) > 0);
}

uint64_t tp_world_tick(const tp_world *world)
{
    return world->tick;
}

uint32_t tp_world_advance_clock(tp_world *world)
{
    TP_ASSERT(world != NULL && world->clock.scale_q40 > 0);
    uint64_t before = ticks_needed_for_clock_time(&world->clock);
    tp_clock_advance(&world->clock);
    tp_fx part = tp_clock_fraction(&world->clock);

    world->lag = part > 0 ? TP_FX_ONE - part : 0;
    return (uint32_t)(ticks_needed_for_clock_time(&world->clock) - before);
}
