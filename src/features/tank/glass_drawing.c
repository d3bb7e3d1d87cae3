/* SPDX-License-Identifier: MIT */
/* Draws a tank's walls of glass: the water's side behind the glass, as triangles up to
 * the surface's edge, and the outlines of the panes in the picture. */
#include "features/tank/tank.h"
#include "frame/frame.h"
#include "view/fan.h"

/* -- the water's side ---------------------------------------------------------------- */

static tp_vec3 point_on_wall(const tp_rectangle *r, uint32_t face, tp_fx along, tp_fx y)
{
    return face & 2 ? (tp_vec3){ along, y, face & 1 ? r->z0 : r->z1 }
                    : (tp_vec3){ face & 1 ? r->x0 : r->x1, y, along };
}

static void append_side_post(const tp_frame *frame, tp_glass_wall *wall,
                             const tp_rectangle *r, tp_fx along)
{
    TP_ASSERT(wall->post != NULL);
    tp_tank_side_post *post = &wall->post[wall->posts];
    tp_vec3 at = point_on_wall(r, wall->face, along, 0);

    post->along = along;
    post->high = tp_rings_pools_sample(&frame->surface, at.x, at.z).height;
    wall->posts++;
}

/* True if the columns of the grid meet a wall along x (`across`) or along z. */
static bool columns_meet_wall(const tp_grid *grid, bool across)
{
    return (grid->fan->law.right.x != 0) == across;
}

/* Returns the grid vertices along a wall; 0: no grid, or one that does not end there. */
static uint32_t count_edge_vertices(const tp_grid *grid, bool across)
{
    if (!grid || !grid->fan->law.walls)
        return 0;
    return columns_meet_wall(grid, across) ? grid->cols : grid->rows;
}

/* Returns the place along the wall of a vertex on the water's edge. */
static tp_fx edge_vertex_place(const tp_grid *grid, bool across, uint32_t n)
{
    const bool column = columns_meet_wall(grid, across);
    const uint32_t i = column ? n : 0, j = column ? 0 : n;

    return across ? tp_grid_s(grid, i, j) : tp_grid_t(grid, i, j);
}

/* Places the posts at the grid's vertices between both ends of the wall, so the side's top
 * edge matches the surface.  Without vertices there only the ends have posts. */
static void place_posts(const tp_frame *frame, tp_glass_wall *wall, const tp_rectangle *r)
{
    const tp_grid *grid = frame->buffers.grid;
    const bool across = wall->face & 2;
    const uint32_t count = count_edge_vertices(grid, across);
    tp_fx from = across ? r->x0 : r->z0, to = across ? r->x1 : r->z1;
    const bool back = count > 0 && edge_vertex_place(grid, across, 0) > from;

    wall->posts = 0;
    append_side_post(frame, wall, r, from);
    for (uint32_t i = 0; i < count; i++) {
        const tp_fx at = edge_vertex_place(grid, across, back ? count - 1 - i : i);
        if (at > from && at < to)
            append_side_post(frame, wall, r, at);
    }
    append_side_post(frame, wall, r, to);
}

static const int16_t no_normal[3] = { 0, 0, 0 };    /* the stage knows the wall's normal */
static void transform_corners(const tp_frame *frame, const tp_vec3 corner[3],
                              tp_view_vertex to[3])
{
    for (int k = 0; k < 3; k++)
        to[k] = tp_solid_vertex_make(&frame->projection, corner[k], no_normal);
}

/* The two triangles of the side from a post to the next one. */
typedef struct {
    tp_view_vertex of[2][3];
} side_part;

static side_part make_side_part(const tp_frame *frame, const tp_rectangle *r, uint32_t face,
                                const tp_tank_side_post *post)
{
    const tp_projection *by = &frame->projection;
    const tp_fx floor = -frame->scene->tank.depth;
    const tp_view_vertex low = tp_solid_vertex_make(
        by, point_on_wall(r, face, post[0].along, floor), no_normal);
    const tp_view_vertex right = tp_solid_vertex_make(
        by, point_on_wall(r, face, post[1].along, floor), no_normal);
    const tp_view_vertex top = tp_solid_vertex_make(
        by, point_on_wall(r, face, post[1].along, post[1].high), no_normal);
    const tp_view_vertex left = tp_solid_vertex_make(
        by, point_on_wall(r, face, post[0].along, post[0].high), no_normal);

    return (side_part){ { { low, right, top }, { low, top, left } } };
}

