/* SPDX-License-Identifier: MIT */
/* The parts of a world; see the header. */
#include "scene/parts.h"
#include "base/base.h"
#include "scene/pools.h"
#include "scene/moves.h"
#include "scene/sides.h"

static const tp_grey *floor_of(const tp_assets *assets)
{
    return assets ? assets->floor : NULL;
}

static tp_ocean_config ocean_config(const tp_scene *scene, const tp_assets *assets)
{
    return (tp_ocean_config){
        .floor = {
            .depth = scene->floor.depth, .slope = scene->floor.slope,
            .heading = scene->floor.heading, .map = floor_of(assets),
            .map_x = scene->floor.map_x, .map_z = scene->floor.map_z,
            .map_size = scene->floor.map_size, .map_low = scene->floor.map_low,
            .map_high = scene->floor.map_high,
        },
        .wind = scene->wind.strength, .wind_heading = scene->wind.heading,
        .k0 = scene->surf.k0, .kx = scene->surf.kx, .ky = scene->surf.ky,
        .stretch = scene->surf.stretch, .irregular = scene->surf.irregular,
    };
}

/* The offset of `bytes` more, 0 of none. */
static uint32_t take(tp_arena *arena, size_t bytes)
{
    TP_ASSERT(arena->block == NULL);
    size_t at = arena->used;
    if (bytes == 0)
        return 0;
    tp_arena_take(arena, 1, bytes);
    return (uint32_t)at;
}

size_t tp_parts_ocean_bytes(const tp_kit *kit, const tp_scene *scene,
                            const tp_assets *assets)
{
    TP_ASSERT(kit->water.swells != NULL);
    tp_ocean_config config = ocean_config(scene, assets);
    tp_sea sea;

    kit->water.swells->init(&sea, scene->wave, TP_WAVES, scene->water.gravity);
    return tp_ocean_bytes(&config, &sea);
}

static bool has_ocean(const tp_kit *kit, const tp_scene *scene)
{
    return kit->move.ocean && kit->water.ocean && kit->water.swells
        && tp_has_ocean(scene);
}

/* That a world has room for. */
static size_t swells_of(const tp_kit *kit, const tp_scene *scene)
{
    size_t count = 0;

    if (!kit->water.swells || !kit->water.swells->few)
        return kit->water.swells ? TP_WAVES : 0;
    for (int i = 0; i < TP_WAVES; i++)
        count += scene->wave[i].amplitude > 0;
    return count;
}

tp_status tp_parts_of(const tp_kit *kit, tp_world_parts *parts, const tp_scene *scene,
                      const tp_assets *assets, tp_error *err)
{
    tp_arena  arena = tp_arena_over(NULL, 0);
    tp_status status = tp_kit_check(kit, scene, err);

    *parts = (tp_world_parts){ .bytes = 0 };
    if (status != TP_OK)
        return status;
    const tp_moves *move = &kit->move;
    take(&arena, offsetof(tp_world, sea.swell) + swells_of(kit, scene) * sizeof(tp_swell));
    if (has_ocean(kit, scene)) {
        size_t bytes = move->ocean->bytes(kit, scene, assets);
        if (bytes == 0)
            return tp_error_blame(err, TP_FAIL(err, TP_E_ARG, 0, 0, 0), "floor.map");
        parts->ocean = take(&arena, bytes);
    }
    const tp_want want = { .scene = scene, .assets = assets, .coastal = parts->ocean != 0 };
    status = tp_modules_take(kit, &arena, want, &parts->modules, err);
    parts->bytes = status == TP_OK ? (uint32_t)arena.used : 0;
    return status;
}

/* The part at an offset; the block is aligned to 8, and so is every part. */
static void *part(const tp_world *world, uint32_t at)
{
    TP_ASSERT(at % 8 == 0 && (at == 0 || at < world->parts.bytes));
    return at ? (char *)(uintptr_t)world + at : NULL;
}

tp_status tp_parts_init_ocean(tp_world *world, const tp_scene *scene,
                              const tp_assets *assets, tp_error *err)
{
    tp_ocean_config config = ocean_config(scene, assets);
    tp_ocean *ocean = part(world, world->parts.ocean);

    return ocean ? tp_ocean_init(ocean, &config, &world->sea, scene->wave, TP_WAVES, err)
                 : TP_OK;
}

tp_status tp_parts_refresh_ocean(tp_world *world, const tp_scene *scene,
                                 const tp_assets *assets)
{
    TP_ASSERT(world->parts.ocean != 0);
    tp_ocean_config config = ocean_config(scene, assets);

    return tp_ocean_refresh(part(world, world->parts.ocean), &config, &world->sea,
                            scene->wave, TP_WAVES, NULL);
}

tp_status tp_parts_init(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                        const tp_assets *assets, tp_error *err)
{
    const tp_moves *move = &kit->move;
    tp_status status = TP_OK;

    if (world->parts.ocean)
        status = move->ocean->init(world, scene, assets, err);
    const tp_want want = { .scene = scene, .assets = assets,
                           .coastal = world->parts.ocean != 0 };
    return status == TP_OK ? tp_modules_init(kit, world, want, err) : status;
}

const tp_ocean *tp_world_ocean(const tp_world *world)
{
    return part(world, world->parts.ocean);
}

tp_surface tp_world_surface(const tp_kit *kit, const tp_world *world)
{
    const bool pools = kit->water.pools != NULL;

    tp_surface surface = {
        .by = &kit->water, .sea = &world->sea, .phases = world->phases,
        .ocean = tp_world_ocean(world),
        .pool = pools ? tp_parts_pool(world) : NULL,
        .field = pools ? tp_parts_field(world) : NULL,
    };

    tp_modules_add_surface(kit, world, &surface);
    return surface;
}
