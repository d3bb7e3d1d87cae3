/* SPDX-License-Identifier: MIT */
/* Collects triangles and writes a Wavefront OBJ.
 *
 * Lengths are metres, rounded on entry to 1/10000 m; positions are integers from there on,
 * so positions that should meet do meet. A triangle without area after the rounding is left
 * out. The text must be equal on all machines although their sin() may differ in the last
 * bit: a number within 1e-6 of a rounding border ends the program, and the borders lie away
 * from round numbers. */
#ifndef MESH_H
#define MESH_H
#include <stdbool.h>
#include <stdint.h>

#define MESH_FACES 8192
#define MESH_RUNS  256

typedef struct {
    double x, y, z;
} vec;
typedef struct {
    double s, t;
} uv;
typedef struct {
    vec at;
    uv map;
} corner;

vec vec_of(double x, double y, double z);
vec vec_add(vec a, vec b);
vec vec_sub(vec a, vec b);
vec vec_scale(vec a, double by);
vec vec_mix(vec a, vec b, double t);
vec vec_cross(vec a, vec b);
double vec_length(vec a);
vec vec_unit(vec a);
double mix(double a, double b, double t);
double smooth(double t); /* 3t^2 - 2t^3, clamped to 0..1 */
corner corner_of(vec at, double s, double t);

typedef struct {
    int32_t at[3], map[2]; /* 1/10000 */
    vec normal;            /* sum over its smoothing number's faces, not unit */
} mesh_corner;

typedef struct {
    mesh_corner corner[3];
    int smoothing;
} mesh_face;
typedef struct {
    const char *group, *material;
    int first;
} mesh_run;

typedef struct {
    int faces, runs;
    bool mirror; /* put the following parts on the other side: x = -x */
    mesh_face face[MESH_FACES];
    mesh_run run[MESH_RUNS];
} mesh;

/* The following triangles belong to the group and have the material. */
void mesh_part(mesh *m, const char *group, const char *material);

/* Adds a triangle with corners counter-clockwise from outside. Corners at one place share a
 * normal if their smoothing numbers are equal and not 0. */
void mesh_triangle(mesh *m, corner a, corner b, corner c, int smoothing);
void mesh_quad(mesh *m, corner a, corner b, corner c, corner d, int smoothing);

/* A tube through `rings` rings of `sides` points, each right-handed about the direction
 * from ring to ring. The grain runs along the tube: s is the distance in metres times
 * `per_metre`, t goes once around from t0 by t_span. Round tubes are smooth all around,
 * other tubes only along; either end may be closed. */
typedef struct {
    double per_metre, t0, t_span;
    bool round, close_first, close_last;
    int smoothing; /* if not round: this number and the next `sides` numbers */
} tube_style;

void mesh_tube(mesh *m, const vec *ring, int rings, int sides, tube_style style);

/* A straight box from `a` to `b`; `across` and `up` are half its sides, perpendicular to
 * its axis, and across x up points from a to b. */
void mesh_beam(mesh *m, vec a, vec b, vec across, vec up, tube_style style);

/* Computes the normals, writes DIR/NAME and prints the number of triangles. */
void mesh_write(mesh *m, const char *dir, const char *name, const char *library);
#endif
