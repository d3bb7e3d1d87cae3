/* SPDX-License-Identifier: MIT */
/* Cost estimate of haze over solids.  With a dome or a cube sky haze costs more, over
 * water too. */
#include "features/haze/haze.h"
#include "scene/fixed_cost.h"

static void count_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    uint32_t *work = w->fixed_cost.of;

    work[TP_WORK_haze] = px->solid;
    work[TP_WORK_haze_dome] = w->is & TP_MODULE_DOME ? px->water + px->solid : 0;
    work[TP_WORK_haze_cube] = w->is & TP_MODULE_CUBE ? px->water + px->solid : 0;
}

const tp_cost tp_haze_cost = { .pixels = count_pixel_work };
