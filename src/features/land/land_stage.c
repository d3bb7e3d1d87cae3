/* SPDX-License-Identifier: MIT */
/* Span stages of land.  The stage `land` shades one plain colour; the stage `ground`
 * textures and lights the land like the floor under water. */
#include "shade/material.h"
#include "shade/refracted_ray.h"
#include "tidepool/modules.h"

/* tp_run.mine begins with the material, a tp_solid. */
void tp_stage_land(const tp_shade *shade, tp_run *run)
{
    const tp_solid *land = run->mine;

    tp_run_fill_vectors_to_eye(shade, &shade->world, run);
    for (int32_t i = 0; i < run->count; i++)
        run->colour[i] = tp_phong(shade, &shade->world, land, land->diffuse,
                                  tp_vec_q14_unpack(run->n[i]),
                                  (tp_vec_q14){ run->vx[i], run->vy[i], run->vz[i] },
                                  run->lv[i], 0);
}

void tp_stage_ground(const tp_shade *shade, tp_run *run)
{
    for (int32_t i = 0; i < run->count; i++) {
        tp_refracted_ray ray;
        tp_underwater_set_start_points(shade, run, i, i + 1, &ray);
        run->colour[i] = tp_light_matt_colour(
            shade,
            tp_wall_material_sample(&shade->underwater->floor, ray.at.x, ray.at.z, ray.far,
                                    true),
            run->n[i]);
    }
}

const tp_stage tp_land_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_land(X)
#undef X
};
