/* SPDX-License-Identifier: MIT */
/* Runs the reference renderer, tests/reference, which is linked into the program only for
 * this view. */
#define _XOPEN_SOURCE 700
#include "tracer.h"
#include "scene/world.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include "tests/reference/image.h"

#define BLOCK  4                /* width and height of a block of the coarse pass, px */
#define BEHIND 10               /* nice value of the thread, below the preview's threads */

static const uint32_t samples_of[] = { [TRACER_COARSE] = 1, [TRACER_1] = 1, [TRACER_4] = 4,
                                       [TRACER_16] = 16 };

struct tracer {
    tp_scene   scene;           /* copies for the thread ... */
    tp_world  *world;
    size_t     world_bytes;
    const tp_assets *assets;
    uint32_t   width, height;
    uint32_t  *ours;            /* ... and the picture for comparison */
    ref_pace   pace;
    atomic_uint height_now;     /* height of the pass, rows */
    tracer_pass first;
    atomic_uint draws;          /* tracer_pass in progress */
    pthread_t  thread;
    pthread_mutex_t lock;       /* guards the last finished picture: */
    uint32_t  *pixel;
    tracer_pass last;
    bool       taken;
};

static void publish(tracer *t, const ref_image *image, tracer_pass pass)
{
    const uint32_t block = pass == TRACER_COARSE ? BLOCK : 1;

    pthread_mutex_lock(&t->lock);
    for (uint32_t y = 0; y < t->height; y++)
        for (uint32_t x = 0; x < t->width; x++)
            t->pixel[(size_t)y * t->width + x] =
                ref_image_pixel(image, x / block, y / block);
    t->last = pass;
    t->taken = false;
    pthread_mutex_unlock(&t->lock);
}

/* Draws a pass with half of the processors; the preview needs the others. */
static bool draw_pass(tracer *t, tracer_pass pass)
{
    const uint32_t block = pass == TRACER_COARSE ? BLOCK : 1;
    const uint32_t width = (t->width + block - 1) / block;
    const uint32_t height = (t->height + block - 1) / block;
    ref_scene scene;
    ref_image image;

    atomic_store(&t->pace.rows, 0);
    atomic_store(&t->height_now, height);
    atomic_store(&t->draws, pass);
    ref_scene_open(&scene, &t->scene, t->assets, t->world, width, height, false);
    const bool done = ref_image_draw_at(&image, &scene, width, height, samples_of[pass],
                                        (crew_usual() + 1) / 2, &t->pace);
    ref_scene_close(&scene);
    if (done) {
        publish(t, &image, pass);
        ref_image_free(&image);
    }
    return done;
}

/* Lowers the priority.  On Linux setpriority affects the calling thread and threads started
 * by it; elsewhere the whole program. */
static void step_back(void)
{
#if defined(__linux__)
    setpriority(PRIO_PROCESS, 0, BEHIND);
#endif
}

static void *live(void *user)
{
    tracer *t = user;
    bool goes_on = true;

    step_back();
    for (tracer_pass pass = t->first; pass <= TRACER_16 && goes_on; pass++)
        goes_on = draw_pass(t, pass);
    atomic_store(&t->draws, TRACER_NONE);
    return NULL;
}

/* -- interface ----------------------------------------------------------------------- */

static void discard(tracer *t)
{
    free(t->world);
    free(t->ours);
    free(t->pixel);
    pthread_mutex_destroy(&t->lock);
    free(t);
}

static bool copy(tracer *t, const stage *s)
{
    const picture *p = &s->canvas.picture;
    const size_t pixels = (size_t)p->width * p->height;

    t->scene = s->file.scene;
    t->assets = &s->assets.names;
    t->width = p->width;
    t->height = p->height;
    t->world_bytes = s->world_bytes > sizeof *t->world ? s->world_bytes : sizeof *t->world;
    t->world = malloc(t->world_bytes);
    t->ours = malloc(pixels * sizeof *t->ours);
    t->pixel = malloc(pixels * sizeof *t->pixel);
    if (!t->world || !t->ours || !t->pixel)
        return false;
    memcpy(t->world, s->world, t->world_bytes);
    for (uint32_t y = 0; y < t->height; y++)
        picture_expand_row(p, y, t->ours + (size_t)y * t->width);
    return true;
}

tracer *tracer_begin(const stage *s, bool coarse)
{
    tracer *t = calloc(1, sizeof *t);

    if (!t)
        return NULL;
    pthread_mutex_init(&t->lock, NULL);
    atomic_init(&t->pace.rows, 0);
    atomic_init(&t->pace.stop, false);
    t->first = coarse ? TRACER_COARSE : TRACER_1;
    atomic_init(&t->draws, t->first);
    atomic_init(&t->height_now, 1);
    if (copy(t, s) && pthread_create(&t->thread, NULL, live, t) == 0)
        return t;
    discard(t);
    return NULL;
}

void tracer_end(tracer *t)
{
    if (!t)
        return;
    atomic_store(&t->pace.stop, true);
    pthread_join(t->thread, NULL);
    discard(t);
}

tracer_pass tracer_take(tracer *t, uint32_t *ours, uint32_t *theirs)
{
    const size_t bytes = (size_t)t->width * t->height * sizeof *ours;

    pthread_mutex_lock(&t->lock);
    const tracer_pass last = t->last;
    if (last) {
        memcpy(ours, t->ours, bytes);
        memcpy(theirs, t->pixel, bytes);
        t->taken = true;
    }
    pthread_mutex_unlock(&t->lock);
    return last;
}

bool tracer_has_news(tracer *t)
{
    pthread_mutex_lock(&t->lock);
    const bool news = t->last && !t->taken;
    pthread_mutex_unlock(&t->lock);
    return news;
}

bool tracer_has_same_world(const tracer *t, const tp_world *world)
{
    return memcmp(t->world, world, t->world_bytes) == 0;
}

tracer_pass tracer_draws(tracer *t, uint32_t *percent)
{
    const uint32_t height = atomic_load(&t->height_now), rows = atomic_load(&t->pace.rows);

    *percent = rows < height ? rows * 100 / height : 100;
    return (tracer_pass)atomic_load(&t->draws);
}
