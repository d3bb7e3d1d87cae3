/* SPDX-License-Identifier: MIT */
/* The second core: its start by the protocol of the boot ROM, words from core to core in
 * the mailbox FIFOs, and spin locks.  After a send the other core is woken by an event. */
#include "pico.h"

#define KEPT_OFF    (CHIP_POWER + 4)    /* blocks kept in reset */

enum { CPUID = 0x000, FIFO_ST = 0x050, FIFO_WR = 0x054, FIFO_RD = 0x058,
       SPINLOCK0 = 0x100 };
enum { FIFO_CAME = 1, FIFO_ROOM = 2 };

uint32_t pico_core(void)
{
    return PICO_SIO(CPUID);
}

/* -- words --------------------------------------------------------------------------- */

void cores_send(uint32_t word)
{
    while (!(PICO_SIO(FIFO_ST) & FIFO_ROOM))
        ;
    PICO_SIO(FIFO_WR) = word;
    __asm__ volatile("dmb\n\tsev" ::: "memory");
}

uint32_t cores_receive(void)
{
    while (!(PICO_SIO(FIFO_ST) & FIFO_CAME))
        __asm__ volatile("wfe");
    const uint32_t word = PICO_SIO(FIFO_RD);
    __asm__ volatile("dmb" ::: "memory");
    return word;
}

/* -- locks --------------------------------------------------------------------------- */

/* A read takes the lock and returns 0 if the lock is taken. */
void cores_lock(uint32_t lock)
{
    while (!PICO_SIO(SPINLOCK0 + 4 * lock))
        ;
    __asm__ volatile("dmb" ::: "memory");
}

void cores_unlock(uint32_t lock)
{
    __asm__ volatile("dmb" ::: "memory");
    PICO_SIO(SPINLOCK0 + 4 * lock) = 0;
}

/* -- start --------------------------------------------------------------------------- */

static void empty_fifo(void)
{
    while (PICO_SIO(FIFO_ST) & FIFO_CAME)
        (void)PICO_SIO(FIFO_RD);
}

/* Core 1 leaves its reset in the boot ROM, which sends 0 when it is ready, waits for these
 * words and answers each with the same word; another answer starts the sequence anew. */
void cores_start(void (*entry)(void))
{
    const uint32_t words[] = {
        0, 0, 1, (uint32_t)(uintptr_t)start_vectors(),
        (uint32_t)(uintptr_t)start_stack_top(1), (uint32_t)(uintptr_t)entry,
    };

    PICO_SET(KEPT_OFF) = CHIP_CORE1;
    while (!(PICO_AT(KEPT_OFF) & CHIP_CORE1))
        ;
    empty_fifo();
    PICO_CLEAR(KEPT_OFF) = CHIP_CORE1;
    cores_receive();
    for (uint32_t i = 0; i < sizeof words / sizeof *words; ) {
        if (!words[i]) {
            empty_fifo();
            __asm__ volatile("sev");
        }
        cores_send(words[i]);
        i = cores_receive() == words[i] ? i + 1 : 0;
    }
}
