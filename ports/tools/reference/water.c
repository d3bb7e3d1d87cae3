/* SPDX-License-Identifier: MIT */
/* Shading of water; see the header. */
#include "water.h"
#include "foam.h"
#include "inside.h"
#include "map.h"
#include "sky_light.h"
#include "trace.h"

static double fx(tp_fx x)
{
    return x / 65536.0;
}

/* -- layers -------------------------------------------------------------------------- */

/* Tones: saturation about the texel's grey, then the values above `clamp` spread over
 * 0..1. */
static ref_colour toned(ref_colour c, const tp_scene_layer *layer)
{
    const double grey = (c.c[0] * 77 + c.c[1] * 150 + c.c[2] * 29) / 256;
    const double low = fx(layer->clamp);
    ref_colour r;

    for (int i = 0; i < 3; i++) {
        const double x = (grey + fx(layer->saturation) * (c.c[i] - grey)) / 255;
        r.c[i] = 255 * ref_clamp((ref_clamp(x, 0, 1) - low) / (1 - low), 0, 1);
    }
    return ref_times(r, ref_colour_unpack((uint32_t)layer->colour));
}

static ref_colour layers(const ref_scene *s, const ref_water *w)
{
    const tp_scene *scene = s->scene;
    const bool linear = scene->water.filter == TP_FILTER_LINEAR;
    ref_colour sum = ref_colour_unpack((uint32_t)scene->water.colour);
    double x = w->x0, z = w->z0;

    if (s->assets->distortion && scene->distortion.strength > 0) {
        const ref_colour d = ref_sample_map(s, s->assets->distortion,
                                            &scene->distortion.map, x, z, w->at, true);
        x += (d.c[0] - 128) / 128 * fx(scene->distortion.strength);
        z += (d.c[1] - 128) / 128 * fx(scene->distortion.strength);
    }
    for (int i = 0; i < TP_LAYERS; i++) {
        if (!s->assets->layer[i])
            continue;
        const ref_colour c = toned(ref_sample_map(s, s->assets->layer[i],
                                              &scene->layer[i].map, x, z, w->at,
                                              linear), &scene->layer[i]);
        sum = i == 0 ? ref_times(c, sum) : ref_add(sum, c);
    }
    return sum;
}

/* -- ripples ------------------------------------------------------------------------- */

static bool has_ripples(const ref_scene *s)
{
    return s->assets->ripple && s->scene->ripple.bump > 0;
}

/* True if the normals differ from the mesh's normals. */
static bool is_rippled(const ref_scene *s)
{
    const ref_relief *r = &s->surface.relief;
    return has_ripples(s) || (r->bump > 0 && (r->cells[0].cols || r->cells[1].cols));
}

/* Share of the slopes of a pool that bends normals only (water.pool_normal_strength): fades
 * from two cells in a pixel, 0 from four cells in a pixel. */
static double bump_share(const ref_scene *s, const ref_cells *c, ref_vec at)
{
    if (!s->meshed || c->cols == 0)
        return 1;
    return ref_clamp(2 - ref_water_lod(s, 1 / c->cell, at), 0, 1);
}

/* Normal with ripples: a texel (nx, ny, nz), green up the picture, in the surface's tangent
 * space. */
ref_vec ref_water_normal(const ref_scene *s, const ref_water *w)
{
    double slope[2] = { w->slope_x, w->slope_z };

    for (int i = 0; i < 2; i++) {
        const double share = bump_share(s, &s->surface.relief.cells[i], w->at);
        slope[0] += share * w->bump_x[i];
        slope[1] += share * w->bump_z[i];
    }
    if (has_ripples(s)) {
        const double sx = slope[0], sz = slope[1];
        const double bump = fx(s->scene->ripple.bump);
        const ref_colour c = ref_sample_map(s, s->assets->ripple, &s->scene->ripple.map,
                                        w->x0, w->z0, w->at, true);
        const double n[3] = { (c.c[0] - 128) / 128 * bump, (c.c[1] - 128) / 128 * bump,
                              fmax((c.c[2] - 128) / 128, 0.125) };
        ref_turned(sx, sz, n, slope);
    }
    return ref_unit_vec((ref_vec){ -slope[0], 1, -slope[1] });
}

