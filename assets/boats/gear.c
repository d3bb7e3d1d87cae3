/* SPDX-License-Identifier: MIT */
/* Gear of the longship, in the hull and along the rails: shields, oars, the steering oar,
 * thwarts. Parts on both sides are built to starboard and mirrored. */
#include "longship.h"

#include <math.h>

static const double TURN = 6.283185307179586;

enum { SHIELDS = 14, OARS = 9, RIM = 10, RIM_MIDDLE = 7, BOSS = 6 };

static const double RADIUS = .43; /* radius of a shield, m */

/* -- shields ------------------------------------------------------------------------- */

/* A place with three directions: aft along the rail, up, and out = up x aft. */
typedef struct {
    vec at, aft, up, out;
} stand;

static stand rail_stand(double z)
{
    double u = hull_u_at(STRAKES, z);
    vec way =
        vec_unit(vec_sub(hull_point(STRAKES, u + .01), hull_point(STRAKES, u - .01)));
    stand s = { hull_point(STRAKES, u), way, { 0, 1, 0 }, { 0, 0, 0 } };
    s.up = vec_unit(vec_sub(s.up, vec_scale(way, way.y)));
    s.out = vec_cross(s.up, s.aft);
    s.at = vec_add(s.at, vec_add(vec_scale(s.out, .085), vec_scale(s.up, .03)));
    return s;
}

static vec on_stand(const stand *s, double aft, double up, double out)
{
    return vec_add(vec_add(s->at, vec_scale(s->aft, aft)),
                   vec_add(vec_scale(s->up, up), vec_scale(s->out, out)));
}

/* A disc, domed outwards; each of four designs fills a quarter of the texture. */
static void shield(mesh *m, const stand *s, int design, int smoothing)
{
    const double reach = .234;
    double cs = .25 + .5 * (design % 2), ct = .25 + .5 * (design / 2);
    corner centre = corner_of(on_stand(s, 0, 0, .055), cs, ct), rim[RIM];
    for (int i = 0; i < RIM; i++) {
        double c = cos(TURN * (i + .5) / RIM), d = sin(TURN * (i + .5) / RIM);
        vec at = on_stand(s, RADIUS * d, RADIUS * c, 0);
        rim[i] = corner_of(at, cs - reach * d, ct + reach * c);
    }
    for (int i = 0; i < RIM; i++)
        mesh_triangle(m, centre, rim[i], rim[(i + 1) % RIM], smoothing);
}

/* The bare boards of a shield's inner side. */
static void shield_back(mesh *m, const stand *s, int smoothing)
{
    corner centre = corner_of(on_stand(s, 0, 0, -.015), .1, .5), rim[RIM];
    for (int i = 0; i < RIM; i++) {
        double c = cos(TURN * (i + .5) / RIM), d = sin(TURN * (i + .5) / RIM);
        rim[i] =
            corner_of(on_stand(s, RADIUS * d, RADIUS * c, 0), .1 + .3 * c, .5 + .3 * d);
    }
    for (int i = 0; i < RIM; i++)
        mesh_triangle(m, centre, rim[(i + 1) % RIM], rim[i], smoothing);
}

/* A flat shield: its front, or the boards of its inner side. */
static void flat_shield(mesh *m, const stand *s, int design, bool front)
{
    const double reach = .234;
    double cs = .25 + .5 * (design % 2), ct = .25 + .5 * (design / 2);
    corner rim[RIM_MIDDLE];
    for (int i = 0; i < RIM_MIDDLE; i++) {
        double c = cos(TURN * (i + .3) / RIM_MIDDLE), d = sin(TURN * (i + .3) / RIM_MIDDLE);
        vec at = on_stand(s, RADIUS * d, RADIUS * c, front ? .02 : -.01);
        rim[i] = front ? corner_of(at, cs - reach * d, ct + reach * c)
                       : corner_of(at, .1 + .3 * c, .5 + .3 * d);
    }
    for (int i = 1; i + 1 < RIM_MIDDLE; i++)
        mesh_triangle(m, rim[0], rim[front ? i : i + 1], rim[front ? i + 1 : i], 0);
}

static void flat_shields(mesh *m)
{
    for (int part = 0; part < 2; part++) {
        mesh_part(m, "shields", part == 0 ? "shield" : "oak");
        for (int i = 0; i < 2 * SHIELDS; i++) {
            stand s = rail_stand(.93 * (i % SHIELDS) - .465 * (SHIELDS - 1));
            m->mirror = i >= SHIELDS;
            flat_shield(m, &s, (i + i / SHIELDS) % 4, part == 0);
        }
    }
    m->mirror = false;
}

static void boss(mesh *m, const stand *s, int smoothing)
{
    static const double shape[2][2] = { { .115, .035 }, { .070, .105 } };
    vec ring[2 * BOSS];
    for (int i = 0; i < 2 * BOSS; i++) {
        const double *k = shape[i / BOSS];
        double turn = TURN * (i % BOSS) / BOSS;
        ring[i] = on_stand(s, k[0] * sin(turn), k[0] * cos(turn), k[1]);
    }
    tube_style style = { 2.0, .1, .5, true, false, true, smoothing };
    mesh_tube(m, ring, 2, BOSS, style);
}

