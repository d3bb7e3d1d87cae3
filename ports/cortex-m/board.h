/* SPDX-License-Identifier: MIT */
/* What the board gives the program beside its processor, and what is drawn on it. */
#ifndef BOARD_H
#define BOARD_H
#include <stddef.h>
#include <stdint.h>
#include "tidepool/frame.h"

extern uint8_t arena_start[], arena_end[];      /* all memory left, aligned to 8 */

uint32_t board_stack_used(void);                /* bytes, the deepest so far */
uint32_t board_stack_bytes(void);               /* that are kept for it */

/* picture.c of the board: all that its scenes may need, and the screen's tiles. */
extern const tp_kit *const board_kit;
extern const tp_frame_config board_picture;
#endif
