/* SPDX-License-Identifier: MIT */
/* Programs with deliberate faults, selected by -DFAULT_NAME. A board must report each fault
 * in a line and exit with 2, or the linker must reject the program. A program that runs to
 * its end exits with 0. */
#include "cortex-m/board.h"
#include "cortex-m/semihost.h"

#ifdef FAULT_address            /* address without memory or device on all boards */
static void go_wrong(void)
{
    *(volatile uint32_t *)(uintptr_t)0xa0000000u = 1;
}
#endif

#ifdef FAULT_instruction
static void go_wrong(void)
{
    __asm__ volatile("udf #0");
}
#endif

#ifdef FAULT_stack              /* nested calls with 256 bytes of stack each */
static volatile uint32_t deepest = 100000;

static uint32_t fall(uint32_t depth)
{
    volatile uint32_t kept[64];
    kept[depth % 64] = depth;
    return depth < deepest ? fall(depth + 1) + kept[depth % 64] : depth;
}

static void go_wrong(void)
{
    fall(0);
}
#endif

#ifdef FAULT_ram                /* more RAM than any of the boards has */
static volatile uint8_t picture[256 * 1024];

static void go_wrong(void)
{
    picture[board_stack_used()] = 1;
}
#endif

int main(void)
{
    semihost_write("going wrong\n");
    go_wrong();
    semihost_write("nothing happened\n");
    return 0;
}
