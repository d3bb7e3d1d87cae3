/* SPDX-License-Identifier: MIT */
/* Drops, [D1]-[D5] of the models.  A steered sphere at constant height releases drops.
 * Drops fall, bounce and vanish.  Each impact raises one ring, or stirs a pool.
 *
 *     drop.c            fall, impact, bounce and shape of one drop
 *     drops.c           the module: the list of drops, the list of rings
 *     drops_drawing.c   drops and sphere as spheroids
 *     drops_stage.c     their shading */
#ifndef TP_DROPS_MODULE_H
#define TP_DROPS_MODULE_H
#include "scene/module.h"
#include "tidepool/world.h"
#include "wave/ring.h"

typedef struct {
    tp_vec3  place;         /* centre, m */
    tp_vec3  last;          /* centre a tick ago, m */
    int64_t  high_q32;      /* place.y at full precision, m: small bounces are a few LSB */
    int32_t  fall_q24;      /* upward speed, m/s, saturates at +-127 */
    tp_fx    radius;
    tp_fx    level;         /* water level below it a tick ago, m; or TP_DROP_NEW */
    uint32_t impacts;       /* impacts so far; each halves the mass */
    int32_t  squash;        /* height / width - 1, Q2.14, +-1/2; > 0: prolate */
    int32_t  squash_speed;  /* change of squash per tick */
} tp_drop;

#define TP_DROP_NEW TP_FX_MIN

/* Head of the block; drops follow the head, then rings. */
typedef struct {
    uint32_t capacity, ring_capacity;
    uint32_t count, rings;      /* in the air; on the water */
    uint32_t dropped;           /* releases beyond the capacity */
    uint32_t rings_dropped;     /* impacts whose ring was beyond the capacity */
    uint32_t released, impacts; /* totals so far */
    uint32_t random;
    uint32_t wait;              /* ticks x 65536 until the next automatic drop */
    tp_vec3  sphere, last_sphere;
    tp_fx    sphere_radius;
} tp_drops;

size_t tp_drops_bytes(const tp_scene_drops *config);    /* 0: no drops; aligned to 8 */
void   tp_drops_init(tp_drops *drops, const tp_scene_drops *config);

const tp_drop *tp_drops_list(const tp_drops *drops);
const tp_ring *tp_drops_rings(const tp_drops *drops);

/* True if drops from outside, as they stood at `tick`, can be stepped and drawn.  All
 * values that follow from the config must equal the values in `fresh`, a state of the
 * same config.  Drops and rings must be in the ranges kept by steps. */
bool tp_drops_are_valid(const tp_drops *drops, const tp_drops *fresh, uint64_t tick);
bool tp_drop_is_valid(const tp_drop *drop);

/* Moves the sphere by (x, z) m, within +-8000 m.  Call once per tick, also with 0. */
void tp_drops_move_sphere(tp_drops *drops, tp_fx x, tp_fx z);

/* Releases `count` drops from the sphere.  Drops beyond the capacity are counted.  A
 * single drop without scatter falls from the sphere's centre; of several drops each has
 * its own place. */
void tp_drops_release(tp_drops *drops, const tp_scene_drops *config, uint32_t count);

/* Releases the automatic drops, one per interval `every`.  Call once per tick. */
void tp_drops_release_due(tp_drops *drops, const tp_scene_drops *config);

/* Moves a drop by the tick that ends at `tick`, over water with the height `level`, m, at
 * the end of the tick [D1].  Returns true if the drop struck the water, at most once per
 * tick.  *impact then describes the impact, and the drop has bounced [D2]; after its last
 * impact radius is 0 and the caller removes the drop.  The speed of impact is relative to
 * the moving water.  A drop under water is lifted to the surface. */
bool tp_drop_step(tp_drop *drop, const tp_scene_drops *config, tp_fx gravity,
                  tp_fx level, uint64_t tick, tp_impact *impact);

/* Steps drop i of the list like tp_drop_step, and counts its impact. */
bool tp_drops_step(tp_drops *drops, const tp_scene_drops *config, uint32_t i,
                   tp_fx gravity, tp_fx level, uint64_t tick, tp_impact *impact);

/* Adds the ring raised by an impact.  Returns true if there was room; otherwise counts
 * the ring as dropped. */
bool tp_drops_add_ring(tp_drops *drops, const tp_scene_drops *config,
                       const tp_impact *impact);

/* Removes drops with radius 0 and rings spent by tp_ring_is_spent.  `now`: ticks x 65536;
 * `beyond`: m from a ring's centre to its rear. */
void tp_drops_remove_spent(tp_drops *drops, int64_t now, tp_fx beyond);

const tp_drops *tp_world_drops(const tp_world *world);

#define TP_DROPS_ID TP_MODULE_ID('d', 'r', 'o', 'p')

/* Fills `to` with the rings at `time`, ticks x 65536, up to `room`.  Returns the count. */
uint32_t tp_drops_rings_evaluate(const tp_drops *drops, const tp_program *program,
                                 int64_t time, tp_ring_now *to, uint32_t room);
#endif
