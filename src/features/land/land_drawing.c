/* SPDX-License-Identifier: MIT */
/* Draws the land: a sea floor near the water's level or above it.  The triangles use the
 * lines of the water's grid and are drawn before the water.  Ground below the deepest
 * trough is left out, because opaque water always hides it. */
#include "base/base.h"
#include "features/land/land.h"
#include "frame/frame.h"
#include "view/fan.h"
#include "world/pools.h"

/* A screen vertex of the land; u may be TP_GRID_NEEDS_CLIP as for the water. */
typedef struct {
    int32_t  u, v;
    uint32_t zi;
    int16_t  n[3];              /* normal, any length */
    int16_t  out;               /* bits DEEP to BELOW */
} corner;

/* Below every trough; behind the near plane; beside the picture. */
enum { DEEP = 1, BEHIND = 2, LEFT = 4, RIGHT = 8, ABOVE = 16, BELOW = 32 };

/* Range of pixel rows, both ends included, and of cells: those of a row of cells that are
 * drawn. */
typedef struct {
    int32_t  y0, y1;
    uint16_t first, end;
} cell_row;

typedef struct {
    tp_land_look look;          /* data of the stages; first member */
    corner   *at;               /* rows x cols, as the water's grid; NULL: streamed */
    cell_row *rows;             /* array, one for each row of cells */
    tp_fx     culling_depth;
    bool      seen;
} land;

/* Clamp of the land's height and depth.  The camera is up to 8 km high, and their
 * difference must fit Q16.16. */
#define HEIGHT_MOST (24000 * TP_FX_ONE)

static tp_view_vertex transform_vertex(const tp_frame *frame, uint32_t i, uint32_t j,
                                       tp_floor_at *floor)
{
    const tp_grid *grid = frame->buffers.grid;
    tp_fx x = tp_grid_s(grid, i, j), z = tp_grid_t(grid, i, j);
    tp_view_vertex c;

    *floor = tp_coastal_floor(frame->surface.coastal, x, z);
    tp_fx y = (tp_fx)tp_clamp_abs(-(int64_t)floor->depth, HEIGHT_MOST);
    tp_projection_view_vertex(&frame->projection, (tp_vec3){ x, y, z }, &c);
    c.s = c.t = 0;
    return c;
}

/* Sets the normal (-rise_x, 1, -rise_z), scaled to a length below 512.  Slopes are within
 * +-8, so the products fit 32 bits. */
static void set_normal(int16_t n[3], tp_fx rise_x, tp_fx rise_z)
{
    tp_fx most = TP_FX_ONE + tp_abs(rise_x) + tp_abs(rise_z);

    n[0] = (int16_t)(-rise_x * 511 / most);
    n[1] = (int16_t)(TP_FX_ONE * 511 / most);
    n[2] = (int16_t)(-rise_z * 511 / most);
}

/* Returns the sides of the picture that a vertex lies beyond.  Each side is a plane through
 * the eye, 16 px beyond the edge: more than clipping rounds. */
static int32_t sides_beside_picture(const tp_projection *projection, const tp_view_vertex *c)
{
    const int64_t x = (int64_t)c->x * (1 << projection->m);
    const int64_t y = (int64_t)c->y * (1 << projection->m);
    const int64_t wide = (int64_t)c->depth * (projection->u0 / 16 + 16);
    const int64_t high = (int64_t)c->depth * (projection->v0 / 16 + 16);

    return (x < -wide ? LEFT : 0) | (x > wide ? RIGHT : 0) | (y > high ? ABOVE : 0)
           | (y < -high ? BELOW : 0);
}

