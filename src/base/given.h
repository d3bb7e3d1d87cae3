/* SPDX-License-Identifier: MIT */
/* Checks of the pointers that a caller passes to an init function.  `name` is the name of
 * the argument, for the error message. */
#ifndef TP_BASE_GIVEN_H
#define TP_BASE_GIVEN_H
#include "tidepool/status.h"

/* Returns TP_E_NULL for a NULL pointer, or TP_OK. */
tp_status tp_given_check(const void *given, const char *name, tp_error *err);

/* Checks a block of memory.  Returns TP_E_NULL for a NULL pointer, TP_E_ALIGN if the
 * address is not a multiple of `align` bytes, or TP_OK. */
tp_status tp_given_block(const void *block, uint32_t align, const char *name,
                         tp_error *err);
#endif
