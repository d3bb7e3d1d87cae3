/* SPDX-License-Identifier: MIT */
/* Drops: a sphere that is steered at constant height releases them, they fall, bounce and
 * are gone; each impact raises one ring, or stirs a pool, [D1]-[D5] of the models.
 *
 *     drop.c            fall, impact, bounce and shape of one
 *     drops.c           the module: the list of drops, the list of rings
 *     drops_drawing.c   drops and sphere as spheroids
 *     drops_stage.c     their colour */
#ifndef TP_DROPS_MODULE_H
#define TP_DROPS_MODULE_H
#include "scene/module.h"
#include "tidepool/world.h"
#include "wave/ring.h"

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

const tp_drops *tp_world_drops(const tp_world *world);

#define TP_DROPS_ID TP_MODULE_ID('d', 'r', 'o', 'p')

/* Fills `to` with the rings at `time`, ticks x 65536, up to `room`; returns their count. */
uint32_t tp_drops_rings_at(const tp_drops *drops, const tp_program *program, int64_t time,
                           tp_ring_now *to, uint32_t room);
#endif
