/* SPDX-License-Identifier: MIT */
/* The bump allocator of base/arena.h.  A size that overflows saturates `used`.  Every later
 * allocation then fails as well, and the caller sees one failure at the end. */
#include "base/arena.h"
#include "base/base.h"

enum { ALIGNMENT = 8 };

tp_arena tp_arena_init(void *block, size_t bytes)
{
    TP_ASSERT((uintptr_t)block % ALIGNMENT == 0);
    return (tp_arena){ .block = block, .bytes = bytes, .used = 0, .failed = false };
}

/* Returns count x size in bytes, rounded up to the alignment.  Returns SIZE_MAX if the
 * product does not fit a size_t: no block is that large. */
static size_t aligned_size(size_t count, size_t size)
{
    if (size != 0 && count > (SIZE_MAX - ALIGNMENT) / size)
        return SIZE_MAX;
    return (count * size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
}

void *tp_arena_alloc(tp_arena *arena, size_t count, size_t size)
{
    TP_ASSERT(arena != NULL);
    TP_ASSERT(arena->failed || arena->block == NULL || arena->used <= arena->bytes);
    const size_t bytes = aligned_size(count, size);
    if (bytes > SIZE_MAX - arena->used) {
        arena->used = SIZE_MAX;
        arena->failed = true;
        return NULL;
    }
    const size_t at = arena->used;
    arena->used += bytes;
    if (arena->block == NULL)
        return NULL;
    if (arena->used > arena->bytes) {
        arena->failed = true;
        return NULL;
    }
    return arena->block + at;
}
