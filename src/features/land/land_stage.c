/* SPDX-License-Identifier: MIT */
/* Span stages of land.  The stage `land` shades one plain colour; the stage `ground`
 * textures and lights the land like the floor under water. */
#include "features/land/land.h"
#include "shade/material.h"
#include "shade/refracted_ray.h"
#include "tidepool/modules.h"

/* tp_run.mine begins with a tp_land_look. */
void tp_stage_land(const tp_shade *shade, tp_run *run)
{
    const tp_solid *land = run->mine;

    const uint32_t shine = tp_solid_shine(shade, land);

    tp_run_fill_vectors_to_eye(shade, &shade->world, run);
    for (int32_t i = 0; i < run->count; i++)
        run->colour[i] = tp_phong(shade, &shade->world, land, land->diffuse, shine,
                                  tp_vec_q14_unpack(run->n[i]),
                                  (tp_vec_q14){ run->vx[i], run->vy[i], run->vz[i] },
                                  run->lv[i], 0);
}

/* -- swash --------------------------------------------------------------------------- */

/* Returns the height, m, to which the swash reaches at a point of the beach: 0.15 to 0.85
 * of the run-up by the wave's phase, which wanders along the beach, and ragged by 0.06. */
static tp_fx swash_height(const tp_land_look *land, tp_fx x, tp_fx z)
{
    const tp_turn far = (tp_turn)x * 1771u + (tp_turn)z * 2203u;    /* 37 m, 30 m */
    const tp_turn near = (tp_turn)x * 7933u + (tp_turn)z * 9973u;   /* 8.3 m, 6.6 m */
    const tp_turn phase = land->phase + (tp_turn)(tp_sin(far) / 2);
    const tp_q30 level = TP_Q30(0.5) + tp_q30_mul(TP_Q30(0.35), tp_sin(phase))
                       + tp_q30_mul(TP_Q30(0.06), tp_sin(near));

    return tp_q30_mul(land->runup, level);
}

#define DARKER 90               /* of 256: light lost by wet sand */
#define GLOSSY 40               /* of 256: sky in the sheet of water */
#define WHITE  200              /* of 256: opacity of foam at the front */

/* Returns the colour of sand at a height y above the level: dark below the run-up and the
 * darker the nearer to the swash, glossy under the sheet, white at the front, whose foam is
 * a tenth of the run-up high. */
static uint32_t wet_colour(const tp_shade *shade, const tp_land_look *land, uint32_t colour,
                           tp_vec3 at)
{
    const tp_fx front = swash_height(land, at.x, at.z), high = land->runup / 10 + 1;

    if (at.y > front)
        return tp_colour_scale(colour, 256 - (uint32_t)((int64_t)DARKER
                                                        * (land->runup - at.y)
                                                        / (land->runup - front)));
    colour = tp_colour_mix(tp_colour_scale(colour, 256 - DARKER), shade->sky[0], GLOSSY);
    if (front - at.y >= high)
        return colour;
    return tp_colour_mix(colour, land->foam,
                         (uint32_t)((int64_t)WHITE * (high - (front - at.y)) / high));
}

static uint32_t ground_colour(const tp_shade *shade, const tp_land_look *land,
                              tp_packed_dir n, const tp_refracted_ray *ray)
{
    const uint32_t texel = tp_wall_material_sample(&shade->underwater->floor, ray->at.x,
                                                   ray->at.z, ray->far, true);
    const uint32_t colour = tp_light_matt_colour(shade, texel, n);

    return ray->at.y < land->runup ? wet_colour(shade, land, colour, ray->at) : colour;
}

void tp_stage_ground(const tp_shade *shade, tp_run *run)
{
    tp_refracted_ray ray[TP_UNDERWATER_ROW];

    for (int32_t i = 0, stop; i < run->count; i = stop) {
        stop = tp_block_end(run, i);
        tp_underwater_set_start_points(shade, run, i, stop, ray);
        for (int32_t k = i; k < stop; k++)
            run->colour[k] = ground_colour(shade, run->mine, run->n[k], &ray[k - i]);
    }
}

const tp_stage tp_land_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_land(X)
#undef X
};
