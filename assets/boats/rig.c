/* SPDX-License-Identifier: MIT */
/* Mast, yard, square sail and ropes. The wind comes from astern: the sail bellies towards
 * the bow, most below its middle, and is held at the yard and at its lower corners. */
#include "longship.h"

#include <math.h>

static const double TURN = 6.283185307179586;
static const double MAST_Z = .25, MAST_TOP = 10.15, YARD_Y = 9.18, YARD_Z = -.02;
static const double SAIL_HEIGHT = 6.35, SAIL_HALF = 3.75;

/* A ring of `sides` points around a point of an upright or athwart axis. */
static void ring_at(vec centre, bool upright, double radius, int sides, vec *to)
{
    for (int i = 0; i < sides; i++) {
        double a = TURN * (i + .25) / sides, c = radius * cos(a), s = radius * sin(a);
        to[i] = vec_add(centre, upright ? vec_of(s, 0, c) : vec_of(0, c, s));
    }
}

static void mast(mesh *m, int sides)
{
    vec ring[3 * 8];
    ring_at(vec_of(0, .2, MAST_Z), true, .16, sides, ring);
    ring_at(vec_of(0, 5.5, MAST_Z), true, .145, sides, ring + sides);
    ring_at(vec_of(0, MAST_TOP, MAST_Z), true, .085, sides, ring + 2 * sides);
    tube_style style = { .42, .06, .12, true, false, true, 200 };
    mesh_tube(m, ring, 3, sides, style);
}

static void yard(mesh *m, int sides)
{
    static const double arm[5][2] = {
        { -4.25, .045 }, { -2.4, .09 }, { 0, .115 }, { 2.4, .09 }, { 4.25, .045 }
    };
    vec ring[5 * 8];
    for (int i = 0; i < 5; i++)
        ring_at(vec_of(arm[i][0], YARD_Y, YARD_Z), false, arm[i][1], sides,
                ring + i * sides);
    tube_style style = { .42, .31, .12, true, true, true, 201 };
    mesh_tube(m, ring, 5, sides, style);
}

/* Point of the sail: x from -1 (port) to 1, down from 0 (yard) to 1 (foot). */
static vec sail_point(double x, double down)
{
    double belly = .95 * sin(TURN * .5 * pow(down, .8)) + .42 * down;
    double across = 1.0 - .80 * x * x - .20 * x * x * x * x;
    double held = across + (1.0 - across) * .16 * sin(TURN * .5 * down);
    double foot = .50 * (1.0 - x * x) * down * down * down;
    double half = SAIL_HALF + .3 * down - .12 * sin(TURN * .5 * down);
    return vec_of(x * half, YARD_Y - .10 - SAIL_HEIGHT * down + foot,
                  YARD_Z - .12 - belly * held);
}

/* Both sides of the cloth, a finger apart and joined at the edges. Four and a half pairs of
 * stripes, so that both edges are red. */
static corner sail_corner(int i, int j, int cols, int rows, bool fore)
{
    double x = 2.0 * i / cols - 1.0, down = (double)j / rows;
    vec at = sail_point(x, down);
    bool edge = i == 0 || i == cols || j == 0 || j == rows;
    at.z += edge ? 0.0 : fore ? -.012 : .012;
    return corner_of(at, 4.5 * i / cols, 4.0 - 4.0 * down);
}

/* Both sides are divided along the same diagonals, otherwise the sides would cross. The
 * diagonals run inwards from the corners, otherwise the corner triangles of the two sides
 * would coincide. */
static void sail(mesh *m, int cols, int rows)
{
    for (int side = 0; side < 2; side++) {
        bool fore = side == 0;
        for (int k = 0; k < cols * rows; k++) {
            int i = k % cols, j = k / cols;
            corner q[4] = { sail_corner(i + 1, j + 1, cols, rows, fore),
                            sail_corner(i, j + 1, cols, rows, fore),
                            sail_corner(i, j, cols, rows, fore),
                            sail_corner(i + 1, j, cols, rows, fore) };
            int first = (2 * i >= cols) != (2 * j >= rows), turn = fore ? 1 : 3;
            mesh_quad(m, q[first], q[(first + turn) % 4], q[(first + 2) % 4],
                      q[(first + 2 + turn) % 4], 210 + side);
        }
    }
}

