/* SPDX-License-Identifier: MIT */
/*
 * Cost estimate of skies and haze: the pixels of the sky, light above white in the
 * water's reflection, and haze over solids.  With a dome or a cube sky haze costs more,
 * over water too.
 */
#include "features/sky/sky.h"
#include "quality/fixed_cost.h"

static void count_hdr_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    const tp_scene *s = w->scene;

    if (s->hdr.share <= 0)
        return;
    w->fixed_cost.of[TP_WORK_sky_hdr] = px->sky;
    w->fixed_cost.of[TP_WORK_hdr] = s->water.reflection > 0 ? px->water : 0;
}

static void count_dome_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    const bool quick = w->quick && !(w->is & TP_MODULE_STARS);

    w->fixed_cost.of[quick ? TP_WORK_sky_quick : TP_WORK_sky_dome] = px->sky;
    count_hdr_pixel_work(w, px);
}

static void count_cube_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    w->fixed_cost.of[TP_WORK_sky_cube] = px->sky;
    count_hdr_pixel_work(w, px);
}

static void count_star_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    w->fixed_cost.of[TP_WORK_sky_stars] = px->sky;
}

const tp_cost tp_sky_dome_cost = { .pixels = count_dome_pixel_work };
const tp_cost tp_sky_cube_cost = { .pixels = count_cube_pixel_work };
const tp_cost tp_stars_cost = { .pixels = count_star_pixel_work };

static void count_haze_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    uint32_t *work = w->fixed_cost.of;

    work[TP_WORK_haze] = px->solid;
    work[TP_WORK_haze_dome] = w->is & TP_MODULE_DOME ? px->water + px->solid : 0;
    work[TP_WORK_haze_cube] = w->is & TP_MODULE_CUBE ? px->water + px->solid : 0;
}

const tp_cost tp_haze_cost = { .pixels = count_haze_pixel_work };