static void place_corner(const tp_frame *frame, uint32_t i, uint32_t j,
                         tp_fx culling_depth, corner *to)
{
    TP_ASSERT(i < frame->buffers.grid->cols && j < frame->buffers.grid->rows);
    tp_floor_at floor;
    tp_view_vertex c = transform_vertex(frame, i, j, &floor);

    set_normal(to->n, floor.rise_x, floor.rise_z);
    to->out = (int16_t)((floor.depth > culling_depth ? DEEP : 0)
                        | (c.depth < frame->projection.near ? BEHIND : 0)
                        | sides_beside_picture(&frame->projection, &c));
    if (tp_projection_can_project(&frame->projection, &c))
        tp_projection_project(&frame->projection, &c, &to->u, &to->v, &to->zi);
    else
        to->u = TP_GRID_NEEDS_CLIP;
}

/* True if all corners of a cell are beyond one side.  Other cells are drawn. */
static bool is_culled(const corner *const p[4])
{
    return (p[0]->out & p[1]->out & p[2]->out & p[3]->out) != 0;
}

static bool needs_clipping(const corner *const p[4])
{
    return p[0]->u == TP_GRID_NEEDS_CLIP || p[1]->u == TP_GRID_NEEDS_CLIP
           || p[2]->u == TP_GRID_NEEDS_CLIP || p[3]->u == TP_GRID_NEEDS_CLIP;
}

/* -- rows of cells ------------------------------------------------------------------- */

/* The corners of two columns of a row of cells, if they are streamed: column i is
 * [i & 1]. */
typedef struct {
    corner placed[2][2];        /* on rows j and j + 1 */
} cell_walk;

static void load_column(const tp_frame *frame, const land *l, uint32_t i, uint32_t j,
                        cell_walk *walk)
{
    for (uint32_t k = 0; k < 2 && !l->at; k++)
        place_corner(frame, i, j + k, l->culling_depth, &walk->placed[i & 1][k]);
}

/* Sets the corners (i, j), (i+1, j), (i, j+1), (i+1, j+1) of a cell whose left column was
 * loaded before. */
TP_ALWAYS_INLINE void find_corners(const tp_frame *frame, const land *l, uint32_t i,
                                   uint32_t j, cell_walk *walk, const corner *p[4])
{
    if (!l->at)
        load_column(frame, l, i + 1, j, walk);
    for (uint32_t k = 0; k < 2; k++) {
        const corner *const at = l->at + (size_t)(j + k) * frame->buffers.grid->cols + i;
        p[2 * k] = l->at ? at : &walk->placed[i & 1][k];
        p[2 * k + 1] = l->at ? at + 1 : &walk->placed[(i + 1) & 1][k];
    }
}

static void add_cell(cell_row *row, uint32_t i, const corner *const p[4])
{
    const bool cut = needs_clipping(p);

    if (row->first == row->end)
        row->first = (uint16_t)i;
    row->end = (uint16_t)(i + 1);
    for (int k = 0; k < 4; k++) {
        int32_t low = cut ? INT32_MIN : p[k]->v >> 4;
        int32_t high = cut ? INT32_MAX : p[k]->v >> 4;
        row->y0 = low < row->y0 ? low : row->y0;
        row->y1 = high > row->y1 ? high : row->y1;
    }
}

/* Sets the drawn cells of row j and the pixel rows that they touch; y0 > y1: none. */
static void set_cell_row(const tp_frame *frame, const land *l, uint32_t j)
{
    cell_row row = { INT32_MAX, INT32_MIN, 0, 0 };
    cell_walk walk;

    load_column(frame, l, 0, j, &walk);
    for (uint32_t i = 0; i + 1 < frame->buffers.grid->cols; i++) {
        const corner *p[4];
        find_corners(frame, l, i, j, &walk, p);
        if (!is_culled(p))
            add_cell(&row, i, p);
    }
    l->rows[j] = row;
}

/* -- swash and projection ------------------------------------------------------------ */

#define MAPPED TP_FX(0.1)       /* slope of beaches on a map */

/* Sets the swash of the wave with the highest run-up by Hunt's law: slope sqrt(H L), at
 * most twice the wave's height. An eye under water sees none: frame->under is known when
 * all modules have begun. */
