/* SPDX-License-Identifier: MIT */
#include "quality/processor_prices.h"

const uint16_t tp_m0plus_factors[TP_SHADED_COUNT][TP_PART_COUNT] = {
#include "quality/processor_prices.inc"
};
