/* SPDX-License-Identifier: MIT */
/* Haze: air between the eye and everything but the sky.
 *
 *     haze_drawing.c   the module
 *     haze_stage.c     its rule, and the span stages, one for each kind of sky */
#ifndef TP_HAZE_MODULE_H
#define TP_HAZE_MODULE_H
#include "scene/module.h"
#include "shade/wide.h"

#define TP_HAZE_ID TP_MODULE_ID('h', 'a', 'z', 'e')

/* Data of the stages, in tp_run.mine. */
typedef struct {
    uint32_t scale;             /* zi to entries of the table, Q0.32 */
} tp_haze;

#define TP_HAZE 512
extern const tp_entry8 tp_haze_table[TP_HAZE + 1];      /* share of the horizon */
#endif
