/* SPDX-License-Identifier: MIT */
/* Light focused by waves; see the header. The triangles are found by a pyramid of bounds:
 * the bounds of a block of rays at depth d follow from the bounds of both summands. */
#include "caustics.h"
#include <stdlib.h>

#define MOST_CELLS 1024         /* along a side */
#define BLOCK      4            /* cells along a side of the lowest level's blocks */
#define LEAST_DOWN 0.1          /* least downward part of a refracted ray, of 1 */

/* -- region -------------------------------------------------------------------------- */

static bool has_caustics(const ref_scene *s)
{
    const bool floor = s->surface.coastal && s->surface.coastal->floored;

    return s->scene->water.clarity > 0 && s->scene->water.caustics > 0 && s->light.y > 0
        && (s->tank.kind != TP_TANK_NONE || floor);
}

/* Low edge of the square along one axis: two fifths of the side ahead of the eye, in whole
 * cells of the engine's map. */
static double square_edge(double eye, double ahead, double side, double cell)
{
    return cell * trunc((eye - side / 2 + 0.4 * side * ahead) / cell);
}

static void place_rectangle(ref_caustics *c, const ref_scene *s)
{
    const tp_scene *scene = s->scene;
    const double side = ref_number(scene->water.caustic_size);
    const double cell = side / scene->water.caustic_cells;
    const ref_vec a = s->camera.ahead, e = s->camera.eye;

    if (scene->pool.cols > 0) {
        c->low[0] = s->tank.x0;
        c->high[0] = s->tank.x1;
        c->low[1] = s->tank.z0;
        c->high[1] = s->tank.z1;
        return;
    }
    c->low[0] = square_edge(e.x, a.x, side, cell);
    c->low[1] = square_edge(e.z, a.z, side, cell);
    c->high[0] = c->low[0] + side;
    c->high[1] = c->low[1] + side;
}

/* Greatest depth of the floor under the rectangle, m. */
static double deepest_floor(const ref_caustics *c, const ref_scene *s)
{
    double deepest = s->tank.depth;

    for (int i = 0; i <= 32 * 33 && s->tank.kind == TP_TANK_NONE; i++) {
        const double x = c->low[0] + (c->high[0] - c->low[0]) * (i % 33) / 32;
        const double z = c->low[1] + (c->high[1] - c->low[1]) * (i / 33) / 32;
        deepest = fmax(deepest, ref_coastal_floor(s->surface.coastal, x, z).depth);
    }
    return deepest;
}

/* Sets the cells: a quarter of the engine's cell or less, 1/32 of the shortest wave and
 * 1/8 of a pool's cell. Without walls the grid extends by a quarter of the depth: rays
 * under slopes of up to 1 are turned by no more. Returns the low corner in *x and *z. */
static void place_grid(ref_caustics *c, const ref_scene *s, double *x, double *z)
{
    const double wide = fmin(c->high[0] - c->low[0], c->high[1] - c->low[1]);
    const double beyond = c->fade > 0 ? deepest_floor(c, s) / 4 : 0;
    double fine = s->surface.fine;

    for (int i = 0; i < 2; i++)
        if (s->surface.relief.cells[i].cols)
            fine = fmin(fine, 4 * s->surface.relief.cells[i].cell);
    c->cell = fmin(wide / s->scene->water.caustic_cells / 4, fine / 32);
    for (int k = 0; k < 2; k++) {
        const double side = c->high[k] - c->low[k] + 2 * beyond;
        c->cell = fmax(c->cell, side / MOST_CELLS);
    }
    c->cell = wide / ceil(wide / c->cell);
    for (int k = 0; k < 2; k++)
        c->cells[k] = (int)ceil((c->high[k] - c->low[k] + 2 * beyond) / c->cell - 1e-6);
    *x = (c->low[0] + c->high[0] - c->cell * c->cells[0]) / 2;
    *z = (c->low[1] + c->high[1] - c->cell * c->cells[1]) / 2;
}

/* -- rays ---------------------------------------------------------------------------- */

/* Horizontal way per depth of the sun's ray behind a surface with these slopes. */
static void refract_sun(ref_vec light, double slope_x, double slope_z, double fall[2])
{
    const ref_vec n = ref_unit_vec((ref_vec){ -slope_x, 1, -slope_z });
    ref_vec down = { 0, -1, 0 };        /* light always enters the denser water */

    ref_refracted(ref_times_vec(light, -1), n, REF_INDEX, &down);
    fall[0] = down.x / fmax(LEAST_DOWN, -down.y);
    fall[1] = down.z / fmax(LEAST_DOWN, -down.y);
}

