/* SPDX-License-Identifier: MIT */
/* Which frames are golden: small ones, whose last strip and last band are short. */
#ifndef GOLDEN_SIZES_H
#define GOLDEN_SIZES_H

enum { GOLDEN_WIDTH = 208, GOLDEN_HEIGHT = 150, GOLDEN_FRAMES = 2 };

#define GOLDEN_TICKS { 0, 100 }
#endif
