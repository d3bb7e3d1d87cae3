/* SPDX-License-Identifier: MIT */
/* Pools that bend the light only (water.pool_bump): the mesh does not see them, the
 * water's normals get their slopes.  The slopes' pictures lie in the frame's block and
 * are made when it begins; a frame that was made for a scene without them draws pools as
 * heights. */
#include "frame/frame.h"

static const tp_scene_pool *scene_pool(const tp_scene *scene, int k)
{
    return k == 0 ? &scene->pool : &scene->field;
}

static const tp_pool *pool_of(const tp_frame *frame, int k)
{
    return k == 0 ? tp_world_pool(frame->world) : tp_world_field(frame->world);
}

/* A cell more all round. */
uint32_t tp_frame_bump_cells(const tp_scene *scene, int k)
{
    const tp_scene_pool *pool = scene_pool(scene, k);

    if (scene->water.pool_bump <= 0 || pool->cols <= 0)
        return 0;
    return (uint32_t)(pool->cols + 2) * (uint32_t)(pool->rows + 2);
}

/* Whether there is room for all pools that the world has. */
static bool hold(const tp_frame *frame)
{
    bool some = false;

    for (int k = 0; k < TP_POOL_BUMPS; k++) {
        const tp_pool *pool = pool_of(frame, k);
        if (pool && (pool->cols + 2) * (pool->rows + 2) > frame->parts.bump_cells[k])
            return false;
        some |= pool != NULL;
    }
    return some && frame->scene->water.pool_bump > 0;
}

/* The surface with all its pools: light falls through as they are, bumps or not. */
tp_surface tp_frame_lit_surface(const tp_frame *frame)
{
    tp_surface surface = frame->surface;

    if (surface.by->pools) {
        surface.pool = pool_of(frame, 0);
        surface.field = pool_of(frame, 1);
    }
    return surface;
}

/* Quiet pools of 8 and 16 bits are flat. */
static bool is_flat(const tp_pool *pool)
{
    return pool->at_rest && pool->cells != TP_CELLS_32;
}

static void place_bumps(tp_frame *frame)
{
    const bool bumps = hold(frame);

    for (int k = 0; k < TP_POOL_BUMPS; k++) {
        const tp_pool *pool = pool_of(frame, k);
        tp_pool_bump *bump = &frame->shade.bumps.pool[k];
        *bump = (tp_pool_bump){ .slope = NULL };
        if (!bumps || !pool || is_flat(pool))
            continue;
        TP_ASSERT(frame->parts.bump[k] != NULL);
        *bump = tp_pool_bump_of(pool, frame->parts.bump[k]);
        bump->lod = tp_frame_lod(frame, tp_fx_recip(pool->cell), true);
        tp_pool_slopes(pool, frame->world->back, frame->scene->water.pool_bump,
                       frame->parts.bump[k]);
    }
}

const struct tp_draw_bumps tp_draw_bumps = {
    hold, place_bumps
};
