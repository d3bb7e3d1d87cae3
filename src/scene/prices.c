/* SPDX-License-Identifier: MIT */
/* The table of prices; prices.inc is made from assets/charts/prices.csv by prices.awk. */
#include "scene/prices.h"

const tp_prices tp_prices_measured = {
#include "scene/prices.inc"
};
