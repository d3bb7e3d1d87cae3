/* SPDX-License-Identifier: MIT */
/* Registers of the LM3S6965 and the wires of its evaluation board.
 *
 * An interrupt stores received bytes in a ring while a picture is drawn; the vector table
 * is copied to RAM to add that one entry.  While the ring is full the interrupt is masked:
 * a sender that continues loses bytes, except on an emulator, which waits. */
#include "evb.h"
#include "cortex-m/board.h"
#include "cortex-m/live.h"

#define AT(address) (*(volatile uint32_t *)(uintptr_t)(address))

/* System control */
#define RIS     AT(0x400fe050)
#define RCC     AT(0x400fe060)
#define RCGC1   AT(0x400fe104)
#define RCGC2   AT(0x400fe108)
#define RCC_FIELDS 0x07c03bf1u          /* fields that RCC_50MHZ replaces: SYSDIV USESYSDIV
                                         * PWRDN OEN BYPASS XTAL OSCSRC MOSCDIS */
#define RCC_BYPASS 0x00000800u
#define RCC_50MHZ  0x01c00380u          /* 200 MHz / 4 from the 8 MHz crystal */
#define PLL_LOCKED 0x00000040u

/* GPIO ports: the address of the data register contains a mask of the pins. */
enum { GPIO_A = 0x40004000, GPIO_C = 0x40006000,
       GPIO_E = 0x40024000, GPIO_F = 0x40025000 };
#define PINS(port, mask) AT((port) + ((mask) << 2))
#define DIR(port)   AT((port) + 0x400)
#define AFSEL(port) AT((port) + 0x420)
#define PUR(port)   AT((port) + 0x510)
#define DEN(port)   AT((port) + 0x51c)
#define POWER_PIN 0x40u                 /* PC6: 15 V supply of the display */
#define DATA_PIN  0x80u                 /* PC7: D/C of the display */

#define UART(offset) AT(0x4000c000 + (offset))
#define UART_EMPTY 0x10u                /* receive FIFO is empty */
#define UART_FULL  0x20u                /* transmit FIFO is full */
#define UART_RX    0x50u                /* interrupts: receive, receive timeout */

#define SSI(offset) AT(0x40008000 + (offset))
#define SSI_ROOM   0x02u
#define SSI_CAME   0x04u
#define SSI_BUSY   0x10u

#define SYSTICK(offset) AT(0xe000e010 + (offset))
#define SYSTICK_BITS 0x00ffffffu
#define NVIC_ENABLE  AT(0xe000e100)
#define VTOR         AT(0xe000ed08)
enum { CORE_VECTORS = 16, UART_IRQ = 5, VECTORS = CORE_VECTORS + UART_IRQ + 1 };

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);

/* -- clock --------------------------------------------------------------------------- */

/* Switches to the PLL.  If the PLL does not lock, the slow clock stays on, and the water
 * is slow. */
static void open_clock(void)
{
    RCC |= RCC_BYPASS;
    RCC = (RCC & ~RCC_FIELDS) | RCC_BYPASS | RCC_50MHZ;
    for (int i = 0; i < 100000; i++)
        if (RIS & PLL_LOCKED) {
            RCC &= ~RCC_BYPASS;
            break;
        }
    SYSTICK(4) = SYSTICK_BITS;
    SYSTICK(8) = 0;
    SYSTICK(0) = 5;                     /* enabled, on the processor's clock */
}

uint32_t evb_clocks(void)
{
    static uint32_t last;
    const uint32_t now = SYSTICK_BITS - SYSTICK(8);
    const uint32_t gone = (now - last) & SYSTICK_BITS;
    last = now;
    return gone;
}

/* -- serial port --------------------------------------------------------------------- */

enum { RING = 256 };

static volatile uint8_t  ring[RING];
static volatile uint32_t ring_in, ring_out;     /* each is written by one side only */
__attribute__((aligned(128))) static uint32_t vectors_used[VECTORS];

/* Interrupt handler: stores all received bytes.  The upper bits of UARTDR report line
 * errors; a byte with an error is stored as 0, invalid in any line. */
static void receive(void)
{
    while (!(UART(0x18) & UART_EMPTY)) {
        if (ring_in - ring_out == RING) {
            UART(0x38) = 0;
            return;
        }
        const uint32_t byte = UART(0);
        ring[ring_in % RING] = (uint8_t)(byte & 0xf00 ? 0 : byte);
        ring_in++;
    }
    UART(0x44) = UART_RX;
}

