/* SPDX-License-Identifier: MIT */
/* Pokes and stirs: hats of the height that the scene's own pokes have. */
#include "poke.h"

#define STIR 3                  /* of them are as high as a poke */

/* What is poked, or NULL. */
static const tp_scene_pool *poked(const tp_scene *scene)
{
    return scene->pool.cols > 0 ? &scene->pool
         : scene->field.cols > 0 ? &scene->field : NULL;
}

/* So many quarters of a side from its middle. */
static tp_fx place(tp_fx middle, int32_t cells, tp_fx cell, int32_t quarters)
{
    return tp_fx_held(middle + (int64_t)cells * cell * quarters / 4);
}

void poke_point(const tp_scene *scene, uint32_t number, tp_input *input)
{
    const tp_scene_pool *pool = poked(scene);
    const int32_t column = (int32_t)(number % 3) - 1;

    if (pool && number < POKE_POINTS)
        poke_at(scene, place(pool->x, pool->cols, pool->cell, column),
                place(pool->z, pool->rows, pool->cell, number < 3 ? -1 : 1), false,
                input);
}

void poke_at(const tp_scene *scene, tp_fx x, tp_fx z, bool stir, tp_input *input)
{
    const tp_scene_pool *pool = poked(scene);

    if (!pool)
        return;
    input->poke = stir ? pool->poke / STIR : pool->poke;
    input->poke_x = x;
    input->poke_z = z;
}