static void set_swash(const tp_frame *frame, tp_land_look *look)
{
    const tp_deep_water *deep = &frame->world->deep;
    const tp_fx slope = frame->assets.floor ? MAPPED : frame->scene->floor.slope;
    const int32_t lit = tp_lit_share(frame->shade.ambient, frame->shade.world.ly);

    look->runup = 0;
    for (uint32_t i = 0; i < deep->count && !frame->under; i++) {
        const int64_t height = 2 * (int64_t)deep->swell[i].amplitude;
        const int64_t square = (height << 32) / (int64_t)deep->swell[i].turns;
        const tp_fx up = tp_fx_mul(slope, tp_fx_sqrt(tp_fx_saturate(square)));
        const tp_fx runup = up < 2 * height ? up : (tp_fx)(2 * height);
        if (runup <= look->runup)
            continue;
        look->runup = runup;
        look->phase = frame->drawn.phases[i];
    }
    look->foam = tp_colour_scale((uint32_t)frame->scene->foam.colour,
                                 (uint32_t)(256 + lit) / 2);
}

/* Returns the depth from which water hides the land.  The fast rung of solids relies on
 * waves that are lower in shallow water: a trough reaches a quarter of the bound at most. */
static tp_fx find_culling_depth(const tp_frame *frame)
{
    const tp_fx lowest = tp_surface_height_bound(&frame->surface);

    if (frame->scene->quality.solids == TP_RUNG_FAST && !frame->under)
        return lowest / 4 + TP_FX_ONE / 4;
    return lowest + TP_FX_ONE;
}

/* Projects the land.  Land appears in the main view only, and needs grid vertices: only
 * some water renderers make them. */
static void project(tp_frame *frame, void *mine, tp_view *view, tp_grid_box *box)
{
    const tp_grid *grid = frame->buffers.grid;
    land *l = mine;

    l->culling_depth = find_culling_depth(frame);
    l->seen = view->picture && grid && frame->surface.coastal;
    if (l->seen) {
        set_swash(frame, &l->look);
        *box = TP_BOX_ALL;
    }
    for (uint32_t j = 0; l->seen && j < grid->rows; j++) {
        for (uint32_t i = 0; l->at && i < grid->cols; i++)
            place_corner(frame, i, j, l->culling_depth, &l->at[(size_t)j * grid->cols + i]);
        if (j > 0)
            set_cell_row(frame, l, j - 1);
    }
}

/* -- drawing ------------------------------------------------------------------------- */

static tp_screen_vertex make_screen_vertex(const corner *v)
{
    return (tp_screen_vertex){ .u = v->u, .v = v->v, .zi = v->zi,
                        .n = { v->n[0], v->n[1], v->n[2] } };
}

/* True if all corners of a cell lie beside one side of the tile. */
static bool is_beside_tile(const corner *const p[4], const tp_gbuffer *tile)
{
    int32_t left = INT32_MAX, right = INT32_MIN, above = INT32_MAX, below = INT32_MIN;

    for (int k = 0; k < 4; k++) {
        left = p[k]->u < left ? p[k]->u : left;
        right = p[k]->u > right ? p[k]->u : right;
        above = p[k]->v < above ? p[k]->v : above;
        below = p[k]->v > below ? p[k]->v : below;
    }
    return right < 16 * tile->x0 || left >= 16 * tile->x1 || below < 16 * tile->y0
           || above >= 16 * tile->y1;
}

static void draw_clipped(const tp_frame *frame, const tp_gbuffer *tile,
                         const uint32_t at[3][2], uint32_t mark)
{
    tp_view_vertex in[3];
    tp_floor_at floor;

    for (int k = 0; k < 3; k++) {
        in[k] = transform_vertex(frame, at[k][0], at[k][1], &floor);
        set_normal(in[k].n, floor.rise_x, floor.rise_z);
    }
    tp_clipped_draw(&frame->projection, NULL, tile, in, mark, 0);
}

