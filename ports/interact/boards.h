/* SPDX-License-Identifier: MIT */
/* Boards that quality.board and `tidepool plan --board` know. */
#ifndef TP_INTERACT_BOARDS_H
#define TP_INTERACT_BOARDS_H
#include <stddef.h>
#include <stdint.h>
#include "quality/plan.h"

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

#define TICKS_A_SECOND 60
#define BOARD_FRAME_US 100000   /* of a frame, if nothing else is asked: 10 a second */

extern const plan_board boards[TP_BOARDS - 1];

/* A board's frame: the time that it may take, and the cost of a tick, instructions. */
typedef struct {
    const plan_board *board;    /* NULL: none, the error budget decides */
    uint32_t frame_us;
    uint64_t tick;
} board_frame;

/* Returns the board of quality.board, or NULL. */
const plan_board *board_of_scene(const tp_scene *scene);

/* Returns the frame of the scene's board: quality.frame_ms, or BOARD_FRAME_US; no ticks. */
board_frame board_frame_of_scene(const tp_scene *scene);

/* Returns the instructions that a board has for a frame beside its ticks. */
uint64_t board_frame_budget(const board_frame *frame);

/* Returns the plan of a scene for a board's frame: the most exact set within its budget; of
 * the drawing rows, mirror.size and grid.vertices are open too.  If no set is within it,
 * *real_time is false, and the plan is the cheapest set with an estimated error of at most
 * 16 levels: 29 to 34 dB in most shipped scenes. */
tp_plan board_plan_make(const board_frame *frame, const tp_scene *scene,
                        const tp_assets *assets, uint32_t width, uint32_t height,
                        bool *real_time);

/* Returns the board of a name, or NULL. */
const plan_board *board_find(const char *name);
#endif
