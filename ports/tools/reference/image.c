/* SPDX-License-Identifier: MIT */
/* Draws pictures with several samples a pixel on several threads. */
#define _POSIX_C_SOURCE 200809L
#include "image.h"
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include "app/files/log.h"
#include "app/files/timing.h"

enum { THREADS = 64 };

typedef struct {
    ref_image *image;
    const ref_scene *scene;
    uint32_t side;              /* samples along a side of the pixel's square */
    ref_pace *pace;
    atomic_uint row;            /* next row to draw */
} ref_work;

/* Draws one pixel. Sample (i, j) lies in its own cell of the square of samples, and in its
 * own column and row of the finer grid. */
static void draw_pixel(ref_work *w, uint32_t x, uint32_t y)
{
    const double side = w->side;
    ref_colour sum = { { 0, 0, 0 } };
    ref_seen seen = { .kind = REF_SKY };

    for (uint32_t k = 0; k < w->side * w->side; k++) {
        const uint32_t i = k % w->side, j = k / w->side;
        seen = ref_look(w->scene, x + (i + (j + 0.5) / side) / side,
                        y + (j + (i + 0.5) / side) / side);
        for (int c = 0; c < 3; c++)
            sum.c[c] += seen.colour.c[c];
    }
    w->image->colour[(size_t)y * w->image->width + x] = ref_scale(sum, 1 / side / side);
    w->image->kind[(size_t)y * w->image->width + x] = (uint8_t)seen.kind;
    w->image->in_mirror[(size_t)y * w->image->width + x] = (uint8_t)seen.in_mirror;
    w->image->near[(size_t)y * w->image->width + x] = seen.near;
}

static bool is_wanted(const ref_work *w)
{
    return !atomic_load_explicit(&w->pace->stop, memory_order_relaxed);
}

static bool draw_row(ref_work *w)
{
    const uint32_t y = atomic_fetch_add(&w->row, 1);

    if (y >= w->image->height)
        return false;
    for (uint32_t x = 0; x < w->image->width && is_wanted(w); x++)
        draw_pixel(w, x, y);
    atomic_fetch_add(&w->pace->rows, 1);
    return is_wanted(w);
}

static void *draw_rows(void *of)
{
    while (draw_row(of))
        ;
    return NULL;
}

static void show(progress *p, uint32_t done, uint32_t rows)
{
    char text[64];

    if (now_us() - p->begin < 2000000u || now_us() - p->shown < 250000u)
        return;
    snprintf(text, sizeof text, "row %u of %u", (unsigned)done, (unsigned)rows);
    log_progress(text);
    p->shown = now_us();
}

static bool allocate(ref_image *image, uint32_t width, uint32_t height)
{
    const size_t pixels = (size_t)width * height;

    *image = (ref_image){ .width = width, .height = height };
    image->colour = malloc(pixels * sizeof *image->colour);
    image->kind = malloc(pixels);
    image->in_mirror = malloc(pixels);
    image->near = malloc(pixels * sizeof *image->near);
    return image->colour && image->kind && image->in_mirror && image->near;
}

/* Draws on the helper threads and on the calling thread; the calling thread reports the
 * progress if the terminal has a progress line. */
static void draw_all(ref_work *w, uint32_t threads, progress *p)
{
    pthread_t thread[THREADS];
    uint32_t helpers = 0;

    while (helpers + 1 < threads && helpers < THREADS
           && pthread_create(&thread[helpers], NULL, draw_rows, w) == 0)
        helpers++;
    while (draw_row(w))
        if (p)
            show(p, atomic_load(&w->pace->rows), w->image->height);
    for (uint32_t i = 0; i < helpers; i++)
        pthread_join(thread[i], NULL);
}

static uint32_t side_length(uint32_t samples)
{
    return (uint32_t)lround(sqrt(samples));
}

void ref_image_draw(ref_image *image, const ref_scene *s, uint32_t width, uint32_t height,
                    uint32_t samples, uint32_t threads)
{
    ref_pace pace = { 0, false };
    ref_work w = { image, s, side_length(samples), &pace, 0 };
    progress p = progress_begin();

    if (!allocate(image, width, height))
        abort();
    draw_all(&w, threads, &p);
    log_progress("");
}

bool ref_image_draw_size(ref_image *image, const ref_scene *s, uint32_t width,
                         uint32_t height, uint32_t samples, uint32_t threads,
                         ref_pace *pace)
{
    ref_work w = { image, s, side_length(samples), pace, 0 };
    const bool there = allocate(image, width, height);

    atomic_store(&pace->rows, 0);
    if (there)
        draw_all(&w, threads, NULL);
    if (there && is_wanted(&w))
        return true;
    ref_image_free(image);
    return false;
}

void ref_image_free(ref_image *image)
{
    free(image->colour);
    free(image->kind);
    free(image->in_mirror);
    free(image->near);
}

uint32_t ref_image_pixel(const ref_image *image, uint32_t x, uint32_t y)
{
    const ref_colour c = image->colour[(size_t)y * image->width + x];
    uint32_t pixel = 0;

    for (int i = 0; i < 3; i++)
        pixel = pixel << 8 | (uint32_t)lround(ref_clamp(c.c[i], 0, 255));
    return pixel;
}
