/* SPDX-License-Identifier: MIT */
/* Keel, stem and stern posts: one timber that rises to a dragon's head at the bow and coils
 * into a tail at the stern.
 *
 * The centre line of a post is defined by its heading: an angle at some lengths along the
 * line, eased between them and walked in small steps. The curvature is then easy to shape
 * and has no kinks. (d, y) are metres outboard along the keel and up. */
#include "longship.h"

#include <math.h>

static const double TURN = 6.283185307179586;
static const double KEEL_END = 5.4, KEEL_Y = -.765;

typedef struct {
    double s, degrees;
} heading_key;
typedef struct {
    double d, y, angle;
} path_point;

static const heading_key bow_keys[] = {
    { 0, 0 },     { 1.4, 7 },  { 2.8, 27 },  { 4.2, 58 }, { 5.4, 79 }, { 6.4, 93 },
    { 7.2, 101 }, { 7.6, 92 }, { 7.95, 58 }, { 8.2, 30 }, { 9, 20 },
};
static const heading_key stern_keys[] = {
    { 0, 0 },     { 1.4, 7 },   { 2.8, 27 },  { 4.2, 58 },  { 5.4, 79 },   { 6.4, 92 },
    { 7.2, 108 }, { 8.0, 165 }, { 8.8, 232 }, { 9.6, 330 }, { 10.3, 450 }, { 10.95, 610 },
};

static double heading_at(ship_end end, double s)
{
    const heading_key *k = end == BOW ? bow_keys : stern_keys;
    int last =
        (int)(end == BOW ? sizeof bow_keys / sizeof *k : sizeof stern_keys / sizeof *k);
    int i = 0;
    while (i < last - 2 && k[i + 1].s < s)
        i++;
    double t = (s - k[i].s) / (k[i + 1].s - k[i].s);
    double before = i > 0 ? k[i - 1].degrees : k[i].degrees;
    double after = i + 2 < last ? k[i + 2].degrees : k[i + 1].degrees;
    double m0 =
        (k[i + 1].degrees - before) / (k[i + 1].s - (i > 0 ? k[i - 1].s : k[i].s));
    double m1 =
        (after - k[i].degrees) / ((i + 2 < last ? k[i + 2].s : k[i + 1].s) - k[i].s);
    double span = k[i + 1].s - k[i].s;
    double ease = mix(k[i].degrees, k[i + 1].degrees, t * t * (3.0 - 2.0 * t));
    double bend = t * (1.0 - t) * ((1.0 - t) * m0 - t * m1) * span;
    return (ease + bend) * TURN / 360.0;
}

static path_point path_at(ship_end end, double s)
{
    enum { STEPS = 256 };
    path_point p = { KEEL_END, KEEL_Y, heading_at(end, s) };
    for (int i = 0; i < STEPS; i++) {
        double angle = heading_at(end, s * (i + .5) / STEPS);
        p.d += cos(angle) * s / STEPS;
        p.y += sin(angle) * s / STEPS;
    }
    return p;
}

static vec to_ship(ship_end end, double x, double d, double y)
{
    return vec_of(x, y, end == BOW ? -d : d);
}

vec post_rabbet(ship_end end, double edge)
{
    path_point p = path_at(end, mix(2.15, 5.7, edge / STRAKES));
    return to_ship(end, 0.0, p.d - .02 * sin(p.angle), p.y + .02 * cos(p.angle));
}

/* -- timbers ------------------------------------------------------------------------- */

/* One ring: n inboard from the centre line, x to the side, in an order that is right-handed
 * about the direction outboard. */
static void put_ring(ship_end end, path_point p, double (*nx)[2], int sides, vec *to)
{
    for (int i = 0; i < sides; i++) {
        double n = nx[i][0], x = end == BOW ? nx[i][1] : -nx[i][1];
        to[i] = to_ship(end, x, p.d - n * sin(p.angle), p.y + n * cos(p.angle));
    }
}

enum { POST_SIDES = 6, RINGS_MAX = 40 };

