/* SPDX-License-Identifier: MIT */
/* Geometry of a mesh, after the whole file is read: polygons become faces and finished
 * vertices, with normals and tangents from exact area vectors. */
#include "base/base.h"
#include "fixed/arithmetic.h"
#include "mesh/mesh.h"
#include "mesh/obj.h"

/* -- area vectors -------------------------------------------------------------------- */

tp_area tp_area_cross(tp_vec3 a, tp_vec3 b)
{
    return (tp_area){ tp_area_product_difference(a.y, b.z, a.z, b.y),
                      tp_area_product_difference(a.z, b.x, a.x, b.z),
                      tp_area_product_difference(a.x, b.y, a.y, b.x) };
}

static uint32_t bit_length(uint32_t x)
{
    return x == 0 ? 0 : 32 - (uint32_t)tp_clz(x);
}

/* Each edge component < 2^e and count < 2^c.  The components of all vectors sum up
 * to below 2^(2e + 1 + c).  The lengths, at most sqrt(3) times as long, sum up to
 * below 2^(2e + 2 + c). */
uint32_t tp_area_sum_shift(uint32_t extent, uint32_t count)
{
    const uint32_t bits = 2 * bit_length(extent) + 2 + bit_length(count);
    return bits > 63 ? bits - 63 : 0;
}

tp_area tp_area_divide_pow2(tp_area a, uint32_t shift)
{
    TP_ASSERT(shift < 63);
    const int64_t unit = (int64_t)1 << shift;
    return (tp_area){ a.x / unit, a.y / unit, a.z / unit };
}

static uint64_t magnitude(int64_t x)
{
    return x < 0 ? 0 - (uint64_t)x : (uint64_t)x;
}

/* Returns the number of bits by which the longest component exceeds 30 bits. */
static uint32_t excess_bits(tp_area a)
{
    const uint64_t most = magnitude(a.x) | magnitude(a.y) | magnitude(a.z);
    uint32_t shift = 0;
    while (most >> shift >= (uint64_t)1 << 30)
        shift++;
    return shift;
}

uint64_t tp_area_length(tp_area a)
{
    const uint32_t shift = excess_bits(a);
    const tp_area small = tp_area_divide_pow2(a, shift);
    const uint64_t square = (uint64_t)(small.x * small.x) + (uint64_t)(small.y * small.y)
                          + (uint64_t)(small.z * small.z);
    return (uint64_t)tp_isqrt64(square) << shift;
}

/* Returns (0, 1, 0) for zero area. */
static tp_dir3 area_direction(tp_area a)
{
    const tp_area small = tp_area_divide_pow2(a, excess_bits(a));
    return tp_normalise((int32_t)small.x, (int32_t)small.y, (int32_t)small.z);
}

/* -- faces and vertices -------------------------------------------------------------- */

/* Before this step a vertex is three indices.  Faces are cut and measured with these
 * indices.  Each face adds its area vector to its smooth normals, one sum per position
 * and smoothing group.  Then every vertex is replaced by its final form, in place. */

/* -- bounds and scales --------------------------------------------------------------- */

static void widen(int32_t *low, int32_t *high, int32_t x)
{
    if (x < *low)
        *low = x;
    if (x > *high)
        *high = x;
}

static struct tp_obj_texcoord vertex_texcoord(const tp_obj_memory *store, uint32_t vertex)
{
    const uint32_t i = store->vertices[vertex].corner.texcoord;
    return i == TP_NO_TEXCOORD ? (struct tp_obj_texcoord){ 0, 0 } : store->texcoords[i];
}

static tp_vec3 vertex_position(const tp_obj_memory *store, uint32_t vertex)
{
    return store->positions[store->vertices[vertex].corner.position];
}

static uint32_t larger_extent(int32_t low_a, int32_t high_a, int32_t low_b, int32_t high_b)
{
    const uint32_t a = (uint32_t)(high_a - low_a), b = (uint32_t)(high_b - low_b);
    return a > b ? a : b;
}

/* Finds the bounding box, and the shifts that keep the sums of areas from overflowing. */
static void find_bounds_and_area_shifts(tp_obj *obj)
{
    const tp_obj_memory *const store = &obj->store;
    tp_vec3 low = vertex_position(store, 0), high = low;
    struct tp_obj_texcoord first = vertex_texcoord(store, 0), last = first;
    for (uint32_t i = 1; i < store->n_vertices; i++) {
        const tp_vec3 p = vertex_position(store, i);
        widen(&low.x, &high.x, p.x);
        widen(&low.y, &high.y, p.y);
        widen(&low.z, &high.z, p.z);
        const struct tp_obj_texcoord tex = vertex_texcoord(store, i);
        widen(&first.s, &last.s, tex.s);
        widen(&first.t, &last.t, tex.t);
    }
    obj->low = low;
    obj->high = high;
    const uint32_t box = larger_extent(low.x, high.x, low.y, high.y);
    const uint32_t depth = (uint32_t)(high.z - low.z);
    obj->area_shift = tp_area_sum_shift(box > depth ? box : depth, obj->total.triangles);
    obj->picture_shift = tp_area_sum_shift(larger_extent(first.s, last.s, first.t, last.t),
                                       obj->total.triangles);
}

