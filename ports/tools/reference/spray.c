/* SPDX-License-Identifier: MIT */
/* Discs of spray; see the header. */
#include "spray.h"
#include <stdlib.h>
#include "features/spray/spray.h"

#define WIDE_MOST 48            /* pixels: the engine's widest disc */

/* Place at the drawn moment. A point under level water appears at 3/4 of its depth. */
static ref_vec apparent_place(const tp_speck *speck, double back, bool through)
{
    const ref_vec now = ref_vec_make(speck->place), last = ref_vec_make(speck->last);
    ref_vec at = ref_plus(now, ref_times_vec(ref_sub(last, now), back));

    if (through && at.y < 0)
        at.y *= 0.75;
    return at;
}

/* Width in pixels at a depth: spray.size times the speck's own factor. */
static double disc_width(const ref_scene *s, const tp_speck *speck, double depth)
{
    const double own = 0.5 + speck->chance * 77 % 256 / 256.0;
    return own * ref_number(s->scene->spray.size) * s->camera.focal / depth;
}

static void add_disc(ref_scene *s, const tp_speck *speck, double back)
{
    const bool through = speck->kind == TP_SPECK_BUBBLE && !s->immersion;
    const ref_vec view = ref_view(&s->camera, apparent_place(speck, back, through));
    const double wide = disc_width(s, speck, view.z);
    const bool small = s->meshed && wide < 1;

    if (view.z < s->camera.near || (small && wide * 256 <= speck->chance))
        return;
    s->speck[s->specks++] = (ref_speck){
        .u = ref_u(&s->camera, view), .v = ref_v(&s->camera, view), .depth = view.z,
        .radius = (s->meshed ? fmin(wide, WIDE_MOST) : wide) / 2,
        .through = through, .pixel = small,
    };
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
            add_disc(s, speck, ref_number(world->lag));
    }
}

static bool is_in_disc(const ref_speck *disc, double u, double v)
{
    if (disc->pixel)
        return floor(u) == floor(disc->u) && floor(v) == floor(disc->v);
    return hypot(u - disc->u, v - disc->v) <= disc->radius;
}

double ref_spray_meets(const ref_scene *s, const ref_ray *ray, double t0, double t1,
                       bool water)
{
    const ref_camera *c = &s->camera;
    const ref_vec view = { ref_dot(ray->way, c->right), ref_dot(ray->way, c->up),
                           ref_dot(ray->way, c->ahead) };
    const double u = ref_u(c, view), v = ref_v(c, view);
    double nearest = HUGE_VAL;

    for (int i = 0; i < s->specks; i++) {
        const ref_speck *disc = &s->speck[i];
        const double t = disc->depth / view.z;
        if (t >= t0 && t < nearest && (t < t1 || (water && disc->through))
            && is_in_disc(disc, u, v))
            nearest = t;
    }
    return nearest;
}

/* Specks are half way between the light of a level surface and full light. */
ref_colour ref_spray_colour(const ref_scene *s)
{
    const double lit = s->ambient + (1 - s->ambient) * ref_clamp(s->light.y, 0, 1);
    return ref_scale(ref_colour_unpack((uint32_t)s->scene->foam.colour), (1 + lit) / 2);
}
