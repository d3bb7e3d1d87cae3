/* SPDX-License-Identifier: MIT */
/* Cost estimate of the planar reflection: water pixels that read the planar map.  Each
 * object's own cost function counts its faces in the reflection. */
#include "features/reflection/reflection.h"
#include "quality/fixed_cost.h"

static void count_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    if (!w->mirrors)
        return;
    w->fixed_cost.of[TP_WORK_looked] = px->water;
    w->fixed_cost.of[TP_WORK_looked_near] = px->mirrored;
}

const tp_cost tp_mirror_cost = { .pixels = count_pixel_work };
