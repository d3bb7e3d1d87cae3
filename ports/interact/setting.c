/* SPDX-License-Identifier: MIT */
/* Changes of parameters.  The scene is changed, then the world takes the change.  If the
 * world cannot take the change, either the scene is changed back or the caller makes a
 * new world.  No scene and no world is ever half changed: a failed tp_world_apply has no
 * effect.
 *
 * tp_world_apply keeps the camera where input has moved it, so changes of camera.* are
 * applied to the camera here. */
#include "setting.h"
#include "world/text.h"
#include "world/world.h"

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);

bool setting_is_grid(const tp_param *param)
{
    return param->offset == offsetof(tp_scene, grid.vertices);
}

bool setting_names_files(const tp_param *param)
{
    return tp_param_is_file(param) || param->offset == offsetof(tp_scene, quality.mesh);
}

bool setting_is_wall(const tp_param *param, const tp_assets *assets)
{
    return assets->pool_mask && (param->offset == offsetof(tp_scene, pool.x)
                                 || param->offset == offsetof(tp_scene, pool.z));
}

static void place_camera(tp_world *world, const tp_scene *scene, uint32_t offset)
{
    static const tp_input still;
    switch (offset) {
    case offsetof(tp_scene, camera.x): world->eye.x = scene->camera.x; break;
    case offsetof(tp_scene, camera.y): world->eye.y = scene->camera.y; break;
    case offsetof(tp_scene, camera.z): world->eye.z = scene->camera.z; break;
    case offsetof(tp_scene, camera.heading):
        world->heading = tp_turn_of_degrees(scene->camera.heading);
        break;
    case offsetof(tp_scene, camera.pitch):
        world->pitch = tp_turn_of_degrees(scene->camera.pitch);
        break;
    default:
        return;
    }
    tp_world_move_camera(world, &still); /* a jump: no interpolation on the way */
}

/* Returns the reason why the world did not take a number: SETTING_ANEW if a new world
 * can, or SETTING_REFUSED. tp_world_init in a block of 0 bytes only checks and writes
 * nothing. */
static setting_result asked_anew(const tp_program *program, const tp_scene *scene,
                                 const tp_assets *assets, tp_error *err)
{
    uint64_t none;
    tp_world *nowhere = (tp_world *)(void *)&none;

    return tp_world_init(program, nowhere, 0, scene, assets, err) == TP_E_NOSPACE
               ? SETTING_ANEW
               : SETTING_REFUSED;
}

setting_result setting_take(const tp_program *program, const tp_scene *scene,
                            tp_world *world, const tp_assets *assets,
                            const tp_param *param, tp_error *err)
{
    if (tp_param_is_file(param))
        return SETTING_LOAD;
    if (param->kind == TP_PARAM_TEXT)
        return SETTING_DONE;
    if (world && tp_world_apply(program, world, scene, assets)) {
        place_camera(world, scene, param->offset);
        return SETTING_DONE;
    }
    return asked_anew(program, scene, assets, err);
}

setting_result setting_put(const tp_program *program, tp_scene *scene, tp_world *world,
                           const tp_assets *assets, const tp_param *param,
                           const char *text, size_t bytes, tp_error *err)
{
    char *at = (char *)scene + param->offset;
    int32_t before;             /* old number; a failed text leaves the scene as it was */

    memcpy(&before, at, sizeof before);
    if (tp_param_set(scene, param, text, bytes, err))
        return SETTING_REFUSED;
    const setting_result result = setting_take(program, scene, world, assets, param, err);
    if (result == SETTING_REFUSED)
        memcpy(at, &before, sizeof before);
    return result;
}
