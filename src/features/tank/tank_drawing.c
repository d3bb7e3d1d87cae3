/* SPDX-License-Identifier: MIT */
/* Draws a tank around the pool and the pool's inner walls.  Walls are of stone, except
 * glass walls in front of the viewer.
 *
 * A wall of glass with the eye on its outer side is not drawn here.  The water's side,
 * from the floor up to the surface's edge, takes its place (glass_drawing.c).  The inside
 * of the other walls is drawn like stone.  Walls in a pool's mask are blocks, made once
 * from the pool's cells. */
#include "base/base.h"
#include "features/tank/tank.h"
#include "frame/frame.h"
#include "mesh/mesh.h"
#include "world/pools.h"

/* -- geometry ------------------------------------------------------------------------ */

/* Returns the walls' thickness, a share of the pool's shorter side, m. */
static tp_fx thickness(const tp_scene *scene, const tp_rectangle *r)
{
    tp_fx wide = r->x1 / 2 - r->x0 / 2, deep = r->z1 / 2 - r->z0 / 2;
    tp_fx half = wide < deep ? wide : deep;

    return scene->tank.kind == TP_TANK_GLASS ? tp_clamp(half / 80, 512, 8192)
                                             : tp_clamp(half / 12, 2048, TP_FX_ONE);
}

tp_rectangle tp_tank_outer_sides(const tp_scene *scene, const tp_rectangle *water)
{
    const tp_fx t = thickness(scene, water);

    return (tp_rectangle){
        tp_fx_saturate((int64_t)water->x0 - t), tp_fx_saturate((int64_t)water->x1 + t),
        tp_fx_saturate((int64_t)water->z0 - t), tp_fx_saturate((int64_t)water->z1 + t)
    };
}

/* True if the eye is on the outer side of wall `face`: +x, -x, +z, -z. */
static bool is_outside(const tp_rectangle *r, uint32_t face, tp_vec3 eye)
{
    switch (face) {
    case 0:  return eye.x > r->x1;
    case 1:  return eye.x < r->x0;
    case 2:  return eye.z > r->z1;
    default: return eye.z < r->z0;
    }
}

bool tp_tank_is_front_glass(const tp_frame *frame, uint32_t face)
{
    tp_rectangle r = tp_pool_sides(frame->scene);
    return frame->scene->tank.kind == TP_TANK_GLASS
           && is_outside(&r, face, frame->projection.eye);
}

/* -- quads --------------------------------------------------------------------------- */

/* Four corners, counter-clockwise as seen from the tip of the normal. */
typedef struct {
    tp_vec3 at[4];
    int16_t n[3];               /* normal; 511 is 1 */
} quad;

/* Returns a side of a box, from height `low` to `high`: its outer side with the normal
 * `face`, or with `inwards` the inner side. */
static quad make_face(const tp_rectangle *r, tp_fx low, tp_fx high, uint32_t face,
                      bool inwards)
{
    TP_ASSERT(face < 4 && low <= high);
    static const uint8_t order[4][2] = { { 1, 2 }, { 3, 0 }, { 0, 1 }, { 2, 3 } };
    const tp_fx corner[4][2] = { { r->x0, r->z1 }, { r->x1, r->z1 }, { r->x1, r->z0 },
                                 { r->x0, r->z0 } };
    const tp_fx *a = corner[order[face][inwards]], *b = corner[order[face][!inwards]];
    int16_t out = (face & 1) != inwards ? -511 : 511;

    return (quad){ { { a[0], low, a[1] }, { b[0], low, b[1] }, { b[0], high, b[1] },
                     { a[0], high, a[1] } },
                   { face & 2 ? 0 : out, 0, face & 2 ? out : 0 } };
}

static quad make_top(tp_fx y, const tp_fx at[4][2])
{
    return (quad){ { { at[0][0], y, at[0][1] }, { at[1][0], y, at[1][1] },
                     { at[2][0], y, at[2][1] }, { at[3][0], y, at[3][1] } },
                   { 0, 511, 0 } };
}

/* Returns the top of wall `face`, between the inner and the outer rectangle. */
static quad make_rim(const tp_rectangle *in, const tp_rectangle *out, tp_fx y,
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
    return make_top(y, rim[face]);
}

#define WALL_QUADS  3           /* the inner side, the rim, and the outer side of stone */
#define BLOCK_QUADS 5           /* the top and four sides */

static quad make_wall_quad(const tp_scene *scene, uint32_t face, uint32_t k)
{
    const tp_rectangle in = tp_pool_sides(scene), out = tp_tank_outer_sides(scene, &in);

    if (k == 1)
        return make_rim(&in, &out, scene->tank.rim, face);
    return make_face(k == 0 ? &in : &out, -scene->tank.depth, scene->tank.rim, face, k == 0);
}

