/* SPDX-License-Identifier: MIT */
/* Sets of rungs: one rung of every kind, with the cost and the error of the picture that
 * they draw together, and the search for the sets that are worth drawing.
 *
 * A picture's cost is a sum of parts: sky, cells of water, the reflection of the water's
 * pixels and so on.  Each part is an amount of work, known from the view, times a price of
 * the exact rungs (quality/prices.h), times a factor fitted to counted pictures of all
 * shipped scenes.  Parts of finding the water have factors for each water renderer; parts
 * of a pixel of water have factors for exact shading, for fast shading and for fast
 * shading of clear water.  A rung multiplies the parts that it changes by a factor of its
 * own, and may add a price for each pixel of water.  A rung's error is a measured mean
 * square per pixel that shows the effect; errors of different kinds are independent, and
 * their mean squares add. */
#ifndef TP_QUALITY_RUNG_SETS_H
#define TP_QUALITY_RUNG_SETS_H
#include "quality/prices.h"

/* The kinds: the rows quality.visibility, shading and rate, the rows of TP_EFFECT_LIST in
 * its order, and two rows that a drawing may change too: mirror.size and the vertices of
 * grid.vertices. */
enum {
    TP_KIND_BEFORE_EFFECTS = TP_KIND_RATE,      /* the kinds of prices.h are the first */
#define X(name, words, last, help) TP_KIND_##name,
    TP_EFFECT_LIST(X)
#undef X
    TP_KIND_mirror_size,        /* as the scene names it, or a quarter */
    TP_KIND_vertices,           /* as many as the scene names, 1/2, 1/4, 1/8 */
    TP_RUNG_KINDS
};

/* A rung of every kind, counted from 0, the exact one. */
typedef struct {
    uint8_t of[TP_RUNG_KINDS];
} tp_rung_set;

/* Number of rungs of a kind, and its row, "quality.foam". */
uint32_t tp_rung_kind_count(int kind);
const char *tp_rung_kind_row(int kind);

/* Sets the scene's rows to the rungs of a set.  Rows of kinds that keep their first rung
 * are named `exact`, except mirror.size and grid.vertices, which keep their values. */
void tp_rung_set_apply(tp_scene *scene, const tp_rung_set *set);

/* The same for some kinds, bits of a word: those that a scene leaves open. */
void tp_rung_set_apply_some(tp_scene *scene, const tp_rung_set *set, uint32_t kinds);

/* Returns the set that a scene names; kinds of `auto` have the exact rung, and their bit
 * of *open is set, as are those of mirror.size and grid.vertices if `drawing_rows`.  A
 * mirror of a quarter stays. */
tp_rung_set tp_rung_set_named(const tp_scene *scene, bool drawing_rows, uint32_t *open);

/* -- cost and error ------------------------------------------------------------------ */

/* Parts of a frame's cost.  TP_SEEN_PARTS find the water: level is the pixel of level
 * water; edges are cells times the rows that each covers; wind, floor_points, pools and
 * rings are what these add to a vertex.  TP_PIXEL_PARTS are of a pixel of water;
 * `spans` is of a row of water, `glass` of a pixel of a tank's water behind its walls;
 * dome_light is light, glint, reflection and mirrored sky under a dome, which costs about
 * as much at half rate. */
#define TP_SEEN_PARTS(X) \
    X(visibility) X(level) X(cells) X(edges) X(vertices) X(waves) X(wind) \
    X(floor_points) X(pools) X(rings)
#define TP_PIXEL_PARTS(X) \
    X(spans) X(plain) X(layers) X(linear) X(distortion) X(ripple) X(light) X(glint) \
    X(reflection) X(mirrored_sky) X(dome_light) X(haze) X(foam) X(objects) \
    X(refraction) X(floor) X(dispersion) X(caustics) X(exposure) X(glass)
#define TP_COST_PARTS(X) \
    TP_SEEN_PARTS(X) TP_PIXEL_PARTS(X) \
    X(store) X(sky) X(sky_kind) X(caustic_map) X(solids) X(faces) X(mirror) X(spray) \
    X(frame) X(rows) X(slopes) X(walls) X(wall_faces) X(side_faces) X(land) \
    X(land_cells)

enum {
#define X(name) TP_PART_##name,
    TP_COST_PARTS(X)
#undef X
    TP_PART_COUNT,
    TP_PARTS_SEEN = TP_PART_rings + 1
};

