/* SPDX-License-Identifier: MIT */
/* Small scenes for the reference's own checks. */
#ifndef TP_TESTS_ACCURACY_VIEWS_H
#define TP_TESTS_ACCURACY_VIEWS_H
#include "scene/world.h"
#include "tests/reference/image.h"
#include "tests/unit/scenes.h"
#include "tidepool/modules.h"

typedef struct {
    tp_scene  scene;
    tp_assets assets;
    tp_world *world;
    ref_scene ref;
} view_of_ref;

/* Level water under a plain gradient sky: no haze, no glitter. */
static inline tp_scene scene_level(void)
{
    tp_scene s;

    tp_scene_level(&s);
    s.sky.haze = 0;
    s.water.specular = 0;
    s.water.reflection = TP_FX_ONE;
    return s;
}

/* Opens a view; the caller sets `v->scene` and `v->assets`. Waves extend to the end of the
 * water. */
static inline void view_open_at(view_of_ref *v, uint32_t width, uint32_t height,
                                uint32_t ticks)
{
    v->world = scene_world(&v->scene, &v->assets);
    if (!v->world)
        abort();
    while (v->world->tick < ticks)
        tp_world_step(&tp_program_all, v->world, &v->scene, NULL);
    ref_scene_open(&v->ref, &v->scene, &v->assets, v->world, width, height, false);
}

static inline void view_open(view_of_ref *v, uint32_t width, uint32_t height)
{
    view_open_at(v, width, height, 0);
}

static inline void view_close(view_of_ref *v)
{
    ref_scene_close(&v->ref);
    free(v->world);
}
#endif
