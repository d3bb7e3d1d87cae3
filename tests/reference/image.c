/* SPDX-License-Identifier: MIT */
/* Pictures by samples and threads. */
#define _POSIX_C_SOURCE 200809L
#include "image.h"
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include "host/say.h"
#include "host/timing.h"

enum { THREADS = 64 };

typedef struct {
    ref_image *image;
    const ref_scene *scene;
    uint32_t side;              /* of the square of samples */
    atomic_uint row;            /* the next to be drawn */
} work;

/* Sample (i, j) lies in its own cell of the square, and in its own column and row of the
 * finer one. */
static void draw_pixel(work *w, uint32_t x, uint32_t y)
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

static bool draw_row(work *w)
{
    const uint32_t y = atomic_fetch_add(&w->row, 1);

    for (uint32_t x = 0; y < w->image->height && x < w->image->width; x++)
        draw_pixel(w, x, y);
    return y < w->image->height;
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
    say_progress(text);
    p->shown = now_us();
}

void ref_image_draw(ref_image *image, const ref_scene *s, uint32_t width, uint32_t height,
                    uint32_t samples, uint32_t threads)
{
    work w = { image, s, (uint32_t)lround(sqrt(samples)), 0 };
    progress p = progress_begin();
    pthread_t thread[THREADS];
    uint32_t helpers = 0;

    *image = (ref_image){ .width = width, .height = height };
    image->colour = malloc((size_t)width * height * sizeof *image->colour);
    image->kind = malloc((size_t)width * height);
    image->in_mirror = malloc((size_t)width * height);
    image->near = malloc((size_t)width * height * sizeof *image->near);
    if (!image->colour || !image->kind || !image->in_mirror || !image->near)
        abort();
    while (helpers + 1 < threads && helpers < THREADS
           && pthread_create(&thread[helpers], NULL, draw_rows, &w) == 0)
        helpers++;
    while (draw_row(&w))
        show(&p, atomic_load(&w.row), height);
    for (uint32_t i = 0; i < helpers; i++)
        pthread_join(thread[i], NULL);
    say_progress("");
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
