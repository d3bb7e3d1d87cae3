/* SPDX-License-Identifier: MIT */
/* The module outlines: finds the edges of the boat's outline in a view, and draws them.
 *
 * The outline consists of the edges between a front face and a back face, and of the
 * borders of front faces.  A frame knows each face's three neighbours.  An edge needs
 * both faces projected without a cut. */
#include "features/boat/boat.h"
#include "frame/frame.h"
#include "mesh/mesh.h"

/* Further bits of tp_boat_outlines.edges. */
enum { FRONT = TP_BOAT_FRONT, CUT = TP_BOAT_CUT, STEP = TP_BOAT_STEP };

/* -- edges of a view ----------------------------------------------------------------- */

/* Distance of two depths. */
static uint32_t apart(uint32_t a, uint32_t b)
{
    return a > b ? a - b : b - a;
}

/* True if the back face g across an edge is a step less deep than the window of
 * outlines. */
static bool is_shallow_step(const tp_boat_outlines *o, const tp_boat_vertex *vertex,
                            uint32_t g, int shift)
{
    const uint32_t *v = o->mesh->faces[g].vertex;
    const uint32_t a = vertex[v[0]].zi, b = vertex[v[1]].zi, c = vertex[v[2]].zi;
    const uint32_t ab = apart(a, b), bc = apart(b, c), ca = apart(c, a);

    if (!(o->edges[g] & STEP))
        return false;
    return (ab < bc ? ab < ca ? ab : ca : bc < ca ? bc : ca) < a >> shift;
}

/* Finds the edges of the outline among a front face's edges: those without a front face
 * beyond. */
static uint8_t find_edges_of_face(const tp_boat_outlines *o, const tp_boat_vertex *vertex,
                                  uint32_t f, int shift)
{
    const uint16_t *neighbour = &o->neighbour[3 * (size_t)f];
    uint8_t edges = 0;

    for (int k = 0; k < 3; k++)
        if (neighbour[k] == TP_BOAT_NO_FACE
            || (!(o->edges[neighbour[k]] & (FRONT | CUT))
                && !is_shallow_step(o, vertex, neighbour[k], shift)))
            edges |= (uint8_t)(1 << k);
    return edges;
}

static void find_edges(const tp_boat_outlines *o, const tp_boat_faces *faces,
                       const tp_boat_vertex *vertex, int32_t focal)
{
    const int shift = tp_outline_shift(focal);

    for (uint32_t i = 0; i < faces->count; i++) {
        const uint32_t f = tp_boat_face_number(faces, faces->entry[i]);
        const uint8_t edges =
            o->edges[f] & FRONT ? find_edges_of_face(o, vertex, f, shift) : 0;
        o->edges[f] |= edges;
        faces->entry[i] |= edges ? TP_FACE_EDGED : 0;
    }
}

static tp_screen_vertex make_end(const tp_boat_view *b, const tp_boat_vertex *at, uint32_t i)
{
    const tp_mesh_vertex *vertex = &b->mesh->vertices[i];
    const tp_packed_dir normal = tp_boat_vertex_normal(b, i);

    return (tp_screen_vertex){
        .u = at->u, .v = at->v, .zi = at->zi, .s = vertex->s, .t = vertex->t,
        .n = { (int16_t)tp_dir_x(normal), (int16_t)tp_dir_y(normal),
               (int16_t)tp_dir_z(normal) },
    };
}

/* Moves texture coordinates by 1/16 to the third corner: past a border lies the other side
 * of the picture. */
static void move_into_face(tp_screen_vertex *end, const tp_mesh_vertex *third)
{
    end->s += (int32_t)(((int64_t)third->s - end->s) / 16);
    end->t += (int32_t)(((int64_t)third->t - end->t) / 16);
}

