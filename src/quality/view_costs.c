/* SPDX-License-Identifier: MIT */
/* The parts of a frame's cost for the exact effects, and the cost and error of a set of
 * rungs. */
#include "quality/rung_sets.h"
#include "base/base.h"
#include "quality/processor_prices.h"
#include "quality/rung_prices.h"

_Static_assert(TP_RUNG_KINDS <= 32, "a set's open kinds are bits of a word");
_Static_assert(TP_PART_COUNT <= 64, "the parts of a rung are bits of 64");

/* -- parts --------------------------------------------------------------------------- */

/* The part to which the pixels of a trait belong. */
static const uint8_t trait_part[TP_TRAIT_COUNT] = {
    [TP_TRAIT_plain] = TP_PART_plain, [TP_TRAIT_diffuse] = TP_PART_light,
    [TP_TRAIT_texture] = TP_PART_layers, [TP_TRAIT_linear] = TP_PART_linear,
    [TP_TRAIT_layer] = TP_PART_layers, [TP_TRAIT_lined] = TP_PART_linear,
    [TP_TRAIT_bend] = TP_PART_distortion, [TP_TRAIT_ripple] = TP_PART_ripple,
    [TP_TRAIT_bump] = TP_PART_ripple, [TP_TRAIT_look] = TP_PART_light,
    [TP_TRAIT_rough] = TP_PART_light, [TP_TRAIT_mirror] = TP_PART_reflection,
    [TP_TRAIT_glint] = TP_PART_glint, [TP_TRAIT_dome] = TP_PART_mirrored_sky,
    [TP_TRAIT_cube] = TP_PART_mirrored_sky, [TP_TRAIT_haze] = TP_PART_haze,
    [TP_TRAIT_objects] = TP_PART_objects, [TP_TRAIT_behind] = TP_PART_refraction,
    [TP_TRAIT_bed] = TP_PART_floor, [TP_TRAIT_chart] = TP_PART_floor,
    [TP_TRAIT_tank] = TP_PART_floor, [TP_TRAIT_caustic] = TP_PART_caustics,
    [TP_TRAIT_dispersion] = TP_PART_dispersion, [TP_TRAIT_foam] = TP_PART_foam,
    [TP_TRAIT_expose] = TP_PART_exposure,
};

/* The part to which each fixed cost belongs, and the instructions of a unit if the table
 * has none: its scene showed too few. */
static const struct {
    uint8_t part;
    uint16_t least;
} works[TP_WORK_COUNT] = {
    [TP_WORK_sky_dome] = { TP_PART_sky_kind, 0 },
    [TP_WORK_sky_quick] = { TP_PART_sky_kind, 0 },
    [TP_WORK_sky_stars] = { TP_PART_sky_kind, 0 },
    [TP_WORK_sky_cube] = { TP_PART_sky_kind, 0 },
    [TP_WORK_sky_hdr] = { TP_PART_sky_kind, 0 },
    [TP_WORK_haze] = { TP_PART_haze, 0 }, [TP_WORK_haze_dome] = { TP_PART_haze, 0 },
    [TP_WORK_haze_cube] = { TP_PART_haze, 0 }, [TP_WORK_hdr] = { TP_PART_exposure, 0 },
    [TP_WORK_solid] = { TP_PART_solids, 0 }, [TP_WORK_boat_face] = { TP_PART_faces, 0 },
    [TP_WORK_boat_scan] = { TP_PART_faces, 0 },
    [TP_WORK_boat_back] = { TP_PART_faces, 50 },
    [TP_WORK_boat_piece] = { TP_PART_faces, 0 },
    [TP_WORK_boat_fill] = { TP_PART_solids, 30 },
    [TP_WORK_boat_cut] = { TP_PART_faces, 0 },
    [TP_WORK_mirror_fill] = { TP_PART_mirror, 0 },
    [TP_WORK_looked] = { TP_PART_objects, 0 },
    [TP_WORK_looked_near] = { TP_PART_objects, 0 },
    [TP_WORK_rings] = { TP_PART_rings, 300 }, [TP_WORK_ball] = { TP_PART_solids, 100 },
    [TP_WORK_wall] = { TP_PART_walls, 0 }, [TP_WORK_walled] = { TP_PART_pools, 0 },
    [TP_WORK_wall_face] = { TP_PART_wall_faces, 500 },
    [TP_WORK_pane] = { TP_PART_glass, 10 }, [TP_WORK_side] = { TP_PART_glass, 0 },
    [TP_WORK_side_face] = { TP_PART_side_faces, 0 },
    [TP_WORK_caustic_pool] = { TP_PART_caustic_map, 0 },
    [TP_WORK_caustic_sea] = { TP_PART_caustic_map, 0 },
    [TP_WORK_land] = { TP_PART_land, 0 }, [TP_WORK_land_row] = { TP_PART_land_cells, 0 },
    [TP_WORK_land_cell] = { TP_PART_land_cells, 0 },
    [TP_WORK_land_cut] = { TP_PART_land_cells, 300 },
    [TP_WORK_surf] = { TP_PART_land_cells, 300 },
    [TP_WORK_land_drawn] = { TP_PART_land_cells, 0 },
    [TP_WORK_land_fill] = { TP_PART_land, 0 }, [TP_WORK_spray] = { TP_PART_spray, 0 },
};

