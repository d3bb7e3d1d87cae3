/* SPDX-License-Identifier: MIT */
/* Parts of live boards: texts over the serial port, a report of the memory taken, and ticks
 * that follow a clock. */
#ifndef TP_CORTEX_M_LIVE_H
#define TP_CORTEX_M_LIVE_H
#include "base/base.h"
#include "serial/control.h"
#include "tidepool/world.h"

/* Defined by the board: writes a text to the serial port and waits until it is taken. */
void live_text(void *unused, const char *text);

void live_number(uint32_t n, uint32_t base, int least_digits);  /* base 2 to 16 */
void live_say(const char *what, size_t n);                      /* n in decimal */
_Noreturn void live_halt(const char *why);                      /* "error WHY", and stops */

/* Allocates memory in the arena and reports its size; halts if the memory is too small. */
void *live_take(tp_arena *arena, const char *what, size_t bytes);

/* Writes the input of the next tick as a line of a tape. */
void live_echo(const tp_world *world, const tp_input *input);

/* Makes the ticks now due: those of a `step` command at once, others by the clock.  `owed`:
 * units of the board's clock since the last tick, of which the ticks are taken; a backlog of
 * more than eight ticks is dropped: water slows down.  Returns true if a tick was made. */
bool live_make_ticks(uint32_t *owed, uint32_t units_of_a_tick, control *lines,
                     void (*tick)(void));
#endif
