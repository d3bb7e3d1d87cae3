/* SPDX-License-Identifier: MIT */
/* The span stage of spray.  Specks are too small for shading: all have the same colour. */
#include "shade/shade.h"
#include "tidepool/modules.h"

/* tp_run.mine begins with the colour. */
void tp_stage_spray(const tp_shade *shade, tp_run *run)
{
    const uint32_t *colour = run->mine;

    (void)shade;
    for (int32_t i = 0; i < run->count; i++)
        run->colour[i] = *colour;
}

const tp_stage tp_spray_stages[] = { tp_stage_spray };
