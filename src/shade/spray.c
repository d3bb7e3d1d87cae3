/* SPDX-License-Identifier: MIT */
/* The stage of spray. */
#include "shade/shade.h"

/* Specks are too small for a shape: one light for all. */
void tp_stage_spray(const tp_shade *shade, tp_run *run)
{
    for (int32_t i = 0; i < run->count; i++)
        run->colour[i] = shade->spray;
}