static void draw_edges(const tp_boat_outlines *o, const tp_boat_view *view,
                       const tp_boat_vertex *vertex, const tp_gbuffer *tile, uint32_t mark,
                       uint32_t f)
{
    const tp_mesh_vertex *vertices = o->mesh->vertices;
    const uint32_t *corner = o->mesh->faces[f].vertex;
    const int32_t top = 16 * tile->y0, bottom = 16 * tile->y1;

    for (uint32_t k = 0; k < 3; k++) {
        const uint32_t i = corner[k], j = corner[k < 2 ? k + 1 : 0];
        const tp_mesh_vertex *third = &vertices[corner[k > 0 ? k - 1 : 2]];
        const tp_boat_vertex *a = &vertex[i], *b = &vertex[j];
        if (!(o->edges[f] >> k & 1) || (a->v < top && b->v < top)
            || (a->v >= bottom && b->v >= bottom))
            continue;
        tp_screen_vertex from = make_end(view, a, i), to = make_end(view, b, j);
        move_into_face(&from, third);
        move_into_face(&to, third);
        if (view->draw_edge)
            view->draw_edge(tile, &from, &to, mark, f);
        else
            tp_outline_draw_edge(tile, &from, &to, mark, f);
    }
}

/* Draws the outline into a tile, before the faces. */
static void draw_outline(const tp_boat_outlines *o, const tp_boat_view *view,
                         const tp_boat_faces *faces, const tp_boat_vertex *vertex,
                         const tp_grid_box *box, tp_gbuffer *tile, uint32_t mark)
{
    const tp_boat_rows rows = tp_boat_rows_find(faces, tile);

    tp_outline_begin(tile, box->x0, box->x1);
    for (uint32_t i = 0;
         (i = tp_boat_faces_next(faces, i, faces->count, rows, TP_FACE_EDGED))
         < faces->count; i++) {
        const uint32_t f = tp_boat_face_number(faces, faces->entry[i]);
        const uint32_t material = o->mesh->faces[f].material;
        draw_edges(o, view, vertex, tile,
                   mark + (material < TP_BOAT_MATERIALS ? material : TP_BOAT_MATERIALS - 1),
                   f);
    }
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_outlines_enabled(const tp_module_conditions *conditions)
{
    const tp_mesh *mesh = conditions->assets ? conditions->assets->boat : NULL;

    return mesh && tp_has_outlines(conditions->scene)
           && mesh->n_faces <= TP_OUTLINE_FACES;
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    const tp_mesh *mesh = conditions->assets->boat;
    tp_boat_outlines *o = tp_arena_alloc(arena, 1, sizeof *o);
    const tp_boat_outlines made = {
        .find = find_edges, .draw = draw_outline, .mesh = mesh,
        .neighbour = tp_arena_alloc(arena, mesh->n_faces, 3 * sizeof *made.neighbour),
        .edges = tp_arena_alloc(arena, mesh->n_faces, sizeof *made.edges),
    };

    if (o)
        *o = made;
    return o;
}

/* Returns the memory of the module boat, or NULL.  Modules are not on yet. */
static void *find_boat(const tp_frame *frame)
{
    const tp_use *use = frame->program->modules;

    for (uint32_t i = 0; use[i].module; i++)
        if (use[i].module->id == TP_BOAT_ID)
            return frame->buffers.module[i];
    return NULL;
}

/* The lists of waiting half-edges take the memory of the projected vertices. */
static void init(tp_frame *frame, void *mine)
{
    const tp_boat_outlines *o = mine;
    void *const boat = find_boat(frame);

    if (!boat)
        return;
    tp_boat_neighbours_find(o, tp_boat_words(boat));
}

const tp_module tp_outlines_module = {
    .name = "outlines", .id = TP_OUTLINES_ID, .is = TP_MODULE_OUTLINES,
    .enabled = tp_outlines_enabled,
};

const tp_drawing tp_outlines_drawing = {
    .layout = layout, .init = init, .outlining = &tp_outlining_by_share,
};
const tp_stage tp_outlines_stages[] = { NULL };
