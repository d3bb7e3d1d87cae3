/* SPDX-License-Identifier: MIT */
/* A tank around the pool, and the walls in it: stone, and glass before the viewer.
 *
 * A wall of glass that the eye stands outside of is not drawn: in its place stands the
 * water's side, from the floor up to the water's own edge.  The others are stone inside.
 * The walls that a pool's mask names are blocks, made of its cells once. */
#include "frame/frame.h"
#include "asset/mesh.h"
#include "base/base.h"

/* -- what stands where ---------------------------------------------------------------- */

/* Of the walls: a share of the shorter side. */
static tp_fx thickness(const tp_scene *scene, const tp_rectangle *r)
{
    tp_fx wide = r->x1 / 2 - r->x0 / 2, deep = r->z1 / 2 - r->z0 / 2;
    tp_fx half = wide < deep ? wide : deep;

    return scene->tank.kind == TP_TANK_GLASS ? tp_clamp(half / 80, 512, 8192)
                                             : tp_clamp(half / 12, 2048, TP_FX_ONE);
}

/* Whether the eye stands outside of wall `face`: +x, -x, +z, -z. */
static bool is_outside(const tp_rectangle *r, uint32_t face, tp_vec3 eye)
{
    switch (face) {
    case 0:  return eye.x > r->x1;
    case 1:  return eye.x < r->x0;
    case 2:  return eye.z > r->z1;
    default: return eye.z < r->z0;
    }
}

bool tp_frame_is_glass(const tp_frame *frame, uint32_t face)
{
    tp_rectangle r = tp_pool_sides(frame->scene);
    return frame->scene->tank.kind == TP_TANK_GLASS
        && is_outside(&r, face, frame->lens.eye);
}

/* -- drawing -------------------------------------------------------------------------- */

/* Counter-clockwise seen from where its normal points. */
typedef struct {
    tp_vec3 at[4];
    int16_t n[3];               /* 511 is 1 */
} quad;

static void draw_triangle(const tp_sight *sight, const tp_samples *samples, const quad *q,
                          int b, int c)
{
    const int which[3] = { 0, b, c };
    tp_view_corner in[3];

    for (int k = 0; k < 3; k++)
        in[k] = tp_clipped_corner(sight->lens, q->at[which[k]], q->n);
    tp_clipped_draw(sight->lens, tp_sight_cut(sight), samples, in, TP_MARK_TANK, 0);
}

static void draw_quad(const tp_sight *sight, const tp_samples *samples, const quad *q)
{
    draw_triangle(sight, samples, q, 1, 2);
    draw_triangle(sight, samples, q, 2, 3);
}

/* The face of a box that looks along `face`, from `low` to `high`; or, `inwards`, its
 * other side. */
static void draw_face(const tp_sight *sight, const tp_samples *samples,
                      const tp_rectangle *r, tp_fx low, tp_fx high, uint32_t face,
                      bool inwards)
{
    TP_ASSERT(face < 4 && low <= high);
    static const uint8_t order[4][2] = { { 1, 2 }, { 3, 0 }, { 0, 1 }, { 2, 3 } };
    const tp_fx corner[4][2] = { { r->x0, r->z1 }, { r->x1, r->z1 }, { r->x1, r->z0 },
                                 { r->x0, r->z0 } };
    const tp_fx *a = corner[order[face][inwards]], *b = corner[order[face][!inwards]];
    int16_t out = (face & 1) != inwards ? -511 : 511;
    quad q = { { { a[0], low, a[1] }, { b[0], low, b[1] }, { b[0], high, b[1] },
                 { a[0], high, a[1] } },
               { face & 2 ? 0 : out, 0, face & 2 ? out : 0 } };

    draw_quad(sight, samples, &q);
}

static void draw_top(const tp_sight *sight, const tp_samples *samples, tp_fx y,
                     const tp_fx at[4][2])
{
    quad q = { { { at[0][0], y, at[0][1] }, { at[1][0], y, at[1][1] },
                 { at[2][0], y, at[2][1] }, { at[3][0], y, at[3][1] } }, { 0, 511, 0 } };
    draw_quad(sight, samples, &q);
}

