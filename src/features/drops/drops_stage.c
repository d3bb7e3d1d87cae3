/* SPDX-License-Identifier: MIT */
/* Shading of drops: balls of clear water, with the surroundings upside down.
 *
 * A ray at the incidence i leaves a ball of index n turned by 2 (i - r) towards the
 * ball's middle, sin i = n sin r [F4].  With c = cos i = N.V two parabolas in c
 * approximate the turn: the ray goes on along cos x (-V) - s x (N - c V), where cos = 1 -
 * 7/8 (1 - c)^2 and s = 1 - 4/5 c + 3/10 c^2, within 0.05 of the exact values.  The
 * reflection at the front surface, weighted by Fresnel, and the specular lobe of the
 * light are added. */
#include "shade/env.h"
#include "shade/material.h"
#include "tidepool/modules.h"

typedef tp_vec_q14 vec;

/* Returns a x + b y; a, b in Q14. */
static vec linear_combination(vec x, int32_t a, vec y, int32_t b)
{
    return (vec){ (x.x * a + y.x * b) >> 14, (x.y * a + y.y * b) >> 14,
                  (x.z * a + y.z * b) >> 14 };
}

/* Returns the light from direction d.  Below the horizon the colour blends from the
 * horizon's into the water's colour within 14 degrees.  The water is lit by ambient light
 * and the sun. */
static uint32_t sample_surroundings(const tp_shade *shade, vec d)
{
    uint32_t light = tp_env_sample(shade, d.x, d.y > 0 ? d.y : 0, d.z);
    uint32_t sky = tp_light_colour_clamped(shade, light);

    if (d.y >= 0)
        return sky;
    int32_t bright = tp_lit_share(shade->ambient, tp_clamp(shade->world.ly, 0, 16384));
    uint32_t water = tp_colour_scale(shade->water_colour, (uint32_t)bright);
    return tp_colour_mix(sky, tp_colour_mix(water, sky, 64),
                         (uint32_t)tp_clamp(-d.y >> 4, 0, 256));
}

/* Returns the direction of the ray behind the ball. */
static vec refracted_direction(vec n, vec v, int32_t c)
{
    int32_t left = 16384 - c;
    int32_t ahead = 16384 - (left * left >> 14) * 7 / 8;
    int32_t aside = 16384 - c * 4 / 5 + (c * c >> 14) * 3 / 10;

    return linear_combination(v, (aside * c >> 14) - ahead, n, -aside);
}

static uint32_t shade_drop(const tp_shade *shade, const tp_solid *drop, vec n, vec v,
                           int32_t lv)
{
    vec     light = { shade->world.lx, shade->world.ly, shade->world.lz };
    int32_t c = tp_clamp(tp_vec_q14_dot(n, v), 0, 16384);
    int32_t nl = tp_vec_q14_dot(n, light);
    int32_t rv = nl > 0 ? tp_clamp((2 * nl * c >> 14) - lv, 0, 16384) : 0;
    uint32_t gloss = drop->gloss[rv * (TP_GLOSS - 1) >> 14];
    uint32_t clear = tp_colour_times(
        sample_surroundings(shade, refracted_direction(n, v, c)), drop->diffuse);
    uint32_t mirror = sample_surroundings(shade, linear_combination(n, 2 * c, v, -16384));

    return tp_colour_add(tp_colour_mix(clear, mirror, shade->fresnel[c >> 6]),
                         tp_colour_scale(tp_colour_times(drop->specular,
                                                         shade->light_colour), gloss));
}

/* tp_run.mine begins with the material, a tp_solid. */
void tp_stage_drop(const tp_shade *shade, tp_run *run)
{
    const tp_solid *drop = run->mine;

    tp_run_fill_vectors_to_eye(shade, &shade->world, run);
    for (int32_t i = 0; i < run->count; i++) {
        run->colour[i] = shade_drop(shade, drop, tp_vec_q14_unpack(run->n[i]),
                             (vec){ run->vx[i], run->vy[i], run->vz[i] }, run->lv[i]);
    }
}

const tp_stage tp_drops_stages[] = { tp_stage_drop };
