/* SPDX-License-Identifier: MIT */
/* Pictures at half the size, or a quarter, that water looks into: objects mirrored at the
 * level, and objects under it.  Both are whole pictures of their own, drawn before any
 * tile, a few rows at a time so that the samples stay small.
 *
 * The mirrored one is what an eye as deep under the level as the camera is above it sees
 * when it looks up as far as the camera looks down, upside down [F4]; the sunken one has
 * heights below the level by 3 / 4, so deep does flat water show them. */
#include "frame/frame.h"
#include "tidepool/light.h"

static void carve_half(tp_half_store *store, tp_arena *arena, uint32_t width,
                       uint32_t height, uint32_t halvings)
{
    store->halvings = halvings;
    store->cols = (width + (1u << halvings) - 1) >> halvings;
    store->rows = (height + (1u << halvings) - 1) >> halvings;
    store->colour = tp_arena_take(arena, (size_t)store->cols * store->rows,
                                  sizeof *store->colour);
    store->zi = tp_arena_take(arena, store->cols, sizeof *store->zi);
    store->samples = tp_arena_take(arena, (size_t)store->cols * TP_HALF_BAND,
                                   4 * sizeof *store->samples);
}

/* The part of the picture that `box` covers; false: none. */
static bool begin(const tp_half_store *store, const tp_grid_box *box, tp_half *half)
{
    TP_ASSERT(store->colour != NULL);
    int32_t cols = (int32_t)store->cols, rows = (int32_t)store->rows;

    *half = (tp_half){
        store->colour, tp_clamp(box->x0, 0, cols), tp_clamp(box->y0, 0, rows),
        tp_clamp(box->x1 + 1, 0, cols), tp_clamp(box->y1 + 1, 0, rows),
        (int32_t)store->halvings - 1,
    };
    if (half->x0 < half->x1 && half->y0 < half->y1)
        return true;
    half->colour = NULL;
    return false;
}

static tp_samples band_of(const tp_half_store *store, const tp_half *half, int32_t y0)
{
    size_t plane = (size_t)store->cols * TP_HALF_BAND;
    int32_t y1 = y0 + TP_HALF_BAND < half->y1 ? y0 + TP_HALF_BAND : half->y1;

    return (tp_samples){ half->x0, y0, half->x1, y1, store->cols, store->samples,
                         store->samples + plane, store->samples + 2 * plane,
                         store->samples + 3 * plane, false };
}

/* The columns' depths, as far as row y of a band tells. */
static void see_depths(tp_mirrored_zi *zi, const tp_samples *band, int32_t y)
{
    const uint32_t *key = band->key + (size_t)(uint32_t)(y - band->y0) * band->stride;

    for (int32_t i = 0; i < band->x1 - band->x0; i++) {
        uint32_t at = TP_ZI(key[i]);
        if (at == 0)
            continue;
        zi[i].far = zi[i].near == 0 || at < zi[i].far ? at : zi[i].far;
        zi[i].near = at > zi[i].near ? at : zi[i].near;
    }
}

/* Columns without an object take their left neighbour's depths, the first ones those of
 * the first that has one. */
static void fill_gaps(tp_mirrored_zi *zi, uint32_t count)
{
    uint32_t first = 0;

    while (first + 1 < count && zi[first].near == 0)
        first++;
    for (uint32_t i = 0; i < first; i++)
        zi[i] = zi[first];
    for (uint32_t i = first + 1; i < count; i++)
        zi[i] = zi[i].near ? zi[i] : zi[i - 1];
}

/* -- mirrored ----------------------------------------------------------------------- */

/* Rows of this lens's picture count from the other end, so that row j of it is row
 * rows - 1 - j of the camera's: its up is the camera's, mirrored and turned round. */
