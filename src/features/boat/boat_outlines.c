/* SPDX-License-Identifier: MIT */
/* The module outlines: finds the edges of the boat's outline in a view, and draws them.
 *
 * The outline consists of the edges between a front face and a back face, and of the
 * borders of front faces.  A frame knows each face's three neighbours.  An edge needs
 * both faces projected without a cut. */
#include "features/boat/boat.h"
#include "frame/frame.h"
#include "mesh/mesh.h"

#define NONE      UINT32_MAX
#define NO_FACE   UINT16_MAX
_Static_assert(TP_OUTLINE_FACES <= NO_FACE, "faces are numbered by 16 bits");

/* Further bits of tp_boat_outlines.edges. */
enum { FRONT = TP_BOAT_FRONT, CUT = TP_BOAT_CUT, CONCAVE = 32, STEP = TP_BOAT_STEP };

/* -- neighbours ---------------------------------------------------------------------- */

/* Number of the vertex at corner k of the half-edge 3 f + k. */
static uint32_t corner(const tp_mesh *mesh, uint32_t f, uint32_t k)
{
    return mesh->faces[f].vertex[k < 3 ? k : 0];
}

static bool is_same_place(const tp_mesh *mesh, uint32_t a, uint32_t b)
{
    const tp_vec3 p = mesh->vertices[a].position, q = mesh->vertices[b].position;
    return p.x == q.x && p.y == q.y && p.z == q.z;
}

/* Returns the list of half-edges that begin at vertex i, or near it by position. */
static uint32_t list_index(const tp_mesh *mesh, uint32_t i, bool by_place)
{
    const tp_vec3 p = mesh->vertices[i].position;

    if (!by_place)
        return i;
    return ((uint32_t)p.x * 2654435761u ^ (uint32_t)p.y * 2246822519u
            ^ (uint32_t)p.z * 3266489917u) % mesh->n_vertices;
}

/* The half-edge after a waiting half-edge in its list, or NONE: its face stands in the place
 * of the neighbour, its corner in two bits of the face's edges. */
static uint32_t next_waiting(const tp_boat_outlines *o, uint32_t e)
{
    const uint32_t f = o->neighbour[e];
    return f == NO_FACE ? NONE : 3 * f + ((uint32_t)o->edges[e / 3] >> 2 * (e % 3) & 3);
}

static void set_next_waiting(const tp_boat_outlines *o, uint32_t e, uint32_t next)
{
    TP_ASSERT(next == NONE || next / 3 < o->mesh->n_faces);
    const uint32_t at = 2 * (e % 3);

    o->neighbour[e] = next == NONE ? NO_FACE : (uint16_t)(next / 3);
    o->edges[e / 3] = (uint8_t)((o->edges[e / 3] & ~(3u << at)) | next % 3 << at);
}

static bool are_opposite(const tp_mesh *mesh, uint32_t e, uint32_t g, bool by_place)
{
    const uint32_t a = corner(mesh, e / 3, e % 3), b = corner(mesh, e / 3, e % 3 + 1);
    const uint32_t c = corner(mesh, g / 3, g % 3), d = corner(mesh, g / 3, g % 3 + 1);

    return by_place ? is_same_place(mesh, c, b) && is_same_place(mesh, d, a)
                    : c == b && d == a;
}

/* Joins half-edge e to a waiting half-edge in the other direction, or adds it to the
 * waiting ones. */
static void match(const tp_boat_outlines *o, uint32_t *list, uint32_t e, bool by_place)
{
    const tp_mesh *mesh = o->mesh;
    uint32_t *head = &list[list_index(mesh, corner(mesh, e / 3, e % 3 + 1), by_place)];
    uint32_t before = NONE;

    for (uint32_t g = *head; g != NONE; before = g, g = next_waiting(o, g)) {
        if (!are_opposite(mesh, e, g, by_place))
            continue;
        if (before == NONE)
            *head = next_waiting(o, g);
        else
            set_next_waiting(o, before, next_waiting(o, g));
        o->neighbour[g] = (uint16_t)(e / 3);
        o->neighbour[e] = (uint16_t)(g / 3);
        return;
    }
    head = &list[list_index(mesh, corner(mesh, e / 3, e % 3), by_place)];
    set_next_waiting(o, e, *head);
    *head = e;
}

static void clear_list(uint32_t *list, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++)
        list[i] = NONE;
}

static void end_lists(const tp_boat_outlines *o, const uint32_t *list)
{
    for (uint32_t i = 0; i < o->mesh->n_vertices; i++)
        for (uint32_t e = list[i], next; e != NONE; e = next) {
            next = next_waiting(o, e);
            o->neighbour[e] = NO_FACE;
        }
}

static bool is_lid(const tp_mesh *mesh, uint32_t f)
{
    return mesh->materials[mesh->faces[f].material].opacity == 0;
}

/* Finds all neighbours: first by vertex numbers, which keeps the two sides of a sheet
 * apart, then by positions, across seams of a texture or of a normal. */
