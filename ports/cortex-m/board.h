/* SPDX-License-Identifier: MIT */
/* Services of a board besides its processor: free memory and stack use. */
#ifndef TP_CORTEX_M_BOARD_H
#define TP_CORTEX_M_BOARD_H
#include <stddef.h>
#include <stdint.h>

extern uint8_t arena_start[], arena_end[];      /* all remaining memory, aligned to 8 */

uint32_t board_stack_used(void);                /* deepest use so far, bytes */
uint32_t board_stack_bytes(void);               /* size of the stack, bytes */
#endif
