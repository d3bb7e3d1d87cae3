/* SPDX-License-Identifier: MIT */
/* The table of boards.  Clocks and memory are those of the data sheets.  No board was timed:
 * speeds are clocks over cycles per instruction.
 *
 * Cortex-M4: 1.3, an estimate for a board's flash with cache.  Cortex-M0+ and Cortex-M0:
 * counted in the steps of shipped scenes, 1.30 to 1.38 (tests/budgets/board-steps.sh), by the
 * cycles of the processors' Technical Reference Manuals: loads and stores take 2, taken
 * branches 2 and 3.  Waits for flash and for the other core are not in it. */
#include "boards.h"

#define SQUARE_MOST (256ull << 16)      /* of 16 levels, Q16 */
#define KB 1024u
#define MB (1024u * KB)
#define M  1000000ull

#define M4 "clock / 1.3"
#define M0PLUS "clock / 1.35, flash without waits"
#define M0 "clock / 1.41, flash without waits"
#define OTHER "clock / 1.5, an estimate"
#define BOARD(name) [TP_BOARD_##name - 1] = { #name

const plan_board boards[TP_BOARDS - 1] = {
    BOARD(stm32f405), "Cortex-M4F", TP_PROCESSOR_M4, true, 168, 129 * M, 128 * KB,
        1024 * KB, "to 64 bits", M4, "ST DS8626; 64 KB more RAM apart" },
    BOARD(stm32f746), "Cortex-M7", TP_PROCESSOR_M4, true, 216, 216 * M, 320 * KB,
        1024 * KB, "to 64 bits", "clock, two instructions a cycle at best, an estimate",
        "ST DS10916" },
    BOARD(nrf52840), "Cortex-M4F", TP_PROCESSOR_M4, true, 64, 49 * M, 256 * KB, 1024 * KB,
        "to 64 bits", M4, "Nordic nRF52840 PS" },
    BOARD(rp2040), "Cortex-M0+", TP_PROCESSOR_M0PLUS, true, 133, 98 * M, 264 * KB, 2 * MB,
        "to 32 bits", M0PLUS, "RP2040 data sheet; flash of a Pico; one of two cores" },
    BOARD(rp2350), "Cortex-M33", TP_PROCESSOR_M4, true, 150, 115 * M, 520 * KB, 4 * MB,
        "to 64 bits", M4, "RP2350 data sheet; flash of a Pico 2; one of two cores" },
    BOARD(esp32s3), "Xtensa LX7", TP_PROCESSOR_M4, false, 240, 160 * M, 512 * KB, 8 * MB,
        "to 64 bits, two parts", OTHER,
        "ESP32-S3 data sheet; flash of a DevKitC-1 N8; one of two cores" },
    BOARD(microbit), "Cortex-M0", TP_PROCESSOR_M0PLUS, true, 16, 11 * M, 16 * KB, 256 * KB,
        "to 32 bits", M0, "nRF51822 PS" },
};

const plan_board *board_of_scene(const tp_scene *scene)
{
    const int32_t board = scene->quality.board;

    return board > TP_BOARD_none && board < TP_BOARDS ? &boards[board - 1] : NULL;
}

board_frame board_frame_of_scene(const tp_scene *scene)
{
    const uint32_t us = (uint32_t)((int64_t)scene->quality.frame_ms * 1000 >> 16);

    return (board_frame){ board_of_scene(scene), us > 0 ? us : BOARD_FRAME_US, 0 };
}

uint64_t board_frame_budget(const board_frame *frame)
{
    const uint64_t ticks = TICKS_A_SECOND * frame->tick, speed = frame->board->speed;

    return speed > ticks ? (speed - ticks) / 1000 * frame->frame_us / 1000 : 0;
}

tp_plan board_plan_make(const board_frame *frame, const tp_scene *scene,
                        const tp_assets *assets, uint32_t width, uint32_t height,
                        bool *real_time)
{
    tp_plan plan = { .open = 0 };
    tp_view_costs view;

    *real_time = false;
    if (!tp_plan_view(&view, scene, assets, width, height))
        return plan;
    view.processor = frame->board->priced_as;
    plan.set = tp_rung_set_named(scene, true, &plan.open);
    *real_time = tp_set_fit(&view, &plan.set, plan.open, board_frame_budget(frame));
    if (!*real_time)
        tp_set_choose(&view, &plan.set, plan.open, SQUARE_MOST);
    plan.price = tp_set_price_estimate(&view, &plan.set);
    return plan;
}

static bool same(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}

const plan_board *board_find(const char *name)
{
    for (size_t i = 0; i < TP_BOARDS - 1; i++)
        if (same(boards[i].name, name))
            return &boards[i];
    return NULL;
}