static void find_neighbours(const tp_boat_outlines *o, uint32_t *list)
{
    const uint32_t edges = 3 * o->mesh->n_faces;

    clear_list(list, o->mesh->n_vertices);
    for (uint32_t e = 0; e < edges; e++) {
        o->neighbour[e] = NO_FACE;
        if (!is_lid(o->mesh, e / 3))
            match(o, list, e, false);
    }
    end_lists(o, list);
    clear_list(list, o->mesh->n_vertices);
    for (uint32_t e = 0; e < edges; e++)
        if (o->neighbour[e] == NO_FACE && !is_lid(o->mesh, e / 3))
            match(o, list, e, true);
    end_lists(o, list);
}

/* -- steps --------------------------------------------------------------------------- */

/* A step is a narrow face with another surface beyond its other edge: the lap of two
 * planks.  The surface beyond lies close behind the step's edge, so the edge is no
 * outline. */

typedef struct {
    int64_t x, y, z;
} way;

/* Returns n halved `shift` times, towards 0. */
static int64_t halve(int64_t n, int shift)
{
    return n < 0 ? -(-n >> shift) : n >> shift;
}

/* Returns the way from vertex a to vertex b, halved until it is below 2^15. */
static way find_way(const tp_mesh *mesh, uint32_t a, uint32_t b, int shift)
{
    const tp_vec3 p = mesh->vertices[a].position, q = mesh->vertices[b].position;

    return (way){ halve((int64_t)q.x - p.x, shift), halve((int64_t)q.y - p.y, shift),
                  halve((int64_t)q.z - p.z, shift) };
}

static int64_t measure_length(way w)
{
    return (w.x < 0 ? -w.x : w.x) + (w.y < 0 ? -w.y : w.y) + (w.z < 0 ? -w.z : w.z);
}

static way cross_product(way a, way b)
{
    return (way){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

/* Returns how the face across edge k of face f bends from the plane of f by about 1/16 of
 * its size or more: 1 for a concave edge, 0 for a plane, -1 for a convex edge. */
static int bend(const tp_boat_outlines *o, uint32_t f, uint32_t k)
{
    const tp_mesh *mesh = o->mesh;
    const uint32_t *v = mesh->faces[f].vertex, *w = mesh->faces[o->neighbour[3 * f + k]].vertex;
    int shift = 0;

    for (int i = 0; i < 3; i++)
        while (measure_length(find_way(mesh, v[0], v[i], shift)) >> 15
               || measure_length(find_way(mesh, v[0], w[i], shift)) >> 15)
            shift++;
    const way n = cross_product(find_way(mesh, v[0], v[1], shift),
                                find_way(mesh, v[0], v[2], shift));
    int64_t most = 0, size = 0;
    for (int i = 0; i < 3; i++) {
        const way p = find_way(mesh, v[k], w[i], shift);
        const int64_t rise = p.x * n.x + p.y * n.y + p.z * n.z;
        most = (rise < 0 ? -rise : rise) > (most < 0 ? -most : most) ? rise : most;
        size = measure_length(p) > size ? measure_length(p) : size;
    }
    const int64_t bent = size * measure_length(n) / 16;
    return most > bent ? 1 : most < -bent ? -1 : 0;
}

static bool has_neighbour(const tp_boat_outlines *o, uint32_t f, uint32_t k)
{
    return !is_lid(o->mesh, f) && o->neighbour[3 * f + k] != NO_FACE;
}

static void find_steps(const tp_boat_outlines *o)
{
    const uint32_t faces = o->mesh->n_faces;

    for (uint32_t f = 0; f < faces; f++) {
        o->edges[f] = 0;
        for (uint32_t k = 0; k < 3; k++)
            if (has_neighbour(o, f, k) && bend(o, f, k) > 0)
                o->edges[f] |= CONCAVE;
    }
    for (uint32_t f = 0; f < faces; f++) {
        bool step = o->edges[f] & CONCAVE;
        for (uint32_t k = 0; k < 3; k++)
            step = step || (has_neighbour(o, f, k) && bend(o, f, k) == 0
                            && o->edges[o->neighbour[3 * f + k]] & CONCAVE);
        o->edges[f] |= step ? STEP : 0;
    }
}

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
        if (neighbour[k] == NO_FACE
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
    const tp_mesh *mesh = o->mesh;
    const int32_t top = 16 * tile->y0, bottom = 16 * tile->y1;

    for (uint32_t k = 0; k < 3; k++) {
        const uint32_t i = corner(mesh, f, k), j = corner(mesh, f, k + 1);
        const tp_boat_vertex *a = &vertex[i], *b = &vertex[j];
        if (!(o->edges[f] >> k & 1) || (a->v < top && b->v < top)
            || (a->v >= bottom && b->v >= bottom))
            continue;
        tp_screen_vertex from = make_end(view, a, i),
                         to = make_end(view, b, j);
        move_into_face(&from, &mesh->vertices[corner(mesh, f, (k + 2) % 3)]);
        move_into_face(&to, &mesh->vertices[corner(mesh, f, (k + 2) % 3)]);
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
    find_neighbours(o, tp_boat_words(boat));
    find_steps(o);
}

const tp_module tp_outlines_module = {
    .name = "outlines", .id = TP_OUTLINES_ID, .is = TP_MODULE_OUTLINES,
    .enabled = tp_outlines_enabled,
};

const tp_drawing tp_outlines_drawing = {
    .layout = layout, .init = init, .outlining = &tp_outlining_by_share,
};
const tp_stage tp_outlines_stages[] = { NULL };
