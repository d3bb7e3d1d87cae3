/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "thread_pool.h"
#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <unistd.h>

#define USUAL_MOST 8

typedef struct {
    thread_pool *of;
    uint32_t  number;           /* index, from 1 */
    uint32_t  done;             /* number of the last job that the thread began */
    pthread_t thread;
} worker;

struct thread_pool {
    pthread_mutex_t lock;       /* guards all members below */
    pthread_cond_t  work, rest; /* work: a job or the end; rest: no thread is busy */
    void    (*task)(void *user, uint32_t i);
    void     *user;
    uint32_t  job;              /* number of the current job, from 1 */
    uint32_t  busy;
    bool      open;             /* threads may still begin the job */
    bool      over;             /* threads shall end */
    uint32_t  workers;
    worker    worker[];
};

static void do_job(thread_pool *c, worker *w)
{
    w->done = c->job;
    c->busy++;
    pthread_mutex_unlock(&c->lock);
    c->task(c->user, w->number);
    pthread_mutex_lock(&c->lock);
    if (--c->busy == 0)
        pthread_cond_signal(&c->rest);
}

static void *run_worker(void *user)
{
    worker *w = user;
    thread_pool *c = w->of;
    pthread_mutex_lock(&c->lock);
    while (!c->over) {
        if (c->open && w->done != c->job)
            do_job(c, w);
        else
            pthread_cond_wait(&c->work, &c->lock);
    }
    pthread_mutex_unlock(&c->lock);
    return NULL;
}

uint32_t thread_pool_default_size(void)
{
    const long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > USUAL_MOST ? USUAL_MOST : (uint32_t)n;
}

thread_pool *thread_pool_open(uint32_t threads)
{
    thread_pool *c = threads ? calloc(1, sizeof *c + threads * sizeof c->worker[0]) : NULL;
    if (!c)
        return NULL;
    pthread_mutex_init(&c->lock, NULL);
    pthread_cond_init(&c->work, NULL);
    pthread_cond_init(&c->rest, NULL);
    for (uint32_t i = 0; i < threads; i++, c->workers++) {
        c->worker[i] = (worker){ .of = c, .number = i + 1 };
        if (pthread_create(&c->worker[i].thread, NULL, run_worker, &c->worker[i]))
            break;
    }
    return c;
}

void thread_pool_close(thread_pool *c)
{
    if (!c)
        return;
    pthread_mutex_lock(&c->lock);
    c->over = true;
    pthread_cond_broadcast(&c->work);
    pthread_mutex_unlock(&c->lock);
    for (uint32_t i = 0; i < c->workers; i++)
        pthread_join(c->worker[i].thread, NULL);
    pthread_cond_destroy(&c->work);
    pthread_cond_destroy(&c->rest);
    pthread_mutex_destroy(&c->lock);
    free(c);
}

void thread_pool_run(thread_pool *c, void (*task)(void *user, uint32_t i), void *user)
{
    if (!c) {
        task(user, 0);
        return;
    }
    pthread_mutex_lock(&c->lock);
    c->task = task;
    c->user = user;
    c->job++;
    c->open = true;
    pthread_cond_broadcast(&c->work);
    pthread_mutex_unlock(&c->lock);
    task(user, 0);
    pthread_mutex_lock(&c->lock);
    c->open = false;
    while (c->busy)
        pthread_cond_wait(&c->rest, &c->lock);
    pthread_mutex_unlock(&c->lock);
}
