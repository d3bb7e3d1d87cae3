/* SPDX-License-Identifier: MIT */
/* The two pools of a scene; see the header. */
#include "base/base.h"
#include "world/pools.h"

tp_pool_config tp_pools_config(const tp_scene *scene, const tp_assets *assets, bool field)
{
    const tp_scene_pool *pool = field ? &scene->field : &scene->pool;

    return (tp_pool_config){
        .cols = (uint32_t)pool->cols, .rows = (uint32_t)pool->rows,
        .cells = (tp_cells)pool->cell_bits, .edges = (tp_edges)pool->boundary,
        .courant = pool->courant, .damping = (uint32_t)pool->damping,
        .interval = (uint32_t)pool->interval,
        .sponge = (uint32_t)pool->sponge, .range = pool->max_height, .cell = pool->cell,
        .x = pool->x, .z = pool->z, .drive_min = pool->drive_min,
        .drive_max = pool->drive_max, .drive_amplitude = pool->drive_amplitude,
        .mask = !assets ? NULL : field ? assets->field_mask : assets->pool_mask,
    };
}

/* Prefixes err->word: "courant" becomes the parameter's full name, "pool.courant". */
static void prefix_error_word(tp_error *err, const char *part)
{
    char name[sizeof err->word];
    tp_text text = tp_text_init(name, sizeof name);

    if (!err)
        return;
    tp_text_append(&text, part);
    tp_text_append_char(&text, '.');
    tp_text_append(&text, err->word);
    tp_error_set_word(err, name, tp_string_length(name));
}

tp_status tp_pools_check(const tp_scene *scene, const tp_assets *assets, bool field,
                         tp_error *err)
{
    const tp_pool_config config = tp_pools_config(scene, assets, field);

    if (config.cols == 0)
        return TP_OK;
    tp_status status = tp_pool_check(&config, err);
    if (status != TP_OK)
        prefix_error_word(err, field ? "field" : "pool");
    return status;
}

/* -- states --------------------------------------------------------------------------- */

static tp_pool *find_pool(const tp_world *world, uint32_t id)
{
    tp_basin *basin = tp_world_module_state(world, id);
    return basin ? &basin->pool : NULL;
}

tp_pool *tp_world_mutable_pool(const tp_world *world)
{
    return find_pool(world, TP_POOL_ID);
}

tp_pool *tp_world_mutable_field(const tp_world *world)
{
    return find_pool(world, TP_FIELD_ID);
}

const tp_pool *tp_world_pool(const tp_world *world)
{
    return find_pool(world, TP_POOL_ID);
}

const tp_pool *tp_world_field(const tp_world *world)
{
    return find_pool(world, TP_FIELD_ID);
}