/* Sets the rows of the side from a post to the next one. */
static void set_post_rows(const tp_frame *frame, const tp_rectangle *r, uint32_t face,
                          tp_tank_side_post *post)
{
    const side_part part = make_side_part(frame, r, face, post);
    tp_grid_box box = TP_BOX_NONE;

    for (int half = 0; half < 2; half++) {
        tp_screen_vertex at[TP_CLIP_VERTICES];
        const int count = tp_clipped_corners(&frame->projection, NULL, part.of[half], at);
        for (int k = 0; k < count; k++)
            tp_box_widen(&box, at[k].u, at[k].v);
    }
    post->y0 = box.y0;
    post->y1 = box.y1;
}

/* Places the posts of all walls; runs after the water's grid. */
static void place_side_posts(tp_frame *frame, void *mine, tp_view *view, tp_grid_box *box)
{
    const tp_rectangle r = tp_pool_sides(frame->scene);
    tp_glass *glass = mine;

    for (uint32_t k = 0; view->picture && k < glass->walls; k++) {
        tp_glass_wall *wall = &glass->wall[k];
        place_posts(frame, wall, &r);
        for (uint32_t i = 0; i + 1 < wall->posts; i++)
            set_post_rows(frame, &r, wall->face, &wall->post[i]);
        *box = TP_BOX_ALL;
    }
}

/* One side of the water, and its target. */
typedef struct {
    const tp_frame   *frame;
    const tp_gbuffer *tile;
    uint32_t          mark, face;
    tp_rectangle      sides;
} glass_side;

/* Draws the part of the side from a post to the next one. */
static void draw_water_face_to_next_post(const glass_side *s, const tp_tank_side_post *post)
{
    if (post->y0 >= s->tile->y1 || post->y1 < s->tile->y0)
        return;
    const side_part part = make_side_part(s->frame, &s->sides, s->face, post);
    for (int half = 0; half < 2; half++)
        tp_clipped_draw(&s->frame->projection, NULL, s->tile, part.of[half], s->mark,
                        s->face);
}

static void draw_water_sides(const tp_frame *frame, const void *mine, const tp_view *view,
                             tp_gbuffer *tile, uint32_t mark)
{
    const tp_glass *glass = mine;
    glass_side s = { .frame = frame, .tile = tile, .mark = mark };

    if (!view->picture || glass->walls == 0)
        return;
    s.sides = tp_pool_sides(frame->scene);
    tile->front_only = false;
    for (uint32_t k = 0; k < glass->walls; k++) {
        const tp_glass_wall *wall = &glass->wall[k];
        s.face = wall->face;
        for (uint32_t i = 0; i + 1 < wall->posts; i++)
            draw_water_face_to_next_post(&s, &wall->post[i]);
    }
}

/* -- the panes ----------------------------------------------------------------------- */

static void widen_wall_box(tp_glass_wall *wall, int32_t u, int32_t v)
{
    wall->x0 = u >> 4 < wall->x0 ? u >> 4 : wall->x0;
    wall->x1 = u >> 4 >= wall->x1 ? (u >> 4) + 1 : wall->x1;
    wall->y0 = v >> 4 < wall->y0 ? v >> 4 : wall->y0;
    wall->y1 = v >> 4 >= wall->y1 ? (v >> 4) + 1 : wall->y1;
}

static void project_pane(const tp_frame *frame, tp_glass_wall *wall, tp_pane *pane,
                         const tp_vec3 at[3])
{
    tp_view_vertex in[3];
    tp_screen_vertex corner[TP_CLIP_VERTICES];

    transform_corners(frame, at, in);
    pane->count = tp_clipped_corners(&frame->projection, NULL, in, corner);
    for (int k = 0; k < pane->count; k++) {
        pane->u[k] = corner[k].u;
        pane->v[k] = corner[k].v;
        widen_wall_box(wall, corner[k].u, corner[k].v);
    }
}

/* Sets the coefficients of the pane's depth.  1 / depth is a plane over the picture: n .
 * D / (n . (p - eye)), D the view ray with 1 m along the axis.  The pane covers samples
 * farther away than the pane. */
