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

enum { COLOUR = TP_NTH_spray, BLEND = TP_NTH_spray_blend, DASHES = TP_NTH_spray_dashes,
       FAST = TP_NTH_spray_fast };

#define MOST  TP_STREAK_MOST
#define BLUR  TP_STREAK_BLUR
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

/* Returns the speck's radius, 1/256 px: spray.size times 0.5 to 1.5.  The place is in
 * front of the near plane, so depth >= near. */
static int32_t speck_radius(const tp_frame *frame, const tp_speck *s, tp_fx depth)
{
    TP_ASSERT(depth >= frame->projection.near);
    int32_t own = 128 + (uint8_t)(s->chance * 77);  /* random factor of the size, Q8 */
    int64_t size = (int64_t)frame->scene->spray.size * own >> 8;
    int64_t wide = (size * frame->projection.focal >> 8) / depth;

    return (int32_t)(wide < (int64_t)1 << 24 ? wide : (int64_t)1 << 24);
}

/* Returns the opacity of a whole speck by its depth, 0..255. */
static uint32_t depth_opacity(tp_fx depth)
{
    return (uint32_t)((tp_clamp(depth, FADED, CLEAR) - FADED) * (int64_t)255
                      / (CLEAR - FADED));
}

/* Sets the streak's shape.  Returns its opacity: a speck covers the same area in the mean,
 * however long its way. */
static uint32_t shape_streak(const tp_speck_place *place, tp_streak *s)
{
    const int64_t wide = place->radius, du = place->du, dv = place->dv;
    const int64_t half = (int64_t)tp_isqrt64((uint64_t)(du * du + dv * dv));
    const int64_t whole = wide / 8 + 2 * half + 1;
    const int64_t most = whole > MOST ? MOST : whole;
    int64_t radius = wide * most / whole;               /* 1/256 px */
    const int64_t way = half * most / whole;
    int64_t opacity = place->opacity * wide / (8 * whole);

    s->du = (int8_t)(du * most / whole);
    s->dv = (int8_t)(dv * most / whole);
    if (radius < BLUR * 16) {
        opacity = opacity * radius / (BLUR * 16) * (radius / 16 + way) / (BLUR + way);
        radius = BLUR * 16;
    }
    s->radius = (uint8_t)(radius / 16);
    return (uint32_t)(opacity < 255 ? opacity : 255);
}

static int32_t clamp_way(int64_t d)
{
    return (int32_t)tp_clamp_abs(d, (int64_t)1 << 24);
}

static bool is_in_picture(const tp_frame *frame, const tp_speck_place *s)
{
    const int32_t w = 16 * (int32_t)frame->config.width,
                  h = 16 * (int32_t)frame->config.height;

    return s->u > -MOST && s->u < w + MOST && s->v > -MOST && s->v < h + MOST;
}

/* A position in the picture, and its depth in m. */
typedef struct {
    int32_t  u, v;
    uint32_t zi;
    tp_fx    depth;
} screen_place;

/* Returns false, without a place, if the position cannot be projected. */
TP_NEVER_INLINE bool project_position(const tp_projection *projection, tp_vec3 position,
                                      screen_place *to)
{
    tp_view_vertex view;

    tp_projection_view_vertex(projection, position, &view);
    if (!tp_projection_can_project(projection, &view))
        return false;
    tp_projection_project(projection, &view, &to->u, &to->v, &to->zi);
    to->depth = view.depth;
    return true;
}

/* Projects a speck.  Returns false if it is not in the picture. */
TP_NEVER_INLINE bool project_speck(const tp_frame *frame, const tp_speck *speck,
                                   bool through_water, tp_speck_place *to)
{
    screen_place now, later;
    tp_vec3 end;
    const tp_vec3 at = interpolate_speck(speck, frame->world->lag, through_water, &end);

    if (!project_position(&frame->projection, at, &now) || now.depth <= FADED)
        return false;
    to->u = now.u;
    to->v = now.v;
    if (!is_in_picture(frame, to))
        return false;
    if (!project_position(&frame->projection, end, &later))
        later = now;
    to->key = (now.zi << 1 & ~(uint32_t)0xff) | through_water;
    to->du = clamp_way((int64_t)later.u - now.u);
    to->dv = clamp_way((int64_t)later.v - now.v);
    to->radius = speck_radius(frame, speck, now.depth);
    to->opacity = depth_opacity(now.depth);
    return true;
}

/* -- colours ------------------------------------------------------------------------- */

/* Returns the colour of a speck in the pixel (x, y).  Specks scatter light forward: the
 * colour is the light of a level surface, and nearer to full light towards the light. */
