/* SPDX-License-Identifier: MIT */
/* From reset to main: the vector table, the initialised and the cleared memory, a stack
 * painted so that its use can be seen; any fault ends the run with exit code 2. */
#include "board.h"
#include "semihost.h"

extern uint8_t data_load[], data_start[], data_end[], bss_start[], bss_end[];
extern uint32_t stack_low[], stack_top[];

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);
void *memset(void *to, int value, size_t bytes);
int main(void);
void reset(void);

#define PAINT 0xa5a5a5a5u

static void fault(void)
{
    semihost_write("fault\n");
    semihost_exit(2);
}

/* Initial stack, reset, NMI, four faults, four reserved, SVC, debug, reserved, PendSV,
 * SysTick. */
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

uint32_t board_stack_used(void)
{
    const uint32_t *word = stack_low;
    while (word < stack_top && *word == PAINT)
        word++;
    return (uint32_t)((uintptr_t)stack_top - (uintptr_t)word);
}
