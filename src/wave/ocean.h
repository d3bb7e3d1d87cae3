/* SPDX-License-Identifier: MIT */
/* Waves over a sea floor and under wind, [B1]-[B20] of the models.
 *
 * Each swell of a tp_sea feels the depth: its period stays, its length shortens, its
 * height shoals, its crests turn towards the shore, its orbits flatten and rise with the
 * bottom, and where it is too high for its depth its crest stretches, overhangs and
 * falls.  What depends on depth alone is tabulated once; the phase integral [B8] too.
 * A wave's `length` is that of deep water.
 *
 * Q k A holds on deep water.  Elsewhere the orbits at each depth are narrowed by one
 * factor where their sum k Q r Sx would pass 0.95 [A11] [B13].  Slopes below 2^-12 are
 * level.  Heights follow refraction [B7] over straight floors; over maps they follow
 * depth alone. */
#ifndef TP_WAVE_OCEAN_H
#define TP_WAVE_OCEAN_H
#include <stdbool.h>
#include "tidepool/assets.h"
#include "wave/depth.h"
#include "wave/wave.h"

/* -- the floor --------------------------------------------------------------------- */

typedef struct {
    tp_fx depth;            /* m at the origin, of still water; 0: no floor, deep sea */
    tp_fx slope;            /* rise of the floor per metre, 0..1 ... */
    tp_fx heading;          /* ... towards this, degrees clockwise from -z */
    const tp_grey *map;     /* or a picture of its heights, north (-z) up, 1 to 4096
                               pixels a side; NULL: none */
    tp_fx map_x, map_z;     /* m: its centre */
    tp_fx map_size;         /* m from its left to its right side, 1..8000 */
    tp_fx map_low, map_high;/* m of the floor at black and white; the level is 0 */
} tp_floor;

/* Depth below the level of still water, 16.16; <= 0 is land, TP_FX_MAX no floor.  Outside
 * of a map its edge goes on. */
typedef struct {
    tp_fx depth;
    tp_fx rise_x, rise_z;   /* of the floor per metre, +-8 */
} tp_floor_at;
tp_floor_at tp_floor_under(const tp_floor *floor, tp_fx x, tp_fx z);

/* -- the waves over it ------------------------------------------------------------- */

typedef struct {
    tp_floor floor;
    tp_fx wind;             /* lambda of [B10], rad/m, 0..1 */
    tp_fx wind_heading;     /* degrees: where it blows to */
    tp_fx k0, kx, ky;       /* of the orbits [B12], 1/m, 0..4; usually 0.1, 0.11, 0.09 */
    tp_fx stretch;          /* of breaking crests, of the type's own [B20], 0..2 */
    tp_fx irregular;        /* of crests by noise, 0..1 */
} tp_ocean_config;

/* Private: what one wave is at a depth.  Nodes stand at 0 and at eight depths an octave
 * from 1/16 to 2048 m, where the sea counts as deep. */
#define TP_OCEAN_DEPTHS (1 + 8 * 15 + 1)
#define TP_OCEAN_PHASES (1 + 32 * 15 + 1)

typedef struct {
    tp_fx   along, up;      /* semi-axes of its orbit, m */
    tp_fx   ratio;          /* of its height, before the cap, to the depth */
    tp_fx   lip;            /* r e^-Kd h [B19], m */
    tp_q30  way_x, way_z;   /* a straight floor: where it travels to */
    int16_t tilt_sin, tilt_cos;     /* ... and the tilt of its orbit [B11], Q1.14 */
    int16_t steep;          /* 0..1, Q1.14: how far it breaks by steepness [B14] */
    int16_t spare;
} tp_ocean_depth;

