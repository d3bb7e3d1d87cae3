/* SPDX-License-Identifier: MIT */
/*
 * Coastal water: waves over a sea floor and under wind, [B1]-[B20] of the models: first
 * the phase of a wave over a straight coast, then all waves of a sea, then single formulas
 * of the models.  The formulas of a single wave over a depth are in water_depth.h.
 *
 * Each swell of a tp_deep_water is changed by the depth.  Its period stays, its length
 * shortens, its height shoals, its crests turn towards the shore, its orbits flatten and
 * tilt with the floor.  A crest too high for its depth stretches, overhangs and falls.
 * All functions of the depth alone are tabulated once, and so is the phase integral [B8].
 * The `length` of a wave is its length in deep water.
 *
 * Q k A is exact in deep water.  Elsewhere one factor narrows all orbits at a depth if
 * their sum k Q r Sx would exceed 0.95 [A11] [B13].  Slopes below 2^-12 count as
 * level.  Heights follow refraction [B7] over straight floors; over maps heights
 * depend on the depth alone.
 */
#ifndef TP_WAVES_COASTAL_WATER_H
#define TP_WAVES_COASTAL_WATER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "fixed/arithmetic.h"
#include "tidepool/assets.h"
#include "waves/deep_water.h"
#include "waves/water_depth.h"

/* -- the phase over a straight coast, coast.c ---------------------------------------- */

/* The phase for any point, to 3e-4 rad.  `tidepool check` compares the tables of [B8] with
 * these functions.  Coastal water has its own tables, by depth: see below. */

/* A straight coast: h(x) = max(least, depth - slope x), x towards the shore. */
typedef struct {
    int64_t k_inf_q32;      /* rad/m, clamped to 0..1024 */
    int64_t kz_q32;         /* wave number along the shore: k_inf sin th_inf, of either
                             * sign; clamped to +-k_inf, where the wave grazes */
    tp_fx   depth;          /* depth at x = 0, m */
    tp_q30  slope;          /* 0..1; a negative slope counts as 0, a level floor */
    tp_fx   least;          /* least depth, m; below 1/16 counts as 1/16 */
    tp_fx   x_from, x_to;   /* m; outside of x_from..x_to the floor is level */
} tp_coast_shape;

typedef struct {
    tp_turn  part;          /* fraction of the phase, Q0.32 */
    int32_t  turns;         /* whole turns of the phase */
    uint32_t rise;          /* phase difference to the next node by the slope
                             * here, turns Q0.32 */
} tp_coast_node;

/* The phase int_0^x sqrt(k(x)^2 - kz^2) dx [B8] [B9] as a table; the nodes follow this head
 * in memory.  Plain data, no pointers. */
typedef struct {
    tp_fx    x_first, x_last;   /* ends of the table, m; outside the phase
                                 * is a straight line */
    uint32_t bits;              /* distance of nodes: 2^bits units of 2^-16 m */
    uint32_t count;             /* number of nodes: 0, or 2 and more */
    int64_t  first, last;       /* phase at x_first and x_last, turns Q32.32 */
    int64_t  rise_first, rise_last;     /* slopes outside of the table, turns
                                         * per metre, Q31.32 */
} tp_coast;

/* Returns the size of the block for a coast in bytes; the block must be aligned to 8.
 * Nodes are at most a 16th of the shortest wave apart and take 12 bytes each.  Deep water
 * and the land behind the beach need no nodes. */
size_t tp_coast_bytes(const tp_coast_shape *shape);
void   tp_coast_init(tp_coast *coast, const tp_coast_shape *shape);

/* Returns the phase in turns, Q32.32; the low half is a tp_turn.  The phase is 0 at x =
 * 0. */
int64_t tp_coast_phase(const tp_coast *coast, tp_fx x);

/* -- the floor, floor.c -------------------------------------------------------------- */

typedef struct {
    tp_fx depth;            /* depth of still water at the origin, m; 0: no
                             * floor, deep water */
    tp_fx slope;            /* rise of the floor per metre, 0..1 ... */
    tp_fx heading;          /* ... in this direction, degrees clockwise from -z */
    const tp_grey *map;     /* or a map of floor heights, north (-z) up, 1 to 4096 pixels a
                             * side; NULL: none */
    tp_fx map_x, map_z;     /* centre of the map, m */
    tp_fx map_size;         /* width of the map, left to right, m, 1..8000 */
    tp_fx map_low, map_high;/* floor height at black and at white, m; still water is 0 */
} tp_floor;