static uint64_t whole(int64_t q16)
{
    return q16 > 0 ? (uint64_t)q16 >> 16 : 0;
}

#define PRICED_WAVES 3          /* in the scene that the price of wind was measured in */

/* Adds the points of a raised surface; only triangles and rows know pools and floors.
 * points < 2^20, prices < 2^28. */
static void set_raised_points(const tp_view_estimate *o, const tp_seen_price *price,
                              const tp_fixed_cost *fixed, const tp_prices *prices,
                              uint64_t seen[TP_PARTS_SEEN])
{
    const int64_t points = o->points[0];
    const tp_fx rings = prices->work[TP_WORK_rings];

    if (o->coastal && o->floor)
        seen[TP_PART_floor_points] =
            whole((o->floor > 1 ? price->map : price->floor) * points);
    else if (o->coastal)
        seen[TP_PART_wind] = whole(price->coastal * points) * o->waves / PRICED_WAVES;
    seen[TP_PART_pools] = whole((int64_t)price->pool * o->pools * points
        + (int64_t)prices->work[TP_WORK_walled] * fixed->of[TP_WORK_walled]);
    seen[TP_PART_rings] = whole((rings ? rings : (int64_t)works[TP_WORK_rings].least << 16)
                                * fixed->of[TP_WORK_rings]);
}

/* Sets the parts of finding the water by one renderer, instructions.  A cell has 500, and
 * each row of its edges 300: a cell is about as wide as high, so its rows are the square
 * root of its pixels. */
static void set_seen_parts(const tp_view_costs *view, const tp_prices *prices, int v,
                           const tp_fixed_cost *fixed, uint64_t seen[TP_PARTS_SEEN])
{
    const tp_view_estimate *o = &view->estimate;
    const tp_seen_price *price = &prices->seen[v];
    const int64_t points = o->points[v];
    const uint64_t cells = (uint64_t)points * o->in_view >> 8;

    for (int i = 0; i < TP_PARTS_SEEN; i++)
        seen[i] = 0;
    if (o->still)
        seen[TP_PART_level] = whole((int64_t)price->still * view->water);
    else                        /* the points of the flat renderer are priced alone */
        seen[TP_PART_visibility] =
            v == TP_VISIBILITY_FLAT - 1 ? (uint64_t)30 * view->water
                                        : whole((int64_t)price->pixel * view->water);
    seen[TP_PART_vertices] = whole(price->vertex * points);
    seen[TP_PART_waves] =
        whole(((int64_t)price->wave + (o->sharp ? price->sharp : 0)) * view->culled.left * points);
    if (v > TP_VISIBILITY_ROWS - 1)
        return;
    seen[TP_PART_cells] = 500 * cells;
    seen[TP_PART_edges] = (uint64_t)300 * tp_isqrt64(cells * view->water);
    set_raised_points(o, price, fixed, prices, seen);
}

/* True for a part that dome_light replaces under a dome. */
#define LIT_BY_DOME(p) ((p) >= TP_PART_light && (p) <= TP_PART_mirrored_sky)

/* Sets the parts of exact shading and of all else but finding the water.  Not inlined: the
 * stack has no room for its sums below the fixed cost. */
