/* SPDX-License-Identifier: MIT */
/* Sets of rungs, their prices and boards as text, for the preview, the page and the
 * commands. */
#ifndef TP_INTERACT_PLAN_TEXT_H
#define TP_INTERACT_PLAN_TEXT_H
#include <stddef.h>
#include "boards.h"

/* A text that grows; what is beyond its `bytes` is cut off. */
typedef struct {
    char  *text;
    size_t bytes, length;
} plan_text;

void plan_text_add(plan_text *to, const char *text);

/* Adds a cost and an error: "12.31 M, off 3.12". */
void plan_text_add_price(plan_text *to, tp_set_price price);

/* Adds the rows by which two sets differ: "foam=fast mirror.size=quarter", by their whole
 * names "quality.foam=fast mirror.size=quarter". */
void plan_text_add_changes(plan_text *to, const tp_scene *scene, const tp_rung_set *from,
                           const tp_rung_set *with, bool whole);

/* Adds what a board does with a picture of a price: "stm32f405: 9.52 pictures a second, too
 * slow for quality.frame_ms". */
void plan_text_add_board(plan_text *to, const board_frame *frame, tp_set_price price,
                         bool real_time);
#endif