/* Of wall `face`: between its inner and its outer rectangle. */
static void draw_rim(const tp_sight *sight, const tp_samples *samples,
                     const tp_rectangle *in, const tp_rectangle *out, tp_fx y,
                     uint32_t face)
{
    const tp_fx rim[4][4][2] = {
        { { in->x1, in->z1 }, { out->x1, out->z1 }, { out->x1, out->z0 },
          { in->x1, in->z0 } },
        { { in->x0, in->z0 }, { out->x0, out->z0 }, { out->x0, out->z1 },
          { in->x0, in->z1 } },
        { { out->x0, out->z1 }, { out->x1, out->z1 }, { in->x1, in->z1 },
          { in->x0, in->z1 } },
        { { in->x0, in->z0 }, { in->x1, in->z0 }, { out->x1, out->z0 },
          { out->x0, out->z0 } },
    };
    draw_top(sight, samples, y, rim[face]);
}

static void draw_walls(const tp_frame *frame, const tp_sight *sight,
                       const tp_samples *samples)
{
    const tp_scene *scene = frame->scene;
    tp_rectangle in = tp_pool_sides(scene);
    tp_fx t = thickness(scene, &in);
    tp_rectangle out = { tp_fx_held((int64_t)in.x0 - t), tp_fx_held((int64_t)in.x1 + t),
                         tp_fx_held((int64_t)in.z0 - t), tp_fx_held((int64_t)in.z1 + t) };

    for (uint32_t face = 0; face < 4; face++) {
        if (tp_frame_is_glass(frame, face))
            continue;
        draw_face(sight, samples, &in, -scene->tank.depth, scene->tank.rim, face, true);
        draw_rim(sight, samples, &in, &out, scene->tank.rim, face);
        if (scene->tank.kind == TP_TANK_STONE)
            draw_face(sight, samples, &out, -scene->tank.depth, scene->tank.rim, face,
                      false);
    }
}

static void draw_tank(const tp_frame *frame, const tp_sight *sight,
                        tp_samples *samples)
{
    samples->front_only = true;
    if (tp_frame_has_tank(frame) && !frame->under)
        draw_walls(frame, sight, samples);
    for (uint32_t i = 0; i < frame->blocks; i++) {
        const tp_rectangle *r = &frame->parts.block[i];
        const tp_fx top[4][2] = { { r->x0, r->z1 }, { r->x1, r->z1 }, { r->x1, r->z0 },
                                  { r->x0, r->z0 } };
        draw_top(sight, samples, frame->block_high, top);
        for (uint32_t face = 0; face < 4; face++)
            draw_face(sight, samples, r, frame->block_low, frame->block_high, face, false);
    }
}

/* -- blocks --------------------------------------------------------------------------- */

static tp_fx line(tp_fx centre, tp_fx cell, uint32_t i, uint32_t cells)
{
    return tp_fx_held(centre + ((int64_t)i - cells / 2) * cell
                      - (cells & 1 ? cell / 2 : 0));
}

/* One that ends at z0 with the same sides goes on to z1. */
static bool goes_on(tp_frame *frame, tp_rectangle r)
{
    for (uint32_t i = 0; i < frame->blocks; i++) {
        tp_rectangle *b = &frame->parts.block[i];
        if (b->x0 == r.x0 && b->x1 == r.x1 && b->z1 == r.z0) {
            b->z1 = r.z1;
            return true;
        }
    }
    return false;
}

static void add_row(tp_frame *frame, const tp_pool *pool, uint32_t row)
{
    uint32_t end;

    for (uint32_t col = 0; col < pool->cols; col = end) {
        bool wall = tp_pool_wall(pool, col, row);
        for (end = col + 1; end < pool->cols && tp_pool_wall(pool, end, row) == wall; )
            end++;
        tp_rectangle r = { line(pool->x, pool->cell, col, pool->cols),
                           line(pool->x, pool->cell, end, pool->cols),
                           line(pool->z, pool->cell, row, pool->rows),
                           line(pool->z, pool->cell, row + 1, pool->rows) };
        if (!wall || goes_on(frame, r))
            continue;
        if (frame->blocks < TP_BLOCKS)
            frame->parts.block[frame->blocks++] = r;
        else
            frame->blocks_dropped++;
    }
}

/* Three cells high where no rim says it: above what a swell of the usual height does. */
static void place_blocks(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    const tp_pool *pool = tp_world_pool(frame->world);
    bool tank = tp_has_tank(scene);

    frame->block_high = tank ? scene->tank.rim : 3 * scene->pool.cell;
    frame->block_low = tank ? -scene->tank.depth : -scene->pool.range;
    if (!frame->blocks_made)
        for (uint32_t row = 0; pool && row < pool->rows; row++)
            add_row(frame, pool, row);
    frame->blocks_made = true;
    frame->stats.dropped += frame->blocks_dropped;
}

const struct tp_draw_tank tp_draw_tank = {
    place_blocks, draw_tank
};
