/* SPDX-License-Identifier: MIT */
/* Runs each model of the water for a known number of units between counting marks:
 * callgrind counts on this machine, count.c's plugin on an emulated board.
 *
 * A model is prepared, then counted_NAME runs between the marks; count_section ends the
 * model's section, and a line describes the section:
 *     model NAME UNIT units N bytes B EACH
 * N is the divisor of the figure. B is the memory that the model keeps for each EACH, 0:
 * none. Only the core's instructions belong to a model: the scripts leave out the
 * instructions of counted_NAME itself, its loop and the choice of places.
 *
 * Freestanding if the compiler is in freestanding mode: static memory, words by
 * semihosting. Each row's assumptions (no breaking, moving water, all in view) are checked
 * during the run; a row that fails ends the program with 1. */
#include "cortex-m/trace_marks.h"
#include "tests/budgets/models.h"
#include "tests/lib/board_output.h"

model_place model;
static const char *broken;

void model_expect(bool holds, const char *otherwise)
{
    if (!holds && !broken)
        broken = otherwise;
}

TRACE_MARK(count_as_model)
TRACE_MARK(count_end)
TRACE_MARK(count_section)

/* -- run of the rows ----------------------------------------------------------------- */

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
