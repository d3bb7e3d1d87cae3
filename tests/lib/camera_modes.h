/* SPDX-License-Identifier: MIT */
/* A world with a camera mode, stepped as the view steps it, for tests. */
#ifndef TP_TESTS_LIB_CAMERA_MODES_H
#define TP_TESTS_LIB_CAMERA_MODES_H
#include "interact/camera_mode.h"
#include "tests/lib/boats.h"

#define NEAR 2                  /* LSB of 16.16 */

static uint64_t chance;

/* Swells, a camera that looks down at the swells, and a boat outside the view. */
static inline tp_scene sea(void)
{
    tp_scene s = scene_plain();

    s.camera.x = 3 * TP_FX_ONE;
    s.camera.pitch = -20 * TP_FX_ONE;
    s.camera.heading = 70 * TP_FX_ONE;
    s.boat.x = -40 * TP_FX_ONE;
    s.boat.length = 12 * TP_FX_ONE;
    return s;
}

/* Random input within the range of one tick of a person's input. */
static inline tp_input any_input(void)
{
    return (tp_input){
        .forward = chance_fx(&chance, -0.3, 0.3),
        .strafe = chance_fx(&chance, -0.3, 0.3),
        .up = chance_fx(&chance, -0.3, 0.3),
        .turn = chance_int(&chance, -9999999, 9999999),
        .tilt = chance_int(&chance, -9999999, 9999999),
        .throttle = chance_fx(&chance, -4, 4),
        .rudder = chance_fx(&chance, -20, 20),
        .drops = 3,
        .light_turn = 77,
    };
}

/* Advances one tick as the view does. */
static inline void go(camera_mode *l, tp_world *w, const tp_scene *s, tp_input in)
{
    camera_mode_steer(l, w, s, &in);
    tp_world_step(&tp_program_all, w, s, &in);
}

/* Begins a camera mode and sets camera.follow as the view does. */
static inline void begin(camera_mode *l, camera_mode_kind mode, tp_world *w, tp_scene *s)
{
    const tp_scene filed = sea();

    assert_true(camera_mode_begin(l, mode, w, s));
    s->camera.follow = (int32_t)camera_mode_follow(l, &filed);
    assert_true(tp_world_apply(&tp_program_all, w, s, NULL));
}

/* Begins a camera mode in a new world. */
static inline camera_mode started(camera_mode_kind mode, tp_world *w, tp_scene *s)
{
    camera_mode l = { .mode = CAMERA_FREE };

    *w = boat_world(s);
    begin(&l, mode, w, s);
    return l;
}

static inline void assert_at(tp_vec3 a, tp_vec3 b, int32_t near)
{
    if (abs(a.x - b.x) > near || abs(a.y - b.y) > near || abs(a.z - b.z) > near)
        fail_msg("%d %d %d, not %d %d %d", a.x, a.y, a.z, b.x, b.y, b.z);
}

static inline double distance(tp_vec3 a, tp_vec3 b)
{
    return sqrt(pow(a.x - b.x, 2) + pow(a.y - b.y, 2) + pow(a.z - b.z, 2)) / 65536;
}
#endif
