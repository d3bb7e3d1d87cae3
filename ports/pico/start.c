/* SPDX-License-Identifier: MIT */
/* Start-up from boot stage 2 to main: the vector table of both cores, functions and data
 * copied to RAM, cleared memory, and both stacks painted with a pattern to measure their
 * use.  Functions in the section .start run in flash. */
#include "pico.h"
#include "cortex-m/live.h"

extern uint32_t data_load[], data_start[], data_end[], bss_start[], bss_end[];
extern uint32_t stack0_low[], stack0_top[], stack1_low[], stack1_top[];

int main(void);
void reset(void);

#define PAINT 0xa5a5a5a5u
enum { GUARD = 16 };            /* words */

/* Keeps a function in flash, its loops from becoming calls of memcpy, which is not in RAM
 * yet. */
#define START __attribute__((section(".start"), noinline, \
                             optimize("no-tree-loop-distribute-patterns")))

/* Words pushed by the processor on an exception, and the index of the return address. */
enum { PUSHED = 8, PUSHED_PC = 6 };

/* -- faults -------------------------------------------------------------------------- */

_Noreturn void report_fault(const uint32_t *sp);
void fault(void);

/* Reports a fault of this core on the serial port, and stops the core. */
_Noreturn __attribute__((used)) void report_fault(const uint32_t *sp)
{
    uint32_t number;

    __asm__ volatile("mrs %0, ipsr" : "=r"(number));
    live_text(NULL, "\nfault ");
    live_number(number & 0xff, 10, 1);
    live_text(NULL, " of core ");
    live_number(pico_core(), 10, 1);
    if (sp >= stack1_low && sp + PUSHED <= stack0_top) {
        live_text(NULL, " at ");
        live_number(sp[PUSHED_PC], 16, 8);
    }
    live_text(NULL, "\n");
    for (;;)
        __asm__ volatile("wfi");
}

__attribute__((naked)) void fault(void)
{
    __asm__ volatile("mov r0, sp\n\tbl report_fault");
}

/* -- vector table -------------------------------------------------------------------- */

/* Initial stack, reset, NMI, hard fault, seven that stay off, SVC, two more, PendSV,
 * SysTick; then interrupts. */
enum { IRQ = 16 };

typedef union { uint32_t *stack; void (*handler)(void); } vector;

extern const vector vectors[IRQ + CHIP_IRQS];
__attribute__((section(".vectors"), used)) const vector vectors[IRQ + CHIP_IRQS] = {
    { .stack = stack0_top }, { .handler = reset }, { .handler = fault },
    { .handler = fault }, [11] = { .handler = fault }, [14] = { .handler = fault },
    [15] = { .handler = fault }, [IRQ + CHIP_IRQ_UART0] = { .handler = pico_receive },
};

const void *start_vectors(void)
{
    return vectors;
}

/* -- memory -------------------------------------------------------------------------- */

START static void fill(uint32_t *from, const uint32_t *end, uint32_t word)
{
    while (from < end)
        *from++ = word;
}

START __attribute__((used)) void reset(void)
{
    uint32_t *sp;

    for (uint32_t i = 0; i < (uint32_t)(data_end - data_start); i++)
        data_start[i] = data_load[i];
    fill(bss_start, bss_end, 0);
    __asm__ volatile("mov %0, sp" : "=r"(sp));
    fill(stack0_low, sp - 8, PAINT);                    /* below our own frame */
    fill(stack1_low, stack1_top, PAINT);
    main();
    for (;;)
        __asm__ volatile("wfi");
}

uint32_t start_stack_used(uint32_t core)
{
    const uint32_t *const top = core ? stack1_top : stack0_top;
    const uint32_t *word = core ? stack1_low : stack0_low;
    while (word < top && *word == PAINT)
        word++;
    return (uint32_t)((uintptr_t)top - (uintptr_t)word);
}

/* The lowest words keep their pattern: the guard of a chip without a limit of the stack. */
bool start_stack_holds(uint32_t core)
{
    const uint32_t *const low = core ? stack1_low : stack0_low;
    for (int i = 0; i < GUARD; i++)
        if (low[i] != PAINT)
            return false;
    return true;
}

void start_guard_stack(void)
{
    chip_limit_stack(pico_core() ? stack1_low : stack0_low);
}

uint32_t *start_stack_top(uint32_t core)
{
    return core ? stack1_top : stack0_top;
}
