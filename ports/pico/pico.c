/* SPDX-License-Identifier: MIT */
/* Registers of the RP2040 and RP2350: clocks, resets, pins, serial port and buttons.
 *
 * An interrupt of core 0 stores received bytes in a ring while a picture is drawn.  While
 * the ring is full the interrupt is masked: a sender that continues loses bytes. */
#include "pico.h"
#include "cortex-m/live.h"

#define USED (CHIP_RESET_DMA | CHIP_RESET_PINS | CHIP_RESET_PADS | CHIP_RESET_SPI0 \
              | CHIP_RESET_TIMER | CHIP_RESET_UART0)

#define CLOCK(offset) PICO_AT(CHIP_CLOCKS + (offset))
enum { REF_CTRL = 0x30, REF_SELECTED = 0x38, SYS_CTRL = 0x3c, SYS_SELECTED = 0x44,
       PERI_CTRL = 0x48 };
#define XOSC(offset) PICO_AT(CHIP_XOSC + (offset))
#define PLL(offset)  PICO_AT(CHIP_PLL + (offset))
enum { PLL_CS = 0, PLL_PWR = 4, PLL_FBDIV = 8, PLL_PRIM = 12 };
#define STABLE       0x80000000u        /* XOSC status; PLL: locked */

#define UART(offset) PICO_AT(CHIP_UART0 + (offset))
enum { UART_DR = 0x00, UART_FR = 0x18, UART_IBRD = 0x24, UART_FBRD = 0x28,
       UART_LCR = 0x2c, UART_CR = 0x30, UART_IMSC = 0x38, UART_ICR = 0x44 };
enum { UART_EMPTY = 0x10, UART_FULL = 0x20, UART_RX = 0x50, UART_BAUD = 115200 };

enum { PAD = 0x56, PAD_PULL_UP = 0x5a };        /* input, 4 mA, hysteresis, a pull */
enum { PIN_TX = 0, PIN_RX = 1, PIN_BUTTONS = 2, BUTTONS = 5 };

/* -- clocks and resets --------------------------------------------------------------- */

static void release_resets(uint32_t blocks)
{
    PICO_CLEAR(CHIP_RESETS) = blocks;
    while (~PICO_AT(CHIP_RESETS + 8) & blocks)
        ;
}

/* 12 MHz from the crystal, CHIP_HZ from the PLL for processors and peripherals.  The
 * system's clock first leaves its other source, which may change only then: the ring
 * oscillator, or the PLL if a debugger started us again. */
static void open_clocks(void)
{
    PICO_CLEAR(CHIP_CLOCKS + SYS_CTRL) = 1;
    while (CLOCK(SYS_SELECTED) != 1)
        ;
    XOSC(0x0c) = 47;                    /* 1 ms in units of 256 clocks */
    XOSC(0x00) = 0xfabaa0;              /* on, 1 to 15 MHz */
    while (!(XOSC(0x04) & STABLE))
        ;
    CLOCK(REF_CTRL) = 2;                /* the crystal */
    while (CLOCK(REF_SELECTED) != 1u << 2)
        ;
    PICO_SET(CHIP_RESETS) = CHIP_RESET_PLL;
    release_resets(CHIP_RESET_PLL);
    PLL(PLL_CS) = 1;                    /* crystal / 1 */
    PLL(PLL_FBDIV) = CHIP_PLL_TIMES;
    PLL(PLL_PWR) = 0x08;                /* all on but the dividers behind */
    while (!(PLL(PLL_CS) & STABLE))
        ;
    PLL(PLL_PRIM) = CHIP_PLL_BY << 16 | CHIP_PLL_BY_2 << 12;
    PLL(PLL_PWR) = 0;
    CLOCK(SYS_CTRL) = 0;                /* its other source is the PLL */
    CLOCK(SYS_CTRL) = 1;
    while (CLOCK(SYS_SELECTED) != 2)
        ;
    CLOCK(PERI_CTRL) = 1u << 11;        /* on, the system's clock */
    chip_start_timer();
}

uint32_t pico_us(void)
{
    return PICO_AT(CHIP_TIMER + 0x28);  /* the lower word, unlatched */
}

/* Sets a pin's function, then its pad, which the RP2350 isolates after a reset. */
static void set_pin(uint32_t pin, uint32_t function, uint32_t pad)
{
    PICO_AT(CHIP_PINS + 8 * pin + 4) = function;
    PICO_AT(CHIP_PADS + 4 * pin + 4) = pad;
}

void pico_pin(uint32_t pin, uint32_t function)
{
    set_pin(pin, function, PAD);
}

/* -- serial port --------------------------------------------------------------------- */

enum { RING = 256 };

static volatile uint8_t  ring[RING];
static volatile uint32_t ring_in, ring_out;     /* each is written by one side only */

/* Stores all received bytes.  The upper bits of UARTDR report line errors; a byte with an
 * error is stored as 0, invalid in any line. */
void pico_receive(void)
{
    UART(UART_ICR) = UART_RX;
    while (!(UART(UART_FR) & UART_EMPTY)) {
        if (ring_in - ring_out == RING) {
            UART(UART_IMSC) = 0;
            return;
        }
        const uint32_t byte = UART(UART_DR);
        ring[ring_in % RING] = (uint8_t)(byte & 0xf00 ? 0 : byte);
        ring_in++;
    }
}

bool pico_byte(uint8_t *byte)
{
    if (ring_in == ring_out)
        return false;
    *byte = ring[ring_out % RING];
    ring_out++;
    UART(UART_IMSC) = UART_RX;
    return true;
}

static void open_serial(void)
{
    /* CHIP_HZ / (16 UART_BAUD), in 1/64 */
    const uint32_t divisor = (4u * CHIP_HZ + UART_BAUD / 2) / UART_BAUD;

    pico_pin(PIN_TX, PICO_PIN_UART);
    pico_pin(PIN_RX, PICO_PIN_UART);
    UART(UART_IBRD) = divisor / 64;
    UART(UART_FBRD) = divisor % 64;
    UART(UART_LCR) = 0x70;              /* 8 bits, no parity, FIFOs on */
    UART(UART_CR) = 0x301;
    UART(UART_IMSC) = UART_RX;
    PICO_AT(0xe000e100u + CHIP_IRQ_UART0 / 32 * 4) = 1u << CHIP_IRQ_UART0 % 32;
}

void live_text(void *unused, const char *text)
{
    (void)unused;
    for (; *text; text++) {
        while (UART(UART_FR) & UART_FULL)
            ;
        UART(UART_DR) = (uint8_t)*text;
    }
}

/* -- buttons ------------------------------------------------------------------------- */

static void open_buttons(void)
{
    for (uint32_t pin = PIN_BUTTONS; pin < PIN_BUTTONS + BUTTONS; pin++) {
        set_pin(pin, PICO_PIN_IN, PAD_PULL_UP);
    }
}

/* GP2 up, GP3 down, GP4 left, GP5 right, GP6 select; pressed lines are low. */
uint32_t pico_buttons(void)
{
    return PICO_SIO(0x04) >> PIN_BUTTONS & ((1u << BUTTONS) - 1);
}

void pico_open(void)
{
    open_clocks();
    PICO_SET(CHIP_RESETS) = USED;
    release_resets(USED);
    open_serial();
    open_buttons();
}