/* Cross section of a post: flat inboard, widest in the middle, narrow at the cutwater. */
static void post_ring(ship_end end, double s, double depth, double width, vec *to)
{
    double nx[POST_SIDES][2] = {
        { depth * .5, -width * .42 }, { depth * .5, width * .42 },   { 0, width * .5 },
        { -depth * .5, width * .24 }, { -depth * .5, -width * .24 }, { 0, -width * .5 },
    };
    put_ring(end, path_at(end, s), nx, POST_SIDES, to);
}

static double post_depth(ship_end end, double s)
{
    double grown = mix(.22, .36, smooth(s / 4.5));
    return end == BOW ? mix(grown, .29, smooth((s - 5.5) / 2.2))
                      : mix(grown, .07, smooth((s - 5.5) / 5.4));
}

static double post_width(ship_end end, double s)
{
    return end == BOW ? mix(.165, .21, smooth((s - 6.2) / 1.6))
                      : mix(.165, .10, smooth((s - 6.0) / 4.6));
}

static void post(mesh *m, ship_end end, const double *at, int rings, int smoothing)
{
    static vec ring[RINGS_MAX * POST_SIDES];
    for (int i = 0; i < rings; i++)
        post_ring(end, at[i], post_depth(end, at[i]), post_width(end, at[i]),
                  ring + i * POST_SIDES);
    tube_style style = { .9, -1.0 / 6.0, 2.0, false, false, true, smoothing };
    mesh_tube(m, ring, rings, POST_SIDES, style);
}

static void keel(mesh *m)
{
    tube_style style = { .4, .0, 1.0, false, true, true, 120 };
    mesh_beam(m, vec_of(0, KEEL_Y, -KEEL_END - .05), vec_of(0, KEEL_Y, KEEL_END + .05),
              vec_of(.08, 0, 0), vec_of(0, .11, 0), style);
}

/* -- the dragon ---------------------------------------------------------------------- */

enum { HEAD_SIDES = 8 };

static const double HEAD = 1.3; /* head length, m; the sizes below are for 1 m */

typedef struct {
    double f, v, degrees, wide, up, down;
} head_key;

/* f forward and v up from the neck's end, then the half axes of an oval. */
static const head_key skull[] = {
    { -.06, -.05, 42, .105, .145, .145 }, { .10, .09, 26, .150, .170, .150 },
    { .29, .155, 6, .160, .165, .115 },   { .43, .125, -12, .115, .105, .085 },
    { .62, .080, -6, .095, .080, .065 },  { .79, .110, 16, .110, .105, .065 },
    { .90, .165, 40, .075, .080, .055 },
};
static const head_key jaw[] = {
    { .06, -.015, -25, .110, .070, .110 },
    { .30, -.105, -20, .095, .045, .075 },
    { .54, -.175, -8, .075, .035, .055 },
    { .72, -.170, 18, .055, .030, .045 },
};

static void oval(path_point neck, const head_key *k, int sides, vec *to)
{
    double nx[HEAD_SIDES][2];
    for (int i = 0; i < sides; i++) {
        double around = TURN * (i + .5) / sides, c = cos(around);
        nx[i][0] = HEAD * c * (c > 0.0 ? k->up : k->down);
        nx[i][1] = HEAD * sin(around) * k->wide;
    }
    path_point p = { neck.d + HEAD * k->f, neck.y + HEAD * k->v,
                     k->degrees * TURN / 360.0 };
    put_ring(BOW, p, nx, sides, to);
}

static void head_part(mesh *m, path_point neck, const head_key *k, int keys, int sides,
                      int smoothing)
{
    vec ring[8 * HEAD_SIDES];
    for (int i = 0; i < keys; i++)
        oval(neck, k + i, sides, ring + i * sides);
    tube_style style = { .42, .05, .15, true, true, true, smoothing };
    mesh_tube(m, ring, keys, sides, style);
}

/* A spike over a base of four corners, right-handed about the direction to the tip. */
static void spike(mesh *m, const vec *base, vec tip)
{
    for (int i = 0; i < 4; i++) {
        int j = (i + 1) % 4;
        mesh_triangle(m, corner_of(base[i], 0, .3), corner_of(base[j], .1, .3),
                      corner_of(tip, .05, .45), 0);
    }
}

