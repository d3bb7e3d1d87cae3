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

/* -- detail of the grid --------------------------------------------------------------- */

#define CELLS  16               /* of a pool in the length of its shortest waves */
#define RADII  6                /* of a drop in the length of a ring; the first has 8 [D4] */
#define DECAYS 2                /* a ring runs for: 6 % of the height is left, with the spreading */

static void widen_detail(tp_water_detail *to, int64_t length, tp_rectangle by)
{
    const tp_fx most = tp_fx_saturate(length);
    tp_rectangle *sides = &to->sides;

    if (to->length == 0) {
        *to = (tp_water_detail){ .length = most, .sides = by };
        return;
    }
    to->length = most < to->length ? most : to->length;
    sides->x0 = by.x0 < sides->x0 ? by.x0 : sides->x0;
    sides->x1 = by.x1 > sides->x1 ? by.x1 : sides->x1;
    sides->z0 = by.z0 < sides->z0 ? by.z0 : sides->z0;
    sides->z1 = by.z1 > sides->z1 ? by.z1 : sides->z1;
}

static void widen_by_pool(tp_water_detail *to, const tp_scene_pool *pool)
{
    const bool tiled = pool->boundary == TP_EDGES_TILE;
    const int64_t wide = tiled ? TP_FX_MAX : (int64_t)pool->cell * pool->cols / 2;
    const int64_t deep = tiled ? TP_FX_MAX : (int64_t)pool->cell * pool->rows / 2;

    if (pool->cols > 0)
        widen_detail(to, (int64_t)pool->cell * CELLS,
                     tp_rectangle_make(pool->x, pool->z, wide, deep));
}

static void widen_by_rings(tp_water_detail *to, const tp_scene_drops *drops)
{
    const int64_t length = (int64_t)drops->radius * RADII;
    const int64_t half = drops->scatter_radius + length
                         + ((int64_t)drops->ring_speed * drops->ring_decay * DECAYS >> 16);

    if (drops->count > 0 && drops->target == TP_DROPS_RINGS)
        widen_detail(to, length, tp_rectangle_make(drops->x, drops->z, half, half));
}

tp_water_detail tp_scene_water_detail(const tp_scene *scene, bool flat)
{
    tp_water_detail detail = { .length = 0 };

    if (tp_is_walled(scene))
        return (tp_water_detail){ .sides = tp_pool_sides(scene), .walled = true };
    if (!flat) {
        widen_by_pool(&detail, &scene->pool);
        widen_by_pool(&detail, &scene->field);
    }
    widen_by_rings(&detail, &scene->drops);
    return detail;
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
