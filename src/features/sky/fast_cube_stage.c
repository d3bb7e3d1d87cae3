/* SPDX-License-Identifier: MIT */
/*
 * The fast stage of the visible cube, quality.sky=fast.  Positions on a face are exact at
 * every 16th column and linear between; texels are mixed at every second or fourth column.
 * Columns are counted from the picture's left edge.
 */
#include "features/sky/sky.h"
#include "shade/env.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

/* A view ray at a column, of any length, and its position on its face in 256ths of a
 * texel, not clamped. */
typedef struct {
    tp_ray  to;
    int     face;
    int32_t u, v;
} cube_knot;

/* A way over one face in a block: position in 4096ths of a texel at the block's first
 * column, and its change a column.  The texels of columns 0..16 and their neighbours to the
 * right and below exist. */
typedef struct {
    const uint32_t *texel;
    int32_t  log2_w, u, v, du, dv;
    uint32_t mask;
} face_way;

/* Returns the view ray at a column, u_q32 over focal lengths from the middle column. */
TP_ALWAYS_INLINE tp_ray cube_ray(const tp_shade *shade, const tp_quick_ray_row *row,
                                 int64_t u_q32)
{
    const tp_view_axes *a = &shade->world;
    const int32_t u = tp_clamp((int32_t)(u_q32 >> 18), -65535, 65535);  /* Q14 */

    return (tp_ray){ (u * (a->right.x >> 16) >> 14) - row->x,
                     (u * (a->right.y >> 16) >> 14) - row->y,
                     (u * (a->right.z >> 16) >> 14) - row->z, 0 };
}

/* Selects the face and scales the ray, at least 1 long, to a largest component of
 * 8192..16383 as tp_cube_recip expects.  The components stay below 2^17. */
TP_ALWAYS_INLINE tp_cube_ray scaled_face(tp_ray to)
{
    tp_cube_ray c = tp_cube_face(to.x, to.y, to.z);
    int shift = c.m > 16383 ? 18 - tp_clz((uint32_t)c.m) : 0;

    return (tp_cube_ray){ c.face, c.right >> shift, c.down >> shift, c.m >> shift };
}

/* Sets a knot; *side belongs to *face, both are those of the knot before. */
TP_ALWAYS_INLINE void set_cube_knot(cube_knot *knot, const tp_shade *shade, int level,
                                    tp_ray to, int *face, tp_cube_face_level *side)
{
    const tp_cube_ray c = scaled_face(to);
    const int32_t r = tp_cube_recip(shade->env.recip, c.m);

    if (c.face != *face) {
        *face = c.face;
        *side = tp_cube_face_level_select(shade->env.cube->face[c.face], level);
    }
    knot->to = to;
    knot->face = c.face;
    knot->u = ((32768 + (c.right * r >> 14)) * (1 << side->log2_w) >> 8) - 128;
    knot->v = ((32768 + (c.down * r >> 14)) * (1 << side->log2_h) >> 8) - 128;
}

/* True if a position and its neighbours to the right and below are on the face. */
static bool is_inside_face(const cube_knot *knot, const tp_cube_face_level *side)
{
    return (uint32_t)knot->u < (256u << side->log2_w) - 256
        && (uint32_t)knot->v < (256u << side->log2_h) - 256;
}

/* Mixes four texels by 16ths, all four bytes, rounded down: each sum is at most 255 x
 * 256. */
TP_ALWAYS_INLINE uint32_t mix_texels(const uint32_t *at, int32_t row, uint32_t fu,
                                     uint32_t fv)
{
    const uint32_t both = fu * fv, right = 16 * fu - both, below = 16 * fv - both;
    const uint32_t here = 256 - 16 * fu - below;
    uint32_t rb = tp_even_bytes(at[0]) * here, ag = tp_odd_bytes(at[0]) * here;

    rb += tp_even_bytes(at[1]) * right;
    ag += tp_odd_bytes(at[1]) * right;
    at += row;
    rb += tp_even_bytes(at[0]) * below;
    ag += tp_odd_bytes(at[0]) * below;
    rb += tp_even_bytes(at[1]) * both;
    ag += tp_odd_bytes(at[1]) * both;
    return tp_odd_bytes(rb) | (ag & 0xff00ff00u);
}