static tp_lens mirror_lens(const tp_frame *frame, tp_fx level)
{
    TP_ASSERT(frame->parts.mirrored.halvings > 0);
    const tp_lens *from = &frame->lens;
    const tp_dir3  r = from->turn.x, up = from->turn.y, back = from->turn.z;
    const tp_rotation turn = { { r.x, -r.y, r.z }, { -up.x, up.y, -up.z },
                               { back.x, -back.y, back.z } };
    tp_lens lens;

    tp_lens_turned(&lens, (tp_vec3){ from->eye.x, 2 * level - from->eye.y, from->eye.z },
                   turn, frame->scene->camera.fov, from->near, frame->config.width,
                   frame->config.height);
    for (uint32_t n = 0; n < frame->parts.mirrored.halvings; n++)
        lens = tp_lens_halved(&lens);
    lens.v0 = 16 * (int32_t)frame->parts.mirrored.rows - lens.v0;
    return lens;
}

/* Pixels by which objects are mirrored from below the level too: water at their feet
 * mixes half pixels from both sides of it.  That much of a mirror lies behind its object,
 * so nobody sees it. */
enum { OVERLAP = 2 };

/* Troughs bare a hull and show it below the level.  Walls and the floor between them would
 * be mirrored there over all the water. */
static tp_view_plane mirror_level(const tp_frame *frame, const tp_lens *lens, tp_fx level)
{
    const tp_fx trough = -tp_surface_height(&frame->surface);
    const bool  bare = !tp_sight_has_walls(frame) && trough < level;
    tp_view_plane plane = tp_lens_level(lens, bare ? trough : level, 1);

    plane.depth += (int32_t)(((int64_t)OVERLAP << 43) / lens->focal);   /* half pixels */
    return plane;
}

static void set_bending(tp_frame *frame, tp_fx level)
{
    tp_mirrored *to = &frame->shade.bending;

    to->bend = frame->scene->mirror.bend >> 8;
    to->height = (int64_t)(frame->lens.eye.y - level) * 4096 / frame->lens.zi_near;
    to->zi = frame->parts.mirrored.zi;
}

static void draw_mirror(tp_frame *frame, const tp_sight *sight, tp_half *half)
{
    const tp_half_store *store = &frame->parts.mirrored;
    uint32_t wide = (uint32_t)(half->x1 - half->x0);

    memset(store->zi, 0, wide * sizeof *store->zi);
    for (int32_t y0 = half->y0; y0 < half->y1; y0 += TP_HALF_BAND) {
        tp_samples band = band_of(store, half, y0);
        tp_samples_clear(&band);
        tp_sight_draw(frame, sight, &band);
        for (int32_t y = y0; y < band.y1; y++) {
            tp_frame_colour_row(frame, &band, y,
                                store->colour + (uint32_t)(half->y1 - 1 - y) * wide);
            see_depths(store->zi, &band, y);
        }
    }
    fill_gaps(store->zi, wide);
}

static void draw_mirrored(tp_frame *frame)
{
    const int32_t rows = (int32_t)frame->parts.mirrored.rows;
    tp_fx    level = tp_sight_level(frame);
    tp_half *half = &frame->shade.mirrored;

    half->colour = NULL;
    if (!tp_sight_above(frame, level))
        return;
    tp_lens  lens = mirror_lens(frame, level);
    tp_sight sight = { .lens = &lens, .cut = true, .walls = true,
                       .level = mirror_level(frame, &lens, level) };
    tp_sight_begin(frame, &sight);
    tp_grid_box box = tp_sight_place(frame, &sight);
    if (!begin(&frame->parts.mirrored, &box, half))
        return;
    set_bending(frame, level);
    draw_mirror(frame, &sight, half);
    *half = (tp_half){ half->colour, half->x0, rows - half->y1, half->x1,
                       rows - half->y0, half->coarser };
}

/* -- sunken ------------------------------------------------------------------------- */

#define ETA TP_Q30(TP_WATER_ETA)

/* Heights over the level times ETA, in the rows: (S p - eye).r = (p - S^-1 eye).(S r). */
static tp_lens sunken_lens(const tp_lens *lens, tp_fx level)
{
    tp_lens to = *lens;
    int64_t up = (int64_t)(lens->eye.y - level) * TP_Q30_ONE / ETA;

    to.eye.y = tp_fx_held(level + up);
    to.right.y = tp_q30_mul(lens->right.y, ETA);
    to.up.y = tp_q30_mul(lens->up.y, ETA);
    to.ahead.y = tp_q30_mul(lens->ahead.y, ETA);
    return to;
}