TP_NEVER_INLINE void set_parts(tp_view_costs *view, const tp_prices *prices,
                               const tp_plan_input *in, const tp_fixed_cost *fixed)
{
    const tp_view_estimate *o = &view->estimate;
    int64_t sum[TP_PART_COUNT] = { 0 };

    for (int i = 0; i < TP_TRAIT_COUNT; i++) {
        const int64_t price = i == TP_TRAIT_plain ? 8 << 16 : prices->shaded[i];
        const int p = trait_part[i];
        sum[o->trait[TP_TRAIT_dome] && LIT_BY_DOME(p) ? TP_PART_dome_light : p] +=
            o->trait[i] * price * view->water;
    }
    for (int i = 0; i < TP_WORK_COUNT; i++)
        sum[works[i].part] += (prices->work[i] ? (int64_t)prices->work[i]
                                               : (int64_t)works[i].least << 16)
                            * fixed->of[i];
    for (int i = TP_PARTS_SEEN; i < TP_PART_COUNT; i++)     /* some prices are negative */
        view->part[i] = whole(sum[i]);
    view->part[TP_PART_spans] = (uint64_t)500 * view->water / in->width;
    view->part[TP_PART_store] = (uint64_t)10 * (view->water + view->other);
    view->part[TP_PART_sky] = whole((int64_t)prices->sky * view->other);
    view->part[TP_PART_frame] = 1000000;
    view->part[TP_PART_rows] = (uint64_t)500 * in->height;
    view->part[TP_PART_slopes] = (uint64_t)1000 * o->slope_cells;
}

/* Returns at least the share of a ray: an object may show between two rays. */
static tp_fx pixel_share(uint32_t pixels, const tp_plan_input *in)
{
    const tp_fx least = TP_FX_ONE / (TP_RAYS * TP_RAYS);
    const tp_fx share =
        (tp_fx)(((uint64_t)pixels << 16) / ((uint64_t)in->width * in->height));

    return share > least ? share : least;
}

/* A board's stack has no room for a copy of the costs: the caller's are set in place. */
void tp_view_costs_make(tp_view_costs *view, const tp_prices *prices,
                        const tp_plan_input *in)
{
    tp_view_estimate *o = &view->estimate;

    *o = tp_view_estimate_make(in);
    view->culled = tp_plan_wave_cull(in->scene, o, prices);
    const tp_fixed_cost fixed = tp_fixed_cost_estimate(in, o, false);
    const uint32_t hidden = fixed.hidden < o->water_pixels ? fixed.hidden : o->water_pixels;

    view->processor = TP_PROCESSOR_M4;
    view->fast = !(o->modules & TP_MODULE_EXACT);
    view->clear = (o->modules & TP_MODULE_CLEAR) != 0;
    view->water = o->water_pixels - hidden;
    view->other = o->other_pixels + hidden;
    view->share[TP_SHARE_all] = TP_FX_ONE;
    view->share[TP_SHARE_sky] = pixel_share(view->other, in);
    view->share[TP_SHARE_water] = tp_fx_mul(pixel_share(view->water, in), o->unhazed) + 1;
    view->share[TP_SHARE_mirrored] = pixel_share(fixed.of[TP_WORK_looked_near], in);
    view->share[TP_SHARE_solid] = pixel_share(fixed.solid, in);
    set_parts(view, prices, in, &fixed);
    for (int v = 0; v < TP_VISIBILITIES; v++)
        set_seen_parts(view, prices, v, &fixed, view->seen[v]);
}

/* -- a set --------------------------------------------------------------------------- */

/* True if the light of fast shading can be of half rate: light that clear water does not
 * pass, and that changes colours. */
static bool has_half_rate(const tp_view_costs *view)
{
    return !view->clear
           && (view->estimate.trait[TP_TRAIT_look] || view->estimate.trait[TP_TRAIT_diffuse]);
}

/* True if the view has nothing that the kind changes, or another rung of the set replaces
 * it: colours of half rate replace fast light, and both the filter of layers; vertices
 * with fast normals or sines have 32 bits anyway, and over a floor all are exact. */
