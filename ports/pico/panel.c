/* SPDX-License-Identifier: MIT */
/* Wires of a panel: SPI0 at a quarter of the clock, a DMA channel for the bytes, and pins
 * for D/C, chip select, reset and the backlight.
 *
 * The DMA ends before the last byte has left the SPI: a wait asks both.  Bytes that the
 * SPI receives are not read; the overrun has no effect on what it sends. */
#include "pico.h"

enum { PIN_CS = 17, PIN_CLOCK = 18, PIN_DATA = 19, PIN_DC = 20, PIN_RESET = 21,
       PIN_LIGHT = 22 };

#define SPI(offset) PICO_AT(CHIP_SPI0 + (offset))
enum { SPI_CR0 = 0x00, SPI_CR1 = 0x04, SPI_DR = 0x08, SPI_SR = 0x0c, SPI_CPSR = 0x10,
       SPI_DMACR = 0x24 };
enum { SPI_ROOM = 0x02, SPI_BUSY = 0x10 };

#define DMA(offset) PICO_AT(0x50000000u + (offset))
enum { DMA_READ = 0x00, DMA_WRITE = 0x04, DMA_COUNT = 0x08, DMA_CTRL = 0x0c };

enum { TIMEOUT_US = 100000 };           /* a tile takes less than a millisecond */

static void put_pin(uint32_t pin, bool high)
{
    PICO_SIO(high ? CHIP_PIN_HIGH : CHIP_PIN_LOW) = 1u << pin;
}

static void open_pin(uint32_t pin, bool high)
{
    put_pin(pin, high);
    PICO_SIO(CHIP_PIN_OUT) = 1u << pin;
    pico_pin(pin, PICO_PIN_OUT);
}

void panel_open(void)
{
    open_pin(PIN_CS, true);
    open_pin(PIN_DC, true);
    open_pin(PIN_RESET, true);
    open_pin(PIN_LIGHT, true);
    pico_pin(PIN_CLOCK, PICO_PIN_SPI);
    pico_pin(PIN_DATA, PICO_PIN_SPI);
    SPI(SPI_CPSR) = 2;
    SPI(SPI_CR0) = 1u << 8 | 7;         /* CHIP_HZ / (2 (1 + 1)); 8 bits, mode 0 */
    SPI(SPI_DMACR) = 2;                 /* requests of the transmit side */
    SPI(SPI_CR1) = 2;                   /* on */
    put_pin(PIN_RESET, false);
    panel_pause(NULL, 1);               /* at least 10 us */
    put_pin(PIN_RESET, true);
    panel_pause(NULL, 120);
    put_pin(PIN_CS, false);             /* the panel is alone on these wires */
}

void panel_command(void *unused, uint8_t byte)
{
    (void)unused;
    put_pin(PIN_DC, false);
    SPI(SPI_DR) = byte;
    while (SPI(SPI_SR) & SPI_BUSY)
        ;
}

void panel_data(void *unused, const uint8_t *bytes, size_t count)
{
    (void)unused;
    put_pin(PIN_DC, true);
    DMA(DMA_READ) = (uint32_t)(uintptr_t)bytes;
    DMA(DMA_WRITE) = CHIP_SPI0 + SPI_DR;
    DMA(DMA_COUNT) = (uint32_t)count;
    __asm__ volatile("dmb" ::: "memory");
    DMA(DMA_CTRL) = CHIP_DMA_TO_SPI0;
}

bool panel_wait(void *unused, lcd_until until)
{
    const uint32_t from = pico_us();

    (void)unused, (void)until;
    while (DMA(DMA_CTRL) & CHIP_DMA_BUSY || SPI(SPI_SR) & SPI_BUSY)
        if (pico_us() - from > TIMEOUT_US) {
            DMA(CHIP_DMA_ABORT) = 1;
            while (DMA(CHIP_DMA_ABORT))
                ;
            return false;
        }
    return true;
}

void panel_pause(void *unused, uint32_t ms)
{
    (void)unused;
    for (const uint32_t from = pico_us(); pico_us() - from < 1000 * ms; )
        ;
}
