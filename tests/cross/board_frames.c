/* SPDX-License-Identifier: MIT */
/* Prints the CRCs of the baked scene's golden frames on a bare board, drawn by all modules
 * of the core: a line as tests/cross/frames prints it for xrgb8888. */
#include "base/base.h"
#include "cortex-m/baked.h"
#include "cortex-m/board.h"
#include "cortex-m/frame_crc.h"
#include "cortex-m/semihost.h"
#include "frame/tools.h"
#include "tests/lib/golden_sizes.h"

static void *claim(tp_arena *arena, size_t bytes)
{
    void *memory = tp_arena_alloc(arena, 1, bytes);
    if (!memory) {
        semihost_decimal("no memory for ", (uint32_t)bytes);
        semihost_stop("");
    }
    return memory;
}

static uint32_t draw(const tp_config *config, tp_frame *frame, void *scratch,
                     const tp_world *world)
{
    tp_tile  tile;
    uint32_t crc = 0;
    tp_frame_begin(frame, world);
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++)
        crc = frame_crc_add_tile(crc, config, &tile);
    return crc;
}

int main(void)
{
    static const uint32_t ticks[] = GOLDEN_TICKS;
    const tp_config config = { .width = GOLDEN_WIDTH, .height = GOLDEN_HEIGHT,
                               .tile_width = 96, .tile_height = 50,
                               .format = TP_FORMAT_XRGB8888, .assets = &baked_assets };
    tp_arena arena = tp_arena_init(arena_start, (size_t)(arena_end - arena_start));
    const size_t bytes = tp_frame_bytes(&config, &baked_scene);
    const size_t world_bytes =
        tp_world_bytes(&tp_program_all, &baked_scene, &baked_assets);
    void *block = claim(&arena, bytes);
    void *scratch = claim(&arena, tp_frame_scratch_bytes(&config, &baked_scene));
    tp_world *world = claim(&arena, world_bytes);
    tp_frame *frame;
    tp_error  err;

    if (tp_frame_init(&frame, &config, &baked_scene, block, bytes, &err)
        || tp_world_init(&tp_program_all, world, world_bytes, &baked_scene, &baked_assets,
                         &err))
        semihost_stop("the scene cannot be made");
    for (size_t i = 0; i < sizeof ticks / sizeof *ticks; i++) {
        while (tp_world_tick(world) < ticks[i])
            tp_world_step(&tp_program_all, world, &baked_scene, NULL);
        semihost_write("xrgb8888");
        semihost_number(" frame ", ticks[i], 10, 4);
        semihost_number(" crc32 ", draw(&config, frame, scratch, world), 16, 8);
        semihost_write("\n");
    }
    return 0;
}
