/* SPDX-License-Identifier: MIT */
/* The modules of a world: loops over the program's module list; see the header. */
#include "base/base.h"
#include "world/module.h"

/* Header of a chunk. The module's state follows, aligned to 8 bytes. */
typedef struct {
    uint32_t id, bytes;
} chunk;

static chunk *chunk_pointer(const tp_world *world, uint32_t at)
{
    TP_ASSERT(at % 8 == 0);
    return (chunk *)(void *)((char *)(uintptr_t)world + at);
}

/* Returns the offset of the next chunk. */
static uint32_t next_chunk_offset(const tp_world *world, uint32_t at)
{
    return at + (uint32_t)sizeof(chunk) + chunk_pointer(world, at)->bytes;
}

/* True if the module is on and has a state in the world.  Ask each module in list order:
 * `conditions` tells later modules the bits of earlier modules. */
static bool ask_enabled_and_has_state(const tp_module *module,
                                      tp_module_conditions *conditions)
{
    return tp_module_ask_condition(module, conditions) && module->bytes;
}

static size_t state_bytes(const tp_module *module, const tp_module_conditions *conditions)
{
    return (module->bytes(conditions) + 7) & ~(size_t)7;
}

/* Returns the first chunk with this id at or after an offset, or NULL. */
static chunk *find_chunk(const tp_world *world, uint32_t at, uint32_t id)
{
    for (; at && at < world->layout.bytes; at = next_chunk_offset(world, at))
        if (chunk_pointer(world, at)->id == id)
            return chunk_pointer(world, at);
    return NULL;
}

void *tp_world_module_state(const tp_world *world, uint32_t id)
{
    chunk *c = find_chunk(world, world->layout.modules, id);
    return c ? c + 1 : NULL;
}

size_t tp_module_state_bytes(const void *part)
{
    return ((const chunk *)part - 1)->bytes;
}

bool tp_modules_is_any_active(const tp_use *modules,
                              const tp_module_conditions *conditions, uint32_t flags)
{
    for (const tp_use *u = modules; u && u->module; u++)
        if (u->module->is & flags && u->module->enabled(conditions))
            return true;
    return false;
}

tp_status tp_program_fail_lacking(const char *what, tp_error *err)
{
    return tp_error_add_word(err, TP_FAIL(err, TP_E_PROGRAM, 0, 0, 0), what);
}

/* Asks each missing module (tp_lack) at its position in the list of all modules, with all
 * wave models. */
tp_status tp_lacks_check(const tp_program *program, const tp_scene *scene,
                         const tp_assets *assets, tp_error *err)
{
    tp_module_conditions conditions = { .scene = scene,
                                        .assets =
                                            tp_assets_or_scene_default(scene, assets),
                                        .shadings = (uint32_t)1
                                                    << scene->quality.shading };
    const tp_use *u = program->modules;
    uint32_t above = 0;

    for (const tp_lack *l = program->lacks; l && l->enabled; l++) {
        for (; above < l->above && u && u->module; above++)
            tp_module_ask_condition(u++->module, &conditions);
        if (l->enabled(&conditions))
            return tp_program_fail_lacking(l->name, err);
    }
    return TP_OK;
}

tp_status tp_program_check_all(const tp_program *program, const tp_scene *scene,
                               const tp_assets *assets, tp_error *err)
{
    program = tp_program_or_linked(program);
    const tp_status status = tp_program_check_scene(program, scene, err);

    return status == TP_OK && program->refuse
               ? program->refuse(program, scene, assets, err) : status;
}

tp_status tp_modules_check_and_measure(const tp_program *program, tp_arena *arena,
                                       tp_module_conditions conditions,
                                       uint32_t *modules_offset, tp_error *err)
{
    TP_ASSERT(arena->block == NULL && conditions.above == 0);
    const size_t begin = arena->used;
    tp_status status = TP_OK;

    for (const tp_use *u = program->modules; u && u->module; u++) {
        const tp_module *m = u->module;
        if (!tp_module_ask_condition(m, &conditions))
            continue;
        if (m->check && (status = m->check(&conditions, err)) != TP_OK)
            return status;
        if (m->bytes)
            tp_arena_alloc(arena, 1, sizeof(chunk) + state_bytes(m, &conditions));
    }
    *modules_offset = arena->used > begin ? (uint32_t)begin : 0;
    return TP_OK;
}

static void write_chunk_headers(const tp_program *program, tp_world *world,
                                tp_module_conditions conditions)
{
    uint32_t at = world->layout.modules;

    for (const tp_use *u = program->modules; u && u->module; u++) {
        if (!ask_enabled_and_has_state(u->module, &conditions))
            continue;
        *chunk_pointer(world, at) = (chunk){ u->module->id,
                                        (uint32_t)state_bytes(u->module, &conditions) };
        at = next_chunk_offset(world, at);
    }
}