static ref_light_ray trace_sun(const ref_caustics *c, ref_vec light, const ref_water *w)
{
    const double x[2] = { w->at.x, w->at.z };
    const double sun[2] = { light.x / light.y, light.z / light.y };
    double fall[2];
    ref_light_ray r;

    refract_sun(light, w->slope_x, w->slope_z, fall);
    for (int k = 0; k < 2; k++) {
        r.from[k] = x[k] + fall[k] * w->at.y;
        r.away[k] = fall[k] - c->still[k];
        r.sun[k] = x[k] - sun[k] * w->at.y;
    }
    return r;
}

static void trace_rays(ref_caustics *c, const ref_scene *s, double x, double z)
{
    ref_surface all = s->surface;       /* pools lift here even if they only bend normals */
    const int wide = c->cells[0] + 1, high = c->cells[1] + 1;

    all.relief.bump = 0;
    c->ray = malloc((size_t)wide * (size_t)high * sizeof *c->ray);
    if (!c->ray)
        abort();
    for (int j = 0; j < high; j++) {
        double rest[2] = { x, z + j * c->cell };
        for (int i = 0; i < wide; i++) {
            const ref_water w = ref_surface_sample(&all, x + i * c->cell, z + j * c->cell,
                                                   rest);
            c->ray[(size_t)j * (size_t)wide + (size_t)i] = trace_sun(c, s->light, &w);
        }
    }
}

/* -- bounds -------------------------------------------------------------------------- */

static int level_side(const ref_caustics *c, int level, int axis)
{
    const int block = BLOCK << level;
    return (c->cells[axis] + block - 1) / block;
}

static const ref_light_bounds nothing = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL },
                                          { HUGE_VAL, HUGE_VAL },
                                          { -HUGE_VAL, -HUGE_VAL } };

static void add_bounds(ref_light_bounds *to, const ref_light_bounds *b)
{
    for (int k = 0; k < 2; k++) {
        to->low[k] = fmin(to->low[k], b->low[k]);
        to->high[k] = fmax(to->high[k], b->high[k]);
        to->low_away[k] = fmin(to->low_away[k], b->low_away[k]);
        to->high_away[k] = fmax(to->high_away[k], b->high_away[k]);
    }
}

/* Bounds of the rays at the vertices of block (i, j) of the lowest level. */
static ref_light_bounds bound_rays(const ref_caustics *c, int i, int j)
{
    ref_light_bounds sum = nothing;

    for (int z = j * BLOCK; z <= (j + 1) * BLOCK && z <= c->cells[1]; z++)
        for (int x = i * BLOCK; x <= (i + 1) * BLOCK && x <= c->cells[0]; x++) {
            const ref_light_ray *r = &c->ray[z * (c->cells[0] + 1) + x];
            add_bounds(&sum, &(ref_light_bounds){ { r->from[0], r->from[1] },
                                                  { r->from[0], r->from[1] },
                                                  { r->away[0], r->away[1] },
                                                  { r->away[0], r->away[1] } });
        }
    return sum;
}

/* Bounds of block (i, j) from the four blocks of the level below. */
static ref_light_bounds bound_blocks(const ref_caustics *c, int level, int i, int j)
{
    const int wide = level_side(c, level - 1, 0), high = level_side(c, level - 1, 1);
    ref_light_bounds sum = nothing;

    for (int z = 2 * j; z < 2 * j + 2 && z < high; z++)
        for (int x = 2 * i; x < 2 * i + 2 && x < wide; x++)
            add_bounds(&sum, &c->bounds[level - 1][z * wide + x]);
    return sum;
}

static void make_bounds(ref_caustics *c)
{
    for (int level = 0; ; level++) {
        const int wide = level_side(c, level, 0), high = level_side(c, level, 1);
        ref_light_bounds *to = malloc((size_t)wide * (size_t)high * sizeof *to);
        if (!to)
            abort();
        c->bounds[level] = to;
        c->levels = level + 1;
        for (int n = 0; n < wide * high; n++)
            to[n] = level ? bound_blocks(c, level, n % wide, n / wide)
                          : bound_rays(c, n % wide, n / wide);
        if (wide * high == 1)
            return;
    }
}

/* -- light --------------------------------------------------------------------------- */

