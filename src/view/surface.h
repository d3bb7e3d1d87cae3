/* SPDX-License-Identifier: MIT */
/*
 * The water surface of all wave models together, at single points and at the vertices of
 * a grid.  Swells of deep water, or coastal water over its floor, displace a point of
 * still water; rings and pools add heights at the displaced position. A model without a
 * part in the scene is NULL or 0 and is not asked.
 */
#ifndef TP_VIEW_SURFACE_H
#define TP_VIEW_SURFACE_H
#include "pool/pool.h"
#include "tidepool/modules.h"
#include "view/projection.h"
#include "waves/coastal_water.h"
#include "waves/deep_water.h"

typedef struct {
    const tp_wave_models *by;   /* wave models of the program; models it lacks are not
                                 * used here */
    const tp_deep_water *deep;
    const tp_turn  *phases;
    const tp_coastal_water *coastal; /* replaces the sum of `deep`; NULL: deep water */
    const tp_ring_now *ring;
    uint32_t        rings;
    const tp_ring  *raised;     /* rings of the world, the source of `ring` at its tick */
    uint32_t        n_raised;   /* number of `raised` rings */
    const tp_pool  *pool, *field;
    tp_fx           lag;        /* interpolation of the pools, 0..1 tick */
} tp_surface;

/* Returns the summed height and slopes of rings, pool and field at world (x, z), without
 * the swells. */
tp_height_slope tp_rings_pools_sample(const tp_surface *surface, tp_fx x, tp_fx z);

/* Same, times `weight`, 0..1.  A mesh fades its waves in the distance, where its cells are
 * too wide for them. */
tp_height_slope tp_rings_pools_sample_faded(const tp_surface *surface, tp_fx x, tp_fx z,
                                            tp_fx weight);

/* True if the deep water has swells and the program has their wave model. */
static inline bool tp_surface_has_swells(const tp_surface *surface)
{
    return surface->deep->count > 0 && surface->by->swells;
}

/* True if the surface has rings or pools. */
static inline bool tp_surface_has_rings_or_pools(const tp_surface *surface)
{
    return surface->rings || surface->pool || surface->field;
}

/* Bounds of the displacement from a rest position, m: horizontal and vertical. */
tp_fx tp_surface_displacement_bound(const tp_surface *surface);
tp_fx tp_surface_height_bound(const tp_surface *surface);

/* Returns the surface point above or below a position; ignores overhangs.  `rest` (x0,
 * z0) may be NULL; otherwise it is the start of the search and receives the rest position
 * found. */
tp_surface_point tp_surface_sample(const tp_surface *surface, tp_fx x, tp_fx z,
                                   tp_fx rest[2]);

/* Same for coastal water, without rings and pools; `rest` is not NULL. */
tp_surface_point tp_surface_coastal_sample(const tp_surface *surface, tp_fx x, tp_fx z,
                                           tp_fx rest[2]);

/* Returns the displaced point of a rest position, without rings and pools. */
tp_vec3 tp_surface_displace(const tp_surface *surface, tp_fx x, tp_fx z);

/* Returns the water level at a place, by one step of the search of [E1].  The error shows
 * only in steep waves; spray uses the level, and there has specks enough to hide it. */
tp_fx tp_surface_rough_height(const tp_surface *surface, tp_fx x, tp_fx z);

/* Computes dy/dx and dy/dz of a surface that goes along_x from column to column and
 * along_z from row to row (16.16 m, lengths below 2 km).  Slopes are within +-8;
 * overhangs get the limit. */
void tp_slopes_from_tangents(tp_vec3 along_x, tp_vec3 along_z, tp_fx *slope_x,
                             tp_fx *slope_z);

/* -- grid vertices ------------------------------------------------------------------- */

/*
 * Grid vertices of a row: displaced by the swells, transformed to view space and
 * projected.  The loops run once per vertex of the water, so they are optimised to the
 * instruction.
 *
 * The phase of a swell at a vertex is a + b, with a from the column and b from the row.
 * View coordinates, slopes and Jacobian of a vertex are sums over swells of
 * C cos(a + b) + S sin(a + b), with C and S constant in a frame.  Each term is
 *     sin a (S cos b - C sin b) + cos a (C cos b + S sin b):
 * two products per swell, of two numbers of the row with sine and cosine of the column.
 * The value of a vertex therefore depends on its column and row only, not on the start of
 * a run.  Waves fade by a product of two weights: the column's weight scales its sines,
 * the row's weight scales its numbers.  Fading costs a vertex nothing.
 *
 * Positions are summed in 64 bits, 16.16 plus lower bits.  Slopes and Jacobian are summed
 * in 32 bits from 16-bit products, two at a time if the processor has such an
 * instruction.  Profiles of sharpened swells are not sines; wave_models.c evaluates them
 * separately.
 */