TP_NEVER_INLINE uint32_t clamp_light(const tp_shade *shade, uint32_t light)
{
    return tp_light_colour_clamped(shade, light);
}

/* Returns the colour at a position on the face of a way. */
TP_ALWAYS_INLINE uint32_t sample_face(const tp_shade *shade, const face_way *way, int32_t u,
                                      int32_t v)
{
    const uint32_t *at = way->texel + ((v >> 12) << way->log2_w) + (u >> 12);
    uint32_t light = mix_texels(at, 1 << way->log2_w, (uint32_t)u >> 8 & 15,
                                (uint32_t)v >> 8 & 15) & way->mask;

    return light >> 24 ? clamp_light(shade, light) : light;
}

/* Returns the colour of column k of a way over one face. */
TP_NEVER_INLINE uint32_t sample_column(const tp_shade *shade, const face_way *way, int32_t k)
{
    return sample_face(shade, way, way->u + k * way->du, way->v + k * way->dv);
}

/* Returns the colour of column k of a way over an edge. */
TP_NEVER_INLINE uint32_t sample_edge(const tp_shade *shade, const cube_knot *a,
                                     const cube_knot *b, int32_t k)
{
    const int level = tp_env_mip_level(shade, TP_ENV_CUBE, 0);
    const tp_ray ray = { a->to.x + ((b->to.x - a->to.x) * k >> 4),
                         a->to.y + ((b->to.y - a->to.y) * k >> 4),
                         a->to.z + ((b->to.z - a->to.z) * k >> 4), 0 };
    const tp_cube_ray c = scaled_face(ray);
    const tp_cube_face_level side =
        tp_cube_face_level_select(shade->env.cube->face[c.face], level);

    return tp_light_colour_clamped(shade, tp_cube_sample(shade, &c, &side));
}

/* Writes colours of columns first..first + 3 to those within [k, end); `to` is column
 * k. */
TP_ALWAYS_INLINE void put_four(uint32_t *to, const uint32_t colour[4], int32_t first,
                               int32_t k, int32_t end)
{
    for (int32_t i = 0; i < 4; i++)
        if (first + i >= k && first + i < end)
            to[first + i - k] = colour[i];
}

/* Fills columns [k, end) of the block between two knots; `to` is column k.  Every fourth
 * column is sampled, and the column in the middle if its neighbours differ by more than
 * `smooth`, summed over the channels; the columns between get means.  `edge` is a literal:
 * 0 if the block lies on one face. */
TP_ALWAYS_INLINE void fill_fours(const tp_shade *shade, const face_way *way,
                                 const cube_knot *a, const cube_knot *b, uint32_t *to,
                                 int32_t k, int32_t end, int32_t smooth, int edge)
{
    int32_t  first = k & -4;
    uint32_t left = edge ? sample_edge(shade, a, b, first)
                         : sample_column(shade, way, first);

    for (; first < end; first += 4) {
        uint32_t right = edge ? sample_edge(shade, a, b, first + 4)
                              : sample_column(shade, way, first + 4);
        uint32_t middle = tp_uhadd8(left, right);
        if ((int32_t)tp_usad8(left, right) > smooth)
            middle = edge ? sample_edge(shade, a, b, first + 2)
                          : sample_column(shade, way, first + 2);
        const uint32_t colour[4] = { left, tp_uhadd8(left, middle), middle,
                                     tp_uhadd8(middle, right) };
        put_four(to, colour, first, k, end);
        left = right;
    }
}

TP_NEVER_INLINE void fill_part(const tp_shade *shade, const face_way *way, uint32_t *to,
                               int32_t k, int32_t end, int32_t smooth)
{
    fill_fours(shade, way, NULL, NULL, to, k, end, smooth, 0);
}

