/* SPDX-License-Identifier: MIT */
/* Pokes and stirs: splashes of the scene's own poke height. */
#include "poke.h"
#include "fixed/arithmetic.h"

#define STIR 3                  /* stirs as high as one poke */

/* Returns the grid to poke: the pool, else the field, else NULL. */
static const tp_scene_pool *poked(const tp_scene *scene)
{
    return scene->pool.cols > 0 ? &scene->pool
         : scene->field.cols > 0 ? &scene->field : NULL;
}

/* Returns a coordinate `quarters` quarters of a side from the middle, m. */
static tp_fx place(tp_fx middle, int32_t cells, tp_fx cell, int32_t quarters)
{
    return tp_fx_saturate(middle + (int64_t)cells * cell * quarters / 4);
}

tp_push poke_point(const tp_scene *scene, uint32_t number)
{
    const tp_scene_pool *pool = poked(scene);
    const int32_t column = (int32_t)(number % 3) - 1;

    if (!pool || number >= POKE_POINTS)
        return (tp_push){ .height = 0 };
    return poke_make_push(scene, place(pool->x, pool->cols, pool->cell, column),
                          place(pool->z, pool->rows, pool->cell, number < 3 ? -1 : 1));
}

tp_push poke_make_push(const tp_scene *scene, tp_fx x, tp_fx z)
{
    const tp_scene_pool *pool = poked(scene);

    return (tp_push){ .height = pool ? pool->splash_height : 0, .x = x, .z = z };
}

/* -- input of a tick ----------------------------------------------------------------- */

static uint32_t count_free_pushes(const tp_input *input)
{
    uint32_t room = 0;

    for (int i = 0; i < TP_PUSHES; i++)
        room += input->push[i].height == 0;
    return room;
}

bool poke_put(tp_input *input, const tp_push *push)
{
    for (int i = 0; i < TP_PUSHES; i++) {
        if (input->push[i].height == 0) {
            input->push[i] = *push;
            return true;
        }
    }
    return false;
}

/* -- queue --------------------------------------------------------------------------- */

bool poke_add(poke_queue *queue, const tp_push *push)
{
    if (push->height == 0)
        return true;
    if (queue->count == POKE_WAITS)
        return false;
    queue->waits[(queue->first + queue->count++) % POKE_WAITS] = *push;
    return true;
}

void poke_stir(poke_queue *queue, tp_fx x, tp_fx z)
{
    const uint32_t at = queue->places < POKE_PATH ? queue->places++ : POKE_PATH - 1;

    queue->path[at].x = x;
    queue->path[at].z = z;
}

/* Moves the path to the input.  A path of more points than there is room for is sampled
 * evenly, its end included.  Without any room the path waits. */
static void take_path(poke_queue *queue, const tp_scene *scene, tp_input *input)
{
    const uint32_t room = count_free_pushes(input);
    const uint32_t n = queue->places < room ? queue->places : room;

    for (uint32_t i = 0; i < n; i++) {
        const uint32_t at = (i + 1) * queue->places / n - 1;
        tp_push push = poke_make_push(scene, queue->path[at].x, queue->path[at].z);
        push.height /= STIR * (tp_fx)n;
        poke_put(input, &push);
    }
    if (n > 0)
        queue->places = 0;
}

void poke_take(poke_queue *queue, const tp_scene *scene, tp_input *input)
{
    while (queue->count > 0 && poke_put(input, &queue->waits[queue->first])) {
        queue->first = (queue->first + 1) % POKE_WAITS;
        queue->count--;
    }
    take_path(queue, scene, input);
}