/* -- smooth normals ------------------------------------------------------------------ */

static uint32_t find_or_add_slot(tp_obj_memory *store, uint64_t seed, uint32_t position,
                                 uint32_t group)
{
    uint32_t at = (uint32_t)tp_mix(tp_mix(seed, position), group) & store->mask;
    for (; store->table[at] != 0; at = (at + 1) & store->mask) {
        const struct tp_obj_slot *const slot = &store->slots[store->table[at] - 1];
        if (slot->position == position && slot->group == group)
            return store->table[at] - 1;
    }
    TP_ASSERT(store->n_slots < store->mask);
    store->slots[store->n_slots] =
        (struct tp_obj_slot){ .position = position, .group = group };
    store->table[at] = ++store->n_slots;
    return store->n_slots - 1;
}

/* The hash table of vertices is no longer needed and now finds slots, at
 * most one per corner. */
static void assign_normal_slots(tp_obj *obj)
{
    tp_obj_memory *const store = &obj->store;
    memset(store->table, 0, ((size_t)store->mask + 1) * sizeof *store->table);
    for (uint32_t i = 0; i < store->n_vertices; i++) {
        union tp_obj_vertex *const vertex = &store->vertices[i];
        const uint32_t normal = vertex->corner.normal;
        if ((normal & TP_NORMAL_KIND) == TP_NORMAL_GROUP)
            vertex->corner.normal = TP_NORMAL_GROUP
                | find_or_add_slot(store, obj->total.digest, vertex->corner.position,
                                   normal & ~TP_NORMAL_KIND);
    }
}

static void add_area(int64_t sum[3], tp_area area)
{
    sum[0] += area.x;
    sum[1] += area.y;
    sum[2] += area.z;
}

static void add_to_slots(tp_obj_memory *store, const tp_mesh_face *face, tp_area area)
{
    for (int k = 0; k < 3; k++) {
        const uint32_t normal = store->vertices[face->vertex[k]].corner.normal;
        if ((normal & TP_NORMAL_KIND) == TP_NORMAL_GROUP)
            add_area(store->slots[normal & ~TP_NORMAL_KIND].sum, area);
    }
}

/* -- tangents ------------------------------------------------------------------------ */

/* Returns the cross product of the normal with the axis most nearly parallel to the
 * face. */
static tp_dir3 any_tangent(tp_area normal)
{
    const tp_dir3 n = area_direction(normal);
    const int32_t x = tp_abs(n.x), y = tp_abs(n.y), z = tp_abs(n.z);
    if (x <= y && x <= z)
        return tp_normalise(0, n.z, -n.y);
    return y <= z ? tp_normalise(-n.z, 0, n.x) : tp_normalise(n.y, -n.x, 0);
}

/* Returns the tangent, the direction of growing s: with edges e and f of (ds, dt) each, T
 * (ds_e dt_f - ds_f dt_e) = e dt_f - f dt_e.  t grows downwards: a picture that is not
 * mirrored turns against the face.  Adds the area of the picture to *picture. */
static tp_packed_dir face_tangent(const tp_obj *obj, const tp_mesh_face *face, tp_vec3 e,
                                  tp_vec3 f, tp_area normal, uint64_t *picture_area_sum)
{
    const struct tp_obj_texcoord a = vertex_texcoord(&obj->store, face->vertex[0]);
    const struct tp_obj_texcoord b = vertex_texcoord(&obj->store, face->vertex[1]);
    const struct tp_obj_texcoord c = vertex_texcoord(&obj->store, face->vertex[2]);
    const int32_t dt_e = b.t - a.t, dt_f = c.t - a.t;
    const int64_t turn = tp_area_product_difference(b.s - a.s, dt_f, c.s - a.s, dt_e);
    if (turn == 0)
        return tp_dir_pack(any_tangent(normal));
    *picture_area_sum += (uint64_t)(turn < 0 ? -turn : turn) >> obj->picture_shift;
    const tp_dir3 along =
        area_direction((tp_area){ tp_area_product_difference(e.x, dt_f, f.x, dt_e),
                                  tp_area_product_difference(e.y, dt_f, f.y, dt_e),
                                  tp_area_product_difference(e.z, dt_f, f.z, dt_e) });
    if (turn > 0)
        return tp_dir_pack(along) | TP_TANGENT_MIRRORED;
    return tp_dir_pack((tp_dir3){ -along.x, -along.y, -along.z });
}

/* -- faces --------------------------------------------------------------------------- */

