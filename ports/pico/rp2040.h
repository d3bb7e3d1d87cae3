/* SPDX-License-Identifier: MIT */
/* Addresses, bits and speeds of the RP2040; rp2350.h has the same names.  Registers of
 * equal offset in both chips stand where they are used. */
#ifndef TP_PICO_RP2040_H
#define TP_PICO_RP2040_H

#define CHIP_CLOCKS  0x40008000u
#define CHIP_RESETS  0x4000c000u
#define CHIP_POWER   0x40010000u        /* power-on state machine */
#define CHIP_PINS    0x40014000u        /* functions of pins */
#define CHIP_PADS    0x4001c000u
#define CHIP_XOSC    0x40024000u
#define CHIP_PLL     0x40028000u
#define CHIP_UART0   0x40034000u
#define CHIP_SPI0    0x4003c000u
#define CHIP_TIMER   0x40054000u
#define CHIP_TICK    0x4005802cu        /* in the watchdog */

enum { CHIP_RESET_DMA = 1 << 2, CHIP_RESET_PINS = 1 << 5, CHIP_RESET_PADS = 1 << 8,
       CHIP_RESET_PLL = 1 << 12, CHIP_RESET_SPI0 = 1 << 16, CHIP_RESET_TIMER = 1 << 21,
       CHIP_RESET_UART0 = 1 << 22 };
enum { CHIP_IRQ_UART0 = 20, CHIP_IRQS = 26 };

/* 12 MHz of the crystal times CHIP_PLL_TIMES, over two dividers of the PLL. */
enum { CHIP_PLL_TIMES = 133, CHIP_PLL_BY = 6, CHIP_PLL_BY_2 = 2, CHIP_HZ = 133000000 };

#define CHIP_CORE1   0x00010000u        /* in CHIP_POWER */
enum { CHIP_PIN_HIGH = 0x14, CHIP_PIN_LOW = 0x18, CHIP_PIN_OUT = 0x24 };     /* in SIO */

/* DMA channel 0: bytes, from increasing addresses, when SPI0 has room; no chain. */
#define CHIP_DMA_TO_SPI0 (16u << 15 | 1u << 4 | 1u)
#define CHIP_DMA_BUSY    (1u << 24)
#define CHIP_DMA_ABORT   0x444u

/* The timer counts microseconds of the crystal's 12 MHz. */
static inline void chip_start_timer(void)
{
    PICO_AT(CHIP_TICK) = 1u << 9 | 12;
}

/* A Cortex-M0+ has no limit of the stack. */
static inline void chip_limit_stack(const uint32_t *low)
{
    (void)low;
}
#endif
