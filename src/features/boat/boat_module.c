/* SPDX-License-Identifier: MIT */
/*
 * A boat that sails on the surface, [E1] and [E2].  The boat moves in the direction of
 * its bow.  Its attitude follows the water height at four points of the hull (see
 * buoyancy.c).  Points half a boat apart filter out waves shorter than the boat, as a
 * real hull does.
 *
 * The plane through the four points rises by `rise` over the length and falls by `tilt`
 * over the beam to starboard.  Roll is about the boat's own axis, after pitch.  The
 * plane's normal is (fall ahead, fall aside, 1).  Its component along the level starboard
 * direction, divided by its component along the pitched mast, is
 * tilt / beam x cos(pitch).
 */
#include "features/boat/boat.h"
#include "view/wave_models.h"
#include "world/module.h"
#include "world/pools.h"

#define PLACE_MOST ((int64_t)8000 << 32)
#define SPEED_MOST (100 * TP_FX_ONE)        /* m/s */
#define TURN_MOST  (360 * TP_FX_ONE)        /* degrees/s */
#define WATER_MOST (2048 * TP_FX_ONE)

/* -- position ------------------------------------------------------------------------ */

/* Clamps `sailed`, the distance sailed from the scene's start position, in one axis.  The
 * boat stays within 8 km of the origin.  In a tank the boat also stays between the walls
 * `low` and `high`, half a boat length clear of each, at any heading.  If the walls are
 * closer together than the boat is long, the boat lies in the middle. */
static int64_t clamp_sailed_distance(int64_t sailed, tp_fx start_place,
                                     const tp_scene *scene, tp_fx low, tp_fx high)
{
    int64_t start = (int64_t)start_place * TP_FX_ONE;
    int64_t at = tp_clamp_abs(start + sailed, PLACE_MOST);
    int64_t middle = ((int64_t)low + high) * (TP_FX_ONE / 2);
    int64_t room = ((int64_t)high - low - scene->boat.length) * (TP_FX_ONE / 2);

    if (tp_has_tank(scene))
        at = middle + tp_clamp_abs(at - middle, room > 0 ? room : 0);
    return at - start;
}

static tp_fx sailed_coordinate(int64_t sailed, tp_fx start_place)
{
    int64_t at = tp_clamp_abs((int64_t)start_place * TP_FX_ONE + sailed, PLACE_MOST);
    return (tp_fx)((at + 0x8000) >> 16);
}

static tp_turn boat_heading(const tp_boat_state *boat_state, const tp_scene *scene)
{
    return tp_turn_of_degrees(scene->boat.heading)
           + (tp_turn)((boat_state->turned + 0x80000000u) >> 32);
}

/* Advances heading and position by one tick.
 *
 * Speed in m/s (Q16.16) times a sine (Q30), over 60 ticks, is Q32 after a shift by 14
 * bits; |speed| <= 2^23 keeps the product below 2^53.  One degree/s in Q16.16 is
 * 2^48 / (360 x 60) of a turn per tick in Q64; 360 degrees/s are below 2^59.  Quotients
 * round symmetrically: sailing forth and back by the same way sums to exactly 0. */
static void sail(tp_boat_state *boat_state, const tp_scene *scene, const tp_input *in)
{
    const int64_t over = TP_TICKS_PER_SECOND << 14, degree = 13031248922;
    const tp_fx rudder = in ? in->rudder : 0, throttle = in ? in->throttle : 0;
    int64_t turn = tp_clamp_abs((int64_t)scene->boat.rudder + rudder, TURN_MOST);
    int64_t speed = tp_clamp_abs((int64_t)scene->boat.speed + throttle, SPEED_MOST);

    boat_state->turned += (uint64_t)(turn * degree);
    tp_turn heading = boat_heading(boat_state, scene);
    int64_t x = tp_div_rounded(speed * tp_sin(heading), over);
    int64_t z = tp_div_rounded(speed * tp_cos(heading), over);
    tp_rectangle r = tp_pool_sides(scene);
    boat_state->sailed_x =
        clamp_sailed_distance(boat_state->sailed_x + x, scene->boat.x, scene, r.x0, r.x1);
    boat_state->sailed_z =
        clamp_sailed_distance(boat_state->sailed_z - z, scene->boat.z, scene, r.z0, r.z1);
}

