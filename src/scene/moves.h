/* SPDX-License-Identifier: MIT */
/* What the kit holds of each part of a world that only some scenes have.  A part that the
 * kit lacks is not in the world.  An `input` of NULL is one that is all 0. */
#ifndef TP_SCENE_MOVES_H
#define TP_SCENE_MOVES_H
#include "geom/waters.h"
#include "scene/boat.h"
#include "scene/light.h"
#include "scene/parts.h"
#include "tidepool/arena.h"

struct tp_move_boat {
    void (*init)(const tp_kit *kit, tp_world *world, const tp_scene *scene);
    void (*step)(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                 const tp_input *input);
};

struct tp_move_wake {
    void (*step)(tp_world *world, const tp_scene *scene);
};

struct tp_move_drops {
    size_t (*bytes)(const tp_scene_drops *config);
    void (*init)(tp_drops *drops, const tp_scene_drops *config);
    void (*step)(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                 const tp_input *input);
};

/* Pool and field. */
struct tp_move_pools {
    tp_status (*take)(tp_world_parts *parts, tp_arena *arena, const tp_scene *scene,
                      const tp_assets *assets, tp_error *err);
    tp_status (*init)(tp_world *world, const tp_scene *scene, const tp_assets *assets,
                      tp_error *err);
    bool (*can_tune)(const tp_world *world, const tp_scene *scene);
    void (*tune)(tp_world *world, const tp_scene *scene);
    bool (*hat)(tp_pool *pool, tp_fx x, tp_fx z, tp_fx sigma, tp_fx height);
    void (*step)(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                 const tp_input *input);
};

struct tp_move_paddle {
    void (*push)(tp_pool *pool, const tp_scene_pool *scene, uint64_t tick);
};

struct tp_move_ocean {
    size_t (*bytes)(const tp_kit *kit, const tp_scene *scene, const tp_assets *assets);
    tp_status (*init)(tp_world *world, const tp_scene *scene, const tp_assets *assets,
                      tp_error *err);
    tp_status (*refresh)(tp_world *world, const tp_scene *scene, const tp_assets *assets);
};
#endif
