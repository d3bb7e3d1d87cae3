/* SPDX-License-Identifier: MIT */
/* Interfaces between start-up code, the board's registers, the linker script and the
 * port. */
#ifndef TP_RPI_RPI_H
#define TP_RPI_RPI_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Symbols of the linker script. */
extern volatile uint32_t peripherals[];         /* the first register */
extern uint8_t gpu_memory[];                    /* byte 0 of memory, for the GPU */
extern uint8_t arena_start[], arena_end[];      /* all remaining memory, aligned to 16 */

/* entry.S: a data barrier; turning on the memory map and the caches, from a table; a
 * semihosting call to the emulator or debugger, -1 if none answers (Arm's "Semihosting for
 * AArch32 and AArch64"). */
void     barrier(void);
void     map_enable(const void *table);
intptr_t semihost(uint32_t operation, const void *argument);

/* start.c */
uint32_t stack_used(void);                      /* deepest use so far, bytes */
_Noreturn void halt(int code);                  /* see start.c */

/* board.c: a clock, us, and the serial port.  say_number writes in base 2 to 16, padded
 * with zeros to `least_digits`.  uart_byte returns a received byte, or -1.  The receive
 * FIFO holds 16 bytes, 1.4 ms: code that runs longer must call uart_listen now and then. */
uint32_t microseconds(void);
void     uart_open(void);
void     uart_listen(void);
int      uart_byte(void);
void     say(const char *text);
void     say_number(const char *before, uint32_t n, uint32_t base, int least_digits);

/* A property of the GPU: the request, then its answer.  Each has room for two numbers;
 * properties with one number leave the second 0. */
typedef struct { uint32_t id, bytes, code, value[2]; } property;

enum { GET_CLOCK = 0x30002, ALLOCATE = 0x40001, GET_PITCH = 0x40008, SET_SIZE = 0x48003,
       SET_VIRTUAL_SIZE = 0x48004, SET_DEPTH = 0x48005, SET_ORDER = 0x48006,
       SET_OFFSET = 0x48009, SET_VSYNC = 0x4800e };

#define ANSWERED   0x80000000u                  /* bit in the code of an answer */
#define PROPERTIES 8                            /* most properties in one message */

bool gpu_ask(property *properties, int n);      /* false: no answer within a second */

/* rpi.c */
int main(void);
#endif
