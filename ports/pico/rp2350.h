/* SPDX-License-Identifier: MIT */
/* Addresses, bits and speeds of the RP2350; see rp2040.h. */
#ifndef TP_PICO_RP2350_H
#define TP_PICO_RP2350_H

#define CHIP_CLOCKS  0x40010000u
#define CHIP_RESETS  0x40020000u
#define CHIP_POWER   0x40018000u
#define CHIP_PINS    0x40028000u
#define CHIP_PADS    0x40038000u
#define CHIP_XOSC    0x40048000u
#define CHIP_PLL     0x40050000u
#define CHIP_UART0   0x40070000u
#define CHIP_SPI0    0x40080000u
#define CHIP_TIMER   0x400b0000u        /* TIMER0 */
#define CHIP_TICK    0x40108018u        /* ticks of TIMER0 */

enum { CHIP_RESET_DMA = 1 << 2, CHIP_RESET_PINS = 1 << 6, CHIP_RESET_PADS = 1 << 9,
       CHIP_RESET_PLL = 1 << 14, CHIP_RESET_SPI0 = 1 << 18, CHIP_RESET_TIMER = 1 << 23,
       CHIP_RESET_UART0 = 1 << 26 };
enum { CHIP_IRQ_UART0 = 33, CHIP_IRQS = 52 };

enum { CHIP_PLL_TIMES = 125, CHIP_PLL_BY = 5, CHIP_PLL_BY_2 = 2, CHIP_HZ = 150000000 };

#define CHIP_CORE1   0x01000000u
enum { CHIP_PIN_HIGH = 0x18, CHIP_PIN_LOW = 0x20, CHIP_PIN_OUT = 0x38 };

#define CHIP_DMA_TO_SPI0 (24u << 17 | 1u << 4 | 1u)
#define CHIP_DMA_BUSY    (1u << 26)
#define CHIP_DMA_ABORT   0x464u

static inline void chip_start_timer(void)
{
    PICO_AT(CHIP_TICK + 4) = 12;        /* clocks of a tick */
    PICO_AT(CHIP_TICK) = 1;
}

/* A stack pointer below `low` is a fault; its exception is entered without a frame. */
static inline void chip_limit_stack(const uint32_t *low)
{
    __asm__ volatile("msr msplim, %0" ::"r"(low));
}
#endif