/* -- mirror -------------------------------------------------------------------------- */

/* Object along the mirrored ray: boat, drops or walls; REF_SKY: none. */
static ref_seen sample_object(const ref_scene *s, const ref_water *w, ref_vec n,
                              ref_vec way)
{
    const ref_ray ray = { w->at, ref_reflected(way, n) };
    ref_seen seen = { .kind = REF_SKY };
    ref_vec at;

    if (s->scene->mirror.method != TP_MIRROR_NONE)
        seen = ref_dry(s, &ray, 1e-6, 1e5, &at);
    if (seen.kind == REF_LAND)
        seen.kind = REF_SKY;
    return seen;
}

/* Light along the mirrored ray; *share falls where the ray meets other water. R uses the
 * raised N.V: the height of R is 2 N.V Ny - Vy. */
static ref_light mirrored(const ref_scene *s, const ref_water *w, ref_vec n, double nv,
                          ref_vec way, double *share, ref_kind *in_mirror)
{
    const ref_vec r = ref_plus(way, ref_times_vec(n, 2 * nv));
    const ref_seen object = sample_object(s, w, n, way);

    *in_mirror = object.kind;
    if (object.kind != REF_SKY)
        return (ref_light){ object.colour, 0 };
    *share *= ref_clamp(1 + 4 * r.y, 0.5, 1);
    return ref_heaven_mirrored(s, r, w->at);
}

/* Adds the mirror. Light above white times a small share may end below white. */
static ref_colour with_mirror(const ref_scene *s, ref_colour c, ref_light m, double share)
{
    return ref_add(ref_scale(c, 1 - share), ref_scale(ref_heaven_whole(s, m), share));
}

/* Specular lobe [F5]; Blinn's exponent is four times Phong's. */
static double lobe(const ref_scene *s, ref_vec n, double nv, double nl, ref_vec way)
{
    const double power = fmax(1, floor(fx(s->scene->water.shininess)));

    if (nl <= 0)
        return 0;
    if (s->scene->light.model == TP_LIGHT_BLINN)
        return pow(fmax(0, ref_dot(n, ref_unit_vec(ref_sub(s->light, way)))), 4 * power);
    return pow(ref_clamp(2 * nl * nv + ref_dot(s->light, way), 0, 1), power);
}

/* Colour of the water. Ripples too small for a pixel leave a part of the water turned to
 * the eye, so N.V of rippled water is at least 0.1; only the lobe uses the actual N.V. */
ref_colour ref_water_colour(const ref_scene *s, const ref_water *w, ref_vec way,
                            ref_kind *in_mirror)
{
    const tp_scene *scene = s->scene;
    const ref_vec n = ref_water_normal(s, w);
    const double nl = ref_clamp(ref_dot(n, s->light), 0, 1);
    const double seen = ref_clamp(-ref_dot(n, way), 0, 1);
    const double nv = is_rippled(s) ? fmax(seen, 0.1) : seen;
    double share = (scene->water.fresnel == TP_FRESNEL_SCHLICK
                    ? ref_schlick(nv) : ref_fresnel_reflectance(nv, REF_INDEX))
                 * fx(scene->water.reflection);
    ref_colour c = ref_scale(layers(s, w), s->ambient + (1 - s->ambient) * nl);

    if (scene->water.clarity > 0)
        c = ref_shade_refraction(s, w->at, n, way, c);
    const ref_light mirror = mirrored(s, w, n, nv, way, &share, in_mirror);
    const double foam = ref_foam_opacity(s, w);
    c = ref_mix(with_mirror(s, c, mirror, share), ref_foam_colour(s, nl), foam);
    if (scene->water.specular > 0)
        c = ref_add(c, ref_scale(ref_colour_unpack((uint32_t)scene->light.colour),
                                 (1 - foam) * fmin(1, fx(scene->water.specular)
                                                      * lobe(s, n, seen, nl, way))));
    return c;
}
