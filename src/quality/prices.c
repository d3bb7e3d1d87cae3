/* SPDX-License-Identifier: MIT */
/* The cost table. prices.awk generates prices.inc from assets/charts/prices.csv. */
#include "quality/prices.h"

const tp_prices tp_prices_measured = {
#include "quality/prices.inc"
};
