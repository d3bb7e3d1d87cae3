/* SPDX-License-Identifier: MIT */
/* Which kit this processor can run: the host's program holds the hot loops twice, for any
 * x86-64 and for those of level v3 (AVX2).  Both draw the same bits. */
#ifndef HOST_MACHINE_H
#define HOST_MACHINE_H
#include "tidepool/kit.h"

typedef struct {
    const char   *name;         /* "baseline", "x86-64-v3" */
    const tp_kit *kit;
} machine;

/* All that this processor can run, best first; the last is "baseline". */
const machine *machine_kits(size_t *count);
#endif
