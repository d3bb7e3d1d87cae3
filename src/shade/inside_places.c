/* SPDX-License-Identifier: MIT */
/* World positions in the water of samples, from their depths; see beam.h. */
#include "shade/beam.h"
#include "shade/depth.h"

void tp_underwater_set_view(tp_underwater *in, const tp_shade *shade, tp_fx zi_near)
{
    const tp_dir3 right = shade->world.right, up = shade->world.up;
    const tp_q30 across[3] = { right.x, right.y, right.z };
    const tp_q30 along[3] = { up.x, up.y, up.z };

    for (int k = 0; k < 3; k++) {
        in->right[k] = (int64_t)across[k] * 4096 / shade->focal;
        in->up[k] = (int64_t)along[k] * 4096 / shade->focal;
    }
    in->zi_near = zi_near;
}

/* The view vector is -back + right (u - u0) / focal + up (v0 - v) / focal at 1 m of depth.
 * Q42 steps times 2^16 sixteenths of a pixel stay below 2^58; reduced to Q20, products
 * with 2^31 of depth do too. */
void tp_underwater_set_start_points(const tp_shade *shade, const tp_run *run, int32_t i,
                                    int32_t stop, tp_refracted_ray *ray)
{
    const tp_underwater *in = shade->underwater;
    const tp_dir3 back = shade->world.back;
    const int32_t eye[3] = { shade->eye.x, shade->eye.y, shade->eye.z };
    const int32_t behind[3] = { back.x, back.y, back.z };
    int64_t u = 16 * (run->x + i) + 8 - shade->u0, v = shade->v0 - 16 * run->y - 8;
    int64_t view[3];

    for (int k = 0; k < 3; k++)
        view[k] = in->right[k] * u + in->up[k] * v - behind[k] * (int64_t)4096;
    for (; i < stop; i++, ray++) {
        uint32_t zi = (run->key[i] >> 1 & ~(uint32_t)0x7f) | 0x40;
        int64_t  depth = tp_depth_from_zi(in->zi_near, zi);
        int32_t  at[3];
        for (int k = 0; k < 3; k++) {
            at[k] = tp_fx_saturate(eye[k] + (depth * (view[k] >> 22) >> 20));
            view[k] += in->right[k] * 16;
        }
        ray->at = (tp_vec3){ at[0], at[1], at[2] };
        ray->far = tp_fx_saturate(depth);
    }
}
