/* SPDX-License-Identifier: MIT */
/* Surface of the water; see the header. */
#include "surface.h"
#include <stdlib.h>
#include "finite_depth.h"
#include "surf.h"
#include "world/pools.h"
#include "world/world.h"

/* -- extent -------------------------------------------------------------------------- */

/* Returns the width of the grid's skirt at one side, m: `reach`, but at least the width of
 * `skirt_lines` equal cells.  The skirt ends within 16000 m of the centre if that leaves
 * room for the cells.  `half` is half the width of the equal cells.  No skirt lines: 0. */
static double skirt_width(double cell, int skirt_lines, double half, double reach)
{
    return skirt_lines ? fmax(fmin(reach, 16000 - half), cell * skirt_lines) : 0;
}

/* Returns the centre of the grid on one axis, m: ahead of the eye in whole cells if the
 * grid follows the eye, else 0. */
static double cell_centre(double eye, double ahead, double cell, int count, bool follow)
{
    return follow ? cell * trunc((eye + cell * (count - 2 * (count / 8)) * 0.4 * ahead)
                                 / cell) : 0;
}

static ref_extent make_extent(const tp_scene *scene, ref_vec eye, ref_vec ahead,
                              bool fading)
{
    const double end = 16000;           /* of a fan */
    if (tp_is_walled(scene)) {
        const tp_rectangle r = tp_pool_sides(scene);
        const double half_x = ref_number(r.x1 - r.x0) / 2;
        const double half_z = ref_number(r.z1 - r.z0) / 2;
        return (ref_extent){ ref_number(r.x0) + half_x, ref_number(r.z0) + half_z, half_x,
                             half_z, half_x, half_z, 0 };
    }
    if (tp_has_fan(scene))
        return (ref_extent){ eye.x, eye.z, end, end, end, end, 0 };
    const int cols = scene->grid.cols, rows = scene->grid.rows;
    const int lines = cols > rows ? cols : rows;
    const double cell = fmin(ref_number(scene->grid.cell), 16000.0 / (lines - 1));
    const double reach = ref_number(scene->grid.reach);
    const int fx = reach > 0 ? (cols / 8 < 12 ? cols / 8 : 12) : 0;
    const int fz = reach > 0 ? (rows / 8 < 12 ? rows / 8 : 12) : 0;
    ref_extent e = {
        .x = cell_centre(eye.x, ahead.x, cell, cols, scene->grid.follow),
        .z = cell_centre(eye.z, ahead.z, cell, rows, scene->grid.follow),
        .half_x = cell * (cols - 2 * fx - 1) / 2,
        .half_z = cell * (rows - 2 * fz - 1) / 2,
    };

    e.out_x = e.half_x + skirt_width(cell, fx, e.half_x, reach);
    e.out_z = e.half_z + skirt_width(cell, fz, e.half_z, reach);
    e.fade = fading && fx ? cell * ((cols - 2 * fx) / 8 + 1) : 0;
    return e;
}

static double edge_fade(const ref_extent *e, double x0, double z0)
{
    if (e->fade == 0)
        return 1;
    return ref_smoothstep(0, e->fade, e->half_x - fabs(x0 - e->x))
         * ref_smoothstep(0, e->fade, e->half_z - fabs(z0 - e->z));
}

bool ref_surface_moves(const ref_surface *s, double x, double z)
{
    const ref_extent *e = &s->extent;
    return e->fade == 0 || (fabs(x - e->x) < e->half_x + s->reach
                            && fabs(z - e->z) < e->half_z + s->reach);
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

ref_surface ref_surface_make(const tp_scene *scene, const tp_world *world, ref_vec eye,
                             ref_vec ahead, bool fading)
{
    ref_surface s = {
        .sea = ref_deep_water_make(scene->wave, TP_WAVES, scene->water.gravity),
        .relief = ref_relief_make(world, ref_number(scene->water.pool_normal_strength)),
        .extent = make_extent(scene, eye, ahead, fading),
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

/* Displaced point of a rest point; the fade scales the Jacobian too. */
static ref_point rest_point(const ref_surface *s, double x0, double z0, bool exact)
{
    const double fade = edge_fade(&s->extent, x0, z0);
    ref_point p = { .x = x0, .z = z0, .jxx = 1, .jzz = 1, .ny = 1 };

    if (fade == 0)
        return p;
    if (s->coastal)
        p = exact ? ref_coastal_exact(s->coastal, s->phase, x0, z0)
                  : ref_coastal_rest(s->coastal, s->phase, x0, z0);
    else
        p = ref_at_rest(&s->sea, s->phase, x0, z0);
    if (fade == 1)
        return p;
    p.x = x0 + fade * (p.x - x0);
    p.y *= fade;
    p.z = z0 + fade * (p.z - z0);
    p.hx *= fade;
    p.hz *= fade;
    p.jxx = 1 + fade * (p.jxx - 1);
    p.jxz *= fade;
    p.jzz = 1 + fade * (p.jzz - 1);
    p.nx = p.hz * p.jxz - p.hx * p.jzz;
    p.ny = p.jxx * p.jzz - p.jxz * p.jxz;
    p.nz = p.hx * p.jxz - p.hz * p.jxx;
    return p;
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
    if (!ref_surface_moves(s, x, z)) {
        rest[0] = x;
        rest[1] = z;
        return 0;
    }
    begin_near(s, x, z, rest);
    const ref_point p = above(s, x, z, rest, off);
    return p.y + edge_fade(&s->extent, rest[0], rest[1])
               * ref_relief_sample(&s->relief, x, z).height;
}

ref_water ref_surface_sample(const ref_surface *s, double x, double z, double rest[2])
{
    const ref_extent *e = &s->extent;

    begin_near(s, x, z, rest);
    above(s, x, z, rest, 1e-12);
    const ref_point p = rest_point(s, rest[0], rest[1], true);
    const double fade = edge_fade(e, rest[0], rest[1]);
    const ref_heights more = ref_relief_sample(&s->relief, x, z);
    const bool inside = fabs(rest[0] - e->x) <= e->out_x
                     && fabs(rest[1] - e->z) <= e->out_z;

    return (ref_water){
        .at = { x, p.y + fade * more.height, z }, .x0 = rest[0], .z0 = rest[1],
        .slope_x = -p.nx / p.ny + fade * more.slope_x,
        .slope_z = -p.nz / p.ny + fade * more.slope_z,
        .bump_x = { more.bump_x[0], more.bump_x[1] },
        .bump_z = { more.bump_z[0], more.bump_z[1] },
        .wet = inside && !(s->coastal
                           && ref_coastal_floor(s->coastal, rest[0], rest[1]).depth <= 0),
    };
}
