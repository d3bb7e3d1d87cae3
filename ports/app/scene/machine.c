/* SPDX-License-Identifier: MIT */
/* Asks the processor for its level.  Every existing processor with the four features below
 * has all of level v3. */
#include "machine.h"
#include <stdbool.h>
#include "tidepool/modules.h"

#ifdef TP_HAVE_PROGRAM_V3
extern const tp_program tp_program_v3;

static const machine all[] = {
    { "x86-64-v3", &tp_program_v3 },
    { "baseline", &tp_program_all },
};

static bool has_v3(void)
{
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi")
        && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
}
#else
static const machine all[] = { { "baseline", &tp_program_all } };

static bool has_v3(void)
{
    return true;
}
#endif

const machine *machine_list(size_t *count)
{
    const size_t skipped = has_v3() ? 0 : 1;

    *count = sizeof all / sizeof *all - skipped;
    return all + skipped;
}
