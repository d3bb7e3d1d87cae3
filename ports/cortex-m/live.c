/* SPDX-License-Identifier: MIT */
/* See live.h. */
#include "live.h"
#include "world/text.h"

#define TICKS_AT_ONCE 8

void live_number(uint32_t n, uint32_t base, int least_digits)
{
    char  text[34];
    char *at = text + sizeof text - 1;
    *at = '\0';
    for (; n || least_digits > 0; n /= base, least_digits--)
        *--at = "0123456789abcdef"[n % base];
    live_text(NULL, at);
}

void live_say(const char *what, size_t n)
{
    live_text(NULL, what);
    live_number((uint32_t)n, 10, 1);
}

_Noreturn void live_halt(const char *why)
{
    live_text(NULL, "\nerror ");
    live_text(NULL, why);
    live_text(NULL, "\n");
    for (;;)
        ;
}

void *live_take(tp_arena *arena, const char *what, size_t bytes)
{
    void *memory = tp_arena_alloc(arena, 1, bytes);
    live_say(what, bytes);
    if (!memory)
        live_halt("that does not fit");
    return memory;
}

void live_echo(const tp_world *world, const tp_input *input)
{
    const tp_tape_entry entry = { tp_world_tick(world), *input };
    char text[TP_TAPE_LINE];
    if (tp_tape_write(&entry, text, sizeof text)) {
        live_text(NULL, text);
        live_text(NULL, "\n");
    }
}

bool live_make_ticks(uint32_t *owed, uint32_t units_of_a_tick, control *lines,
                     void (*tick)(void))
{
    bool made = false;
    if (*owed > TICKS_AT_ONCE * units_of_a_tick)
        *owed = TICKS_AT_ONCE * units_of_a_tick;
    for (; *owed >= units_of_a_tick; *owed -= units_of_a_tick)
        if (control_reads(lines) && control_ticks(lines)) {
            tick();
            made = true;
        }
    while (!control_reads(lines) && control_ticks(lines)) {
        tick();
        made = true;
    }
    return made;
}
