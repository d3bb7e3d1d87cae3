/* SPDX-License-Identifier: MIT */
/* Draws spray and bubbles: small discs over the finished picture, with a depth test.  A
 * speck narrower than a pixel is drawn as one pixel or not at all, by its own `chance`.
 * Far spray therefore thins out without flicker. */
#include "base/base.h"
#include "features/spray/spray.h"
#include "frame/frame.h"

/* A projected speck. */
typedef struct {
    int32_t  u, v;              /* centre, 28.4 px */
    uint16_t wide;              /* diameter, 28.4 px, at least 16 */
    uint16_t through;           /* 1: a bubble seen through water */
    uint32_t zi;
} disc;

typedef struct {
    uint32_t colour;            /* colour of all specks; first: the stage reads
                                 * tp_run.mine as a pointer to the colour */
    uint32_t count, room;
    disc    *disc;              /* visible specks */
} discs;

#define WIDE_MOST (48 * 16)

/* Returns the speck's place at the drawn moment.  A point under flat water appears at 3/4
 * of its depth [F4]. */
static tp_vec3 interpolate_speck(const tp_speck *s, tp_fx lag, bool through_water)
{
    tp_vec3 at = tp_position_interpolate(s->last, s->place, lag);

    if (through_water && at.y < 0)
        at.y -= at.y / 4;
    return at;
}

/* Returns the diameter, 28.4 px: spray.size times 0.5 to 1.5.  Returns 0 for a speck
 * below one pixel with too high a `chance`.  The place is in front of the near plane, so
 * depth >= near. */
static uint32_t speck_width(const tp_frame *frame, const tp_speck *s, tp_fx depth)
{
    TP_ASSERT(depth >= frame->projection.near);
    int32_t own = 128 + (uint8_t)(s->chance * 77);  /* random factor of the size, Q8 */
    int64_t size = (int64_t)frame->scene->spray.size * own >> 8;
    int64_t wide = (size * frame->projection.focal >> 12) / depth;

    if (wide < 16)
        return wide * 16 > s->chance ? 16 : 0;
    return wide < WIDE_MOST ? (uint32_t)wide : WIDE_MOST;
}

static bool project_speck(const tp_frame *frame, const tp_speck *s, bool through_water,
                          disc *to)
{
    tp_view_vertex view;

    tp_projection_view_vertex(&frame->projection,
                              interpolate_speck(s, frame->world->lag, through_water),
                              &view);
    if (!tp_projection_can_project(&frame->projection, &view))
        return false;
    tp_projection_project(&frame->projection, &view, &to->u, &to->v, &to->zi);
    to->wide = (uint16_t)speck_width(frame, s, view.depth);
    to->through = through_water;
    return to->wide > 0;
}

/* Returns the colour of specks: white in the light of a level surface, half way to full
 * white. */
static uint32_t spray_colour(const tp_shade *shade, uint32_t colour)
{
    int32_t lit = tp_lit_share(shade->ambient, shade->world.ly);
    return tp_colour_scale(colour, (uint32_t)(lit + (256 - lit) / 2));
}

static void project_specks(tp_frame *frame, void *mine, tp_view *view, tp_grid_box *box)
{
    discs *d = mine;
    const tp_spray *spray = tp_spray_of_world(frame->world);
    bool under = frame->under, clear = frame->scene->water.clarity > 0;

    (void)box;
    if (!view->picture)
        return;
    d->count = 0;
    d->colour = spray_colour(&frame->shade, (uint32_t)frame->scene->foam.colour);
    for (uint32_t i = 0; spray && i < spray->count && d->count < d->room; i++) {
        const tp_speck *s = &tp_spray_list(spray)[i];
        bool bubble = s->kind == TP_SPECK_BUBBLE;
        if (bubble && !under && !clear)
            continue;
        d->count += project_speck(frame, s, bubble && !under, &d->disc[d->count]);
    }
}

/* -- drawing ------------------------------------------------------------------------- */

static void write_speck_sample(const tp_gbuffer *tile, size_t at, const disc *s,
                               uint32_t mark)
{
    uint32_t depth = s->zi << 1 & ~(uint32_t)0xff, there = tile->key[at];

    if (depth <= (there | 0xff) && !(s->through && TP_MARK(there) == TP_MARK_WATER))
        return;
    tile->key[at] = depth | mark;
    tile->s[at] = tile->t[at] = tile->n[at] = 0;
}

/* Draws the pixels with their centres in the disc; the smallest disc covers the pixel
 * with its centre. */
static void draw_disc(const tp_gbuffer *tile, const disc *s, uint32_t mark)
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
                write_speck_sample(tile, (size_t)(y - tile->y0) * tile->stride
                          + (size_t)(x - tile->x0), s, mark);
        }
    }
}

static void draw_post_water(const tp_frame *frame, const void *mine, const tp_gbuffer *tile,
                            uint32_t mark)
{
    const discs *d = mine;

    (void)frame;
    for (uint32_t i = 0; i < d->count; i++) {
        const disc *s = &d->disc[i];
        int32_t r = s->wide / 2 + 16;
        if (s->u + r >= 16 * tile->x0 && s->u - r < 16 * tile->x1
            && s->v + r >= 16 * tile->y0 && s->v - r < 16 * tile->y1)
            draw_disc(tile, s, mark);
    }
}

static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    (void)frame;
    if (list->owner == &tp_spray_drawing)
        tp_shaders_add(list, TP_AT_COLOUR, stage[0], mine);
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    const uint32_t room = (uint32_t)conditions->scene->spray.count;
    discs *d = tp_arena_alloc(arena, 1, sizeof *d);
    disc  *all = tp_arena_alloc(arena, room, sizeof *all);

    if (d)
        *d = (discs){ .room = room, .disc = all };
    return d;
}

const tp_drawing tp_spray_drawing = {
    .layout = layout,
    .marks = tp_marks_one,
    .project = project_specks,
    .over = draw_post_water,
    .stages = add_stages,
};
