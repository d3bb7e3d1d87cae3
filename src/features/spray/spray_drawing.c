/* SPDX-License-Identifier: MIT */
/* Draws spray and bubbles: small soft streaks, blended over the shaded samples in front of
 * which they lie.
 *
 * A speck is a puff of droplets.  Its opacity is largest on its way in half a tick and
 * falls to 0 with the square of the distance from the way, at the speck's size.  A streak
 * is at most MOST long, its way included.  A streak narrower than two pixels is drawn two
 * pixels wide and fainter in proportion, so far spray neither flickers nor vanishes.
 * Specks nearer than 2 m fade out.
 *
 * The haze, or the water before an eye under water, is applied to a speck's colour once
 * a picture. */
#include "base/base.h"
#include "features/spray/spray.h"
#include "frame/frame.h"
#include "quality/prices.h"

#define MOST  96                /* length of the longest streak, 1/16 px */
#define BLUR  16                /* smallest radius, 1/16 px */
#define FADED TP_FX_ONE         /* m: specks up to this depth are invisible, ... */
#define CLEAR (2 * TP_FX_ONE)   /* m: ... specks from this depth on do not fade */

/* -- from specks to streaks ---------------------------------------------------------- */

/* Returns the speck's place at the drawn moment, and a quarter of a tick later in *end.  A
 * point under flat water appears at 3/4 of its depth [F4]. */
static tp_vec3 interpolate_speck(const tp_speck *s, tp_fx lag, bool through_water,
                                 tp_vec3 *end)
{
    tp_vec3 at = tp_position_interpolate(s->last, s->place, lag);

    if (through_water && at.y < 0)
        at.y -= at.y / 4;
    *end = (tp_vec3){ tp_fx_add_sat(at.x, (s->place.x - s->last.x) / 4),
                      tp_fx_add_sat(at.y, (s->place.y - s->last.y) / 4),
                      tp_fx_add_sat(at.z, (s->place.z - s->last.z) / 4) };
    return at;
}

/* Returns the speck's diameter, 1/256 px: spray.size times 0.5 to 1.5.  The place is in
 * front of the near plane, so depth >= near. */
static int64_t speck_diameter(const tp_frame *frame, const tp_speck *s, tp_fx depth)
{
    TP_ASSERT(depth >= frame->projection.near);
    int32_t own = 128 + (uint8_t)(s->chance * 77);  /* random factor of the size, Q8 */
    int64_t size = (int64_t)frame->scene->spray.size * own >> 8;
    int64_t wide = (size * frame->projection.focal >> 8) / depth;

    return wide < (int64_t)1 << 24 ? wide : (int64_t)1 << 24;
}

/* Returns the opacity of a whole speck by its depth, 0..255. */
static uint32_t depth_opacity(tp_fx depth)
{
    return (uint32_t)((tp_clamp(depth, FADED, CLEAR) - FADED) * (int64_t)255
                      / (CLEAR - FADED));
}

/* Sets the streak's shape from the diameter, 1/256 px, and from half of its way, 1/16 px.
 * Returns the opacity for a speck of the opacity `full`: a speck covers the same area in
 * the mean, however long its way. */
static uint32_t shape_streak(tp_streak *s, int64_t wide, int64_t du, int64_t dv,
                             uint32_t full)
{
    const int64_t half = (int64_t)tp_isqrt64((uint64_t)(du * du + dv * dv));
    const int64_t whole = wide / 8 + 2 * half + 1;
    const int64_t most = whole > MOST ? MOST : whole;
    int64_t radius = wide * most / whole;               /* 1/256 px */
    const int64_t way = half * most / whole;
    int64_t opacity = full * wide / (8 * whole);

    s->du = (int8_t)(du * most / whole);
    s->dv = (int8_t)(dv * most / whole);
    if (radius < BLUR * 16) {
        opacity = opacity * radius / (BLUR * 16) * (radius / 16 + way) / (BLUR + way);
        radius = BLUR * 16;
    }
    s->radius = (uint8_t)(radius / 16);
    return (uint32_t)(opacity < 255 ? opacity : 255);
}

/* Returns the longest way that shape_streak takes: its square fits 64 bits. */
static int64_t clamp_way(int64_t d)
{
    return tp_clamp_abs(d, (int64_t)1 << 24);
}

static bool is_in_picture(const tp_frame *frame, const tp_streak *s)
{
    const int32_t w = 16 * (int32_t)frame->config.width,
                  h = 16 * (int32_t)frame->config.height;

    return s->u > -MOST && s->u < w + MOST && s->v > -MOST && s->v < h + MOST;
}

/* Projects a speck.  Returns the opacity of its streak, 0 if there is none. */
static uint32_t project_speck(const tp_frame *frame, const tp_speck *speck,
                              bool through_water, tp_streak *to)
{
    const tp_projection *projection = &frame->projection;
    tp_view_vertex view, later;
    tp_vec3 end;
    int32_t u, v;
    uint32_t zi;

    tp_projection_view_vertex(projection,
                              interpolate_speck(speck, frame->world->lag, through_water,
                                                &end), &view);
    if (!tp_projection_can_project(projection, &view) || view.depth <= FADED)
        return 0;
    tp_projection_project(projection, &view, &to->u, &to->v, &zi);
    if (!is_in_picture(frame, to))
        return 0;
    to->key = (zi << 1 & ~(uint32_t)0xff) | through_water;
    u = to->u;
    v = to->v;
    tp_projection_view_vertex(projection, end, &later);
    if (tp_projection_can_project(projection, &later))
        tp_projection_project(projection, &later, &u, &v, &zi);
    return shape_streak(to, speck_diameter(frame, speck, view.depth),
                        clamp_way((int64_t)u - to->u), clamp_way((int64_t)v - to->v),
                        depth_opacity(view.depth));
}