static void update_hull_position(tp_boat_state *boat_state, const tp_scene *scene)
{
    boat_state->hull.x = sailed_coordinate(boat_state->sailed_x, scene->boat.x);
    boat_state->hull.z = sailed_coordinate(boat_state->sailed_z, scene->boat.z);
    boat_state->hull.heading = boat_heading(boat_state, scene);
}

/* -- attitude ------------------------------------------------------------------------ */

static void hull_points(const tp_hull *hull, const tp_scene *scene, tp_fx points[4][2])
{
    tp_fx  length = scene->boat.length / 2, beam = scene->boat.beam / 2;
    const tp_fx ahead[4] = { length, -length, 0, 0 }, aside[4] = { 0, 0, -beam, beam };
    tp_q30 s = tp_sin(hull->heading), c = tp_cos(hull->heading);

    for (int i = 0; i < 4; i++) {
        points[i][0] = hull->x + tp_q30_mul(ahead[i], s) + tp_q30_mul(aside[i], c);
        points[i][1] = hull->z - tp_q30_mul(ahead[i], c) + tp_q30_mul(aside[i], s);
    }
}

/* Water heights under the four hull points: `all` of the whole surface, `without_pool`
 * without the pool stirred by the boat. */
typedef struct { tp_fx all[4], without_pool[4]; } waters;

/* Samples the water at the four hull points.  Each search starts at the rest point found
 * in the last tick. */
static waters sample_hull_water(const tp_program *program, tp_world *world,
                                tp_fx points[4][2])
{
    const tp_surface surface = tp_world_surface(program, world);
    const tp_pool *stirred = program->water.pools ? tp_boat_pool(world) : NULL;
    const tp_pool_kind *kind = stirred ? tp_models_pool_kind(&program->water, stirred) : NULL;
    waters w;

    for (int i = 0; i < 4; i++) {
        tp_fx x = points[i][0], z = points[i][1];
        tp_surface_point at =
            tp_surface_sample(&surface, x, z, world->boat_state.rest[i]);
        tp_fx high =
            kind ? program->water.pools->height_slope(stirred, kind, x, z, 0).height : 0;
        w.all[i] = tp_clamp(at.position.y, -WATER_MOST, WATER_MOST);
        w.without_pool[i] = tp_clamp(at.position.y - high, -WATER_MOST, WATER_MOST);
    }
    return w;
}

/* Sets the world's boat pose.  cos(pitch) <= 1, so the tilt keeps its range, below 2^29. */
static void update_boat_pose(tp_world *world, const tp_scene *scene)
{
    const tp_boat_state *a = &world->boat_state;
    tp_turn pitch = tp_atan2(tp_fx_of_q40(a->attitude.at[1]), scene->boat.length);
    tp_fx   tilt = tp_q30_mul(tp_fx_of_q40(a->attitude.at[2]), tp_cos(pitch));

    world->boat = (tp_pose){
        { a->hull.x, tp_fx_of_q40(a->attitude.at[0]) + scene->boat.lift, a->hull.z },
        a->hull.heading, pitch, tp_atan2(tilt, scene->boat.beam),
    };
}

/* ----------------------------------------------------------------------------------- */

static bool needs_attitude_reset(const tp_boat_state *boat_state, const tp_scene *scene)
{
    return !boat_state->placed
           || (scene->boat.mode == TP_BOAT_KINEMATIC && scene->boat.smooth <= 0);
}

void tp_boat_place_on_water(const tp_program *program, tp_world *world,
                            const tp_scene *scene)
{
    TP_ASSERT(scene->boat.length > 0 && scene->boat.beam > 0);
    tp_boat_state *a = &world->boat_state;
    tp_fx points[4][2];

    update_hull_position(a, scene);
    hull_points(&a->hull, scene, points);
    for (int i = 0; i < 4; i++) {
        a->rest[i][0] = points[i][0];
        a->rest[i][1] = points[i][1];
    }
    const waters w = sample_hull_water(program, world, points);
    if (needs_attitude_reset(a, scene)) {
        tp_boat_snap_attitude(&a->attitude, w.all);
        tp_boat_snap_attitude(&a->without_pool, w.without_pool);
    }
    a->placed = 1;
    tp_boat_set_immersion(&a->hull, &a->without_pool, w.without_pool);
    a->wake_hull = a->hull;
    update_boat_pose(world, scene);
}