/* Depth below still water, m, 16.16; <= 0 on land, TP_FX_MAX without a floor.  Outside of a
 * map the depth of its edge goes on. */
typedef struct {
    tp_fx depth;
    tp_fx rise_x, rise_z;   /* slopes of the floor, m/m, within +-8 */
} tp_floor_at;
tp_floor_at tp_floor_sample(const tp_floor *floor, tp_fx x, tp_fx z);

/* -- all waves over the floor, coastal_init.c and coastal_water.c -------------------- */

typedef struct {
    tp_floor floor;
    tp_fx wind;             /* lambda of [B10], rad/m, 0..1 */
    tp_fx wind_heading;     /* direction the wind blows to, degrees */
    tp_fx k0, kx, ky;       /* decay rates of the orbits [B12], 1/m, 0..4;
                             * usually 0.1, 0.11, 0.09 */
    tp_fx stretch;          /* factor of the breaker type's stretch [B20], 0..2 */
    tp_fx irregular;        /* irregularity of crests by noise, 0..1 */
} tp_coastal_config;

/* Private: properties of one wave at a depth.  Nodes stand at depth 0, and at eight depths
 * an octave from 1/16 to 2048 m, the depth where water counts as deep. */
#define TP_COASTAL_DEPTHS (1 + 8 * 15 + 1)
#define TP_COASTAL_PHASES (1 + 32 * 15 + 1)

typedef struct {
    tp_fx   along, up;      /* semi-axes of the orbit, m */
    tp_fx   ratio;          /* wave height before the cap / depth */
    tp_fx   lip;            /* r e^-Kd h [B19], m */
    tp_q30  way_x, way_z;   /* straight floor: direction of travel */
    int16_t tilt_sin, tilt_cos;     /* straight floor: tilt of the orbit [B11], Q1.14 */
    int16_t steep;          /* breaking by steepness [B14], 0..1, Q1.14 */
    int16_t shorter;        /* length / length in deep water, Q1.14 */
} tp_coastal_depth_entry;

/* Private: the inputs of a table, and of the rest of tp_coastal_water; used to detect
 * changes. */
typedef struct {
    tp_fx length, heading, amplitude, orbit_x, orbit_z;
} tp_coastal_swell_inputs;
typedef struct {
    tp_fx depth, slope, heading, map_x, map_z, map_size, map_low, map_high;
} tp_coastal_floor_inputs;
typedef struct {
    tp_fx wind, wind_heading, k0, kx, ky, stretch, irregular;
} tp_coastal_model_inputs;

typedef struct {
    tp_coastal_depth_entry depth[TP_COASTAL_DEPTHS];
    int32_t turns[TP_COASTAL_PHASES]; /* straight floor: phase in excess of deep
                                     * water, turns, Q16 */
    tp_coastal_swell_inputs key;
} tp_coastal_table;

/* Private: a map node of the floor, and a map node of a wave. */
typedef struct {
    tp_fx   depth;
    int16_t rise_x, rise_z; /* slopes, Q4.11 */
} tp_coastal_floor_node;

typedef struct {
    int32_t turns;          /* phase in excess of deep water, turns, Q16 */
    int16_t way_x, way_z;   /* direction of travel less the direction in deep water,
                             * Q2.13 */
} tp_coastal_wave_node;

/* Private: a wave. */
typedef struct {
    int64_t  turns_x, turns_z;      /* deep water, turns per metre, Q0.32 */
    tp_q30   way_x, way_z;          /* direction of travel in deep water */
    tp_fx    lambda;                /* lambda of the wind on this wave, rad/m */
    int32_t  iterations;            /* iterations of [B10]; the same for all depths */
    tp_fx    stretch, plunge;       /* factors from breaker type and config [B20] */
    uint32_t foam;                  /* share of foam by breaker type, 0..256 */
    uint32_t wave_nodes;            /* byte offset of its map nodes */
    uint32_t calm;                  /* first depth node without breaking;
                                     * deeper nodes have none */
} tp_coastal_wave;

