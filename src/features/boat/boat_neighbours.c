/* SPDX-License-Identifier: MIT */
/* Neighbours of the boat's faces across their edges, and steps: found once, for the module
 * outlines.
 *
 * Positions are below 2^30, so differences of two have 32 bits. */
#include "features/boat/boat.h"
#include "fixed/arithmetic.h"
#include "mesh/mesh.h"

#define NONE      UINT32_MAX
#define NO_FACE   TP_BOAT_NO_FACE

/* Further bits of tp_boat_outlines.edges. */
enum { CONCAVE = 32, STEP = TP_BOAT_STEP };

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

/* Returns n halved `shift` times, towards 0. */
static int32_t halve(int32_t n, int shift)
{
    return n < 0 ? -(-n >> shift) : n >> shift;
}

/* Returns the way from vertex a to vertex b, halved `shift` times. */
static tp_vec3 find_way(const tp_mesh *mesh, uint32_t a, uint32_t b, int shift)
{
    const tp_vec3 way = tp_vec3_sub(mesh->vertices[b].position, mesh->vertices[a].position);

    return (tp_vec3){ halve(way.x, shift), halve(way.y, shift), halve(way.z, shift) };
}

static int64_t measure_length(tp_vec3 way)
{
    return (int64_t)tp_abs(way.x) + tp_abs(way.y) + tp_abs(way.z);
}

/* Lengths of a and b are below 2^15, so products fit 32 bits. */
static tp_vec3 cross_product(tp_vec3 a, tp_vec3 b)
{
    return (tp_vec3){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
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
    const tp_vec3 n = cross_product(find_way(mesh, v[0], v[1], shift),
                                    find_way(mesh, v[0], v[2], shift));
    int64_t most = 0, size = 0;
    for (int i = 0; i < 3; i++) {
        const tp_vec3 p = find_way(mesh, v[k], w[i], shift);
        const int64_t rise = (int64_t)p.x * n.x + (int64_t)p.y * n.y + (int64_t)p.z * n.z;
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

void tp_boat_neighbours_find(const tp_boat_outlines *o, uint32_t *list)
{
    find_neighbours(o, list);
    find_steps(o);
}
