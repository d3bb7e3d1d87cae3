/* SPDX-License-Identifier: MIT */
/* Writes snapshots in a thread of its own: a disk may take a second to confirm a write,
 * and no frame should wait for the disk. */
#ifndef SCREEN_KEEPER_H
#define SCREEN_KEEPER_H
#include "keep.h"

typedef struct keeper keeper;

/* Returns NULL without memory or thread; then only the final world is kept. */
keeper *keeper_begin(const keep *k, size_t bytes);

/* Copies the world for writing in the background.  Returns false if the last snapshot is
 * still being written. */
bool    keeper_offer(keeper *to, const tp_world *world, keep_at at);

/* Waits until the last snapshot is written.  Returns false if the write failed; the
 * reason has been said. */
bool    keeper_end(keeper *to);
#endif
