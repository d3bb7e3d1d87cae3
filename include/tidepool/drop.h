/* SPDX-License-Identifier: MIT */
/* Drops: a sphere that is steered at constant height releases them, they fall, bounce and
 * are gone; each impact raises one ring, or stirs a pool, [D1]-[D5] of the models. */
#ifndef TP_DROP_H
#define TP_DROP_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/fx.h"
#include "tidepool/language.h"
#include "tidepool/ring.h"

TP_BEGIN_C

typedef enum { TP_DROPS_RINGS, TP_DROPS_POOL } tp_drops_into;

/* As a scene describes them; 16.16 unless said. */
typedef struct {
    int32_t count;          /* in the air at once, 0..1024; 0: no sphere and no drops */
    int32_t rings;          /* on the water at once, 0..1024 */
    int32_t into;           /* tp_drops_into */
    tp_fx   x, y, z;        /* m, of the sphere at tick 0 */
    tp_fx   radius;         /* m of a drop, 0.002..1; the sphere's is twice as much */
    tp_fx   density;        /* kg/m^3, 100..10000 */
    tp_fx   drag;           /* Cd [D1], 0..2; 0: mass does not matter */
    tp_fx   bounce;         /* e [D2], 0.5..0.8 */
    int32_t impacts;        /* 5..7, then it vanishes */
    tp_fx   every;          /* s between drops that fall by themselves; 0: none do */
    tp_fx   scatter;        /* m: they fall so far from the sphere at the most */
    tp_fx   efficiency;     /* share of the lost energy that the ring takes, 0..1 [D4] */
    tp_fx   speed, decay, spread, attack;   /* of rings, see tp_ring */
    int32_t colour;         /* of drops and sphere */
} tp_scene_drops;

typedef struct {
    tp_vec3  place;         /* m */
    tp_vec3  last;          /* a tick ago */
    int64_t  high_q32;      /* place.y in full: small bounces are a few LSB high */
    int32_t  fall_q24;      /* m/s upwards: saturates at +-127 */
    tp_fx    radius;
    tp_fx    level;         /* of the water under it, a tick ago; TP_DROP_NEW: unknown */
    uint32_t impacts;       /* so far; the mass is halved at each */
    int32_t  squash;        /* shape: height over width - 1, Q2.14: > 0 is long; +-1/2 */
    int32_t  squash_speed;  /* of its wobble, a tick */
} tp_drop;

#define TP_DROP_NEW TP_FX_MIN
#define TP_DROP_FAR (9000 * TP_FX_ONE)  /* m each way: 8000 of the sphere, 1000 of scatter */

/* In one block: drops follow this head, then rings. */
typedef struct {
    uint32_t capacity, ring_capacity;
    uint32_t count, rings;      /* in the air, on the water */
    uint32_t dropped;           /* releases that found no place */
    uint32_t rings_dropped;     /* impacts that found no place for their ring */
    uint32_t released, impacts; /* so far */
    uint32_t random;
    uint32_t wait;              /* ticks x 65536 until the next falls by itself */
    tp_vec3  sphere, last_sphere;
    tp_fx    sphere_radius;
} tp_drops;

/* What an impact does to the water; the caller gives it to rings or to a pool. */
typedef struct {
    tp_fx   x, z;
    int64_t time;           /* ticks x 65536: inside the step */
    tp_fx   amplitude;      /* A0 [D4], m, capped at L / 14 [B14] */
    int32_t uncapped_q24;   /* A0 before that, saturated: late ones are a few LSB high */
    tp_fx   length;         /* L = 8 radii */
    tp_fx   lost;           /* energy [D3], J, saturated */
} tp_impact;

size_t tp_drops_bytes(const tp_scene_drops *config);    /* 0: none; aligned to 8 */
void   tp_drops_init(tp_drops *drops, const tp_scene_drops *config);

const tp_drop *tp_drops_list(const tp_drops *drops);
const tp_ring *tp_drops_rings(const tp_drops *drops);

/* Whether drops whose bytes come from outside, as they stood at `tick`, can be stepped and
 * drawn: what follows from the config equals `fresh`'s, those of the same config; drops
 * and rings are in the ranges that steps keep. */
bool tp_drops_are_valid(const tp_drops *drops, const tp_drops *fresh, uint64_t tick);
bool tp_drop_is_valid(const tp_drop *drop);

/* Moves the sphere by (x, z) m, within +-8000 m; once a tick, also by 0. */
void tp_drops_steer(tp_drops *drops, tp_fx x, tp_fx z);

/* Lets `count` drops go from the sphere; those beyond the capacity are counted.  One
 * alone without scatter falls from its centre, of several each from its own place. */
void tp_drops_release(tp_drops *drops, const tp_scene_drops *config, uint32_t count);

/* Lets go those that fall by themselves, one `every` so often; once a tick. */
void tp_drops_release_due(tp_drops *drops, const tp_scene_drops *config);

/* Moves a drop by one tick, the one that ends at `tick`, over water that then has `level`
 * m at its place [D1]: true if it struck the water, and then *impact says how; the drop
 * has bounced [D2], or, its impacts done, radius is 0 and it is to be removed.  At the
 * most one impact a tick.  The water's own motion counts: it strikes by the speed between
 * them.  One that water has swallowed is lifted to the surface. */
bool tp_drop_step(tp_drop *drop, const tp_scene_drops *config, tp_fx gravity,
                  tp_fx level, uint64_t tick, tp_impact *impact);

/* The same of drop i in the list, its impact counted. */
bool tp_drops_step(tp_drops *drops, const tp_scene_drops *config, uint32_t i,
                   tp_fx gravity, tp_fx level, uint64_t tick, tp_impact *impact);

/* The ring that an impact raises, added if there is room, else counted: true if added. */
bool tp_drops_ring(tp_drops *drops, const tp_scene_drops *config,
                   const tp_impact *impact);

/* Removes drops whose radius is 0, and rings that are spent; `now` ticks x 65536. */
void tp_drops_tidy(tp_drops *drops, int64_t now, tp_fx beyond);

TP_END_C
#endif
