/* SPDX-License-Identifier: MIT */
/* Pieces of a person's text, as settings and tapes hold them: not terminated.  White
 * space is a space and what lies from tab to carriage return. */
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

/* Without the white space around it. */
tp_piece tp_piece_trimmed(tp_piece piece);

bool tp_piece_is(tp_piece piece, const char *name);
bool tp_piece_has_control(tp_piece piece);      /* bytes below the space, or DEL */

/* All of it as a number: TP_E_NUMBER, or TP_E_RANGE for what 16.16 does not hold. */
tp_status tp_piece_fx(tp_piece piece, tp_fx *x);
#endif
