/* SPDX-License-Identifier: MIT */
/* The board's registers: clock, serial port and the mailbox to the GPU, by Broadcom's
 * "BCM2835 ARM Peripherals" and the firmware's list of mailbox properties.  Boards differ
 * in the address of the first register. */
#include "rpi.h"

enum { TIMER_LOW = 0x3004, MAILBOX_READ = 0xb880, MAILBOX_STATE = 0xb898,
       MAILBOX_WRITE = 0xb8a0, MAILBOX_OUT_STATE = 0xb8b8, GPIO_SELECT_1 = 0x200004,
       UART_DATA = 0x201000, UART_FLAGS = 0x201018, UART_WHOLE = 0x201024,
       UART_PARTS = 0x201028, UART_LINE = 0x20102c, UART_CONTROL = 0x201030 };

static uint32_t take(uint32_t offset)
{
    return peripherals[offset / 4];
}

static void put(uint32_t offset, uint32_t value)
{
    peripherals[offset / 4] = value;
}

uint32_t microseconds(void)
{
    return take(TIMER_LOW);
}

/* -- the GPU ------------------------------------------------------------------------- */

static struct {
    uint32_t bytes, code;
    property properties[PROPERTIES];
    uint32_t end;
} message __attribute__((section(".bare"), aligned(16)));

/* Waits while the bits `not` of a mailbox's state are set (full, or empty); returns false
 * after one second. */
static bool wait_while(uint32_t state, uint32_t not)
{
    const uint32_t begun = microseconds();
    while (take(state) & not)
        if (microseconds() - begun > 1000000)
            return false;
    return true;
}

/* Sends properties to the GPU and receives the answers.  Property 0 ends the message:
 * unused entries are cleared. */
bool gpu_ask(property *properties, int n)
{
    const uint32_t letter = (uint32_t)((uintptr_t)&message | (uintptr_t)gpu_memory) + 8;

    for (int i = 0; i < PROPERTIES; i++)
        message.properties[i] = i < n ? properties[i] : (property){ 0 };
    for (int i = 0; i < n; i++)
        message.properties[i].bytes = sizeof message.properties[i].value;
    message.bytes = sizeof message;
    message.code = message.end = 0;
    barrier();
    if (!wait_while(MAILBOX_OUT_STATE, 1u << 31))
        return false;
    put(MAILBOX_WRITE, letter);
    do {
        if (!wait_while(MAILBOX_STATE, 1u << 30))
            return false;
    } while (take(MAILBOX_READ) != letter);
    barrier();
    for (int i = 0; i < n; i++)
        properties[i] = message.properties[i];
    return message.code == ANSWERED;
}

/* -- the serial port ----------------------------------------------------------------- */

void uart_open(void)
{
    property clock = { .id = GET_CLOCK, .value = { 2 } };
    uint32_t hertz = 48000000;                      /* the firmware's default */

    if (gpu_ask(&clock, 1) && clock.value[1])
        hertz = clock.value[1];
    put(UART_CONTROL, 0);
    put(GPIO_SELECT_1, (take(GPIO_SELECT_1) & ~(077u << 12)) | 044u << 12);
    put(UART_WHOLE, hertz / (16 * 115200));
    put(UART_PARTS, hertz / (115200 / 4) % 64);
    put(UART_LINE, 7 << 4);                         /* 8n1, FIFOs on */
    put(UART_CONTROL, 0x301);                       /* on, transmit and receive */
}

static struct {
    uint8_t  bytes[256];
    uint32_t in, out;               /* running counts; indices are their lower bits */
} heard;

void uart_listen(void)
{
    while (heard.in - heard.out < sizeof heard.bytes && !(take(UART_FLAGS) & 1 << 4))
        heard.bytes[heard.in++ % sizeof heard.bytes] = (uint8_t)take(UART_DATA);
}

int uart_byte(void)
{
    uart_listen();
    return heard.in == heard.out ? -1 : heard.bytes[heard.out++ % sizeof heard.bytes];
}

void say(const char *text)
{
    for (; *text; text++) {
        while (take(UART_FLAGS) & 1 << 5)           /* transmit FIFO full? */
            ;
        put(UART_DATA, (uint8_t)*text);
    }
}

void say_number(const char *before, uint32_t n, uint32_t base, int least_digits)
{
    char  text[34];
    char *c = text + sizeof text - 1;

    *c = '\0';
    for (; n || least_digits > 0; n /= base, least_digits--)
        *--c = "0123456789abcdef"[n % base];
    say(before);
    say(c);
}
