/* SPDX-License-Identifier: MIT */
/* Every model of the water, each worked for a known number of units, for whoever counts
 * instructions: callgrind on this machine, count.c's plugin on an emulated board.
 *
 * A model is prepared, then counted_NAME runs between the marks; count_section ends its
 * section, and a line says what the section held:
 *     model NAME UNIT units N bytes B EACH
 * Units are what the figure is divided by; B is the memory that the model keeps for what
 * EACH says, 0: none.  Only what the core executes is a model's: the instructions of
 * counted_NAME itself, its loop and the choice of places, are left out by who adds up.
 *
 * Freestanding where the compiler is told so: static memory, words by semihosting.  What
 * a row promises (no breaking, water that moves, all in view) is looked at as it runs;
 * a row that does not hold ends the program with 1. */
#include "cortex-m/marks.h"
#include "tests/budgets/models.h"
#include "tests/budgets/say.h"

model_place model;
static const char *broken;

void model_expect(bool holds, const char *otherwise)
{
    if (!holds && !broken)
        broken = otherwise;
}

MARK(count_as_model)
MARK(count_end)
MARK(count_section)

/* -- all of them --------------------------------------------------------------------- */

static bool count(const model_row *row)
{
    model.count = row->units;
    model.bytes = 0;
    row->prepare(row->kind);
    count_as_model();
    row->run();
    count_end();
    count_section();
    say("model ");
    say(row->name);
    say(" ");
    say(row->unit);
    say_number(" units ", model.count);
    say_number(" bytes ", model.bytes);
    say(" ");
    say(row->each);
    say("\n");
    if (broken) {
        say("FAILED ");
        say(broken);
        say("\n");
    }
    return !broken;
}

int main(void)
{
    static const model_row *const lists[] = {
        model_seas, model_oceans, model_pools, model_drops, model_grids,
    };

    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        for (const model_row *row = lists[i]; row->name; row++)
            if (!count(row))
                return 1;
    return 0;
}
