/* SPDX-License-Identifier: MIT */
/* The four functions required by the core of each port.  Aligned blocks are copied and
 * filled by several words a turn.  PLAIN keeps the compiler from turning the loops into
 * calls of these functions. */
#include <stddef.h>
#include <stdint.h>

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);
void *memmove(void *to, const void *from, size_t bytes);
void *memset(void *to, int value, size_t bytes);
int   memcmp(const void *a, const void *b, size_t bytes);

typedef uint32_t __attribute__((may_alias)) word;

#define PLAIN __attribute__((optimize("no-tree-loop-distribute-patterns")))

static int aligned(const void *a, const void *b)
{
    return (((uintptr_t)a | (uintptr_t)b) & 3) == 0;
}

PLAIN void *memcpy(void *restrict to, const void *restrict from, size_t bytes)
{
    uint8_t *d = to;
    const uint8_t *s = from;
    if (aligned(d, s)) {
        for (; bytes >= 16; bytes -= 16, d += 16, s += 16) {
            const word *four = (const void *)s;
            word *out = (void *)d;
            const word a = four[0], b = four[1], c = four[2], e = four[3];
            out[0] = a;
            out[1] = b;
            out[2] = c;
            out[3] = e;
        }
        for (; bytes >= 4; bytes -= 4, d += 4, s += 4)
            *(word *)(void *)d = *(const word *)(const void *)s;
    }
    while (bytes--)
        *d++ = *s++;
    return to;
}

PLAIN void *memmove(void *to, const void *from, size_t bytes)
{
    uint8_t *d = to;
    const uint8_t *s = from;
    if ((uintptr_t)d - (uintptr_t)s >= bytes)       /* `to` does not start within `from` */
        return memcpy(to, from, bytes);
    while (bytes--)
        d[bytes] = s[bytes];
    return to;
}

PLAIN void *memset(void *to, int value, size_t bytes)
{
    uint8_t *d = to;
    uint32_t four = (uint8_t)value * 0x01010101u;
    for (; bytes && (uintptr_t)d & 3; bytes--)
        *d++ = (uint8_t)value;
    for (; bytes >= 32; bytes -= 32, d += 32) {
        word *out = (void *)d;
        out[0] = out[1] = out[2] = out[3] = four;
        out[4] = out[5] = out[6] = out[7] = four;
    }
    for (; bytes >= 4; bytes -= 4, d += 4)
        *(word *)(void *)d = four;
    while (bytes--)
        *d++ = (uint8_t)value;
    return to;
}

PLAIN int memcmp(const void *a, const void *b, size_t bytes)
{
    const uint8_t *p = a, *q = b;
    for (; bytes; bytes--, p++, q++)
        if (*p != *q)
            return *p < *q ? -1 : 1;
    return 0;
}
