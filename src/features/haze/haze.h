/* SPDX-License-Identifier: MIT */
/* Haze: air between the eye and everything except the sky.
 *
 *     haze_drawing.c   the module
 *     haze_stage.c     the rule, and the span stages, one for each kind of sky */
#ifndef TP_HAZE_MODULE_H
#define TP_HAZE_MODULE_H
#include "scene/module.h"
#include "shade/wide.h"

#define TP_HAZE_ID TP_MODULE_ID('h', 'a', 'z', 'e')

/* Data of the haze stages, in tp_run.mine. */
typedef struct {
    uint32_t scale;             /* factor from zi to table entries, Q0.32 */
} tp_haze;

#define TP_HAZE 512
extern const tp_entry8 tp_haze_table[TP_HAZE + 1];      /* horizon's share of 255 */
#endif
