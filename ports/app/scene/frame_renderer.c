/* SPDX-License-Identifier: MIT */
/* Draws the tiles of a frame into one picture.  The frame is read-only while tiles are
 * drawn: each thread takes the next free tile and draws into its own scratch memory.  Tiles
 * do not overlap in the picture, so every order of drawing gives the same picture. */
#include "frame_renderer.h"
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/timing.h"
#include "frame/tools.h"
#include "pixel/pixel.h"

/* Height of a tile.  Bands keep the memory of a tile small, 20 bytes a pixel; bands of 128
 * rows cost 1% more time than one tile of 640x480 (three-swells).  Several threads need
 * enough bands to stay busy until the end: eight bands per thread.  Below 16 rows the fixed
 * cost of a tile is greater than the gain by better balance (tank: 4% at 30 rows, 10% at
 * 16). */
#define BAND_ROWS        128
#define BAND_LEAST       16
#define BANDS_PER_THREAD 8

static void choose_tiles(tp_config *config, uint32_t threads)
{
    const uint32_t bands = threads > 1 ? threads * BANDS_PER_THREAD : 1;
    uint32_t rows = (config->height + bands - 1) / bands;
    rows = rows < BAND_LEAST ? BAND_LEAST : rows;
    if (!config->tile_width && !config->tile_height)
        config->tile_height = rows < BAND_ROWS ? rows : BAND_ROWS;
}

void frame_renderer_plan(frame_renderer *c, const tp_config *config, uint32_t threads)
{
    *c = (frame_renderer){ .threads = threads < 1 ? 1 : threads, .config = *config };
    if (c->threads > FRAME_RENDERER_THREADS)
        c->threads = FRAME_RENDERER_THREADS;
    choose_tiles(&c->config, c->threads);
    c->picture.format = config->format;
    c->picture.width = config->width;
    c->picture.height = config->height;
    c->picture.row_bytes = tp_format_row_bytes(config->format, (int)config->width);
    size_t programs;
    c->machine = machine_list(&programs);
}

/* Returns the scene as drawn: rows that the scene leaves open have the plan's rungs. */
static tp_scene drawn_scene(const tp_plan *plan, const tp_scene *scene)
{
    tp_scene drawn = *scene;

    tp_rung_set_apply_some(&drawn, &plan->set, plan->open);
    return drawn;
}

void frame_renderer_measure(frame_renderer *c, const tp_scene *scene,
                            const tp_assets *assets)
{
    const tp_scene drawn = drawn_scene(&c->plan, scene);

    c->program = *c->machine->program;
    if (c->stream) {
        c->program.method.triangles = &tp_method_streamed;
        c->program.method.walk = &tp_method_streamed_walk;
    }
    c->config.program = &c->program;
    c->config.assets = assets;
    c->frame_bytes = tp_frame_bytes(&c->config, &drawn);
    c->scratch_bytes = c->threads * tp_frame_scratch_bytes(&c->config, &drawn);
}

/* Takes the memory of the frame and of the scene as drawn. */
static int allocate_frame(frame_renderer *c)
{
    c->block = malloc(c->frame_bytes);
    c->drawn = malloc(sizeof *c->drawn);
    bool there = c->block && c->drawn;
    for (uint32_t i = 0; i < c->threads; i++) {
        c->scratch[i] = calloc(1, c->scratch_bytes / c->threads);
        there = there && c->scratch[i];
    }
    return there ? EXIT_DONE : log_fail_memory(c->frame_bytes + c->scratch_bytes);
}

static void free_frame(frame_renderer *c)
{
    for (uint32_t i = 0; i < c->threads; i++)
        free(c->scratch[i]);
    free(c->block);
    free(c->drawn);
}

static int init_frame(frame_renderer *c)
{
    tp_error err = { 0 };

    *c->drawn = drawn_scene(&c->plan, c->scene);
    if (tp_frame_init(&c->frame, &c->config, c->drawn, c->block, c->frame_bytes, &err))
        return log_fail_error("tidepool", &err);
    return EXIT_DONE;
}

int frame_renderer_open(frame_renderer *c, const tp_scene *scene, const tp_assets *assets)
{
    const size_t picture_bytes = c->picture.row_bytes * c->picture.height;

    c->scene = scene;
    frame_renderer_measure(c, scene, assets);
    int code = allocate_frame(c);
    c->picture.rows = malloc(picture_bytes);
    if (!code && !c->picture.rows)
        code = log_fail_memory(picture_bytes);
    code = code ? code : init_frame(c);
    if (!code)
        c->pool = thread_pool_open(c->threads - 1);
    return code;
}

int frame_renderer_set_rungs(frame_renderer *c, const tp_rung_set *set)
{
    frame_renderer with = *c;

    with.plan.set = *set;
    frame_renderer_measure(&with, c->scene, c->config.assets);
    const int code = allocate_frame(&with);
    if (code) {
        free_frame(&with);
        return code;
    }
    free_frame(c);
    *c = with;
    c->config.program = &c->program;
    return init_frame(c);
}

void frame_renderer_close(frame_renderer *c)
{
    thread_pool_close(c->pool);
    free_frame(c);
    free(c->picture.rows);
    *c = (frame_renderer){ 0 };
}

/* -- drawing ------------------------------------------------------------------------- */

typedef struct {
    frame_renderer *renderer;
    atomic_uint taken;          /* number of tiles taken by threads */
    atomic_uint water_pixels;
} tile_work;

/* Copies a tile into the picture.  Its left edge is a multiple of 16 pixels, which is a
 * whole number of bytes in every format. */
static void place(frame_renderer *c, const tp_tile *tile)
{
    const uint32_t bits = (uint32_t)tp_format_bits(c->picture.format);
    const size_t left = tile->x0 * (size_t)bits / 8;
    const int width = (int)(tile->x1 - tile->x0);
    const size_t bytes = tp_format_row_bytes(c->picture.format, width);
    const uint8_t *from = tile->pixels;
    for (uint32_t y = tile->y0; y < tile->y1; y++, from += tile->stride)
        memcpy(c->picture.rows + y * c->picture.row_bytes + left, from, bytes);
}

/* Draws tiles from the last to the first.  The last tiles hold the near water, the most
 * expensive; the first hold sky, cheap enough for all threads to end at about the same
 * time.  Kept lines are for tiles from the first on. */
static void draw_tiles(void *user, uint32_t thread)
{
    tile_work *all = user;
    frame_renderer *c = all->renderer;
    const uint32_t tiles = tp_frame_tiles(c->frame);
    void *scratch = c->scratch[thread];
    tp_tile tile;
    for (uint32_t i; (i = atomic_fetch_add(&all->taken, 1)) < tiles;) {
        tp_frame_draw_tile(c->frame, c->config.kept_bytes ? i : tiles - 1 - i, scratch,
                           &tile);
        place(c, &tile);
        atomic_fetch_add(&all->water_pixels,
                         tp_frame_water_pixels(c->frame, scratch, &tile));
    }
}

void frame_renderer_draw(frame_renderer *c, const tp_world *world)
{
    tile_work all = { .renderer = c };
    atomic_init(&all.taken, 0);
    atomic_init(&all.water_pixels, 0);
    const uint64_t begin = now_us();
    *c->drawn = drawn_scene(&c->plan, c->scene);
    tp_frame_begin(c->frame, world);
    const uint64_t middle = now_us();
    thread_pool_run(c->pool, draw_tiles, &all);
    c->begin_us = (uint32_t)(middle - begin);
    c->tiles_us = (uint32_t)(now_us() - middle);
    c->water_pixels = atomic_load(&all.water_pixels);
}
