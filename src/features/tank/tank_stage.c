/* SPDX-License-Identifier: MIT */
/* Span stage of the stone of a tank and of a pool's inner walls. */
#include "features/tank/tank.h"
#include "shade/beam.h"
#include "shade/wall_material.h"

/* Shades stone.  The texture is projected along the largest component of the normal:
 * on x y, z y or x z. */
void tp_stage_wall(const tp_shade *shade, tp_run *run)
{
    for (int32_t i = 0; i < run->count; i++) {
        tp_packed_dir n = run->n[i];
        int32_t x = tp_abs(tp_dir_x(n)), y = tp_abs(tp_dir_y(n)), z = tp_abs(tp_dir_z(n));
        tp_refracted_ray ray;
        tp_underwater_set_start_points(shade, run, i, i + 1, &ray);
        tp_fx s = x > y && x > z ? ray.at.z : ray.at.x;
        tp_fx t = y >= x && y >= z ? ray.at.z : -ray.at.y;
        uint32_t colour =
            tp_wall_material_sample(&shade->underwater->wall, s, t, ray.far, false);
        run->colour[i] = tp_wall_material_light(shade, colour, n);
    }
}

const tp_stage tp_tank_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_tank(X)
#undef X
};
