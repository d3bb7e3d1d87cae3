/* SPDX-License-Identifier: MIT */
/* Vertices of a fan by packed sines of tp_sin, for quality.normals = fast with exact sines.
 *
 * Places are within 16 / 65536 of the waves' displacement from the exact vertices', measured
 * 5; slopes with the whole Jacobian within 4 / 4096. */
#include "view/packed_vertices.h"

const struct tp_draw_packed_waves tp_draw_packed_waves = {{ evaluate_row,
                                                            make_view_vertices }};
