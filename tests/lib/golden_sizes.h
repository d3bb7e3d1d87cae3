/* SPDX-License-Identifier: MIT */
/* Frame sizes of the golden frames: small, and not a multiple of the tile sizes, so that
 * the last strip and the last band are short. */
#ifndef TP_TESTS_LIB_GOLDEN_SIZES_H
#define TP_TESTS_LIB_GOLDEN_SIZES_H

enum { GOLDEN_WIDTH = 208, GOLDEN_HEIGHT = 150, GOLDEN_FRAMES = 2 };

#define GOLDEN_TICKS { 0, 100 }
#endif