#define TP_VERTEX_BATCH 32      /* vertices processed at a time */

/* A grid vertex: displaced, projected, packed. */
typedef struct {
    int32_t  u, v;              /* 28.4 px; u = TP_GRID_NEEDS_CLIP: needs clipping */
    uint32_t zi;                /* near / depth, Q1.31 */
    int16_t  slope_x, slope_z;  /* slopes, Q3.12 */
} tp_grid_vertex;

#define TP_GRID_NEEDS_CLIP INT32_MIN

typedef struct {
    tp_fx place;                /* rest position, world x or z, m */
    tp_fx fade;                 /* weight of the waves, 0..1 */
} tp_grid_line;

/* Sine and cosine of an angle such as a phase, Q2.30. */
typedef struct {
    int32_t sin, cos;
} tp_vertex_sincos;

/* Numbers of a swell, constant in a frame. */
typedef struct {
    int32_t x, y, depth;                /* view coordinates: m per cosine, Q.20 */
    int32_t rise_x, rise_y, rise_depth; /* m per sine, Q.20; rise_x: 0 without roll */
    int32_t tilt_x, tilt_z;             /* k A D, Q.(14 + tilt) */
    int32_t bend_xx, bend_xz, bend_zz;  /* QkA D D, Q.29; not crossed: xx is QkA */
} tp_vertex_swell;

typedef struct {
    const tp_projection *projection;
    const tp_surface *surface;
    tp_vertex_swell swell[TP_WAVES];
    uint32_t most;                      /* swells that the columns have memory for */
    uint32_t count;                     /* number of swells */
    int      tilt;                      /* fraction bits of slopes, 9..19 */
    tp_fx    max_displacement;          /* largest displacement of a vertex, m */
    int32_t  margin;                    /* the same in view coordinates */
    int32_t  far;                       /* smallest depth for the fast projection */
    bool     wide;                      /* true if view coordinates may exceed 16.16 */
} tp_vertex_frame;

/* Tables of the columns, with frame.count turns and pairs per column. */
typedef struct {
    tp_grid_line   *line;
    int32_t        *rest[3];            /* parts of x, y, depth, by tp_vertex_x_to_view */
    tp_vertex_sincos *turn;             /* phases times fade weights; for sharpened crests,
                                        * phases alone */
    uint32_t       *pair;               /* two Q.15: the sine low, the cosine high */
} tp_vertex_columns;

/* Numbers of a swell in a row: pairs for the sine and cosine of the column. */
typedef struct {
    uint32_t tilt_x, tilt_z;            /* Q.tilt */
    uint32_t bend_xx, bend_xz, bend_zz; /* Q.15; xx and zz are negative */
} tp_vertex_tilt;

typedef struct {
    tp_grid_line     line;
    int32_t          rest[3];
    tp_vertex_sincos turn[TP_WAVES];        /* row phases times fade weights */
    tp_vertex_sincos place[3][TP_WAVES];    /* x, y, depth: m per sine and cosine, Q.18 */
    tp_vertex_tilt   tilt[TP_WAVES];
} tp_vertex_row;

/* Starts a frame for water in x0..x1 and z0..z1.  The caller sets projection and
 * surface; the function sets all other members. */
void tp_vertex_begin(tp_vertex_frame *frame, tp_fx x0, tp_fx x1, tp_fx z0, tp_fx z1);

/* Computes the numbers of all swells; after tp_vertex_begin. */
void tp_vertex_set_swells(tp_vertex_frame *frame);

/* Compute the view coordinates of water at rest: the part of a column at x, and the part
 * of a row at z, including the height of the eye. 16.16, or 18.14 in wide frames. */
void tp_vertex_x_to_view(const tp_vertex_frame *frame, tp_fx x, int32_t view_part[3]);
void tp_vertex_z_to_view(const tp_vertex_frame *frame, tp_fx z, int32_t view_part[3]);

/* Returns sine and cosine of an angle, within 2^-28. */
tp_vertex_sincos tp_vertex_sincos_from_angle(tp_turn angle);

/* Returns sine and cosine of the sum of two angles, by the addition theorems. */
TP_ALWAYS_INLINE tp_vertex_sincos tp_vertex_sincos_add_angles(tp_vertex_sincos a,
                                                              tp_vertex_sincos b)
{
    const int64_t half = 1 << 29;
    return (tp_vertex_sincos){
        .sin = (int32_t)(((int64_t)a.sin * b.cos + (int64_t)a.cos * b.sin + half) >> 30),
        .cos = (int32_t)(((int64_t)a.cos * b.cos - (int64_t)a.sin * b.sin + half) >> 30),
    };
}

/* Computes the tables of columns first to end - 1; neighbouring lines are `cell` apart. */
void tp_vertex_set_columns(const tp_vertex_frame *frame, const tp_vertex_columns *columns,
                           uint32_t first, uint32_t end, tp_fx cell);

