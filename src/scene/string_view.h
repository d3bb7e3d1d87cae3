/* SPDX-License-Identifier: MIT */
/* String views of user text, as in settings and tapes; the text is not terminated.  White
 * space is the space character and the characters from tab to carriage return. */
#ifndef TP_SCENE_STRING_VIEW_H
#define TP_SCENE_STRING_VIEW_H
#include <stdbool.h>
#include <stddef.h>
#include "tidepool/status.h"

typedef struct { const char *text; size_t bytes; } tp_string_view;

static inline bool tp_is_white(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* Returns the view without leading and trailing white space. */
tp_string_view tp_string_view_trim(tp_string_view piece);

bool tp_string_view_is(tp_string_view piece, const char *name);
bool tp_string_view_has_control(tp_string_view piece); /* bytes below the space, or DEL */

/* Reads the whole view as a number.  TP_E_NUMBER: not a number.  TP_E_RANGE: outside
 * Q16.16. */
tp_status tp_string_view_fx(tp_string_view piece, tp_fx *x);
#endif
