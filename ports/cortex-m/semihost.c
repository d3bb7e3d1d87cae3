/* SPDX-License-Identifier: MIT */
/* Semihosting calls of Arm's "Semihosting for AArch32 and AArch64": breakpoint 0xab with
 * the operation in r0 and its argument in r1. */
#include "semihost.h"

enum { SYS_WRITE0 = 0x04, SYS_GET_CMDLINE = 0x15, SYS_EXIT_EXTENDED = 0x20 };

#define APPLICATION_EXIT 0x20026u

static uint32_t call(uint32_t operation, const void *argument)
{
    register uint32_t    r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void semihost_write(const char *text)
{
    call(SYS_WRITE0, text);
}

bool semihost_words(char *buffer, size_t size)
{
    struct { char *text; size_t size; } block = { buffer, size };
    return call(SYS_GET_CMDLINE, &block) == 0;
}

_Noreturn void semihost_exit(int code)
{
    const uint32_t reason[2] = { APPLICATION_EXIT, (uint32_t)code };
    call(SYS_EXIT_EXTENDED, reason);
    for (;;)
        ;
}

void semihost_number(const char *before, uint32_t n, uint32_t base, int least_digits)
{
    char  text[34];
    char *c = text + sizeof text - 1;

    *c = '\0';
    for (; n || least_digits > 0; n /= base, least_digits--)
        *--c = "0123456789abcdef"[n % base];
    semihost_write(before);
    semihost_write(c);
}

void semihost_decimal(const char *before, uint32_t n)
{
    semihost_number(before, n, 10, 1);
}

_Noreturn void semihost_stop(const char *why)
{
    semihost_write(why);
    semihost_write("\n");
    semihost_exit(SEMIHOST_FAILED);
}
