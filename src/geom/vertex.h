/* SPDX-License-Identifier: MIT */
/* Crossings of a row, displaced by the swells, seen by the lens and projected: what is
 * done once for each vertex of the water, so its loops are counted in instructions.
 *
 * A swell's phase at a crossing is a + b, a of the column and b of the row.  What swells
 * add to a crossing, in view coordinates, slopes and the Jacobian, is a sum of
 * C cos(a + b) + S sin(a + b), C and S the frame's, that is
 *     sin a (S cos b - C sin b) + cos a (C cos b + S sin b):
 * two products a swell, of two numbers of the row and the column's sine and cosine.  So a
 * crossing's value depends on its column and row alone, not on where a run begins.  Waves
 * fade by the product of a number of the column, which scales its sines, and one of the
 * row, which scales its numbers: a crossing pays nothing for it.
 *
 * Places are summed in 64 bits, 16.16 with what is below; slopes and the Jacobian in 32,
 * from products of 16 bits, two at a time where the processor has such an instruction.
 * Sharpened seas, whose profiles are no sines, go by a way of their own. */
#ifndef TP_GEOM_VERTEX_H
#define TP_GEOM_VERTEX_H
#include "geom/geom.h"
#include "geom/surface.h"

#define TP_VERTEX_RUN 32        /* crossings that are worked on at a time */

/* A crossing: displaced, projected, packed. */
typedef struct {
    int32_t  u, v;              /* 28.4; u = TP_GRID_CUT: must be clipped */
    uint32_t zi;                /* Q1.31 */
    int16_t  slope_x, slope_z;  /* Q3.12 */
} tp_grid_vertex;

#define TP_GRID_CUT INT32_MIN

typedef struct {
    tp_fx place;                /* world x or z at rest */
    tp_fx fade;                 /* of the waves, 0..1 */
} tp_grid_line;

/* Of a phase, Q2.30. */
typedef struct {
    int32_t sin, cos;
} tp_vertex_turn;

/* A swell's numbers of the frame. */
typedef struct {
    int32_t x, y, depth;                /* of the view: m per cosine, Q.20 */
    int32_t rise_x, rise_y, rise_depth; /* m per sine, Q.20; x: of a camera that rolls */
    int32_t tilt_x, tilt_z;             /* k A D, Q.(14 + tilt) */
    int32_t bend_xx, bend_xz, bend_zz;  /* QkA D D, Q.29; not crossed: xx is QkA */
} tp_vertex_swell;

struct tp_thinning;                     /* geom/lod.h */

typedef struct {
    const tp_lens    *lens;
    const tp_surface *surface;
    const struct tp_thinning *lod;      /* of columns and rows; NULL: lines are even */
    tp_vertex_swell   swell[TP_WAVES];
    uint32_t most;                      /* swells that columns have room for */
    uint32_t count;                     /* of swells */
    int      tilt;                      /* bits of slopes, 9..19 */
    tp_fx    reach;                     /* no crossing lies farther from its rest ... */
    int32_t  margin;                    /* ... nor in view coordinates */
    int32_t  far;                       /* a depth beyond which projecting is easy */
    bool     wide;                      /* view coordinates may not fit 16.16 */
} tp_vertex_frame;

/* The columns' tables, frame.count turns and pairs to a column. */
typedef struct {
    tp_grid_line   *line;
    int32_t        *rest[3];            /* the parts x, y and depth, of tp_vertex_rest_x */
    tp_vertex_turn *turn;               /* faded, unless the sea is sharpened */
    uint32_t       *pair;               /* two Q.15: the sine low, the cosine high */
} tp_vertex_columns;

/* A swell's numbers of a row: pairs for the column's sine and cosine. */
typedef struct {
    uint32_t tilt_x, tilt_z;            /* Q.tilt */
    uint32_t bend_xx, bend_xz, bend_zz; /* Q.15; those of xx and zz negative */
} tp_vertex_tilt;

typedef struct {
    tp_grid_line   line;
    int32_t        rest[3];
    tp_vertex_turn turn[TP_WAVES];      /* of the phase, faded as the columns' pairs are */
    tp_vertex_turn place[3][TP_WAVES];  /* m of x, y and depth per sine and cosine, Q.18 */
    tp_vertex_tilt tilt[TP_WAVES];
} tp_vertex_row;

/* lens, surface and lod set, the rest is filled in, for water in x0..x1 and z0..z1. */
void tp_vertex_begin(tp_vertex_frame *frame, tp_fx x0, tp_fx x1, tp_fx z0, tp_fx z1);

/* Of a frame that has begun, the swells' numbers. */
void tp_vertex_set_swells(tp_vertex_frame *frame);

/* View coordinates of water at rest: the part of a column at x, and that of a row at z
 * with the eye's height.  16.16, or 18.14 in wide frames. */
void tp_vertex_rest_x(const tp_vertex_frame *frame, tp_fx x, int32_t rest[3]);
void tp_vertex_rest_z(const tp_vertex_frame *frame, tp_fx z, int32_t rest[3]);

/* Sine and cosine within 2^-28. */
tp_vertex_turn tp_vertex_turn_of(tp_turn angle);

/* The phase b more. */
TP_ALWAYS_INLINE tp_vertex_turn tp_vertex_turned(tp_vertex_turn a, tp_vertex_turn b)
{
    const int64_t half = 1 << 29;
    return (tp_vertex_turn){
        .sin = (int32_t)(((int64_t)a.sin * b.cos + (int64_t)a.cos * b.sin + half) >> 30),
        .cos = (int32_t)(((int64_t)a.cos * b.cos - (int64_t)a.sin * b.sin + half) >> 30),
    };
}

/* Tables of columns first to end - 1, whose lines are laid `cell` apart. */
void tp_vertex_set_columns(const tp_vertex_frame *frame, const tp_vertex_columns *columns,
                           uint32_t first, uint32_t end, tp_fx cell);

/* A row's numbers for places, and for slopes too; line and rest are set already. */
void tp_vertex_set_row(const tp_vertex_frame *frame, tp_vertex_row *row, bool sloped);

/* `count` <= TP_VERTEX_RUN crossings from column `first`, all of them `still` (column or
 * row without waves) or none. */
void tp_vertex_place(const tp_vertex_frame *frame, const tp_vertex_columns *columns,
                     const tp_vertex_row *row, uint32_t first, uint32_t count, bool still,
                     tp_grid_vertex *vertex);

/* One crossing before projection, bit by bit what tp_vertex_place projects; its slopes are
 * left 0.  The row needs no tilts. */
tp_view_corner tp_vertex_corner(const tp_vertex_frame *frame,
                                const tp_vertex_columns *columns,
                                const tp_vertex_row *row, uint32_t column, bool still);
#endif
