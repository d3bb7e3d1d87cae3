/* SPDX-License-Identifier: MIT */
/* Start-up from reset to main: the vector table, initialised and cleared memory, and a
 * stack painted with a pattern to measure its use.  Any fault is reported in one line and
 * ends the run with exit code 139. */
#include "board.h"
#include "semihost.h"

extern uint8_t data_load[], data_start[], data_end[], bss_start[], bss_end[];
extern uint32_t stack_low[], stack_top[];

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);
void *memset(void *to, int value, size_t bytes);
int main(void);
void reset(void);

#define PAINT 0xa5a5a5a5u

/* Words pushed by the processor on an exception, and the index of the return address. */
enum { PUSHED = 8, PUSHED_PC = 6 };

_Noreturn void report_fault(const uint32_t *sp);
void fault(void);

/* Reports a fault.  `sp` is the stack pointer after the exception; if it lies outside of
 * the stack, the stack has overflowed. */
_Noreturn __attribute__((used)) void report_fault(const uint32_t *sp)
{
    uint32_t number;

    __asm__ volatile("mrs %0, ipsr" : "=r"(number));
    semihost_decimal("fault ", number & 0xff);
    if (sp < stack_low || sp + PUSHED > stack_top) {
        semihost_write(": the stack overflowed\n");
    } else {
        semihost_number(" at ", sp[PUSHED_PC], 16, 8);
        semihost_decimal(", bytes of stack left ",
                         (uint32_t)((uintptr_t)sp - (uintptr_t)stack_low));
        semihost_write("\n");
    }
    semihost_exit(SEMIHOST_FAULT);
}

/* Fault handler.  Resets the stack pointer first if less than 256 bytes of stack are
 * left. */
__attribute__((naked)) void fault(void)
{
    __asm__ volatile("mov r0, sp\n\tldr r1, =stack_low + 256\n\t"
                     "cmp r0, r1\n\tbhs 1f\n\tldr r1, =stack_top\n\tmov sp, r1\n"
                     "1:\tbl report_fault\n\t.pool");
}

/* Vector table: initial stack, reset, NMI, four faults, four reserved, SVC, debug,
 * reserved, PendSV, SysTick. */
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
    semihost_exit(main());
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
