/* SPDX-License-Identifier: MIT */
/* The wave models of the water surface, as structs that a program names. */
#include "geom/waters.h"

const struct tp_water_rings tp_water_rings = { tp_ring_relief, tp_ring_evaluate,
                                               tp_run_relief };

const struct tp_water_pools tp_water_pools = {
    tp_pool_relief, tp_pool_highest, tp_run_relief,
};

#define SWELLS(init_by) \
    .init = init_by, .above = tp_sea_sample, \
    .begin = tp_vertex_set_swells, .columns = tp_vertex_set_columns, \
    .row = tp_vertex_set_row, .sway = tp_run_sway, .slope = tp_run_slope, \
    .point = tp_level_point

const struct tp_water_swells tp_water_swells = { SWELLS(tp_sea_init) };

const struct tp_water_swells tp_water_few_swells = {
    SWELLS(tp_sea_init_few), .few = true,
};

const struct tp_water_sharp tp_water_sharp = { tp_run_sharpen };

const struct tp_water_ocean tp_water_ocean = {
    .reach = tp_ocean_reach,
    .height = tp_ocean_height,
    .above = tp_surface_ocean_sample,
    .smooth = tp_ocean_smooth,
    .floor = tp_ocean_floor,
    .carve = tp_grid_carve_ocean,
    .row = tp_sheet_place_row,
    .corner = tp_sheet_corner,
};

const struct tp_water_lod tp_water_lod = {
    tp_lod_carve, tp_lod_thin, tp_lod_step, tp_lod_swell_share,
};
