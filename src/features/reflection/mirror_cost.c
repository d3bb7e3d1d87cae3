/* SPDX-License-Identifier: MIT */
/* What the mirror of objects costs: pixels of water that look into it.  What is drawn in
 * it counts its own faces. */
#include "features/reflection/mirror.h"
#include "scene/works.h"

static void pixels(tp_site *w, const tp_work_pixels *px)
{
    if (!w->mirrors)
        return;
    w->works.of[TP_WORK_looked] = px->water;
    w->works.of[TP_WORK_looked_near] = px->mirrored;
}

const tp_cost tp_mirror_cost = { .pixels = pixels };
