/* SPDX-License-Identifier: MIT */
/* One thread and one buffer.  While the buffer is empty the drawing thread may fill it;
 * while it is full the snapshot thread writes it. */
#define _POSIX_C_SOURCE 200809L
#include "snapshot_thread.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

struct snapshot_thread {
    pthread_t       thread;
    pthread_mutex_t mutex;          /* guards `full` and `end` */
    pthread_cond_t  changed;
    bool            full, end;
    snapshot_store  keep;
    snapshot_progress at;
    size_t          bytes;
    void           *copy;
};

static void *work(void *user)
{
    snapshot_thread *k = user;
    pthread_mutex_lock(&k->mutex);
    while (!k->end || k->full) {
        if (!k->full) {
            pthread_cond_wait(&k->changed, &k->mutex);
            continue;
        }
        pthread_mutex_unlock(&k->mutex);
        (void)snapshot_write(&k->keep, k->copy, k->bytes, k->at);
        pthread_mutex_lock(&k->mutex);
        k->full = false;
    }
    pthread_mutex_unlock(&k->mutex);
    return NULL;
}

snapshot_thread *snapshot_thread_begin(const snapshot_store *kept, size_t bytes)
{
    snapshot_thread *k = calloc(1, sizeof *k);
    if (!k)
        return NULL;
    k->keep = *kept;
    k->bytes = bytes;
    k->copy = malloc(bytes);
    pthread_mutex_init(&k->mutex, NULL);
    pthread_cond_init(&k->changed, NULL);
    if (k->copy && pthread_create(&k->thread, NULL, work, k) == 0)
        return k;
    free(k->copy);
    free(k);
    return NULL;
}

bool snapshot_thread_offer(snapshot_thread *k, const tp_world *world, snapshot_progress at)
{
    if (!k)
        return false;
    pthread_mutex_lock(&k->mutex);
    const bool empty = !k->full;
    if (empty) {
        memcpy(k->copy, world, k->bytes);
        k->at = at;
        k->full = true;
        pthread_cond_signal(&k->changed);
    }
    pthread_mutex_unlock(&k->mutex);
    return empty;
}

bool snapshot_thread_end(snapshot_thread *k)
{
    if (!k)
        return true;
    pthread_mutex_lock(&k->mutex);
    k->end = true;
    pthread_cond_signal(&k->changed);
    pthread_mutex_unlock(&k->mutex);
    pthread_join(k->thread, NULL);
    pthread_cond_destroy(&k->changed);
    pthread_mutex_destroy(&k->mutex);
    const bool written = !k->keep.failed;
    free(k->copy);
    free(k);
    return written;
}