static void shields(mesh *m)
{
    static const char *const made_of[3] = { "shield", "oak", "iron" };
    for (int part = 0; part < 3; part++) {
        mesh_part(m, "shields", made_of[part]);
        for (int i = 0; i < 2 * SHIELDS; i++) {
            int place = i % SHIELDS;
            stand s = rail_stand(.93 * place - .465 * (SHIELDS - 1));
            m->mirror = i >= SHIELDS;
            if (part == 0)
                shield(m, &s, (i + i / SHIELDS) % 4, 300 + place);
            else if (part == 1)
                shield_back(m, &s, 320 + place);
            else
                boss(m, &s, 340 + place);
        }
    }
    m->mirror = false;
}

/* -- oars ---------------------------------------------------------------------------- */

/* Half sizes of a diamond across the loom, and its place between the ends. */
typedef struct {
    double along, flat, edge;
} oar_key;

static void loom(mesh *m, vec a, vec b, const oar_key *key, int keys, tube_style style)
{
    vec way = vec_unit(vec_sub(b, a));
    vec flat =
        vec_unit(vec_cross(way, fabs(way.y) < .7 ? vec_of(0, 1, 0) : vec_of(1, 0, 0)));
    vec edge = vec_cross(way, flat), ring[8 * 4];
    for (int i = 0; i < keys; i++) {
        vec c = vec_mix(a, b, key[i].along), *r = ring + 4 * i;
        vec f = vec_scale(flat, key[i].flat), e = vec_scale(edge, key[i].edge);
        r[0] = vec_add(c, f);
        r[1] = vec_add(c, e);
        r[2] = vec_sub(c, f);
        r[3] = vec_sub(c, e);
    }
    mesh_tube(m, ring, keys, 4, style);
}

static void oars(mesh *m, ship_detail detail)
{
    static const oar_key key[] = {
        { 0, .034, .034 },
        { .72, .034, .038 },
        { .79, .022, .105 },
        { 1, .014, .135 },
    };
    static const oar_key key_middle[] = { { 0, .034, .034 }, { 1, .014, .06 } };
    const bool full = detail == FULL;
    mesh_part(m, "oars", "deck");
    for (int i = 0; i < 2 * OARS; i++) {
        double z = .93 * (i % OARS) - .465 * (OARS - 1) - .1;
        vec hole = hull_point(6.45, hull_u_at(6.45, z));
        vec hand = vec_add(hole, vec_of(-.95, .30, -.17));
        vec tip = vec_add(hole, vec_of(3.30, -1.03, .59));
        tube_style style = { .42, .56, .12, !full, full, full, 400 + 4 * (i % OARS) };
        m->mirror = i >= OARS;
        loom(m, hand, tip, full ? key : key_middle, full ? 4 : 2, style);
    }
    m->mirror = false;
}

/* The steering oar hangs outside the starboard quarter; the tiller lies athwart above the
 * deck. */
static void steering_oar(mesh *m, bool low)
{
    static const oar_key key[] = {
        { 0, .05, .05 },    { .42, .06, .06 }, { .52, .045, .12 },
        { .80, .035, .27 }, { 1, .025, .20 },
    };
    static const oar_key key_low[] = { { 0, .07, .07 }, { 1, .05, .26 } };
    vec rail = hull_point(STRAKES, hull_u_at(STRAKES, 7.1));
    vec head = vec_add(rail, vec_of(.17, .60, -.20)),
        foot = vec_of(rail.x + .12, -1.15, 7.75);
    tube_style style = { .42, .56, .12, false, true, true, 370 };
    mesh_part(m, "rudder", "oak");
    if (low) {
        loom(m, head, foot, key_low, 2, style);
        return;
    }
    loom(m, head, foot, key, 5, style);
    tube_style tiller = { .42, .31, .12, false, true, true, 375 };
    mesh_beam(m, vec_add(head, vec_of(-.95, .02, -.12)),
              vec_add(head, vec_of(.02, -.08, .02)), vec_of(0, .03, 0), vec_of(0, 0, .03),
              tiller);
    tube_style block = { .42, .56, .12, false, true, true, 380 };
    mesh_beam(m, vec_add(rail, vec_of(-.02, -.2, .05)),
              vec_add(rail, vec_of(.13, -.2, .05)), vec_of(0, .12, 0), vec_of(0, 0, .12),
              block);
}

/* -- inside the hull ----------------------------------------------------------------- */

static void thwarts(mesh *m)
{
    mesh_part(m, "thwarts", "oak");
    for (int i = 0; i < OARS; i++) {
        double z = .93 * i - .465 * (OARS - 1) + .42, y = .715;
        if (fabs(z - .35) < .4)
            continue; /* the mast stands there */
        double x = hull_inner_x(y, hull_u_at(7.0, z)) + .03;
        tube_style style = { .42, .25 * (i % 4) + .06, .12, false, false, false, 390 };
        mesh_beam(m, vec_of(-x, y, z), vec_of(x, y, z), vec_of(0, .03, 0),
                  vec_of(0, 0, .11), style);
    }
}

void gear_build(mesh *m, ship_detail detail)
{
    thwarts(m);
    if (detail == FULL)
        shields(m);
    else
        flat_shields(m);
    oars(m, detail);
    steering_oar(m, detail != FULL);
}

void gear_build_low(mesh *m)
{
    steering_oar(m, true);
}