static void draw_cell(const tp_frame *frame, const corner *const all[4],
                      const tp_gbuffer *tile, uint32_t i, uint32_t j, uint32_t mark)
{
    if (is_culled(all))
        return;
    if (needs_clipping(all)) {
        const uint32_t first[3][2] = { { i, j }, { i, j + 1 }, { i + 1, j + 1 } };
        const uint32_t second[3][2] = { { i, j }, { i + 1, j + 1 }, { i + 1, j } };
        draw_clipped(frame, tile, first, mark);
        draw_clipped(frame, tile, second, mark);
        return;
    }
    if (is_beside_tile(all, tile))
        return;
    tp_screen_vertex p[4] = { make_screen_vertex(all[0]), make_screen_vertex(all[1]),
                              make_screen_vertex(all[3]), make_screen_vertex(all[2]) };
    tp_tri_solid(tile, &p[0], &p[3], &p[2], mark, 0, 16);
    tp_tri_solid(tile, &p[0], &p[2], &p[1], mark, 0, 16);
}

static void draw_cell_row(const tp_frame *frame, const land *l, const tp_gbuffer *samples,
                          uint32_t j, uint32_t mark)
{
    const cell_row row = l->rows[j];
    cell_walk walk;

    TP_ASSERT(row.first < row.end && row.end < frame->buffers.grid->cols);
    load_column(frame, l, row.first, j, &walk);
    for (uint32_t i = row.first; i < row.end; i++) {
        const corner *p[4];
        find_corners(frame, l, i, j, &walk, p);
        draw_cell(frame, p, samples, i, j, mark);
    }
}

static void draw(const tp_frame *frame, const void *mine, const tp_view *view,
                 tp_gbuffer *samples, uint32_t mark)
{
    const land *l = mine;

    if (!l->seen || !view->picture)
        return;
    samples->front_only = true;
    for (uint32_t j = 0; j + 1 < frame->buffers.grid->rows; j++) {
        if (l->rows[j].y0 >= samples->y1 || l->rows[j].y1 < samples->y0)
            continue;
        draw_cell_row(frame, l, samples, j, mark);
    }
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_land_enabled(const tp_module_conditions *conditions)
{
    return tp_has_floor(conditions->scene);
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    const uint32_t vertices = tp_fan_budget(conditions->scene);
    land *l = tp_arena_alloc(arena, 1, sizeof *l), made = { .seen = false };

    made.at = conditions->streams ? NULL
                                  : tp_arena_alloc(arena, vertices, sizeof *made.at);
    made.rows = tp_arena_alloc(arena, tp_fan_most_rows(vertices), sizeof *made.rows);
    if (l)
        *l = made;
    return l;
}

/* Sets the material of bare land: the colour of the floor, without highlights. */
static void begin_land_material(tp_frame *frame, void *mine)
{
    land *l = mine;

    l->look.look = (tp_solid){
        .diffuse = tp_frame_lit_colour(frame, (uint32_t)frame->scene->floor.colour),
        .gloss = tp_drop_gloss,
    };
}

/* True if land is textured and lit like the floor: beside clear water, with a floor
 * texture, or for a camera under water. */
static bool is_shaded_as_floor(const tp_frame *frame)
{
    return tp_frame_has_module(frame, TP_MODULE_UNDERWATER)
        && (frame->under || frame->assets.floor_texture
            || frame->scene->water.clarity > 0);
}

static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    if (list->owner == &tp_land_drawing)
        tp_shaders_add(list, TP_AT_COLOUR, is_shaded_as_floor(frame) && stage[1] ? stage[1]
                                                                        : stage[0], mine);
}

const tp_module tp_land_module = {
    .name = "land",
    .id = TP_LAND_ID,
    .is = TP_MODULE_DRAWS(LAND),
    .enabled = tp_land_enabled,
};

const tp_drawing tp_land_drawing = {
    .layout = layout, .marks = tp_marks_one, .begin = begin_land_material,
    .project = project,
    .draw = draw, .stages = add_stages,
};
