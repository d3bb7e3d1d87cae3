/* SPDX-License-Identifier: MIT */
/* Flat water: a level plane, pixel by pixel, without mesh or wave outline.  Along a row
 * world positions are linear in x.  In a rolled picture positions are exact at every 16th
 * column and linear between; where depth changes much within 16 columns, each pixel is
 * exact.  Slopes are interpolated between the points of slope_grid.c; a sea without waves
 * has slope 0.
 *
 * Valid for any camera above the highest crest at any pitch and roll, and for water of any
 * outline.  Not valid if the surface shows more than waves: rings and pools as heights, a
 * coastal floor or wind tables, a tank. */
#include "frame/frame.h"
#include "frame/renderers.h"

enum { CELL = TP_LATTICE_CELL, BLOCK = 16 };

/* -- filling pixels ------------------------------------------------------------------ */

/* A world coordinate along a row, 16.16 with 16 more fraction bits; may wrap. */
typedef struct {
    uint64_t now, step;
} flat_walker;

/* Neighbouring pixels of one row. */
typedef struct tp_flat_piece {
    uint32_t *key, *s, *t, *n;
    int32_t   x, y, count;
    uint32_t  zi, zi_step;
    flat_walker place[2];
} flat_piece;

/* Interpolated values of a few pixels; 32 bits suffice.  n packs both slopes; the lower
 * half may carry into the upper half. */
typedef struct {
    uint32_t s, s_step, t, t_step, n, n_step;
} few;

TP_ALWAYS_INLINE uint32_t make_water_key(uint32_t zi)
{
    return (zi << 1 & ~(uint32_t)0xff) | TP_MARK_WATER;
}

/* Returns the values at the start of a block; `from` is the pixel's index in the row and
 * lies `off` pixels after the start. */
TP_ALWAYS_INLINE few start_interpolants(const flat_piece *p, int32_t from, int32_t off)
{
    uint64_t s = p->place[0].now + p->place[0].step * (uint64_t)(int64_t)(from - off);
    uint64_t t = p->place[1].now + p->place[1].step * (uint64_t)(int64_t)(from - off);
    few f = { .s_step = (uint32_t)((p->place[0].step + 32768) >> 16),
              .t_step = (uint32_t)((p->place[1].step + 32768) >> 16) };

    f.s = (uint32_t)(s >> 16) + f.s_step * (uint32_t)off;
    f.t = (uint32_t)(t >> 16) + f.t_step * (uint32_t)off;
    return f;
}

/* Fills `count` pixels from `from` on; the flags are literals. */
TP_ALWAYS_INLINE void fill(const flat_piece *p, int32_t from, int32_t count, few f,
                           int waves, int rolled, int tested)
{
    uint32_t *key = p->key + from, *s = p->s + from, *t = p->t + from, *n = p->n + from;
    uint32_t  zi = p->zi + p->zi_step * (uint32_t)from, now = make_water_key(zi);

    for (const uint32_t *end = key + count; key < end; key++, s++, t++, n++) {
        if (rolled) {
            now = make_water_key(zi);
            zi += p->zi_step;
        }
        if (!tested || now > (*key | 0xff)) {
            *key = now;
            *s = f.s;
            *t = f.t;
            *n = waves ? f.n : 0;
        }
        f.s += f.s_step;
        f.t += f.t_step;
        if (waves)
            f.n += f.n_step;
    }
}

/* Slopes at one side of a cell at row y, Q.15. */
typedef struct {
    int32_t x, z;
} side;

static inline side interpolate_side(const uint32_t *point, uint32_t cols, int32_t down)
{
    uint32_t a = point[0], b = point[cols];
    int32_t  up = CELL - down;

    return (side){ (int16_t)(a >> 16) * up + (int16_t)(b >> 16) * down,
                   (int16_t)(a & 0xffff) * up + (int16_t)(b & 0xffff) * down };
}

static uint32_t pack_slopes(int32_t x, int32_t z)
{
    return (uint32_t)x * 65536u + (uint32_t)z;
}

/* Fills a piece of a row, with slopes interpolated between the points of the slope grid. */
TP_ALWAYS_INLINE void fill_with_waves(const tp_frame *frame, const flat_piece *p,
                                      int rolled, int tested)
{
    const uint32_t cols = frame->buffers.slope_cols;
    const uint32_t *point = frame->buffers.slopes + (uint32_t)(p->y / CELL) * cols
                          + (uint32_t)(p->x / CELL);
    const int32_t down = p->y % CELL;
    side a = interpolate_side(point, cols, down);

    for (int32_t from = 0, count; from < p->count; from += count) {
        int32_t off = (p->x + from) % CELL;
        side b = interpolate_side(++point, cols, down);
        few  f = start_interpolants(p, from, off);
        f.n_step = pack_slopes((b.x - a.x + 32) >> 6, (b.z - a.z + 32) >> 6);
        f.n = pack_slopes((a.x + 4) >> 3, (a.z + 4) >> 3) + f.n_step * (uint32_t)off;
        count = CELL - off < p->count - from ? CELL - off : p->count - from;
        fill(p, from, count, f, 1, rolled, tested);
        a = b;
    }
}

