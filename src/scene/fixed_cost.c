/* SPDX-License-Identifier: MIT */
/* Counts the works of a frame, the cost besides finding and shading water, without
 * drawing; each module counts its own.  The rungs do not change the works, so the choice
 * of rungs ignores them; reports add them to the total cost of a frame.  Moving objects
 * are counted at their start position in the scene. */
#include "scene/fixed_cost.h"

/* The enabled modules with a cost. */
typedef struct {
    const tp_cost *cost[TP_MODULES];
    uint32_t stopped[TP_MODULES];       /* rays stopped by each module */
    uint32_t count;
} costs;

static costs collect_costs(const tp_plan_input *in, tp_want want)
{
    costs all = { .count = 0 };

    for (const tp_use *u = in->modules; u && u->module; u++)
        if (tp_module_ask_enabled(u->module, &want) && u->drawing && u->cost)
            all.cost[all.count++] = u->cost;
    return all;
}

static uint32_t count_bits(uint32_t word)
{
    uint32_t n = 0;

    for (; word; word &= word - 1)
        n++;
    return n;
}

/* Tests a ray that would meet water.  If objects of several modules stop the ray, the
 * last module counts the ray. */
static void test_ray_for_objects(tp_site *w, costs *all, int32_t i, int32_t j, int64_t far)
{
    const tp_vec3 ray = tp_work_ray(w, i, j);
    uint32_t by = all->count;

    for (uint32_t k = 0; k < all->count; k++)
        if (all->cost[k]->stops && all->cost[k]->stops(w, ray, far))
            by = k;
    if (by == all->count || w->solid[j] >> i & 1)
        return;
    w->solid[j] |= 1u << i;
    w->apart++;
    all->stopped[by]++;
}

/* Finds the rays that meet water, and among them the rays that meet water near enough to
 * reflect objects: up to an eighth beyond the objects, as in the stage of the planar
 * reflection. */
static void cast_rays(tp_site *w, costs *all, uint32_t near[TP_RAYS])
{
    const tp_start_view *at = &w->at;

    for (int32_t j = 0; j < TP_RAYS; j++) {
        near[j] = w->wet[j] = 0;
        for (int32_t i = 0; i < TP_RAYS; i++) {
            const int64_t far =
                tp_start_view_water_distance(at, at->wide * (2 * i + 1 - TP_RAYS) / TP_RAYS,
                                    at->high * (2 * j + 1 - TP_RAYS) / TP_RAYS);
            if (far > 0)
                test_ray_for_objects(w, all, i, j, far);
            w->wet[j] |= (uint32_t)(far > 0) << i;
            near[j] |= (uint32_t)(far > 0 && far < w->far + w->far / 8) << i;
        }
    }
}

static void add_pixel_costs(tp_site *w, costs *all)
{
    uint32_t near[TP_RAYS], sky = 0, water = 0, hidden = 0, solid = 0, looks = 0;

    cast_rays(w, all, near);
    for (int j = 0; j < TP_RAYS; j++) {
        solid += count_bits(w->solid[j]);
        hidden += count_bits(w->wet[j] & w->solid[j]);
        water += count_bits(w->wet[j] & ~w->solid[j]);
        looks += count_bits(near[j] & ~w->solid[j]);
        sky += count_bits(~(w->wet[j] | w->solid[j]));
    }
    w->fixed_cost.hidden = tp_work_ray_pixels(w, hidden);
    w->fixed_cost.solid = tp_work_ray_pixels(w, solid);
    w->fixed_cost.of[TP_WORK_solid] = tp_work_ray_pixels(w, solid - w->apart);
    for (uint32_t k = 0; k < all->count; k++) {
        const tp_work_pixels pixels = {
            tp_work_ray_pixels(w, sky), tp_work_ray_pixels(w, water),
            tp_work_ray_pixels(w, solid - w->apart), tp_work_ray_pixels(w, looks),
            all->stopped[k],
        };
        if (all->cost[k]->pixels)
            all->cost[k]->pixels(w, &pixels);
    }
}

tp_fixed_cost tp_fixed_cost_estimate(const tp_plan_input *in,
                                     const tp_view_estimate *estimate, bool quick)
{
    tp_site w = {
        .scene = in->scene, .assets = in->assets, .estimate = estimate, .quick = quick,
        .width = in->width, .height = in->height,
        .at = tp_start_view_make(in->scene, in->width, in->height), .is = estimate->modules,
    };
    costs all = collect_costs(in, tp_plan_want(in));

    w.mirrors = w.is & TP_MODULE_MIRROR && w.at.eye.y > 0;
    for (uint32_t k = 0; k < all.count; k++)
        if (all.cost[k]->work)
            all.cost[k]->work(&w);
    add_pixel_costs(&w, &all);
    return w.fixed_cost;
}