/* Plain data without pointers.  A tp_coastal_table for each wave follows this head,
 * then the data of a map.  The struct is open in layout so that a board can place it;
 * only the functions below read it. */
typedef struct tp_coastal_water {
    uint32_t count;
    tp_fx    depth, slope;          /* straight floor: depth at the origin, m; slope ... */
    tp_q30   up_x, up_z;            /* ... rising in this direction */
    tp_fx    irregular;
    tp_fx    max_displacement, height;
    int64_t  map_x, map_z;          /* north-west node, m, 16.16 */
    uint32_t map_cols, map_rows;    /* number of nodes; 0: no map */
    uint32_t map_step;              /* distance of nodes, m, 16.16 */
    uint32_t floor_nodes;           /* byte offset of the floor's nodes */
    uint64_t map_per_step;          /* 2^48 / map_step */
    uint32_t fall[TP_COASTAL_DEPTHS]; /* e^-K0 h [B11], Q0.32 */
    tp_coastal_wave wave[TP_WAVES];
    tp_coastal_floor_inputs floor_key;
    tp_coastal_model_inputs model_key;
} tp_coastal_water;

/* Size of the block without a map, in bytes, for callers that place the block
 * themselves. */
#define TP_COASTAL_STRAIGHT_BYTES(waves) \
    ((sizeof(tp_coastal_water) + (waves) * sizeof(tp_coastal_table) + 7) / 8 * 8)

/* Returns the size of the block in bytes; the block must be aligned to 8.  The size depends
 * only on the number of swells and the sides of the map: waves may change in place.
 * Returns 0 if the map has a side of 0 pixels or of more than 4096. */
size_t tp_coastal_bytes(const tp_coastal_config *config, const tp_deep_water *deep);

/* Builds the tables; may take a while on small processors.  The swells of `deep` are used
 * in their order; `waves` and `count` are the arguments that made `deep`.  Their `power`
 * is ignored: all waves are trochoids.  The map of the config is read now and not kept.
 * Errors: TP_E_NULL, TP_E_ALIGN for the argument err->word; the block must be aligned to 8.
 * TP_E_ARG if the map has a side of 0 or of more than 4096 pixels, or a size outside of
 * 1..8000 m, or if the waves did not make `deep`.  Other numbers are clamped to
 * their ranges. */
tp_status tp_coastal_init(tp_coastal_water *coastal, const tp_coastal_config *config,
                          const tp_deep_water *deep, const tp_wave *waves, uint32_t count,
                          tp_error *err);

/* Rebuilds the parts that depend on changed numbers.  The block then equals the result
 * of tp_coastal_init, byte for byte.  The floor nodes depend on the floor alone.  The
 * map nodes of a swell depend on the floor and on the length and heading of the swell.
 * Everything else depends on all numbers.  The map must be the map of tp_coastal_init.
 * Returns TP_E_ARG and changes nothing in the cases of tp_coastal_init, or if `deep`
 * has another number of swells, or the map other sides. */
tp_status tp_coastal_refresh(tp_coastal_water *coastal, const tp_coastal_config *config,
                             const tp_deep_water *deep, const tp_wave *waves,
                             uint32_t count, tp_error *err);

/* Returns the bytes of the tables in a block, without the solver's memory behind them. */
size_t tp_coastal_table_bytes(const tp_coastal_water *coastal);

/* True if the block holds the tables that tp_coastal_init makes of these arguments with the
 * same map.  A block of another processor's layout holds other numbers. */
bool tp_coastal_is_current(const tp_coastal_water *coastal, const tp_coastal_config *config,
                           const tp_deep_water *deep, const tp_wave *waves, uint32_t count);

typedef struct {
    tp_vec3 position;       /* displaced point, m; may overhang */
    tp_fx   depth;          /* depth of still water at the rest point, m; <= 0: dry,
                             * and position.y is 0 */
    uint8_t breaking;       /* strength of breaking of the crest, 0..255 [B14] [B15] */
} tp_coastal_point;

