/* SPDX-License-Identifier: MIT */
/* Foam and spray: what of the water turns white.
 *
 * Foam is a field of cover, a byte a cell, over the places at rest: so it goes with the
 * water that waves displace.  Its cells lie on an endless lattice that drifts as the
 * scene says; the field is a window on it, cells x cells, around the pool or the eye, and
 * is stored as a torus: cell (i, j) of the lattice lies at column i mod cells, row j mod
 * cells, wherever the window is.
 *
 * Spray is a list of specks that fly through the air, and of bubbles that rise in the
 * water. */
#ifndef TP_FOAM_H
#define TP_FOAM_H
#include <stddef.h>
#include <stdint.h>
#include "tidepool/fx.h"
#include "tidepool/language.h"

TP_BEGIN_C

#define TP_FOAM_TICKS 4         /* a quarter of the rows is looked after in each tick */

/* Plain data without pointers; the cells' bytes follow this head, row by row. */
typedef struct {
    uint32_t cells;             /* of a side, 1..256 */
    tp_fx    cell;              /* m */
    int64_t  drift_x, drift_z;  /* Q32 m, 0 to a side: of the lattice's origin */
    int32_t  first_x, first_z;  /* the window's lowest lattice cell */
    int32_t  seen[TP_FOAM_TICKS][2];    /* the same when a quarter was last visited */
    uint32_t visits;            /* ticks so far */
    uint32_t work;              /* byte offset of a row's places, 0: none */
} tp_foam;

/* Cover 0..255 at a place at rest, bilinear between cells' centres; 0 outside. */
uint8_t tp_foam_at(const tp_foam *foam, tp_fx x, tp_fx z);

typedef enum { TP_SPECK_SPRAY, TP_SPECK_BUBBLE } tp_speck_kind;

typedef struct {
    tp_vec3  place, last;       /* m, now and a tick ago */
    tp_vec3  speed;             /* m/s */
    uint16_t age;               /* ticks */
    uint8_t  kind;              /* tp_speck_kind */
    uint8_t  chance;            /* 0..255, its own: thins out what is far away */
} tp_speck;

/* The specks follow this head. */
typedef struct {
    uint32_t capacity, count;
    uint32_t dropped;           /* that found no place, so far */
    uint32_t random;
} tp_spray;

const tp_speck *tp_spray_list(const tp_spray *spray);

TP_END_C
#endif
