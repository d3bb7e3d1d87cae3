/* SPDX-License-Identifier: MIT */
/*
 * Counts the fixed cost of a frame, besides finding and shading water, without drawing,
 * seen by the start camera of the scene; each module counts its own.  The rungs do not
 * change the fixed cost, so the choice of rungs ignores it; reports add it to the total
 * cost of a frame.  Moving objects are counted at their start position in the scene.
 */
#include "quality/prices.h"
#include "view/grid.h"
#include "world/pools.h"

/* -- the start camera ---------------------------------------------------------------- */

/* Returns the position of the eye. A camera on the boat has a position in deck axes. */
static tp_vec3 start_eye(const tp_scene *s)
{
    tp_vec3 eye = { s->camera.x, s->camera.y, s->camera.z };

    if (s->camera.follow == TP_FOLLOW_BOAT) {
        const tp_turn heading = tp_turn_of_degrees(s->boat.heading);
        const tp_rotation boat = tp_rotation_from_angles(heading, 0, 0);
        eye = tp_rotate_back(&boat, eye);
        eye.x = tp_fx_saturate((int64_t)eye.x + s->boat.x);
        eye.z = tp_fx_saturate((int64_t)eye.z + s->boat.z);
    }
    return eye;
}

/* Water reaches 16 km in every direction, or to the tank's walls. */
static tp_rectangle water_extent(const tp_scene *s, tp_vec3 eye)
{
    const tp_fx far = 16000 * TP_FX_ONE;

    return tp_is_walled(s) ? tp_pool_sides(s) : tp_rectangle_make(eye.x, eye.z, far, far);
}

tp_start_view tp_start_view_make(const tp_scene *s, uint32_t width, uint32_t height)
{
    TP_ASSERT(width > 0 && height > 0);
    const tp_dir3 half =
        tp_rotation_from_angles(tp_turn_of_degrees(s->camera.fov) / 2, 0, 0).x;
    const tp_turn aboard = s->camera.follow == TP_FOLLOW_BOAT
                         ? tp_turn_of_degrees(s->boat.heading) : 0;
    tp_start_view at = { .eye = start_eye(s) };

    at.turn = tp_rotation_from_angles(aboard + tp_turn_of_degrees(s->camera.heading),
                                      tp_turn_of_degrees(s->camera.pitch), 0);
    at.high = ((int64_t)half.z * 65536) / half.x;
    at.wide = at.high * width / height;
    at.water = water_extent(s, at.eye);
    return at;
}

/* -- pixels -------------------------------------------------------------------------- */

tp_vec3 tp_start_view_ray(const tp_start_view *at, int64_t x, int64_t y)
{
    return tp_rotate_back(&at->turn, (tp_vec3){ (tp_fx)x, (tp_fx)y, -TP_FX_ONE });
}

int64_t tp_start_view_water_distance_ahead(const tp_start_view *at, int64_t x, int64_t y)
{
    const tp_vec3 ray = tp_start_view_ray(at, x, y);

    if (ray.y == 0 || at->eye.y == 0 || (ray.y < 0) != (at->eye.y > 0))
        return 0;
    const int64_t far = (int64_t)at->eye.y * 65536 / -ray.y;    /* Q16 m, up to 2^47 */
    if (far > (int64_t)1 << 32)
        return 0;
    const int64_t px = at->eye.x + (far * ray.x >> 16);
    const int64_t pz = at->eye.z + (far * ray.z >> 16);
    return px >= at->water.x0 && px <= at->water.x1
        && pz >= at->water.z0 && pz <= at->water.z1 ? far : 0;
}

/* -- fixed cost ---------------------------------------------------------------------- */

#define COSTED 16               /* modules with a cost; of a longer list the first ones */

/* The cost callbacks of the enabled modules. */
typedef struct {
    const tp_cost *cost[COSTED];
    uint16_t stopped[COSTED];   /* rays stopped by each module */
    uint32_t count;
} cost_callbacks;

