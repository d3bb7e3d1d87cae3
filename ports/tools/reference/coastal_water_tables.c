/* SPDX-License-Identifier: MIT */
/* Properties of each coastal wave by depth: [B2]-[B15], as a table of doubles. */
#include <stdlib.h>
#include "coastal_water.h"
#include "finite_depth.h"
#include "surf.h"
#include "world/module.h"

static double least(double a, double b)
{
    return a < b ? a : b;
}

static double table_depth(int i)
{
    return exp2(i / 64.0) / 16;
}

static double across(double k, double kz)
{
    return k > fabs(kz) ? sqrt(k * k - kz * kz) : 0;
}

/* Amplitude A Ks Kr, capped by [B15] and by Miche's height. Miche's cap is never below the
 * part of it that the wave already has on deep water. */
static double local_amplitude(const ref_coastal_wave *w, double k, double kz, double h,
                              bool mapped)
{
    const double kr = mapped ? 1
        : sqrt(fmax(across(w->deep.k, kz) / w->deep.k, 1 / 16.0)
               / fmax(across(k, kz) / k, 1 / 16.0));
    const double here = 0.142 * 2 * PI / k * tanh(k * h);
    const double deep = 0.142 * 2 * PI / w->deep.k;
    const double miche = fmax(here / 2, here * w->deep.amplitude / deep);

    return least(least(w->deep.amplitude * ref_shoaling(w->deep.k, k, h) * kr, 0.39 * h),
                 miche);
}

static void bend(const ref_coastal *o, const ref_coastal_wave *w, double kz, double k,
                 ref_depth_node *n)
{
    const double up = w->deep.dx * o->up_x + w->deep.dz * o->up_z;
    const double kx = up < 0 ? -across(k, kz) : across(k, kz);

    n->way_x = (kx * o->up_x - kz * o->up_z) / k;
    n->way_z = (kx * o->up_z + kz * o->up_x) / k;
}

/* True for a surging wave on a straight beach [B20]: its orbits do not widen. */
static bool is_surging(const ref_coastal *o, const ref_coastal_wave *w)
{
    const double height = 2 * w->deep.amplitude, length = 2 * PI / w->deep.k;
    return !o->map && o->slope / sqrt(height / length) > 3.3;
}

static ref_depth_node place_node(const ref_coastal *o, const ref_coastal_wave *w,
                                 const tp_scene *scene, double kz, int i)
{
    const bool   deep = i == REF_DEPTHS - 1;
    const double h = table_depth(i), k = deep ? w->deep.k : ref_depth_number(w->deep.k, h);
    const double r =
        deep ? w->deep.amplitude : local_amplitude(w, k, kz, h, o->map != NULL);
    const double wide = 1 / -expm1(-ref_number(scene->surf.widening_decay) * h);
    const double sx = deep || is_surging(o, w) ? 1 : wide;
    const double sy = deep ? 1
                           : wide * -expm1(-ref_number(scene->surf.flattening_decay) * h);
    const double round = w->deep.q / w->deep.k * r / w->deep.amplitude;
    ref_depth_node n = { .k = k, .way_x = w->deep.dx, .way_z = w->deep.dz };

    n.along = deep ? round : least(least(round, 0.95 / k) * sx, 0.95 / k);
    n.up = r * sy;
    n.push = least(w->lambda * n.up, 0.5);
    if (o->slope > 0 && !deep) {
        bend(o, w, kz, k, &n);
        const double rise = o->slope * (n.way_x * o->up_x + n.way_z * o->up_z);
        n.sine = rise > 0 ? rise / hypot(1, rise) * exp(-o->k0 * h) : 0;
    }
    return n;
}

/* [B8] [B9]: integral over depth of the wave number towards the shore minus the deep-water
 * number, from the deep end; Simpson's rule in ln h. */
