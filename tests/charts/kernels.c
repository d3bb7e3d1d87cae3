/* SPDX-License-Identifier: MIT */
/* Runs each kernel once between the marks of count.sh and prints its name:
 *     kernel CHART POINT
 * Freestanding if the compiler is in freestanding mode: static memory, words by
 * semihosting. */
#include "cortex-m/trace_marks.h"
#include "tests/lib/board_output.h"
#include "tests/charts/kernels.h"

static int32_t in[KERNEL_UNITS * KERNEL_WIDTH], out[KERNEL_UNITS * KERNEL_WIDTH];

TRACE_MARK(count_as_kernel)
TRACE_MARK(count_end)
TRACE_MARK(count_section)

int main(void)
{
    for (const kernel *const *list = kernel_lists; *list; list++)
        for (const kernel *k = *list; k->chart; k++) {
            k->fill(in);
            count_as_kernel();
            k->run(in, out);
            count_end();
            count_section();
            say("kernel ");
            say(k->chart);
            say(" ");
            say(k->point);
            say("\n");
        }
    return 0;
}
