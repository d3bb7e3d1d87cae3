/* SPDX-License-Identifier: MIT */
/* Reads OBJ and MTL texts as a port would, in the way most likely to reveal faults: every
 * piece of text is a heap block of exact size, freed after the call, and the mesh memory
 * has exactly the required size and is filled with 0xA5. */
#ifndef TP_TESTS_LIB_MESHES_H
#define TP_TESTS_LIB_MESHES_H
#include <stdlib.h>
#include <string.h>
#include "mesh/obj.h"
#include "mesh/mesh.h"
#include "tests/lib/random.h"

#define OBJ_TRIANGLE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

typedef struct {
    tp_obj   obj;
    tp_error err;
    tp_mesh  mesh;
    void    *mem;               /* NULL until loading begins */
    uint32_t warnings;          /* count over all steps, and the first warning */
    tp_error warned;
} obj_reader;

typedef tp_status feeder(tp_obj *obj, const void *text, size_t bytes, tp_error *err);

static inline tp_status feed_pieces(feeder *feed, tp_obj *obj, const char *text,
                                    size_t bytes, size_t piece, tp_error *err)
{
    tp_status status = TP_OK;
    for (size_t i = 0; i < bytes && status == TP_OK; i += piece) {
        const size_t n = bytes - i < piece ? bytes - i : piece;
        char *const copy = malloc(n);
        memcpy(copy, text + i, n);
        status = feed(obj, copy, n, err);
        free(copy);
    }
    return status;
}

static inline tp_status scan_text(obj_reader *r, const char *text, size_t bytes,
                                  size_t piece)
{
    memset(r, 0xA5, sizeof *r);
    r->err.code = r->warned.code = TP_OK;
    r->mem = NULL;
    r->warnings = 0;
    tp_obj_begin_count(&r->obj);
    tp_status status = feed_pieces(tp_obj_feed, &r->obj, text, bytes, piece, &r->err);
    return status != TP_OK ? status : tp_obj_end_count(&r->obj, &r->err);
}

static inline tp_status load_text(obj_reader *r, const char *text, size_t bytes,
                                  size_t piece)
{
    r->mem = malloc(tp_obj_memory_bytes(&r->obj));
    memset(r->mem, 0xA5, tp_obj_memory_bytes(&r->obj));
    tp_obj_begin_load(&r->obj, r->mem);
    tp_status status = feed_pieces(tp_obj_feed, &r->obj, text, bytes, piece, &r->err);
    return status != TP_OK ? status : tp_obj_end_load(&r->obj, &r->err);
}

/* Adds the warnings of the step that has just ended. */
static inline void note_warnings(obj_reader *r)
{
    if (r->warnings == 0 && r->obj.warnings > 0)
        r->warned = r->obj.warning[0];
    r->warnings += r->obj.warnings;
}

/* Runs both passes.  Every library that the file names reads `mtl`, if `mtl` is not
 * NULL. */
static inline tp_status read_bytes(obj_reader *r, const char *text, size_t bytes,
                                   const char *mtl, size_t mtl_bytes, size_t piece)
{
    tp_status status = scan_text(r, text, bytes, piece);
    if (status == TP_OK)
        status = load_text(r, text, bytes, piece);
    if (status == TP_OK)
        note_warnings(r);
    for (uint32_t i = 0; mtl && status == TP_OK && i < r->obj.libraries; i++) {
        tp_mtl_begin(&r->obj, i);
        status = feed_pieces(tp_mtl_feed, &r->obj, mtl, mtl_bytes, piece, &r->err);
        if (status == TP_OK)
            status = tp_mtl_end(&r->obj, &r->err);
        if (status == TP_OK)
            note_warnings(r);
    }
    if (status == TP_OK)
        status = tp_obj_finish(&r->obj, NULL, &r->mesh, &r->err);
    if (status == TP_OK)
        note_warnings(r);
    return status;
}

static inline tp_status read_text(obj_reader *r, const char *text, const char *mtl)
{
    return read_bytes(r, text, strlen(text), mtl, mtl ? strlen(mtl) : 0, 4096);
}