/* Spikes of the mane, or every `step`-th: lengthwise plates on the neck's inboard side. */
static void mane(mesh *m, int step)
{
    for (int i = 0; i < 8; i += step) {
        double s = 6.15 + .235 * i, depth = post_depth(BOW, s) * .5 - .03;
        path_point a = path_at(BOW, s), b = path_at(BOW, s + .20);
        double foot[4][2] = {
            { depth, -.035 }, { depth, .035 }, { depth, .035 }, { depth, -.035 }
        };
        vec base[4], first[4], second[4];
        put_ring(BOW, a, foot, 4, first);
        put_ring(BOW, b, foot, 4, second);
        base[0] = first[0];
        base[1] = first[1];
        base[2] = second[1];
        base[3] = second[0];
        double height = .13 + .012 * i;
        path_point top = path_at(BOW, s - .04);
        spike(m, base,
              to_ship(BOW, 0.0, top.d - (depth + height) * sin(top.angle),
                      top.y + (depth + height) * cos(top.angle)));
    }
}

/* A horn: a cone of rings on the head's starboard side; the mirror makes the other horn. */
static void horn(mesh *m, path_point neck)
{
    static const double line[4][5] = {
        /* f, v, x, radius, degrees */
        { .20, .22, .080, .055, 100 },
        { .12, .38, .125, .045, 125 },
        { -.03, .46, .155, .030, 165 },
        { -.20, .44, .170, .006, 195 },
    };
    vec ring[16];
    for (int i = 0; i < 4; i++) {
        const double *k = line[i];
        double x = HEAD * k[2], r = HEAD * k[3];
        double nx[4][2] = { { r, x }, { 0, x + r }, { -r, x }, { 0, x - r } };
        path_point p = { neck.d + HEAD * k[0], neck.y + HEAD * k[1],
                         k[4] * TURN / 360.0 };
        put_ring(BOW, p, nx, 4, ring + 4 * i);
    }
    tube_style style = { .42, .56, .10, true, false, true, 140 };
    mesh_tube(m, ring, 4, 4, style);
}

/* Teeth of the starboard side: two in the upper jaw, and one between them in the lower
 * jaw. */
static void teeth(mesh *m, path_point neck)
{
    static const double tooth[4][4] = {
        /* f, v, x, towards */
        { .60, .055, .062, -.085 },
        { .74, .085, .062, -.10 },
        { .66, -.155, .048, .08 },
        { .48, .075, .070, -.06 },
    };
    for (int i = 0; i < 4; i++) {
        const double *k = tooth[i];
        double d = neck.d + HEAD * k[0], y = neck.y + HEAD * k[1], x = HEAD * k[2];
        double r = HEAD * .025;
        vec base[4] = { to_ship(BOW, x + r, d, y), to_ship(BOW, x, d + r, y),
                        to_ship(BOW, x - r, d, y), to_ship(BOW, x, d - r, y) };
        if (k[3] < 0.0) {
            vec swap = base[1];
            base[1] = base[3];
            base[3] = swap;
        }
        spike(m, base, to_ship(BOW, x, d, y + HEAD * k[3]));
    }
}

static void eye(mesh *m, path_point neck)
{
    double d = neck.d + HEAD * .315, y = neck.y + HEAD * .215, x = HEAD * .128;
    double r = HEAD * .048;
    vec base[4] = { to_ship(BOW, x, d - r, y), to_ship(BOW, x, d, y - r),
                    to_ship(BOW, x, d + r, y), to_ship(BOW, x, d, y + r) };
    spike(m, base, to_ship(BOW, x + r, d + .01, y + .005));
}