/* Private: the numbers that a table, and the rest of an ocean, were made of. */
typedef struct { tp_fx length, heading, amplitude, reach_x, reach_z; } tp_ocean_swell_key;
typedef struct {
    tp_fx depth, slope, heading, map_x, map_z, map_size, map_low, map_high;
} tp_ocean_floor_key;
typedef struct {
    tp_fx wind, wind_heading, k0, kx, ky, stretch, irregular;
} tp_ocean_model_key;

typedef struct {
    tp_ocean_depth depth[TP_OCEAN_DEPTHS];
    int32_t turns[TP_OCEAN_PHASES]; /* a straight floor: phase beyond deep water's, Q16 */
    tp_ocean_swell_key key;
} tp_ocean_table;

/* Private: a node of a map's floor, and of a wave over it. */
typedef struct {
    tp_fx   depth;
    int16_t rise_x, rise_z; /* Q4.11 */
} tp_ocean_bed;

typedef struct {
    int32_t turns;          /* phase beyond deep water's, Q16 */
    int16_t way_x, way_z;   /* where it travels to, less where it came from, Q2.13 */
} tp_ocean_ray;

/* Private: a wave. */
typedef struct {
    int64_t  turns_x, turns_z;      /* of deep water, turns per metre, Q0.32 */
    tp_q30   way_x, way_z;          /* where it travels to on deep water */
    tp_fx    lambda;                /* of the wind on it, rad/m */
    int32_t  iterations;            /* of [B10]; one number for all depths */
    tp_fx    stretch, plunge;       /* of its breaker type and the config's [B20] */
    uint32_t rays;                  /* byte offset of its nodes over a map */
    uint32_t calm;                  /* from this depth's node on it does not break */
} tp_ocean_wave;

/* Plain data without pointers.  This head is followed by a tp_ocean_table for each wave,
 * then by what a map needs.  Open in layout so that a board can place it; read by the
 * functions below alone. */
typedef struct tp_ocean {
    uint32_t count;
    tp_fx    depth, slope;          /* straight: at the origin, and rise a metre ... */
    tp_q30   up_x, up_z;            /* ... towards this */
    tp_fx    irregular;
    tp_fx    reach, height;
    int64_t  map_x, map_z;          /* 16.16 m of its north-west node */
    uint32_t map_cols, map_rows;    /* nodes; 0: no map */
    uint32_t map_step;              /* m between nodes, 16.16 */
    uint32_t beds;                  /* byte offset of the floor's nodes */
    uint64_t map_per_step;          /* 2^48 / map_step */
    uint32_t fall[TP_OCEAN_DEPTHS]; /* e^-K0 h [B11], Q0.32 */
    tp_ocean_wave wave[TP_WAVES];
    tp_ocean_floor_key floor_key;
    tp_ocean_model_key model_key;
} tp_ocean;

/* Of the block of an ocean without a map, for those who place it themselves. */
#define TP_OCEAN_STRAIGHT_BYTES(waves) \
    ((sizeof(tp_ocean) + (waves) * sizeof(tp_ocean_table) + 7) / 8 * 8)

/* Of the block, aligned to 8: a matter of the sea's count of swells and of the map's
 * sides alone, so that waves may change in place.  0: the map has a side of 0 pixels, or
 * of more than 4096. */
size_t tp_ocean_bytes(const tp_ocean_config *config, const tp_sea *sea);

/* Builds the tables; may take a while on small processors.  The sea's swells, in their
 * order, are the ocean's; `waves` and `count` are those that made it.  Their `power`
 * does not count: all are trochoids.  The config's map is read now and not kept.
 * TP_E_NULL, TP_E_ALIGN: of the argument err->word; the block is aligned to 8.
 * TP_E_ARG: the map has a side of 0 or of more than 4096 pixels, or a size outside of
 * 1..8000 m; or the waves did not make this sea.  Other numbers are held in their
 * ranges. */
tp_status tp_ocean_init(tp_ocean *ocean, const tp_ocean_config *config,
                        const tp_sea *sea, const tp_wave *waves, uint32_t count,
                        tp_error *err);