void tp_boat_step(const tp_program *program, tp_world *world, const tp_scene *scene,
                  const tp_input *input)
{
    tp_boat_state *a = &world->boat_state;
    tp_fx points[4][2];

    sail(a, scene, input);
    update_hull_position(a, scene);
    hull_points(&a->hull, scene, points);
    const waters w = sample_hull_water(program, world, points);
    tp_boat_step_attitude(&a->attitude, scene, w.all);
    tp_boat_step_attitude(&a->without_pool, scene, w.without_pool);
    tp_boat_set_immersion(&a->hull, &a->without_pool, w.without_pool);
    update_boat_pose(world, scene);
}

/* -- validation of a state from outside ---------------------------------------------- */

#define REST_MOST (16000 * TP_FX_ONE)       /* m: plus half a boat and a displacement */
static bool is_magnitude_within(int64_t x, int64_t limit)
{
    return x >= -limit && x <= limit;
}

static bool is_coordinate_valid(tp_fx x)
{
    return is_magnitude_within(x, PLACE_MOST >> 16);
}

static bool is_pose_place_valid(const tp_pose *pose)
{
    return is_coordinate_valid(pose->place.x) && is_coordinate_valid(pose->place.y)
           && is_coordinate_valid(pose->place.z);
}

static bool is_hull_valid(const tp_hull *hull)
{
    return is_coordinate_valid(hull->x) && is_coordinate_valid(hull->z)
           && tp_boat_immersion_is_valid(hull);
}

/* True if the boat of a world from outside is in the ranges kept by tp_boat_step. */
static bool is_boat_valid(const tp_world *world)
{
    const tp_boat_state *a = &world->boat_state;
    bool valid = is_magnitude_within(a->sailed_x, 2 * PLACE_MOST)
                 && is_magnitude_within(a->sailed_z, 2 * PLACE_MOST)
                 && tp_boat_attitude_is_valid(&a->attitude)
                 && tp_boat_attitude_is_valid(&a->without_pool) && is_hull_valid(&a->hull)
                 && is_hull_valid(&a->wake_hull) && is_pose_place_valid(&world->boat)
                 && is_pose_place_valid(&world->last_boat);

    for (int i = 0; i < 4; i++)
        valid = valid && is_magnitude_within(a->rest[i][0], REST_MOST)
                && is_magnitude_within(a->rest[i][1], REST_MOST);
    return valid;
}

/* -- the module ---------------------------------------------------------------------- */

/* True if the scene names a boat.  Without a boat no water is sampled and the camera
 * stands in the world. */
static bool has_boat(const tp_scene *scene)
{
    return scene->boat.mesh[0] != '\0';
}

bool tp_hull_enabled(const tp_module_conditions *conditions)
{
    return has_boat(conditions->scene);
}

/* Sets the camera's place for the scene.  A camera that has left the deck stays off the
 * deck as long as the scene's camera follows the boat. */
static void set_camera_aboard(tp_world *world, bool follows)
{
    if (!follows)
        world->aboard = TP_ABOARD_NOT;
    else if (world->aboard == TP_ABOARD_NOT)
        world->aboard = TP_ABOARD_DECK;
}

static void place_floating(void *mine, const tp_program *program, tp_world *world,
                           const tp_scene *scene)
{
    (void)mine;
    if (has_boat(scene))
        tp_boat_place_on_water(program, world, scene);
    world->last_boat = world->boat;
    set_camera_aboard(world, has_boat(scene) && scene->camera.follow == TP_FOLLOW_BOAT);
}

static void step(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *input)
{
    (void)mine;
    world->last_boat = world->boat;
    if (has_boat(scene))
        tp_boat_step(program, world, scene, input);
}

static bool is_valid(const void *mine, const void *fresh, const tp_world *world)
{
    (void)mine, (void)fresh;
    return is_boat_valid(world);
}

const tp_module tp_hull_module = {
    .name = "hull", .id = TP_MODULE_ID('h', 'u', 'l', 'l'), .is = TP_MODULE_SAMPLES,
    .enabled = tp_hull_enabled,
    .settle = place_floating, .step = step, .carry = tp_camera_carry, .is_valid = is_valid,
};

/* -- the module of the drawn boat ---------------------------------------------------- */

bool tp_boat_enabled(const tp_module_conditions *conditions)
{
    return conditions->assets && conditions->assets->boat;
}

const tp_module tp_boat_module = {
    .name = "boat",
    .id = TP_BOAT_ID,
    .enabled = tp_boat_enabled,
    .is = TP_MODULE_SOLID | TP_MODULE_DRAWS(OBJECT),
};