static void dragon(mesh *m, ship_detail detail)
{
    path_point neck = path_at(BOW, 8.2);
    const bool full = detail == FULL;
    mesh_part(m, "dragon", "oak");
    head_part(m, neck, skull, 7, full ? HEAD_SIDES : 4, 130);
    head_part(m, neck, jaw, 4, full ? HEAD_SIDES : 3, 131);
    mesh_part(m, "dragon", "carved");
    mane(m, full ? 1 : 2);
    for (int side = 0; side < 2; side++) {
        m->mirror = side == 1;
        mesh_part(m, "dragon", "oak");
        horn(m, neck);
        if (!full)
            continue;
        mesh_part(m, "dragon", "bone");
        teeth(m, neck);
        eye(m, neck);
    }
    m->mirror = false;
}

/* -- posts with three sides ---------------------------------------------------------- */

static void post_low(mesh *m, ship_end end, const double *at, int rings, int smoothing)
{
    vec ring[3 * RINGS_MAX];
    for (int i = 0; i < rings; i++) {
        double depth = post_depth(end, at[i]), width = post_width(end, at[i]) * .6;
        double nx[3][2] = { { depth * .5, -width },
                            { depth * .5, width },
                            { -depth * .5, 0 } };
        put_ring(end, path_at(end, at[i]), nx, 3, ring + 3 * i);
    }
    tube_style style = { .9, .5, 2.0, false, false, true, smoothing };
    mesh_tube(m, ring, rings, 3, style);
}

/* -- the posts of each detail --------------------------------------------------------- */

void posts_build(mesh *m, ship_detail detail)
{
    static const double bow[] = { 0,   .9,  1.8, 2.6, 3.3,  4.0,  4.7,
                                  5.4, 6.1, 6.8, 7.3, 7.65, 7.95, 8.2 };
    static const double stern[] = { 0,   .9,   1.8, 2.6,  3.3,  4.0,  4.7,   5.4,  6.1,
                                    6.7, 7.2,  7.6, 7.95, 8.3,  8.6,  8.85,  9.1,  9.3,
                                    9.5, 9.68, 9.9, 10.1, 10.3, 10.5, 10.72, 10.95 };
    static const double bow_middle[] = { 2.0, 3.3, 4.7, 6.1, 6.8, 7.3, 7.65, 7.95, 8.25 };
    static const double stern_middle[] = { 2.0, 3.3, 4.7, 6.1,  6.7, 7.2, 7.6,
                                           8.3, 8.85, 9.3, 9.9, 10.4, 10.95 };
    mesh_part(m, "keel", "tar");
    keel(m);
    mesh_part(m, "stem", "carved");
    if (detail == FULL)
        post(m, BOW, bow, 14, 100);
    else
        post_low(m, BOW, bow_middle, 9, 100);
    mesh_part(m, "stern", "carved");
    if (detail == FULL)
        post(m, STERN, stern, 26, 110);
    else
        post_low(m, STERN, stern_middle, 13, 110);
    dragon(m, detail);
}

void posts_build_low(mesh *m)
{
    static const double bow[] = { 2.0, 3.6, 5.4, 7.3, 7.9, 8.25 };
    static const double stern[] = { 2.0, 3.6, 5.4, 7.3, 8.3, 9.2 };
    path_point neck = path_at(BOW, 8.2);
    static const head_key head[3] = {
        { -.12, .0, 0, .15, .16, .26 },
        { .40, .18, 0, .20, .24, .20 },
        { 1.15, .12, 0, .07, .10, .08 },
    };
    vec ring[12];
    for (int i = 0; i < 3; i++) {
        double nx[4][2] = { { head[i].up, 0 },
                            { 0, head[i].wide },
                            { -head[i].down, 0 },
                            { 0, -head[i].wide } };
        path_point p = { neck.d + head[i].f, neck.y + head[i].v, 0.0 };
        put_ring(BOW, p, nx, 4, ring + 4 * i);
    }
    mesh_part(m, "stem", "carved");
    post_low(m, BOW, bow, 6, 100);
    tube_style style = { .42, .05, .15, true, false, true, 130 };
    mesh_part(m, "dragon", "oak");
    mesh_tube(m, ring, 3, 4, style);
    mesh_part(m, "stern", "carved");
    post_low(m, STERN, stern, 6, 110);
}
