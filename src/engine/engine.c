/* SPDX-License-Identifier: MIT */
/* The simple interface: a world, its frame and the scratch memory of a tile in a single
 * block. tp_world_init and tp_frame_init make them separately. */
#include <stdbool.h>
#include "base/base.h"
#include "tidepool/tidepool.h"
#include "world/module.h"

/* The engine's state at the start of the block; world, frame and scratch follow. */
struct tp_engine {
    tp_config       config;
    const tp_scene *scene;
    tp_world       *world;
    tp_frame       *frame;
    void           *scratch;
    uint32_t        next;           /* next tile to draw */
};

/* The three blocks and their sizes; a size of 0: config or scene are refused. */
typedef struct {
    size_t world_bytes, frame_bytes, scratch_bytes;
    void  *world, *frame, *scratch;
} blocks;

static blocks measure_blocks(const tp_config *c, const tp_scene *scene)
{
    return (blocks){
        .world_bytes = tp_world_bytes(c->program, scene, c->assets),
        .frame_bytes = tp_frame_bytes(c, scene),
        .scratch_bytes = tp_frame_scratch_bytes(c, scene),
    };
}

static bool has_valid_sizes(const blocks *b)
{
    return b->world_bytes > 0 && b->frame_bytes > 0 && b->scratch_bytes > 0;
}

/* Lays out the block; with a counting arena, only counts bytes. */
static void allocate_blocks(blocks *b, tp_arena *arena)
{
    tp_arena_alloc(arena, 1, sizeof(tp_engine));
    b->world = tp_arena_alloc(arena, 1, b->world_bytes);
    b->frame = tp_arena_alloc(arena, 1, b->frame_bytes);
    b->scratch = tp_arena_alloc(arena, 1, b->scratch_bytes);
}

size_t tp_engine_bytes(const tp_config *config, const tp_scene *scene)
{
    tp_arena arena = tp_arena_init(NULL, 0);

    if (config == NULL || scene == NULL)
        return 0;
    blocks b = measure_blocks(config, scene);
    allocate_blocks(&b, &arena);
    return has_valid_sizes(&b) ? arena.used : 0;
}

/* Returns the status of a refused config or scene, from the init function that refuses
 * them. */
static tp_status diagnose_refusal(const tp_config *c, const tp_scene *scene, void *memory,
                                  size_t bytes, tp_error *err)
{
    tp_frame *frame;
    const tp_status status = tp_frame_init(&frame, c, scene, memory, bytes, err);

    return status != TP_OK && status != TP_E_NOSPACE
               ? status : tp_world_init(c->program, memory, bytes, scene, c->assets, err);
}

static tp_status check_pointers(tp_engine **out, const tp_config *config,
                                const tp_scene *scene, const void *memory, tp_error *err)
{
    tp_status status = tp_pointer_check(out, "engine", err);

    if (status == TP_OK)
        status = tp_pointer_check(config, "config", err);
    if (status == TP_OK)
        status = tp_pointer_check(scene, "scene", err);
    return status == TP_OK ? tp_pointer_check_aligned(memory, 8, "memory", err) : status;
}

tp_status tp_engine_init(tp_engine **out, const tp_config *config, const tp_scene *scene,
                         void *memory, size_t bytes, tp_error *err)
{
    tp_frame *frame;
    tp_status status = check_pointers(out, config, scene, memory, err);

    if (status != TP_OK)
        return status;
    blocks b = measure_blocks(config, scene);
    if (!has_valid_sizes(&b))
        return diagnose_refusal(config, scene, memory, bytes, err);
    tp_arena arena = tp_arena_init(memory, bytes);
    allocate_blocks(&b, &arena);
    if (arena.failed)
        return TP_FAIL(err, TP_E_NOSPACE, 0, arena.used, bytes);
    status = tp_world_init(config->program, b.world, b.world_bytes, scene, config->assets,
                           err);
    if (status == TP_OK)
        status = tp_frame_init(&frame, config, scene, b.frame, b.frame_bytes, err);
    if (status != TP_OK)
        return status;
    *out = memory;
    **out = (tp_engine){ *config, scene, b.world, frame, b.scratch, 0 };
    return TP_OK;
}

const char *tp_engine_step(tp_engine *engine, const tp_input *input)
{
    TP_ASSERT(engine != NULL);
    const char *lacks = NULL;

    for (uint32_t n = tp_world_advance_clock(engine->world); n > 0; n--, input = NULL) {
        const char *own =
            tp_world_step(engine->config.program, engine->world, engine->scene, input);
        lacks = lacks ? lacks : own;
    }
    return lacks;
}

void tp_engine_begin(tp_engine *engine)
{
    TP_ASSERT(engine != NULL);
    tp_frame_begin(engine->frame, engine->world);
    engine->next = 0;
}

bool tp_engine_next_tile(tp_engine *engine, tp_tile *tile)
{
    TP_ASSERT(engine != NULL && tile != NULL);
    return tp_frame_draw_tile(engine->frame, engine->next++, engine->scratch, tile);
}

tp_status tp_engine_apply(tp_engine *engine, tp_error *err)
{
    TP_ASSERT(engine != NULL);
    const tp_config *c = &engine->config;
    const tp_status status =
        tp_program_check_all(c->program, engine->scene, c->assets, err);

    if (status != TP_OK)
        return status;
    if (!tp_world_apply(c->program, engine->world, engine->scene, c->assets))
        return tp_error_add_word(err, TP_FAIL(err, TP_E_WORLD, 0, 0, 0), "layout");
    return TP_OK;
}

tp_world *tp_engine_world(tp_engine *engine)
{
    return engine->world;
}

tp_frame *tp_engine_frame(tp_engine *engine)
{
    return engine->frame;
}
