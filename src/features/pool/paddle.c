/* SPDX-License-Identifier: MIT */
/* The paddle at a pool's edge. */
#include "base/base.h"
#include "features/pool/pool_module.h"
#include "pool/pool.h"
#include "world/world.h"

/* -- the push ------------------------------------------------------------------------ */

/* A paddle at a pool's north edge: two rows of cells about half a wavelength apart.  One
 * row is pushed up while the other is pushed down, with the period of the wave.  The gain
 * of one row equals the loss of the other, so the sum of all heights stays.
 *
 * A wave obeys sin(k/2) = sin(om/2) / r, with k and om its phase per cell and per tick
 * [C1].  A row pushed by d per tick sends d / (2 r cos(k/2)) in both directions.  The
 * second row, n cells away with opposite sign, multiplies the amplitude by 2 sin(k
 * n / 2).  At a wall the mirrored rows contribute too; the factor is 2 (cos(k/2) - cos(k
 * (n + 1/2))). */

typedef struct {
    uint32_t row, apart;        /* the rows are `row` and `row + apart` */
    int32_t  push;              /* maximum per step, LSB */
} stroke;

/* Returns om / 2 of a tick, a turn.  The period is at least 0.1 s, so the result is below
 * 1/12 turn. */
static tp_turn half_phase_per_tick(const tp_scene_pool *scene)
{
    TP_ASSERT(scene->paddle_period > 0);
    return (tp_turn)(((uint64_t)1 << 47) / ((uint64_t)(uint32_t)scene->paddle_period
                                            * TP_TICKS_PER_SECOND));
}

/* Returns the rows and the push for the scene's wave; tick, r and om are those of a step.
 * Four ticks have a phase om / 2 below 1/3 turn, of a positive sine.  The amplitude, half
 * of the height, has 29 bits; the push is below 2^60 before its division.  The push is at
 * most the amplitude, so a pool too short for its wave gets a lower wave.  The shortest
 * waves of a grid do not travel, so k is clamped just below 1/2 turn. */
static stroke compute_stroke(const tp_pool *pool, const tp_scene_pool *scene)
{
    TP_ASSERT(scene->courant > 0 && scene->paddle >= 0);
    bool    walls = pool->edges == TP_EDGES_WALL;
    stroke  s = { .row = pool->edges == TP_EDGES_SPONGE ? (uint32_t)scene->sponge : 0 };
    const tp_turn step_half = half_phase_per_tick(scene) << pool->interval;
    const tp_fx courant = scene->courant * (1 << pool->interval);
    int64_t sine = (int64_t)tp_sin(step_half) * TP_FX_ONE / courant;

    sine = sine < TP_Q30(0.99) ? sine : TP_Q30(0.99);
    int64_t cosine = tp_isqrt64(((uint64_t)1 << 60) - (uint64_t)(sine * sine));
    tp_turn half = tp_atan2((int32_t)sine, (int32_t)cosine);            /* k / 2 */
    uint32_t most = (pool->rows - 1 - s.row) / 2;
    s.apart = (((uint32_t)1 << 30) + half / 2) / half;
    s.apart = s.apart < 1 ? 1 : s.apart > most ? most : s.apart;

    int64_t share = walls ? cosine - tp_cos(half * (2 * s.apart + 1))
                          : tp_sin(half * s.apart);
    int64_t most_push = tp_pool_from_metres(pool, scene->paddle) / 2;
    int64_t push = (most_push * courant >> 16) * cosine;
    s.push = (int32_t)(push < most_push * share ? push / share : most_push);
    return s;
}

/* Pushes one column: up at the first row, down by the same amount at the second, limited
 * by the smaller of both. */
static void push_column(tp_pool *pool, const stroke *s, uint32_t col, int32_t push)
{
    uint32_t other = s->row + s->apart;

    if (tp_pool_is_wall_or_outside(pool, col, s->row)
        || tp_pool_is_wall_or_outside(pool, col, other))
        return;
    int32_t done = tp_pool_add_cell_height(pool, col, s->row, push);
    int32_t back = tp_pool_add_cell_height(pool, col, other, -done);
    if (back != -done)
        tp_pool_add_cell_height(pool, col, s->row, -done - back);
}

void tp_paddle_push(tp_pool *pool, const tp_scene_pool *scene, uint64_t tick)
{
    stroke  s = compute_stroke(pool, scene);
    tp_turn phase = (tp_turn)(2 * (uint64_t)half_phase_per_tick(scene) * tick);
    int32_t push = tp_q30_mul(s.push, tp_sin(phase));

    for (uint32_t col = 0; push != 0 && col < pool->cols; col++)
        push_column(pool, &s, col, push);
    tp_pool_start_carry_rounding(pool, tp_pool_from_metres(pool, scene->paddle));
}

/* -- the module ---------------------------------------------------------------------- */

static bool has_paddle(const tp_scene_pool *scene)
{
    return scene->cols > 0 && scene->paddle > 0;
}

bool tp_paddle_enabled(const tp_module_conditions *conditions)
{
    return has_paddle(&conditions->scene->pool) || has_paddle(&conditions->scene->field);
}

static void step_paddle(void *mine, const tp_program *program, tp_world *world,
                        const tp_scene *scene, const tp_input *input)
{
    tp_pool *pool = tp_world_mutable_pool(world), *field = tp_world_mutable_field(world);

    (void)mine, (void)program, (void)input;
    if (pool && has_paddle(&scene->pool) && tp_pool_is_due(pool))
        tp_paddle_push(pool, &scene->pool, world->tick);
    if (field && has_paddle(&scene->field) && tp_pool_is_due(field))
        tp_paddle_push(field, &scene->field, world->tick);
}

const tp_module tp_paddle_module = {
    .name = "paddle", .id = TP_MODULE_ID('p', 'a', 'd', 'l'),
    .enabled = tp_paddle_enabled,
    .step = step_paddle,
};
