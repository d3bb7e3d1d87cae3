/* SPDX-License-Identifier: MIT */
/* Evaluates the coastal water at a place; coastal_water_tables.c builds the tables. */
#include "coastal_water.h"

/* -- grid places --------------------------------------------------------------------- */

typedef struct {
    int    col, row;
    double s, t;
} nodes;

static double held(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

static nodes surrounding_nodes(const tp_coastal_water *o, double x, double z)
{
    const double step = o->map_step / 65536.0;
    const double u = held((x - (double)o->map_x / 65536) / step, 0, o->map_cols - 1);
    const double w = held((z - (double)o->map_z / 65536) / step, 0, o->map_rows - 1);
    nodes n = { (int)u, (int)w, 0, 0 };

    n.col -= n.col == (int)o->map_cols - 1;
    n.row -= n.row == (int)o->map_rows - 1;
    n.s = u - n.col;
    n.t = w - n.row;
    return n;
}

static double between(const nodes *n, double a, double b, double c, double d)
{
    const double north = a + (b - a) * n->s, south = c + (d - c) * n->s;
    return north + (south - north) * n->t;
}

static ref_bed bed_of_map(const tp_coastal_water *o, double x, double z)
{
    const nodes n = surrounding_nodes(o, x, z);
    const char *from = (const char *)o + o->floor_nodes;
    const tp_coastal_floor_node *a = (const tp_coastal_floor_node *)(const void *)from
                                     + (size_t)n.row * o->map_cols + n.col;
    const tp_coastal_floor_node *c = a + o->map_cols;

    return (ref_bed){
        between(&n, a[0].depth, a[1].depth, c[0].depth, c[1].depth) / 65536,
        between(&n, a[0].rise_x, a[1].rise_x, c[0].rise_x, c[1].rise_x) / 2048,
        between(&n, a[0].rise_z, a[1].rise_z, c[0].rise_z, c[1].rise_z) / 2048,
    };
}

ref_bed ref_coastal_floor(const ref_coastal *coastal, double x, double z)
{
    if (coastal->map)
        return bed_of_map(coastal->map, x, z);
    return (ref_bed){
        coastal->depth - coastal->slope * (coastal->up_x * x + coastal->up_z * z),
        coastal->slope * coastal->up_x, coastal->slope * coastal->up_z,
    };
}

/* -- one wave ------------------------------------------------------------------------ */

/* Catmull-Rom cubic through four numbers. */
static double cubic(const double p[4], double s)
{
    const double a = p[3] - 3 * p[2] + 3 * p[1] - p[0];
    const double b = 2 * p[0] - 5 * p[1] + 4 * p[2] - p[3];
    return p[1] + s / 2 * (p[2] - p[0] + s * (b + s * a));
}

static int around(int i)
{
    return i < 0 ? 0 : i < REF_DEPTHS ? i : REF_DEPTHS - 1;
}

/* Place of a depth in the tables of all waves. */
typedef struct {
    int    node[4];             /* nodes of the cubic */
    double s, left;             /* place between the inner nodes; share of the orbit */
} table_place;

/* Below 1/16 m the entry of 1/16 m holds, and its orbit shrinks with the depth. */
static table_place place_of_depth(double depth)
{
    const double at = held(log2(fmax(depth, 1 / 16.0) * 16) * 64, 0, REF_DEPTHS - 1);
    const int i = (int)at;

    return (table_place){ { around(i - 1), i, around(i + 1), around(i + 2) }, at - i,
                          fmin(1, depth * 16) };
}

/* Table entry for a depth. */
static ref_depth_node interpolate_node(const ref_coastal_wave *w, const table_place *at)
{
    const ref_depth_node *a = &w->node[at->node[0]], *b = &w->node[at->node[1]],
                         *c = &w->node[at->node[2]], *d = &w->node[at->node[3]];
    ref_depth_node n;

    for (int i = 0; i < REF_NODE; i++)
        n.all[i] = cubic((const double[4]){ a->all[i], b->all[i], c->all[i], d->all[i] },
                         at->s);
    n.along *= at->left;
    n.up *= at->left;
    n.push *= at->left;
    return n;
}

/* Adds the map's refraction: phase and direction interpolated between nodes, the tilt from
 * the rise of the floor along the direction. */
static void bend(const ref_coastal *coastal, int i, double x0, double z0,
                 const ref_bed *bed, ref_depth_node *n)
{
    const tp_coastal_water *o = coastal->map;
    const nodes at = surrounding_nodes(o, x0, z0);
    const char *from = (const char *)o + o->wave[i].wave_nodes;
    const tp_coastal_wave_node *a = (const tp_coastal_wave_node *)(const void *)from
                                    + (size_t)at.row * o->map_cols + at.col;
    const tp_coastal_wave_node *c = a + o->map_cols;

    n->excess = 2 * PI / 65536
              * between(&at, a[0].turns, a[1].turns, c[0].turns, c[1].turns);
    n->way_x += between(&at, a[0].way_x, a[1].way_x, c[0].way_x, c[1].way_x) / 8192;
    n->way_z += between(&at, a[0].way_z, a[1].way_z, c[0].way_z, c[1].way_z) / 8192;
    const double rise = bed->rise_x * n->way_x + bed->rise_z * n->way_z;
    n->sine = rise > 0 ? rise / hypot(1, rise) * exp(-coastal->k0 * bed->depth) : 0;
}

/* Phi and dPhi/dtheta of [B10] after `iterations` steps as printed. */
static double blown(double theta, double push, int iterations, double *rate)
{
    double phi = theta, d = 1;

    for (int n = 0; n < iterations && push != 0; n++) {
        d = 1 - push * sin(phi) * d;
        phi = theta + push * cos(phi);
    }
    *rate = d;
    return phi;
}

/* Adds the wave's orbit at phi to the point: displacement along its direction and up, and
 * the derivatives. */
static void add_wave(const ref_coastal_wave *w, const ref_depth_node *n, double theta,
                     ref_point *p)
{
    double rate;
    const double phi = blown(theta, n->push, w->iterations, &rate);
    const double s = sin(phi), c = cos(phi), cosine = sqrt(1 - n->sine * n->sine);
    const double side = n->sine == 0 || n->up <= n->along ? n->up : n->along;
    const double level = n->along * s * cosine + side * c * n->sine;
    const double d_level = rate * n->k * (n->along * c * cosine - side * s * n->sine);
    const double d_up = rate * n->k * (n->along * c * n->sine + n->up * s * cosine);

    p->x += level * n->way_x;
    p->y += n->along * s * n->sine - n->up * c * cosine;
    p->z += level * n->way_z;
    p->hx += d_up * n->way_x;
    p->hz += d_up * n->way_z;
    p->jxx += d_level * n->way_x * n->way_x;
    p->jxz += d_level * n->way_x * n->way_z;
    p->jzz += d_level * n->way_z * n->way_z;
}

static void set_normal(ref_point *p)
{
    p->nx = p->hz * p->jxz - p->hx * p->jzz;
    p->ny = p->jxx * p->jzz - p->jxz * p->jxz;
    p->nz = p->hx * p->jxz - p->hz * p->jxx;
}

ref_point ref_coastal_rest(const ref_coastal *coastal, const double phase[TP_WAVES],
                           double x0, double z0)
{
    const ref_bed bed = ref_coastal_floor(coastal, x0, z0);
    const table_place at = place_of_depth(bed.depth);
    ref_point p = { .x = x0, .z = z0, .jxx = 1, .jzz = 1 };

    for (int i = 0; i < coastal->count && bed.depth > 0; i++) {
        const ref_coastal_wave *w = &coastal->wave[i];
        ref_depth_node n = interpolate_node(w, &at);
        if (coastal->map)
            bend(coastal, i, x0, z0, &bed, &n);
        add_wave(w, &n, w->k_deep * (w->deep.dx * x0 + w->deep.dz * z0) + n.excess
                        + phase[i] + PI / 2, &p);
    }
    set_normal(&p);
    return p;
}

#define STEP 1e-3

/* Derivative of the displacement along x or z, by four points. */
static ref_point displacement_rate(const ref_coastal *coastal, const double *phase,
                                   double x0, double z0, double dx, double dz)
{
    static const double at[4] = { -2, -1, 1, 2 }, by[4] = { 1, -8, 8, -1 };
    ref_point sum = { .x = 0 };

    for (int i = 0; i < 4; i++) {
        const ref_point p = ref_coastal_rest(coastal, phase, x0 + at[i] * dx,
                                           z0 + at[i] * dz);
        sum.x += by[i] * p.x / (12 * STEP);
        sum.y += by[i] * p.y / (12 * STEP);
        sum.z += by[i] * p.z / (12 * STEP);
    }
    return sum;
}

ref_point ref_coastal_exact(const ref_coastal *coastal, const double phase[TP_WAVES],
                            double x0, double z0)
{
    ref_point p = ref_coastal_rest(coastal, phase, x0, z0);

    if (!coastal->floored || (!coastal->map && coastal->slope == 0))
        return p;
    const ref_point a = displacement_rate(coastal, phase, x0, z0, STEP, 0);
    const ref_point b = displacement_rate(coastal, phase, x0, z0, 0, STEP);
    p.nx = b.y * a.z - b.z * a.y;           /* B x T [A10]; J is no longer symmetric */
    p.ny = b.z * a.x - b.x * a.z;
    p.nz = b.x * a.y - b.y * a.x;
    return p;
}