/* Makes a face of three vertices, unless its area is 0.  Adds its area vector to *sum. */
static void make_face(tp_obj *obj, const uint32_t vertex[3], uint32_t material,
                      int64_t area_sum[3])
{
    tp_obj_memory *const store = &obj->store;
    const tp_vec3 corner = vertex_position(store, vertex[0]);
    const tp_vec3 e = tp_vec3_sub(vertex_position(store, vertex[1]), corner);
    const tp_vec3 f = tp_vec3_sub(vertex_position(store, vertex[2]), corner);
    const tp_area exact = tp_area_cross(e, f);
    if (tp_area_is_none(exact)) {
        obj->dropped++;
        return;
    }
    TP_ASSERT(store->n_faces < obj->total.triangles);
    tp_mesh_face *const face = &store->faces[store->n_faces++];
    struct tp_obj_made *const made = &store->made[material];
    *face = (tp_mesh_face){ { vertex[0], vertex[1], vertex[2] }, 0, material };
    face->tangent = face_tangent(obj, face, e, f, exact, &made->picture);
    const tp_area area = tp_area_divide_pow2(exact, obj->area_shift);
    made->area += tp_area_length(area);
    add_area(area_sum, area);
    add_to_slots(store, face, area);
}

static void begin_triangulation(const tp_obj_memory *store, const uint32_t *corners,
                                uint32_t n)
{
    for (uint32_t i = 0; i < n; i++) {
        const tp_vec3 p = vertex_position(store, corners[i]);
        store->cut->at[0][i] = p.x;
        store->cut->at[1][i] = p.y;
        store->cut->at[2][i] = p.z;
    }
    tp_cut_begin(store->cut, n);
}

/* Makes the faces of a polygon.  Adds their area vectors to *sum. */
static void triangulate_polygon(tp_obj *obj, const struct tp_obj_polygon *polygon,
                                const uint32_t *corners, int64_t sum[3])
{
    if (polygon->corners == 3) {
        make_face(obj, corners, polygon->material, sum);
        return;
    }
    begin_triangulation(&obj->store, corners, polygon->corners);
    for (uint32_t at[3]; tp_cut_next(obj->store.cut, at);) {
        const uint32_t vertex[3] = { corners[at[0]], corners[at[1]], corners[at[2]] };
        make_face(obj, vertex, polygon->material, sum);
    }
}

/* Makes the faces of a polygon.  The vertices of a flat polygon belong to this polygon
 * alone: they get its normal at once. */
static void make_faces(tp_obj *obj, const struct tp_obj_polygon *polygon,
                       const uint32_t *corners)
{
    tp_obj_memory *const store = &obj->store;
    int64_t sum[3] = { 0, 0, 0 };
    triangulate_polygon(obj, polygon, corners, sum);
    const tp_packed_dir normal =
        tp_dir_pack(area_direction((tp_area){ sum[0], sum[1], sum[2] }));
    for (uint32_t i = 0; i < polygon->corners; i++) {
        union tp_obj_vertex *const vertex = &store->vertices[corners[i]];
        if ((vertex->corner.normal & TP_NORMAL_KIND) == TP_NORMAL_FLAT)
            vertex->corner.normal = TP_NORMAL_KNOWN | normal;
    }
}

/* -- vertices ------------------------------------------------------------------------ */

static tp_packed_dir resolve_normal(const tp_obj_memory *store, uint32_t normal)
{
    const uint32_t i = normal & ~TP_NORMAL_KIND;
    switch (normal & TP_NORMAL_KIND) {
    case TP_NORMAL_FILE:
        return store->normals[i];
    case TP_NORMAL_GROUP: {
        const int64_t *const sum = store->slots[i].sum;
        return tp_dir_pack(area_direction((tp_area){ sum[0], sum[1], sum[2] }));
    }
    default:
        return i;
    }
}

static void convert_corners_to_vertices(tp_obj_memory *store)
{
    for (uint32_t i = 0; i < store->n_vertices; i++) {
        const struct tp_obj_texcoord tex = vertex_texcoord(store, i);
        store->vertices[i].out = (tp_mesh_vertex){
            .position = vertex_position(store, i),
            .normal = resolve_normal(store, store->vertices[i].corner.normal),
            .s = tex.s, .t = tex.t };
    }
}

tp_status tp_obj_build_faces(tp_obj *obj, tp_error *err)
{
    tp_obj_memory *const store = &obj->store;
    find_bounds_and_area_shifts(obj);
    assign_normal_slots(obj);
    const uint32_t *corners = store->corners;
    for (uint32_t i = 0; i < obj->total.polygons; i++) {
        make_faces(obj, &store->polygons[i], corners);
        corners += store->polygons[i].corners;
    }
    if (store->n_faces == 0)
        return TP_FAIL(err, TP_E_OBJ_EMPTY, obj->lines.next, 0, 0);
    convert_corners_to_vertices(store);
    return TP_OK;
}