static void add_phases(const ref_coastal *o, ref_coastal_wave *w, double kz)
{
    const double up = w->deep.dx * o->up_x + w->deep.dz * o->up_z;
    const double deep = across(w->deep.k, kz), step = log(2) / 64;
    double sum = 0;

    for (int i = REF_DEPTHS - 2; i >= 0 && o->slope > 0; i--) {
        double f[3];
        for (int j = 0; j < 3; j++) {
            const double h = table_depth(i) * exp(j * step / 2);
            const double k = j ? ref_depth_number(w->deep.k, h) : w->node[i].k;
            f[j] = (across(k, kz) - deep) * h;
        }
        sum += step / 6 * (f[0] + 4 * f[1] + f[2]);
        w->node[i].excess = (up < 0 ? -sum : sum) / o->slope;
    }
}

static void make_wave(ref_coastal *o, ref_coastal_wave *w, const tp_scene *scene)
{
    const double wind = ref_number(scene->wind.heading) * PI / 180;
    const double kz = o->slope > 0
        ? w->deep.k * (w->deep.dz * o->up_x - w->deep.dx * o->up_z) : 0;

    w->lambda = ref_number(scene->wind.strength)
              * fmax(0, w->deep.dx * sin(wind) - w->deep.dz * cos(wind));
    w->iterations = 1;
    w->k_deep = w->deep.k;
    if (o->floored && !o->map && o->slope == 0 && o->depth < 2048)
        w->k_deep = ref_depth_number(w->deep.k, o->depth);
    for (int i = 0; i < REF_DEPTHS; i++) {
        w->node[i] = place_node(o, w, scene, kz, i);
        if (w->node[i].push > 0.3)
            w->iterations = 3;
    }
    add_phases(o, w, kz);
}

/* [A11] [B13]: scales all orbits of a depth by one factor, and computes the bounds. */
static void share(ref_coastal *o)
{
    for (int n = o->floored ? 0 : REF_DEPTHS - 1; n < REF_DEPTHS; n++) {
        double sum = 0, up = 0, reach = 0, tilt = 0, steep = 0;
        for (int i = 0; i < o->count; i++) {
            const ref_depth_node *d = &o->wave[i].node[n];
            sum += d->k * d->along * (1 + d->push);
        }
        for (int i = 0; i < o->count; i++) {
            ref_depth_node *d = &o->wave[i].node[n];
            if (sum > 0.951)
                d->along *= 0.95 / sum;
            reach += d->along + d->up;
            tilt += d->along;
            up += d->up;
            steep += d->k * (d->up + d->along * d->sine) * (1 + d->push);
        }
        o->reach = fmax(o->reach, reach);
        o->high = fmax(o->high, o->slope > 0 || o->map ? up + tilt / 2 : up);
        o->steep = fmax(o->steep, steep / (1 - least(sum, 0.95)));
    }
}

static void lay_floor(ref_coastal *o, const tp_scene *scene, const tp_world *world)
{
    const double heading = ref_number(scene->floor.heading) * PI / 180;

    o->up_x = sin(heading);
    o->up_z = -cos(heading);
    o->floored = scene->floor.depth > 0 || scene->floor.map[0];
    o->depth = scene->floor.depth > 0 ? ref_number(scene->floor.depth) : 1e9;
    o->slope = scene->floor.depth > 0 ? ref_number(scene->floor.slope) : 0;
    o->slope = o->slope < 0x1p-12 ? 0 : o->slope;
    o->k0 = ref_number(scene->surf.tilt_decay);
    if (scene->floor.map[0]) {
        o->map = tp_world_coastal(world);
        o->slope = 0;
    }
}

ref_coastal *ref_coastal_make(const tp_scene *scene, const tp_world *world,
                              const ref_deep_water *sea)
{
    if (!tp_world_coastal(world))
        return NULL;
    ref_coastal *o = calloc(1, sizeof *o);
    if (!o)
        abort();
    lay_floor(o, scene, world);
    o->count = sea->count;
    for (int i = 0; i < sea->count; i++) {
        o->wave[i].deep = sea->wave[i];
        make_wave(o, &o->wave[i], scene);
    }
    share(o);
    return o;
}