TP_NEVER_INLINE void fill_edge(const tp_shade *shade, const cube_knot *a,
                               const cube_knot *b, uint32_t *to, int32_t k, int32_t end,
                               int32_t smooth)
{
    fill_fours(shade, NULL, a, b, to, k, end, smooth, 1);
}

/* Fills a whole block over one face with the colours of fill_fours.  `left` is the colour
 * of column 0; returns that of column 16. */
TP_NEVER_INLINE uint32_t fill_whole(const tp_shade *shade, const face_way *way, uint32_t *to,
                                    uint32_t left, int32_t smooth)
{
    const int32_t du = 4 * way->du, dv = 4 * way->dv;
    int32_t u = way->u, v = way->v;

    for (const uint32_t *end = to + 16; to < end; to += 4) {
        u += du;
        v += dv;
        uint32_t right = sample_face(shade, way, u, v);
        uint32_t middle = tp_uhadd8(left, right);
        if ((int32_t)tp_usad8(left, right) > smooth)
            middle = sample_column(shade, way, 18 - (int32_t)(end - to));
        to[0] = left;
        to[1] = tp_uhadd8(left, middle);
        to[2] = middle;
        to[3] = tp_uhadd8(middle, right);
        left = right;
    }
    return left;
}

/* The colour of a knot that is not known. */
#define UNKNOWN UINT32_MAX

/* Fills the run's part of the block whose column 0 is sample `first`, which may lie before
 * the run.  *last is the colour of knot a, or UNKNOWN, and becomes that of knot b. */
TP_ALWAYS_INLINE void fill_cube_block(const tp_shade *shade, const cube_knot *a,
                                      const cube_knot *b, const tp_cube_face_level *side,
                                      tp_run *run, uint32_t *last, int32_t first,
                                      int32_t smooth)
{
    const int32_t i = first > 0 ? first : 0, k = i - first;
    const int32_t end = first + 16 < run->count ? 16 : run->count - first;
    const face_way way = { side->texel, side->log2_w, 16 * a->u, 16 * a->v, b->u - a->u,
                           b->v - a->v, shade->env.cube->mask[b->face] };
    uint32_t left = *last;

    *last = UNKNOWN;
    if (a->face != b->face || !is_inside_face(a, side) || !is_inside_face(b, side)) {
        fill_edge(shade, a, b, run->colour + i, k, end, smooth);
    } else if (end - k < 16) {
        fill_part(shade, &way, run->colour + i, k, end, smooth);
    } else {
        if (left == UNKNOWN)
            left = sample_column(shade, &way, 0);
        *last = fill_whole(shade, &way, run->colour + i, left, smooth);
    }
}

/* Largest difference over four columns, summed over the channels, that counts as smooth.
 * Texels less than 1.7 columns wide may hide detail between equal columns. */
#define SMOOTH      24
#define SMOOTH_LOD  (-128)

void tp_stage_sky_cube_fast(const tp_shade *shade, tp_run *run)
{
    TP_ASSERT(shade->env.cube != NULL && shade->env.recip != NULL);
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    const int     level = tp_env_mip_level(shade, TP_ENV_CUBE, 0);
    const int32_t smooth = shade->env.cube->lod < SMOOTH_LOD ? SMOOTH : -1;
    const int64_t step = 16 * 16 * (int64_t)shade->per_focal;
    int64_t u = (16 * (run->x & ~15) + 8 - shade->u0) * (int64_t)shade->per_focal;
    tp_cube_face_level side = { 0 };
    cube_knot knot[2], *a = &knot[0], *b = &knot[1];
    uint32_t  last = UNKNOWN;
    int       face = -1;

    for (int32_t i = -(run->x & 15); ; i += 16, u += step) {    /* column 0 of a block */
        set_cube_knot(b, shade, level, cube_ray(shade, &row, u), &face, &side);
        if (i > 0)
            fill_cube_block(shade, a, b, &side, run, &last, i - 16, smooth);
        if (i >= run->count)
            return;
        cube_knot *next = a;
        a = b;
        b = next;
    }
}
