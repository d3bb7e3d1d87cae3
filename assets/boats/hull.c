/* SPDX-License-Identifier: MIT */
/* The clinker hull: one closed skin of planks outside, gunwale, bulwark and deck inside.
 *
 * Each strake edge is a curve from stern post to stem. Amidships the edges follow the frame
 * of `frame_at`; towards the ends their breadth approaches the post's breadth as 1 - |u|^p,
 * and their height approaches the place in the post's rabbet as |u|^e. The lower edge of
 * each strake is offset from the strake below by a plank's thickness, which makes the
 * steps. A station is the row of points from keel to deck at one u; mirrored and joined to
 * its neighbours, a station makes a closed tube. A lid, which is never drawn, spans the
 * hull from gunwale to gunwale. Proportions after the Oseberg and Gokstad ships. */
#include "longship.h"

#include <math.h>

static const double frame_at[STRAKES + 1][2] = {
    /* half breadth, height */
    { .08, -.68 }, { .50, -.612 }, { .92, -.482 }, { 1.28, -.292 }, { 1.56, -.055 },
    { 1.75, .20 }, { 1.87, .456 }, { 1.94, .702 }, { 1.985, .905 }, { 2.003, 1.085 },
};

static const double END_BREADTH = .055; /* half breadth at the posts, m */
static const double DECK_HEIGHT = .402;
static const double WATERLINE = 4.0; /* strake edge of the upper limit of the tar */
static const double TILE = 2.4;      /* length of plank that the wood texture covers, m */

static double frame_value(double edge, int axis)
{
    int k = (int)edge;
    k = k < 0 ? 0 : k > STRAKES - 1 ? STRAKES - 1 : k;
    return mix(frame_at[k][axis], frame_at[k + 1][axis], edge - k);
}

vec hull_point(double edge, double u)
{
    double a = fabs(u), up = edge / STRAKES;
    vec end = post_rabbet(u < 0.0 ? BOW : STERN, edge);
    double full = pow(1.0 - pow(a, mix(1.75, 2.35, up)), mix(1.3, 1.0, up));
    double rise = pow(a, mix(3.0, 3.4, up));
    return vec_of(mix(END_BREADTH, frame_value(edge, 0), full),
                  mix(frame_value(edge, 1), end.y, rise), a * end.z);
}

vec hull_outward(double edge, double u)
{
    double low = edge < .5 ? 0.0 : edge - .5;
    double high = edge > STRAKES - .5 ? STRAKES : edge + .5;
    vec up = vec_sub(hull_point(high, u), hull_point(low, u));
    return vec_unit(vec_of(up.y, -up.x, 0.0));
}

double hull_u_at(double edge, double z)
{
    double low = -1.0, high = 1.0;
    for (int i = 0; i < 48; i++) {
        double u = (low + high) / 2.0;
        if (hull_point(edge, u).z < z)
            low = u;
        else
            high = u;
    }
    return low;
}

/* Point of the outer skin at a height; planks are straight between their edges. */
static vec skin_at(double y, double u)
{
    int k = 0;
    while (k < STRAKES - 1 && hull_point(k + 1, u).y < y)
        k++;
    vec a = hull_point(k, u), b = hull_point(k + 1, u);
    return vec_mix(a, b, b.y > a.y ? fmin(fmax((y - a.y) / (b.y - a.y), 0.0), 1.0) : 1.0);
}

double hull_inner_x(double y, double u)
{
    double x = skin_at(y, u).x;
    return x - fmin(.075, .5 * x);
}

/* -- stations ------------------------------------------------------------------------ */

enum { PLANKS_MAX = STRAKES, POINTS_MAX = 2 * PLANKS_MAX + 4, STATIONS_MAX = 32 };

/* Strake edges that bound the planks, and positions of the stations. */
typedef struct {
    int planks, stations;
    double edge[PLANKS_MAX + 1];
    double u[STATIONS_MAX];
    double lap, rail; /* thickness of a plank, height of the gunwale */
    double decked;    /* u| from which the deck lies at the gunwale */
    bool painted;     /* shields are painted on the uppermost plank */
} hull_plan;

typedef struct {
    vec at[POINTS_MAX];     /* two a plank, 3 gunwale, 1 edge of the deck */
    double way[PLANKS_MAX]; /* distance along each plank from the bow, m */
} station;

static vec deck_edge(double u, double decked, vec rail)
{
    double raised = smooth((fabs(u) - decked + .24) / .24);
    double y = mix(DECK_HEIGHT, rail.y, raised);
    vec skin = skin_at(y, u);
    return fabs(u) >= decked ? rail : vec_of(hull_inner_x(y, u), y, skin.z);
}

