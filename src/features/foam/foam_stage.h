/* SPDX-License-Identifier: MIT */
/* Data of the foam stages, in tp_run.mine. */
#ifndef TP_FOAM_STAGE_H
#define TP_FOAM_STAGE_H
#include <stdint.h>
#include "tidepool/assets.h"

typedef struct {
    const uint8_t *cover;       /* torus of cells x cells bytes */
    uint32_t cells, col, row;   /* cells per side; cell of the low corner */
    tp_fx    low_s, low_t;      /* rest position of the low corner, m */
    uint32_t side;              /* side of the window, m, 16.16 */
    uint64_t per_metre;         /* cells per metre, Q16 over 16.16, Q32 */
    uint32_t edge;              /* 2^24 over an eighth of the window in cells, Q8;
                                 * UINT32_MAX: no fading, walls at the window's edge */
    uint32_t colour;
    const tp_texture *texture;  /* NULL: no texture */
    uint32_t repeats, drift_s, drift_t;     /* as in tp_layer */
    int32_t  lod;
    int32_t  mean;              /* rank of the texture's mean */
    uint8_t  rank[256];         /* share of darker texels, by green, 0..255 */
} tp_shade_foam;

/* name, slopes bent by a ripple, glint below the foam */
#define TP_FOAM_STAGES(X) \
    X(foam,                 0, 0) \
    X(foam_rippled,         1, 0) \
    X(foam_shiny,           0, 1) \
    X(foam_shiny_rippled,   1, 1)

/* Fills `rank`.  With ranks every texture turns white by the share of the cover. */
void tp_shade_foam_make_ranks(tp_shade_foam *foam, const tp_texture *texture);
#endif
