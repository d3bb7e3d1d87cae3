/* SPDX-License-Identifier: MIT */
/* Lists the faces that a view of the mesh may draw, once a view, in the order of the mesh.
 * Tiles and bands scan the list instead of the mesh.
 *
 * An entry holds, from its low bits up: three flags, the last row, the first row, the
 * face's number.  Rows are counted in steps of 2^row_shift pixels. */
#include "features/boat/boat.h"

static int32_t min_of_three(int32_t a, int32_t b, int32_t c)
{
    const int32_t n = a < b ? a : b;
    return n < c ? n : c;
}

static int32_t max_of_three(int32_t a, int32_t b, int32_t c)
{
    return -min_of_three(-a, -b, -c);
}

static uint32_t row_step(const tp_boat_faces *faces, int32_t row)
{
    return (uint32_t)tp_clamp(row >> faces->row_shift, 0, faces->last_step);
}

tp_boat_faces tp_boat_faces_layout(tp_arena *arena, uint32_t count, uint32_t height)
{
    const int face_bits = 32 - tp_clz(count | 1), free_bits = (29 - face_bits) / 2;
    tp_boat_faces faces = { .row_bits = (uint8_t)(free_bits < 8 ? free_bits : 8) };

    TP_ASSERT(free_bits > 0);
    faces.entry = tp_arena_alloc(arena, count, sizeof *faces.entry);
    faces.block = tp_arena_alloc(arena, (count + TP_BOAT_BLOCK - 1) / TP_BOAT_BLOCK,
                                 sizeof *faces.block);
    faces.last_step = (1 << faces.row_bits) - 1;
    while ((height - 1) >> faces.row_shift > (uint32_t)faces.last_step)
        faces.row_shift++;
    return faces;
}

tp_boat_rows tp_boat_rows_find(const tp_boat_faces *faces, const tp_gbuffer *tile)
{
    return (tp_boat_rows){ row_step(faces, tile->y0), row_step(faces, tile->y1 - 1) };
}

/* Returns the entry of a projected face, without its number. */
static uint32_t make_entry(const tp_boat_faces *faces, const tp_boat_vertex *a,
                           const tp_boat_vertex *b, const tp_boat_vertex *c)
{
    const int32_t left = min_of_three(a->u, b->u, c->u),
                  right = max_of_three(a->u, b->u, c->u),
                  top = min_of_three(a->v, b->v, c->v),
                  bottom = max_of_three(a->v, b->v, c->v);
    const bool fills = tp_first_centre(left) < tp_first_centre(right)
                       && tp_first_centre(top) < tp_first_centre(bottom);

    return row_step(faces, bottom >> 4) << 3
           | row_step(faces, top >> 4) << (3 + faces->row_bits)
           | (fills ? TP_FACE_FILLS : 0);
}

/* Triangles seen from behind draw nothing; neither do rows above the picture. */
void tp_boat_faces_set_polygon(tp_boat_faces *faces, uint32_t i,
                               const tp_screen_vertex *corner, int count)
{
    const int shift = 3 + 2 * faces->row_bits;
    int32_t top = INT32_MAX, end = 0;

    for (int k = 2; k < count; k++) {
        const tp_screen_vertex *a = &corner[0], *b = &corner[k - 1], *c = &corner[k];
        if (tp_tri_twice_area(a, b, c) >= 0)
            continue;
        const int32_t first = tp_first_centre(min_of_three(a->v, b->v, c->v)),
                      past = tp_first_centre(max_of_three(a->v, b->v, c->v));
        top = first < top ? first : top;
        end = past > end ? past : end;
    }
    faces->entry[i] = faces->entry[i] >> shift << shift | TP_FACE_CUT;
    if (top < end)
        faces->entry[i] |= row_step(faces, end - 1) << 3
                         | row_step(faces, top) << (3 + faces->row_bits) | TP_FACE_FILLS;
}

/* Returns FRONT, CUT or neither; sets the entry to 0 if the view shows no part. */
static uint8_t classify(const tp_boat_faces *faces, const tp_mesh_face *face,
                        const tp_boat_vertex *vertex, uint32_t *entry)
{
    const tp_boat_vertex *a = &vertex[face->vertex[0]], *b = &vertex[face->vertex[1]],
                         *c = &vertex[face->vertex[2]];

    *entry = 0;
    if (a->u <= TP_BOAT_OUTSIDE || b->u <= TP_BOAT_OUTSIDE || c->u <= TP_BOAT_OUTSIDE) {
        if (a->u != TP_BOAT_OUTSIDE || b->u != TP_BOAT_OUTSIDE || c->u != TP_BOAT_OUTSIDE)
            *entry = TP_FACE_CUT;
        return TP_BOAT_CUT;
    }
    if ((int64_t)(b->u - a->u) * (c->v - a->v) >= (int64_t)(c->u - a->u) * (b->v - a->v))
        return 0;
    *entry = make_entry(faces, a, b, c);
    return TP_BOAT_FRONT;
}

void tp_boat_faces_list(tp_boat_faces *faces, const tp_mesh *mesh,
                        const tp_boat_vertex *vertex, uint8_t *edges)
{
    const int shift = 3 + 2 * faces->row_bits;

    faces->count = 0;
    faces->lids = faces->end = mesh->n_faces;
    for (uint32_t f = 0; f < mesh->n_faces; f++) {
        const tp_mesh_face *face = &mesh->faces[f];
        const bool lid = mesh->materials[face->material].opacity == 0;
        uint32_t entry;
        const uint8_t facing = classify(faces, face, vertex, &entry);
        if (edges)
            edges[f] = (uint8_t)((edges[f] & TP_BOAT_STEP) | (lid ? 0 : facing));
        if (entry || facing == TP_BOAT_FRONT)
            faces->entry[lid ? --faces->lids : faces->count++] = entry | f << shift;
    }
}

/* Widens the blocks' rows by those of a range of entries. */
static void widen_blocks(tp_boat_faces *faces, uint32_t first, uint32_t end)
{
    for (uint32_t i = first; i < end; i++) {
        tp_boat_block *block = &faces->block[i / TP_BOAT_BLOCK];
        const tp_boat_rows rows = tp_boat_face_rows(faces, faces->entry[i]);
        if (!(faces->entry[i] & (TP_FACE_FILLS | TP_FACE_EDGED)))
            continue;
        if (rows.first < block->first)
            block->first = (uint8_t)rows.first;
        if (rows.last > block->last)
            block->last = (uint8_t)rows.last;
    }
}

void tp_boat_faces_set_blocks(tp_boat_faces *faces)
{
    for (uint32_t i = 0; i < faces->end; i += TP_BOAT_BLOCK)
        faces->block[i / TP_BOAT_BLOCK] = (tp_boat_block){ UINT8_MAX, 0 };
    widen_blocks(faces, 0, faces->count);
    widen_blocks(faces, faces->lids, faces->end);
}