static void station_at(const hull_plan *plan, double u, station *to)
{
    vec *at = to->at;
    double thin = 1.0 - pow(u, 6.0); /* planks and gunwale run out into the posts */
    for (int k = 0; k < plan->planks; k++) {
        double low = plan->edge[k];
        vec lap = vec_scale(hull_outward(low, u), k > 0 ? plan->lap * thin : 0.0);
        *at++ = vec_add(hull_point(low, u), lap);
        *at++ = hull_point(plan->edge[k + 1], u);
    }
    vec top = at[-1], out = vec_of(plan->rail * .8 * thin, 0.0, 0.0);
    *at++ = vec_add(top, out);
    *at++ = vec_add(vec_add(top, out), vec_of(0.0, plan->rail, 0.0));
    vec inner = vec_of(top.x - fmin(plan->rail * 1.2, .5 * top.x) * thin,
                       top.y + plan->rail, top.z);
    *at++ = inner;
    *at = deck_edge(u, plan->decked, inner);
}

static void measure_planks(const hull_plan *plan, station *s)
{
    for (int k = 0; k < plan->planks; k++) {
        s[0].way[k] = .37 * TILE * k; /* no grain continues into the next strake */
        for (int i = 1; i < plan->stations; i++) {
            vec a = vec_mix(s[i - 1].at[2 * k], s[i - 1].at[2 * k + 1], .5);
            vec b = vec_mix(s[i].at[2 * k], s[i].at[2 * k + 1], .5);
            s[i].way[k] = s[i - 1].way[k] + vec_length(vec_sub(b, a));
        }
    }
}

/* -- skins --------------------------------------------------------------------------- */

/* Smoothing numbers: PLANK_FACE and PLANK_STEP are each the first of as many numbers as
 * there are planks. */
enum {
    PLANK_FACE = 1,
    PLANK_STEP = 20,
    RAIL_UNDER = 41,
    RAIL_SIDE,
    RAIL_TOP,
    BULWARK,
    DECK,
    BOTTOM
};

/* t0 and t1 are the texture's t at the strip's first and second edge; with by_height t
 * follows the height of the wall instead, so that the inner planks keep their width. */
typedef struct {
    double t0, t1, tile;
    int smoothing;
    bool by_height;
} strip_style;

static double height_t(const station *s, int p, strip_style w)
{
    return w.by_height ? w.t0 - .8 * (s->at[p].y - s->at[p + 1].y) : w.t1;
}

/* Strip between the points p and p + 1 of all stations, with the distances of plank k. */
static void strip(mesh *m, const hull_plan *plan, const station *s, int p, int k,
                  strip_style w)
{
    for (int i = 0; i + 1 < plan->stations; i++) {
        const station *a = &s[i], *b = &s[i + 1];
        double sa = a->way[k] / w.tile, sb = b->way[k] / w.tile;
        mesh_quad(m, corner_of(b->at[p], sb, w.t0), corner_of(a->at[p], sa, w.t0),
                  corner_of(a->at[p + 1], sa, height_t(a, p, w)),
                  corner_of(b->at[p + 1], sb, height_t(b, p, w)), w.smoothing);
    }
}

static void planks(mesh *m, const hull_plan *plan, const station *s, int first, int last)
{
    for (int k = first; k < last; k++) {
        bool top = k == plan->planks - 1;
        double t0 = plan->edge[k] / 4.0, t1 = plan->edge[k + 1] / 4.0;
        strip_style wood = { t0, t1, TILE, PLANK_FACE + k, false };
        strip_style shields = { 0.0, .5, 1.5, PLANK_FACE + k, false };
        strip_style step = { t1 - .02, t1, TILE, PLANK_STEP + k, false };
        strip(m, plan, s, 2 * k, k, top && plan->painted ? shields : wood);
        if (!top)
            strip(m, plan, s, 2 * k + 1, k, step);
    }
}

static void gunwale(mesh *m, const hull_plan *plan, const station *s)
{
    int p = 2 * plan->planks - 1, top = plan->planks - 1;
    strip_style under = { .26, .28, TILE, RAIL_UNDER, false };
    strip_style side = { .27, .42, TILE, RAIL_SIDE, false };
    strip_style over = { .27, .48, TILE, RAIL_TOP, false };
    strip_style inside = { .99, 0, TILE, BULWARK, true };
    strip(m, plan, s, p, top, under);
    strip(m, plan, s, p + 1, top, side);
    strip(m, plan, s, p + 2, top, over);
    strip(m, plan, s, p + 3, top, inside);
}

