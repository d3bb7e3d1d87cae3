/* SPDX-License-Identifier: MIT */
/* Boards that `tidepool plan --board` knows. */
#ifndef TP_APP_SCENE_BOARDS_H
#define TP_APP_SCENE_BOARDS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "quality/rung_sets.h"

/* `priced_as`: the processor of whose instructions the plan's prices count, a Cortex-M4 for
 * processors of other instruction sets.  `speed`: those that the board does in a second;
 * `speed_from` says how it is known. */
typedef struct plan_board {
    const char *name, *processor;
    tp_processor priced_as;
    bool        own;            /* the instructions are those of the board's processor */
    uint32_t    mhz;
    uint64_t    speed;
    uint32_t    ram, flash;     /* bytes; flash: of the chip, or of the usual board */
    const char *multiplier;     /* what multiplies two numbers of 32 bits */
    const char *speed_from, *source;
} plan_board;

/* The names, for messages. */
#define BOARD_NAMES \
    "stm32f405, stm32f746, nrf52840, rp2040, rp2350, esp32s3 or microbit"

extern const plan_board boards[];
extern const size_t board_count;

/* Returns the board of a name, or NULL. */
const plan_board *board_find(const char *name);
#endif
