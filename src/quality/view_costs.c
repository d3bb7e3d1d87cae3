/* SPDX-License-Identifier: MIT */
/* The parts of a frame's cost for the exact effects, and the cost and error of a set of
 * rungs. */
#include "quality/rung_sets.h"
#include "base/base.h"
#include "quality/conditions.h"
#include "quality/processor_prices.h"
#include "quality/rung_prices.h"

_Static_assert(TP_RUNG_KINDS <= 32, "a set's open kinds are bits of a word");

/* -- parts --------------------------------------------------------------------------- */

/* The part to which the pixels of a trait belong. */
static const uint8_t trait_part[TP_TRAIT_COUNT] = {
    [TP_TRAIT_plain] = TP_PART_plain, [TP_TRAIT_diffuse] = TP_PART_light,
    [TP_TRAIT_texture] = TP_PART_layers, [TP_TRAIT_linear] = TP_PART_layers,
    [TP_TRAIT_layer] = TP_PART_layers, [TP_TRAIT_lined] = TP_PART_layers,
    [TP_TRAIT_bend] = TP_PART_distortion, [TP_TRAIT_ripple] = TP_PART_ripple,
    [TP_TRAIT_bump] = TP_PART_ripple, [TP_TRAIT_look] = TP_PART_light,
    [TP_TRAIT_rough] = TP_PART_glint, [TP_TRAIT_mirror] = TP_PART_reflection,
    [TP_TRAIT_glint] = TP_PART_glint, [TP_TRAIT_dome] = TP_PART_reflection,
    [TP_TRAIT_cube] = TP_PART_reflection, [TP_TRAIT_haze] = TP_PART_haze,
    [TP_TRAIT_objects] = TP_PART_objects, [TP_TRAIT_behind] = TP_PART_refraction,
    [TP_TRAIT_bed] = TP_PART_refraction, [TP_TRAIT_chart] = TP_PART_refraction,
    [TP_TRAIT_tank] = TP_PART_refraction, [TP_TRAIT_caustic] = TP_PART_caustics,
    [TP_TRAIT_dispersion] = TP_PART_dispersion, [TP_TRAIT_foam] = TP_PART_foam,
    [TP_TRAIT_expose] = TP_PART_exposure,
};

/* The part to which each fixed cost belongs. */
static const uint8_t work_part[TP_WORK_COUNT] = {
    [TP_WORK_sky_dome] = TP_PART_sky, [TP_WORK_sky_quick] = TP_PART_reflection,
    [TP_WORK_sky_stars] = TP_PART_sky, [TP_WORK_sky_cube] = TP_PART_sky,
    [TP_WORK_sky_hdr] = TP_PART_exposure, [TP_WORK_haze] = TP_PART_haze,
    [TP_WORK_haze_dome] = TP_PART_haze, [TP_WORK_haze_cube] = TP_PART_haze,
    [TP_WORK_hdr] = TP_PART_exposure, [TP_WORK_solid] = TP_PART_solids,
    [TP_WORK_boat_face] = TP_PART_faces, [TP_WORK_boat_scan] = TP_PART_faces,
    [TP_WORK_boat_back] = TP_PART_faces, [TP_WORK_boat_piece] = TP_PART_faces,
    [TP_WORK_boat_fill] = TP_PART_solids, [TP_WORK_boat_cut] = TP_PART_faces,
    [TP_WORK_mirror_fill] = TP_PART_mirror, [TP_WORK_looked] = TP_PART_objects,
    [TP_WORK_looked_near] = TP_PART_objects, [TP_WORK_rings] = TP_PART_vertices,
    [TP_WORK_ball] = TP_PART_solids, [TP_WORK_wall] = TP_PART_walls,
    [TP_WORK_walled] = TP_PART_vertices, [TP_WORK_wall_face] = TP_PART_walls,
    [TP_WORK_pane] = TP_PART_refraction, [TP_WORK_side] = TP_PART_refraction,
    [TP_WORK_side_face] = TP_PART_walls, [TP_WORK_caustic_pool] = TP_PART_caustics,
    [TP_WORK_caustic_sea] = TP_PART_caustics, [TP_WORK_land] = TP_PART_land,
    [TP_WORK_land_row] = TP_PART_land, [TP_WORK_land_cell] = TP_PART_land,
    [TP_WORK_land_cut] = TP_PART_land, [TP_WORK_surf] = TP_PART_land,
    [TP_WORK_land_drawn] = TP_PART_land, [TP_WORK_land_fill] = TP_PART_land,
    [TP_WORK_spray] = TP_PART_spray,
};

