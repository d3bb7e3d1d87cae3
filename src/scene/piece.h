/* SPDX-License-Identifier: MIT */
/* String views of user text, as in settings and tapes; the text is not terminated.  White
 * space is the space character and the characters from tab to carriage return. */
#ifndef TP_SCENE_PIECE_H
#define TP_SCENE_PIECE_H
#include <stdbool.h>
#include <stddef.h>
#include "tidepool/status.h"

typedef struct { const char *text; size_t bytes; } tp_piece;

static inline bool tp_is_white(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* Returns the view without leading and trailing white space. */
tp_piece tp_piece_trimmed(tp_piece piece);

bool tp_piece_is(tp_piece piece, const char *name);
bool tp_piece_has_control(tp_piece piece);      /* bytes below the space, or DEL */

/* Reads the whole view as a number.  TP_E_NUMBER: not a number.  TP_E_RANGE: outside
 * Q16.16. */
tp_status tp_piece_fx(tp_piece piece, tp_fx *x);
#endif