tp_status tp_modules_init(const tp_program *program, tp_world *world,
                          tp_module_conditions conditions, tp_error *err)
{
    tp_status status = TP_OK;

    write_chunk_headers(program, world, conditions);
    for (const tp_use *u = program->modules; u && u->module && status == TP_OK; u++)
        if (ask_enabled_and_has_state(u->module, &conditions) && u->module->init)
            status = u->module->init(tp_world_module_state(world, u->module->id), world,
                                     &conditions, err);
    return status;
}

bool tp_modules_fit(const tp_program *program, const tp_world *world,
                    tp_module_conditions conditions)
{
    uint32_t at = world->layout.modules;

    for (const tp_use *u = program->modules; u && u->module; u++) {
        if (!ask_enabled_and_has_state(u->module, &conditions))
            continue;
        if (at == 0 || at >= world->layout.bytes)
            return false;
        const chunk *c = chunk_pointer(world, at);
        if (c->id != u->module->id || c->bytes != state_bytes(u->module, &conditions)
            || (u->module->fits && !u->module->fits(c + 1, conditions.scene)))
            return false;
        at = next_chunk_offset(world, at);
    }
    return at == 0 || at == world->layout.bytes;
}

bool tp_modules_refresh(const tp_program *program, tp_world *world,
                        tp_module_conditions conditions)
{
    for (const tp_use *u = program->modules; u && u->module; u++)
        if (ask_enabled_and_has_state(u->module, &conditions) && u->module->refresh
            && !u->module->refresh(tp_world_module_state(world, u->module->id), world,
                                   &conditions))
            return false;
    return true;
}

/* The state of a module that has this hook, else NULL. */
#define PART_FOR(hook, u, world) \
    ((u)->module->hook ? tp_world_module_state(world, (u)->module->id) : NULL)

void tp_modules_place_floating(const tp_program *program, tp_world *world,
                               const tp_scene *scene)
{
    for (const tp_use *u = program->modules; u && u->module; u++) {
        void *mine = PART_FOR(settle, u, world);
        if (mine || (u->module->settle && !u->module->bytes))
            u->module->settle(mine, program, world, scene);
    }
}

void tp_modules_step(const tp_program *program, tp_world *world, const tp_scene *scene,
                     const tp_input *input)
{
    for (const tp_use *u = program->modules; u && u->module; u++) {
        void *mine = PART_FOR(step, u, world);
        if (mine || (u->module->step && !u->module->bytes))
            u->module->step(mine, program, world, scene, input);
    }
}

void tp_modules_add_surface(const tp_program *program, const tp_world *world,
                            tp_surface *surface)
{
    for (const tp_use *u = program->modules; u && u->module; u++) {
        const void *mine = PART_FOR(surface, u, world);
        if (mine)
            u->module->surface(mine, surface);
    }
}

bool tp_modules_handle_impact(const tp_program *program, tp_world *world,
                              const tp_scene *scene, const tp_impact *impact, tp_fx level)
{
    bool moves = false;

    for (const tp_use *u = program->modules; u && u->module; u++) {
        void *mine = PART_FOR(hit, u, world);
        if (mine && u->module->hit(mine, program, scene, impact, level))
            moves = true;
    }
    return moves;
}

static const char *module_name(const tp_program *program, uint32_t id)
{
    for (const tp_use *u = program->modules; u && u->module; u++)
        if (u->module->id == id)
            return u->module->name;
    return "layout";
}

/* Returns the name of the first module whose chunk has another id or length in `world`,
 * or NULL.  Walks the chunks by the lengths in `fresh` and compares the lengths in
 * `world`. */
static const char *find_mismatched_module(const tp_program *program, const tp_world *world,
                                          const tp_world *fresh)
{
    uint32_t at = fresh->layout.modules;

    for (; at && at < fresh->layout.bytes; at = next_chunk_offset(fresh, at))
        if (memcmp(chunk_pointer(world, at), chunk_pointer(fresh, at), sizeof(chunk)) != 0)
            return module_name(program, chunk_pointer(fresh, at)->id);
    return NULL;
}

const char *tp_modules_find_invalid(const tp_program *program, const tp_world *world,
                                    const tp_world *fresh)
{
    const char *other = find_mismatched_module(program, world, fresh);

    if (other)
        return other;
    for (const tp_use *u = program->modules; u && u->module; u++) {
        const void *mine = tp_world_module_state(world, u->module->id);
        if (u->module->is_valid && (mine || !u->module->bytes)
            && !u->module->is_valid(mine, tp_world_module_state(fresh, u->module->id),
                                    world))
            return u->module->name;
    }
    return NULL;
}