/* Sets the parts of exact shading by one water renderer, instructions. */
static void set_parts(const tp_view_costs *view, const tp_plan_conditions *g,
                      uint8_t visibility, const tp_fixed_cost *works,
                      uint64_t part[TP_PART_COUNT])
{
    const tp_view_estimate *o = &g->estimate;
    const int drawn = o->fits[visibility] ? visibility : 0;
    const tp_seen_price *seen = &g->prices->seen[drawn];
    const tp_shaded_price *shaded = &g->prices->shaded[0][0];
    int64_t sum[TP_PART_COUNT] = { 0 };

    sum[TP_PART_frame] = (int64_t)g->prices->frame * 1000;
    sum[TP_PART_sky] = (int64_t)g->prices->sky * view->other;
    sum[TP_PART_visibility] = (int64_t)(o->still ? seen->still : seen->pixel) * view->water;
    sum[TP_PART_vertices] = tp_plan_point_price(g, seen) * o->points[drawn];
    for (int i = 0; i < TP_TRAIT_COUNT; i++)
        sum[trait_part[i]] += (int64_t)o->trait[i] * shaded->part[i] * view->water;
    for (int i = 0; i < TP_WORK_COUNT; i++)
        sum[work_part[i]] += (int64_t)g->prices->work[i] * works->of[i];
    sum[TP_PART_tables] = (int64_t)1000000 << 16;
    sum[TP_PART_store] = (int64_t)(10 << 16) * (view->water + view->other);
    sum[TP_PART_spans] = (int64_t)(20 << 16) * view->water;
    for (int i = 0; i < TP_PART_COUNT; i++)     /* some prices are negative */
        part[i] = sum[i] > 0 ? (uint64_t)sum[i] >> 16 : 0;
}

static tp_fx pixel_share(uint32_t pixels, const tp_plan_input *in)
{
    return (tp_fx)(((uint64_t)pixels << 16) / ((uint64_t)in->width * in->height));
}

/* A board's stack has no room for a copy of the costs: the caller's are set in place. */
void tp_view_costs_make(tp_view_costs *view, const tp_prices *prices,
                        const tp_plan_input *in)
{
    const tp_plan_conditions g = tp_plan_conditions_make(prices, in);
    const tp_fixed_cost works = tp_fixed_cost_estimate(in, &g.estimate, false);
    const uint32_t hidden = works.hidden < g.estimate.water_pixels
                                ? works.hidden : g.estimate.water_pixels;

    view->processor = TP_PROCESSOR_M4;
    view->estimate = g.estimate;
    view->culled = g.culled;
    view->fast = !(g.estimate.modules & TP_MODULE_EXACT);
    view->clear = (g.estimate.modules & TP_MODULE_CLEAR) != 0;
    view->water = g.estimate.water_pixels - hidden;
    view->other = g.estimate.other_pixels + hidden;
    view->share[TP_SHARE_all] = TP_FX_ONE;
    view->share[TP_SHARE_sky] = pixel_share(view->other, in);
    view->share[TP_SHARE_water] = pixel_share(view->water, in);
    view->share[TP_SHARE_mirrored] = pixel_share(works.of[TP_WORK_looked_near], in);
    view->share[TP_SHARE_solid] = pixel_share(works.solid, in);
    for (uint8_t v = 0; v < TP_VISIBILITIES; v++)
        set_parts(view, &g, v, &works, view->part[v]);
}

/* -- a set --------------------------------------------------------------------------- */

bool tp_rung_takes_effect(const tp_view_costs *view, const tp_rung_set *set, int kind)
{
    const tp_rung_effect *e = &tp_rung_effects[kind];

    if (kind == TP_KIND_SHADING || (e->needs_rung && e->needs_kind == TP_KIND_SHADING))
        return tp_set_is_fast(view, set);
    if (kind == TP_KIND_triangles)
        return set->of[TP_KIND_VISIBILITY] == 0;
    return !e->needs_rung || set->of[e->needs_kind] == e->needs_rung;
}

/* Sets the costs of the parts on a Cortex-M4; returns the set's square error. */
static uint64_t set_costs(const tp_view_costs *view, const tp_rung_set *set,
                          uint64_t cost[TP_PART_COUNT])
{
    const uint8_t *of = set->of;
    const int v = view->estimate.fits[of[TP_KIND_VISIBILITY]] ? of[TP_KIND_VISIBILITY] : 0;
    const uint16_t *factor = tp_part_factors[tp_set_is_fast(view, set)];
    uint64_t square = 0;

    for (int p = 0; p < TP_PART_COUNT; p++)
        cost[p] = view->part[v][p] * factor[p] >> 8;
    cost[TP_PART_vertices] >>= of[TP_KIND_vertices];
    for (int k = 0; k < TP_RUNG_KINDS; k++) {
        if (of[k] == 0 || !tp_rung_takes_effect(view, set, k))
            continue;
        const tp_rung_effect *e = &tp_rung_effects[k];
        const tp_rung_price *price = &tp_rung_prices[k][of[k]];
        for (int p = 0; p < TP_PART_COUNT; p++)
            if (e->parts >> p & 1)
                cost[p] = cost[p] * price->factor >> 8;
        square += (uint64_t)price->square[view->estimate.sea]
                * (uint32_t)view->share[e->share] >> 8;
    }
    return square;
}

uint64_t tp_set_part_costs(const tp_view_costs *view, const tp_rung_set *set,
                           uint64_t cost[TP_PART_COUNT])
{
    const uint64_t square = set_costs(view, set, cost);

    if (view->processor == TP_PROCESSOR_M0PLUS) {
        const uint16_t *factor = tp_m0plus_factors[tp_set_is_fast(view, set)];
        for (int p = 0; p < TP_PART_COUNT; p++)
            cost[p] = cost[p] * factor[p] >> 8;
    }
    return square;
}

tp_set_price tp_set_price_estimate(const tp_view_costs *view, const tp_rung_set *set)
{
    uint64_t cost[TP_PART_COUNT];
    tp_set_price sum = { 0, tp_set_part_costs(view, set, cost) };

    for (int p = 0; p < TP_PART_COUNT; p++)
        sum.cost += cost[p];
    return sum;
}