static quad make_block_quad(const tp_tank *tank, uint32_t i, uint32_t k)
{
    const tp_rectangle *r = &tank->block[i];
    const tp_fx top[4][2] = { { r->x0, r->z1 }, { r->x1, r->z1 }, { r->x1, r->z0 },
                              { r->x0, r->z0 } };

    return k == 0 ? make_top(tank->high, top)
                  : make_face(r, tank->low, tank->high, k - 1, false);
}

/* -- drawing ------------------------------------------------------------------------- */

/* Sets triangle 0 or 1 of a quad. */
static void set_triangle(const tp_view *view, const quad *q, int half, tp_view_vertex in[3])
{
    const int which[3] = { 0, half + 1, half + 2 };

    for (int k = 0; k < 3; k++)
        in[k] = tp_solid_vertex_make(view->projection, q->at[which[k]], q->n);
}

/* Adds quad k, if it shows a front to a pixel's centre, and widens the box by it. */
static void measure_quad(const tp_view *view, const quad *q, uint32_t k, tp_tank_seen *seen,
                         tp_grid_box *box)
{
    tp_screen_vertex at[TP_CLIP_VERTICES];
    tp_view_vertex in[3];

    for (int half = 0; half < 2; half++) {
        set_triangle(view, q, half, in);
        const int count =
            tp_clipped_corners(view->projection, tp_view_clip_plane(view), in, at);
        for (int i = 2; i < count; i++) {
            const tp_screen_vertex *a = &at[0], *b = &at[i - 1], *c = &at[i];
            tp_grid_box part = TP_BOX_NONE;
            if (tp_tri_twice_area(a, b, c) >= 0)
                continue;
            tp_box_widen(&part, a->u, a->v);
            tp_box_widen(&part, b->u, b->v);
            tp_box_widen(&part, c->u, c->v);
            tp_box_join(box, &part);
            seen->first = part.y0 < seen->first ? part.y0 : seen->first;
            seen->end = part.y1 >= seen->end ? (int16_t)(part.y1 + 1) : seen->end;
            seen->quads |= (uint8_t)(1u << k);
        }
    }
}

/* Finds the quads that the view shows, and widens the box by them.  For an eye in the
 * tank's water the span stages `deep` and `underside` show the walls by ray tests
 * instead. */
static void project(tp_frame *frame, void *mine, tp_view *view, tp_grid_box *box)
{
    const tp_tank_seen none = { INT16_MAX, INT16_MIN, 0 };
    const bool walled = tp_frame_has_tank(frame) && !frame->under;
    const uint32_t quads = frame->scene->tank.kind == TP_TANK_STONE ? WALL_QUADS
                                                                    : WALL_QUADS - 1;
    tp_tank *tank = mine;

    if (!view->walls)
        return;
    for (uint32_t face = 0; face < 4; face++) {
        tank->wall_seen[face] = none;
        if (!walled || tp_tank_is_front_glass(frame, face))
            continue;
        for (uint32_t k = 0; k < quads; k++) {
            const quad q = make_wall_quad(frame->scene, face, k);
            measure_quad(view, &q, k, &tank->wall_seen[face], box);
        }
    }
    for (uint32_t i = 0; i < tank->blocks; i++) {
        tank->block_seen[i] = none;
        for (uint32_t k = 0; k < BLOCK_QUADS; k++) {
            const quad q = make_block_quad(tank, i, k);
            measure_quad(view, &q, k, &tank->block_seen[i], box);
        }
    }
}

static bool touches(const tp_tank_seen *seen, const tp_gbuffer *samples)
{
    return seen->first < samples->y1 && seen->end > samples->y0;
}

static void draw_quad(const tp_view *view, const tp_gbuffer *samples, const quad *q,
                      uint32_t mark)
{
    tp_view_vertex in[3];

    for (int half = 0; half < 2; half++) {
        set_triangle(view, q, half, in);
        tp_clipped_draw(view->projection, tp_view_clip_plane(view), samples, in, mark, 0);
    }
}

/* Draws walls and blocks. */
static void draw(const tp_frame *frame, const void *mine, const tp_view *view,
                 tp_gbuffer *samples, uint32_t mark)
{
    const tp_tank *tank = mine;

    if (!view->walls)
        return;
    samples->front_only = true;
    for (uint32_t face = 0; face < 4; face++) {
        const tp_tank_seen *seen = &tank->wall_seen[face];
        for (uint32_t k = 0; k < WALL_QUADS && touches(seen, samples); k++) {
            if (!(seen->quads >> k & 1))
                continue;
            const quad q = make_wall_quad(frame->scene, face, k);
            draw_quad(view, samples, &q, mark);
        }
    }
    for (uint32_t i = 0; i < tank->blocks; i++) {
        const tp_tank_seen *seen = &tank->block_seen[i];
        for (uint32_t k = 0; k < BLOCK_QUADS && touches(seen, samples); k++) {
            if (!(seen->quads >> k & 1))
                continue;
            const quad q = make_block_quad(tank, i, k);
            draw_quad(view, samples, &q, mark);
        }
    }
}

