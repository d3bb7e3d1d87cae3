/* SPDX-License-Identifier: MIT */
/* The table of boards.  Clocks and memory are those of the data sheets.  No board was timed:
 * speeds are clocks over cycles per instruction.
 *
 * Cortex-M4: 1.3, an estimate for a board's flash with cache.  Cortex-M0+ and Cortex-M0:
 * counted in the steps of shipped scenes, 1.30 to 1.38 (tests/budgets/board-steps.sh), by the
 * cycles of the processors' Technical Reference Manuals: loads and stores take 2, taken
 * branches 2 and 3.  Waits for flash and for the other core are not in it. */
#include "boards.h"
#include <string.h>

#define KB 1024u
#define MB (1024u * KB)
#define M  1000000ull

#define M4 "clock / 1.3"
#define M0PLUS "clock / 1.35, flash without waits"
#define M0 "clock / 1.41, flash without waits"
#define OTHER "clock / 1.5, an estimate"

const plan_board boards[] = {
    { "stm32f405", "Cortex-M4F", TP_PROCESSOR_M4, true, 168, 129 * M, 128 * KB, 1024 * KB,
      "to 64 bits", M4, "ST DS8626; 64 KB more RAM apart" },
    { "stm32f746", "Cortex-M7", TP_PROCESSOR_M4, true, 216, 216 * M, 320 * KB, 1024 * KB,
      "to 64 bits", "clock, two instructions a cycle at best, an estimate", "ST DS10916" },
    { "nrf52840", "Cortex-M4F", TP_PROCESSOR_M4, true, 64, 49 * M, 256 * KB, 1024 * KB,
      "to 64 bits", M4, "Nordic nRF52840 PS" },
    { "rp2040", "Cortex-M0+", TP_PROCESSOR_M0PLUS, true, 133, 98 * M, 264 * KB, 2 * MB,
      "to 32 bits", M0PLUS, "RP2040 data sheet; flash of a Pico; one of two cores" },
    { "rp2350", "Cortex-M33", TP_PROCESSOR_M4, true, 150, 115 * M, 520 * KB, 4 * MB,
      "to 64 bits", M4, "RP2350 data sheet; flash of a Pico 2; one of two cores" },
    { "esp32s3", "Xtensa LX7", TP_PROCESSOR_M4, false, 240, 160 * M, 512 * KB, 8 * MB,
      "to 64 bits, two parts", OTHER,
      "ESP32-S3 data sheet; flash of a DevKitC-1 N8; one of two cores" },
    { "microbit", "Cortex-M0", TP_PROCESSOR_M0PLUS, true, 16, 11 * M, 16 * KB, 256 * KB,
      "to 32 bits", M0, "nRF51822 PS" },
};

const size_t board_count = sizeof boards / sizeof *boards;

const plan_board *board_find(const char *name)
{
    for (size_t i = 0; i < board_count; i++)
        if (strcmp(boards[i].name, name) == 0)
            return &boards[i];
    return NULL;
}
