/* SPDX-License-Identifier: MIT */
/*
 * The foam of 16 columns for vectorizing compilers, with the bits of foam_stage.c's loop: a
 * part of that file.  Each step is a loop over all columns, with selects for branches; the
 * field's bytes and the cover over a floor are read one column after another.
 */
#ifndef TP_FEATURES_FOAM_FOAM_WIDE_H
#define TP_FEATURES_FOAM_FOAM_WIDE_H

/* A cell's byte of each column, the steps to its neighbours, and their weights.  weight: as
 * in sample_window; bytes: of four cells, row by row. */
typedef struct {
    int32_t  first[16], right[16], below[16];
    uint32_t fs[16], ft[16], weight[16], bytes[16];
} window_cells;

TP_ALWAYS_INLINE void find_window_cells(const tp_shade_foam *f, const uint32_t *restrict s,
                                        const uint32_t *restrict t, int32_t count,
                                        window_cells *restrict to)
{
    const uint32_t low = (uint32_t)f->per_metre, high = (uint32_t)(f->per_metre >> 32);
    const uint32_t n = f->cells, col = f->col, row = f->row, side = f->side;
    const uint32_t low_s = (uint32_t)f->low_s, low_t = (uint32_t)f->low_t, edge = f->edge;
    const uint32_t r = n * 128, inner = edge == UINT32_MAX ? UINT32_MAX : (r * r >> 4) * 9;

    for (int32_t k = 0; k < count; k++) {
        const uint32_t ds = s[k] - low_s, dt = t[k] - low_t;
        const uint32_t in = 0 - (uint32_t)((ds < side) & (dt < side));
        const uint32_t u = ds * high + (uint32_t)((uint64_t)ds * low >> 32);
        const uint32_t w = dt * high + (uint32_t)((uint64_t)dt * low >> 32);
        const uint32_t du = (u >> 8) - r, dw = (w >> 8) - r, square = du * du + dw * dw;
        const uint32_t left = square < r * r ? r * r - square : 0;
        uint32_t share = (uint32_t)((uint64_t)left * edge >> 32);
        share = share < 256 ? share : 256;
        share = square > inner ? share : 256;
        const uint32_t a = u + 32768, b = w + 32768;
        uint32_t i = (a >> 16) + col, j = (b >> 16) + row;
        i = (i - (i >= n ? n : 0)) & in;
        j = (j - (j >= n ? n : 0)) & in;
        to->first[k] = (int32_t)(j * n + i);
        to->right[k] = (int32_t)(i + 1 < n ? 1 : 0 - i);
        to->below[k] = (int32_t)((j + 1 < n ? 1 : 0 - j) * n);
        to->fs[k] = a >> 8 & 0xff;
        to->ft[k] = b >> 8 & 0xff;
        to->weight[k] = share & in;
    }
}

/* Reads the cells where the window has weight. */
TP_ALWAYS_INLINE void read_window_cells(const uint8_t *cover, window_cells *to,
                                        int32_t count)
{
    for (int32_t k = 0; k < count; k++) {
        const uint8_t *here = cover + to->first[k], *below = here + to->below[k];
        const int32_t right = to->right[k];
        to->bytes[k] = to->weight[k] == 0 ? 0
                     : (uint32_t)here[0] | (uint32_t)here[right] << 8
                           | (uint32_t)below[0] << 16 | (uint32_t)below[right] << 24;
    }
}

/* Fills the cover inside the window, 0..255. */
TP_ALWAYS_INLINE void mix_window_cells(const window_cells *w, int32_t count,
                                       uint32_t *restrict cover)
{
    for (int32_t k = 0; k < count; k++) {
        const uint32_t byte = w->bytes[k], fs = w->fs[k], ft = w->ft[k];
        const uint32_t over = (byte & 0xff) * (256 - fs) + (byte >> 8 & 0xff) * fs;
        const uint32_t under = (byte >> 16 & 0xff) * (256 - fs) + (byte >> 24) * fs;
        cover[k] = (over * (256 - ft) + under * ft + 0x8000) >> 16;
    }
}

/* Mixes the cover beyond the window into the covers, by the window's weight: that of open
 * water, or any. */
TP_ALWAYS_INLINE void mix_open_cover(const tp_shade_foam *f, const tp_run *run, int32_t i,
                                     int32_t count, uint32_t v, const window_cells *w,
                                     uint32_t *restrict cover)
{
    for (int32_t k = 0; k < count; k++) {
        const uint32_t far =
            tp_foam_open_cover(f, f->far_fresh, f->far_old, run, i + k, v);
        cover[k] = (cover[k] * w->weight[k] + far * (256 - w->weight[k]) + 128) >> 8;
    }
}

