/* SPDX-License-Identifier: MIT */
/* The board.  FILL IN marks the five functions to write: command, data, await, pause and
 * board_say.  board_ms and board_end may follow later.
 *
 * The bodies given here are stand-ins: they have no panel, and reach the emulator or a
 * debugger by Arm semihosting.  On a board without a debugger a semihosting call is a
 * fault, so replace them all; then delete semihost(). */
#include "board.h"
#include <stdbool.h>
#include <stddef.h>

/* -- stand-in: semihosting ----------------------------------------------------------- */

enum { SYS_WRITE0 = 0x04, SYS_CLOCK = 0x10, SYS_EXIT_EXTENDED = 0x20 };

static uint32_t semihost(uint32_t operation, const void *argument)
{
    register uint32_t    r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

/* -- the wires ----------------------------------------------------------------------- */

/* FILL IN: sends one command byte.  Set D/C low and CS low, write the byte to the SPI, and
 * return after its last bit has left. */
static void command(void *user, uint8_t byte)
{
    (void)user;
    (void)byte;
}

/* FILL IN: sends data bytes.  Set D/C high and CS low, then either write all bytes and
 * return, or start a DMA of them and return at once.  The bytes stay unchanged until
 * await(LCD_SENT) returns, and no other function of the wires is called before that.
 * If the processor has a data cache, clean it over these bytes before the DMA. */
static void data(void *user, const uint8_t *bytes, size_t count)
{
    (void)user;
    (void)bytes;
    (void)count;
}

/* FILL IN: waits for the end of the last data().  LCD_SENT: until the DMA is done and the
 * SPI has sent its last bit.  LCD_IDLE: until the BUSY line is free, for e-paper only.
 * Return false if it takes longer than about 100 ms: main() then starts the panel again. */
static bool await(void *user, lcd_until until)
{
    (void)user;
    (void)until;
    return true;
}

/* FILL IN: returns after at least `ms` milliseconds; the panel's start needs 5 to 120. */
static void pause(void *user, uint32_t ms)
{
    (void)user;
    (void)ms;
}

const lcd_wires board_wires = { NULL, command, data, await, pause };

/* -- texts, time, the end ------------------------------------------------------------ */

/* FILL IN: writes the characters to a serial port, up to the terminating zero. */
void board_say(const char *text)
{
    semihost(SYS_WRITE0, text);
}

/* Fill in later: a count of milliseconds, by SysTick or a timer.  The world advances by it
 * in real time; if it always returns 0, by one tick a picture.  The stand-in has steps of
 * 10 ms. */
uint32_t board_ms(void)
{
    return semihost(SYS_CLOCK, NULL) * 10;
}

/* Fill in later: a board blinks a LED or resets itself.  An empty endless loop is enough;
 * keep it, and delete the call above it. */
_Noreturn void board_end(int code)
{
    const uint32_t reason[2] = { 0x20026, (uint32_t)code };     /* application exit */
    semihost(SYS_EXIT_EXTENDED, reason);
    for (;;)
        ;
}
