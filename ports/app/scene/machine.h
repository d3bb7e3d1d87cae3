/* SPDX-License-Identifier: MIT */
/* Builds of the core for this processor.  The host has the hot loops twice, for any x86-64
 * and for level v3 (AVX2).  Both draw the same bits. */
#ifndef TP_APP_SCENE_MACHINE_H
#define TP_APP_SCENE_MACHINE_H
#include "tidepool/world.h"

typedef struct {
    const char   *name;         /* "baseline", "x86-64-v3" */
    const tp_program *program;
} machine;

/* Returns all builds for this processor, best first; the last is "baseline". */
const machine *machine_list(size_t *count);
#endif
