/* SPDX-License-Identifier: MIT */
/*
 * Draws drops and the releasing sphere as spheroids of triangles, in the tiles touched by
 * their boxes, and estimates their cost.  Small spheroids use every second meridian and
 * parallel.  A drop keeps its volume at any shape: with height over width a = 1 + squash,
 * height is proportional to a^(2/3) and width to a^(-1/3).
 */
#include "base/base.h"
#include "features/drops/drops.h"
#include "frame/frame.h"
#include "quality/prices.h"

#define ROUND 20                        /* meridians */
#define RINGS 11                        /* parallels */
#define BALL  (ROUND * RINGS + 2)

/* A point of the unit sphere, Q1.14. */
typedef struct {
    int16_t x, y, z;
} ball_point;

typedef struct {
    tp_solid     look;          /* material of the stage; first member */
    ball_point  *ball;
    tp_grid_box *box;           /* boxes of the drops, then of the sphere, in this view */
    tp_ring_now *ring;          /* rings at the drawn moment */
    uint32_t     room, ring_room;
    uint32_t     seen;          /* number of drops drawn, at most `room` */
} drawn_drops;

/* -- the unit sphere ----------------------------------------------------------------- */

/* Makes the unit sphere: north pole, parallels from north to south, south pole. */
static void make_ball(tp_frame *frame, void *mine)
{
    ball_point *to = ((drawn_drops *)mine)->ball;

    (void)frame;
    *to++ = (ball_point){ 0, 16384, 0 };
    for (uint32_t j = 1; j <= RINGS; j++) {
        tp_turn down = (tp_turn)(((uint64_t)j << 31) / (RINGS + 1));
        tp_q30  ring = tp_sin(down);
        for (uint32_t i = 0; i < ROUND; i++) {
            tp_turn round = (tp_turn)(((uint64_t)i << 32) / ROUND);
            *to++ = (ball_point){ (int16_t)(tp_q30_mul(ring, tp_sin(round)) >> 16),
                                  (int16_t)(tp_cos(down) >> 16),
                                  (int16_t)(tp_q30_mul(ring, tp_cos(round)) >> 16) };
        }
    }
    *to = (ball_point){ 0, -16384, 0 };
}

/* -- one spheroid -------------------------------------------------------------------- */

typedef struct {
    tp_vec3 centre;
    tp_fx   wide, high;         /* half axes, m */
} spheroid;

/* Returns the spheroid of a squashed drop.  The width a^(-1/3) is a series to the third
 * power, within 0.017 for |squash| <= 1/2.  The height follows from constant volume. */
static spheroid make_spheroid(tp_vec3 centre, tp_fx radius, int32_t squash_q14)
{
    tp_fx q = tp_clamp(squash_q14, -8192, 8192) * 4;
    tp_fx square = tp_fx_mul(q, q);
    tp_fx wide = TP_FX_ONE - q / 3 + square * 2 / 9 - tp_fx_mul(square, q) * 14 / 81;
    tp_fx high = tp_fx_div(TP_FX_ONE, tp_fx_mul(wide, wide));

    return (spheroid){ centre, tp_fx_mul(radius, wide), tp_fx_mul(radius, high) };
}

/* Returns spheroid i at the drawn moment: drop i, or the sphere for i = seen. */
static spheroid interpolate_spheroid(const tp_drops *drops, tp_fx lag, uint32_t i,
                                     uint32_t sphere_index)
{
    TP_ASSERT(i <= sphere_index && sphere_index <= drops->count);
    bool  sphere = i == sphere_index;
    const tp_drop *drop = tp_drops_list(drops) + (sphere ? 0 : i);
    tp_vec3 a = sphere ? drops->last_sphere : drop->last;
    tp_vec3 b = sphere ? drops->sphere : drop->place;
    tp_vec3 at = tp_position_interpolate(a, b, lag);

    return sphere ? (spheroid){ at, drops->sphere_radius, drops->sphere_radius }
                  : make_spheroid(at, drop->radius, drop->squash);
}

static tp_view_vertex transform_point(const tp_view *view, const spheroid *s,
                                      const ball_point *p)
{
    tp_vec3 at = { s->centre.x + (tp_fx)((int64_t)p->x * s->wide >> 14),
                   s->centre.y + (tp_fx)((int64_t)p->y * s->high >> 14),
                   s->centre.z + (tp_fx)((int64_t)p->z * s->wide >> 14) };
    tp_view_vertex c;

    tp_projection_view_vertex(view->projection, at, &c);
    c.s = c.t = 0;
    c.n[0] = (int16_t)((int64_t)p->x * s->high / (s->wide + s->high + 1) >> 5);
    c.n[1] = (int16_t)((int64_t)p->y * s->wide / (s->wide + s->high + 1) >> 5);
    c.n[2] = (int16_t)((int64_t)p->z * s->high / (s->wide + s->high + 1) >> 5);
    return c;
}

