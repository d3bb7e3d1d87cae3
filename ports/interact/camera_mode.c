/* SPDX-License-Identifier: MIT */
/* Camera modes, implemented by changing the input.
 *
 * tp_world_step first turns and tilts the camera, then moves it forward and sideways
 * along the new heading.  So one input can reach any position and direction: with (dx,
 * dz) the way to go, s and c the sine and cosine of the new heading,
 *     forward = (dx s - dz c) / (s^2 + c^2),  strafe = (dx c + dz s) / (s^2 + c^2),
 * exact within 1 LSB of Q16.16, whatever the error of the tables in s^2 + c^2 = 1.  In
 * the modes orbit and top the camera's position follows from the target, the distance
 * and the direction.  Each input leads there from the current camera pose: an error of a
 * tick does not persist, and a world made anew in between does no harm.
 *
 * On the deck the camera moves freely in the deck's axes: the mode sets its first pose
 * only.  The mode free restores the pose where the camera was free last. */
#include "camera_mode.h"
#include "tidepool/modules.h"
#include "world/world.h"

#define PITCH_MOST  TP_DEG(89)
#define PLACE_MOST  (8000 * TP_FX_ONE)
#define AWAY_LEAST  TP_FX_ONE
#define AWAY_MOST   (4000 * TP_FX_ONE)

/* Upper limit of the orbit's radius: 25 m plus 4 times the height of the eye. */
#define AHEAD_MOST  (25 * TP_FX_ONE)
/* A step of input is scaled by distance / 16 m, if the distance exceeds 16 m. */
#define AWAY_USUAL  16

/* Camera on deck, as fractions of the boat's length, the only size of a boat known in
 * metres.  For a boat of 15 m: 7.5 m abaft the middle, 3.4 m high, looking over the bow
 * below the sail. */
#define DECK_Y      TP_FX(3.4 / 15)
#define DECK_Z      TP_FX(7.5 / 15)
#define DECK_PITCH  TP_DEG(-6)

/* Pitch of the orbit around the boat, when entered from its deck. */
#define ROUND_PITCH TP_DEG(-15)

const char *camera_mode_name(camera_mode_kind mode)
{
    static const char *const names[CAMERA_MODES] = { "free", "orbit", "top", "boat" };
    return mode < CAMERA_MODES ? names[mode] : "";
}

tp_camera_follow camera_mode_follow(const camera_mode *l, const tp_scene *filed)
{
    return l->mode == CAMERA_BOAT ? TP_FOLLOW_BOAT
         : l->mode == CAMERA_FREE ? (tp_camera_follow)filed->camera.follow : TP_FOLLOW_NONE;
}

/* -- target -------------------------------------------------------------------------- */

static tp_fx held(int64_t x, int64_t most)
{
    return (tp_fx)tp_clamp_abs(x, most);
}

/* Returns the point at signed distance `far` m (Q16.16) from `from` along `back`;
 * negative = ahead. */
static tp_vec3 along(tp_vec3 from, tp_dir3 back, int64_t far)
{
    const tp_fx by = held(far, PLACE_MOST);

    return (tp_vec3){ tp_fx_add_sat(from.x, tp_q30_mul(by, back.x)),
                      tp_fx_add_sat(from.y, tp_q30_mul(by, back.y)),
                      tp_fx_add_sat(from.z, tp_q30_mul(by, back.z)) };
}

/* Returns the distance of a point ahead of the camera, m; each product is at most 2^61. */
static int64_t forward_distance(const tp_camera *camera, tp_vec3 place)
{
    const tp_dir3 *back = &camera->turn.z;
    const int64_t x = (int64_t)place.x - camera->eye.x;
    const int64_t y = (int64_t)place.y - camera->eye.y;
    const int64_t z = (int64_t)place.z - camera->eye.z;

    return -((x * back->x >> 30) + (y * back->y >> 30) + (z * back->z >> 30));
}

/* True if the boat is in the middle of the picture: within 12 degrees, and nearer than
 * 200 m. *far: its distance ahead, m. */
