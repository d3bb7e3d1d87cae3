/* SPDX-License-Identifier: MIT */
/* Memory of the page's module: one growing arena, and the C library functions used by
 * the core.  With -mbulk-memory clang compiles __builtin_memcpy and the like to single
 * instructions, so these functions do not call themselves. */
#include "web.h"

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);
void *memmove(void *to, const void *from, size_t bytes);
void *memset(void *to, int value, size_t bytes);
int   memcmp(const void *a, const void *b, size_t bytes);

#define PAGE 65536u

extern unsigned char __heap_base;   /* set by the linker: end of constants and stack */

static uintptr_t top;               /* end of the used part */

static uintptr_t begin(void)
{
    if (!top)
        top = ((uintptr_t)&__heap_base + 15) & ~(uintptr_t)15;
    return top;
}

void *web_take(size_t bytes)
{
    const uintptr_t at = begin();
    const size_t there = __builtin_wasm_memory_size(0) * PAGE;
    const size_t free = there - at;
    if (bytes > free) {
        const size_t pages = (bytes - free + PAGE - 1) / PAGE;
        if (bytes > SIZE_MAX / 2 || __builtin_wasm_memory_grow(0, pages) == SIZE_MAX)
            return NULL;
    }
    top = (at + bytes + 15) & ~(uintptr_t)15;
    return (void *)at;
}

uintptr_t web_mark(void)
{
    return begin();
}

void web_restore_mark(uintptr_t mark)
{
    top = mark;
}

void *memcpy(void *restrict to, const void *restrict from, size_t bytes)
{
    return __builtin_memcpy(to, from, bytes);
}

void *memmove(void *to, const void *from, size_t bytes)
{
    return __builtin_memmove(to, from, bytes);
}

void *memset(void *to, int value, size_t bytes)
{
    return __builtin_memset(to, value, bytes);
}

int memcmp(const void *a, const void *b, size_t bytes)
{
    const unsigned char *p = a, *q = b;
    for (; bytes; bytes--, p++, q++)
        if (*p != *q)
            return *p < *q ? -1 : 1;
    return 0;
}
