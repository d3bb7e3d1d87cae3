/* SPDX-License-Identifier: MIT */
/* Selects the linked program for calls without a program. */
#ifndef TP_SCENE_PROGRAM_H
#define TP_SCENE_PROGRAM_H
#include "tidepool/modules.h"

static inline const tp_program *tp_program_or_linked(const tp_program *program)
{
    return program ? program : tp_program_linked;
}
#endif
