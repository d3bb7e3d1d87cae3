/* SPDX-License-Identifier: MIT */
/* One thread and one buffer.  While the buffer is empty the drawing thread may fill it;
 * while it is full the keeper thread writes it. */
#define _POSIX_C_SOURCE 200809L
#include "keeper.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

struct keeper {
    pthread_t       thread;
    pthread_mutex_t mutex;          /* guards `full` and `end` */
    pthread_cond_t  changed;
    bool            full, end;
    keep            keep;
    keep_at         at;
    size_t          bytes;
    void           *copy;
};

static void *work(void *user)
{
    keeper *k = user;
    pthread_mutex_lock(&k->mutex);
    while (!k->end || k->full) {
        if (!k->full) {
            pthread_cond_wait(&k->changed, &k->mutex);
            continue;
        }
        pthread_mutex_unlock(&k->mutex);
        (void)keep_put(&k->keep, k->copy, k->bytes, k->at);
        pthread_mutex_lock(&k->mutex);
        k->full = false;
    }
    pthread_mutex_unlock(&k->mutex);
    return NULL;
}

keeper *keeper_begin(const keep *kept, size_t bytes)
{
    keeper *k = calloc(1, sizeof *k);
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

bool keeper_offer(keeper *k, const tp_world *world, keep_at at)
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

bool keeper_end(keeper *k)
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
