/* SPDX-License-Identifier: MIT */
/* Checks of pointer arguments of init functions: base/given.h. */
#include "base/assert.h"
#include "base/fail.h"
#include "base/given.h"

tp_status tp_given_check(const void *given, const char *name, tp_error *err)
{
    return given != NULL ? TP_OK
                         : tp_error_blame(err, TP_FAIL(err, TP_E_NULL, 0, 0, 0), name);
}

tp_status tp_given_block(const void *block, uint32_t align, const char *name,
                         tp_error *err)
{
    TP_ASSERT(align > 0 && (align & (align - 1)) == 0);
    if ((uintptr_t)block % align != 0)
        return tp_error_blame(err, TP_FAIL(err, TP_E_ALIGN, 0, align, 0), name);
    return tp_given_check(block, name, err);
}
