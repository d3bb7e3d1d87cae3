/* SPDX-License-Identifier: MIT */
/* The wave models of the water surface, as structs that a program names. */
#include "geom/waters.h"

const struct tp_water_rings tp_water_rings = { tp_ring_height_slope, tp_ring_evaluate,
                                               tp_batch_add_rings_and_pools };

const struct tp_water_pools tp_water_pools = {
    tp_pool_height_slope, tp_pool_height_bound, tp_batch_add_rings_and_pools,
};

#define SWELLS(init_by) \
    .init = init_by, .above = tp_deep_water_sample, \
    .begin = tp_vertex_set_swells, .columns = tp_vertex_set_columns, \
    .row = tp_vertex_set_row, .displace_axis = tp_batch_displace_axis, .slope = tp_batch_set_slopes, \
    .point = tp_level_sample_surface

const struct tp_water_swells tp_water_swells = { SWELLS(tp_deep_water_init) };

const struct tp_water_swells tp_water_few_swells = {
    SWELLS(tp_deep_water_init_compact), .few = true,
};

const struct tp_water_sharp tp_water_sharp = { tp_batch_add_sharp_swells };

const struct tp_water_coastal tp_water_coastal = {
    .max_displacement = tp_coastal_max_displacement,
    .height = tp_coastal_max_height,
    .above = tp_surface_coastal_sample,
    .smooth = tp_coastal_displace_smooth,
    .floor = tp_coastal_floor,
    .layout = tp_grid_layout_coastal,
    .row = tp_sheet_place_row,
    .corner = tp_sheet_make_view_vertex,
};

const struct tp_water_lod tp_water_lod = {
    tp_lod_layout, tp_lod_thin, tp_lod_step, tp_lod_swell_share,
};
