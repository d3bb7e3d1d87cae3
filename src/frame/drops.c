/* SPDX-License-Identifier: MIT */
/* Drops and the sphere that they fall from: spheroids of triangles, drawn in the tiles
 * that their boxes touch; small ones take every second meridian and parallel.  A drop
 * keeps its volume whatever its shape: with height over width a = 1 + squash, height goes
 * with a^(2/3) and width with a^(-1/3). */
#include "base/base.h"
#include "frame/frame.h"

/* -- the unit sphere --------------------------------------------------------------- */

/* North pole, parallels from north to south, south pole. */
static void make_ball(tp_frame *frame)
{
    tp_ball_point *to = frame->parts.ball;

    *to++ = (tp_ball_point){ 0, 16384, 0 };
    for (uint32_t j = 1; j <= TP_BALL_RINGS; j++) {
        tp_turn down = (tp_turn)(((uint64_t)j << 31) / (TP_BALL_RINGS + 1));
        tp_q30  ring = tp_sin(down);
        for (uint32_t i = 0; i < TP_BALL_ROUND; i++) {
            tp_turn round = (tp_turn)(((uint64_t)i << 32) / TP_BALL_ROUND);
            *to++ = (tp_ball_point){ (int16_t)(tp_q30_mul(ring, tp_sin(round)) >> 16),
                                     (int16_t)(tp_cos(down) >> 16),
                                     (int16_t)(tp_q30_mul(ring, tp_cos(round)) >> 16) };
        }
    }
    *to = (tp_ball_point){ 0, -16384, 0 };
}

/* -- one of them -------------------------------------------------------------------- */

typedef struct {
    tp_vec3 centre;
    tp_fx   wide, high;         /* half axes, m */
} spheroid;

/* a^(-1/3) by its series to the cube, of |squash| <= 1/2 within 0.017; the height takes
 * what volume is left. */
static spheroid shaped(tp_vec3 centre, tp_fx radius, int32_t squash_q14)
{
    tp_fx q = tp_clamp(squash_q14, -8192, 8192) * 4;
    tp_fx square = tp_fx_mul(q, q);
    tp_fx wide = TP_FX_ONE - q / 3 + square * 2 / 9 - tp_fx_mul(square, q) * 14 / 81;
    tp_fx high = tp_fx_div(TP_FX_ONE, tp_fx_mul(wide, wide));

    return (spheroid){ centre, tp_fx_mul(radius, wide), tp_fx_mul(radius, high) };
}

/* The last one is the sphere. */
static spheroid number(const tp_frame *frame, uint32_t i)
{
    TP_ASSERT(i <= frame->drops_seen);
    const tp_drops *drops = tp_world_drops(frame->world);
    tp_fx back = frame->world->back;
    bool  sphere = i == frame->drops_seen;
    const tp_drop *drop = tp_drops_list(drops) + (sphere ? 0 : i);
    tp_vec3 a = sphere ? drops->last_sphere : drop->last;
    tp_vec3 b = sphere ? drops->sphere : drop->place;
    tp_vec3 at = tp_place_between(a, b, back);

    return sphere ? (spheroid){ at, drops->sphere_radius, drops->sphere_radius }
                  : shaped(at, drop->radius, drop->squash);
}

static tp_view_corner corner_of(const tp_sight *sight, const spheroid *s,
                                const tp_ball_point *p)
{
    tp_vec3 at = { s->centre.x + (tp_fx)((int64_t)p->x * s->wide >> 14),
                   s->centre.y + (tp_fx)((int64_t)p->y * s->high >> 14),
                   s->centre.z + (tp_fx)((int64_t)p->z * s->wide >> 14) };
    tp_view_corner c;

    tp_lens_view(sight->lens, at, &c);
    c.s = c.t = 0;
    c.n[0] = (int16_t)((int64_t)p->x * s->high / (s->wide + s->high + 1) >> 5);
    c.n[1] = (int16_t)((int64_t)p->y * s->wide / (s->wide + s->high + 1) >> 5);
    c.n[2] = (int16_t)((int64_t)p->z * s->high / (s->wide + s->high + 1) >> 5);
    return c;
}

/* Parallel j, every `step`th point of it; both poles are rings of one point. */
static void see_ring(const tp_frame *frame, const tp_sight *sight, const spheroid *s,
                     uint32_t j, uint32_t step, tp_view_corner to[TP_BALL_ROUND])
{
    TP_ASSERT(j <= TP_BALL_RINGS + 1 && step > 0);
    const bool north = j == 0, south = j > TP_BALL_RINGS;
    const tp_ball_point *ring = &frame->parts.ball[south ? TP_BALL - 1
                                                   : north ? 0 : 1 + (j - 1) * TP_BALL_ROUND];

    for (uint32_t i = 0; i < TP_BALL_ROUND; i += step)
        to[i] = (north || south) && i > 0 ? to[0] : corner_of(sight, s, &ring[i]);
}