TP_ALWAYS_INLINE void fill_without_waves(const flat_piece *p, int rolled, int tested)
{
    for (int32_t from = 0, count; from < p->count; from += count) {
        int32_t off = (p->x + from) % BLOCK;
        count = BLOCK - off < p->count - from ? BLOCK - off : p->count - from;
        fill(p, from, count, start_interpolants(p, from, off), 0, rolled, tested);
    }
}

static void fill_waves_piece(const tp_frame *frame, const struct tp_flat_piece *p,
                             bool tested)
{
    if (frame->buffers.level->rolled)
        fill_with_waves(frame, p, 1, 1);
    else if (tested)
        fill_with_waves(frame, p, 0, 1);
    else
        fill_with_waves(frame, p, 0, 0);
}

const struct tp_draw_flat_waves tp_draw_flat_waves = {
    tp_frame_layout_slopes, tp_frame_place_slopes, fill_waves_piece,
};

/* Pieces of pictures that do not roll. */
static void fill_piece(const tp_frame *frame, const flat_piece *p, bool tested)
{
    TP_ASSERT(p->count > 0 && p->x >= 0 && p->y >= 0);

    if (tp_surface_has_swells(&frame->surface))
        frame->program->draw.flat_waves->fill(frame, p, tested);
    else if (tested)
        fill_without_waves(p, 0, 1);
    else
        fill_without_waves(p, 0, 0);
}

/* -- rows without roll --------------------------------------------------------------- */

/* Returns the walker of a row, computed from absolute x = 0: a product of a 31-bit factor
 * and a 30-bit pixel direction. */
static flat_walker make_walker(tp_level_scale scale, tp_fx eye, const tp_level_linear *sum,
                               int32_t x, int32_t y)
{
    int      shift = scale.shift > 16 ? scale.shift - 16 : 0;
    int64_t  first = (int64_t)scale.factor * (int32_t)(tp_level_evaluate(sum, 0, y) >> 14);
    uint64_t step = (uint64_t)((int64_t)scale.factor * sum->x >> (shift + 14));
    uint64_t from = (uint64_t)(first >> shift) + ((uint64_t)(int64_t)eye << 16);

    return (flat_walker){ from + step * (uint32_t)x, step };
}

static void draw_row_without_roll(const tp_frame *frame, flat_piece *p, bool tested)
{
    const tp_level *level = frame->buffers.level;
    tp_level_scale scale =
        tp_level_metres_per_pixel(level, tp_level_evaluate(&level->down, 0, p->y));

    p->zi = (uint32_t)(tp_level_evaluate(&level->zi, 0, p->y) >> TP_LEVEL_ZI);
    p->place[0] = make_walker(scale, level->x, &level->east, p->x, p->y);
    p->place[1] = make_walker(scale, level->z, &level->south, p->x, p->y);
    fill_piece(frame, p, tested);
}

/* -- rows with roll ------------------------------------------------------------------ */

/* Depth term and world position at the start or the end of a block. */
typedef struct {
    int64_t  down;
    uint32_t place[2];
} knot;

static knot intersect_level_plane(const tp_level *level, int32_t x, int32_t y)
{
    knot k = { tp_level_evaluate(&level->down, x, y), { 0, 0 } };

    if (k.down <= 0)
        return k;
    tp_level_scale scale = tp_level_metres_per_pixel(level, k.down);
    k.place[0] = (uint32_t)level->x
                 + (uint32_t)tp_level_pixels_to_metres(
                     scale, tp_level_evaluate(&level->east, x, y));
    k.place[1] = (uint32_t)level->z
                 + (uint32_t)tp_level_pixels_to_metres(
                     scale, tp_level_evaluate(&level->south, x, y));
    return k;
}

/* True if depth changes by less than 1/32 between two knots: the position half way is then
 * off by less than 1/4000 of the distance. */
static bool is_depth_nearly_equal(const knot *a, const knot *b)
{
    int64_t change = a->down - b->down;

    change = change < 0 ? -change : change;
    return a->down > 0 && b->down > 0 && change <= a->down >> 5;
}

static void fill_rolled_piece(const tp_frame *frame, const flat_piece *p)
{
    if (tp_surface_has_swells(&frame->surface))
        frame->program->draw.flat_waves->fill(frame, p, true);
    else
        fill_without_waves(p, 1, 1);
}