/* Computes the numbers of a row for positions and, if `sloped`, for slopes.  The caller
 * sets line and rest. */
void tp_vertex_set_row(const tp_vertex_frame *frame, tp_vertex_row *row, bool sloped);

/* Evaluates `count` <= TP_VERTEX_BATCH vertices from column `first`.  `at_rest`: no wave
 * reaches any of the vertices (column or row without waves); a run must not mix both
 * cases. */
void tp_vertex_evaluate_batch(const tp_vertex_frame *frame,
                              const tp_vertex_columns *columns, const tp_vertex_row *row,
                              uint32_t first, uint32_t count, bool at_rest,
                              tp_grid_vertex *vertex);

/* Returns a vertex before projection, with the same bits that tp_vertex_evaluate_batch
 * projects; its slopes stay 0.  The row needs no tilts. */
tp_view_vertex tp_vertex_make_view_vertex(const tp_vertex_frame *frame,
                                          const tp_vertex_columns *columns,
                                          const tp_vertex_row *row, uint32_t column,
                                          bool at_rest);

/* -- runs of vertices, for the files of src/view alone ------------------------------- */

/* View coordinates of a run: x, y, depth, 16.16 m. */
typedef struct {
    int32_t at[3][TP_VERTEX_BATCH];
} tp_vertex_batch;

/* The inputs of a run: tables, first column, number of vertices; `at_rest`: without
 * waves. */
typedef struct {
    const tp_vertex_frame   *frame;
    const tp_vertex_columns *columns;
    const tp_vertex_row     *row;
    uint32_t                 first, count;
    bool                     at_rest;
} tp_vertex_batch_input;

/* tp_batch_displace_axis: displaces a run along a view axis: from + rest + the
 * displacement by swells. tp_batch_set_slopes: computes the slopes. */
void tp_batch_displace_axis(const tp_vertex_batch_input *place, int axis,
                            const int32_t *from, int32_t rest, int32_t *to);
void tp_batch_set_slopes(const tp_vertex_batch_input *place, tp_grid_vertex *to);

/* Returns sum + both products of the 16-bit halves; the same bits on every processor. */
TP_ALWAYS_INLINE int32_t tp_add_pair_products(int32_t sum, uint32_t a, uint32_t b)
{
#if defined(__ARM_FEATURE_DSP) && __ARM_FEATURE_DSP
    return __builtin_arm_smlad((int32_t)a, (int32_t)b, sum);
#else
    return sum + (int16_t)a * (int16_t)b + ((int32_t)a >> 16) * ((int32_t)b >> 16);
#endif
}

TP_ALWAYS_INLINE int16_t tp_saturated(int32_t x)
{
#if defined(__ARM_FEATURE_SAT) && __ARM_FEATURE_SAT
    return (int16_t)__builtin_arm_ssat(x, 16);
#else
    return (int16_t)tp_clamp(x, INT16_MIN, INT16_MAX);
#endif
}

#define TP_JACOBIAN_ONE (1 << 30)

/* Terms of a slope [A9]: h in Q.(15 + tilt), |h| < 2^31; J in Q2.30, between 0.048 and
 * 1.952; bxz is -Jxz. */
typedef struct {
    int32_t hx, hz, jxx, jzz, bxz;
} tp_jacobian;

/* Computes slopes by [A10], see waves/deep_water.c: num / det.  J J is Q.28; h J, below
 * 2^62.5 with both terms of a sum, is Q.(13 + tilt).  The reciprocal of a det shifted up
 * by 2..8 is 2^(34 - shift) / det.  Shifted down by tilt - 1 - shift, not negative as
 * tilt >= 9, the reciprocal takes the numerators to 16.16 for every tilt. */
TP_ALWAYS_INLINE void tp_set_slopes(const tp_jacobian *j, int slope_bits, bool crossed,
                                    tp_grid_vertex *to)
{
    int32_t det = j->jxx >> 2, nx = j->hx >> 2, nz = j->hz >> 2;

    if (crossed) {
        det = tp_mul_upper(j->jxx, j->jzz) - tp_mul_upper(j->bxz, j->bxz);
        nx = tp_upper((int64_t)j->hx * j->jzz + (int64_t)j->hz * j->bxz);
        nz = tp_upper((int64_t)j->hz * j->jxx + (int64_t)j->hx * j->bxz);
    }
    int     shift = tp_clz((uint32_t)det);
    TP_ASSERT(det > 0 && shift < slope_bits);
    int32_t r = tp_recip_rough((uint32_t)det << shift) >> (slope_bits - 1 - shift);
    to->slope_x = tp_saturated((tp_mul_upper(nx, r) + 8) >> 4);
    to->slope_z = tp_saturated((tp_mul_upper(nz, r) + 8) >> 4);
}

#endif
