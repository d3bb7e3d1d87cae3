/* SPDX-License-Identifier: MIT */
/* Cost estimate of drops: rings at the water's grid vertices, and the spheres' faces. */
#include "features/drops/drops.h"
#include "quality/fixed_cost.h"

#define BALL_FACES 440          /* faces of a large sphere; a small one has a quarter */

/* Counts the faces of the releasing sphere, in the main view and in the reflection. */
static void count_work(tp_site *w)
{
    const tp_view_estimate *o = w->estimate;
    const tp_scene *s = w->scene;
    const tp_vec3 sphere = { s->drops.x, s->drops.y, s->drops.z };
    const tp_vec3 way = tp_start_view_clamped_vector(w->at.eye, sphere);
    const tp_vec3 view = tp_rotate(&w->at.turn, way);
    uint32_t *work = w->fixed_cost.of;

    work[TP_WORK_rings] = s->drops.interval > 0 ? o->vertices : 0;
    if (-view.z <= 0)
        return;
    const int64_t rows = (int64_t)o->focal * 4 * s->drops.radius / -view.z;
    const uint32_t faces = rows > 16 ? BALL_FACES : BALL_FACES / 4;
    work[TP_WORK_ball] = faces * tp_work_bands(rows, TP_WORK_BAND);
    if (w->mirrors) {
        work[TP_WORK_ball] += faces * tp_work_bands(rows / 2, TP_WORK_STRIP);
        w->far = -view.z > w->far ? -view.z : w->far;
    }
}

const tp_cost tp_drops_cost = { .work = count_work };