/* Makes again what depends on numbers that have changed since the ocean was made: the
 * block is then what tp_ocean_init makes of them, byte for byte.  The floor's nodes
 * depend on the floor alone, the rays of a swell over a map on the floor and on that
 * swell's length and heading, everything else on all numbers.  The map is the one that
 * the ocean was made of.  TP_E_ARG, and nothing is done: as tp_ocean_init says, or the
 * sea has another count of swells, or the map other sides. */
tp_status tp_ocean_refresh(tp_ocean *ocean, const tp_ocean_config *config,
                           const tp_sea *sea, const tp_wave *waves, uint32_t count,
                           tp_error *err);

typedef struct {
    tp_vec3 position;       /* of the displaced point, m; may overhang */
    tp_fx   depth;          /* of still water at its rest; <= 0: dry, and position.y 0 */
    uint8_t breaking;       /* 0..255: how far its crest is breaking [B14] [B15] */
} tp_ocean_point;

/* The point whose place at rest is (x0, z0), any place of 16.16, at whose ends a position
 * is held; `phases` as tp_sea_phases gives them. */
tp_ocean_point tp_ocean_at_rest(const tp_ocean *ocean, const tp_turn phases[TP_WAVES],
                                tp_fx x0, tp_fx z0);

/* The same without what overhangs (stretch and displacement), for boats and drops: a
 * height field wherever sum Q k A < 1. */
tp_ocean_point tp_ocean_smooth(const tp_ocean *ocean, const tp_turn phases[TP_WAVES],
                               tp_fx x0, tp_fx z0);

/* No point lies farther from its rest than this, along and up. */
tp_fx tp_ocean_reach(const tp_ocean *ocean);
tp_fx tp_ocean_height(const tp_ocean *ocean);

/* Depth under a place, from the ocean's own tables. */
tp_floor_at tp_ocean_floor(const tp_ocean *ocean, tp_fx x, tp_fx z);

/* -- the models one by one --------------------------------------------------------- */

/* An orbit: its semi-axes, r Sx and r Sy, and the tilt alpha of the first. */
typedef struct {
    tp_fx  along, up;
    tp_q30 sin, cos;
} tp_ellipse;

/* Along the way of travel, and up; m from the rest. */
typedef struct {
    tp_fx along, up;
} tp_offset;

/* [B11]-[B13] of a wave of amplitude r (0..64 m) and wave number k over a floor that
 * rises at the angle gamma along its way; k0, kx, ky as in the config. */
tp_ellipse tp_orbit_of(tp_fx r, tp_fx depth, tp_turn gamma, int64_t k_q32, tp_fx k0,
                       tp_fx kx, tp_fx ky);

/* The particle's offset at phase Phi, which is 0 in the trough [A7]. */
tp_offset tp_orbit(const tp_ellipse *orbit, tp_turn phi);

/* The phase of the orbit's lowest point [B16]. */
tp_turn tp_orbit_lowest(const tp_ellipse *orbit);

/* smoothstep(0.6, 0.78, H / h), 16.16. */
tp_fx tp_breaking_gate(tp_fx height_over_depth);

/* A crest that breaks [B17]-[B19]: `stretch` is St_max and `lip` 2 r, in m. */
typedef struct {
    tp_ellipse orbit;
    tp_fx stretch, lip;             /* 0..128 m */
    tp_fx kept_stretch, kept_lip;   /* of them in the offset, 0..1: e^-Kh and the gate */
} tp_breaker;

typedef struct {
    int32_t   p;                    /* Phi - Phi_min, turns Q0.32, -1/2..1/2 */
    tp_fx     stretch, displacement;/* m, whole */
    int32_t   orientation;          /* turns, Q0.32 */
    tp_offset offset;               /* with the orbit's own */
} tp_breaking;
tp_breaking tp_breaking_shape(const tp_breaker *breaker, tp_turn phi);
#endif
