/* SPDX-License-Identifier: MIT */
/*
 * Drops, [D1]-[D5] of the models.  A steered sphere at constant height releases drops.
 * Drops fall, bounce and vanish.  Each impact raises one ring, or stirs a pool.
 *
 *     drop.c            fall, impact, bounce and shape of one drop
 *     drops_module.c    the module: the list of drops, the list of rings
 *     drops_drawing.c   drops and sphere as spheroids; cost
 *     drops_stage.c     their shading
 */
#ifndef TP_FEATURES_DROPS_DROPS_H
#define TP_FEATURES_DROPS_DROPS_H
#include "tidepool/modules.h"
#include "tidepool/world.h"
#include "waves/deep_water.h"
#include "world/module.h"

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
    tp_vec3  sphere, last_sphere;       /* centre of the releasing sphere; a tick ago */
    tp_fx    sphere_radius;
} tp_drops;

size_t tp_drops_bytes(const tp_scene_drops *config);    /* 0: no drops; aligned to 8 */
void   tp_drops_init(tp_drops *drops, const tp_scene_drops *config);

const tp_drop *tp_drops_list(const tp_drops *drops);
const tp_ring *tp_drops_rings(const tp_drops *drops);

bool tp_drop_is_valid(const tp_drop *drop);

/* Moves the sphere that drops are released from by (dx, dz) m, within +-8000 m of the
 * origin.  Call once per tick, also with 0. */
void tp_drops_move_releasing_sphere(tp_drops *drops, tp_fx dx, tp_fx dz);

/* Releases `count` drops from the sphere.  Drops beyond the capacity are counted.  A
 * single drop without scatter falls from the sphere's centre; of several drops each has
 * its own place. */
void tp_drops_release(tp_drops *drops, const tp_scene_drops *config, uint32_t count);

/* Releases the automatic drops, one per drops.interval.  Call once per tick. */
void tp_drops_release_by_interval(tp_drops *drops, const tp_scene_drops *config);

/* Moves a drop by the tick that ends at `tick`, over water with the height `level`, m, at
 * the end of the tick [D1].  Returns true if the drop struck the water, at most once per
 * tick.  *impact then describes the impact, and the drop has bounced [D2]; after its last
 * impact radius is 0 and the caller removes the drop.  The speed of impact is relative to
 * the moving water.  A drop under water is lifted to the surface. */
bool tp_drop_step(tp_drop *drop, const tp_scene_drops *config, tp_fx gravity,
                  tp_fx level, uint64_t tick, tp_impact *impact);

/* Steps drop i of the list like tp_drop_step, and counts its impact. */
bool tp_drops_step_drop(tp_drops *drops, const tp_scene_drops *config, uint32_t i,
                        tp_fx gravity, tp_fx level, uint64_t tick, tp_impact *impact);

/* Adds the ring raised by an impact.  Returns true if there was room; otherwise counts
 * the ring as dropped. */
bool tp_drops_add_ring(tp_drops *drops, const tp_scene_drops *config,
                       const tp_impact *impact);

/* Removes drops with radius 0 and rings spent by tp_ring_is_spent.  `now`: ticks x 65536;
 * `max_distance`: m from a ring's centre to its rear. */
void tp_drops_rings_remove_spent(tp_drops *drops, int64_t now, tp_fx max_distance);

/* Returns the drops of a world, or NULL. */
const tp_drops *tp_world_drops(const tp_world *world);

#define TP_DROPS_SPHERE_FAR (8000 * TP_FX_ONE)      /* of the sphere along x and z */

/* drops_check.c: true if drops from outside, as they stood at `tick`, can be stepped and
 * drawn.  All values that follow from the config must equal the values in `fresh`, a state
 * of the same config.  Drops and rings must be in the ranges kept by steps. */
bool tp_drops_are_valid(const tp_drops *drops, const tp_drops *fresh, uint64_t tick);

#define TP_DROPS_ID TP_MODULE_ID('d', 'r', 'o', 'p')

/* Fills `to` with the rings at `time`, ticks x 65536, up to `room`.  Returns the count; 0
 * if the program has no wave model of rings. */
uint32_t tp_drops_rings_evaluate(const tp_drops *drops, const tp_program *program,
                                 int64_t time, tp_ring_now *to, uint32_t room);

#define TP_DROPS_ROWS \
    TP_ROW_COUNT("drops.count", drops.count, "", 0, 1024, 0, \
        "most drops in the air at once; 0: no sphere and no drops"), \
    TP_ROW_COUNT("drops.rings", drops.rings, "", 0, 1024, 64, \
        "most rings on the water at once"), \
    TP_ROW_CHOICE("drops.target", drops.target, "rings|pool", TP_DROPS_POOL, \
        TP_DROPS_RINGS, "an impact makes a ring, or a splash in the pool"), \
    TP_ROW_NUMBER("drops.x", drops.x, "m", -8000, 8000, 0, \
        "start position of the sphere, to the right of the origin"), \
    TP_ROW_NUMBER("drops.y", drops.y, "m", 0, 100, 3, "height of the sphere"), \
    TP_ROW_NUMBER("drops.z", drops.z, "m", -8000, 8000, 0, \
        "start position of the sphere, towards the viewer"), \
    TP_ROW_NUMBER("drops.radius", drops.radius, "m", 0.002, 1, 0.06, \
        "radius of a drop"), \
    TP_ROW_NUMBER("drops.density", drops.density, "kg/m^3", 100, 10000, 1000, \
        "density of a drop"), \
    TP_ROW_NUMBER("drops.drag", drops.drag, "", 0, 2, 0.47, \
        "drag coefficient Cd in air; 0: no drag"), \
    TP_ROW_NUMBER("drops.bounce", drops.bounce, "", 0.5, 0.8, 0.65, \
        "speed after an impact over the speed before"), \
    TP_ROW_COUNT("drops.impacts", drops.impacts, "", 5, 7, 6, \
        "impacts after which a drop vanishes"), \
    TP_ROW_NUMBER("drops.interval", drops.interval, "s", 0, 60, 1, \
        "time between automatic drops; 0: no automatic drops"), \
    TP_ROW_NUMBER("drops.scatter_radius", drops.scatter_radius, "m", 0, 1000, 0, \
        "greatest distance of an automatic drop from the sphere"), \
    TP_ROW_NUMBER("drops.efficiency", drops.efficiency, "", 0, 1, 0.2, \
        "share of a drop's lost energy that goes into its ring"), \
    TP_ROW_NUMBER("drops.ring_speed", drops.ring_speed, "m/s", 0.01, 64, 1.2, \
        "speed of rings"), \
    TP_ROW_NUMBER("drops.ring_decay", drops.ring_decay, "s", 0.05, 1000, 2, \
        "time constant with which rings decay"), \
    TP_ROW_NUMBER("drops.ring_spread", drops.ring_spread, "m", 0.01, 1000, 1, \
        "distance at which the height of a ring has fallen to 0.7"), \
    TP_ROW_NUMBER("drops.ring_rise_time", drops.ring_rise_time, "s", 0, 8, 0.1, \
        "time in which a ring rises to its full height"), \
    TP_ROW_COLOUR("drops.colour", drops.colour, 0xbfe0f0, "colour of sphere and drops")

#endif
