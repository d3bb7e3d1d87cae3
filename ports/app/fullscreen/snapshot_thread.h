/* SPDX-License-Identifier: MIT */
/* Writes snapshots in a thread of its own: a disk may take a second to confirm a write,
 * and no frame should wait for the disk. */
#ifndef TP_APP_FULLSCREEN_SNAPSHOT_THREAD_H
#define TP_APP_FULLSCREEN_SNAPSHOT_THREAD_H
#include "app/files/snapshot.h"

typedef struct snapshot_thread snapshot_thread;

/* Returns NULL without memory or thread; then only the final world is kept. */
snapshot_thread *snapshot_thread_begin(const snapshot_store *k, size_t bytes);

/* Copies the world for writing in the background.  Returns false if the last snapshot is
 * still being written. */
bool snapshot_thread_offer(snapshot_thread *to, const tp_world *world,
                           snapshot_progress at);

/* Waits until the last snapshot is written.  Returns false if the write failed; the
 * reason has been said. */
bool    snapshot_thread_end(snapshot_thread *to);
#endif