static inline void finish(obj_reader *r)
{
    free(r->mem);
    r->mem = NULL;
}

/* 32 random bits. */
static inline uint32_t next_random(uint64_t *state)
{
    return (uint32_t)(random_next(state) >> 32);
}

/* Reads a text that must be accepted. */
static inline void accept_text(obj_reader *r, const char *text)
{
    if (read_text(r, text, NULL) != TP_OK) {
        char what[200];
        tp_error_text(&r->err, what, sizeof what);
        fail_msg("line %u: %s", (unsigned)r->err.where, what);
    }
}

/* -- triangulation ------------------------------------------------------------------- */

/* Triangulates polygons in memory of exact size, filled with 0xA5 before, and checks
 * that the triangles cover an outline exactly once and cover nothing outside.  The
 * check: every triangle has the orientation of the polygon, and the triangles' edges
 * are the polygon's edges after each pair of opposite edges cancels.  Then the number
 * of triangles over any point equals the winding number of the outline around the
 * point. */

typedef struct { int32_t u, v; } point;

typedef struct {
    void     *block;
    uint32_t (*triangle)[3];
    uint32_t  count;
    uint64_t  steps;            /* steps left at the end */
} cutting;

/* Returns twice the signed area of the triangle a, b, c.  Coordinates are within +-2^29. */
static inline int64_t turn(point a, point b, point c)
{
    return ((int64_t)b.u - a.u) * ((int64_t)c.v - a.v)
         - ((int64_t)b.v - a.v) * ((int64_t)c.u - a.u);
}

static inline int64_t area_of(const point *p, int n)
{
    int64_t sum = 0;
    for (int i = 2; i < n; i++)
        sum += turn(p[0], p[i - 1], p[i]);
    return sum;
}

static inline struct tp_obj_cut *layout_cut(cutting *c, int n)
{
    tp_arena count = tp_arena_init(NULL, 0);
    tp_cut_layout(&count, (uint32_t)n);
    c->block = malloc(count.used);
    memset(c->block, 0xA5, count.used);
    tp_arena arena = tp_arena_init(c->block, count.used);
    struct tp_obj_cut *const cut = tp_cut_layout(&arena, (uint32_t)n);
    assert_false(arena.failed);
    return cut;
}

/* Triangulates a polygon; the caller has stored the coordinates. */
static inline void run_cut(cutting *c, struct tp_obj_cut *cut, int n)
{
    c->triangle = malloc((size_t)n * sizeof *c->triangle);
    c->count = 0;
    tp_cut_begin(cut, (uint32_t)n);
    while (c->count < (uint32_t)n && tp_cut_next(cut, c->triangle[c->count]))
        c->count++;
    assert_int_equal(c->count, n - 2);
    c->steps = cut->steps;
}

/* Places the polygon in one of six planes and triangulates: three planes are square to an
 * axis, three are oblique, and a projection along a different axis has their largest
 * area. */
static inline cutting cut_in_plane(const point *p, int n, int plane)
{
    cutting c;
    struct tp_obj_cut *const cut = layout_cut(&c, n);
    for (int i = 0; i < n; i++) {
        const int32_t out = plane < 3 ? 77 : p[i].u + 2 * p[i].v;
        cut->at[plane % 3][i] = p[i].u;
        cut->at[(plane + 1) % 3][i] = p[i].v;
        cut->at[(plane + 2) % 3][i] = out;
    }
    run_cut(&c, cut, n);
    return c;
}

static inline void free_cut(cutting *c)
{
    free(c->triangle);
    free(c->block);
}

/* An edge: its two ends, the smaller index first, and the number of upward runs minus
 * downward runs. */
typedef struct { uint32_t a, b; int32_t runs; } cut_edge;

static inline int compare_edges(const void *left, const void *right)
{
    const cut_edge *const x = left, *const y = right;
    return x->a != y->a ? x->a < y->a ? -1 : 1 : x->b != y->b ? x->b < y->b ? -1 : 1 : 0;
}

static inline cut_edge edge_of(uint32_t a, uint32_t b, int32_t runs)
{
    return a < b ? (cut_edge){ a, b, runs } : (cut_edge){ b, a, -runs };
}

