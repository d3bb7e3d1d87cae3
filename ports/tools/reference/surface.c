/* SPDX-License-Identifier: MIT */
/* Surface of the water; see the header. */
#include "surface.h"
#include <stdlib.h>
#include "finite_depth.h"
#include "surf.h"
#include "world/pools.h"
#include "world/world.h"

/* -- extent -------------------------------------------------------------------------- */

static ref_extent make_extent(const tp_scene *scene, ref_vec eye)
{
    const double far = 16000;

    if (!tp_is_walled(scene))
        return (ref_extent){ eye.x, eye.z, far, far };
    const tp_rectangle r = tp_pool_sides(scene);
    const double half_x = ref_number(r.x1 - r.x0) / 2, half_z = ref_number(r.z1 - r.z0) / 2;
    return (ref_extent){ ref_number(r.x0) + half_x, ref_number(r.z0) + half_z, half_x,
                         half_z };
}

/* -- construction -------------------------------------------------------------------- */

/* Bounds of deep water: [A11] bounds the smallest stretch of rest points. */
static void bound_sea(ref_surface *s)
{
    double q = 0;

    for (int i = 0; i < s->sea.count; i++) {
        const ref_wave *w = &s->sea.wave[i];
        const double sharp = w->power == 1 ? 1 : 0.63 + 0.65 * sqrt(w->power);
        s->high += w->amplitude * (w->power == 1 ? 1 : 2);
        s->reach += w->q / w->k;
        s->steep += w->k * w->amplitude * sharp;
        q += w->q;
    }
    s->steep /= 1 - fmin(q, 0.95);
}

ref_surface ref_surface_make(const tp_scene *scene, const tp_world *world, ref_vec eye)
{
    ref_surface s = {
        .sea = ref_deep_water_make(scene->wave, TP_WAVES, scene->water.gravity),
        .relief = ref_relief_make(world, ref_number(scene->water.pool_normal_strength)),
        .extent = make_extent(scene, eye),
        .close = REF_CLOSE,
    };
    const double back = ref_number(world->lag);

    ref_phases(&s.sea, world->tick, s.phase);
    for (int i = 0; i < s.sea.count; i++)
        s.phase[i] += back * (double)s.sea.wave[i].turns_tick * 2 * PI;
    s.coastal = ref_coastal_make(scene, world, &s.sea);
    if (s.coastal) {
        s.high = s.coastal->high;
        s.reach = s.coastal->reach;
        s.steep = s.coastal->steep;
    } else {
        bound_sea(&s);
    }
    s.high += s.relief.high + 1e-9;
    s.steep += s.relief.steep;
    s.fine = s.relief.fine;
    for (int i = 0; i < s.sea.count; i++)
        s.fine = fmin(s.fine, 2 * PI / s.sea.wave[i].k);
    return s;
}

void ref_surface_free(ref_surface *surface)
{
    ref_relief_free(&surface->relief);
    free(surface->coastal);
}

/* -- points -------------------------------------------------------------------------- */

/* Displaced point of a rest point. */
static ref_point rest_point(const ref_surface *s, double x0, double z0, bool exact)
{
    if (!s->coastal)
        return ref_at_rest(&s->sea, s->phase, x0, z0);
    return exact ? ref_coastal_exact(s->coastal, s->phase, x0, z0)
                 : ref_coastal_rest(s->coastal, s->phase, x0, z0);
}

/* hypot() takes as long as several waves; no metres overflow. */
static double distance(double x, double z)
{
    return sqrt(x * x + z * z);
}

/* Newton's method; the step is halved if the full step does not come nearer. */
static ref_point above(const ref_surface *s, double x, double z, double rest[2],
                       double off)
{
    ref_point p = rest_point(s, rest[0], rest[1], false);
    double step = 1;

    for (int n = 0; n < 100; n++) {
        const double ex = x - p.x, ez = z - p.z, far = distance(ex, ez);
        if (far <= off || step < 1e-9)
            break;
        const double x0 = rest[0] + step * (ex * p.jzz - ez * p.jxz) / p.ny;
        const double z0 = rest[1] + step * (ez * p.jxx - ex * p.jxz) / p.ny;
        const ref_point next = rest_point(s, x0, z0, false);
        if (distance(x - next.x, z - next.z) < far) {
            rest[0] = x0;
            rest[1] = z0;
            p = next;
            step = fmin(1, 2 * step);
        } else {
            step /= 2;
        }
    }
    return p;
}

/* Restarts the search at the place itself if the start is too far away. */
static void begin_near(const ref_surface *s, double x, double z, double rest[2])
{
    if (!(distance(rest[0] - x, rest[1] - z) <= s->reach)) {
        rest[0] = x;
        rest[1] = z;
    }
}

double ref_surface_height(const ref_surface *s, double x, double z, double rest[2],
                          double off)
{
    begin_near(s, x, z, rest);
    const ref_point p = above(s, x, z, rest, off);
    return p.y + ref_relief_sample(&s->relief, x, z).height;
}

ref_water ref_surface_sample(const ref_surface *s, double x, double z, double rest[2])
{
    const ref_extent *e = &s->extent;

    begin_near(s, x, z, rest);
    above(s, x, z, rest, 1e-12);
    const ref_point p = rest_point(s, rest[0], rest[1], true);
    const ref_heights more = ref_relief_sample(&s->relief, x, z);
    const bool inside = fabs(rest[0] - e->x) <= e->half_x
                     && fabs(rest[1] - e->z) <= e->half_z;

    return (ref_water){
        .at = { x, p.y + more.height, z }, .x0 = rest[0], .z0 = rest[1],
        .slope_x = -p.nx / p.ny + more.slope_x,
        .slope_z = -p.nz / p.ny + more.slope_z,
        .bump_x = { more.bump_x[0], more.bump_x[1] },
        .bump_z = { more.bump_z[0], more.bump_z[1] },
        .wet = inside && !(s->coastal
                           && ref_coastal_floor(s->coastal, rest[0], rest[1]).depth <= 0),
    };
}
