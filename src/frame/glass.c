/* SPDX-License-Identifier: MIT */
/* A tank's walls of glass: the water behind them as triangles up to the water's own edge,
 * and the pane itself, blended over what was drawn in the pixels that it covers. */
#include "frame/frame.h"
#include "base/base.h"
#include "raster/edge.h"

/* -- the water's side ----------------------------------------------------------------- */

static tp_vec3 on_wall(const tp_rectangle *r, uint32_t face, tp_fx along, tp_fx y)
{
    return face & 2 ? (tp_vec3){ along, y, face & 1 ? r->z0 : r->z1 }
                    : (tp_vec3){ face & 1 ? r->x0 : r->x1, y, along };
}

static void place_post(tp_frame *frame, tp_glass *glass, const tp_rectangle *r,
                       tp_fx along)
{
    TP_ASSERT(glass->post != NULL);
    tp_side_post *post = &glass->post[glass->posts];
    tp_vec3 at = on_wall(r, glass->face, along, 0);

    post->along = along;
    post->high = tp_surface_relief(&frame->surface, at.x, at.z).height;
    glass->posts++;
}

/* At the grid's lines between both ends of the wall, so that the side ends where the
 * surface does. */
static void place_posts(tp_frame *frame, tp_glass *glass, const tp_rectangle *r)
{
    const tp_grid *grid = frame->parts.grid;
    const tp_grid_line *line = glass->face & 2 ? grid->column : grid->row;
    uint32_t lines = glass->face & 2 ? grid->cols : grid->rows;
    tp_fx from = glass->face & 2 ? r->x0 : r->z0, to = glass->face & 2 ? r->x1 : r->z1;

    glass->posts = 0;
    place_post(frame, glass, r, from);
    for (uint32_t i = 0; i < lines; i++)
        if (line[i].place > from && line[i].place < to)
            place_post(frame, glass, r, line[i].place);
    place_post(frame, glass, r, to);
}

static const int16_t no_normal[3] = { 0, 0, 0 };    /* its stage knows the wall's */

static void wall_corners(const tp_frame *frame, const tp_vec3 at[3], tp_view_corner to[3])
{
    for (int k = 0; k < 3; k++)
        to[k] = tp_clipped_corner(&frame->lens, at[k], no_normal);
}

static void draw_triangle(const tp_frame *frame, const tp_samples *tile, uint32_t face,
                          const tp_vec3 at[3])
{
    tp_view_corner in[3];

    wall_corners(frame, at, in);
    tp_clipped_draw(&frame->lens, NULL, tile, in, TP_MARK_SIDE, face);
}

static void draw_sides(const tp_frame *frame, tp_samples *tile)
{
    tp_rectangle r = tp_pool_sides(frame->scene);
    tp_fx floor = -frame->scene->tank.depth;

    tile->front_only = false;
    for (uint32_t g = 0; g < frame->glasses; g++) {
        const tp_glass *glass = &frame->parts.glass[g];
        for (uint32_t i = 0; i + 1 < glass->posts; i++) {
            const tp_side_post *a = &glass->post[i], *b = a + 1;
            tp_vec3 low = on_wall(&r, glass->face, a->along, floor);
            tp_vec3 top = on_wall(&r, glass->face, b->along, b->high);
            tp_vec3 left = on_wall(&r, glass->face, a->along, a->high);
            tp_vec3 right = on_wall(&r, glass->face, b->along, floor);
            const tp_vec3 one[3] = { low, right, top }, two[3] = { low, top, left };
            draw_triangle(frame, tile, glass->face, one);
            draw_triangle(frame, tile, glass->face, two);
        }
    }
}

/* -- the pane ------------------------------------------------------------------------- */

static void place_pane(tp_frame *frame, tp_pane *pane, const tp_vec3 at[3])
{
    tp_view_corner in[3];
    tp_corner corner[TP_CLIP_CORNERS];

    wall_corners(frame, at, in);
    pane->count = tp_clipped_corners(&frame->lens, NULL, in, corner);
    for (int k = 0; k < pane->count; k++) {
        pane->u[k] = corner[k].u;
        pane->v[k] = corner[k].v;
    }
}

/* A pane is in front of what is farther than it; its 1 / depth is a plane over the
 * picture, n . D / (n . (p - eye)) for the view's ray D at 1 m. */
static void place_depth(tp_frame *frame, tp_glass *glass, const tp_rectangle *r)
{
    const tp_inside *in = frame->shade.inside;
    const tp_dir3 back = frame->shade.world.back;
    tp_vec3 at = on_wall(r, glass->face, 0, 0), eye = frame->lens.eye;
    int     axis = glass->face & 2 ? 2 : 0;
    int64_t gap = axis ? (int64_t)at.z - eye.z : (int64_t)at.x - eye.x;

    if (gap == 0)
        gap = 1;
    glass->gap = gap;
    glass->right = in->right[axis];
    glass->up = in->up[axis];
    glass->ahead = -(int64_t)(axis ? back.z : back.x) * 4096;
}

