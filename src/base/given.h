/* SPDX-License-Identifier: MIT */
/* Checks of the pointers that a caller hands to an init.  `name` is the argument's. */
#ifndef TP_BASE_GIVEN_H
#define TP_BASE_GIVEN_H
#include "tidepool/status.h"

/* TP_E_NULL, or TP_OK. */
tp_status tp_given_check(const void *given, const char *name, tp_error *err);

/* A block of memory: TP_E_NULL, TP_E_ALIGN if it does not lie at a multiple of `align`
 * bytes, or TP_OK. */
tp_status tp_given_block(const void *block, uint32_t align, const char *name,
                         tp_error *err);
#endif
