/* SPDX-License-Identifier: MIT */
/* Registers of the RP2040: clocks, resets, pins, serial port and buttons.
 *
 * An interrupt of core 0 stores received bytes in a ring while a picture is drawn.  While
 * the ring is full the interrupt is masked: a sender that continues loses bytes. */
#include "pico.h"

#define RESETS      0x4000c000u         /* +8: done */
enum { RESET_DMA = 1 << 2, RESET_IO = 1 << 5, RESET_PADS = 1 << 8, RESET_PLL = 1 << 12,
       RESET_SPI0 = 1 << 16, RESET_TIMER = 1 << 21, RESET_UART0 = 1 << 22 };
#define USED (RESET_DMA | RESET_IO | RESET_PADS | RESET_SPI0 | RESET_TIMER | RESET_UART0)

#define CLK_REF_CTRL PICO_AT(0x40008030u)
#define CLK_REF_SELECTED PICO_AT(0x40008038u)
#define CLK_SYS_CTRL PICO_AT(0x4000803cu)
#define CLK_SYS_SELECTED PICO_AT(0x40008044u)
#define CLK_PERI_CTRL PICO_AT(0x40008048u)
#define XOSC(offset) PICO_AT(0x40024000u + (offset))
#define PLL(offset)  PICO_AT(0x40028000u + (offset))
enum { PLL_CS = 0, PLL_PWR = 4, PLL_FBDIV = 8, PLL_PRIM = 12 };
#define WATCHDOG_TICK PICO_AT(0x4005802cu)
#define TIMERAWL      PICO_AT(0x40054028u)
#define STABLE        0x80000000u       /* XOSC status; PLL: locked */

#define UART(offset) PICO_AT(0x40034000u + (offset))
enum { UART_DR = 0x00, UART_FR = 0x18, UART_IBRD = 0x24, UART_FBRD = 0x28,
       UART_LCR = 0x2c, UART_CR = 0x30, UART_IMSC = 0x38, UART_ICR = 0x44 };
enum { UART_EMPTY = 0x10, UART_FULL = 0x20, UART_RX = 0x50, UART_IRQ = 20 };

enum { PIN_TX = 0, PIN_RX = 1, PIN_BUTTONS = 2, BUTTONS = 5 };

/* -- clocks and resets --------------------------------------------------------------- */

static void release_resets(uint32_t blocks)
{
    PICO_CLEAR(RESETS) = blocks;
    while (~PICO_AT(RESETS + 8) & blocks)
        ;
}

/* 12 MHz from the crystal, 1596 MHz in the PLL, 133 MHz for processors and peripherals.
 * The system's clock leaves the PLL first, in case a debugger started us again. */
static void open_clocks(void)
{
    CLK_SYS_CTRL = 0;
    while (CLK_SYS_SELECTED != 1)
        ;
    XOSC(0x0c) = 47;                    /* 1 ms in units of 256 clocks */
    XOSC(0x00) = 0xfabaa0;              /* on, 1 to 15 MHz */
    while (!(XOSC(0x04) & STABLE))
        ;
    CLK_REF_CTRL = 2;                   /* the crystal */
    while (CLK_REF_SELECTED != 1u << 2)
        ;
    PICO_SET(RESETS) = RESET_PLL;
    release_resets(RESET_PLL);
    PLL(PLL_CS) = 1;                    /* crystal / 1 */
    PLL(PLL_FBDIV) = 133;
    PLL(PLL_PWR) = 0x08;                /* all on but the dividers behind */
    while (!(PLL(PLL_CS) & STABLE))
        ;
    PLL(PLL_PRIM) = 6u << 16 | 2u << 12;
    PLL(PLL_PWR) = 0;
    CLK_SYS_CTRL = 1;                   /* PLL_SYS */
    while (CLK_SYS_SELECTED != 2)
        ;
    CLK_PERI_CTRL = 1u << 11;           /* on, the system's clock */
    WATCHDOG_TICK = 1u << 9 | 12;       /* on: the timer counts microseconds */
}

uint32_t pico_us(void)
{
    return TIMERAWL;
}

void pico_pin(uint32_t pin, uint32_t function)
{
    PICO_AT(0x40014004u + 8 * pin) = function;
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
    pico_pin(PIN_TX, PICO_PIN_UART);
    pico_pin(PIN_RX, PICO_PIN_UART);
    UART(UART_IBRD) = 72;               /* 133 MHz / (16 * 115200) = 72 + 10/64 */
    UART(UART_FBRD) = 10;
    UART(UART_LCR) = 0x70;              /* 8 bits, no parity, FIFOs on */
    UART(UART_CR) = 0x301;
    UART(UART_IMSC) = UART_RX;
    PICO_AT(0xe000e100u) = 1u << UART_IRQ;
}

void pico_text(void *unused, const char *text)
{
    (void)unused;
    for (; *text; text++) {
        while (UART(UART_FR) & UART_FULL)
            ;
        UART(UART_DR) = (uint8_t)*text;
    }
}

void pico_number(uint32_t n, uint32_t base, int least_digits)
{
    char  text[34];
    char *at = text + sizeof text - 1;
    *at = '\0';
    for (; n || least_digits > 0; n /= base, least_digits--)
        *--at = "0123456789abcdef"[n % base];
    pico_text(NULL, at);
}

/* -- buttons ------------------------------------------------------------------------- */

static void open_buttons(void)
{
    for (uint32_t pin = PIN_BUTTONS; pin < PIN_BUTTONS + BUTTONS; pin++) {
        PICO_AT(0x4001c004u + 4 * pin) = 0x4a;  /* input, pull-up, hysteresis */
        pico_pin(pin, PICO_PIN_IN);
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
    PICO_SET(RESETS) = USED;
    release_resets(USED);
    open_serial();
    open_buttons();
}
