/* SPDX-License-Identifier: MIT */
/* The services that a board gives the program beside its processor. */
#ifndef BOARD_H
#define BOARD_H
#include <stddef.h>
#include <stdint.h>

extern uint8_t arena_start[], arena_end[];      /* all memory left, aligned to 8 */

uint32_t board_stack_used(void);                /* bytes, the deepest so far */
uint32_t board_stack_bytes(void);               /* that are kept for it */
#endif