static void place_glass(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    tp_rectangle r = tp_pool_sides(scene);

    frame->glasses = 0;
    if (frame->under)
        return;
    for (uint32_t face = 0; face < 4; face++) {
        if (!tp_frame_is_glass(frame, face))
            continue;
        TP_ASSERT(frame->glasses < TP_GLASSES);
        tp_glass *glass = &frame->parts.glass[frame->glasses++];
        tp_fx from = face & 2 ? r.x0 : r.z0, to = face & 2 ? r.x1 : r.z1;
        const tp_vec3 at[4] = { on_wall(&r, face, from, -scene->tank.depth),
                                on_wall(&r, face, to, -scene->tank.depth),
                                on_wall(&r, face, to, scene->tank.rim),
                                on_wall(&r, face, from, scene->tank.rim) };
        const tp_vec3 other[3] = { at[0], at[2], at[3] };
        glass->face = face;
        place_posts(frame, glass, &r);
        place_pane(frame, &glass->pane[0], at);
        place_pane(frame, &glass->pane[1], other);
        place_depth(frame, glass, &r);
    }
}

/* Where a convex polygon covers row y, by the fill rule of triangles. */
static tp_covered covered(const tp_pane *pane, int32_t y)
{
    tp_covered c = { INT32_MAX, INT32_MIN };

    for (int k = 0; k < pane->count; k++) {
        int n = k + 1 < pane->count ? k + 1 : 0;
        int a = pane->v[k] < pane->v[n] ? k : n, b = a == k ? n : k;
        if (tp_first_centre(pane->v[a]) > y || tp_first_centre(pane->v[b]) <= y)
            continue;
        tp_edge edge = tp_edge_of(pane->u[a], pane->v[a], pane->u[b], pane->v[b]);
        tp_edge_go(&edge, y);
        c.x0 = edge.pixel < c.x0 ? edge.pixel : c.x0;
        c.x1 = edge.pixel > c.x1 ? edge.pixel : c.x1;
    }
    return c;
}

/* Whether what a sample holds lies behind the glass: depth > gap / (n . D), so that
 * zi < zi_near (n . D) / gap; cross-multiplied, in Q42 and 16.16 over Q31. */
static bool is_behind(const tp_frame *frame, const tp_glass *glass, uint32_t key,
                      int64_t view)
{
    int64_t near = (int64_t)frame->lens.zi_near * (view >> 22);        /* Q36 */
    int64_t here = (int64_t)(TP_ZI(key) >> 4) * (glass->gap >> 2);      /* Q27 Q14 */
    int64_t rise = near * (glass->gap > 0 ? 1 : -1);
    int64_t far = (here >> 5) * (glass->gap > 0 ? 1 : -1);
    return far <= rise + (rise >> 10);
}

static void glaze(const tp_frame *frame, const tp_glass *glass, tp_run *run,
                  tp_covered c)
{
    int32_t i = c.x0 > run->x ? c.x0 - run->x : 0;
    int32_t end = c.x1 - run->x < run->count ? c.x1 - run->x : run->count;
    int64_t v = frame->shade.v0 - 16 * run->y - 8;

    for (int32_t from = i; i < end; from = i) {
        int64_t u = 16 * (run->x + i) + 8 - frame->shade.u0;
        int64_t view = glass->right * u + glass->up * v + glass->ahead;
        bool seen = is_behind(frame, glass, run->key[i], view);
        for (; i < end && seen == is_behind(frame, glass, run->key[i], view); i++)
            view += glass->right * 16;
        if (seen)
            tp_shade_glaze(&frame->shade, run, from, i, glass->face);
    }
}

static void glass_row(const tp_frame *frame, int32_t y, tp_covered row[TP_PANES])
{
    for (uint32_t g = 0; g < frame->glasses; g++) {
        row[2 * g] = covered(&frame->parts.glass[g].pane[0], y);
        row[2 * g + 1] = covered(&frame->parts.glass[g].pane[1], y);
    }
}

static void glaze_run(const tp_frame *frame, const tp_covered row[TP_PANES], tp_run *run)
{
    for (uint32_t k = 0; k < 2 * frame->glasses; k++)
        if (row[k].x0 < row[k].x1)
            glaze(frame, &frame->parts.glass[k / 2], run, row[k]);
}

const struct tp_draw_glass tp_draw_glass = {
    place_glass, draw_sides, glass_row, glaze_run
};
