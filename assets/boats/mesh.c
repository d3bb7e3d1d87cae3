/* SPDX-License-Identifier: MIT */
/* See mesh.h. */
#include "mesh.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- vectors ------------------------------------------------------------------------- */

vec vec_of(double x, double y, double z)
{
    vec v = { x, y, z };
    return v;
}

vec vec_add(vec a, vec b)
{
    return vec_of(a.x + b.x, a.y + b.y, a.z + b.z);
}

vec vec_sub(vec a, vec b)
{
    return vec_of(a.x - b.x, a.y - b.y, a.z - b.z);
}

vec vec_scale(vec a, double by)
{
    return vec_of(a.x * by, a.y * by, a.z * by);
}

vec vec_mix(vec a, vec b, double t)
{
    return vec_of(mix(a.x, b.x, t), mix(a.y, b.y, t), mix(a.z, b.z, t));
}

vec vec_cross(vec a, vec b)
{
    return vec_of(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

double vec_length(vec a)
{
    return sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

vec vec_unit(vec a)
{
    return vec_scale(a, 1.0 / vec_length(a));
}

double mix(double a, double b, double t)
{
    return a + (b - a) * t;
}

double smooth(double t)
{
    t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
    return t * t * (3.0 - 2.0 * t);
}

corner corner_of(vec at, double s, double t)
{
    corner c = { at, { s, t } };
    return c;
}

/* -- collecting ---------------------------------------------------------------------- */

static void fail(const char *what)
{
    fprintf(stderr, "longship: %s\n", what);
    exit(3);
}

/* Converts to ten-thousandths. The rounding borders lie at .4863 instead of .5, where no
 * decimal written by hand falls; the sign is handled separately, so both sides of the boat
 * are equal. */
static int32_t units(double v)
{
    double scaled = fabs(v) * 10000.0 + 0.5137, whole = floor(scaled);
    if (scaled - whole < 1e-6 || whole + 1.0 - scaled < 1e-6)
        fail("a coordinate lies on a rounding border: change a measure a little");
    return (int32_t)(v < 0.0 ? -whole : whole);
}

void mesh_part(mesh *m, const char *group, const char *material)
{
    if (m->runs == MESH_RUNS)
        fail("too many parts");
    m->run[m->runs].group = group;
    m->run[m->runs].material = material;
    m->run[m->runs++].first = m->faces;
}

static mesh_corner rounded(const mesh *m, const corner *c)
{
    mesh_corner r = { { units(c->at.x), units(c->at.y), units(c->at.z) },
                      { units(c->map.s), units(c->map.t) },
                      { 0.0, 0.0, 0.0 } };
    if (m->mirror)
        r.at[0] = -r.at[0];
    return r;
}

static vec way_between(const mesh_corner *from, const mesh_corner *to)
{
    return vec_of(to->at[0] - from->at[0], to->at[1] - from->at[1],
                  to->at[2] - from->at[2]);
}

/* True if the triangle has no area. The test is exact: products of distances within 30 m,
 * in units, stay below 2^53. */
static bool is_flat(const mesh_face *f)
{
    vec cross = vec_cross(way_between(&f->corner[0], &f->corner[1]),
                          way_between(&f->corner[0], &f->corner[2]));
    return vec_length(cross) == 0.0;
}

void mesh_triangle(mesh *m, corner a, corner b, corner c, int smoothing)
{
    if (m->faces == MESH_FACES)
        fail("too many triangles");
    mesh_face *f = &m->face[m->faces];
    f->corner[0] = rounded(m, &a);
    f->corner[1] = rounded(m, m->mirror ? &c : &b);
    f->corner[2] = rounded(m, m->mirror ? &b : &c);
    f->smoothing = smoothing;
    if (!is_flat(f))
        m->faces++;
}

void mesh_quad(mesh *m, corner a, corner b, corner c, corner d, int smoothing)
{
    mesh_triangle(m, a, b, c, smoothing);
    mesh_triangle(m, a, c, d, smoothing);
}

/* -- tubes --------------------------------------------------------------------------- */

static vec ring_centre(const vec *ring, int sides)
{
    vec sum = vec_of(0.0, 0.0, 0.0);
    for (int i = 0; i < sides; i++)
        sum = vec_add(sum, ring[i]);
    return vec_scale(sum, 1.0 / sides);
}

/* Closes a ring by a fan with a flat mapping: s and t from the position in the ring's own
 * directions. */
static void close_ring(mesh *m, const vec *ring, int sides, bool first, tube_style style)
{
    vec centre = ring_centre(ring, sides);
    double span = style.t_span;
    for (int i = 1; i + 1 < sides; i++) {
        int pick[3] = { 0, first ? i + 1 : i, first ? i : i + 1 };
        corner c[3];
        for (int k = 0; k < 3; k++) {
            vec off = vec_sub(ring[pick[k]], centre);
            c[k] = corner_of(ring[pick[k]], (off.x + off.z) * style.per_metre,
                             style.t0 + span * 0.5
                                 + (off.y - off.x) * style.per_metre * 0.5);
        }
        mesh_triangle(m, c[0], c[1], c[2], 0);
    }
}

static void tube_segment(mesh *m, const vec *a, const vec *b, int sides, double s0,
                         double s1, tube_style style)
{
    for (int i = 0; i < sides; i++) {
        int j = (i + 1) % sides;
        double t0 = style.t0 + style.t_span * i / sides;
        double t1 = style.t0 + style.t_span * (i + 1) / sides;
        mesh_quad(m, corner_of(a[i], s0, t0), corner_of(a[j], s0, t1),
                  corner_of(b[j], s1, t1), corner_of(b[i], s1, t0),
                  style.smoothing + (style.round ? 0 : i));
    }
}

void mesh_tube(mesh *m, const vec *ring, int rings, int sides, tube_style style)
{
    double s = 0.0;
    if (style.close_first)
        close_ring(m, ring, sides, true, style);
    for (int r = 0; r + 1 < rings; r++) {
        const vec *a = ring + r * sides, *b = a + sides;
        double way = vec_length(vec_sub(ring_centre(b, sides), ring_centre(a, sides)));
        double next = s + way * style.per_metre;
        tube_segment(m, a, b, sides, s, next, style);
        s = next;
    }
    if (style.close_last)
        close_ring(m, ring + (rings - 1) * sides, sides, false, style);
}

void mesh_beam(mesh *m, vec a, vec b, vec across, vec up, tube_style style)
{
    vec ring[8];
    for (int end = 0; end < 2; end++) {
        vec c = end == 0 ? a : b;
        vec *r = ring + 4 * end;
        r[0] = vec_sub(vec_add(c, across), up);
        r[1] = vec_add(vec_add(c, across), up);
        r[2] = vec_add(vec_sub(c, across), up);
        r[3] = vec_sub(vec_sub(c, across), up);
    }
    mesh_tube(m, ring, 2, 4, style);
}

/* -- normals ------------------------------------------------------------------------- */

static bool same_at(const mesh_corner *a, const mesh_corner *b)
{
    return memcmp(a->at, b->at, sizeof a->at) == 0;
}

/* The face's unit normal times its angle at corner k: a side then counts the same for each
 * division into triangles. */
static vec corner_share(const mesh_face *f, int k)
{
    vec a = way_between(&f->corner[k], &f->corner[(k + 1) % 3]);
    vec b = way_between(&f->corner[k], &f->corner[(k + 2) % 3]);
    vec cross = vec_cross(a, b);
    double size = vec_length(cross);
    return vec_scale(cross, atan2(size, a.x * b.x + a.y * b.y + a.z * b.z) / size);
}

static void share_corner(mesh *m, const mesh_face *f, int k)
{
    vec share = corner_share(f, k);
    for (int i = 0; i < 3 * m->faces; i++) {
        mesh_face *g = &m->face[i / 3];
        mesh_corner *c = &g->corner[i % 3];
        bool together = f->smoothing != 0 && g->smoothing == f->smoothing;
        if ((g == f && i % 3 == k) || (g != f && together && same_at(c, &f->corner[k])))
            c->normal = vec_add(c->normal, share);
    }
}

static void smooth_normals(mesh *m)
{
    for (int i = 0; i < 3 * m->faces; i++)
        share_corner(m, &m->face[i / 3], i % 3);
}

/* -- text ---------------------------------------------------------------------------- */

/* Distinct rows of up to three numbers, numbered from 1 in the order of first use. */
typedef struct {
    int count;
    int32_t row[3 * MESH_FACES][3];
} table;

static int table_index(table *t, int32_t a, int32_t b, int32_t c)
{
    for (int i = 0; i < t->count; i++) {
        if (t->row[i][0] == a && t->row[i][1] == b && t->row[i][2] == c)
            return i + 1;
    }
    t->row[t->count][0] = a;
    t->row[t->count][1] = b;
    t->row[t->count][2] = c;
    return ++t->count;
}

static void normal_units(const mesh_corner *c, int32_t n[3])
{
    vec unit = vec_unit(c->normal);
    n[0] = units(unit.x);
    n[1] = units(unit.y);
    n[2] = units(unit.z);
}

static void print_units(FILE *file, int32_t v)
{
    int32_t size = v < 0 ? -v : v;
    char tail[8];
    snprintf(tail, sizeof tail, ".%04d", (int)(size % 10000));
    for (size_t end = 4; end > 0 && tail[end] == '0'; end--)
        tail[end] = '\0';
    fprintf(file, " %s%d%s", v < 0 ? "-" : "", (int)(size / 10000),
            tail[1] == '\0' ? "" : tail);
}

static void print_table(FILE *file, const char *what, const table *t, int width)
{
    for (int i = 0; i < t->count; i++) {
        fputs(what, file);
        for (int k = 0; k < width; k++)
            print_units(file, t->row[i][k]);
        fputc('\n', file);
    }
}

typedef struct {
    int at, map, normal;
} index3;

static void print_faces(FILE *file, const mesh *m, const index3 *index)
{
    int run = 0, smoothing = -1;
    for (int i = 0; i < m->faces; i++) {
        for (; run < m->runs && m->run[run].first <= i; run++) {
            if (run + 1 == m->runs || m->run[run + 1].first > i)
                fprintf(file, "g %s\nusemtl %s\n", m->run[run].group,
                        m->run[run].material);
        }
        if (m->face[i].smoothing != smoothing) {
            smoothing = m->face[i].smoothing;
            if (smoothing == 0)
                fputs("s off\n", file);
            else
                fprintf(file, "s %d\n", smoothing);
        }
        fputs("f", file);
        for (const index3 *c = index + 3 * i; c < index + 3 * i + 3; c++)
            fprintf(file, " %d/%d/%d", c->at, c->map, c->normal);
        fputc('\n', file);
    }
}

void mesh_write(mesh *m, const char *dir, const char *name, const char *library)
{
    static table at, map, normal;
    static index3 index[3 * MESH_FACES];
    at.count = map.count = normal.count = 0;
    smooth_normals(m);
    for (int i = 0; i < 3 * m->faces; i++) {
        const mesh_corner *c = &m->face[i / 3].corner[i % 3];
        int32_t n[3];
        normal_units(c, n);
        index[i].at = table_index(&at, c->at[0], c->at[1], c->at[2]);
        index[i].map = table_index(&map, c->map[0], c->map[1], 0);
        index[i].normal = table_index(&normal, n[0], n[1], n[2]);
    }
    char path[1024];
    int length = snprintf(path, sizeof path, "%s/%s", dir, name);
    FILE *file = length < (int)sizeof path ? fopen(path, "wb") : NULL;
    if (file == NULL)
        fail("the mesh cannot be written");
    fprintf(file,
            "# SPDX-License-Identifier: CC0-1.0\n"
            "# Written by longship.c.  Metres, y up, bow towards -z, origin amidships\n"
            "# at the waterline; %d triangles.\nmtllib %s\n",
            m->faces, library);
    print_table(file, "v", &at, 3);
    print_table(file, "vt", &map, 2);
    print_table(file, "vn", &normal, 3);
    print_faces(file, m, index);
    if (fclose(file) != 0)
        fail("the mesh cannot be written");
    printf("%s: %d triangles\n", name, m->faces);
}