static void add_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    const bool fast = frame->scene->quality.solids == TP_RUNG_FAST;

    if (list->owner == &tp_tank_drawing)
        tp_shaders_add(list, TP_AT_COLOUR, stage[fast ? TP_NTH_quick_wall : TP_NTH_wall],
                       mine);
}

/* -- blocks -------------------------------------------------------------------------- */

/* Returns the coordinate of edge i of a row of `cells` pool cells around `centre`, m. */
static tp_fx pool_cell_edge_coordinate(tp_fx centre, tp_fx cell, uint32_t i, uint32_t cells)
{
    return tp_fx_saturate(centre + ((int64_t)i - cells / 2) * cell
                          - (cells & 1 ? cell / 2 : 0));
}

/* Lengthens a wall block with the same x range that ends at r.z0 to r.z1.  Returns false
 * if there is no such block. */
static bool extend_wall_block(tp_tank *tank, tp_rectangle r)
{
    for (uint32_t i = 0; i < tank->blocks; i++) {
        tp_rectangle *b = &tank->block[i];
        if (b->x0 == r.x0 && b->x1 == r.x1 && b->z1 == r.z0) {
            b->z1 = r.z1;
            return true;
        }
    }
    return false;
}

/* Adds the wall cells of a row: each stretch of neighbouring wall cells lengthens the same
 * stretch of the row before, or begins a new block.  Counts blocks without room. */
static void append_row_wall_blocks(tp_tank *tank, const tp_pool *pool, uint32_t row)
{
    uint32_t end;

    for (uint32_t col = 0; col < pool->cols; col = end) {
        bool wall = tp_pool_is_wall_or_outside(pool, col, row);
        for (end = col + 1;
             end < pool->cols && tp_pool_is_wall_or_outside(pool, end, row) == wall;)
            end++;
        tp_rectangle r = {
            pool_cell_edge_coordinate(pool->x, pool->cell, col, pool->cols),
            pool_cell_edge_coordinate(pool->x, pool->cell, end, pool->cols),
            pool_cell_edge_coordinate(pool->z, pool->cell, row, pool->rows),
            pool_cell_edge_coordinate(pool->z, pool->cell, row + 1, pool->rows)
        };
        if (!wall || extend_wall_block(tank, r))
            continue;
        if (tank->blocks < TP_BLOCKS)
            tank->block[tank->blocks++] = r;
        else
            tank->dropped++;
    }
}

/* Makes the wall blocks once, and sets their heights.  Without a tank blocks are three
 * cells high, above a splash of the usual height. */
static void begin_tank_walls(tp_frame *frame, void *mine)
{
    tp_tank *tank = mine;
    const tp_scene *scene = frame->scene;
    const tp_pool *pool = tank->block ? tp_world_pool(frame->world) : NULL;
    const bool walled = tp_has_tank(scene);

    tank->high = walled ? scene->tank.rim : 3 * scene->pool.cell;
    tank->low = walled ? -scene->tank.depth : -scene->pool.max_height;
    for (uint32_t row = 0; !tank->made && pool && row < pool->rows; row++)
        append_row_wall_blocks(tank, pool, row);
    tank->made = true;
    frame->stats.dropped += tank->dropped;
}

/* -- the module ---------------------------------------------------------------------- */

/* True if the stone is on.  Stone uses the materials and the light of the module for the
 * inside of the water. */
bool tp_tank_enabled(const tp_module_conditions *conditions)
{
    return conditions->above & TP_MODULE_UNDERWATER
           && (tp_has_tank(conditions->scene) || tp_has_inner_walls(conditions->scene));
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    tp_tank *tank = tp_arena_alloc(arena, 1, sizeof *tank), made = { .block = NULL };

    if (tp_has_inner_walls(conditions->scene)) {
        made.block = tp_arena_alloc(arena, TP_BLOCKS, sizeof *made.block);
        made.block_seen = tp_arena_alloc(arena, TP_BLOCKS, sizeof *made.block_seen);
    }
    if (tank)
        *tank = made;
    return tank;
}

const tp_module tp_tank_module = {
    .name = "tank",
    .id = TP_TANK_ID,
    .enabled = tp_tank_enabled,
    .is = TP_MODULE_WALLS | TP_MODULE_DRAWS(WALL),
};

const tp_drawing tp_tank_drawing = {
    .layout = layout,
    .marks = tp_marks_one,
    .begin = begin_tank_walls,
    .project = project,
    .draw = draw,
    .stages = add_stage,
};