static cost_callbacks collect_cost_callbacks(const tp_plan_input *in,
                                             tp_module_conditions conditions)
{
    cost_callbacks callbacks = { .count = 0 };

    for (const tp_use *u = in->modules; u && u->module; u++)
        if (tp_module_ask_condition(u->module, &conditions) && u->drawing && u->cost
            && callbacks.count < COSTED)
            callbacks.cost[callbacks.count++] = u->cost;
    return callbacks;
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
static void count_ray_stopped_by_object(tp_site *site, cost_callbacks *callbacks,
                                        int32_t i, int32_t j, int64_t far)
{
    const tp_vec3 ray = tp_work_ray(site, i, j);
    uint32_t by = callbacks->count;

    for (uint32_t k = 0; k < callbacks->count; k++)
        if (callbacks->cost[k]->stops && callbacks->cost[k]->stops(site, ray, far))
            by = k;
    if (by == callbacks->count || site->solid[j] >> i & 1)
        return;
    site->solid[j] |= 1u << i;
    site->apart++;
    callbacks->stopped[by]++;
}

/* Sets the bit of each ray that meets water in site->wet[row].  Counts rays that an object
 * stops before the water in `callbacks`, and sets their bits in site->solid.  Returns the
 * rays to water near enough to reflect objects: up to an eighth beyond the objects, as in
 * the stage of the planar reflection. */
static uint32_t mark_water_rays(tp_site *site, cost_callbacks *callbacks)
{
    const tp_start_view *at = &site->at;
    uint32_t looks = 0;

    for (int32_t j = 0; j < TP_RAYS; j++) {
        uint32_t reflecting = 0;
        site->wet[j] = 0;
        for (int32_t i = 0; i < TP_RAYS; i++) {
            const int64_t far = tp_start_view_water_distance_ahead(
                at, at->wide * (2 * i + 1 - TP_RAYS) / TP_RAYS,
                at->high * (2 * j + 1 - TP_RAYS) / TP_RAYS);
            if (far > 0)
                count_ray_stopped_by_object(site, callbacks, i, j, far);
            site->wet[j] |= (uint32_t)(far > 0) << i;
            reflecting |= (uint32_t)(far > 0 && far < site->far + site->far / 8) << i;
        }
        looks += count_bits(reflecting & ~site->solid[j]);
    }
    return looks;
}

/* Returns the pixels of outlines, drawn over what lies behind: 23 sqrt(area), as measured
 * for a longship with its ropes, oars and shields. */
static uint32_t outline_pixels(const tp_site *site, uint32_t solid)
{
    const uint32_t outline = 23 * tp_isqrt64((uint64_t)solid << 16) >> 8;

    if (!(site->is & TP_MODULE_OUTLINES))
        return 0;
    return outline < solid / 2 ? outline : solid / 2;
}

/* Counts the picture's pixels by content, and lets each module add the work of its pixels
 * to site->fixed_cost. */
static void add_pixels_to_fixed_cost(tp_site *site, cost_callbacks *callbacks)
{
    const uint32_t looks = mark_water_rays(site, callbacks);
    uint32_t sky = 0, water = 0, hidden = 0, solid = 0;

    for (int j = 0; j < TP_RAYS; j++) {
        solid += count_bits(site->solid[j]);
        hidden += count_bits(site->wet[j] & site->solid[j]);
        water += count_bits(site->wet[j] & ~site->solid[j]);
        sky += count_bits(~(site->wet[j] | site->solid[j]));
    }
    const uint32_t all = tp_work_ray_pixels(site, solid);
    const uint32_t behind = outline_pixels(site, all);
    site->fixed_cost.hidden = tp_work_ray_pixels(site, hidden);
    site->fixed_cost.hidden -= (uint32_t)((uint64_t)site->fixed_cost.hidden * behind
                                          / (all + !all));
    site->fixed_cost.solid = all;
    site->fixed_cost.of[TP_WORK_solid] = tp_work_ray_pixels(site, solid - site->apart);
    for (uint32_t k = 0; k < callbacks->count; k++) {
        const tp_work_pixels pixels = {
            tp_work_ray_pixels(site, sky), tp_work_ray_pixels(site, water),
            tp_work_ray_pixels(site, solid - site->apart), tp_work_ray_pixels(site, looks),
            callbacks->stopped[k],
        };
        if (callbacks->cost[k]->pixels)
            callbacks->cost[k]->pixels(site, &pixels);
    }
}

tp_fixed_cost tp_fixed_cost_estimate(const tp_plan_input *in,
                                     const tp_view_estimate *estimate, bool quick)
{
    tp_site site = {
        .scene = in->scene, .assets = in->assets, .estimate = estimate, .quick = quick,
        .width = in->width, .height = in->height,
        .at = tp_start_view_make(in->scene, in->width, in->height), .is = estimate->modules,
    };
    cost_callbacks callbacks = collect_cost_callbacks(in, tp_plan_module_conditions(in));

    site.mirrors = site.is & TP_MODULE_MIRROR && site.at.eye.y > 0;
    for (uint32_t k = 0; k < callbacks.count; k++)
        if (callbacks.cost[k]->work)
            callbacks.cost[k]->work(&site);
    add_pixels_to_fixed_cost(&site, &callbacks);
    return site.fixed_cost;
}
