/* SPDX-License-Identifier: MIT */
/* Keeps worlds while others go on: a disk may take a second to say that it has written
 * something, and no picture should wait for that. */
#ifndef SCREEN_KEEPER_H
#define SCREEN_KEEPER_H
#include "keep.h"

typedef struct keeper keeper;

/* NULL: there is no memory or no thread for it; then only the end is kept. */
keeper *keeper_begin(const keep *k, size_t bytes);

/* Copies the world, to be written by and by.  False: the last one is being written yet. */
bool    keeper_offer(keeper *to, const tp_world *world, keep_at at);

/* Returns when all that was offered is written.  False: the last one could not be, and
 * that was said. */
bool    keeper_end(keeper *to);
#endif
