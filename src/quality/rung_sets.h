/* SPDX-License-Identifier: MIT */
/* Sets of rungs: one rung of every kind, with the cost and the error of the picture that
 * they draw together, and the search for the sets that are worth drawing.
 *
 * A picture's cost is a sum of parts: sky, vertices, the reflection of the water's pixels
 * and so on.  Each part is estimated for the exact rungs by the tables of quality/prices.h,
 * which are measured in one scene, and corrected by a factor fitted to pictures of all
 * shipped scenes, one for exact and one for fast shading.  A rung of an effect multiplies
 * the parts that it changes by a factor of its own.  Its error is a measured mean square per
 * pixel that shows the effect; errors of different kinds are independent, and their mean
 * squares add. */
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

/* Parts of a frame's cost.  No rung changes the last three, for which the tables have no
 * prices: tables of a frame, storing of pixels, spans of water. */
#define TP_COST_PARTS(X) \
    X(frame) X(sky) X(visibility) X(vertices) X(plain) X(layers) X(distortion) X(ripple) \
    X(light) X(glint) X(reflection) X(haze) X(foam) X(objects) X(refraction) \
    X(dispersion) X(caustics) X(exposure) X(solids) X(faces) X(mirror) X(walls) X(land) \
    X(spray) X(tables) X(store) X(spans)

enum {
#define X(name) TP_PART_##name,
    TP_COST_PARTS(X)
#undef X
    TP_PART_COUNT
};

/* Shares of the picture, Q16, whose pixels show an effect. */
enum { TP_SHARE_all, TP_SHARE_sky, TP_SHARE_water, TP_SHARE_mirrored, TP_SHARE_solid,
       TP_SHARE_COUNT };

/* The processor whose instructions a cost counts.  A Cortex-M0+ multiplies to 32 bits only:
 * a product of 64 bits is a call. */
typedef enum { TP_PROCESSOR_M4, TP_PROCESSOR_M0PLUS } tp_processor;

/* A view with its costs: those of the exact effects, by each water renderer.  Parts are
 * those of a Cortex-M4; a set is priced for `processor`, which is a Cortex-M4 unless the
 * caller sets another one.  The plan never does: all machines draw the same bits. */
typedef struct tp_view_costs {
    tp_processor processor;
    tp_view_estimate estimate;
    tp_wave_cull culled;        /* waves too faint to be drawn, at this camera */
    uint32_t water, other;      /* pixels of water that no object hides, and all others */
    bool     fast, clear;       /* fast stages can draw all water; the water is clear: fast
                                 * stages then need fast refraction */
    uint64_t part[TP_VISIBILITIES][TP_PART_COUNT];      /* instructions */
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
