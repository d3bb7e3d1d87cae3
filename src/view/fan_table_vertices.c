/* SPDX-License-Identifier: MIT */
/* Vertices of a fan by a table of packed sines, for quality.sine = fast: the nearest of 1024
 * pairs, 4 KB of constants.  A sine is within 0.0031: 3 instructions for sine and cosine,
 * where two calls of tp_sin take about 50.
 *
 * Places are within 420 / 65536 of the waves' displacement from the exact vertices',
 * measured 392; pictures of the shipped seas keep 46 to 58 dB. */
#include <stdint.h>

static const uint32_t sine_pairs[1024] = {
#include "view/sine_pairs.inc"
};

#define TP_PACKED_PAIR(phase) sine_pairs[(phase) >> 22]
#include "view/packed_vertices.h"

const struct tp_draw_table_waves tp_draw_table_waves = {{ evaluate_row,
                                                          make_view_vertices }};