/* Transforms every `step`th point of parallel j.  A pole counts as a parallel whose
 * points are all equal. */
static void transform_parallel(const drawn_drops *d, const tp_view *view, const spheroid *s,
                               uint32_t j, uint32_t step, tp_view_vertex to[ROUND])
{
    TP_ASSERT(j <= RINGS + 1 && step > 0);
    const bool north = j == 0, south = j > RINGS;
    const ball_point *ring = &d->ball[south ? BALL - 1 : north ? 0 : 1 + (j - 1) * ROUND];

    for (uint32_t i = 0; i < ROUND; i += step)
        to[i] = (north || south) && i > 0 ? to[0] : transform_point(view, s, &ring[i]);
}

/* -- placing ------------------------------------------------------------------------- */

static const tp_grid_box nowhere = { 1, 1, 0, 0 };

/* Returns the pixel box of a spheroid's vertices; all pixels if a vertex must be clipped.
 * A spheroid cut by the clip level counts in full. */
static tp_grid_box spheroid_box(const drawn_drops *d, const tp_view *view,
                                const spheroid *s, uint32_t step)
{
    tp_grid_box box = TP_BOX_NONE;
    tp_view_vertex ring[ROUND];
    bool ahead = false, cut = false;

    for (uint32_t j = 0; j <= RINGS + 1; j += step) {
        transform_parallel(d, view, s, j, step, ring);
        for (uint32_t i = 0; i < ROUND; i += step) {
            tp_screen_vertex p;
            ahead |= ring[i].depth >= view->projection->near
                     && (!view->clipped
                         || tp_view_plane_distance(&view->level, &ring[i]) >= 0);
            cut |= !tp_projection_can_project(view->projection, &ring[i]);
            if (cut)
                continue;
            tp_projection_project(view->projection, &ring[i], &p.u, &p.v, &p.zi);
            tp_box_widen(&box, p.u, p.v);
        }
    }
    if (!ahead)
        return nowhere;
    return cut ? (tp_grid_box){ INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX } : box;
}

/* Returns the step between meridians and parallels.  Up to 16 px across step 2 is enough:
 * the outline is off by 8 % of the radius. */
static uint32_t choose_detail_step(const tp_grid_box *box)
{
    return box->x1 - box->x0 > 16 || box->y1 - box->y0 > 16 ? 1 : 2;
}

static void widen_box(tp_grid_box *all, const tp_grid_box *box)
{
    tp_box_widen(all, 16 * box->x0, 16 * box->y0);
    tp_box_widen(all, 16 * box->x1, 16 * box->y1);
}

static void project(tp_frame *frame, void *mine, tp_view *view, tp_grid_box *box)
{
    const tp_drops *drops = tp_world_drops(frame->world);
    drawn_drops *d = mine;

    if (!drops)
        return;
    d->seen = drops->count < d->room ? drops->count : d->room;
    frame->stats.dropped += drops->count - d->seen;
    for (uint32_t i = 0; i <= d->seen; i++) {
        spheroid s = interpolate_spheroid(drops, frame->world->lag, i, d->seen);
        d->box[i] = spheroid_box(d, view, &s, 2);
        uint32_t step = choose_detail_step(&d->box[i]);
        if (step == 1)
            d->box[i] = spheroid_box(d, view, &s, 1);
        if (d->box[i].x0 <= d->box[i].x1) {
            uint32_t points = ROUND / step * (RINGS / step);
            widen_box(box, &d->box[i]);
            frame->stats.vertices += points + 2;
            frame->stats.triangles += 2 * points;
        }
    }
}

/* -- drawing ------------------------------------------------------------------------- */

static void draw_face(const tp_view *view, const tp_gbuffer *tile,
                      const tp_view_vertex *a, const tp_view_vertex *b,
                      const tp_view_vertex *c, uint32_t mark)
{
    const tp_view_vertex in[3] = { *a, *b, *c };

    tp_clipped_draw(view->projection, tp_view_clip_plane(view), tile, in, mark, 0);
}

static void draw_spheroid(const drawn_drops *d, const tp_view *view, const tp_gbuffer *tile,
                          const spheroid *s, uint32_t step, uint32_t mark)
{
    tp_view_vertex ring[2][ROUND];

    transform_parallel(d, view, s, 0, step, ring[0]);
    for (uint32_t j = 0; j <= RINGS; j += step) {
        const tp_view_vertex *above = ring[j / step & 1];
        tp_view_vertex *below = ring[(j / step + 1) & 1];
        transform_parallel(d, view, s, j + step, step, below);
        for (uint32_t i = 0; i < ROUND; i += step) {
            uint32_t next = (i + step) % ROUND;
            if (j + step <= RINGS)
                draw_face(view, tile, &above[i], &below[i], &below[next], mark);
            if (j > 0)
                draw_face(view, tile, &above[i], &below[next], &above[next], mark);
        }
    }
}

