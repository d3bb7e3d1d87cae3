/* SPDX-License-Identifier: MIT */
#ifndef TP_TESTS_CHARTS_POOL_EDGES_H
#define TP_TESTS_CHARTS_POOL_EDGES_H
#include <stdbool.h>
#include <stdint.h>

/* Prints the chart "pool-walls": standing waves between walls on and across the grid; and
 * "pool-sponge": what a sponge sends back of waves that run into it at an angle, 0 or 45
 * degrees. `cells_only`: only the column `updates`, of which pool-edges.sh makes
 * instructions. */
void print_pool_walls(bool cells_only);
void print_pool_sponge(uint32_t degrees, bool cells_only);

/* Prints the chart "pool-feed": the level of a field that random splashes keep moving, with
 * a damping of 2^-m. */
void print_pool_feed(uint32_t m);

#endif