/* -- colours ------------------------------------------------------------------------- */

/* Returns the colour of a speck in the pixel (x, y).  Specks scatter light forward: the
 * colour is the light of a level surface, and nearer to full light towards the light. */
static uint32_t lit_colour(const tp_frame *frame, int32_t x, int32_t y)
{
    const tp_shade *shade = &frame->shade;
    const int32_t lit = tp_lit_share(shade->ambient, shade->world.ly);
    const int32_t towards =
        16384 - tp_vector_to_eye(shade, &shade->world, x, y).l;         /* 0..2, Q14 */
    const uint32_t glow = (uint32_t)(tp_clamp(towards, 0, 32768) >> 7); /* 0..256 */
    const uint32_t share = (uint32_t)lit + ((uint32_t)(256 - lit) * glow * glow >> 16);

    return tp_colour_scale((uint32_t)frame->scene->foam.colour, share);
}

/* Returns the shader list of the module's own samples: the stages for a speck's colour. */
static const tp_shaders *own_list(const tp_frame *frame)
{
    const tp_marks *marks = &frame->buffers.marks;

    for (uint32_t i = 0; i < marks->lists; i++)
        if (marks->list[i].owner == &tp_spray_drawing)
            return &marks->list[i];
    return NULL;
}

/* Returns the speck's colour behind the air or water before it: the list's stages up to
 * the tone, applied to a run of one sample. */
static uint32_t shade_speck(const tp_frame *frame, const tp_shaders *list, uint32_t key,
                            int32_t x, int32_t y)
{
    const uint32_t mark = list->first, sample = (key & ~(uint32_t)0xff) | mark, zero = 0;
    tp_run run = { .x = x, .y = y, .count = 1, .key = &sample, .s = &zero, .t = &zero,
                   .n = &zero, .ls = &zero, .lt = &zero };

    for (uint32_t i = 0; i < list->count && list->order[i] < TP_AT_TONE; i++) {
        run.mine = list->shader[i].mine;
        list->shader[i].stage(&frame->shade, &run);
    }
    return run.colour[0] & 0xffffff;
}

/* Adds a streak to its band. */
static void add_streak(tp_frame *frame, tp_streaks *d, const tp_shaders *list,
                       uint32_t opacity)
{
    tp_streak *s = &d->streak[d->count++];
    const int32_t x = tp_clamp(s->u >> 4, 0, (int32_t)frame->config.width - 1);
    const int32_t y = tp_clamp(s->v >> 4, 0, (int32_t)frame->config.height - 1);
    uint16_t *band = &d->first[y / TP_STREAK_BAND];

    d->colour = lit_colour(frame, x, y);
    s->colour = opacity << 24 | shade_speck(frame, list, s->key, x, y);
    s->high = (uint8_t)(s->radius + tp_abs(s->dv));
    if (d->reach * 16 < s->high)
        d->reach = (s->high + 15u) / 16;
    TP_ASSERT(d->reach <= TP_STREAK_REACH);
    s->next = *band;
    *band = (uint16_t)d->count;
}

static void project_specks(tp_frame *frame, void *mine, tp_view *view, tp_grid_box *box)
{
    tp_streaks *d = mine;
    const tp_spray *spray = tp_spray_of_world(frame->world);
    const bool under = frame->under, clear = frame->scene->water.clarity > 0;
    const tp_shaders *list = own_list(frame);

    (void)box;
    if (!view->picture || !list)
        return;
    d->count = 0;
    d->reach = 0;
    memset(d->first, 0, d->bands * sizeof *d->first);
    for (uint32_t i = 0; spray && i < spray->count && d->count < d->room; i++) {
        const tp_speck *s = &tp_spray_list(spray)[i];
        const bool bubble = s->kind == TP_SPECK_BUBBLE;
        const uint32_t opacity =
            bubble && !under && !clear
                ? 0 : project_speck(frame, s, bubble && !under, &d->streak[d->count]);
        if (opacity > 0)
            add_streak(frame, d, list, opacity);
    }
}

/* ----------------------------------------------------------------------------------- */

/* Adds the colour of specks to their own list, the streaks to all others. */
static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    const bool own = list->owner == &tp_spray_drawing;

    (void)frame;
    tp_shaders_add(list, own ? TP_AT_COLOUR : TP_AT_TONE, stage[own ? 0 : 1], mine);
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    const uint32_t room = (uint32_t)conditions->scene->spray.count;
    const uint32_t bands = conditions->height / TP_STREAK_BAND + 1;
    tp_streaks *d = tp_arena_alloc(arena, 1, sizeof *d);
    tp_streak  *all = tp_arena_alloc(arena, room, sizeof *all);
    uint16_t   *first = tp_arena_alloc(arena, bands, sizeof *first);

    if (d)
        *d = (tp_streaks){ .room = room, .bands = bands, .streak = all, .first = first };
    return d;
}

const tp_drawing tp_spray_drawing = {
    .layout = layout,
    .marks = tp_marks_one,
    .project = project_specks,
    .stages = add_stages,
};

/* -- cost ---------------------------------------------------------------------------- */

/* Counts the specks: in a gale as many as there is room. */
static void count_work(tp_site *w)
{
    w->fixed_cost.of[TP_WORK_spray] = (uint32_t)w->scene->spray.count;
}

const tp_cost tp_spray_cost = { .work = count_work };
