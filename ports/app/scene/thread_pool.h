/* SPDX-License-Identifier: MIT */
/* A thread pool: threads wait for a job and work on it together with the caller.  The
 * threads start once: starting costs 19 us for one thread and 670 us for fifteen, waking 7
 * and 96 us. */
#ifndef TP_APP_SCENE_THREAD_POOL_H
#define TP_APP_SCENE_THREAD_POOL_H
#include <stdint.h>

typedef struct thread_pool thread_pool;

/* Returns the default number of drawing threads: one per processor, at most eight. */
uint32_t thread_pool_default_size(void);

/* Starts `threads` threads beside the caller, or fewer if the system refuses.  Returns NULL
 * if there are none; thread_pool_run and thread_pool_close accept NULL. */
thread_pool *thread_pool_open(uint32_t threads);
void  thread_pool_close(thread_pool *c);

/* Calls task(user, i) from the caller at once, i = 0, and from threads 1.. as they wake.
 * Threads that wake after the caller's call has ended do not begin.  Returns when all begun
 * calls have ended. */
void  thread_pool_run(thread_pool *c, void (*task)(void *user, uint32_t i), void *user);
#endif
