/* SPDX-License-Identifier: MIT */
/* Start-up from the first instructions to main: cleared memory, a painted stack, an
 * identity memory map that enables the caches; and the end, with exit code 2 after a
 * fault.
 *
 * The map has one entry per MB (AArch32) or 2 MB (AArch64).  The program's memory is
 * cached.  The GPU's memory above it, with the frame buffer, is not cached, since pictures
 * would stay in the cache, but its writes are combined to bursts.  Registers keep their
 * order of access.  The block below the stack and the space after the registers are
 * unmapped.
 *
 * On cores that share caches with others (Cortex-A7, A53) the firmware's stub has enabled
 * coherency already. */
#include "rpi.h"

extern uint8_t  bss_start[], bss_end[], hole_start[], bare_start[], ram_end[];
extern uint32_t stack_low[], stack_top[];

void *memset(void *to, int value, size_t bytes);
_Noreturn void reset(void);
_Noreturn void fault(uint32_t class, uintptr_t pc, uintptr_t address);

#define PAINT 0xa5a5a5a5u

/* -- the map ------------------------------------------------------------------------- */

enum { NOBODYS, CACHED, BARE, DEVICE };

#ifdef __aarch64__
/* Level 2 blocks: valid, attribute index of map_enable, shared, accessed.  BARE and
 * DEVICE are not executable. */
#define BLOCK   0x200000u
#define ENTRIES 512
typedef uint64_t page_entry;
static const page_entry kinds[] = {
    [CACHED] = 0x701, [BARE] = 0x60000000000705, [DEVICE] = 0x60000000000409,
};
#else
/* Sections: TEX C B (B2.4 of the ARMv6 manual, B3.8 of ARMv7's), full access.  BARE and
 * DEVICE are not executable. */
#define BLOCK   0x100000u
#define ENTRIES 4096
typedef uint32_t page_entry;
static const page_entry kinds[] = {
    [CACHED] = 0x1c0e, [BARE] = 0x1c12, [DEVICE] = 0xc16,
};
#endif

static _Alignas(sizeof(page_entry) * ENTRIES) page_entry map[ENTRIES];

static int memory_kind(uintptr_t address)
{
    const uintptr_t registers = (uintptr_t)peripherals;
    if (address >= (uintptr_t)hole_start && address < (uintptr_t)stack_low)
        return NOBODYS;
    if (address < (uintptr_t)bare_start)
        return CACHED;
    if (address < registers)
        return BARE;
    return address - registers < 0x1000000 ? DEVICE : NOBODYS;
}

static void make_map(void)
{
    for (uint32_t i = 0; i < ENTRIES; i++) {
        const uintptr_t address = (uintptr_t)i * BLOCK;
        const int kind = memory_kind(address);
        map[i] = kind == NOBODYS ? 0 : (page_entry)address | kinds[kind];
    }
    barrier();
    map_enable(map);
}

/* -- start and end ------------------------------------------------------------------- */

void reset(void)
{
    memset(bss_start, 0, (size_t)(bss_end - bss_start));
    uint32_t *sp = __builtin_frame_address(0);
    for (uint32_t *word = stack_low; word < sp - 32; word++)    /* below our own frame */
        *word = PAINT;
    make_map();
    halt(main());
}

uint32_t stack_used(void)
{
    const uint32_t *word = stack_low;
    while (word < stack_top && *word == PAINT)
        word++;
    return (uint32_t)((uintptr_t)stack_top - (uintptr_t)word);
}

/* Ends an emulator with the exit code; on a board the last picture stays on the screen. */
void halt(int code)
{
    const uintptr_t reason[2] = { 0x20026, (uintptr_t)code };   /* application exit */
    semihost(0x20, reason);
    say_number("halted ", (uint32_t)code, 10, 1);
    say("\n");
    for (;;)
#if defined __aarch64__ || __ARM_ARCH >= 7
        __asm__ volatile("wfi");
#else
        __asm__ volatile("mcr p15, 0, %0, c7, c0, 4" : : "r"(0));
#endif
}

void fault(uint32_t class, uintptr_t pc, uintptr_t address)
{
    say(class == 0      ? "fault: undefined instruction"
        : class == 0x21 ? "fault: no instruction there"
        : class == 0x25 ? "fault: no such data"
                        : "fault");
    say_number(", pc ", (uint32_t)pc, 16, 8);
    say_number(" address ", (uint32_t)address, 16, 8);
    say("\n");
    halt(2);
}