/* -- placing ------------------------------------------------------------------------ */

static const tp_grid_box nowhere = { 1, 1, 0, 0 };

/* By the corners of the ball; one that must be clipped may be anywhere.  Of a ball that
 * the level cuts the whole is taken. */
static tp_grid_box box_of(const tp_frame *frame, const tp_sight *sight, const spheroid *s,
                          uint32_t step)
{
    tp_grid_box box = TP_BOX_NONE;
    tp_view_corner ring[TP_BALL_ROUND];
    bool ahead = false, cut = false;

    for (uint32_t j = 0; j <= TP_BALL_RINGS + 1; j += step) {
        see_ring(frame, sight, s, j, step, ring);
        for (uint32_t i = 0; i < TP_BALL_ROUND; i += step) {
            tp_corner p;
            ahead |= ring[i].depth >= sight->lens->near
                  && (!sight->cut || tp_view_height(&sight->level, &ring[i]) >= 0);
            cut |= !tp_lens_holds(sight->lens, &ring[i]);
            if (cut)
                continue;
            tp_lens_project(sight->lens, &ring[i], &p.u, &p.v, &p.zi);
            tp_box_widen(&box, p.u, p.v);
        }
    }
    if (!ahead)
        return nowhere;
    return cut ? (tp_grid_box){ INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX } : box;
}

/* Every second point is enough up to 16 pixels across: its outline is off by 8 % of half
 * of that. */
static uint32_t step_of(const tp_grid_box *box)
{
    return box->x1 - box->x0 > 16 || box->y1 - box->y0 > 16 ? 1 : 2;
}

static void widen(tp_grid_box *all, const tp_grid_box *box)
{
    tp_box_widen(all, 16 * box->x0, 16 * box->y0);
    tp_box_widen(all, 16 * box->x1, 16 * box->y1);
}

static void place_drops(tp_frame *frame, tp_sight *sight)
{
    const tp_drops *drops = tp_world_drops(frame->world);

    frame->drops_seen = drops->count < frame->parts.drop_capacity ? drops->count
                                                            : frame->parts.drop_capacity;
    frame->stats.dropped += drops->count - frame->drops_seen;
    for (uint32_t i = 0; i <= frame->drops_seen; i++) {
        spheroid s = number(frame, i);
        frame->parts.drop_box[i] = box_of(frame, sight, &s, 2);
        uint32_t step = step_of(&frame->parts.drop_box[i]);
        if (step == 1)
            frame->parts.drop_box[i] = box_of(frame, sight, &s, 1);
        if (frame->parts.drop_box[i].x0 <= frame->parts.drop_box[i].x1) {
            uint32_t points = TP_BALL_ROUND / step * (TP_BALL_RINGS / step);
            widen(&sight->drops_box, &frame->parts.drop_box[i]);
            frame->stats.vertices += points + 2;
            frame->stats.triangles += 2 * points;
        }
    }
}

/* -- drawing ------------------------------------------------------------------------ */

static void draw_face(const tp_sight *sight, const tp_samples *tile,
                      const tp_view_corner *a, const tp_view_corner *b,
                      const tp_view_corner *c)
{
    const tp_view_corner in[3] = { *a, *b, *c };

    tp_clipped_draw(sight->lens, tp_sight_cut(sight), tile, in, TP_MARK_DROP, 0);
}

static void draw_one(const tp_frame *frame, const tp_sight *sight, const tp_samples *tile,
                     const spheroid *s, uint32_t step)
{
    tp_view_corner ring[2][TP_BALL_ROUND];

    see_ring(frame, sight, s, 0, step, ring[0]);
    for (uint32_t j = 0; j <= TP_BALL_RINGS; j += step) {
        const tp_view_corner *above = ring[j / step & 1];
        tp_view_corner *below = ring[(j / step + 1) & 1];
        see_ring(frame, sight, s, j + step, step, below);
        for (uint32_t i = 0; i < TP_BALL_ROUND; i += step) {
            uint32_t next = (i + step) % TP_BALL_ROUND;
            if (j + step <= TP_BALL_RINGS)
                draw_face(sight, tile, &above[i], &below[i], &below[next]);
            if (j > 0)
                draw_face(sight, tile, &above[i], &below[next], &above[next]);
        }
    }
}

static void draw_drops(const tp_frame *frame, const tp_sight *sight, tp_samples *tile)
{
    tile->front_only = true;
    for (uint32_t i = 0; i <= frame->drops_seen; i++) {
        if (!tp_sight_touches(&frame->parts.drop_box[i], tile))
            continue;
        spheroid s = number(frame, i);
        draw_one(frame, sight, tile, &s, step_of(&frame->parts.drop_box[i]));
    }
}

const struct tp_draw_drops tp_draw_drops = {
    .solid = { place_drops, draw_drops }, .init = make_ball,
};