/* Shadings of water that have factors of their own. */
enum { TP_SHADED_EXACT, TP_SHADED_FAST, TP_SHADED_FAST_CLEAR, TP_SHADED_COUNT };

/* Shares of the picture, Q16, whose pixels show an effect.  A pixel of water counts by the
 * square of what haze leaves of its colour: errors fade as the colour does. */
enum { TP_SHARE_all, TP_SHARE_sky, TP_SHARE_water, TP_SHARE_mirrored, TP_SHARE_solid,
       TP_SHARE_COUNT };

/* The processor whose instructions a cost counts.  A Cortex-M0+ multiplies to 32 bits only:
 * a product of 64 bits is a call. */
typedef enum { TP_PROCESSOR_M4, TP_PROCESSOR_M0PLUS } tp_processor;

/* A view with the costs of the exact effects, by each water renderer.  Parts are those of a
 * Cortex-M4; a set is priced for `processor`, a Cortex-M4 unless the caller sets another
 * one.  The plan for an error budget is priced for a Cortex-M4 on every machine. */
typedef struct tp_view_costs {
    tp_processor processor;
    tp_view_estimate estimate;
    tp_wave_cull culled;        /* waves too faint to be drawn, at this camera */
    uint32_t water, other;      /* pixels of water that no object hides, and all others */
    bool     fast, clear;       /* fast stages can draw all water; the water is clear: fast
                                 * stages then need fast refraction */
    uint64_t seen[TP_VISIBILITIES][TP_PARTS_SEEN];      /* instructions, before factors */
    uint64_t part[TP_PART_COUNT];       /* those from TP_PARTS_SEEN on */
    tp_fx    share[TP_SHARE_COUNT];
} tp_view_costs;

typedef struct {
    uint64_t cost;              /* instructions of the view's processor per frame */
    uint64_t square;            /* mean square error beyond the exact picture, Q16 */
} tp_set_price;

/* True if the set draws the view's water with fast stages. */
static inline bool tp_set_is_fast(const tp_view_costs *view, const tp_rung_set *set)
{
    return set->of[TP_KIND_SHADING] && view->fast
        && (!view->clear || set->of[TP_KIND_refraction]);
}

/* Returns the water renderer that draws a set, and the shading that its factors are of. */
static inline int tp_set_renderer(const tp_view_costs *view, const tp_rung_set *set)
{
    const int v = set->of[TP_KIND_VISIBILITY];
    return view->estimate.fits[v] ? v : 0;
}

static inline int tp_set_shaded(const tp_view_costs *view, const tp_rung_set *set)
{
    return !tp_set_is_fast(view, set) ? TP_SHADED_EXACT
         : view->clear ? TP_SHADED_FAST_CLEAR : TP_SHADED_FAST;
}

void tp_view_costs_make(tp_view_costs *view, const tp_prices *prices,
                        const tp_plan_input *in);
tp_set_price tp_set_price_estimate(const tp_view_costs *view, const tp_rung_set *set);

/* -- the search ---------------------------------------------------------------------- */

#define TP_SET_STEPS 40         /* most steps of a walk */

/* A walk from the set that a scene names to the cheapest one.  Each step changes one kind,
 * or two that only save together, and adds the least error per instruction saved. */
typedef struct {
    tp_rung_set  set[TP_SET_STEPS];
    tp_set_price price[TP_SET_STEPS];
    uint32_t     count;
} tp_set_walk;

/* `open`: bits of the kinds that may change. */
void tp_set_walk_make(tp_set_walk *walk, const tp_view_costs *view, tp_rung_set from,
                      uint32_t open);

/* Changes *set, the one that a scene names, to the cheapest set found with a mean square
 * error of at most `most`, Q16, or of its own error if that is greater. */
void tp_set_choose(const tp_view_costs *view, tp_rung_set *set, uint32_t open,
                   uint64_t most);

/* Changes *set, the one that a scene names, to a set with a cost of at most `most`
 * instructions: the first one of the walk, refined.  Returns false, and changes nothing, if
 * the walk has none. */
bool tp_set_fit(const tp_view_costs *view, tp_rung_set *set, uint32_t open, uint64_t most);

/* Makes rungs of a set more exact again, as long as the cost stays within `most` and the
 * error falls. */
void tp_set_refine(const tp_view_costs *view, tp_rung_set *set, uint32_t open,
                   uint64_t most);

#endif
