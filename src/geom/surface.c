/* SPDX-License-Identifier: MIT */
/* The water's surface, all models together; see the header.
 *
 * Above a given place the surface is found by inversion of what displaces sideways
 * [E1]: by the sea's own Newton steps, or, over an ocean, whose tables have no
 * derivatives, by p0 <- p0 + (p - P(p0)) with one step's memory (Anderson's mixing): as
 * much of the last step is taken back as makes the error least along the line of the last
 * two.  On 32,000 places with steepness sums to 0.9, deep and over a beach, twelve steps
 * left 0.3 mm at the most; plain ones, which leave q^n of a sum q, 0.29 m. */
#include "geom/waters.h"

#define STEPS 12
#define CLOSE 4         /* 16.16: 0.06 mm */
#define REACH TP_FX(511)/* above 0.95 x 2000 m / 2 pi = 303 m, the most without overhangs */
#define MIX   (4 * 256) /* the most of a step that is taken back or repeated, Q8 */

static void add(tp_relief *sum, tp_relief more)
{
    sum->height += more.height;
    sum->slope_x += more.slope_x;
    sum->slope_z += more.slope_z;
}

tp_relief tp_surface_relief(const tp_surface *surface, tp_fx x, tp_fx z)
{
    tp_relief sum = { 0, 0, 0 };

    if (surface->rings)
        sum = surface->by->rings->relief(surface->ring, surface->rings, x, z);
    if (surface->pool)
        add(&sum, surface->by->pools->relief(surface->pool, x, z, surface->back));
    if (surface->field)
        add(&sum, surface->by->pools->relief(surface->field, x, z, surface->back));
    return sum;
}

tp_relief tp_surface_relief_faded(const tp_surface *surface, tp_fx x, tp_fx z, tp_fx fade)
{
    TP_ASSERT(fade >= 0 && fade <= TP_FX_ONE);
    if (fade == 0)
        return (tp_relief){ 0, 0, 0 };
    tp_relief relief = tp_surface_relief(surface, x, z);
    if (fade == TP_FX_ONE)
        return relief;
    return (tp_relief){ tp_fx_mul(relief.height, fade), tp_fx_mul(relief.slope_x, fade),
                        tp_fx_mul(relief.slope_z, fade) };
}

/* Rings add up to no more than 4 m each; a pool has its range. */
static tp_fx relief_height(const tp_surface *surface)
{
    int64_t sum = 0;

    for (uint32_t i = 0; i < surface->rings; i++)
        sum += (surface->ring[i].gain_q24 >> 8) + 1;
    if (surface->pool)
        sum += surface->by->pools->highest(surface->pool);
    if (surface->field)
        sum += surface->by->pools->highest(surface->field);
    return (tp_fx)(sum < 1024 * TP_FX_ONE ? sum : 1024 * TP_FX_ONE);
}

tp_fx tp_surface_reach(const tp_surface *surface)
{
    return surface->ocean ? surface->by->ocean->reach(surface->ocean) : surface->sea->reach;
}

tp_fx tp_surface_height(const tp_surface *surface)
{
    tp_fx waves = surface->ocean ? surface->by->ocean->height(surface->ocean)
                                 : surface->sea->height;
    return waves + relief_height(surface);
}

/* A search along one axis: the place, the last error, the step after it. */
typedef struct {
    tp_fx   at;
    int64_t error, step;
} search;

/* The root lies within the reach of the place that is asked for, and so does the search;
 * at the ends of 16.16 it stays there. */
static void go(search *s, int64_t error, int64_t by, tp_fx place, tp_fx reach)
{
    int64_t step = error - by * (s->step + error - s->error) / 256;
    int64_t off = tp_limit(s->at + step - place, reach);
    tp_fx   to = tp_fx_held(place + off);

    s->step = (int64_t)to - s->at;
    s->error = error;
    s->at = to;
}

/* Errors are below REACH and 303 m more, 2^25.7, so that products have 54.4 bits and 256
 * times both of them fit. */
static int64_t mixed(const search *u, const search *w, int64_t dx, int64_t dz)
{
    int64_t ux = dx - u->error, uz = dz - w->error, over = ux * ux + uz * uz;
    int64_t by = over > 0 ? (dx * ux + dz * uz) * 256 / over : 0;

    return by > MIX ? MIX : by < -MIX ? -MIX : by;
}

