/* SPDX-License-Identifier: MIT */
/* The wave models of the water surface, as structs that a program names. */
#include "geom/waters.h"

const struct tp_water_rings tp_water_rings = { tp_ring_relief, tp_ring_evaluate,
                                               tp_run_add_relief };

const struct tp_water_pools tp_water_pools = {
    tp_pool_relief, tp_pool_height_bound, tp_run_add_relief,
};

#define SWELLS(init_by) \
    .init = init_by, .above = tp_sea_sample, \
    .begin = tp_vertex_set_swells, .columns = tp_vertex_set_columns, \
    .row = tp_vertex_set_row, .sway = tp_run_displace_axis, .slope = tp_run_set_slopes, \
    .point = tp_level_sample_surface

const struct tp_water_swells tp_water_swells = { SWELLS(tp_sea_init) };

const struct tp_water_swells tp_water_few_swells = {
    SWELLS(tp_sea_init_compact), .few = true,
};

const struct tp_water_sharp tp_water_sharp = { tp_run_add_sharp_swells };

const struct tp_water_ocean tp_water_ocean = {
    .reach = tp_ocean_max_displacement,
    .height = tp_ocean_max_height,
    .above = tp_surface_ocean_sample,
    .smooth = tp_ocean_displace_smooth,
    .floor = tp_ocean_floor,
    .carve = tp_grid_carve_ocean,
    .row = tp_sheet_place_row,
    .corner = tp_sheet_make_view_vertex,
};

const struct tp_water_lod tp_water_lod = {
    tp_lod_carve, tp_lod_thin, tp_lod_step, tp_lod_swell_share,
};
