/* SPDX-License-Identifier: MIT */
/* A bump allocator over one block of the caller's.  With a NULL block it only counts,
 * so that the function which carves a block also answers how large it must be. */
#ifndef TP_BASE_ARENA_H
#define TP_BASE_ARENA_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    uint8_t *block;         /* aligned to 8, or NULL to count */
    size_t   bytes;         /* of the block */
    size_t   used;          /* also beyond `bytes`: what would have been needed */
    bool     failed;        /* some take did not fit, or its size overflowed */
} tp_arena;

/* `block` aligned to 8 bytes. */
tp_arena tp_arena_over(void *block, size_t bytes);

/* count x size bytes, aligned to 8; NULL when counting or when it does not fit. */
void *tp_arena_take(tp_arena *arena, size_t count, size_t size);
#endif
