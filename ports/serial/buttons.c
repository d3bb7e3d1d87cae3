/* SPDX-License-Identifier: MIT */
/* Converts buttons into the input of the next tick. */
#include "buttons.h"
#include "../interact/poke.h"
#include "features/drops/drops.h"
#include "world/pools.h"

/* Steps per click: 10 degrees of the camera, 15 degrees of the light, 0.25 m of the
 * sphere. */
#define TURN  ((int32_t)TP_DEG(10))
#define LIGHT ((int32_t)TP_DEG(15))
#define STEER TP_FX(0.25)

/* Clamps x into the pool, unless a periodic field covers the water around it. */
static tp_fx held(const tp_scene *scene, int32_t cells, tp_fx middle, tp_fx x)
{
    const int64_t half = (int64_t)cells * scene->pool.cell / 2;
    const int64_t from = x < middle - half ? middle - half : x;
    const int64_t in = from > middle + half ? middle + half : from;
    return scene->field.cols ? x : tp_fx_saturate(in);
}

/* Adds a push where the view ray of the picture's middle meets still water; if it meets
 * none, in the pool's middle.  Returns false if the input has no room for another push. */
static bool aim(const tp_world *world, const tp_scene *scene, tp_input *input)
{
    const tp_camera camera = tp_world_camera(world);
    const tp_dir3 *back = &camera.turn.z;
    tp_fx x = scene->pool.x, z = scene->pool.z;

    if (back->y >> 14 > 0 && camera.eye.y > 0) {
        const tp_fx far = tp_fx_div(camera.eye.y, back->y >> 14);
        x = tp_fx_sub_sat(camera.eye.x, tp_q30_mul(far, back->x));
        z = tp_fx_sub_sat(camera.eye.z, tp_q30_mul(far, back->z));
    }
    const tp_push push = { scene->pool.splash_height,
                           held(scene, scene->pool.cols, scene->pool.x, x),
                           held(scene, scene->pool.rows, scene->pool.z, z) };
    return push.height == 0 || poke_put(input, &push);
}

void buttons_read(buttons *b, uint32_t lines, const tp_world *world,
                  const tp_scene *scene, tp_input *input)
{
    const uint32_t up = lines & ~b->lines;
    const int32_t  side = (up & BUTTON_RIGHT ? 1 : 0) - (up & BUTTON_LEFT ? 1 : 0);

    b->lines = lines;
    if (up & BUTTON_UP && tp_world_drops(world))
        input->drops++;
    if (up & BUTTON_SELECT && (tp_world_pool(world) || tp_world_field(world))
        && !aim(world, scene, input))
        b->lines &= ~(uint32_t)BUTTON_SELECT;   /* no room: try again with the next tick */
    if (up & BUTTON_DOWN)
        input->light_turn += LIGHT;
    if (tp_world_drops(world))
        input->sphere_x += side * STEER;
    else
        input->turn += side * TURN;
}
