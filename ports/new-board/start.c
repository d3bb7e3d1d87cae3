/* SPDX-License-Identifier: MIT */
/* Start-up from reset to main: the vector table, initialised and cleared memory, and a
 * stack painted with a pattern to measure its use.  Set clocks and pins at the beginning of
 * main(), or in reset() before the memory is copied.  If the vendor's start-up is used
 * instead, leave this file out: the notes in board.ld name the symbols that it provides. */
#include "board.h"
#include <stddef.h>

extern uint8_t data_load[], data_start[], data_end[], bss_start[], bss_end[];
extern uint32_t stack_low[], stack_top[];

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);
void *memset(void *to, int value, size_t bytes);
int main(void);
void reset(void);
void fault(void);
_Noreturn void report_fault(void);

#define PAINT 0xa5a5a5a5u

enum { EXIT_FAULT = 139 };      /* 128 + 11, as a shell reports SIGSEGV */

_Noreturn __attribute__((used)) void report_fault(void)
{
    board_say("fault: wrong address or instruction, or the stack overflowed\n");
    board_end(EXIT_FAULT);
}

/* Every fault, and every interrupt without a handler of its own.  The stack may have
 * overflowed: it is taken from its top again. */
__attribute__((naked)) void fault(void)
{
    __asm__ volatile("ldr r0, =stack_top\n\tmov sp, r0\n\tbl report_fault\n\t.pool");
}

/* Vector table: initial stack, reset, NMI, four faults, four reserved, SVC, debug,
 * reserved, PendSV, SysTick.  Interrupts of the chip follow: add those of a DMA or a timer
 * in the order of the chip's manual, up to the last one that is enabled. */
typedef union { uint32_t *stack; void (*handler)(void); } vector;

extern const vector vectors[16];
__attribute__((section(".vectors"), used)) const vector vectors[16] = {
    { .stack = stack_top }, { .handler = reset }, { .handler = fault },
    { .handler = fault }, { .handler = fault }, { .handler = fault },
    { .handler = fault },
    { 0 }, { 0 }, { 0 }, { 0 }, { .handler = fault }, { .handler = fault }, { 0 },
    { .handler = fault }, { .handler = fault },
};

void reset(void)
{
    memcpy(data_start, data_load, (size_t)(data_end - data_start));
    memset(bss_start, 0, (size_t)(bss_end - bss_start));
    uint32_t *sp;
    __asm__ volatile("mov %0, sp" : "=r"(sp));
    for (uint32_t *word = stack_low; word < sp - 8; word++)     /* below our own frame */
        *word = PAINT;
    board_end(main());
}

uint32_t board_stack_bytes(void)
{
    return (uint32_t)((uintptr_t)stack_top - (uintptr_t)stack_low);
}

uint32_t board_stack_used(void)
{
    const uint32_t *word = stack_low;
    while (word < stack_top && *word == PAINT)
        word++;
    return (uint32_t)((uintptr_t)stack_top - (uintptr_t)word);
}