/* Returns the displaced point of the rest point (x0, z0), any point of 16.16; positions are
 * clamped to the range.  `phases` come from tp_deep_water_phases. */
tp_coastal_point tp_coastal_displace_point(const tp_coastal_water *coastal,
                                           const tp_turn phases[TP_WAVES], tp_fx x0,
                                           tp_fx z0);

/* Distance of neighbouring points over the length of each wave in deep water, 16.16: along
 * a view's heading and across. */
typedef struct {
    tp_fx along[TP_WAVES], across[TP_WAVES];
} tp_coastal_spacing;

/* The same, where a wave keeps the share of its height that points so far apart hold. */
tp_coastal_point tp_coastal_displace_filtered(const tp_coastal_water *coastal,
                                              const tp_turn phases[TP_WAVES],
                                              const tp_coastal_spacing *spacing, tp_fx x0,
                                              tp_fx z0);

/* The same without overhanging parts (stretch and displacement), for boats and drops: a
 * height field wherever sum Q k A < 1. */
tp_coastal_point tp_coastal_displace_no_overhang(const tp_coastal_water *coastal,
                                                 const tp_turn phases[TP_WAVES], tp_fx x0,
                                                 tp_fx z0);

/* Bounds of the displacement of all points: horizontal and vertical, m. */
tp_fx tp_coastal_max_displacement(const tp_coastal_water *coastal);
tp_fx tp_coastal_max_height(const tp_coastal_water *coastal);

/* True if the floor is one plane. */
static inline bool tp_coastal_floor_is_plane(const tp_coastal_water *coastal)
{
    return coastal->map_cols == 0;
}

/* Returns the depth under a point, from the tables. */
tp_floor_at tp_coastal_floor(const tp_coastal_water *coastal, tp_fx x, tp_fx z);

/* -- orbits and breaking crests, orbit.c --------------------------------------------- */

/* An orbit: its semi-axes r Sx (along) and r Sy (up), and the tilt alpha of the first as
 * sine and cosine. */
typedef struct {
    tp_fx  along, up;
    tp_q30 sin, cos;
} tp_ellipse;

/* Offset from the rest point: along the direction of travel, and up; m. */
typedef struct {
    tp_fx along, up;
} tp_offset;

/* Returns the orbit of [B11]-[B13].  r is the amplitude (0..64 m), k the wave number.
 * floor_angle is the angle of the floor's rise along the direction of travel.  The decays
 * with depth, 1/m, are k0, kx and ky of the config. */
tp_ellipse tp_orbit_ellipse(tp_fx r, tp_fx depth, tp_turn floor_angle, int64_t k_q32,
                            tp_fx tilt_decay, tp_fx widening_decay,
                            tp_fx flattening_decay);

/* Returns the offset of the particle at phase Phi; Phi is 0 in the trough [A7]. */
tp_offset tp_orbit_evaluate(const tp_ellipse *orbit, tp_turn phi);

/* Returns the phase of the lowest point of the orbit [B16]. */
tp_turn tp_orbit_lowest_phase(const tp_ellipse *orbit);

/* Returns smoothstep(0.6, 0.78, H / h), 16.16. */
tp_fx tp_breaking_gate(tp_fx height_over_depth);

/* A breaking crest [B17]-[B19]: `stretch` is St_max, `lip` is 2 r, both in m. */
typedef struct {
    tp_ellipse orbit;
    tp_fx stretch, lip;             /* 0..128 m */
    tp_fx kept_stretch, kept_lip;   /* shares of stretch and lip in the offset, 0..1:
                                     * e^-Kh and the gate */
} tp_breaker;

typedef struct {
    int32_t   p;                    /* Phi - Phi_min, turns Q0.32, -1/2..1/2 */
    tp_fx     stretch, displacement;/* full size, m, before the shares */
    int32_t   orientation;          /* turns, Q0.32 */
    tp_offset offset;               /* includes the offset of the orbit */
} tp_breaking;

/* Returns the displacement at phase `phi` of a wave whose crest breaks: the orbit's offset,
 * stretched near the crest, with the lip thrown forward and down. */
tp_breaking tp_breaking_shape(const tp_breaker *breaker, tp_turn phi);

#endif