/* Asserts that the triangles' edges minus the n edges of the outline cancel. */
static inline void assert_edges(const cutting *c, int corners)
{
    const uint32_t n = (uint32_t)corners;
    const size_t count = 3 * (size_t)c->count + n;
    cut_edge *const edge = malloc(count * sizeof *edge);
    size_t m = 0;
    for (uint32_t i = 0; i < c->count; i++)
        for (int k = 0; k < 3; k++) {
            const uint32_t a = c->triangle[i][k], b = c->triangle[i][(k + 1) % 3];
            assert_true(a < n && b < n && a != b);
            edge[m++] = edge_of(a, b, 1);
        }
    for (uint32_t i = 0; i < n; i++)
        edge[m++] = edge_of(i, (i + 1) % n, -1);
    qsort(edge, m, sizeof *edge, compare_edges);
    for (size_t i = 0, next; i < m; i = next) {
        int32_t runs = 0;
        for (next = i; next < m && compare_edges(&edge[next], &edge[i]) == 0; next++)
            runs += edge[next].runs;
        assert_int_equal(runs, 0);
    }
    free(edge);
}

/* Asserts exact cover.  `simple` is true if the outline does not touch itself; then every
 * triangle has a positive area. */
static inline void assert_covered(const cutting *c, const point *p, int n, bool simple)
{
    const int64_t whole = area_of(p, n);
    int64_t sum = 0;
    assert_edges(c, n);
    for (uint32_t i = 0; i < c->count; i++) {
        const uint32_t *const t = c->triangle[i];
        const int64_t area = turn(p[t[0]], p[t[1]], p[t[2]]);
        assert_true(whole > 0 ? area >= 0 : area <= 0);
        assert_true(area != 0 || !simple);
        sum += area;
    }
    assert_true(sum == whole);
}

static inline void assert_cut(const point *p, int n, int plane, bool simple)
{
    cutting c = cut_in_plane(p, n, plane);
    assert_covered(&c, p, n, simple);
    free_cut(&c);
}

/* -- outlines with many reflex corners in a row, or few ears ------------------------- */

static inline int make_comb(point *p, int teeth)
{
    int n = 0;
    for (int i = 0; i < teeth; i++) {
        p[n++] = (point){ 4 * i, 0 };
        p[n++] = (point){ 4 * i + 2, i % 3 };
        p[n++] = (point){ 4 * i + 3, 100 + i % 5 };
    }
    p[n++] = (point){ 4 * teeth, 0 };
    p[n++] = (point){ 4 * teeth, -10 };
    p[n++] = (point){ 0, -10 };
    return n;
}

static inline int make_spiral(point *p, int half)
{
    static const point step[4] = { {1,0}, {0,1}, {-1,0}, {0,-1} };
    for (int i = 0; i < half; i++) {        /* out along the inner side */
        const point *const d = &step[i % 4], *const e = &step[(i + 1) % 4];
        const int32_t r = 4 * (i + 4);
        p[i] = (point){ d->u * r - e->u * (r - 4), d->v * r - e->v * (r - 4) };
        p[2 * half - 1 - i] = (point){ p[i].u + d->u - e->u, p[i].v + d->v - e->v };
    }
    return 2 * half;
}

/* Makes a star polygon: corners sorted by angle around the origin.  Directions lie on a
 * square, without floating point. */
static inline int make_star(point *p, int n, uint64_t *random, uint32_t reach)
{
    for (int i = 0; i < n; i++) {
        const int32_t along = (int32_t)((int64_t)i * 8 * 4096 / n), side = along / 8192;
        const int32_t a = 4096 - along % 8192;
        const point d = side == 0 ? (point){ 4096, -a } : side == 1 ? (point){ a, 4096 }
                      : side == 2 ? (point){ -4096, a } : (point){ -a, -4096 };
        const int64_t r = 1 + next_random(random) % reach;
        p[i] = (point){ (int32_t)(d.u * r), (int32_t)(d.v * r) };
    }
    return n;
}
#endif
