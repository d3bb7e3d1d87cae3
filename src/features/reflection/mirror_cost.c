/* SPDX-License-Identifier: MIT */
/* The costs of the mirror of objects: pixels of water that read its picture.  Each object
 * counts the faces that it has in the mirror. */
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
