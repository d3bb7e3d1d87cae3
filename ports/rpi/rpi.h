/* SPDX-License-Identifier: MIT */
/* What start-up, the board's registers and its linker script give the port. */
#ifndef RPI_H
#define RPI_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* By the linker. */
extern volatile uint32_t peripherals[];         /* the first register */
extern uint8_t gpu_memory[];                    /* byte 0 of memory, for the GPU */
extern uint8_t arena_start[], arena_end[];      /* all memory left, aligned to 16 */

/* entry.S: waits until memory has what was written; gives the processor its map and its
 * caches, from a table; asks the emulator or debugger that we run under, -1 if there is
 * none (Arm's "Semihosting for AArch32 and AArch64"). */
void     barrier(void);
void     map_on(const void *table);
intptr_t semihost(uint32_t operation, const void *argument);

/* start.c */
uint32_t stack_used(void);                      /* bytes, the deepest so far */
_Noreturn void halt(int code);                  /* see there */

/* board.c: a clock, and words over the serial port: numbers of base 2 to 16, with zeros
 * before them up to `least_digits`; the byte that came, or -1.  The port itself keeps 16
 * bytes, which come in 1.4 ms: who does something for longer listens now and then. */
uint32_t microseconds(void);
void     uart_open(void);
void     uart_listen(void);
int      uart_byte(void);
void     say(const char *text);
void     say_number(const char *before, uint32_t n, uint32_t base, int least_digits);

/* A property of the GPU's, its request and then its answer.  All have room for two
 * numbers; of some the second is 0. */
typedef struct { uint32_t id, bytes, code, value[2]; } property;

enum { GET_CLOCK = 0x30002, ALLOCATE = 0x40001, GET_PITCH = 0x40008, SET_SIZE = 0x48003,
       SET_VIRTUAL_SIZE = 0x48004, SET_DEPTH = 0x48005, SET_ORDER = 0x48006,
       SET_OFFSET = 0x48009, SET_VSYNC = 0x4800e };

#define ANSWERED   0x80000000u                  /* in the code */
#define PROPERTIES 8                            /* at most, asked at once */

bool gpu_ask(property *properties, int n);      /* false: no answer within a second */

/* rpi.c */
int main(void);
#endif