static void draw(const tp_frame *frame, const void *mine, const tp_view *view,
                 tp_gbuffer *samples, uint32_t mark)
{
    const tp_drops *drops = tp_world_drops(frame->world);
    const drawn_drops *d = mine;

    samples->front_only = true;
    for (uint32_t i = 0; drops && i <= d->seen; i++) {
        if (!tp_box_overlaps_tile(&d->box[i], samples))
            continue;
        spheroid s = interpolate_spheroid(drops, frame->world->lag, i, d->seen);
        draw_spheroid(d, view, samples, &s, choose_detail_step(&d->box[i]), mark);
    }
}

/* -- the module ---------------------------------------------------------------------- */

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    drawn_drops *d = tp_arena_alloc(arena, 1, sizeof *d), made = {
        .room = (uint32_t)conditions->scene->drops.count,
        .ring_room = (uint32_t)conditions->scene->drops.rings,
    };

    made.box = tp_arena_alloc(arena, made.room + 1, sizeof *made.box);
    made.ring = tp_arena_alloc(arena, made.ring_room, sizeof *made.ring);
    made.ball = tp_arena_alloc(arena, BALL, sizeof *made.ball);
    if (d)
        *d = made;
    return d;
}

/* Adds the rings at the drawn moment to the surface.  Between two ticks a ring has an age
 * in between. */
static void add_surface(tp_frame *frame, void *mine, tp_surface *surface)
{
    const tp_drops *drops = tp_world_drops(frame->world);
    drawn_drops *d = mine;

    surface->ring = d->ring;
    surface->rings = drops ? tp_drops_rings_evaluate(
                         drops, frame->program, frame->drawn.time, d->ring, d->ring_room)
                           : 0;
}

/* Sets the material of drops and sphere: the scene's colour, with white highlights. */
static void begin_drop_material(tp_frame *frame, void *mine)
{
    drawn_drops *d = mine;

    tp_frame_use_fresnel(frame);
    d->look = (tp_solid){ .diffuse = (uint32_t)frame->scene->drops.colour,
                          .specular = 0xffffff, .gloss = tp_drop_gloss };
}

static bool set_anchor(const tp_frame *frame, const void *mine, tp_view_anchor *anchor)
{
    const tp_drops *drops = tp_world_drops(frame->world);

    (void)mine;
    if (drops)
        *anchor = (tp_view_anchor){ .middle = drops->sphere };
    return drops != NULL;
}

static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    (void)frame;
    if (list->owner == &tp_drops_drawing)
        tp_shaders_add(list, TP_AT_COLOUR, stage[0], mine);
}

const tp_drawing tp_drops_drawing = {
    .layout = layout, .init = make_ball, .marks = tp_marks_one, .surface = add_surface,
    .begin = begin_drop_material, .anchor = set_anchor, .project = project, .draw = draw,
    .stages = add_stages,
};

/* -- cost ---------------------------------------------------------------------------- */

/* Fixed cost of a frame with drops, for the quality plan: rings at the water's grid
 * vertices, and the spheres' faces. */

#define BALL_FACES 440          /* faces of a large sphere; a small one has a quarter */

/* Counts the grid vertices with rings, and the faces of one sphere at the place of release,
 * in the main view and in the reflection. */
static void count_work(tp_site *w)
{
    const tp_view_estimate *o = w->estimate;
    const tp_scene *s = w->scene;
    const tp_vec3 sphere = { s->drops.x, s->drops.y, s->drops.z };
    const tp_vec3 way = tp_start_view_clamped_vector(w->at.eye, sphere);
    const tp_vec3 view = tp_rotate(&w->at.turn, way);
    uint32_t *work = w->fixed_cost.of;

    work[TP_WORK_rings] = s->drops.interval > 0 ? o->vertices : 0;
    if (-view.z <= 0)
        return;
    const int64_t rows = (int64_t)o->focal * 4 * s->drops.radius / -view.z;
    const uint32_t faces = rows > 16 ? BALL_FACES : BALL_FACES / 4;
    work[TP_WORK_ball] = faces * tp_work_bands(rows, TP_WORK_BAND);
    if (w->mirrors) {
        work[TP_WORK_ball] += faces * tp_work_bands(rows / 2, TP_WORK_STRIP);
        w->far = -view.z > w->far ? -view.z : w->far;
    }
}

const tp_cost tp_drops_cost = { .work = count_work };