static bool sees_boat(const tp_camera *camera, const tp_world *world,
                      const tp_scene *scene, int64_t *far)
{
    if (!scene->boat.mesh[0])
        return false;
    *far = forward_distance(camera, world->boat.place);
    const tp_vec3 foot = along(camera->eye, camera->turn.z, -*far);
    const int64_t off = tp_vec3_length((tp_vec3){
        tp_fx_sub_sat(world->boat.place.x, foot.x),
        tp_fx_sub_sat(world->boat.place.y, foot.y),
        tp_fx_sub_sat(world->boat.place.z, foot.z) });
    return *far > 0 && *far < 200 * TP_FX_ONE && off * 5 < *far;
}

/* Returns the distance of the target ahead, m: the boat, the water, or the limit if
 * neither is near. */
static int64_t aim(camera_mode *l, const tp_camera *camera, const tp_world *world,
                   const tp_scene *scene)
{
    const uint32_t side = 512;
    const tp_fx middle = 256 * TP_FX_ONE;
    const int64_t most = AHEAD_MOST + 4 * (int64_t)tp_abs(camera->eye.y);
    int64_t far;
    tp_vec3 at;

    l->with_boat = sees_boat(camera, world, scene, &far);
    l->boat_x = world->boat.place.x;
    l->boat_z = world->boat.place.z;
    if (l->with_boat)
        return far;
    if (tp_world_pick(&tp_program_all, world, scene, side, side, middle, middle, &at))
        far = forward_distance(camera, at);
    else
        far = most;
    return far < most ? far : most;
}

/* Sets heading and pitch of the camera in world axes, on deck too. */
static void face(camera_mode *l, const tp_camera *camera, const tp_world *world)
{
    const tp_dir3 *back = &camera->turn.z;
    const int64_t level = (int64_t)back->x * back->x + (int64_t)back->z * back->z;

    l->heading = world->heading;
    l->pitch = world->pitch;
    if (world->aboard == TP_ABOARD_DECK) {
        l->heading = tp_atan2(-back->x, back->z);
        l->pitch = tp_atan2(-back->y, (int32_t)tp_isqrt64((uint64_t)level));
    }
}

/* Entering orbit or top from the deck: the target is the boat. */
static void leave_deck(camera_mode *l, const tp_world *world, const tp_scene *scene)
{
    l->with_boat = true;
    l->about = world->boat.place;
    l->away = tp_clamp(scene->boat.length * 2, AWAY_LEAST, AWAY_MOST);
    l->pitch = ROUND_PITCH;
}

static void begin_orbit(camera_mode *l, const tp_world *world, const tp_scene *scene)
{
    const tp_camera camera = tp_world_camera(world);
    const int64_t far = aim(l, &camera, world, scene);

    face(l, &camera, world);
    l->about = along(camera.eye, camera.turn.z, -far);
    l->away = tp_clamp((int32_t)tp_clamp_abs(far, AWAY_MOST), AWAY_LEAST, AWAY_MOST);
    if (world->aboard == TP_ABOARD_DECK)
        leave_deck(l, world, scene);
    if (l->mode == CAMERA_TOP) {
        l->about.y = 0;
        l->pitch = (tp_turn)-PITCH_MOST;
    }
}

/* -- modes --------------------------------------------------------------------------- */

static void begin_first_person(camera_mode *l, tp_vec3 eye, tp_turn heading, tp_turn pitch)
{
    l->about = eye;
    l->away = 0;
    l->heading = heading;
    l->pitch = pitch;
    l->with_boat = false;
}

bool camera_mode_begin(camera_mode *l, camera_mode_kind mode, const tp_world *world,
                       const tp_scene *scene)
{
    const tp_fx length = scene->boat.length;

    if (mode >= CAMERA_MODES || (mode == CAMERA_BOAT && !scene->boat.mesh[0]))
        return false;
    if (mode == CAMERA_FREE && l->mode == CAMERA_FREE)
        return true;
    if (l->mode == CAMERA_FREE) {
        l->free_eye = world->eye;
        l->free_heading = world->heading;
        l->free_pitch = world->pitch;
    }
    l->mode = mode;
    l->jump = true;
    if (mode == CAMERA_FREE)
        begin_first_person(l, l->free_eye, l->free_heading, l->free_pitch);
    else if (mode == CAMERA_BOAT)
        begin_first_person(
            l, (tp_vec3){ 0, tp_fx_mul(length, DECK_Y), tp_fx_mul(length, DECK_Z) }, 0,
            DECK_PITCH);
    else
        begin_orbit(l, world, scene);
    return true;
}