static bool is_replaced(const tp_view_costs *view, const tp_rung_set *set, int kind)
{
    const uint8_t *of = set->of;

    switch (kind) {
    case TP_KIND_RATE:
        return view->clear || (of[TP_KIND_RATE] == 1 && of[TP_KIND_light] && has_half_rate(view));
    case TP_KIND_light:
        return !has_half_rate(view) || of[TP_KIND_RATE] == 2;
    case TP_KIND_layers:        /* half the columns have stages of their own */
        return tp_set_is_fast(view, set) && !view->clear
               && (of[TP_KIND_RATE] == 2 || (of[TP_KIND_light] && has_half_rate(view)));
    case TP_KIND_waves:
        return view->estimate.floor || of[TP_KIND_normals] || of[TP_KIND_sine];
    case TP_KIND_normals:
    case TP_KIND_sine:
    case TP_KIND_geometry:
        return view->estimate.floor;
    case TP_KIND_blending:      /* rows or columns in between are means of pixels */
        return !of[TP_KIND_lines]
               && !(of[TP_KIND_light] && of[TP_KIND_RATE] != 2 && has_half_rate(view)
                    && tp_set_is_fast(view, set));
    default:
        return false;
    }
}

bool tp_rung_takes_effect(const tp_view_costs *view, const tp_rung_set *set, int kind)
{
    const tp_rung_effect *e = &tp_rung_effects[kind];

    if (is_replaced(view, set, kind))
        return false;
    if (kind == TP_KIND_SHADING || (e->needs_rung && e->needs_kind == TP_KIND_SHADING))
        return tp_set_is_fast(view, set);
    if (kind == TP_KIND_triangles)
        return tp_set_renderer(view, set) == 0;
    return !e->needs_rung || set->of[e->needs_kind] == e->needs_rung;
}

/* Sets the costs of the parts of a set before its rungs.  Each halving of the vertices
 * halves the cells and what is evaluated, and divides the edges by the root of 2. */
static void set_exact_costs(const tp_view_costs *view, const tp_rung_set *set,
                      uint64_t cost[TP_PART_COUNT])
{
    static const uint16_t root[] = { 256, 181, 128, 91 };
    const int v = tp_set_renderer(view, set);
    const int halvings = v < TP_VISIBILITY_PROJECTED - 1 ? set->of[TP_KIND_vertices] : 0;
    const uint16_t *factor = tp_part_factors[tp_set_shaded(view, set)];

    for (int p = 0; p < TP_PARTS_SEEN; p++)
        cost[p] = view->seen[v][p] * tp_seen_factors[v][p] >> 8;
    for (int p = TP_PARTS_SEEN; p < TP_PART_COUNT; p++)
        cost[p] = view->part[p] * factor[p] >> 8;
    cost[TP_PART_edges] = cost[TP_PART_edges] * root[halvings] >> 8;
    cost[TP_PART_cells] >>= halvings;
    for (int p = TP_PART_vertices; p < TP_PARTS_SEEN; p++)
        cost[p] >>= halvings;
}

/* Sets the costs of the parts on a Cortex-M4; returns the set's square error. */
static uint64_t set_costs(const tp_view_costs *view, const tp_rung_set *set,
                          uint64_t cost[TP_PART_COUNT])
{
    uint64_t square = 0, more = 0;

    set_exact_costs(view, set, cost);
    for (int k = 0; k < TP_RUNG_KINDS; k++) {
        if (set->of[k] == 0 || !tp_rung_takes_effect(view, set, k))
            continue;
        const tp_rung_effect *e = &tp_rung_effects[k];
        const tp_rung_price *price = &tp_rung_prices[k][set->of[k]];
        uint64_t parts = price->factor ? e->parts : 0;
        for (int p = 0; parts; p++, parts >>= 1)
            if (parts & 1)
                cost[p] = cost[p] * price->factor >> 8;
        more += (uint64_t)price->more * view->water;
        square += ((uint64_t)price->square[view->estimate.sea]
                   * (uint32_t)view->share[e->share] + 255) >> 8;
    }
    cost[TP_PART_plain] += more;
    return square;
}

uint64_t tp_set_part_costs(const tp_view_costs *view, const tp_rung_set *set,
                           uint64_t cost[TP_PART_COUNT])
{
    const uint64_t square = set_costs(view, set, cost);

    if (view->processor == TP_PROCESSOR_M0PLUS) {
        const uint16_t *factor = tp_m0plus_factors[tp_set_shaded(view, set)];
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
