/* SPDX-License-Identifier: MIT */
/* Output of programs that run on this machine and on a bare board. */
#ifndef TP_TESTS_LIB_BOARD_OUTPUT_H
#define TP_TESTS_LIB_BOARD_OUTPUT_H
#include <stdint.h>

#if __STDC_HOSTED__
#include <stdio.h>

static inline void say(const char *text)
{
    fputs(text, stdout);
}

static inline void say_number(const char *before, uint32_t n)
{
    printf("%s%lu", before, (unsigned long)n);
}
#else
#include "cortex-m/semihost.h"

static inline void say(const char *text)
{
    semihost_write(text);
}

static inline void say_number(const char *before, uint32_t n)
{
    semihost_decimal(before, n);
}
#endif
#endif