/* Scales a step by the distance; the result is at most 32768 m. */
static int64_t scaled(const camera_mode *l, tp_fx step)
{
    const int64_t by = l->away / AWAY_USUAL;
    return by > TP_FX_ONE ? tp_clamp_abs(step * by >> 16, TP_FX_MAX) : step;
}

static void go_away(camera_mode *l, int64_t by, tp_fx near)
{
    const int64_t least = near > AWAY_LEAST / 2 ? 2 * (int64_t)near : AWAY_LEAST;
    const int64_t away = l->away + by;

    l->away = (tp_fx)(away > AWAY_MOST ? AWAY_MOST : away < least ? least : away);
}

/* Orbit.  A sideways step of d m turns by d / distance radians; a radian is 2^32 / 2 pi. */
static void go_round(camera_mode *l, const tp_scene *scene, const tp_input *input)
{
    const int64_t radian = 683565276;
    const int64_t aside = scaled(l, input->strafe) * radian / l->away;

    l->heading += (tp_turn)input->turn - (tp_turn)aside;
    l->pitch = (tp_turn)(int32_t)tp_clamp_abs((int64_t)(int32_t)l->pitch + input->tilt,
                                              PITCH_MOST);
    l->about.y = held(l->about.y + scaled(l, input->up), PLACE_MOST);
    go_away(l, -scaled(l, input->forward), scene->camera.near);
}

static void glide(camera_mode *l, const tp_scene *scene, const tp_input *input)
{
    const int64_t ahead = scaled(l, input->forward), aside = scaled(l, input->strafe);

    l->heading += (tp_turn)input->turn;
    const int64_t s = tp_sin(l->heading), c = tp_cos(l->heading);
    l->about.x = held(l->about.x + ((ahead * s + aside * c) >> 30), PLACE_MOST);
    l->about.z = held(l->about.z + ((aside * s - ahead * c) >> 30), PLACE_MOST);
    go_away(l, scaled(l, input->up), scene->camera.near);
}

/* Moves the target with the boat in x and z; heave is not followed. */
static void go_with_boat(camera_mode *l, const tp_world *world, const tp_scene *scene)
{
    const tp_vec3 *boat = &world->boat.place;

    if (!l->with_boat || !scene->boat.mesh[0])
        return;
    l->about.x = held((int64_t)l->about.x + boat->x - l->boat_x, PLACE_MOST);
    l->about.z = held((int64_t)l->about.z + boat->z - l->boat_z, PLACE_MOST);
    l->boat_x = boat->x;
    l->boat_z = boat->z;
}

/* Writes the input that moves the world's camera to the mode's pose within this tick.
 * Differences of positions are below 2^30, sines at most 2^30 (Q2.30).  `one` is
 * sin^2 + cos^2, about 2^30; the division removes the error of the table's sines. */
static void lead(const camera_mode *l, const tp_world *world, tp_input *input)
{
    const tp_rotation turn = tp_rotation_from_angles(l->heading, l->pitch, 0);
    const tp_vec3 eye = along(l->about, turn.z, l->away);
    const int64_t dx = (int64_t)held(eye.x, PLACE_MOST) - world->eye.x;
    const int64_t dz = (int64_t)held(eye.z, PLACE_MOST) - world->eye.z;
    const int64_t s = tp_sin(l->heading), c = tp_cos(l->heading);
    const int64_t one = (s * s + c * c) >> 30;

    input->turn = (int32_t)(l->heading - world->heading);
    input->tilt = (int32_t)(l->pitch - world->pitch);
    input->forward = tp_fx_saturate(tp_div_rounded(dx * s - dz * c, one));
    input->strafe = tp_fx_saturate(tp_div_rounded(dx * c + dz * s, one));
    input->up = tp_fx_sub_sat(held(eye.y, PLACE_MOST), world->eye.y);
}

void camera_mode_steer(camera_mode *l, const tp_world *world, const tp_scene *scene,
                       tp_input *input)
{
    const bool around = l->mode == CAMERA_ORBIT || l->mode == CAMERA_TOP;

    if (!around && !l->jump)
        return;
    go_with_boat(l, world, scene);
    if (l->mode == CAMERA_ORBIT && !l->jump)
        go_round(l, scene, input);
    if (l->mode == CAMERA_TOP && !l->jump)
        glide(l, scene, input);
    lead(l, world, input);
    l->jump = false;
}