static uint32_t lit_colour(const tp_shade *shade, uint32_t colour, int32_t x, int32_t y)
{
    const int32_t lit = tp_lit_share(shade->ambient, shade->world.ly);
    const int32_t towards =
        16384 - tp_vector_to_eye(shade, &shade->world, x, y).l;         /* 0..2, Q14 */
    const uint32_t glow = (uint32_t)(tp_clamp(towards, 0, 32768) >> 7); /* 0..256 */
    const uint32_t share = (uint32_t)lit + ((uint32_t)(256 - lit) * glow * glow >> 16);

    return tp_colour_scale(colour, share);
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

/* Applies the list's stages up to the tone to a run of one sample. */
uint32_t tp_spray_shade(const tp_shade *shade, tp_streaks *d, uint32_t key, int32_t x,
                        int32_t y, tp_run *run)
{
    const tp_shaders *list = d->list;
    const uint32_t mark = list->first, sample = (key & ~(uint32_t)0xff) | mark, zero = 0;

    run->x = x;
    run->y = y;
    run->count = 1;
    run->key = &sample;
    run->s = run->t = run->n = &zero;
    d->colour = lit_colour(shade, d->foam_colour, x, y);
    for (uint32_t i = 0; i < list->count && list->order[i] < TP_AT_TONE; i++) {
        run->mine = list->shader[i].mine;
        list->shader[i].stage(shade, run);
    }
    return run->colour[0] & 0xffffff;
}

/* Shapes a speck's streak and adds it to its band. */
static void add_streak(const tp_frame *frame, tp_streaks *d, const tp_speck_place *place,
                       tp_run *run)
{
    tp_streak *s = &d->streak[d->count];
    const uint32_t opacity = shape_streak(place, s);
    const int32_t x = tp_clamp(place->u >> 4, 0, (int32_t)frame->config.width - 1);
    const int32_t y = tp_clamp(place->v >> 4, 0, (int32_t)frame->config.height - 1);
    uint16_t *band = &d->first[y / TP_STREAK_BAND];

    if (opacity == 0)
        return;
    s->u = place->u;
    s->v = place->v;
    s->key = place->key;
    s->colour = opacity << 24 | tp_spray_shade(&frame->shade, d, s->key, x, y, run);
    s->high = (uint8_t)(s->radius + tp_abs(s->dv));
    if (d->reach * 16 < s->high)
        d->reach = (s->high + 15u) / 16;
    TP_ASSERT(d->reach <= TP_STREAK_REACH);
    s->next = *band;
    *band = (uint16_t)++d->count;
}

/* -- the specks of a picture --------------------------------------------------------- */

/* Adds a speck's streak, or its dashes by the stage for them. */
static void add_speck(const tp_frame *frame, tp_streaks *d, tp_stage dashes,
                      const tp_speck_place *place)
{
    const tp_dash_task task = { d, place };
    tp_run run;

    run.mine = &task;
    if (!d->dashes)
        add_streak(frame, d, place, &run);
    else if (dashes)
        dashes(&frame->shade, &run);
}

/* Empties the lists of bands or rows, and the colours of dashes. */
static void clear_streaks(const tp_frame *frame, tp_streaks *d)
{
    d->list = own_list(frame);
    d->foam_colour = (uint32_t)frame->scene->foam.colour;
    d->count = 0;
    d->reach = 0;
    memset(d->first, 0, d->bands * sizeof *d->first);
    if (d->dashes) {
        d->dashes->count = 0;
        memset(d->dashes->colour, 0, sizeof d->dashes->colour);
    }
}

static void project_specks(tp_frame *frame, void *mine, tp_view *view, tp_grid_box *box)
{
    tp_streaks *d = mine;
    const tp_spray *spray = tp_spray_of_world(frame->world);
    const bool under = frame->under, clear = frame->scene->water.clarity > 0;
    const tp_stage dashes = tp_frame_module_stages(frame, TP_SPRAY_ID)[DASHES];
    tp_speck_place place;

    (void)box;
    if (!view->picture)
        return;
    clear_streaks(frame, d);
    if (!d->list)
        return;
    for (uint32_t i = 0; spray && i < spray->count && d->count < d->room; i++) {
        const tp_speck *s = &tp_spray_list(spray)[i];
        const bool bubble = s->kind == TP_SPECK_BUBBLE;
        if (bubble && !under && !clear)
            continue;
        if (project_speck(frame, s, bubble && !under, &place))
            add_speck(frame, d, dashes, &place);
    }
}

/* -- the module ---------------------------------------------------------------------- */

/* Adds the colour of specks to their own list, the streaks to all others. */
static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    const tp_streaks *d = mine;

    (void)frame;
    if (list->owner == &tp_spray_drawing)
        tp_shaders_add(list, TP_AT_COLOUR, stage[COLOUR], mine);
    else
        tp_shaders_add(list, TP_AT_TONE, stage[d->dashes ? FAST : BLEND], mine);
}

/* Allocates the dashes: two for each speck, and a list for each row of the picture. */
static tp_dashes *layout_dashes(tp_arena *arena, const tp_module_conditions *conditions)
{
    const uint32_t room = 2 * (uint32_t)conditions->scene->spray.count;
    tp_dashes *dashes = tp_arena_alloc(arena, 1, sizeof *dashes);
    tp_dash   *all = tp_arena_alloc(arena, room, sizeof *all);

    if (dashes)
        *dashes = (tp_dashes){ .room = room, .width = (int32_t)conditions->width,
                               .height = (int32_t)conditions->height, .dash = all };
    return dashes;
}

/* The rung is fixed here: each has its own memory. */
static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    const bool fast = conditions->scene->quality.spray == TP_RUNG_FAST;
    const uint32_t room = (uint32_t)conditions->scene->spray.count;
    const uint32_t bands = fast ? conditions->height
                                : conditions->height / TP_STREAK_BAND + 1;
    tp_streaks *d = tp_arena_alloc(arena, 1, sizeof *d);
    tp_dashes  *dashes = fast ? layout_dashes(arena, conditions) : NULL;
    tp_streak  *all = fast ? NULL : tp_arena_alloc(arena, room, sizeof *all);
    uint16_t   *first = tp_arena_alloc(arena, bands, sizeof *first);

    if (d)
        *d = (tp_streaks){ .room = room, .bands = bands, .streak = all, .first = first,
                           .dashes = dashes };
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
