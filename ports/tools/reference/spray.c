/* SPDX-License-Identifier: MIT */
/* Streaks of spray; see the header. */
#include "spray.h"
#include <stdlib.h>
#include "features/spray/spray.h"
#include "inside.h"
#include "sky_light.h"

#define LONGEST 6               /* pixels: longest streak */
#define BLUR    1               /* pixels: the engine's smallest radius */

/* Place at a moment, `back` ticks before the last tick. A point under level water appears
 * at 3/4 of its depth. */
static ref_vec apparent_place(const tp_speck *speck, double back, bool through)
{
    const ref_vec now = ref_vec_make(speck->place), last = ref_vec_make(speck->last);
    ref_vec at = ref_plus(now, ref_times_vec(ref_sub(last, now), back));

    if (through && at.y < 0)
        at.y *= 0.75;
    return at;
}

/* Twice the width in pixels at a depth: spray.size times the speck's own factor. */
static double streak_width(const ref_scene *s, const tp_speck *speck, double depth)
{
    const double own = 0.5 + speck->chance * 77 % 256 / 256.0;
    return 2 * own * ref_number(s->scene->spray.size) * s->camera.focal / depth;
}

/* Widens a streak to the engine's smallest radius. */
static void blur(ref_speck *d)
{
    const double way = hypot(d->du, d->dv);

    if (d->radius >= BLUR)
        return;
    d->opacity *= d->radius / BLUR * (d->radius + way) / (BLUR + way);
    d->radius = BLUR;
}

static void add_streak(ref_scene *s, const tp_speck *speck, double back)
{
    const bool through = speck->kind == TP_SPECK_BUBBLE && !s->immersion;
    const ref_vec at = apparent_place(speck, back, through);
    const ref_vec way = ref_times_vec(ref_sub(ref_vec_make(speck->place),
                                              ref_vec_make(speck->last)), 0.25);
    const ref_vec view = ref_view(&s->camera, at),
                  end = ref_view(&s->camera, ref_plus(at, way));
    ref_speck d = { .depth = view.z, .through = through };

    if (view.z < fmax(1, s->camera.near))
        return;
    d.u = ref_u(&s->camera, view);
    d.v = ref_v(&s->camera, view);
    if (end.z >= s->camera.near) {
        d.du = ref_u(&s->camera, end) - d.u;
        d.dv = ref_v(&s->camera, end) - d.v;
    }
    const double wide = streak_width(s, speck, view.z);
    const double whole = wide + 2 * hypot(d.du, d.dv), by = fmin(1, LONGEST / whole);
    d.radius = wide / 2 * by;
    d.du *= by;
    d.dv *= by;
    d.opacity = fmin(1, view.z - 1) * wide / whole;
    if (s->meshed)
        blur(&d);
    s->speck[s->specks++] = d;
}

void ref_spray_open(ref_scene *s, const tp_world *world)
{
    const tp_spray *spray = tp_world_spray(world);
    const bool clear = s->scene->water.clarity > 0;

    if (!spray)
        return;
    s->speck = calloc(spray->count + 1, sizeof *s->speck);
    if (!s->speck)
        abort();
    for (uint32_t i = 0; i < spray->count; i++) {
        const tp_speck *speck = &tp_spray_list(spray)[i];
        if (speck->kind == TP_SPECK_SPRAY || s->immersion || clear)
            add_streak(s, speck, ref_number(world->lag));
    }
}

/* Opacity of a streak at a place of the picture. */
static double streak_opacity(const ref_speck *d, double u, double v)
{
    const double square = d->du * d->du + d->dv * d->dv;
    const double along = (u - d->u) * d->du + (v - d->v) * d->dv;
    const double t = square > 0 ? ref_clamp(along / square, -1, 1) : 0;
    const double off = hypot(u - d->u - t * d->du, v - d->v - t * d->dv) / d->radius;

    return off < 1 ? d->opacity * (1 - off * off) : 0;
}

double ref_spray_blend(const ref_scene *s, const ref_ray *ray, double t1, bool water,
                       ref_colour *colour)
{
    const ref_camera *c = &s->camera;
    const ref_vec view = { ref_dot(ray->way, c->right), ref_dot(ray->way, c->up),
                           ref_dot(ray->way, c->ahead) };
    const double u = ref_u(c, view), v = ref_v(c, view);
    double clear = 1;

    for (int i = 0; i < s->specks; i++) {
        const ref_speck *d = &s->speck[i];
        const double t = d->depth / view.z;
        const double share = t < t1 || (water && d->through) ? streak_opacity(d, u, v) : 0;
        if (share <= 0)
            continue;
        ref_colour own = ref_spray_colour(s, ray->way);
        own = s->immersion ? ref_shade_absorbed(s, own, t)
                           : ref_heaven_haze(s, own, ref_ray_point(ray, t));
        *colour = ref_mix(*colour, own, share);
        clear *= 1 - share;
    }
    return 1 - clear;
}

/* Specks scatter light forward: from the light of a level surface to full light, by the
 * square of half of 1 plus the cosine between the direction and the light. */
ref_colour ref_spray_colour(const ref_scene *s, ref_vec way)
{
    const double lit = s->ambient + (1 - s->ambient) * ref_clamp(s->light.y, 0, 1);
    const double glow = (1 + ref_dot(way, s->light)) / 2;

    return ref_scale(ref_colour_unpack((uint32_t)s->scene->foam.colour),
                     lit + (1 - lit) * glow * glow);
}