static void set_pane_depth_plane(const tp_frame *frame, tp_glass_wall *wall,
                                 const tp_rectangle *r)
{
    const tp_underwater *in = frame->shade.underwater;
    const tp_dir3 back = frame->shade.world.back;
    tp_vec3 at = point_on_wall(r, wall->face, 0, 0), eye = frame->projection.eye;
    int     axis = wall->face & 2 ? 2 : 0;
    int64_t gap = axis ? (int64_t)at.z - eye.z : (int64_t)at.x - eye.x;

    if (gap == 0)
        gap = 1;
    wall->gap = gap;
    wall->right = in->right[axis];
    wall->up = in->up[axis];
    wall->ahead = -(int64_t)(axis ? back.z : back.x) * 4096;
}

static void project_wall(const tp_frame *frame, tp_glass_wall *wall, uint32_t face)
{
    const tp_scene *scene = frame->scene;
    const tp_rectangle r = tp_pool_sides(scene);
    const tp_fx from = face & 2 ? r.x0 : r.z0, to = face & 2 ? r.x1 : r.z1;
    const tp_vec3 at[4] = { point_on_wall(&r, face, from, -scene->tank.depth),
                            point_on_wall(&r, face, to, -scene->tank.depth),
                            point_on_wall(&r, face, to, scene->tank.rim),
                            point_on_wall(&r, face, from, scene->tank.rim) };
    const tp_vec3 other[3] = { at[0], at[2], at[3] };

    wall->face = face;
    wall->x0 = wall->y0 = INT32_MAX;
    wall->x1 = wall->y1 = INT32_MIN;
    project_pane(frame, wall, &wall->pane[0], at);
    project_pane(frame, wall, &wall->pane[1], other);
    set_pane_depth_plane(frame, wall, &r);
}

/* Sets the glass's colour and projects the glass walls towards the viewer.  An eye under
 * water sees no glass. */
static void begin_glass_panes(tp_frame *frame, void *mine)
{
    tp_glass *glass = mine;

    tp_frame_use_fresnel(frame);
    glass->colour = (uint32_t)frame->scene->tank.glass_colour;
    glass->share = (uint32_t)frame->scene->tank.glass >> 8;
    glass->walls = 0;
    for (uint32_t face = 0; face < 4 && !frame->under; face++) {
        if (!tp_tank_is_front_glass(frame, face))
            continue;
        TP_ASSERT(glass->walls < TP_GLASSES);
        project_wall(frame, &glass->wall[glass->walls++], face);
    }
}

/* Adds the stages.  Panes cover everything; colours behind them are tone-mapped already. */
static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    const tp_glass *glass = mine;
    const bool fast = frame->scene->quality.refraction == TP_RUNG_FAST;

    if (list->owner == &tp_glass_drawing)
        tp_shaders_add(list, TP_AT_COLOUR,
                       stage[fast ? TP_NTH_quick_tank_side : TP_NTH_tank_side], mine);
    if (glass->walls > 0)
        tp_shaders_add(list, TP_AT_GLASS, stage[fast ? TP_NTH_quick_pane : TP_NTH_pane],
                       mine);
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_glass_enabled(const tp_module_conditions *conditions)
{
    return conditions->above & TP_MODULE_WALLS && tp_has_tank(conditions->scene)
           && conditions->scene->tank.kind == TP_TANK_GLASS;
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    const uint32_t lines = tp_fan_most_cols(tp_fan_budget(conditions->scene));
    tp_glass *glass = tp_arena_alloc(arena, 1, sizeof *glass), made = { .walls = 0 };

    for (int k = 0; k < TP_GLASSES; k++)
        made.wall[k].post = tp_arena_alloc(arena, lines + 2, sizeof *made.wall[k].post);
    if (glass)
        *glass = made;
    return glass;
}

const tp_module tp_glass_module = {
    .name = "glass",
    .id = TP_GLASS_ID,
    .is = TP_MODULE_PANES | TP_MODULE_DRAWS(GLASS),
    .enabled = tp_glass_enabled,
};

const tp_drawing tp_glass_drawing = {
    .layout = layout,
    .marks = tp_marks_one,
    .begin = begin_glass_panes,
    .project = place_side_posts,
    .draw = draw_water_sides,
    .stages = add_stages,
};
