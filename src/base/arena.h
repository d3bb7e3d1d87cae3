/* SPDX-License-Identifier: MIT */
/* A bump allocator over one block of the caller's memory.  With a NULL block the arena only
 * counts: the function that makes a layout then also answers how large the block must
 * be. */
#ifndef TP_BASE_ARENA_H
#define TP_BASE_ARENA_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    uint8_t *block;         /* aligned to 8 bytes; NULL to count only */
    size_t   bytes;         /* size of the block */
    size_t   used;          /* bytes allocated; also counts beyond `bytes`, to
                             * tell the size needed */
    bool     failed;        /* true if an allocation did not fit or its size overflowed */
} tp_arena;

/* Makes an arena over `block`, which must be aligned to 8 bytes. */
tp_arena tp_arena_init(void *block, size_t bytes);

/* Allocates count x size bytes, aligned to 8.  Returns NULL when counting, or when the
 * block has no room left. */
void *tp_arena_alloc(tp_arena *arena, size_t count, size_t size);
#endif
