/* SPDX-License-Identifier: MIT */
/* Ends a test program when a contract of the core is broken: base/base.h. */
#include <stdio.h>
#include <stdlib.h>
#ifndef TP_CHECKED
#define TP_CHECKED
#endif
#include "base/base.h"

_Noreturn void tp_assert_failed(const char *file, int line, const char *condition)
{
    fprintf(stderr, "%s:%d: does not hold: %s\n", file, line, condition);
    abort();
}
