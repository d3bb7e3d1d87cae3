/* SPDX-License-Identifier: MIT */
/* The program that a NULL stands for. */
#ifndef TP_SCENE_PROGRAM_H
#define TP_SCENE_PROGRAM_H
#include "tidepool/modules.h"

/* The program that NULL stands for. */
static inline const tp_program *tp_program_or_linked(const tp_program *program)
{
    return program ? program : tp_program_linked;
}
#endif
