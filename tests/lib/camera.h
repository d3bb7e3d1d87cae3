/* SPDX-License-Identifier: MIT */
/* A camera for tests, in the core's formats and in double precision. */
#ifndef TP_TESTS_LIB_CAMERA_H
#define TP_TESTS_LIB_CAMERA_H
#include "view/projection.h"
#include "tests/lib/random.h"
#include "tools/reference/camera.h"

typedef struct {
    tp_projection projection;
    ref_camera ref;
    uint32_t   width, height;
} test_view;

static inline test_view view_of(tp_vec3 eye, tp_turn heading, tp_turn pitch, tp_fx fov,
                                tp_fx near, uint32_t width, uint32_t height)
{
    test_view v = { .width = width, .height = height };

    tp_projection_init(&v.projection, eye, heading, pitch, fov, near, width, height);
    v.ref = ref_camera_make(eye, heading, pitch, fov, near, width, height);
    return v;
}

/* A camera from the whole ranges of the parameter table, every fourth at the ends of the
 * ranges. */
static inline test_view view_any(uint64_t *state)
{
    const bool ends = random_below(state, 4) == 0;
    const double far = ends ? 8000 : chance_double(state, 0, 8000);
    const tp_vec3 eye = {
        chance_fx(state, 0, 1) < 32768 ? (tp_fx)(far * 65536) : (tp_fx)(-far * 65536),
        ends ? TP_FX(2000) : chance_scale(state, 0.01, 2000),
        chance_fx(state, 0, 1) < 32768 ? (tp_fx)(far * 65536) : (tp_fx)(-far * 65536),
    };
    return view_of(eye, (tp_turn)random_next(state),
                   tp_turn_of_degrees(ends ? -89 * TP_FX_ONE : chance_fx(state, -89, 89)),
                   ends ? 20 * TP_FX_ONE : chance_fx(state, 20, 100),
                   chance_scale(state, 0.05, 10),
                   ends ? 4096 : (uint32_t)chance_int(state, 16, 4096),
                   ends ? 4096 : (uint32_t)chance_int(state, 16, 4096));
}

/* World point at pixel position (u, v) and depth, in 16.16; false if the point is out of
 * range. */
static inline bool view_point(const test_view *v, double u, double w, double depth,
                              tp_vec3 *p)
{
    const ref_camera *c = &v->ref;
    const double x = (u - c->u0) / c->focal * depth, y = (c->v0 - w) / c->focal * depth;
    const double at[3] = {
        c->eye.x + x * c->right.x + y * c->up.x + depth * c->ahead.x,
        c->eye.y + x * c->right.y + y * c->up.y + depth * c->ahead.y,
        c->eye.z + x * c->right.z + y * c->up.z + depth * c->ahead.z,
    };
    const double eye[3] = { c->eye.x, c->eye.y, c->eye.z };

    for (int i = 0; i < 3; i++) {
        if (fabs(at[i]) > 32700 || fabs(at[i] - eye[i]) > 32700)
            return false;
    }
    *p = (tp_vec3){ (tp_fx)lround(at[0] * 65536), (tp_fx)lround(at[1] * 65536),
                    (tp_fx)lround(at[2] * 65536) };
    return true;
}
#endif