static void draw_interpolated_positions(const tp_frame *frame, flat_piece *p, const knot *a,
                              const knot *b)
{
    uint32_t off = (uint32_t)p->x % BLOCK;

    for (int axis = 0; axis < 2; axis++) {
        int64_t  way = (int32_t)(b->place[axis] - a->place[axis]);
        uint64_t step = (uint64_t)(way * (65536 / BLOCK));
        p->place[axis] =
            (flat_walker){ ((uint64_t)a->place[axis] << 16) + step * off, step };
    }
    fill_rolled_piece(frame, p);
}

static void draw_pixel_by_pixel(const tp_frame *frame, const flat_piece *block)
{
    for (int32_t i = 0; i < block->count; i++) {
        knot  k = intersect_level_plane(frame->buffers.level, block->x + i, block->y);
        flat_piece p = { block->key + i, block->s + i, block->t + i, block->n + i,
                    block->x + i, block->y, 1, block->zi + block->zi_step * (uint32_t)i,
                    0, { { (uint64_t)k.place[0] << 16, 0 },
                         { (uint64_t)k.place[1] << 16, 0 } } };
        fill_rolled_piece(frame, &p);
    }
}

static void draw_rolled_row(const tp_frame *frame, const struct tp_flat_piece *row)
{
    const tp_level *level = frame->buffers.level;
    knot a = intersect_level_plane(level, row->x & ~(BLOCK - 1), row->y);

    for (int32_t i = 0, count; i < row->count; i += count) {
        int32_t x = row->x + i, off = x % BLOCK;
        knot    b = intersect_level_plane(level, x - off + BLOCK, row->y);
        count = BLOCK - off < row->count - i ? BLOCK - off : row->count - i;
        flat_piece p = { .key = row->key + i,
                         .s = row->s + i,
                         .t = row->t + i,
                         .n = row->n + i,
                         .x = x,
                         .y = row->y,
                         .count = count };
        p.zi_step = (uint32_t)(level->zi.x >> TP_LEVEL_ZI);
        p.zi = (uint32_t)(tp_level_evaluate(&level->zi, x - off, row->y) >> TP_LEVEL_ZI)
               + p.zi_step * (uint32_t)off;
        if (is_depth_nearly_equal(&a, &b))
            draw_interpolated_positions(frame, &p, &a, &b);
        else
            draw_pixel_by_pixel(frame, &p);
        a = b;
    }
}

const struct tp_draw_flat_roll tp_draw_flat_roll = { draw_rolled_row };

/* -- a tile -------------------------------------------------------------------------- */

static bool has_any_sample(const uint32_t *key, int32_t count)
{
    uint32_t any = 0;

    for (int32_t i = 0; i < count; i++)
        any |= key[i];
    return any != 0;
}

static void draw_flat(const tp_frame *frame, tp_gbuffer *tile, void *memory)
{
    const tp_level *level = frame->buffers.level;
    unsigned mask = tp_level_clip_mask(level, tile->x0, tile->y0, tile->x1, tile->y1);

    (void)memory;
    for (int32_t y = tile->y0; y < tile->y1; y++) {
        int32_t x0 = tile->x0, x1 = tile->x1;
        tp_level_clip_span(level, mask, y, &x0, &x1);
        if (x0 >= x1)
            continue;
        size_t at = (size_t)(uint32_t)(y - tile->y0) * tile->stride
                  + (uint32_t)(x0 - tile->x0);
        flat_piece  p = { tile->key + at, tile->s + at, tile->t + at, tile->n + at, x0, y,
                     x1 - x0, 0, 0, { { 0, 0 }, { 0, 0 } } };
        if (level->rolled)
            frame->program->draw.flat_roll->draw_row(frame, &p);
        else
            draw_row_without_roll(frame, &p, has_any_sample(p.key, p.count));
    }
}

/* -- the renderer -------------------------------------------------------------------- */

static void layout_flat(tp_frame_buffers *buffers, tp_arena *arena,
                        const tp_program *program, const tp_scene *scene,
                        const tp_config *config)
{
    buffers->level = tp_arena_alloc(arena, 1, sizeof *buffers->level);
    if (program->water.swells && program->draw.flat_waves)
        program->draw.flat_waves->layout(buffers, arena, scene, config);
}

static bool can_draw_flat(tp_frame *frame)
{
    return tp_frame_can_use_level_plane(frame)
           && (frame->projection.turn.x.y == 0 || frame->program->draw.flat_roll)
           && (!tp_surface_has_swells(&frame->surface) || frame->buffers.slopes);
}

static void place_flat(tp_frame *frame)
{
    tp_frame_place_level(frame);
    if (tp_surface_has_swells(&frame->surface))
        frame->program->draw.flat_waves->place(frame);
}

const struct tp_water_renderer tp_method_flat = {
    .layout = layout_flat, .holds = can_draw_flat, .place = place_flat, .draw = draw_flat,
};