TP_ALWAYS_INLINE void mix_far_cover(const tp_shade_foam *f, const tp_run *run, int32_t i,
                                      int32_t count, uint32_t v, const window_cells *w,
                                      uint32_t *cover)
{
    for (int32_t k = 0; k < count; k++) {
        const uint32_t share = w->weight[k];
        if (share < 256)
            cover[k] = (cover[k] * share + far_cover(f, run, i + k, v) * (256 - share)
                        + 128) >> 8;
    }
}

/* Fills the ranks of the bubbles at both scales; `patched` is the cover after the large
 * scale. */
TP_ALWAYS_INLINE void rank_bubbles(const tp_shade_foam *f, const tp_foam_lace *l,
                                   const uint32_t *restrict s, const uint32_t *restrict t,
                                   int32_t count, const tp_entry8 *restrict ranks,
                                   const uint32_t *restrict cover,
                                   uint32_t *restrict patched, int32_t *restrict rank)
{
    if (l->wide.texel)
        for (int32_t k = 0; k < count; k++) {
            const uint32_t ds = s[k] * f->wide_repeats + f->wide_drift_s;
            const uint32_t dt = t[k] * f->wide_repeats + f->wide_drift_t;
            const int32_t rank_there = (int32_t)ranks[tp_foam_mix_bubbles(&l->wide, ds, dt)];
            patched[k] = tp_foam_spread_cover(cover[k], rank_there - l->wide_middle);
        }
    else
        for (int32_t k = 0; k < count; k++)
            patched[k] = cover[k];
    if (l->level.texel)
        for (int32_t k = 0; k < count; k++)
            rank[k] = (int32_t)ranks[tp_foam_mix_bubbles(&l->level, s[k] * f->repeats + f->drift_s,
                                                 t[k] * f->repeats + f->drift_t)];
    else
        for (int32_t k = 0; k < count; k++)
            rank[k] = 128;
}

/* Fills the shares of white. */
TP_ALWAYS_INLINE void lace_covers(const tp_foam_lace *l, int32_t count, const window_cells *w,
                                  const uint32_t *restrict cover,
                                  const uint32_t *restrict patched,
                                  const int32_t *restrict rank, uint32_t *restrict share)
{
    for (int32_t k = 0; k < count; k++) {
        const uint32_t faint = (cover[k] * TP_FOAM_MEAN_SHARE + 128) >> 8;
        const uint32_t white = tp_foam_whiteness(l, rank[k], patched[k]);
        const uint32_t laced = cover[k] > 0 ? tp_foam_lace_opacity(white, patched[k]) : 0;
        const bool is_faint = (w->weight[k] < 256) & (cover[k] < TP_FOAM_FAINT);
        share[k] = is_faint ? faint : laced;
    }
}

TP_ALWAYS_INLINE void mix_foam(const tp_shade *shade, const tp_run *run, int32_t i,
                               int32_t count, uint32_t white,
                               const uint32_t *restrict share, uint32_t *restrict colour,
                               uint16_t *restrict glint, int slopes, int has_glint)
{
    for (int32_t k = 0; k < count; k++) {
        const uint32_t lit =
            tp_colour_scale(white, slope_light(shade, run, i + k, slopes));
        colour[k] = tp_colour_mix(colour[k], lit, share[k]);
        if (has_glint)
            glint[k] = (uint16_t)(glint[k] * (256 - share[k]) >> 8);
    }
}

/* Shades `count` columns from column i on, at most 16. */
TP_ALWAYS_INLINE void foam_columns_wide(const tp_shade *shade, tp_run *run, int32_t i,
                                        int32_t count, int slopes, int has_glint)
{
    const tp_shade_foam *f = run->mine;
    const uint32_t *s = run->s + i, *t = run->t + i;
    window_cells w;
    uint32_t cover[16] = { 0 }, patched[16], share[16], any = 0, all = 256;
    int32_t  rank[16];

    find_window_cells(f, s, t, count, &w);
    read_window_cells(f->cover, &w, count);
    mix_window_cells(&w, count, cover);
    for (int32_t k = 0; k < count; k++)
        all &= w.weight[k];
    if (all != 256) {
        const uint32_t v = tp_foam_filtered_variance(shade, f, run->key[i]);
        if (f->far_fresh)
            mix_open_cover(f, run, i, count, v, &w, cover);
        else
            mix_far_cover(f, run, i, count, v, &w, cover);
    }
    for (int32_t k = 0; k < count; k++)
        any |= cover[k];
    if (any == 0)
        return;
    tp_foam_lace l;
    tp_foam_lace_select(shade, f, run->key[i], &l);
    rank_bubbles(f, &l, s, t, count, f->rank, cover, patched, rank);
    lace_covers(&l, count, &w, cover, patched, rank, share);
    mix_foam(shade, run, i, count, f->colour, share, run->colour + i, run->glint + i,
             slopes, has_glint);
}
#endif
