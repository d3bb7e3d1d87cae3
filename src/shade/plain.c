/* SPDX-License-Identifier: MIT */
/* Water of one colour, without a texture. */
#include "shade/shade.h"
#include "tidepool/modules.h"

void tp_stage_plain(const tp_shade *shade, tp_run *run)
{
    for (int32_t i = 0; i < run->count; i++)
        run->colour[i] = shade->water_colour;
}
