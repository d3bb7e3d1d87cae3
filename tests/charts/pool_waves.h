/* SPDX-License-Identifier: MIT */
#ifndef TP_TESTS_CHARTS_POOL_WAVES_H
#define TP_TESTS_CHARTS_POOL_WAVES_H

/* Prints the chart "pool-waves": lag of waves in 16-bit cells, in percent of the speed. */
void print_pool_waves(void);

#endif