static vec port(vec v)
{
    return vec_of(-v.x, v.y, v.z);
}

static corner flat_corner(vec at)
{
    return corner_of(at, at.z / TILE, at.x * .8 + .5);
}

/* Deck and underside of the keel, from side to side. */
static void across(mesh *m, const station *a, const station *b, int p, bool up)
{
    vec ra = a->at[p], rb = b->at[p];
    vec first = up ? port(rb) : rb, second = up ? rb : port(rb);
    vec third = up ? ra : port(ra), fourth = up ? port(ra) : ra;
    mesh_quad(m, flat_corner(first), flat_corner(second), flat_corner(third),
              flat_corner(fourth), up ? DECK : BOTTOM);
}

/* Closing strips inside a post; `fore`: at the bow. */
static void end_cap(mesh *m, const station *s, int points, bool fore)
{
    for (int p = 0; p + 1 < points; p++) {
        vec a = s->at[p], b = s->at[p + 1];
        vec left = fore ? port(a) : a, right = fore ? a : port(a);
        vec high_left = fore ? port(b) : b, high_right = fore ? b : port(b);
        mesh_quad(m, flat_corner(right), flat_corner(left), flat_corner(high_left),
                  flat_corner(high_right), 0);
    }
}

static void both_sides(mesh *m, const hull_plan *plan, const station *s, int first,
                       int last)
{
    for (int side = 0; side < 2; side++) {
        m->mirror = side == 1;
        planks(m, plan, s, first, last);
    }
    m->mirror = false;
}

static void build(mesh *m, const hull_plan *plan)
{
    static station s[STATIONS_MAX];
    int points = 2 * plan->planks + 4, last = plan->stations - 1, tarred = 0;
    for (int i = 0; i <= last; i++)
        station_at(plan, plan->u[i], &s[i]);
    measure_planks(plan, s);
    while (plan->edge[tarred + 1] <= WATERLINE)
        tarred++;

    mesh_part(m, "hull", "tar");
    both_sides(m, plan, s, 0, tarred);
    for (int i = 0; i < last; i++)
        across(m, &s[i], &s[i + 1], 0, false);
    end_cap(m, &s[0], points - 1, true);
    end_cap(m, &s[last], points - 1, false);
    mesh_part(m, "hull", "oak");
    both_sides(m, plan, s, tarred, plan->planks - 1);
    for (int side = 0; side < 2; side++) {
        m->mirror = side == 1;
        gunwale(m, plan, s);
    }
    m->mirror = false;
    mesh_part(m, "hull", plan->painted ? "shield" : "oak");
    both_sides(m, plan, s, plan->planks - 1, plan->planks);
    mesh_part(m, "hull", "deck");
    for (int i = 0; i < last; i++)
        across(m, &s[i], &s[i + 1], points - 1, true);
    mesh_part(m, "lid", "lid");
    for (int i = 0; i < last; i++) {
        if (fabs(plan->u[i]) < plan->decked || fabs(plan->u[i + 1]) < plan->decked)
            across(m, &s[i], &s[i + 1], points - 2, true);
    }
}

void hull_build(mesh *m, ship_detail detail)
{
    static const hull_plan full = {
        .planks = STRAKES,
        .stations = 19,
        .edge = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 },
        .u = { -1, -.955, -.895, -.82, -.73, -.62, -.49, -.34, -.17, 0, .17, .34, .49,
               .62, .73, .82, .895, .955, 1 },
        .lap = .038,
        .rail = .068,
        .decked = 1,
    };
    static const hull_plan middle = {
        .planks = 4,
        .stations = 11,
        .edge = { 0, 2, 4, 6, 9 },
        .u = { -1, -.92, -.77, -.56, -.3, 0, .3, .56, .77, .92, 1 },
        .rail = .068,
        .decked = 1,
    };
    build(m, detail == FULL ? &full : &middle);
}

/* Without laps and rail the strips of laps and rail have no area, so they are dropped. */
void hull_build_low(mesh *m)
{
    static const hull_plan plan = {
        .planks = 3,
        .stations = 9,
        .edge = { 0, 4, 6, 9 },
        .u = { -1, -.88, -.66, -.36, 0, .36, .66, .88, 1 },
        .decked = .88,
        .painted = true,
    };
    build(m, &plan);
}