/* Three sides are enough for a rope, which is mostly seen as a line. */
static void rope(mesh *m, vec a, vec b, double radius, int smoothing)
{
    vec way = vec_unit(vec_sub(b, a));
    vec side =
        vec_unit(vec_cross(way, fabs(way.y) < .9 ? vec_of(0, 1, 0) : vec_of(1, 0, 0)));
    vec up = vec_cross(way, side), ring[6];
    for (int i = 0; i < 6; i++) {
        double turn = TURN * (i % 3) / 3.0;
        vec off = vec_add(vec_scale(side, radius * cos(turn)),
                          vec_scale(up, radius * sin(turn)));
        ring[i] = vec_add(i < 3 ? a : b, off);
    }
    tube_style style = { 4.0, 0.0, 1.0, true, false, false, smoothing };
    mesh_tube(m, ring, 2, 3, style);
}

static void side_ropes(mesh *m, int smoothing)
{
    vec head = vec_of(.05, MAST_TOP - .35, MAST_Z);
    for (int i = 0; i < 3; i++) {
        vec rail = hull_point(STRAKES, hull_u_at(STRAKES, .75 + .75 * i));
        rope(m, vec_add(rail, vec_of(-.03, .05, 0)), head, .018, smoothing + i);
    }
    vec clew = sail_point(1, 1), sheet = hull_point(STRAKES, hull_u_at(STRAKES, 4.6));
    vec arm = vec_of(4.2, YARD_Y, YARD_Z),
        brace = hull_point(STRAKES, hull_u_at(STRAKES, 6.6));
    rope(m, vec_add(sheet, vec_of(-.03, .06, 0)), clew, .018, smoothing + 3);
    rope(m, vec_add(brace, vec_of(-.03, .06, 0)), arm, .014, smoothing + 4);
}

void rig_build(mesh *m, ship_detail detail)
{
    const bool full = detail == FULL;
    mesh_part(m, "mast", "oak");
    mast(m, full ? 8 : 4);
    tube_style fish = { .42, .0, 1.0, false, true, true, 190 };
    if (full)
        mesh_beam(m, vec_of(0, .46, -1.1), vec_of(0, .46, 1.7), vec_of(.24, 0, 0),
                  vec_of(0, .09, 0), fish);
    mesh_part(m, "yard", "oak");
    yard(m, full ? 6 : 3);
    mesh_part(m, "sail", "sail");
    sail(m, full ? 12 : 6, full ? 9 : 5);
    mesh_part(m, "ropes", "rope");
    vec stem = vec_add(post_rabbet(BOW, STRAKES), vec_of(0, .55, .15));
    vec stern = vec_add(post_rabbet(STERN, STRAKES), vec_of(0, .55, -.15));
    rope(m, stem, vec_of(0, MAST_TOP - .25, MAST_Z), .020, 220);
    rope(m, stern, vec_of(0, MAST_TOP - .25, MAST_Z), .020, 221);
    for (int side = 0; side < 2; side++) {
        m->mirror = side == 1;
        side_ropes(m, 222);
    }
    m->mirror = false;
}

void rig_build_low(mesh *m)
{
    vec ring[6];
    mesh_part(m, "mast", "oak");
    ring_at(vec_of(0, .2, MAST_Z), true, .2, 3, ring);
    ring_at(vec_of(0, MAST_TOP, MAST_Z), true, .12, 3, ring + 3);
    tube_style upright = { .42, .06, .12, true, false, false, 200 };
    mesh_tube(m, ring, 2, 3, upright);
    ring_at(vec_of(-4.2, YARD_Y, YARD_Z), false, .11, 3, ring);
    ring_at(vec_of(4.2, YARD_Y, YARD_Z), false, .11, 3, ring + 3);
    tube_style athwart = { .42, .31, .12, true, false, false, 201 };
    mesh_tube(m, ring, 2, 3, athwart);
    mesh_part(m, "sail", "sail");
    sail(m, 3, 2);
}
