/* SPDX-License-Identifier: MIT */
/* The modules of a world: loops over the program's list; see the header. */
#include "scene/module.h"
#include "base/assert.h"
#include "base/base.h"

/* Before a module's state, which follows it, aligned to 8. */
typedef struct {
    uint32_t id, bytes;
} chunk;

static chunk *chunk_at(const tp_world *world, uint32_t at)
{
    TP_ASSERT(at % 8 == 0);
    return (chunk *)(void *)((char *)(uintptr_t)world + at);
}

/* The offset of the next one. */
static uint32_t chunk_end(const tp_world *world, uint32_t at)
{
    return at + (uint32_t)sizeof(chunk) + chunk_at(world, at)->bytes;
}

static bool has_state(const tp_module *module, const tp_want *want)
{
    return module->bytes && module->enabled(want);
}

static size_t state_bytes(const tp_module *module, const tp_want *want)
{
    return (module->bytes(want) + 7) & ~(size_t)7;
}

void *tp_world_part(const tp_world *world, uint32_t id)
{
    uint32_t at = world->parts.modules;

    for (; at && at < world->parts.bytes; at = chunk_end(world, at))
        if (chunk_at(world, at)->id == id)
            return chunk_at(world, at) + 1;
    return NULL;
}

uint32_t tp_modules_take(const tp_kit *kit, tp_arena *arena, const tp_want *want)
{
    TP_ASSERT(arena->block == NULL);
    const size_t begin = arena->used;

    for (const tp_use *u = kit->modules; u && u->module; u++)
        if (has_state(u->module, want))
            tp_arena_take(arena, 1, sizeof(chunk) + state_bytes(u->module, want));
    return arena->used > begin ? (uint32_t)begin : 0;
}

void tp_modules_init(const tp_kit *kit, tp_world *world, const tp_want *want)
{
    uint32_t at = world->parts.modules;

    for (const tp_use *u = kit->modules; u && u->module; u++) {
        if (!has_state(u->module, want))
            continue;
        chunk *c = chunk_at(world, at);
        *c = (chunk){ u->module->id, (uint32_t)state_bytes(u->module, want) };
        if (u->module->init)
            u->module->init(c + 1, world, want);
        at = chunk_end(world, at);
    }
}

bool tp_modules_fit(const tp_kit *kit, const tp_world *world, const tp_want *want)
{
    uint32_t at = world->parts.modules;

    for (const tp_use *u = kit->modules; u && u->module; u++) {
        if (!has_state(u->module, want))
            continue;
        if (at == 0 || at >= world->parts.bytes)
            return false;
        const chunk *c = chunk_at(world, at);
        if (c->id != u->module->id || c->bytes != state_bytes(u->module, want)
            || (u->module->fits && !u->module->fits(c + 1, want->scene)))
            return false;
        at = chunk_end(world, at);
    }
    return at == 0 || at == world->parts.bytes;
}

void tp_modules_step(const tp_kit *kit, tp_world *world, const tp_scene *scene)
{
    if (world->parts.modules == 0)
        return;
    for (const tp_use *u = kit->modules; u && u->module; u++) {
        void *mine = u->module->step ? tp_world_part(world, u->module->id) : NULL;
        if (mine)
            u->module->step(mine, kit, world, scene);
    }
}

void tp_modules_hit(const tp_kit *kit, tp_world *world, const tp_scene *scene,
                    const tp_impact *impact, tp_fx level)
{
    for (const tp_use *u = kit->modules; u && u->module; u++) {
        void *mine = u->module->hit ? tp_world_part(world, u->module->id) : NULL;
        if (mine)
            u->module->hit(mine, scene, impact, level);
    }
}

/* The lengths of `fresh` are walked, those of `world` compared. */
static bool are_same_chunks(const tp_world *world, const tp_world *fresh)
{
    uint32_t at = fresh->parts.modules;

    for (; at && at < fresh->parts.bytes; at = chunk_end(fresh, at))
        if (memcmp(chunk_at(world, at), chunk_at(fresh, at), sizeof(chunk)) != 0)
            return false;
    return true;
}

const char *tp_modules_find_invalid(const tp_kit *kit, const tp_world *world,
                                    const tp_world *fresh)
{
    if (!are_same_chunks(world, fresh))
        return "layout";
    for (const tp_use *u = kit->modules; u && u->module; u++) {
        const void *mine = tp_world_part(world, u->module->id);
        if (mine && u->module->is_valid
            && !u->module->is_valid(mine, tp_world_part(fresh, u->module->id)))
            return u->module->name;
    }
    return NULL;
}