bool evb_byte(uint8_t *byte)
{
    if (ring_in == ring_out)
        return false;
    *byte = ring[ring_out % RING];
    ring_out++;
    UART(0x38) = UART_RX;
    return true;
}

static void open_serial(void)
{
    AFSEL(GPIO_A) |= 0x03;              /* PA0, PA1 */
    DEN(GPIO_A) |= 0x03;
    UART(0x30) = 0;
    UART(0x24) = 27;                    /* divisor 50 MHz / (16 * 115200) = 27 + 8/64 */
    UART(0x28) = 8;
    UART(0x2c) = 0x70;                  /* 8 bits, no parity, FIFOs on */
    UART(0x30) = 0x301;
    memcpy(vectors_used, (const void *)VTOR, CORE_VECTORS * sizeof *vectors_used);
    vectors_used[CORE_VECTORS + UART_IRQ] = (uint32_t)(uintptr_t)receive;
    VTOR = (uint32_t)(uintptr_t)vectors_used;
    UART(0x38) = UART_RX;
    NVIC_ENABLE = 1u << UART_IRQ;
}

void live_text(void *unused, const char *text)
{
    (void)unused;
    for (; *text; text++) {
        while (UART(0x18) & UART_FULL)
            ;
        UART(0) = (uint8_t)*text;
    }
}

/* -- display ------------------------------------------------------------------------- */

static void open_display(void)
{
    AFSEL(GPIO_A) |= 0x2c;              /* PA2 clock, PA3 chip select, PA5 data */
    DEN(GPIO_A) |= 0x2c;
    DIR(GPIO_C) |= POWER_PIN | DATA_PIN;
    DEN(GPIO_C) |= POWER_PIN | DATA_PIN;
    PINS(GPIO_C, POWER_PIN) = POWER_PIN;
    SSI(4) = 0;
    SSI(0x10) = 14;                     /* 3.6 MHz; the panel's limit is 4 */
    SSI(0) = 0xc7;                      /* 8 bits, clock idle high, sampled as it rises */
    SSI(4) = 2;
}

/* Discards received bytes; an emulator sends nothing more until they are read. */
static void fetch(void)
{
    while (SSI(0xc) & SSI_CAME)
        (void)SSI(8);
}

static void send(uint8_t byte)
{
    while (!(SSI(0xc) & SSI_ROOM))
        fetch();
    SSI(8) = byte;
}

/* Waits for the last bit to leave; D/C may change only then. */
static void settle(void)
{
    while (SSI(0xc) & SSI_BUSY)
        fetch();
    fetch();
}

void evb_command(void *unused, uint8_t byte)
{
    (void)unused;
    PINS(GPIO_C, DATA_PIN) = 0;
    send(byte);
    settle();
}

void evb_data(void *unused, const uint8_t *bytes, size_t count)
{
    (void)unused;
    PINS(GPIO_C, DATA_PIN) = DATA_PIN;
    while (count--)
        send(*bytes++);
    settle();
}

void evb_pause(void *unused, uint32_t ms)
{
    (void)unused;
    for (uint32_t gone = evb_clocks(); gone < ms * (EVB_HZ / 1000); )
        gone += evb_clocks();
}

/* -- buttons ------------------------------------------------------------------------- */

/* Returns the button lines: PE0 up, PE1 down, PE2 left, PE3 right, PF1 select.  Pull-ups
 * keep released lines high. */
uint32_t evb_buttons(void)
{
    return PINS(GPIO_E, 0x0fu) | PINS(GPIO_F, 0x02u) << 3;
}

static void open_buttons(void)
{
    DEN(GPIO_E) |= 0x0f;
    PUR(GPIO_E) |= 0x0f;
    DEN(GPIO_F) |= 0x02;
    PUR(GPIO_F) |= 0x02;
}

void evb_open(void)
{
    open_clock();
    RCGC1 |= 0x11;                      /* UART0, SSI0 */
    RCGC2 |= 0x35;                      /* ports A, C, E, F */
    (void)RCGC2;                        /* read back: waits until the clocks are on */
    open_serial();
    open_display();
    open_buttons();
}