/* The way under water for each metre of apparent depth, 16.16: the refracted ray has
 * sin = ETA sin, and the true depth is the apparent one over ETA. */
static tp_fx way_of(const tp_frame *frame, int32_t x, int32_t y)
{
    tp_ray  ray = tp_view_ray(&frame->shade, &frame->shade.world, x, y);
    int64_t s2 = (1 << 28) - (int64_t)ray.y * ray.y;            /* Q28 */
    int64_t c2 = (1 << 28) - ((s2 * (ETA >> 15) >> 15) * (ETA >> 15) >> 15);
    tp_fx   c = (tp_fx)(tp_isqrt64((uint64_t)c2 << 4));         /* Q16 */
    return tp_fx_div(TP_FX(TP_WATER_INDEX), c);
}

/* Water takes its share of each colour, by how deep under the level the sample lies. */
static void absorb_row(const tp_frame *frame, const tp_lens *lens, tp_fx height,
                       const tp_samples *band, int32_t y, uint32_t *to)
{
    const uint32_t *key = band->key + (size_t)(uint32_t)(y - band->y0) * band->stride;
    const uint32_t deep = (uint32_t)frame->scene->water.deep;
    const int64_t v = tp_over_focal(&frame->shade, lens->v0 - 16 * y - 8);
    const int64_t middle = -((lens->ahead.y >> 14) + (v * (lens->turn.y.y >> 14) >> 16));
    const int64_t aside = -(lens->turn.x.y >> 14)               /* a 16th of a pixel */
                        * (int64_t)frame->shade.per_focal;
    tp_fx way = way_of(frame, band->x0, y);

    for (int32_t x = band->x0; x < band->x1; x++, key++, to++) {
        if (x % 16 == 0)
            way = way_of(frame, x + 8, y);
        if (*to == 0)
            continue;
        int64_t z = tp_depth_of(lens->zi_near, tp_key_zi(*key));
        int64_t fall = middle + ((16 * x + 8 - lens->u0) * aside >> 32);
        tp_fx   depth = tp_fx_held((fall * z >> 16) - height);
        *to = tp_absorb_at(&frame->shade.absorb, *to & 0xffffff, deep,
                           tp_fx_mul(depth > 0 ? depth : 0, way)) | 0xff000000u;
    }
}

static void draw_below(tp_frame *frame, const tp_sight *sight, const tp_lens *lens,
                       tp_fx height, const tp_half *half)
{
    const tp_half_store *store = &frame->parts.sunken;
    uint32_t wide = (uint32_t)(half->x1 - half->x0);

    for (int32_t y0 = half->y0; y0 < half->y1; y0 += TP_HALF_BAND) {
        tp_samples band = band_of(store, half, y0);
        tp_samples_clear(&band);
        tp_sight_draw(frame, sight, &band);
        for (int32_t y = y0; y < band.y1; y++) {
            uint32_t *to = store->colour + (uint32_t)(y - half->y0) * wide;
            tp_frame_colour_row(frame, &band, y, to);
            absorb_row(frame, lens, height, &band, y, to);
        }
    }
}

static void draw_sunken(tp_frame *frame)
{
    tp_fx    level = tp_sight_level(frame);
    tp_half *half = &frame->shade.sunken;

    half->colour = NULL;
    if (!tp_sight_above(frame, level))
        return;
    const tp_lens lens = tp_lens_halved(&frame->lens);
    const tp_lens bent = sunken_lens(&lens, level);
    tp_sight sight = { .lens = &bent, .cut = true,
                       .level = tp_lens_level(&lens, level, -1) };
    tp_sight_begin(frame, &sight);
    tp_grid_box box = tp_sight_place(frame, &sight);
    if (!begin(&frame->parts.sunken, &box, half))
        return;
    draw_below(frame, &sight, &lens, frame->lens.eye.y - level, half);
}

const struct tp_draw_mirrored tp_draw_mirrored = {
    carve_half, draw_mirrored
};

const struct tp_draw_sunken tp_draw_sunken = {
    carve_half, draw_sunken
};