/* Slopes by points a little to each side: a floor's waves have no closed form. */
static tp_sea_point ocean_above(const tp_surface *surface, tp_fx x, tp_fx z,
                                tp_fx rest[2])
{
    tp_fx most = tp_ocean_reach(surface->ocean), reach = most < REACH ? most : REACH;
    search u = { x, 0, 0 }, w = { z, 0, 0 };
    tp_ocean_point at;

    go(&u, (int64_t)rest[0] - x, 0, x, reach);      /* held to the box */
    go(&w, (int64_t)rest[1] - z, 0, z, reach);
    at = tp_ocean_smooth(surface->ocean, surface->phases, u.at, w.at);
    for (int n = 0; n < STEPS; n++) {
        int64_t dx = (int64_t)x - at.position.x, dz = (int64_t)z - at.position.z;
        if (dx < CLOSE && dx > -CLOSE && dz < CLOSE && dz > -CLOSE)
            break;
        int64_t by = n > 0 ? mixed(&u, &w, dx, dz) : 0;
        go(&u, dx, by, x, reach);
        go(&w, dz, by, z, reach);
        at = tp_ocean_smooth(surface->ocean, surface->phases, u.at, w.at);
    }
    rest[0] = u.at;
    rest[1] = w.at;
    return (tp_sea_point){ .position = at.position };
}

/* 1/32 m either way: an eighth of the shortest wave. */
static void ocean_slopes(const tp_surface *surface, tp_sea_point *at, const tp_fx rest[2])
{
    const tp_fx d = TP_FX_ONE / 32;
    const tp_fx way[4][2] = { { -d, 0 }, { d, 0 }, { 0, -d }, { 0, d } };
    tp_vec3 p[4];

    for (int k = 0; k < 4; k++)
        p[k] = tp_ocean_smooth(surface->ocean, surface->phases,
                               tp_fx_plus(rest[0], way[k][0]),
                               tp_fx_plus(rest[1], way[k][1])).position;
    tp_slopes_across(tp_vec3_sub(p[1], p[0]), tp_vec3_sub(p[3], p[2]), &at->slope_x,
                     &at->slope_z);
}

tp_sea_point tp_surface_ocean_above(const tp_surface *surface, tp_fx x, tp_fx z,
                                    tp_fx rest[2])
{
    TP_ASSERT(surface->ocean != NULL && rest != NULL);
    tp_sea_point at = ocean_above(surface, x, z, rest);
    ocean_slopes(surface, &at, rest);
    return at;
}

tp_sea_point tp_surface_above(const tp_surface *surface, tp_fx x, tp_fx z, tp_fx rest[2])
{
    tp_fx from[2] = { x, z };
    tp_sea_point at = { .position = { x, 0, z } };

    if (!rest)
        rest = from;
    if (surface->ocean)
        at = surface->by->ocean->above(surface, x, z, rest);
    else if (surface->by->swells)
        at = surface->by->swells->above(surface->sea, surface->phases, x, z, rest);
    if (tp_surface_has_relief(surface)) {
        tp_relief relief = tp_surface_relief(surface, x, z);
        at.position.y += relief.height;
        at.slope_x += relief.slope_x;
        at.slope_z += relief.slope_z;
    }
    return at;
}

/* N = across x along, the two ways as the grid's columns and rows run; a slope is
 * -N over N.y, which is held from below: what overhangs is as steep as can be. */
void tp_slopes_across(tp_vec3 along_x, tp_vec3 along_z, tp_fx *slope_x, tp_fx *slope_z)
{
    int64_t nx = (int64_t)along_z.y * along_x.z - (int64_t)along_z.z * along_x.y;
    int64_t ny = (int64_t)along_z.z * along_x.x - (int64_t)along_z.x * along_x.z;
    int64_t nz = (int64_t)along_z.x * along_x.y - (int64_t)along_z.y * along_x.x;
    int64_t most = (nx < 0 ? -nx : nx) + (nz < 0 ? -nz : nz);

    for (; most > (int64_t)1 << 40; most >>= 1) {
        nx /= 2;
        ny /= 2;
        nz /= 2;
    }
    if (ny * 8 <= most)             /* also where all three are 0 */
        ny = most / 8 + 1;
    *slope_x = (tp_fx)(-nx * TP_FX_ONE / ny);
    *slope_z = (tp_fx)(-nz * TP_FX_ONE / ny);
}