/* Twice the signed area of a triangle. */
static double twice_area(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* True if the edge from a to b crosses the line from the point towards +x. The edge's upper
 * end does not count, so neighbours share no point and leave no gap. */
static bool crosses(const double a[2], const double b[2], const double at[2])
{
    if ((a[1] > at[1]) == (b[1] > at[1]))
        return false;
    return at[0] < a[0] + (b[0] - a[0]) * (at[1] - a[1]) / (b[1] - a[1]);
}

/* Light of one triangle at a map place. A triangle that faces away from the sun has
 * none. */
static double triangle_light(const ref_light_ray *const r[3], const double at[2],
                             double depth)
{
    double p[3][2];

    for (int n = 0; n < 3; n++)
        for (int k = 0; k < 2; k++)
            p[n][k] = r[n]->from[k] + depth * r[n]->away[k];
    if ((crosses(p[0], p[1], at) ^ crosses(p[1], p[2], at) ^ crosses(p[2], p[0], at)) == 0)
        return 0;
    const double in = twice_area(r[0]->sun, r[1]->sun, r[2]->sun);
    const double out = fabs(twice_area(p[0], p[1], p[2]));
    return out > 0 ? fmax(0, in) / out : 0;
}

/* Light of the cells of block (i, j) of the lowest level. */
static double cells_light(const ref_caustics *c, int i, int j, const double at[2],
                          double depth)
{
    const int wide = c->cells[0] + 1;
    double sum = 0;

    for (int z = j * BLOCK; z < (j + 1) * BLOCK && z < c->cells[1]; z++)
        for (int x = i * BLOCK; x < (i + 1) * BLOCK && x < c->cells[0]; x++) {
            const ref_light_ray *a = &c->ray[z * wide + x], *b = a + wide;
            sum += triangle_light((const ref_light_ray *[]){ a, a + 1, b }, at, depth)
                 + triangle_light((const ref_light_ray *[]){ a + 1, b + 1, b }, at, depth);
        }
    return sum;
}

static bool may_light(const ref_light_bounds *b, const double at[2], double depth)
{
    for (int k = 0; k < 2; k++)
        if (at[k] < b->low[k] + depth * b->low_away[k]
            || at[k] > b->high[k] + depth * b->high_away[k])
            return false;
    return true;
}

static double block_light(const ref_caustics *c, int level, int i, int j,
                          const double at[2], double depth)
{
    const int wide = level_side(c, level, 0);
    double sum = 0;

    if (i >= wide || j >= level_side(c, level, 1)
        || !may_light(&c->bounds[level][j * wide + i], at, depth))
        return 0;
    if (level == 0)
        return cells_light(c, i, j, at, depth);
    for (int n = 0; n < 4; n++)
        sum += block_light(c, level - 1, 2 * i + n % 2, 2 * j + n / 2, at, depth);
    return sum;
}

/* Light at a map place inside a tank: light beyond a wall is mirrored at the wall. */
static double mirrored_light(const ref_caustics *c, const double at[2], double depth)
{
    double place[2][3], sum = 0;

    for (int k = 0; k < 2; k++) {
        const double side = c->high[k] - c->low[k];
        const double in = fabs(remainder(at[k] - c->low[k], 2 * side));
        place[k][0] = c->low[k] + in;
        place[k][1] = c->low[k] - in;
        place[k][2] = c->high[k] + (side - in);
    }
    for (int n = 0; n < 9; n++)
        sum += block_light(c, c->levels - 1, 0, 0,
                           (const double[]){ place[0][n % 3], place[1][n / 3] }, depth);
    return sum;
}

static void find_map_place(const ref_caustics *c, ref_vec at, double place[2])
{
    place[0] = at.x + at.y * c->still[0];
    place[1] = at.z + at.y * c->still[1];
}

double ref_caustics_light(const ref_caustics *c, ref_vec at)
{
    double place[2];

    if (at.y >= 0)
        return 1;
    find_map_place(c, at, place);
    return c->fade > 0 ? block_light(c, c->levels - 1, 0, 0, place, -at.y)
                       : mirrored_light(c, place, -at.y);
}

double ref_caustics_factor(const ref_caustics *c, ref_vec at)
{
    double place[2], share = 1;

    if (!c)
        return 1;
    find_map_place(c, at, place);
    for (int k = 0; k < 2 && c->fade > 0; k++) {
        const double edge = fmin(place[k] - c->low[k], c->high[k] - place[k]);
        share = fmin(share, ref_clamp(edge / c->fade, 0, 1));
    }
    return share > 0 ? fmax(0, 1 + share * c->strength * (ref_caustics_light(c, at) - 1))
                     : 1;
}

/* -- construction -------------------------------------------------------------------- */

ref_caustics *ref_caustics_make(const ref_scene *s)
{
    double x, z;

    if (!has_caustics(s))
        return NULL;
    ref_caustics *c = calloc(1, sizeof *c);
    if (!c)
        abort();
    place_rectangle(c, s);
    c->strength = ref_number(s->scene->water.caustics);
    if (s->tank.kind == TP_TANK_NONE)
        c->fade = fmin(c->high[0] - c->low[0], c->high[1] - c->low[1]) / 8;
    refract_sun(s->light, 0, 0, c->still);
    place_grid(c, s, &x, &z);
    trace_rays(c, s, x, z);
    make_bounds(c);
    return c;
}

void ref_caustics_free(ref_caustics *c)
{
    for (int i = 0; c && i < c->levels; i++)
        free(c->bounds[i]);
    if (c)
        free(c->ray);
    free(c);
}
