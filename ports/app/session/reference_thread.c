/* SPDX-License-Identifier: MIT */
/* Runs the reference renderer, ports/tools/reference, which is linked into the program only
 * for this view. */
#define _XOPEN_SOURCE 700
#include "reference_thread.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include "tools/reference/image.h"
#include "world/world.h"

#define BLOCK  4                /* width and height of a block of the coarse pass, px */
#define BEHIND 10               /* nice value of the thread, below the preview's threads */

static const uint32_t samples_of[] = {
    [REFERENCE_COARSE] = 1, [REFERENCE_1] = 1, [REFERENCE_4] = 4, [REFERENCE_16] = 16
};

struct reference_thread {
    tp_scene   scene;           /* copies for the thread ... */
    tp_world  *world;
    size_t     world_bytes;
    const tp_assets *assets;
    uint32_t   width, height;
    uint32_t  *ours;            /* ... and the picture for comparison */
    ref_pace   pace;
    atomic_uint height_now;     /* rows of the picture of pass_now */
    reference_pass first;       /* pass to start with */
    atomic_uint pass_now;       /* the pass being drawn; REFERENCE_NONE: all are finished */
    pthread_t  thread;
    pthread_mutex_t lock;       /* guards the last finished picture: */
    uint32_t  *pixel;
    reference_pass last;        /* pass of that picture; REFERENCE_NONE: no picture yet */
    bool       taken;           /* true if that picture has been copied out */
};

static void publish(reference_thread *t, const ref_image *image, reference_pass pass)
{
    const uint32_t block = pass == REFERENCE_COARSE ? BLOCK : 1;

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
static bool draw_pass(reference_thread *t, reference_pass pass)
{
    const uint32_t block = pass == REFERENCE_COARSE ? BLOCK : 1;
    const uint32_t width = (t->width + block - 1) / block;
    const uint32_t height = (t->height + block - 1) / block;
    ref_scene scene;
    ref_image image;

    atomic_store(&t->pace.rows, 0);
    atomic_store(&t->height_now, height);
    atomic_store(&t->pass_now, pass);
    ref_scene_open(&scene, &t->scene, t->assets, t->world, width, height, false);
    const bool done = ref_image_draw_size(&image, &scene, width, height, samples_of[pass],
                                        (thread_pool_default_size() + 1) / 2, &t->pace);
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
    reference_thread *t = user;
    bool goes_on = true;

    step_back();
    for (reference_pass pass = t->first; pass <= REFERENCE_16 && goes_on; pass++)
        goes_on = draw_pass(t, pass);
    atomic_store(&t->pass_now, REFERENCE_NONE);
    return NULL;
}

/* -- interface ----------------------------------------------------------------------- */

static void discard(reference_thread *t)
{
    free(t->world);
    free(t->ours);
    free(t->pixel);
    pthread_mutex_destroy(&t->lock);
    free(t);
}

static bool copy(reference_thread *t, const loaded_scene *s)
{
    const picture *p = &s->renderer.picture;
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

reference_thread *reference_thread_begin(const loaded_scene *s, bool coarse)
{
    reference_thread *t = calloc(1, sizeof *t);

    if (!t)
        return NULL;
    pthread_mutex_init(&t->lock, NULL);
    atomic_init(&t->pace.rows, 0);
    atomic_init(&t->pace.stop, false);
    t->first = coarse ? REFERENCE_COARSE : REFERENCE_1;
    atomic_init(&t->pass_now, t->first);
    atomic_init(&t->height_now, 1);
    if (copy(t, s) && pthread_create(&t->thread, NULL, live, t) == 0)
        return t;
    discard(t);
    return NULL;
}

void reference_thread_end(reference_thread *t)
{
    if (!t)
        return;
    atomic_store(&t->pace.stop, true);
    pthread_join(t->thread, NULL);
    discard(t);
}

reference_pass reference_thread_take(reference_thread *t, uint32_t *ours, uint32_t *theirs)
{
    const size_t bytes = (size_t)t->width * t->height * sizeof *ours;

    pthread_mutex_lock(&t->lock);
    const reference_pass last = t->last;
    if (last) {
        memcpy(ours, t->ours, bytes);
        memcpy(theirs, t->pixel, bytes);
        t->taken = true;
    }
    pthread_mutex_unlock(&t->lock);
    return last;
}

bool reference_thread_has_news(reference_thread *t)
{
    pthread_mutex_lock(&t->lock);
    const bool news = t->last && !t->taken;
    pthread_mutex_unlock(&t->lock);
    return news;
}

bool reference_thread_has_same_world(const reference_thread *t, const tp_world *world)
{
    return memcmp(t->world, world, t->world_bytes) == 0;
}

reference_pass reference_thread_progress(reference_thread *t, uint32_t *percent)
{
    const uint32_t height = atomic_load(&t->height_now), rows = atomic_load(&t->pace.rows);

    *percent = rows < height ? rows * 100 / height : 100;
    return (reference_pass)atomic_load(&t->pass_now);
}
