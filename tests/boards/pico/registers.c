/* SPDX-License-Identifier: MIT */
/* Compares the addresses and bits of ports/pico/rp2040.h or rp2350.h with the register
 * headers of the Pico SDK.  It compiles if all are equal. */
#include <stdint.h>
#define _u(x) x##u
#include "hardware/regs/addressmap.h"
#include "hardware/regs/clocks.h"
#include "hardware/regs/dma.h"
#include "hardware/regs/dreq.h"
#include "hardware/regs/intctrl.h"
#include "hardware/regs/io_bank0.h"
#include "hardware/regs/pads_bank0.h"
#include "hardware/regs/psm.h"
#include "hardware/regs/resets.h"
#include "hardware/regs/sio.h"
#include "hardware/regs/timer.h"
#include "hardware/regs/watchdog.h"

#define PICO_AT(address) (*(volatile uint32_t *)(uintptr_t)(address))
#ifdef RP2350
#include "hardware/regs/ticks.h"
#include "pico/rp2350.h"
#define TIMER_BASE              TIMER0_BASE
#define RESETS_RESET_TIMER_BITS RESETS_RESET_TIMER0_BITS
#define TICK                    (TICKS_BASE + TICKS_TIMER0_CTRL_OFFSET)
#define IRQS                    52u
#else
#include "pico/rp2040.h"
#define TICK                    (WATCHDOG_BASE + WATCHDOG_TICK_OFFSET)
#define IRQS                    26u
#endif

#define SAME(a, b) _Static_assert((a) + 0u == (b) + 0u, #a)
#define RESETS(chip, sdk) SAME(CHIP_RESET_##chip, RESETS_RESET_##sdk##_BITS)
SAME(CHIP_CLOCKS, CLOCKS_BASE);
SAME(CHIP_RESETS, RESETS_BASE);
SAME(CHIP_POWER, PSM_BASE);
SAME(CHIP_PINS, IO_BANK0_BASE);
SAME(CHIP_PADS, PADS_BANK0_BASE);
SAME(CHIP_XOSC, XOSC_BASE);
SAME(CHIP_PLL, PLL_SYS_BASE);
SAME(CHIP_UART0, UART0_BASE);
SAME(CHIP_SPI0, SPI0_BASE);
SAME(CHIP_TIMER, TIMER_BASE);
SAME(CHIP_TICK, TICK);
RESETS(DMA, DMA);
RESETS(PINS, IO_BANK0);
RESETS(PADS, PADS_BANK0);
RESETS(PLL, PLL_SYS);
RESETS(SPI0, SPI0);
RESETS(TIMER, TIMER);
RESETS(UART0, UART0);
SAME(CHIP_IRQ_UART0, UART0_IRQ);
SAME(CHIP_IRQS, IRQS);
SAME(CHIP_CORE1, PSM_FRCE_OFF_PROC1_BITS);
SAME(CHIP_PIN_HIGH, SIO_GPIO_OUT_SET_OFFSET);
SAME(CHIP_PIN_LOW, SIO_GPIO_OUT_CLR_OFFSET);
SAME(CHIP_PIN_OUT, SIO_GPIO_OE_SET_OFFSET);
SAME(CHIP_DMA_TO_SPI0, DREQ_SPI0_TX << DMA_CH0_CTRL_TRIG_TREQ_SEL_LSB
                           | DMA_CH0_CTRL_TRIG_INCR_READ_BITS
                           | DMA_CH0_CTRL_TRIG_EN_BITS);
SAME(CHIP_DMA_BUSY, DMA_CH0_CTRL_TRIG_BUSY_BITS);
SAME(CHIP_DMA_ABORT, DMA_CHAN_ABORT_OFFSET);
/* Offsets that the drivers use for both chips. */
SAME(0x30, CLOCKS_CLK_REF_CTRL_OFFSET);
SAME(0x3c, CLOCKS_CLK_SYS_CTRL_OFFSET);
SAME(0x48, CLOCKS_CLK_PERI_CTRL_OFFSET);
SAME(0x28, TIMER_TIMERAWL_OFFSET);
SAME(4, IO_BANK0_GPIO0_CTRL_OFFSET);
SAME(4, PADS_BANK0_GPIO0_OFFSET);
SAME(4, PSM_FRCE_OFF_OFFSET);
SAME(8, RESETS_RESET_DONE_OFFSET);
SAME(0x50, SIO_FIFO_ST_OFFSET);
SAME(0x100, SIO_SPINLOCK0_OFFSET);
