/* SPDX-License-Identifier: MIT */
/* Cost estimate of skies: their pixels, and light above white in the water's reflection. */
#include "features/sky/sky.h"
#include "scene/fixed_cost.h"

static void add_hdr_work(tp_site *w, const tp_work_pixels *px)
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
    add_hdr_work(w, px);
}

static void count_cube_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    w->fixed_cost.of[TP_WORK_sky_cube] = px->sky;
    add_hdr_work(w, px);
}

static void count_star_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    w->fixed_cost.of[TP_WORK_sky_stars] = px->sky;
}

const tp_cost tp_sky_dome_cost = { .pixels = count_dome_pixel_work };
const tp_cost tp_sky_cube_cost = { .pixels = count_cube_pixel_work };
const tp_cost tp_stars_cost = { .pixels = count_star_pixel_work };
