/* SPDX-License-Identifier: MIT */
/* Spray and bubbles: small discs over what has been drawn, nearer ones in front.  A speck
 * narrower than a pixel is one pixel or none, by its own chance: so far spray thins out
 * and does not flicker. */
#include "base/base.h"
#include "frame/frame.h"

#define WIDE_MOST (48 * 16)

/* The speck between its last two ticks.  What lies under flat water shows at 3/4 of its
 * depth [F4]. */
static tp_vec3 place_of(const tp_speck *s, tp_fx back, bool through)
{
    tp_vec3 at = tp_place_between(s->last, s->place, back);

    if (through && at.y < 0)
        at.y -= at.y / 4;
    return at;
}

/* 28.4 pixels across, of spray.size from half to one and a half; 0: too small for its
 * chance.  The lens holds the place, so depth >= near. */
static uint32_t width_of(const tp_frame *frame, const tp_speck *s, tp_fx depth)
{
    TP_ASSERT(depth >= frame->lens.near);
    int32_t own = 128 + (uint8_t)(s->chance * 77);  /* no matter of the chance itself */
    int64_t size = (int64_t)frame->scene->spray.size * own >> 8;
    int64_t wide = (size * frame->lens.focal >> 12) / depth;

    if (wide < 16)
        return wide * 16 > s->chance ? 16 : 0;
    return wide < WIDE_MOST ? (uint32_t)wide : WIDE_MOST;
}

static bool project(const tp_frame *frame, const tp_speck *s, bool through,
                    tp_frame_speck *to)
{
    tp_view_corner view;

    tp_lens_view(&frame->lens, place_of(s, frame->world->back, through), &view);
    if (!tp_lens_holds(&frame->lens, &view))
        return false;
    tp_lens_project(&frame->lens, &view, &to->u, &to->v, &to->zi);
    to->wide = (uint16_t)width_of(frame, s, view.depth);
    to->through = through;
    return to->wide > 0;
}

/* White in the light of a level place: for specks. */
static uint32_t spray_colour(const tp_shade *shade, uint32_t colour)
{
    int32_t lit = tp_lit_share(shade->ambient, shade->world.ly);
    return tp_colour_scale(colour, (uint32_t)(lit + (256 - lit) / 2));
}

static void place_spray(tp_frame *frame)
{
    const tp_spray *spray = tp_world_spray(frame->world);
    bool under = frame->under, clear = frame->scene->water.clear > 0;

    frame->specks = 0;
    frame->shade.spray = spray_colour(&frame->shade,
                                      (uint32_t)frame->scene->foam.colour);
    for (uint32_t i = 0; spray && i < spray->count; i++) {
        if (frame->specks == frame->parts.speck_capacity)
            break;
        const tp_speck *s = &tp_spray_list(spray)[i];
        bool bubble = s->kind == TP_SPECK_BUBBLE;
        if (bubble && !under && !clear)
            continue;
        frame->specks += project(frame, s, bubble && !under,
                                 &frame->parts.speck[frame->specks]);
    }
}

/* -- drawing ------------------------------------------------------------------------- */

static void put(const tp_samples *tile, size_t at, const tp_frame_speck *s)
{
    uint32_t depth = s->zi << 1 & ~(uint32_t)0xff, there = tile->key[at];

    if (depth <= (there | 0xff) && !(s->through && TP_MARK(there) == TP_MARK_WATER))
        return;
    tile->key[at] = depth | TP_MARK_SPRAY;
    tile->s[at] = tile->t[at] = tile->n[at] = 0;
}

/* Pixels whose centres lie within; of the smallest the one that holds its middle. */
static void draw(const tp_samples *tile, const tp_frame_speck *s)
{
    int32_t r = s->wide / 2, u = s->u, v = s->v;

    if (s->wide == 16) {
        u = (u & ~15) + 8;
        v = (v & ~15) + 8;
    }
    for (int32_t y = (v - r) >> 4; y <= (v + r) >> 4; y++) {
        for (int32_t x = (u - r) >> 4; x <= (u + r) >> 4; x++) {
            int32_t dx = 16 * x + 8 - u, dy = 16 * y + 8 - v;
            if (dx * dx + dy * dy <= r * r && x >= tile->x0 && x < tile->x1
                && y >= tile->y0 && y < tile->y1)
                put(tile, (size_t)(y - tile->y0) * tile->stride
                          + (size_t)(x - tile->x0), s);
        }
    }
}

static void draw_spray(const tp_frame *frame, const tp_samples *tile)
{
    for (uint32_t i = 0; i < frame->specks; i++) {
        const tp_frame_speck *s = &frame->parts.speck[i];
        int32_t r = s->wide / 2 + 16;
        if (s->u + r >= 16 * tile->x0 && s->u - r < 16 * tile->x1
            && s->v + r >= 16 * tile->y0 && s->v - r < 16 * tile->y1)
            draw(tile, s);
    }
}

const struct tp_draw_spray tp_draw_spray = {
    place_spray, draw_spray
};
