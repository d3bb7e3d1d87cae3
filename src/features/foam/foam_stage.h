/* SPDX-License-Identifier: MIT */
/* The data that the stages of foam read, in tp_run.mine. */
#ifndef TP_FOAM_STAGE_H
#define TP_FOAM_STAGE_H
#include <stdint.h>
#include "tidepool/assets.h"

typedef struct {
    const uint8_t *cover;       /* cells x cells bytes, a torus */
    uint32_t cells, col, row;   /* of a side; where the window's low corner lies */
    tp_fx    low_s, low_t;      /* m at rest: that corner */
    uint32_t side;              /* m of the window, 16.16 */
    uint64_t per_metre;         /* cells, Q16 over 16.16, Q32 */
    uint32_t edge;              /* 2^24 over an eighth of the window in cells, Q8; all
                                   ones: the window ends at walls */
    uint32_t colour;
    const tp_texture *texture;  /* NULL: plain */
    uint32_t repeats, drift_s, drift_t;     /* as a tp_layer's */
    int32_t  lod;
    int32_t  mean;              /* rank of the texture's mean */
    uint8_t  rank[256];         /* share of the texture that is darker, by its green */
} tp_shade_foam;

/* name, slopes that a ripple has bent, glint beneath it */
#define TP_FOAM_STAGES(X) \
    X(foam,                 0, 0) \
    X(foam_rippled,         1, 0) \
    X(foam_shiny,           0, 1) \
    X(foam_shiny_rippled,   1, 1)

/* Fills rank: so that of any picture as many texels turn white as the cover says. */
void tp_shade_foam_rank(tp_shade_foam *foam, const tp_texture *texture);
#endif
