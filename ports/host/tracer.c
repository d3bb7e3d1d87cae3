/* SPDX-License-Identifier: MIT */
/* The reference is tests/reference, which is part of this program for that alone. */
#define _POSIX_C_SOURCE 200809L
#include "tracer.h"
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include "tests/reference/image.h"

static const uint32_t passes[] = { 1, 4, 16 };  /* samples a pixel */

struct tracer {
    tp_scene   scene;           /* copies, for the thread ... */
    tp_world  *world;
    size_t     world_bytes;
    const tp_assets *assets;
    uint32_t   width, height;
    uint32_t  *ours;            /* ... and what it is compared with */
    ref_pace   pace;
    atomic_uint draws;          /* samples a pixel; 0: it is over */
    pthread_t  thread;
    pthread_mutex_t lock;       /* of the last finished picture: */
    uint32_t  *pixel;
    uint32_t   samples;         /* 0: there is none */
    bool       taken;
};

static void publish(tracer *t, const ref_image *image, uint32_t samples)
{
    pthread_mutex_lock(&t->lock);
    for (uint32_t y = 0; y < t->height; y++)
        for (uint32_t x = 0; x < t->width; x++)
            t->pixel[(size_t)y * t->width + x] = ref_image_pixel(image, x, y);
    t->samples = samples;
    t->taken = false;
    pthread_mutex_unlock(&t->lock);
}

/* Half of the processors, as pictures go on meanwhile. */
static bool draw_pass(tracer *t, const ref_scene *scene, uint32_t samples)
{
    ref_image image;

    atomic_store(&t->pace.rows, 0);
    atomic_store(&t->draws, samples);
    if (!ref_image_draw_at(&image, scene, t->width, t->height, samples,
                           (crew_usual() + 1) / 2, &t->pace))
        return false;
    publish(t, &image, samples);
    ref_image_free(&image);
    return true;
}

static void *live(void *user)
{
    tracer *t = user;
    ref_scene scene;
    bool goes_on = true;

    ref_scene_open(&scene, &t->scene, t->assets, t->world, t->width, t->height, false);
    for (size_t i = 0; i < sizeof passes / sizeof *passes && goes_on; i++)
        goes_on = draw_pass(t, &scene, passes[i]);
    ref_scene_close(&scene);
    atomic_store(&t->draws, 0);
    return NULL;
}

/* -- from outside -------------------------------------------------------------------- */

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

tracer *tracer_begin(const stage *s)
{
    tracer *t = calloc(1, sizeof *t);

    if (!t)
        return NULL;
    pthread_mutex_init(&t->lock, NULL);
    atomic_init(&t->pace.rows, 0);
    atomic_init(&t->pace.stop, false);
    atomic_init(&t->draws, passes[0]);
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

uint32_t tracer_take(tracer *t, uint32_t *ours, uint32_t *theirs)
{
    const size_t bytes = (size_t)t->width * t->height * sizeof *ours;

    pthread_mutex_lock(&t->lock);
    const uint32_t samples = t->samples;
    if (samples) {
        memcpy(ours, t->ours, bytes);
        memcpy(theirs, t->pixel, bytes);
        t->taken = true;
    }
    pthread_mutex_unlock(&t->lock);
    return samples;
}

bool tracer_has_news(tracer *t)
{
    pthread_mutex_lock(&t->lock);
    const bool news = t->samples && !t->taken;
    pthread_mutex_unlock(&t->lock);
    return news;
}

bool tracer_is_of(const tracer *t, const tp_world *world)
{
    return memcmp(t->world, world, t->world_bytes) == 0;
}

uint32_t tracer_draws(tracer *t, uint32_t *percent)
{
    *percent = atomic_load(&t->pace.rows) * 100 / t->height;
    return atomic_load(&t->draws);
}
