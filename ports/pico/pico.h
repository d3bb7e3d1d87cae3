/* SPDX-License-Identifier: MIT */
/* Drivers of the Raspberry Pi Pico and Pico 2: start-up, clocks, serial port, buttons, the
 * wires of a panel, and the second core. */
#ifndef TP_PICO_PICO_H
#define TP_PICO_PICO_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "lcd/lcd.h"

#define PICO_AT(address) (*(volatile uint32_t *)(uintptr_t)(address))
/* The same register, whose written bits are set or cleared in one access. */
#define PICO_SET(address) PICO_AT((address) + 0x2000u)
#define PICO_CLEAR(address) PICO_AT((address) + 0x3000u)
#define PICO_SIO(offset) PICO_AT(0xd0000000u + (offset))

#if __ARM_ARCH >= 8
#include "rp2350.h"
#else
#include "rp2040.h"
#endif

/* -- start.c and the linker script --------------------------------------------------- */

extern uint8_t arena_start[], arena_end[];      /* all remaining memory, aligned to 8 */

const void *start_vectors(void);                /* vector table of both cores */
uint32_t   *start_stack_top(uint32_t core);
uint32_t    start_stack_used(uint32_t core);    /* deepest use so far, bytes */
bool        start_stack_holds(uint32_t core);   /* false: it has overflowed, or nearly so */
void        start_guard_stack(void);            /* of this core: an overflow is a fault */

/* -- pico.c: clocks, pins, serial port, buttons --------------------------------------- */

enum { PICO_PIN_IN = 5, PICO_PIN_OUT = 5, PICO_PIN_SPI = 1, PICO_PIN_UART = 2 };

void     pico_open(void);                       /* starts clocks, timer, pins and port */
uint32_t pico_us(void);                         /* a clock, us; wraps after 71 minutes */
void     pico_pin(uint32_t pin, uint32_t function);

void pico_receive(void);                        /* interrupt handler of the serial port */
bool pico_byte(uint8_t *byte);                  /* false: no byte has arrived */

uint32_t pico_buttons(void);    /* lines in the format of serial/buttons.h */

/* -- panel.c: functions of lcd_wires over SPI0 and a DMA channel ----------------------- */

void panel_open(void);          /* resets the panel by its reset line; turns the light on */
void panel_command(void *unused, uint8_t byte);
void panel_data(void *unused, const uint8_t *bytes, size_t count);
bool panel_wait(void *unused, lcd_until until);
void panel_pause(void *unused, uint32_t ms);

/* -- cores.c -------------------------------------------------------------------------- */

/* Locks of the hardware; only the core that took a lock may give it back. */
enum { LOCK_TILES = 16, LOCK_PANEL = 17 };

uint32_t pico_core(void);                       /* 0 or 1: the core that asks */
void     cores_start(void (*entry)(void));      /* starts core 1 from its reset */
void     cores_send(uint32_t word);             /* to the other core; waits for room */
uint32_t cores_receive(void);                   /* sleeps until the other core sends */
void     cores_lock(uint32_t lock);
void     cores_unlock(uint32_t lock);
#endif
