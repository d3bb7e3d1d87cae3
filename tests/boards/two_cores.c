/* SPDX-License-Identifier: MIT */
/* The baked scene drawn by two Cortex-M33 of an emulated SSE-200 (QEMU's mps2-an521): each
 * core takes the next tile until none is left, as ports/pico does.  Prints the CRCs of
 * frames 60 and 61 and the tiles of each core. */
#include "base/base.h"
#include "cortex-m/baked.h"
#include "cortex-m/board.h"
#include "cortex-m/frame_crc.h"
#include "cortex-m/semihost.h"
#include "frame/tools.h"

#define SYSTEM(offset) (*(volatile uint32_t *)(uintptr_t)(0x50021000u + (offset)))
enum { VECTORS_OF_CORE_1 = 0x114, CORES_THAT_WAIT = 0x118 };
enum { CORES = 2, FIRST = 60, FRAMES = 2, STACK_WORDS = 2048 };

static tp_frame *frame;
static void     *scratch[CORES];
static uint32_t  next_tile, crc, tiles[CORES];
static uint32_t  asked, answered;       /* numbers of frames */
static char      lock;                  /* of crc */
_Alignas(8) static uint32_t stack_of_core_1[STACK_WORDS];

static void draw_tiles(int core)
{
    tp_tile tile;
    while (tp_frame_draw_tile(frame, __atomic_fetch_add(&next_tile, 1, __ATOMIC_ACQ_REL),
                              scratch[core], &tile)) {
        while (__atomic_test_and_set(&lock, __ATOMIC_ACQUIRE))
            ;
        crc = frame_crc_add_tile(crc, &baked_config, &tile);
        __atomic_clear(&lock, __ATOMIC_RELEASE);
        tiles[core]++;
    }
}

/* Core 1: draws when core 0 asks. */
static void help(void)
{
    for (;;) {
        while (__atomic_load_n(&asked, __ATOMIC_ACQUIRE) == answered)
            ;
        draw_tiles(1);
        __atomic_store_n(&answered, answered + 1, __ATOMIC_RELEASE);
    }
}

static const struct {
    uint32_t *stack;
    void    (*reset)(void);
    void    (*fault[14])(void);
} vectors_of_core_1 __attribute__((aligned(128))) = {
    stack_of_core_1 + STACK_WORDS, help, { NULL },
};

static void start_core_1(void)
{
    SYSTEM(VECTORS_OF_CORE_1) = (uint32_t)(uintptr_t)&vectors_of_core_1;
    SYSTEM(CORES_THAT_WAIT) = 0;
}

static void draw(const tp_world *world)
{
    tp_frame_begin(frame, world);
    next_tile = crc = 0;
    __atomic_store_n(&asked, asked + 1, __ATOMIC_RELEASE);
    draw_tiles(0);
    while (__atomic_load_n(&answered, __ATOMIC_ACQUIRE) != asked)
        ;
}

static void *claim(tp_arena *arena, size_t bytes)
{
    void *memory = tp_arena_alloc(arena, 1, bytes);
    if (!memory)
        semihost_stop("no memory");
    return memory;
}

int main(void)
{
    tp_arena arena = tp_arena_init(arena_start, (size_t)(arena_end - arena_start));
    const size_t world_bytes =
        tp_world_bytes(&baked_program, &baked_scene, &baked_assets);
    const size_t bytes = baked_frame_bytes();
    tp_world *world = claim(&arena, world_bytes);
    void *block = claim(&arena, bytes);
    tp_error err;

    for (int core = 0; core < CORES; core++) {
        scratch[core] = claim(&arena, baked_scratch_bytes);
        memset(scratch[core], 0, baked_scratch_bytes);
    }
    if (baked_frame_init(&frame, block, bytes, &err)
        || tp_world_init(&baked_program, world, world_bytes, &baked_scene, &baked_assets,
                         &err))
        semihost_stop("the scene cannot be made");
    start_core_1();
    for (uint32_t n = 0; n < FIRST + FRAMES; n++) {
        if (n >= FIRST) {
            draw(world);
            semihost_number("frame ", n, 10, 4);
            semihost_number(" crc32 ", crc, 16, 8);
            semihost_write("\n");
        }
        tp_world_step(&baked_program, world, &baked_scene, NULL);
    }
    semihost_decimal("tiles ", tiles[0]);
    semihost_decimal(" ", tiles[1]);
    semihost_write("\n");
    return 0;
}
